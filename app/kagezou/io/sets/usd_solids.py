"""The basic solids of USD as faces: cubes, spheres, cylinders, cones, capsules and planes about their origins."""

from collections.abc import Callable
from math import pi
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.vectors import Matrix
from kagezou.io.sets.triangles import Triangles

Value = Callable[[str], Any]
"""What gives an attribute of a solid by name."""

_AROUND: Final = 48
_UP: Final = 12
"""So many sides a round solid has around, and a quarter of one from its middle to its top."""

_TURNS: Final = {"X": (1, 2, 0), "Y": (2, 0, 1), "Z": (0, 1, 2)}
"""From the axes of a solid along z to those of one along another axis."""


def solid_of(kind: str, value: Value) -> Triangles | None:
    """Return a solid of a kind as USD calls it; None for kinds that are no solids."""
    make = _MAKERS.get(kind)
    return None if make is None else make(value)


def _cube(value: Value) -> Triangles:
    size = float(value("size"))
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float) - 0.5
    quads = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
    return Triangles(corners * size, _halves(quads))


def _plane(value: Value) -> Triangles:
    width, length = float(value("width")) / 2, float(value("length")) / 2
    # Along z its width runs along x; along x along z, along y along x.
    first, second = {"X": (2, 1), "Y": (0, 2), "Z": (0, 1)}[str(value("axis"))]
    points = np.zeros((4, 3))
    points[:, first], points[:, second] = (-width, width, width, -width), (-length, -length, length, length)
    return Triangles(points, _halves(np.array([[0, 1, 2, 3]])))


def _sphere(value: Value) -> Triangles:
    radius, heights = float(value("radius")), np.linspace(-pi / 2, pi / 2, 2 * _UP + 1)
    return _turned(radius * np.cos(heights), radius * np.sin(heights), "Z")


def _cylinder(value: Value) -> Triangles:
    radius, half = float(value("radius")), float(value("height")) / 2
    return _turned(np.array([0, radius, radius, 0]), np.array([-half, -half, half, half]), str(value("axis")))


def _tapered(value: Value) -> Triangles:
    bottom, top, half = float(value("radiusBottom")), float(value("radiusTop")), float(value("height")) / 2
    return _turned(np.array([0, bottom, top, 0]), np.array([-half, -half, half, half]), str(value("axis")))


def _cone(value: Value) -> Triangles:
    radius, half = float(value("radius")), float(value("height")) / 2
    return _turned(np.array([0, radius, 0]), np.array([-half, -half, half]), str(value("axis")))


def _capsule(value: Value) -> Triangles:
    radius = float(value("radius"))
    return _pill(radius, radius, float(value("height")) / 2, str(value("axis")))


def _tapered_capsule(value: Value) -> Triangles:
    half = float(value("height")) / 2
    return _pill(float(value("radiusBottom")), float(value("radiusTop")), half, str(value("axis")))


def _pill(bottom: float, top: float, half: float, axis: str) -> Triangles:
    below, above = np.linspace(-pi / 2, 0, _UP + 1), np.linspace(0, pi / 2, _UP + 1)
    radii = np.concatenate([bottom * np.cos(below), top * np.cos(above)])
    return _turned(radii, np.concatenate([bottom * np.sin(below) - half, top * np.sin(above) + half]), axis)


_MAKERS: Final[dict[str, Callable[[Value], Triangles]]] = {
    "Cube": _cube,
    "Plane": _plane,
    "Sphere": _sphere,
    "Cylinder": _cylinder,
    "Cylinder_1": _tapered,
    "Cone": _cone,
    "Capsule": _capsule,
    "Capsule_1": _tapered_capsule,
}


def _turned(radii: Matrix, heights: Matrix, axis: str) -> Triangles:
    """Return what radii (R,) at heights (R,) sweep around an axis; where a radius is 0 there is one point often."""
    # What is one point but for rounding is one point.
    radii = np.where(np.abs(radii) > 1e-9 * np.abs(radii).max(), radii, 0.0)
    angles = 2 * pi * np.arange(_AROUND) / _AROUND
    rings = [np.outer(radii, np.cos(angles)), np.outer(radii, np.sin(angles))]
    points = np.stack([*rings, np.broadcast_to(heights[:, np.newaxis], rings[0].shape)], axis=-1)
    at = np.arange(points[..., 0].size).reshape(len(radii), _AROUND)
    after = np.roll(at, -1, axis=1)
    quads = np.stack([at[:-1], after[:-1], after[1:], at[1:]], axis=-1).reshape(-1, 4)
    return Triangles(points.reshape(-1, 3)[:, np.argsort(_TURNS[axis])], _halves(quads))


def _halves(quads: NDArray[np.int64]) -> NDArray[np.int64]:
    return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
