"""Where a matte is empty, full or neither, asked for many boxes at once: most of a shadow needs no sampling at all."""

import numpy as np
from numpy.typing import NDArray

from kagezou.io.images.reading import Steps

BLOCK_TEXELS = 4

Flags = NDArray[np.bool_]
Counts = NDArray[np.int32] | NDArray[np.int64]

_GAP_BITS = 32
"""Where in a table's number the blocks with gaps are counted, above those with any alpha."""


class Occupancy:
    """Sums over blocks of texels, so that the state of any box is four look-ups (a summed-area table).

    Parameters
    ----------
    alpha
        (H, W), the texels of the matte.
    reach_texels
        How far beyond a texel its alpha may have been carried by smoothing.
    """

    def __init__(self, alpha: Steps, reach_texels: int) -> None:
        blocks = _in_whole_blocks(alpha)
        rows, columns = (side // BLOCK_TEXELS for side in blocks.shape)
        # A block's row of texels is one number, so that four texels are asked about at once.
        word = np.dtype(f"u{BLOCK_TEXELS * alpha.dtype.itemsize}")
        words = blocks.view(word).reshape(rows, BLOCK_TEXELS, columns)
        has_some = np.bitwise_or.reduce(words, axis=1) != 0
        has_gaps = np.bitwise_and.reduce(words, axis=1) != np.iinfo(word).max
        self._table = summed(has_some + (has_gaps.astype(np.int64) << _GAP_BITS))
        self._reach = reach_texels + 1

    def states(self, low: NDArray[np.float64], high: NDArray[np.float64]) -> tuple[Flags, Flags]:
        """Return for boxes (2, N) to (2, N), texels x, y, whether each is certainly empty, and certainly full.

        Bilinear sampling and smoothing are allowed for. A box that leaves the matte is not full.
        """
        height, width = self._table.shape
        limit = np.array([[width - 1.0], [height - 1.0]])
        first = np.floor((low - self._reach) / BLOCK_TEXELS)
        last = np.floor((high + self._reach) / BLOCK_TEXELS) + 1
        leaves = ((first < 0) | (last > limit)).any(axis=0)
        start = np.minimum(np.maximum(first, 0, out=first), limit, out=first)
        stop = np.maximum(np.minimum(last, limit, out=last), start, out=last)
        found = count_in(self._table, start.astype(np.intp), stop.astype(np.intp))
        is_empty = found & ((1 << _GAP_BITS) - 1) == 0
        return is_empty, ~leaves & (found < 1 << _GAP_BITS)


def _in_whole_blocks(alpha: Steps) -> Steps:
    """Return the texels, C-contiguous, with empty ones after them where the last blocks are not filled."""
    height, width = alpha.shape
    if height % BLOCK_TEXELS == width % BLOCK_TEXELS == 0:
        return alpha if alpha.flags.c_contiguous else alpha.copy()
    blocks: Steps = np.zeros((height + -height % BLOCK_TEXELS, width + -width % BLOCK_TEXELS), alpha.dtype)
    blocks[:height, :width] = alpha
    return blocks


def summed(numbers: Flags | NDArray[np.int64]) -> Counts:
    """Return the summed-area table (H + 1, W + 1) of numbers (H, W): the sum in any box is then four look-ups.

    Flags are counted in half the memory, and so in half the time.
    """
    shape = (numbers.shape[0] + 1, numbers.shape[1] + 1)
    table: Counts = np.zeros(shape, np.int32) if numbers.dtype == np.bool_ else np.zeros(shape, np.int64)
    np.cumsum(np.cumsum(numbers, axis=0, dtype=table.dtype), axis=1, out=table[1:, 1:])
    return table


def count_in(table: Counts, start: NDArray[np.intp], stop: NDArray[np.intp]) -> Counts:
    """Return the sum in each of the boxes ``start`` to ``stop``, (2, N) as x, y, half-open."""
    numbers, width = table.ravel(), table.shape[1]
    (x0, y0), (x1, y1) = start, stop
    top, bottom = y0 * width, y1 * width
    return np.asarray(numbers[bottom + x1] - numbers[top + x1] - numbers[bottom + x0] + numbers[top + x0])
