"""A mesh out of any triangles: equal points made one, triangles without an area left out, edges worth drawing found."""

from math import cos, radians
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.mesh import Mesh
from kagezou.geometry.vectors import Matrix

CREASE_DEG: Final = 30.0
"""Faces that meet at a larger angle have an edge between them that is worth drawing."""

_MIXERS: Final = (0x9E3779B97F4A7C15, 0xC2B2AE3D27D4EB4F, 0x165667B19E3779F9)

_PIECE: Final = 1 << 18

Indices = NDArray[np.int32]


def mesh_of(points: Matrix, corners: NDArray[np.integer]) -> Mesh:
    """Return a mesh of triangles; it has none where all of them lie on lines or points.

    Parameters
    ----------
    points
        (N, 3) float64, finite.
    corners
        (M, 3) whole numbers, indices of points.
    """
    vertices, index = _united(points)
    triangles = index[corners]
    normals, has_area = _normals(vertices, triangles)
    triangles, normals = triangles[has_area], normals[has_area]
    vertices, triangles = _used(vertices, triangles)
    return Mesh(vertices, triangles, _lines(triangles, normals, len(vertices)))


def _united(points: Matrix) -> tuple[Matrix, Indices]:
    """Return the different points, and for each old one its new number."""
    # Without minus zeros, so that equal numbers have equal bits.
    rows = np.ascontiguousarray(points, np.float64) + 0.0
    mixed = np.zeros(len(rows), np.uint64)
    for column, mixer in enumerate(_MIXERS):
        # It is meant to run over.
        mixed = (mixed ^ _bits(rows[:, column])) * np.uint64(mixer)
        mixed ^= mixed >> np.uint64(29)
    order = np.argsort(mixed, kind="stable")
    rows = rows[order]
    # Different points may be mixed alike; equal ones torn apart by that stay apart, which harms nothing.
    is_new = np.ones(len(rows), bool)
    is_new[1:] = (rows[1:] != rows[:-1]).any(axis=1)
    index = np.empty(len(rows), np.int32)
    index[order] = np.cumsum(is_new) - 1
    return rows[is_new], index


def _bits(column: Matrix) -> NDArray[np.uint64]:
    return np.ascontiguousarray(column).view(np.uint64)


def _normals(vertices: Matrix, triangles: Indices) -> tuple[NDArray[np.float32], NDArray[np.bool_]]:
    """Return unit normals (M, 3), and which triangles have one."""
    normals = np.zeros((len(triangles), 3), np.float32)
    has_area = np.zeros(len(triangles), bool)
    # Piece by piece, as what is needed on the way takes ten times the room of what comes of it.
    for start in range(0, len(triangles), _PIECE):
        piece = slice(start, start + _PIECE)
        a, b, c = (vertices[triangles[piece, corner]] for corner in range(3))
        crossed = np.cross(b - a, c - a)
        lengths = np.linalg.norm(crossed, axis=1)
        has_area[piece] = lengths > 0
        normals[piece] = crossed / np.where(lengths > 0, lengths, 1.0)[:, None]
    return normals, has_area


def _used(vertices: Matrix, triangles: Indices) -> tuple[Matrix, Indices]:
    used = np.zeros(len(vertices), bool)
    used[triangles] = True
    index = (np.cumsum(used) - 1).astype(np.int32)
    return np.ascontiguousarray(vertices[used]), np.ascontiguousarray(index[triangles])


def _lines(triangles: Indices, normals: NDArray[np.float32], count: int) -> Indices:
    """Return creases and borders as pairs of vertices, (K, 2)."""
    keys, is_upward = _edges(triangles, count)
    order = np.argsort(keys, kind="stable")
    keys = keys[order]
    first = np.flatnonzero(np.concatenate([[True], keys[1:] != keys[:-1]])[: len(keys)])
    is_drawn = np.diff(np.append(first, len(keys))) != 2
    pairs = first[~is_drawn]
    here, there = order[pairs], order[pairs + 1]
    faces = max(len(triangles), 1)
    cosines = np.einsum("ij,ij->i", normals[here % faces], normals[there % faces])
    # Neighbours run along their edge in opposite directions, unless one of them is inside out.
    cosines[is_upward[here] == is_upward[there]] *= -1
    is_drawn[~is_drawn] = cosines < cos(radians(CREASE_DEG))
    drawn = keys[first[is_drawn]]
    return np.stack([drawn // count, drawn % count], axis=1).astype(np.int32)


def _edges(triangles: Indices, count: int) -> tuple[NDArray[np.int64], NDArray[np.bool_]]:
    """Return a number for every side of every triangle, all first sides first, and whether it runs up in it."""
    faces = len(triangles)
    keys, is_upward = np.empty(3 * faces, np.int64), np.empty(3 * faces, bool)
    for side in range(3):
        start, end = triangles[:, side], triangles[:, (side + 1) % 3]
        part = slice(side * faces, (side + 1) * faces)
        is_upward[part] = start < end
        keys[part] = np.minimum(start, end)
        keys[part] *= count
        keys[part] += np.maximum(start, end)
    return keys, is_upward
