"""The connected parts of masks, as runs of pixels."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

_Indices = NDArray[np.intp]


@dataclass(frozen=True, slots=True, eq=False)
class Runs:
    """The connected parts of a mask as runs of pixels of the flat picture.

    Parameters
    ----------
    starts, ends
        Where each run begins, and the first pixel beyond it (N,).
    parts
        Which part it belongs to (N,): the number of the part's first run.
    """

    starts: _Indices
    ends: _Indices
    parts: _Indices

    @classmethod
    def of(cls, mask: NDArray[np.bool_], *, diagonal: bool) -> "Runs":
        """Find the parts of a mask (H, W); its outermost columns must be alike and hide that rows go on.

        ``diagonal`` is whether pixels that touch at a corner are connected.
        """
        flat = mask.ravel()
        turns = np.flatnonzero(flat[1:] != flat[:-1]) + 1
        bounds = np.concatenate([[0] if flat[0] else [], turns, [flat.size] if flat[-1] else []]).astype(np.intp)
        starts, ends = bounds[0::2], bounds[1::2]
        beyond = mask.shape[1] + (1 if diagonal else 0)
        first = np.searchsorted(ends, starts + (2 * mask.shape[1] - beyond), "right")
        last = np.searchsorted(starts, ends + beyond, "left")
        counts = np.maximum(last - first, 0)
        above = np.repeat(np.arange(len(starts)), counts)
        below = _ranges(first, counts)
        return cls(starts, ends, _joined(len(starts), above, below))

    def areas(self) -> NDArray[np.float64]:
        """Return how many pixels the part of each run has (N,)."""
        lengths = (self.ends - self.starts).astype(np.float64)
        return np.asarray(np.bincount(self.parts, lengths, len(self.parts))[self.parts], np.float64)

    def pixels(self, wanted: NDArray[np.bool_]) -> tuple[_Indices, _Indices]:
        """Return the pixels of some runs, and the part of each."""
        lengths = (self.ends - self.starts)[wanted]
        return _ranges(self.starts[wanted], lengths), np.repeat(self.parts[wanted], lengths)

    def mask(self, wanted: NDArray[np.bool_], shape: tuple[int, ...]) -> NDArray[np.bool_]:
        """Return the mask of some runs, of the shape of the one they were found in."""
        change = np.zeros(shape[0] * shape[1] + 1, np.int8)
        change[self.starts[wanted]] = 1
        change[self.ends[wanted]] -= 1
        return np.cumsum(change[:-1], dtype=np.int8).view(np.bool_).reshape(shape)

    def reach_border(self, shape: tuple[int, ...]) -> NDArray[np.bool_]:
        """Return which runs belong to a part with one of the outermost pixels of a padded mask (N,).

        ``shape`` is that of the mask with its padding of one pixel.
        """
        height, width = shape
        row, left = np.divmod(self.starts, width)
        right = self.ends - row * width
        outermost = (row <= 1) | (row >= height - 2) | (left <= 1) | (right >= width - 1)
        return np.asarray(np.isin(self.parts, self.parts[outermost]))


def part_areas(mask: NDArray[np.bool_], *, diagonal: bool) -> NDArray[np.float64]:
    """Return how many pixels each connected part of a mask (H, W) has, the largest first.

    ``diagonal`` is whether pixels that touch at a corner are connected.
    """
    if not mask.any():
        return np.zeros(0)
    runs = Runs.of(np.pad(mask, 1), diagonal=diagonal)
    # Every part has the number of one of its runs.
    areas = runs.areas()[np.unique(runs.parts)]
    return np.asarray(np.sort(areas)[::-1], np.float64)


def _ranges(starts: _Indices, lengths: _Indices) -> _Indices:
    """Return the whole numbers from each start on, so many each, one after the other."""
    before = np.cumsum(lengths) - lengths
    return np.asarray(np.arange(int(lengths.sum())) + np.repeat(starts - before, lengths), np.intp)


def _joined(count: int, one: _Indices, other: _Indices) -> _Indices:
    """Return for each of ``count`` things the least one it is connected to, by any way over pairs."""
    least = np.arange(count)
    while True:
        a, b = least[one], least[other]
        apart = a != b
        if not apart.any():
            return least
        one, other, a, b = one[apart], other[apart], a[apart], b[apart]
        np.minimum.at(least, np.maximum(a, b), np.minimum(a, b))
        while not np.array_equal(nearer := least[least], least):
            least = nearer
