"""Islands and holes of a shadow that are too small to be wanted: they would come and go from drawing to drawing."""

import numpy as np
from numpy.typing import NDArray

from kagezou.io.pixels.connected import Runs

Covered = NDArray[np.uint16]
_Indices = NDArray[np.intp]


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
    runs = Runs.of(outside, diagonal=False)
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
    runs = Runs.of(inside, diagonal=True)
    pixels, parts = runs.pixels((runs.areas() < least) & ~runs.reach_border(padded.shape))
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
