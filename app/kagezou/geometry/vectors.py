"""The few vector types the geometry is written in."""

from collections.abc import Sequence
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

Point2: TypeAlias = tuple[float, float]
"""A point on the canvas, px, y down."""

Vector3: TypeAlias = tuple[float, float, float]
"""A point or direction in the world, px."""

Vector4: TypeAlias = tuple[float, float, float, float]
"""A homogeneous point (w = 1), direction (w = 0) or plane (n, d) with n·X + d = 0."""

Matrix: TypeAlias = NDArray[np.float64]
"""A float64 matrix; its shape stands in the docstring of whatever returns it."""


_SAME_DIRECTION = 1e-9
_SAME_PLACE_PX = 1e-6


def dot(a: Vector3, b: Vector3) -> float:
    """Return the scalar product of two vectors."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def plane_through(point: Vector3, normal: Vector3) -> Vector4:
    """Return the plane (n, d) with n·X + d = 0 through ``point``."""
    return (*normal, -dot(normal, point))


def coinciding(plane: Vector4, others: Sequence[Vector4] | Matrix) -> NDArray[np.bool_]:
    """Return which planes (n, d) of ``others`` are one and the same as ``plane``, whichever way their normals point."""
    first, second = (
        each / np.linalg.norm(each[:, :3], axis=1, keepdims=True) for each in (np.array([plane]), np.array(others))
    )
    second = np.where(second[:, :3] @ first[0, :3] > 0, 1.0, -1.0)[:, np.newaxis] * second
    apart = np.abs(first - second)
    return np.asarray((apart[:, :3].max(axis=1) < _SAME_DIRECTION) & (apart[:, 3] < _SAME_PLACE_PX))


def height_over(plane: Vector4, point: Vector4) -> float:
    """Return plane·point: for a unit normal and w = 1 the signed distance in px."""
    return sum(a * b for a, b in zip(plane, point, strict=True))
