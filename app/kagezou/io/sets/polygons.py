"""Polygons cut into triangles, each in the plane that it lies in best, so that doorways stay open."""

from dataclasses import dataclass, field
from typing import Any, Final

import mapbox_earcut
import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.vectors import Matrix
from kagezou.io.sets.crossings import loops_apart, simple_loops
from kagezou.io.sets.triangles import Indices, Triangles
from kagezou.message import Message

MAX_CORNERS: Final = 20_000
"""A polygon that is not convex and has more takes too long."""

_MAX_WORK: Final = 4_000_000_000
"""The squares of the corners of such polygons, together: some ten seconds at worst."""

_HARDLY: Final = 1e-9
"""The part of a polygon's area that a triangle may have on the wrong side and still count as none."""

_SAME_AREA: Final = 1e-6

_PIECE: Final = 1 << 18
"""So many corners are looked at together."""

_TRIANGLE, _QUAD = 3, 4


def triangulated(points: Matrix, counts: Indices, corners: Indices) -> Triangles:
    """Return polygons as triangles.

    A polygon of which fans of triangles around a corner cover all is cut so; any other is cut in its plane by ears. One
    that crosses itself is every loop of it.

    Parameters
    ----------
    points
        (N, 3) float64.
    counts
        (F,) whole numbers, how many corners each polygon has; together all of ``corners``.
    corners
        (C,) whole numbers, indices of points, polygon after polygon.
    """
    starts = np.cumsum(counts) - counts
    cutting = _Cutting(points)
    made: list[Indices] = [np.zeros((0, 3), np.int32)]
    for count in np.unique(counts[counts >= _TRIANGLE]).tolist():
        firsts = starts[counts == count]
        step = max(_PIECE // count, 1)
        for at in range(0, len(firsts), step):
            rows = corners[firsts[at : at + step, np.newaxis] + np.arange(count)]
            made.append((rows if count == _TRIANGLE else cutting.cut(rows)).astype(np.int32))
    triangles = np.concatenate(made)
    return Triangles(cutting.all_points(), triangles, cutting.notes(int((counts < _TRIANGLE).sum())))


@dataclass(slots=True)
class _Cutting:
    """Polygons being cut; where they cross themselves there are new points."""

    points: Matrix
    crossings: list[Matrix] = field(default_factory=list)
    crossing: int = 0
    left_out: int = 0
    work: int = 0

    def all_points(self) -> Matrix:
        return np.concatenate([self.points, *self.crossings]) if self.crossings else self.points

    def notes(self, too_few: int) -> tuple[Message, ...]:
        """Return what is to be said, after so many faces with too few corners."""
        made = []
        if too_few:
            made.append(Message("{count} of its faces have fewer than three corners and are not used", count=too_few))
        if self.crossing:
            made.append(
                Message("{count} of its faces cross or touch themselves: every loop is filled", count=self.crossing)
            )
        if self.left_out:
            made.append(
                Message(
                    "{count} of its faces have too many corners or cross themselves too often and are left out",
                    count=self.left_out,
                )
            )
        return tuple(made)

    def cut(self, rows: Indices) -> Indices:
        """Return polygons (K, N), N > 3, as triangles (M, 3)."""
        is_fan = _are_fans(self.points[rows])
        made = [_fans(rows[is_fan])]
        rest = rows[~is_fan]
        if rows.shape[1] == _QUAD and len(rest):
            # A quadrangle with one corner inward is right around that corner or the one across.
            turned = np.roll(rest, 1, axis=1)
            is_fan = _are_fans(self.points[turned])
            made.append(_fans(turned[is_fan]))
            rest = rest[~is_fan]
        made += [self._ears(row) for row in rest]
        return np.concatenate(made)

    def _ears(self, row: Indices) -> Indices:
        nothing = np.zeros((0, 3), np.int64)
        self.work += len(row) ** 2
        if len(row) > MAX_CORNERS or self.work > _MAX_WORK:
            self.left_out += 1
            return nothing
        polygon = self.points[row]
        seen, area = _in_its_plane(polygon)
        if seen is None:
            return nothing
        found = _ears_of(seen)
        if _is_about(_area_of(seen, found), area):
            return np.asarray(row[found], np.int64)
        return self._loops(polygon, seen)

    def _loops(self, polygon: Matrix, seen: Matrix) -> Indices:
        """Return the loops of a polygon that crosses or touches itself, all of their points new."""
        loops = simple_loops(np.concatenate([seen, polygon], axis=1))
        if loops is None:
            self.left_out += 1
            return np.zeros((0, 3), np.int64)
        self.crossing += 1
        made: list[Indices] = [np.zeros((0, 3), np.int64)]
        for loop in loops:
            whole = _ears_of(loop[:, :2])
            if _is_about(_area_of(loop[:, :2], whole), _enclosed(loop[:, :2])):
                made.append(self._added(loop, whole))
            else:
                made += [self._added(part, _ears_of(part[:, :2])) for part in loops_apart(loop)]
        return np.concatenate(made)

    def _added(self, loop: Matrix, triangles: Indices) -> Indices:
        start = len(self.points) + sum(map(len, self.crossings))
        self.crossings.append(loop[:, 2:])
        return triangles + start


def _fans(rows: Indices) -> Indices:
    """Return polygons (K, N) as triangles around their first corners."""
    return np.stack([np.broadcast_to(rows[:, :1], rows[:, 1:-1].shape), rows[:, 1:-1], rows[:, 2:]], axis=-1).reshape(
        -1, 3
    )


def _are_fans(polygons: Matrix) -> NDArray[np.bool_]:
    """Return which polygons (K, N, 3) are covered by triangles around their first corners, none on the wrong side."""
    with np.errstate(all="ignore"):
        from_first = polygons - polygons[:, :1]
        across = np.cross(from_first[:, 1:-1], from_first[:, 2:])
        normal = across.sum(axis=1)
        lean, size = np.einsum("kij,kj->ki", across, normal), np.einsum("kj,kj->k", normal, normal)
        covers = (lean >= -_HARDLY * size[:, np.newaxis]).all(axis=1) & (size > 0)
    # What is no number is refused later on, whatever it is cut into.
    return np.asarray(covers | ~np.isfinite(size))


def _in_its_plane(polygon: Matrix) -> tuple[Matrix | None, float]:
    """Return a polygon (N, 3) as its plane shows it (N, 2), and its area there; None for one on a line."""
    from_first = polygon - polygon[0]
    size = float(np.abs(from_first).max())
    if size == 0:
        return None, 0.0
    from_first = from_first / size
    across = np.cross(from_first[1:-1], from_first[2:])
    normal = across.sum(axis=0)
    lengths = np.linalg.norm(across, axis=1)
    # Loops that run the other way may take the whole area away.
    if np.linalg.norm(normal) < _SAME_AREA * lengths.max():
        normal = across[lengths.argmax()]
    length = float(np.linalg.norm(normal))
    if length == 0:
        return None, 0.0
    normal = normal / length
    first = np.cross(normal, np.eye(3)[np.abs(normal).argmin()])
    first = first / np.linalg.norm(first)
    seen = np.ascontiguousarray(from_first @ np.stack([first, np.cross(normal, first)], axis=1))
    return seen, abs(float(across.sum(axis=0) @ normal)) / 2


def _ears_of(seen: Matrix) -> NDArray[np.int64]:
    found: Any = mapbox_earcut.triangulate_float64(np.ascontiguousarray(seen), np.array([len(seen)], np.uint32))
    return np.asarray(found, np.int64).reshape(-1, 3)


def _is_about(one: float, other: float) -> bool:
    return abs(one - other) <= _SAME_AREA * other


def _enclosed(seen: Matrix) -> float:
    """Return the area of a ring (N, 2), of which what runs the other way round is taken away."""
    (x, y), (next_x, next_y) = seen.T, np.roll(seen, -1, axis=0).T
    return abs(float((x * next_y - y * next_x).sum())) / 2


def _area_of(seen: Matrix, triangles: Indices) -> float:
    a, b, c = (seen[triangles[:, corner]] for corner in range(3))
    (ux, uy), (vx, vy) = (b - a).T, (c - a).T
    return float(np.abs(ux * vy - uy * vx).sum()) / 2
