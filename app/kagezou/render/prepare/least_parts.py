"""Islands and holes of a shadow that are too small to be wanted: they would come and go from drawing to drawing."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Covered = NDArray[np.uint16]
_Indices = NDArray[np.intp]


@dataclass(frozen=True, slots=True, eq=False)
class _Runs:
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
    def of(cls, mask: NDArray[np.bool_], *, diagonal: bool) -> "_Runs":
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


def part_areas(mask: NDArray[np.bool_], *, diagonal: bool) -> NDArray[np.float64]:
    """Return how many pixels each connected part of a mask (H, W) has, the largest first.

    ``diagonal`` is whether pixels that touch at a corner are connected.
    """
    if not mask.any():
        return np.zeros(0)
    runs = _Runs.of(np.pad(mask, 1), diagonal=diagonal)
    # Every part has the number of one of its runs.
    areas = runs.areas()[np.unique(runs.parts)]
    return np.asarray(np.sort(areas)[::-1], np.float64)


def without_least_parts(covered: Covered, least_px2: float) -> Covered:
    """Return a shadow without islands and holes smaller than an area; the array itself where there are none.

    A pixel is in the shadow from half of the largest covered part on. The anti-aliased or soft rim goes with its
    island. What touches the outermost pixels stays: it may go on beyond them.

    Parameters
    ----------
    covered
        Covered parts (H, W).
    least_px2
        The smallest area that stays, in pixels.
    """
    top = int(covered.max(initial=0))
    if top == 0 or least_px2 <= 0:
        return covered
    level = (top + 1) // 2
    filled = _without_holes(np.pad(covered, 1), level, least_px2)
    kept = _without_islands(filled, level, least_px2)[1:-1, 1:-1]
    return covered if np.array_equal(kept, covered) else np.ascontiguousarray(kept)


def _without_holes(padded: Covered, level: int, least: float) -> Covered:
    outside = padded < level
    runs = _Runs.of(outside, diagonal=False)
    # What is connected to the padding, where the first run is, is no hole.
    pixels, parts = runs.pixels((runs.areas() < least) & (runs.parts != runs.parts[0]))
    if not len(pixels):
        return padded
    upside_down = (np.iinfo(np.uint16).max - padded).ravel()
    reached, of = _downhill(upside_down, (pixels, parts), ~outside.ravel(), padded.shape[1])
    # As full as it is around the hole: what is translucent stays so.
    fullest = np.zeros(len(runs.parts), np.uint16)
    flat = padded.ravel()
    np.maximum.at(fullest, of, flat[reached])
    changed = flat.copy()
    changed[reached] = fullest[of]
    return changed.reshape(padded.shape)


def _without_islands(padded: Covered, level: int, least: float) -> Covered:
    inside = padded >= level
    runs = _Runs.of(inside, diagonal=True)
    pixels, parts = runs.pixels((runs.areas() < least) & ~_touches(runs, padded.shape))
    if not len(pixels):
        return padded
    flat = padded.ravel()
    stays = inside.ravel().copy()
    stays[pixels] = False
    free = (flat > 0) & ~inside.ravel()
    reached, _ = _downhill(flat, (pixels, parts), free, padded.shape[1])
    changed = flat.copy()
    # The rim of what stays is not taken away where it is the island's as well.
    beside = stays[reached[:, np.newaxis] + _around(padded.shape[1])].any(axis=1)
    changed[reached[~beside]] = 0
    return changed.reshape(padded.shape)


def _touches(runs: _Runs, shape: tuple[int, ...]) -> NDArray[np.bool_]:
    """Return which runs belong to a part with one of the outermost pixels within the padding (N,)."""
    height, width = shape
    row, left = np.divmod(runs.starts, width)
    right = runs.ends - row * width
    outermost = (row <= 1) | (row >= height - 2) | (left <= 1) | (right >= width - 1)
    return np.asarray(np.isin(runs.parts, runs.parts[outermost]))


def _downhill(
    values: Covered, begin: tuple[_Indices, _Indices], free: NDArray[np.bool_], width: int
) -> tuple[_Indices, _Indices]:
    """Return pixels and all free ones from which the way up leads to them, with the part that each belongs to."""
    around = _around(width)
    free = free.copy()
    pixels, parts = begin
    reached, belongs = [pixels], [parts]
    while len(pixels):
        near = pixels[:, np.newaxis] + around
        lower = free[near] & (values[near] < values[pixels][:, np.newaxis])
        pixels, first = np.unique(near[lower], return_index=True)
        parts = np.broadcast_to(parts[:, np.newaxis], near.shape)[lower][first]
        free[pixels] = False
        reached.append(pixels)
        belongs.append(parts)
    return np.concatenate(reached), np.concatenate(belongs)


def _around(width: int) -> _Indices:
    """Return the steps to the eight pixels around one in the flat picture."""
    return np.array([-width - 1, -width, -width + 1, -1, 1, width - 1, width, width + 1])


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
