"""Where a piece beside a figure stands: seen, clear of everything, and where a shadow falls on it that can be read."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import product
from math import ceil, dist, floor, hypot

import numpy as np

from kagezou.document import set_properties as lines
from kagezou.document.piece_kinds import TRAITS
from kagezou.geometry.box import Box
from kagezou.geometry.ground import Plane
from kagezou.geometry.sets.measures import Measures, PieceKind
from kagezou.geometry.sets.shapes import bodies_of, stand_on
from kagezou.geometry.sight import MIN_DEPTH, depth_of, seen
from kagezou.geometry.vectors import Matrix, Vector3, dot
from kagezou.tools.catching import Caster, Catch, Flags, casters_of, catch_of
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.shadow import tip_of
from kagezou.tools.sight import between, moved
from kagezou.tools.wall_fitting import FigureSide, sides_of

_BEHIND = (0.25, 0.8, 0.0, 1.4)
"""How far behind the figure a piece may stand beside it, in figure heights."""

_ALONG = (0.45, 0.6, 0.75, 0.9, 1.1)
_BESIDE = (0.0, 0.2, -0.2, 0.4, -0.4)
_LONGEST = 1.4
"""Which parts of the way to the tip of the shadow a piece may stand at, how far beside that way, in figure heights, and
up to which length of it."""

_GROWN = (1.0, 1.4, 0.7, 0.45)
_CLEARANCE = 0.12
_CROWDED = 0.03
"""How much less a place is worth on which something stands already, or a figure on another frame."""

_GAP = 0.03
"""By so many figure heights a piece stays clear of the line on which a figure stands."""

_ENOUGH = 0.97
"""A place that is worth this much is as good as any."""

_UNREAD = 0.05
"""What a place is worth where no shadow is read, against one where it is."""

_PART, _GOOD_PART = (0.1, 0.9), (0.25, 0.6)
"""Between which parts of what is seen and lit of a piece a shadow is read at all, and well."""

_GOOD_AREA = 0.06
"""From this part of the figure's area on a shadow is large enough."""

_OF_PARTS = (0.0, 1.0, 0.9, 0.5)
"""What a shadow in so many parts is worth; in more it is scraps."""

_SHOWN = 0.7
"""From this part on enough of a piece is seen beside the figures."""

_FIGURE_OF_CANVAS = 0.5
"""The height of a figure where there is none, as a part of the canvas' height."""


@dataclass(frozen=True, slots=True)
class SizedFigure:
    """What a piece is sized from: where it stands, how high it is and how far it reaches aside, world px."""

    foot: Vector3
    height: float
    half_width: float


@dataclass(frozen=True, slots=True)
class Spot:
    """A place of the ground, and the size of the piece there, world px."""

    place: Vector3
    size: tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Neighbours:
    """Other pieces: where they stand and how far they reach, world px, and the stands of walls."""

    taken: tuple[tuple[Vector3, float], ...]
    walls: tuple[Plane, ...]


@dataclass(frozen=True, slots=True, eq=False)
class _Trial:
    """What places are judged by: the kind, the figure, all others, where they stand over the cut, and other pieces."""

    geometry: FrameGeometry
    kind: PieceKind
    figure: SizedFigure
    caster: Caster | None
    others: tuple[Caster, ...]
    standing: Matrix
    neighbours: Neighbours


def best_spot(
    geometry: FrameGeometry, kind: PieceKind, shapes: Mapping[str, Flags], neighbours: Neighbours
) -> Spot | None:
    """Return the first spot that is good enough, else the best; None where a piece would be seen nowhere.

    Parameters
    ----------
    geometry
        What is looked at; the piece is put for the figure worked on.
    kind
        Not a wall.
    shapes
        Silhouettes of figures by the ids of their layers.
    neighbours
        The other pieces.
    """
    document, figure = geometry.document, sized_figure(geometry)
    casters = {each.layer_id: each for each in casters_of(document, geometry.frame, shapes)}
    own = None if geometry.figure is None else casters.pop(geometry.figure.id, None)
    trial = _Trial(
        geometry, kind, figure, own, tuple(casters.values()),
        _standing(sides_of(document, geometry.frame), geometry), neighbours,
    )  # fmt: skip
    best, most = None, 0.0
    for spot in _spots(geometry, kind, figure):
        worth = _worth(trial, spot)
        if worth > most:
            best, most = spot, worth
        if most >= _ENOUGH:
            break
    return best


def _spots(geometry: FrameGeometry, kind: PieceKind, figure: SizedFigure) -> Iterator[Spot]:
    """Yield places along the figure's shadow, then beside it and behind it."""
    sizes = TRAITS[kind].first_sizes
    if sizes is None:
        return
    for grown in _GROWN:
        width, height, depth = (figure.height * part * grown for part in sizes.of_figure)
        for aside, behind in (*_along_shadow(geometry, figure), *_beside(geometry, figure, width)):
            place = moved(figure.foot, (aside, geometry.ground.u), (-behind, geometry.ground.v))
            if depth_of(geometry.camera, place) > MIN_DEPTH and _is_on(geometry, place):
                yield Spot(place, (width, height, depth))


def _along_shadow(geometry: FrameGeometry, figure: SizedFigure) -> Iterator[tuple[float, float]]:
    """Yield offsets from the figure along its shadow: aside and behind, world px; none where it has no shadow."""
    tip = tip_of(geometry)
    if tip is None:
        return
    way = between(figure.foot, tip)
    aside, behind = dot(way, geometry.ground.u), -dot(way, geometry.ground.v)
    length = hypot(aside, behind)
    if length <= 0:
        return
    kept = min(length, _LONGEST * figure.height) / length
    for along, beside in product(_ALONG, _BESIDE):
        off = beside * figure.height / length
        yield aside * along * kept - off * behind, behind * along * kept + off * aside


def _beside(geometry: FrameGeometry, figure: SizedFigure, width: float) -> Iterator[tuple[float, float]]:
    """Yield offsets beside the figure, first on the side of its shadow: aside and behind, world px."""
    first = _shadow_side(geometry)
    for behind, side in product(_BEHIND, (first, -first)):
        yield side * (figure.half_width + width / 2 + _CLEARANCE * figure.height), behind * figure.height


def _worth(trial: _Trial, spot: Spot) -> float:
    """Return what a place is worth, 0 to 1: seen on the canvas, with nothing in its way, and a shadow that is read."""
    geometry, (width, height, depth) = trial.geometry, spot.size
    corners = _corners(geometry, spot)
    worth = _part_on_canvas(geometry, corners)
    reach = max(width, depth) / 2
    if worth <= 0 or _is_stood_in(trial, spot) or _is_behind_wall(trial, spot):
        return worth * _UNREAD * _UNREAD
    if any(dist(spot.place, at) < reach + room for at, room in trial.neighbours.taken):
        worth *= _CROWDED
    measures = Measures(trial.kind, width, height, depth, count=round(lines.PIECE_COUNT.default))
    bodies = bodies_of(stand_on(geometry.ground, spot.place, 0.0), measures)
    (left, top), (right, bottom) = corners.min(axis=0), corners.max(axis=0)
    frame = Box(floor(left), floor(top), ceil(right), ceil(bottom)).intersection(geometry.document.canvas.box)
    if trial.caster is None or frame is None:
        return worth
    catch = catch_of(bodies, frame, trial.caster, trial.others, geometry.camera, geometry.light)
    return worth * max(_read(trial.caster, catch), _UNREAD)


def _read(caster: Caster, catch: Catch) -> float:
    """Return how well a shadow is read, 0 to 1."""
    (least, most), (low, high) = _PART, _GOOD_PART
    part = min((catch.part - least) / (low - least), (most - catch.part) / (most - high), 1.0)
    area = catch.area_px / max(_GOOD_AREA * caster.area_px, 1.0)
    parts = _OF_PARTS[catch.parts] if catch.parts < len(_OF_PARTS) else 0.0
    return max(part, 0.0) * min(area, 1.0) * min(catch.shown / _SHOWN, 1.0) * parts


def _standing(sides: tuple[FigureSide, ...], geometry: FrameGeometry) -> Matrix:
    """Return where figures stand over the cut, (N, 3): from and to along the ground line, and toward the viewer."""
    ground, foot = geometry.ground, sized_figure(geometry).foot
    found = []
    for left, right in zip(sides[::2], sides[1::2], strict=True):
        ends = [between(foot, side.foot) for side in (left, right)]
        along = sorted(dot(end, ground.u) for end in ends)
        found.append((*along, sum(dot(end, ground.v) for end in ends) / 2))
    return np.array(found, np.float64).reshape(-1, 3)


def _is_stood_in(trial: _Trial, spot: Spot) -> bool:
    """Whether a figure would stand in the piece on any frame looked at."""
    ground, (width, _, depth) = trial.geometry.ground, spot.size
    way, gap = between(trial.figure.foot, spot.place), _GAP * trial.figure.height
    aside, nearer = dot(way, ground.u), dot(way, ground.v)
    left, right, at = trial.standing.T
    meets = (left < aside + width / 2) & (right > aside - width / 2) & (np.abs(at - nearer) < depth / 2 + gap)
    return bool(meets.any())


def sized_figure(geometry: FrameGeometry) -> SizedFigure:
    """Return what pieces are sized from: the figure worked on, or half the canvas where there is none."""
    canvas, depth = geometry.document.canvas, max(depth_of(geometry.camera, geometry.contact), MIN_DEPTH)
    box = geometry.figure_box
    if box.is_empty:
        height = _FIGURE_OF_CANVAS * canvas.height_px * depth
        return SizedFigure(geometry.contact, height, height / 4)
    return SizedFigure(geometry.contact, box.height * depth, box.width * depth / 2)


def _shadow_side(geometry: FrameGeometry) -> float:
    """Return on which side of the figure its shadow falls, where a new piece shows at once what it does."""
    tip = tip_of(geometry)
    return -1.0 if tip is not None and dot(between(geometry.contact, tip), geometry.ground.u) < 0 else 1.0


def _is_behind_wall(trial: _Trial, spot: Spot) -> bool:
    """Whether a wall stands between the figure and the back of a piece."""
    back = moved(spot.place, (-spot.size[2] / 2, trial.geometry.ground.v))
    return any(
        dot(between(wall.origin, back), wall.v) * dot(between(wall.origin, trial.figure.foot), wall.v) <= 0
        for wall in trial.neighbours.walls
    )


def _corners(geometry: FrameGeometry, spot: Spot) -> Matrix:
    """Return where the corners of the box around a piece are seen, (8, 2), canvas px."""
    ground, (width, height, depth) = geometry.ground, spot.size
    return np.array(
        [
            seen(geometry.camera, moved(spot.place, (a, ground.u), (b, ground.v), (h, ground.normal)))
            for a, b, h in product((-width / 2, width / 2), (-depth / 2, depth / 2), (0.0, height))
        ]
    )


def _is_on(geometry: FrameGeometry, place: Vector3) -> bool:
    """Whether a place is seen on the canvas."""
    (x, y), canvas = seen(geometry.camera, place), geometry.document.canvas
    return 0 <= x <= canvas.width_px and 0 <= y <= canvas.height_px


def _part_on_canvas(geometry: FrameGeometry, corners: Matrix) -> float:
    """Return which part of the picture of a box lies on the canvas."""
    canvas = geometry.document.canvas
    low, high = corners.min(axis=0), corners.max(axis=0)
    kept = np.minimum(high, (canvas.width_px, canvas.height_px)) - np.maximum(low, 0.0)
    return float(np.prod(np.maximum(kept, 0.0) / np.maximum(high - low, 1e-9)))
