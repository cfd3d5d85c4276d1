"""How far a light's shadows turn because a figure travels: a lamp near its way throws them now here, now there."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise
from math import atan2, degrees

from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera, project
from kagezou.geometry.ground import Plane, place_on
from kagezou.geometry.lean import Lean
from kagezou.geometry.vectors import Vector4, dot, height_over

_ANY_WAY_DEG = 360.0
_GRAZING = 1e-3
"""A ray that falls by less for each px of its way meets the ground nowhere near."""


@dataclass(frozen=True, slots=True)
class Station:
    """Where a figure is once, canvas px: the column of its middle, the row of its ground, and that of its top."""

    x: float
    ground_row: float
    top_row: float


def stations(boxes: Sequence[Box], above_px: float = 0.0, below_px: float = 0.0) -> tuple[Station, ...]:
    """Return the stations of a figure from the boxes around it in the order of time, canvas px.

    In a jump the ground stays: no row lies above both the lowest one before it and the lowest one after it.

    Parameters
    ----------
    boxes
        Around the figure, or around one of its parts.
    above_px, below_px
        How far the figure goes on over and under that part.
    """
    bottoms = [float(box.bottom) for box in boxes]
    before = accumulate(bottoms, max)
    after = [*accumulate(reversed(bottoms), max)][::-1]
    rows = (min(pair) + below_px for pair in zip(before, after, strict=True))
    return tuple(Station(box.middle[0], row, box.top - above_px) for box, row in zip(boxes, rows, strict=True))


def turn_of_shadows(camera: Camera, ground: Plane, light: Vector4, figures: Iterable[Sequence[Station]]) -> float:
    """Return by how many degrees the direction of a figure's shadow changes at most over its stations.

    The direction is that from the contact to the head's shadow as it is seen on the canvas, and the least angle that
    holds all of them counts. 360 where a shadow falls nowhere, or straight under the figure.

    Parameters
    ----------
    camera, ground
        What the figures are seen with and stand on.
    light
        A lamp or the sun, homogeneous.
    figures
        The stations of each.
    """
    turns = [0.0]
    for way in figures:
        found = [_direction_deg(camera, ground, light, station) for station in way]
        known = [each for each in found if each is not None]
        turns.append(_least_angle(known) if len(known) == len(found) else _ANY_WAY_DEG)
    return max(turns)


def _direction_deg(camera: Camera, ground: Plane, light: Vector4, station: Station) -> float | None:
    contact = place_on(camera, ground, (station.x, station.ground_row))
    if contact is None:
        return None
    head = Lean().seen_at(camera, contact[2], (station.x, station.top_row))
    x, y, z, w = light
    ray = (x - w * head[0], y - w * head[1], z - w * head[2])
    rise = dot(ray, ground.normal)
    if rise <= _GRAZING * dot(ray, ray) ** 0.5:
        return None
    part = -height_over(ground.equation, (*head, 1.0)) / rise
    tip = (head[0] + part * ray[0], head[1] + part * ray[1], head[2] + part * ray[2], 1.0)
    canvas_from_world = camera.canvas_from_world()
    if canvas_from_world[2] @ tip <= 0:
        return None
    seen = project(canvas_from_world, tip)
    way = (seen[0] - station.x, seen[1] - station.ground_row)
    return None if max(map(abs, way)) < 1.0 else degrees(atan2(way[1], way[0]))


def _least_angle(directions_deg: Sequence[float]) -> float:
    """Return the least angle that holds all directions; 0 for fewer than two."""
    if len(directions_deg) < 2:
        return 0.0
    turned = sorted(directions_deg)
    return _ANY_WAY_DEG - max(b - a for a, b in pairwise([*turned, turned[0] + _ANY_WAY_DEG]))
