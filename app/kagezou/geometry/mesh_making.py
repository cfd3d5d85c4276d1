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
Points = NDArray[np.float64] | NDArray[np.float32]


def mesh_of(points: Points, corners: NDArray[np.integer]) -> Mesh:
    """Return a mesh of triangles; it has none where all of them lie on lines or points.

    Parameters
    ----------
    points
        (N, 3) float64 or float32, finite.
    corners
        (M, 3) whole numbers, indices of points.
    """
    vertices, index = _united(points)
    triangles = index[corners]
    normals, has_area = _normals(vertices, triangles)
    triangles, normals = triangles[has_area], normals[has_area]
    vertices, triangles = _used(vertices, triangles)
    return Mesh(vertices, triangles, _lines(triangles, normals, len(vertices)))


def _united(points: Points) -> tuple[Matrix, Indices]:
    """Return the different points, and for each old one its new number."""
    order = np.argsort(_mixed(points), kind="stable").astype(np.int32)
    # Different points may be mixed alike; equal ones torn apart by that stay apart, which harms nothing.
    is_new = np.ones(len(points), bool)
    for start in range(1, len(points), _PIECE):
        end = min(start + _PIECE, len(points))
        is_new[start:end] = (points[order[start:end]] != points[order[start - 1 : end - 1]]).any(axis=1)
    index = np.empty(len(points), np.int32)
    index[order] = np.cumsum(is_new, dtype=np.int32) - 1
    return points[order[is_new]].astype(np.float64) + 0.0, index


def _mixed(points: Points) -> NDArray[np.uint64]:
    """Return a number for each point, the same for equal ones; piece by piece, as points are most of the memory."""
    mixed = np.zeros(len(points), np.uint64)
    for start in range(0, len(points), _PIECE):
        piece = slice(start, start + _PIECE)
        for column, mixer in enumerate(_MIXERS):
            # Without minus zeros, so that equal numbers have equal bits. It is meant to run over.
            mixed[piece] = (mixed[piece] ^ _bits(points[piece, column].astype(np.float64) + 0.0)) * np.uint64(mixer)
            mixed[piece] ^= mixed[piece] >> np.uint64(29)
    return mixed


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
    order = np.argsort(keys, kind="stable").astype(np.int32)
    # In place: every copy of them is as large as all triangles.
    keys.sort()
    first = np.flatnonzero(np.concatenate([[True], keys[1:] != keys[:-1]])[: len(keys)])
    is_drawn = np.diff(np.append(first, len(keys))) != 2
    pairs = np.flatnonzero(~is_drawn)
    for start in range(0, len(pairs), _PIECE):
        piece = pairs[start : start + _PIECE]
        here, there = order[first[piece]], order[first[piece] + 1]
        faces = len(triangles)
        cosines = np.einsum("ij,ij->i", normals[here % faces], normals[there % faces])
        # Neighbours run along their edge in opposite directions, unless one of them is inside out.
        cosines[is_upward[here] == is_upward[there]] *= -1
        is_drawn[piece] = cosines < cos(radians(CREASE_DEG))
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
