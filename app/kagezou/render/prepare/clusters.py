"""Triangles in clusters: those that lie near each other are drawn, or left out, together."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.vectors import Matrix
from kagezou.render.prepare.mask_tiles import Flags

_LEAST_TRIANGLES = 64
_MOST_CLUSTERS = 1024
"""A mesh has so many at most, each of so many triangles at least."""

_SKIPPED_GAP = 2
"""So few clusters that are not needed between two that are cost less than another call."""

_LEVELS = 10
"""Bits of a place along each axis."""

_SPREAD = ((16, 0x030000FF), (8, 0x0300F00F), (4, 0x030C30C3), (2, 0x09249249))
"""Steps that put two empty bits between any two of a place, so that those of three axes can stand in turn."""

Numbers = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Clusters:
    """Runs of triangles, and boxes around each.

    Parameters
    ----------
    firsts
        (C + 1,): the number of the first triangle of each, and at last how many triangles there are.
    low, high
        (C, 3): the boxes.
    """

    firsts: Numbers
    low: Matrix
    high: Matrix

    @staticmethod
    def of(corners: Matrix) -> "Clusters":
        """Return the clusters of triangles (N, 3, 3) that :func:`near_together` has put in order."""
        size = max(_LEAST_TRIANGLES, -(-len(corners) // _MOST_CLUSTERS))
        firsts = np.append(np.arange(0, len(corners), size), len(corners))
        if len(corners) == 0:
            return Clusters(np.zeros(1, np.int64), np.zeros((0, 3)), np.zeros((0, 3)))
        low = np.minimum.reduceat(corners.min(axis=1), firsts[:-1])
        high = np.maximum.reduceat(corners.max(axis=1), firsts[:-1])
        return Clusters(firsts, low, high)

    def hulls(self) -> Matrix:
        """Return the corners of the boxes, (8, 3, C)."""
        ends = self.low.T, self.high.T
        return np.array([[ends[x][0], ends[y][1], ends[z][2]] for x in (0, 1) for y in (0, 1) for z in (0, 1)])

    def runs(self, clip_rows: Matrix) -> list[tuple[int, int]]:
        """Return the runs of triangles, each by its first one and how many, that may lie in a clip space.

        Parameters
        ----------
        clip_rows
            (4, 4), to it.
        """
        w = clip_rows[3]
        forms = np.concatenate([w + clip_rows[:3], w - clip_rows[:3]])
        # The corner of a box that lies farthest along a form decides.
        most = np.maximum(forms[:, :3], 0) @ self.high.T + np.minimum(forms[:, :3], 0) @ self.low.T
        return self._joined((most + forms[:, 3:] >= 0).all(axis=0))

    def _joined(self, wanted: Flags) -> list[tuple[int, int]]:
        numbers = np.nonzero(wanted)[0]
        if len(numbers) == 0:
            return []
        breaks = np.nonzero(np.diff(numbers) > _SKIPPED_GAP)[0]
        starts = self.firsts[numbers[np.append(0, breaks + 1)]]
        stops = self.firsts[numbers[np.append(breaks, len(numbers) - 1)] + 1]
        return list(zip(starts.tolist(), (stops - starts).tolist(), strict=True))


def near_together(corners: Matrix) -> Numbers:
    """Return an order (N,) of triangles (N, 3, 3) in which those that lie near each other stand near each other."""
    if len(corners) == 0:
        return np.zeros(0, np.int64)
    middles = corners.mean(axis=1)
    low = middles.min(axis=0)
    span = max(float((middles.max(axis=0) - low).max()), 1e-30)
    places = np.minimum((middles - low) * ((1 << _LEVELS) / span), (1 << _LEVELS) - 1).astype(np.int64)
    for step, kept in _SPREAD:
        places = (places | places << step) & kept
    return np.argsort(places[:, 0] | places[:, 1] << 1 | places[:, 2] << 2, kind="stable")
