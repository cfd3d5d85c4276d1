"""Where a new set piece is put: on the ground behind the figure or beside it, seen, and sized from the figure."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import product
from math import dist

from kagezou.document import set_properties as lines
from kagezou.document.model import Document
from kagezou.document.piece_kinds import BUILT_KINDS, TRAITS
from kagezou.document.set_pieces import add_piece, stood_up
from kagezou.geometry.sets.measures import PieceKind
from kagezou.geometry.sets.shapes import stand_on
from kagezou.geometry.sight import MIN_DEPTH, depth_of, seen
from kagezou.geometry.vectors import Vector3, dot
from kagezou.scene.piece_frames import piece_frame
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.shadow import tip_of
from kagezou.tools.sight import between, moved
from kagezou.tools.view import CanvasView
from kagezou.tools.wall_fitting import FigureSide, farthest_back, reach_on, sides_of

_BEHIND = (0.25, 0.8, 0.0, 1.4)
_BEHIND_OF_WALL = (0.45, 0.8, 0.25, 1.3)
_BEFORE_TIP = 0.6
"""A wall stands within this part of the way to where the head's shadow would fall on the ground."""

_NEAREST_WALL = 0.12
"""Nearer than so many heights no wall is put; a shadow that goes back by less stays on the ground before it."""

_GROWN = (1.0, 0.7, 0.45)
_CLEARANCE = 0.12
_CROWDED = 0.5
"""How much less a place is worth on which something stands already."""

_ENOUGH_OF_WALL, _ENOUGH = 0.5, 0.97
"""How much of a new piece should lie on the canvas."""

_MOST_OF_CANVAS = 3.0
"""A shadow that falls on a wall farther away than so many canvases is not followed."""

_FIGURE_OF_CANVAS = 0.5
"""The height of a figure where there is none, as a part of the canvas' height."""


@dataclass(frozen=True, slots=True)
class _Figure:
    """What a piece is sized from: where it stands, how high it is and how far it reaches aside, world px."""

    foot: Vector3
    height: float
    half_width: float


@dataclass(frozen=True, slots=True)
class _Spot:
    """A place of the ground, the size of the piece there, and its worth: which part of it would be on the canvas."""

    place: Vector3
    size: tuple[float, float, float]
    worth: float


def add_placed(
    document: Document,
    frame: int,
    layer_id: str | None,
    kind: PieceKind,
    name: str,
    wanted: Mapping[str, object] | None = None,
) -> tuple[Document, str]:
    """Return the document with a new piece where it is seen, and the piece's id; figures stand up as it does.

    A wall stands behind all figures over the whole cut, and their shadows fit on it.

    Parameters
    ----------
    document, frame
        What is looked at.
    layer_id
        The layer whose figure it is put beside; None for the topmost.
    kind, name
        As for :func:`~kagezou.document.set_pieces.add_piece`, which also says what is refused.
    wanted
        Constants that are settled already, by property name.
    """
    document = stood_up(document)
    if layer_id is None and document.layers:
        layer_id = document.layers[-1].id
    geometry = FrameGeometry.of(document, frame, layer_id, CanvasView())
    sides = sides_of(document, frame) if TRAITS[kind].is_backdrop else ()
    spot = _best_spot(geometry, kind, sides)
    if spot is not None and sides:
        spot = _fitted(geometry, spot, sides)
    values: dict[str, object] = {}
    if spot is not None:
        scale = depth_of(geometry.camera, spot.place)
        x, y = seen(geometry.camera, spot.place)
        values[lines.PIECE_POSITION.name] = (float(round(x)), float(round(y)))
        sized = zip((lines.PIECE_WIDTH, lines.PIECE_HEIGHT, lines.PIECE_DEPTH), spot.size, strict=True)
        values |= {prop.name: float(max(round(size / scale), 1)) for prop, size in sized}
    document = add_piece(document, name, kind, {**values, **(wanted or {})})
    return document, document.pieces[-1].id


def _fitted(geometry: FrameGeometry, spot: _Spot, sides: tuple[FigureSide, ...]) -> _Spot:
    """Return the spot of a wall as wide and high as the shadows on it need."""
    (width, height, depth), canvas = spot.size, geometry.document.canvas
    most = _MOST_OF_CANVAS * max(canvas.width_px, canvas.height_px) * depth_of(geometry.camera, spot.place)
    reach = reach_on(sides, stand_on(geometry.ground, spot.place, 0.0), most)
    if reach is None:
        return spot
    rim = _CLEARANCE * _figure(geometry).height
    left, right = min(-width / 2, reach.left - rim), max(width / 2, reach.right + rim)
    place = moved(spot.place, ((left + right) / 2, geometry.ground.u))
    return replace(spot, place=place, size=(right - left, max(height, reach.top + rim), depth))


def _best_spot(geometry: FrameGeometry, kind: PieceKind, sides: tuple[FigureSide, ...]) -> _Spot | None:
    """Return the first spot that is good enough, else the best; None where a piece would be seen nowhere."""
    enough = _ENOUGH_OF_WALL if TRAITS[kind].is_backdrop else _ENOUGH
    best: _Spot | None = None
    for spot in _spots(geometry, kind, sides):
        if best is None or spot.worth > best.worth:
            best = spot
        if best.worth >= enough:
            break
    return best if best is not None and best.worth > 0 else None


def _spots(geometry: FrameGeometry, kind: PieceKind, sides: tuple[FigureSide, ...]) -> Iterator[_Spot]:
    sizes = TRAITS[kind].first_sizes
    if sizes is None:
        return
    figure, ground, camera = _figure(geometry), geometry.ground, geometry.camera
    back = farthest_back(sides, ground, figure.foot)
    first = _shadow_side(geometry)
    is_wall = TRAITS[kind].is_backdrop
    behind_it = _behind_of_wall(geometry, figure, back) if is_wall else _BEHIND
    taken = tuple(_taken(geometry, is_wall=is_wall))
    for grown, behind, side in product(_GROWN, behind_it, (0.0,) if is_wall else (first, -first)):
        width, height, depth = (figure.height * part * grown for part in sizes.of_figure)
        aside = side * (figure.half_width + width / 2 + _CLEARANCE * figure.height)
        place = moved(figure.foot, (aside, ground.u), (-behind * figure.height - back, ground.v))
        if depth_of(camera, place) <= MIN_DEPTH:
            continue
        size, reach = (width, height, depth), (depth if is_wall else max(width, depth)) / 2
        is_crowded = any(dist(place, at) < reach + room for at, room in taken)
        yield _Spot(place, size, _part_on_canvas(geometry, place, size) * (_CROWDED if is_crowded else 1.0))


def _behind_of_wall(geometry: FrameGeometry, figure: _Figure, back: float) -> tuple[float, ...]:
    """Return how far behind all figures a wall may stand, in heights, first where the head's shadow falls on it."""
    tip = tip_of(geometry)
    room = 0.0 if tip is None else -dot(between(figure.foot, tip), geometry.ground.v) - back
    nearest = _BEFORE_TIP * room / figure.height
    if nearest < _NEAREST_WALL:
        return _BEHIND_OF_WALL
    return (min(_BEHIND_OF_WALL[0], nearest), *_BEHIND_OF_WALL[1:])


def _figure(geometry: FrameGeometry) -> _Figure:
    canvas, depth = geometry.document.canvas, max(depth_of(geometry.camera, geometry.contact), MIN_DEPTH)
    box = geometry.figure_box
    if box.is_empty:
        height = _FIGURE_OF_CANVAS * canvas.height_px * depth
        return _Figure(geometry.contact, height, height / 4)
    return _Figure(geometry.contact, box.height * depth, box.width * depth / 2)


def _shadow_side(geometry: FrameGeometry) -> float:
    """Return on which side of the figure its shadow falls, where a new piece shows at once what it does."""
    tip = tip_of(geometry)
    return -1.0 if tip is not None and dot(between(geometry.contact, tip), geometry.ground.u) < 0 else 1.0


def _taken(geometry: FrameGeometry, *, is_wall: bool) -> Iterator[tuple[Vector3, float]]:
    """Yield where the other pieces stand and how far they reach; a wall has things before it, but no second wall."""
    for piece in geometry.document.pieces:
        found = piece_frame(piece, geometry.frame, geometry.camera, geometry.ground)
        if found is None or found.measures.kind not in BUILT_KINDS:
            continue
        if TRAITS[found.measures.kind].is_backdrop == is_wall:
            sizes = (found.measures.depth_px,) if is_wall else (found.measures.width_px, found.measures.depth_px)
            yield found.stand.origin, max(sizes) / 2


def _part_on_canvas(geometry: FrameGeometry, place: Vector3, size: tuple[float, float, float]) -> float:
    """Return which part of the picture of a box at a place lies on the canvas."""
    ground, canvas = geometry.ground, geometry.document.canvas
    width, height, depth = size
    corners = [
        seen(geometry.camera, moved(place, (a, ground.u), (b, ground.v), (h, ground.normal)))
        for a, b, h in product((-width / 2, width / 2), (-depth / 2, depth / 2), (0.0, height))
    ]
    part = 1.0
    for axis, limit in ((0, canvas.width_px), (1, canvas.height_px)):
        low, high = (extreme(corner[axis] for corner in corners) for extreme in (min, max))
        part *= max(min(high, limit) - max(low, 0.0), 0.0) / max(high - low, 1e-9)
    return part
