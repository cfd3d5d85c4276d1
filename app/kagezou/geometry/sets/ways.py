"""Straight ways through the bodies of set pieces: where they enter and leave."""

import numpy as np

from kagezou.geometry.sets.bodies import Ball, Body, Drum, Solid
from kagezou.geometry.vectors import Matrix, Vector4

ENDLESS_PX = 1e9
"""As far as this goes a way without an end."""


def ways_to(aim: Vector4, points: Matrix) -> tuple[Matrix, Matrix]:
    """Return the unit way (N, 3) from each point (N, 3) to a homogeneous point, and how far it goes (N,), world px."""
    ways = np.array(aim[:3]) - aim[3] * points
    lengths = np.linalg.norm(ways, axis=1)
    ways = ways / np.maximum(lengths, 1e-9)[:, None]
    return ways, lengths if aim[3] else np.full(len(points), ENDLESS_PX)


def way_within(body: Body, points: Matrix, ways: Matrix, begin: Matrix, end: Matrix) -> tuple[Matrix, Matrix]:
    """Return the part of each way that lies within a closed body.

    Parameters
    ----------
    body
        Not a sheet, which has no inside.
    points, ways
        Where they start and their unit directions, (N, 3), world px.
    begin, end
        Which part of each is asked after, (N,), px from its point.

    Returns
    -------
    begin, end
        Where each enters and leaves; ``end`` <= ``begin`` where it passes by.
    """
    planes = [facet.equation for facet in body.facets] if isinstance(body, Solid) else []
    if isinstance(body, Drum):
        planes = list(body.ends)
    if planes:
        normals, offsets = np.array(planes)[:, :3].T, np.array(planes)[:, 3]
        begin, end = _under(points @ normals + offsets, ways @ normals, begin, end)
    if isinstance(body, Ball | Drum):
        begin, end = _within(body.quadric, points, ways, begin, end)
    return begin, end


def _under(heights: Matrix, rises: Matrix, begin: Matrix, end: Matrix) -> tuple[Matrix, Matrix]:
    """Return the part of each way from ``begin`` to ``end`` over none of the planes; heights are (N, planes)."""
    level = np.abs(rises) < 1e-9
    crossings = -heights / np.where(level, 1.0, rises)
    begin = np.maximum(begin, np.where(~level & (rises < 0), crossings, -np.inf).max(axis=1))
    end = np.minimum(end, np.where(~level & (rises > 0), crossings, np.inf).min(axis=1))
    return begin, np.where((level & (heights > -1e-6)).any(axis=1), begin, end)


def _within(form: Matrix, points: Matrix, ways: Matrix, begin: Matrix, end: Matrix) -> tuple[Matrix, Matrix]:
    """Return the part of each way from ``begin`` to ``end`` that lies within a quadric."""
    start = np.column_stack([points, np.ones(len(points))])
    way = np.column_stack([ways, np.zeros(len(ways))])
    a, b, c = (np.einsum("ij,jk,ik->i", x, form, y) for x, y in ((way, way), (way, start), (start, start)))
    inside = b * b - a * c
    meets = (inside > 0) & (a > 1e-12)
    root, whole = np.sqrt(np.where(meets, inside, 0.0)), np.where(a > 1e-12, a, 1.0)
    begin = np.where(meets, np.maximum(begin, (-b - root) / whole), begin)
    return begin, np.where(meets, np.minimum(end, (-b + root) / whole), begin)
