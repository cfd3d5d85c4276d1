"""Where a new wall stands: behind all figures over the whole cut, where their shadows bend well, across the canvas."""

from collections.abc import Iterable
from math import inf
from typing import Final, NamedTuple

import numpy as np

from kagezou.document.model import Document
from kagezou.document.piece_kinds import TRAITS, kind_of
from kagezou.geometry.ground import Plane
from kagezou.geometry.sets.shapes import stand_on
from kagezou.geometry.sight import MIN_DEPTH, depth_of, seen
from kagezou.geometry.vectors import Matrix, Vector3, dot, height_over
from kagezou.message import Message
from kagezou.scene.evaluate import camera_at, ground_at
from kagezou.scene.piece_frames import piece_frame
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.sight import between, moved
from kagezou.tools.wall_fitting import FigureSide, reach_on, sides_of

_NEAR, _BEST, _FAR = 0.35, 0.5, 0.7
"""Which part of the way of a shadow should lie on the ground before the wall."""

_PLACES: Final = 61
_BEHIND: Final = 0.25
"""So many figure heights behind the figures a wall stands on which no shadow falls."""

_LEAST_WAY: Final = 0.05
"""A shadow that goes back by fewer figure heights does not fall on a wall."""

_CLEARANCE: Final = 0.03
"""By so many figure heights a wall stays behind every part of a figure."""

_ABOVE: Final = 1.3
"""The least height of a wall, in heights of the tallest figure."""

_RIM: Final = 0.12
"""How much of a wall is left around the shadows on it, in figure heights."""

_LEAST_PACE: Final = 0.2
"""A ground line steeper than this is as good as upright: a wall on it is not drawn out to the canvas' sides."""

_MOST_OF_CANVAS: Final = 3.0
"""A shadow that falls on a wall farther away than so many canvases is not followed."""


class WallSpot(NamedTuple):
    """The middle of a wall's foot, world px, and its width and height, world px."""

    place: Vector3
    width: float
    height: float


def wall_spot(
    geometry: FrameGeometry, sides: tuple[FigureSide, ...], height: float, taken: Iterable[Vector3]
) -> WallSpot | None:
    """Return where a wall stands; None where its foot would be seen nowhere.

    Parameters
    ----------
    geometry
        What is looked at.
    sides
        Of all figures over the cut.
    height
        That of a figure, world px.
    taken
        Where other walls stand.
    """
    ground = geometry.ground
    tall = max((_length(between(side.foot, side.top)) for side in sides), default=height)
    for behind in _places(ground, sides, geometry.contact, tall, taken):
        place = _centred(geometry, moved(geometry.contact, (behind, ground.v)))
        if place is not None:
            return _fitted(geometry, place, sides, tall)
    return None


def cut_notes(before: Document, after: Document) -> tuple[Message, ...]:
    """Return what the user should know of new walls that are too low for the shadows on them over the cut."""
    known, camera, ground = {piece.id for piece in before.pieces}, camera_at(after, 1), ground_at(after, 1)
    new = [piece for piece in after.pieces if piece.id not in known and TRAITS[kind_of(piece)].is_backdrop]
    sides = sides_of(after, 1) if new else ()
    notes = []
    for piece in new:
        found = piece_frame(piece, 1, camera, ground)
        reach = None if found is None else reach_on(sides, found.stand, inf)
        if found is not None and reach is not None and reach.top > found.measures.height_px:
            notes.append(
                Message("{piece}: shadows reach over its upper edge at some time and are cut off", piece=piece.name)
            )
    return tuple(notes)


def _places(
    ground: Plane, sides: tuple[FigureSide, ...], origin: Vector3, tall: float, taken: Iterable[Vector3]
) -> list[float]:
    """Return how far a wall may lie toward the viewer from a place, the best first; below 0 it lies behind."""
    feet = np.array([dot(between(origin, end), ground.v) for side in sides for end in (side.foot, side.top)])
    nearest = min(float(feet.min(initial=0.0)), 0.0) - _CLEARANCE * tall
    ways = _ways(ground, sides, origin, tall)
    farthest = min(float(ways[:, 1].min(initial=0.0)), nearest - tall)
    places = np.linspace(nearest, farthest, _PLACES)
    others = np.array([dot(between(origin, at), ground.v) for at in taken])
    crowded = (np.abs(places[:, None] - others) < _RIM * tall).any(axis=1)
    if len(ways):
        parts = (ways[:, 0] - places[:, None]) / (ways[:, 0] - ways[:, 1])
        bending = ((parts >= _NEAR) & (parts <= _FAR)).mean(axis=1)
        away = np.abs(parts - _BEST).mean(axis=1)
    else:
        bending, away = np.zeros(_PLACES), np.abs(places - nearest + _BEHIND * tall) / tall
    return [float(places[at]) for at in np.lexsort((away, -bending, crowded))]


def _ways(ground: Plane, sides: Iterable[FigureSide], origin: Vector3, tall: float) -> Matrix:
    """Return where shadows begin and end on the ground, toward the viewer from a place (N, 2); those that go back."""
    found = []
    for side in sides:
        x, y, z, w = side.light
        ray = (x - w * side.top[0], y - w * side.top[1], z - w * side.top[2])
        rise, high = dot(ray, ground.normal), height_over(ground.equation, (*side.top, 1.0))
        if rise <= 0 or high <= 0:
            continue
        tip = moved(side.top, (-high / rise, ray))
        begin, end = (dot(between(origin, at), ground.v) for at in (side.foot, tip))
        if begin - end > _LEAST_WAY * tall:
            found.append((begin, end))
    return np.array(found, np.float64).reshape(-1, 2)


def _centred(geometry: FrameGeometry, place: Vector3) -> Vector3 | None:
    """Return the place moved along the ground line to the middle column of the canvas; None where it is not seen."""
    camera, canvas = geometry.camera, geometry.document.canvas
    if depth_of(camera, place) <= MIN_DEPTH:
        return None
    aside = canvas.width_px / 2 - seen(camera, place)[0]
    centred = moved(place, (aside / _pace(geometry, place), geometry.ground.u))
    row = seen(camera, centred)[1]
    return centred if 0 <= row <= canvas.height_px else None


def _pace(geometry: FrameGeometry, place: Vector3) -> float:
    """Return how many columns of the canvas one px along the ground line is seen as."""
    return max(geometry.ground.u[0], _LEAST_PACE) / depth_of(geometry.camera, place)


def _fitted(geometry: FrameGeometry, place: Vector3, sides: tuple[FigureSide, ...], tall: float) -> WallSpot:
    """Return a wall across the canvas, and as wide and high as the shadows on it need."""
    camera, canvas, ground = geometry.camera, geometry.document.canvas, geometry.ground
    most = _MOST_OF_CANVAS * max(canvas.width_px, canvas.height_px) * depth_of(camera, place)
    reach = reach_on(sides, stand_on(ground, place, 0.0), most)
    high = _ABOVE * tall if reach is None else max(_ABOVE * tall, reach.top + _RIM * tall)
    leaning = abs(seen(camera, moved(place, (high, ground.normal)))[0] - seen(camera, place)[0])
    half = min((canvas.width_px / 2 + leaning) / _pace(geometry, place), most)
    if reach is not None:
        half = max(half, reach.right + _RIM * tall, _RIM * tall - reach.left)
    return WallSpot(place, 2 * half, high)


def _length(way: Vector3) -> float:
    return float(np.linalg.norm(way))
