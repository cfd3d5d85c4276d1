"""How far apart the outlines of two coverages lie."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

NEAR_PX, REACH_PX = 2, 4
"""Outlines further apart than this are measured by brute force."""


@dataclass(frozen=True)
class Shift:
    """Distances between two outlines, canvas px, over the points of both."""

    mean: float
    p99: float
    largest: float

    @staticmethod
    def between(first: Array, second: Array) -> "Shift":
        """Measure from every point of either 0.5 level of two coverages (H, W) to the nearest point of the other."""
        a, b = Outline.of(first), Outline.of(second)
        apart = np.concatenate([a.distance_to(b.points), b.distance_to(a.points)])
        return Shift(float(apart.mean()), float(np.quantile(apart, 0.99)), float(apart.max()))


@dataclass(frozen=True)
class Outline:
    """The 0.5 level of a coverage as segments (N, 4), from (x, y) to (x, y) px, and the cell (x, y) of each."""

    segments: Array
    cells: NDArray[np.intp]

    @property
    def points(self) -> Array:
        """The middle of each segment, (N, 2)."""
        return (self.segments[:, :2] + self.segments[:, 2:]) / 2

    @staticmethod
    def of(coverage: Array) -> "Outline":
        """Follow the level through the cells between four pixel centres, linear along their sides."""
        value = coverage - 0.5
        a, b, c, d = value[:-1, :-1], value[:-1, 1:], value[1:, 1:], value[1:, :-1]
        below = value < 0
        either, both = below[:, :-1] | below[:, 1:], below[:, :-1] & below[:, 1:]
        j, i = np.nonzero((either[:-1] | either[1:]) & ~(both[:-1] & both[1:]))
        corners = np.stack([each[j, i] for each in (a, b, c, d)], axis=1)
        places = np.array([[0.5, 0.5], [1.5, 0.5], [1.5, 1.5], [0.5, 1.5]])
        following = np.roll(corners, -1, axis=1)
        crossed = (corners < 0) != (following < 0)
        span = np.where(crossed, corners - following, 1.0)
        part = np.where(crossed, corners / span, 0.0)[..., np.newaxis]
        crossing = places + part * (np.roll(places, -1, axis=0) - places) + np.stack([i, j], axis=1)[:, np.newaxis]
        # Two crossings make one segment; four, of a saddle, make two.
        order = np.argsort(~crossed, axis=1, kind="stable")
        crossing = np.take_along_axis(crossing, order[..., np.newaxis], axis=1)
        saddle = crossed.all(axis=1)
        segments = np.concatenate([crossing[:, :2].reshape(-1, 4), crossing[saddle, 2:].reshape(-1, 4)])
        cells = np.stack([i, j], axis=1)
        return Outline(segments, np.concatenate([cells, cells[saddle]]))

    def distance_to(self, points: Array) -> Array:
        """Return how far each point (N, 2) lies from the outline."""
        low = self.cells.min(axis=0) - REACH_PX - 1
        size = self.cells.max(axis=0) - low + REACH_PX + 2
        # A saddle's second segment lies behind its first one.
        index = np.full((2, size[1], size[0]), -1)
        x, y = (self.cells - low).T
        number = np.arange(len(x))
        index[0, y[::-1], x[::-1]] = number[::-1]
        index[1, y, x] = number
        best = self._near(points, index, low, NEAR_PX)
        # Most lie so near that no cell further off can hold what is nearer.
        further = np.nonzero(best > NEAR_PX - 1)[0]
        best[further] = self._near(points[further], index, low, REACH_PX)
        for far in np.nonzero(best > REACH_PX - 1)[0]:
            best[far] = _distance(points[far], self.segments).min()
        return best

    def _near(self, points: Array, index: NDArray[np.intp], low: NDArray[np.intp], reach_px: int) -> Array:
        """Return how far points lie from the segments of the cells within a reach, of which the index has numbers."""
        reach = np.arange(-reach_px, reach_px + 1)
        px, py = np.floor(points - 0.5).astype(np.intp).T
        columns = np.clip(px[:, np.newaxis, np.newaxis] - low[0] + reach, 0, index.shape[2] - 1)
        rows = np.clip(py[:, np.newaxis, np.newaxis] - low[1] + reach[:, np.newaxis], 0, index.shape[1] - 1)
        near = index[:, rows, columns].transpose(1, 0, 2, 3).reshape(len(points), 2 * len(reach) ** 2)
        away = _distance(points[:, np.newaxis], self.segments[near])
        return np.asarray(np.where(near >= 0, away, np.inf).min(axis=1))


def _distance(points: Array, segments: Array) -> Array:
    start, run = segments[..., :2], segments[..., 2:] - segments[..., :2]
    length = np.maximum((run * run).sum(axis=-1), 1e-12)
    part = np.clip(((points - start) * run).sum(axis=-1) / length, 0, 1)
    return np.asarray(np.linalg.norm(points - start - part[..., np.newaxis] * run, axis=-1))
