"""The shapes of set pieces, built on a stand: a frame on the ground whose v points out of the piece's front."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from math import cos, radians, sin
from typing import Final, NamedTuple, TypeAlias

import numpy as np

from kagezou.geometry.ground import Plane
from kagezou.geometry.sets.bodies import Ball, Body, Drum, Facet, Solid, vector
from kagezou.geometry.sets.measures import Measures, PieceKind, by_kind
from kagezou.geometry.vectors import Vector3

_BOX_SIDES = ((0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5))
"""The faces of a box, by corners counted 4·(right) + 2·(front) + (top)."""

_STEP_PARTS = 48
"""Into how many parts the edges of all steps together are looked at, along each of their directions."""


class Profile(NamedTuple):
    """The outline of a piece seen from its side: (toward the front, up) in px, and the parts each edge is cut into.

    Whether an edge is hidden is asked of each part; one is enough where edges are hidden as a whole.
    """

    points: tuple[tuple[float, float], ...]
    parts: int = 1


@dataclass(frozen=True, slots=True)
class Sheet:
    """A shape that is one flat face; its edges are that face's."""

    bodies: Callable[[Plane, Measures], tuple[Solid, ...]]


@dataclass(frozen=True, slots=True)
class DrawnOut:
    """A shape of flat faces: a profile drawn out along the piece's width, which gives its edges."""

    bodies: Callable[[Plane, Measures], tuple[Solid, ...]]
    profile: Callable[[Measures], Profile]


@dataclass(frozen=True, slots=True)
class Round:
    """A shape of round bodies; its edges are their rims and the outline that the eye sees."""

    bodies: Callable[[Plane, Measures], tuple[Drum | Ball, ...]]


Shape: TypeAlias = Sheet | DrawnOut | Round


def bodies_of(stand: Plane, measures: Measures) -> tuple[Body, ...]:
    """Return what a piece is made of; nothing where its kind is not built from measures."""
    shape = SHAPES[measures.kind]
    return () if shape is None else shape.bodies(stand, measures)


def stand_on(ground: Plane, place: Vector3, angle_deg: float) -> Plane:
    """Return the ground's frame moved to a place and turned about its normal; at 0° the front is the viewer's side."""
    turn = radians(angle_deg)
    u, v = np.array(ground.u), np.array(ground.v)
    return Plane(
        place,
        vector(cos(turn) * u + sin(turn) * v),
        vector(cos(turn) * v - sin(turn) * u),
        ground.normal,
    )


def wall(stand: Plane, width_px: float, height_px: float, lean_deg: float) -> tuple[Solid, ...]:
    """Return an upright sheet on the stand's u, leaning away from its front by an angle."""
    lean = radians(lean_deg)
    back, rise = -height_px * sin(lean), height_px * cos(lean)
    half = width_px / 2
    corners = tuple(
        _at(stand, a, b, h) for a, b, h in ((-half, 0, 0), (half, 0, 0), (half, back, rise), (-half, back, rise))
    )
    normal = vector(cos(lean) * np.array(stand.v) + sin(lean) * np.array(stand.normal))
    return (Solid((Facet(corners, normal),), is_sheet=True),)


def box(stand: Plane, width_px: float, depth_px: float, height_px: float) -> tuple[Solid, ...]:
    """Return a box with its base around the stand."""
    return (_block(stand, width_px / 2, (-depth_px / 2, depth_px / 2), (0.0, height_px)),)


def steps(stand: Plane, width_px: float, depth_px: float, height_px: float, count: int) -> tuple[Solid, ...]:
    """Return steps that rise from the front to the back: one block a step, each lying on the one before."""
    tread, riser = depth_px / count, height_px / count
    return tuple(
        _block(stand, width_px / 2, (-depth_px / 2, depth_px / 2 - each * tread), (each * riser, (each + 1) * riser))
        for each in range(count)
    )


def ramp(stand: Plane, width_px: float, depth_px: float, height_px: float) -> tuple[Solid, ...]:
    """Return a wedge that rises from the front to the back."""
    half, front, back = width_px / 2, depth_px / 2, -depth_px / 2
    left, right = (
        tuple(_at(stand, side, b, h) for b, h in ((front, 0), (back, 0), (back, height_px))) for side in (-half, half)
    )
    rims = [left, right, *((left[i], left[j], right[j], right[i]) for i, j in ((0, 1), (1, 2), (2, 0)))]
    return (_closed(rims),)


def drum(stand: Plane, width_px: float, height_px: float) -> tuple[Drum, ...]:
    """Return an upright cylinder of a diameter."""
    return (Drum(stand.origin, stand.normal, width_px / 2, height_px),)


def ball(stand: Plane, width_px: float) -> tuple[Ball, ...]:
    """Return a sphere of a diameter that touches the stand."""
    return (Ball(_at(stand, 0, 0, width_px / 2), width_px / 2),)


def _at(stand: Plane, a: float, b: float, h: float) -> Vector3:
    u, v, up = (np.array(axis) for axis in (stand.u, stand.v, stand.normal))
    return vector(np.array(stand.origin) + a * u + b * v + h * up)


def _block(stand: Plane, half_px: float, along: tuple[float, float], rise: tuple[float, float]) -> Solid:
    corners = [_at(stand, a, b, h) for a in (-half_px, half_px) for b in along for h in rise]
    return _closed([tuple(corners[index] for index in side) for side in _BOX_SIDES])


def _closed(rims: Sequence[tuple[Vector3, ...]]) -> Solid:
    """Return the convex body within rims, whose normals then point away from its middle."""
    middle = np.mean([corner for rim in rims for corner in rim], axis=0)
    facets = []
    for rim in rims:
        first, second, third = (np.array(corner) for corner in rim[:3])
        normal = np.cross(second - first, third - first)
        normal /= np.linalg.norm(normal)
        facets.append(Facet(rim, vector(normal if normal @ (first - middle) > 0 else -normal)))
    return Solid(tuple(facets))


def _box_profile(measures: Measures) -> Profile:
    front, top = measures.depth_px / 2, measures.height_px
    return Profile(((front, 0.0), (front, top), (-front, top), (-front, 0.0)))


def _steps_profile(measures: Measures) -> Profile:
    """Return the outline of steps from the foot of the first one; where steps are many, each edge is cut less."""
    depth, count = measures.depth_px, measures.count
    tread, riser = depth / count, measures.height_px / count
    points = [(depth / 2, 0.0)]
    for each in range(count):
        front, top = depth / 2 - each * tread, (each + 1) * riser
        points += [(front, top), (front - tread, top)]
    return Profile((*points, (-depth / 2, 0.0)), max(_STEP_PARTS // count, 2))


def _ramp_profile(measures: Measures) -> Profile:
    front = measures.depth_px / 2
    return Profile(((front, 0.0), (-front, measures.height_px), (-front, 0.0)))


SHAPES: Final[Mapping[PieceKind, Shape | None]] = by_kind({
    PieceKind.WALL: Sheet(lambda stand, size: wall(stand, size.width_px, size.height_px, size.lean_deg)),
    PieceKind.BOX: DrawnOut(
        lambda stand, size: box(stand, size.width_px, size.depth_px, size.height_px), _box_profile
    ),
    PieceKind.STEPS: DrawnOut(
        lambda stand, size: steps(stand, size.width_px, size.depth_px, size.height_px, size.count), _steps_profile
    ),
    PieceKind.RAMP: DrawnOut(
        lambda stand, size: ramp(stand, size.width_px, size.depth_px, size.height_px), _ramp_profile
    ),
    PieceKind.CYLINDER: Round(lambda stand, size: drum(stand, size.width_px, size.height_px)),
    PieceKind.SPHERE: Round(lambda stand, size: ball(stand, size.width_px)),
    PieceKind.MESH: None,
})  # fmt: skip
"""How each kind is built from its measures; None for what is not."""
