"""Where a matte is empty, full or neither, asked for many boxes at once: most of a shadow needs no sampling at all."""

import numpy as np
from numpy.typing import NDArray

from kagezou.io.images import Steps

BLOCK_TEXELS = 4

Flags = NDArray[np.bool_]


class Occupancy:
    """Sums over blocks of texels, so that the state of any box is four look-ups (summed-area tables).

    Parameters
    ----------
    alpha
        (H, W), the texels of the matte.
    reach_texels
        How far beyond a texel its alpha may have been carried by smoothing.
    """

    def __init__(self, alpha: Steps, reach_texels: int) -> None:
        height, width = alpha.shape
        rows, columns = -(-height // BLOCK_TEXELS), -(-width // BLOCK_TEXELS)
        blocks = np.zeros((rows * BLOCK_TEXELS, columns * BLOCK_TEXELS), dtype=alpha.dtype)
        blocks[:height, :width] = alpha
        # A block's row of texels is one number, so that four texels are asked about at once.
        word = np.dtype(f"u{BLOCK_TEXELS * alpha.dtype.itemsize}")
        words = blocks.view(word).reshape(rows, BLOCK_TEXELS, columns)
        self._some = summed((words != 0).any(axis=1))
        self._gaps = summed((words != np.iinfo(word).max).any(axis=1))
        self._reach = reach_texels + 1

    def states(self, low: NDArray[np.float64], high: NDArray[np.float64]) -> tuple[Flags, Flags]:
        """Return for boxes (N, 2) to (N, 2), texels (x, y), whether each is certainly empty, and certainly full.

        Bilinear sampling and smoothing are allowed for. A box that leaves the matte is not full.
        """
        rows, columns = self._some.shape[0] - 1, self._some.shape[1] - 1
        limit = np.array([columns, rows])
        first = np.floor((low - self._reach) / BLOCK_TEXELS)
        last = np.floor((high + self._reach) / BLOCK_TEXELS) + 1
        leaves = ((first < 0) | (last > limit)).any(axis=1)
        start = np.clip(first, 0, limit).astype(np.intp)
        stop = np.maximum(np.clip(last, 0, limit).astype(np.intp), start)
        empty = count_in(self._some, start, stop) == 0
        full = ~leaves & (count_in(self._gaps, start, stop) == 0)
        return empty, full


def summed(flags: Flags) -> NDArray[np.int64]:
    """Return the summed-area table (H + 1, W + 1) of flags (H, W): the count in any box is then four look-ups."""
    table = np.zeros((flags.shape[0] + 1, flags.shape[1] + 1), dtype=np.int64)
    np.cumsum(np.cumsum(flags, axis=0), axis=1, out=table[1:, 1:])
    return table


def count_in(table: NDArray[np.int64], start: NDArray[np.intp], stop: NDArray[np.intp]) -> NDArray[np.int64]:
    """Return how many flags are set in each of the boxes ``start`` to ``stop``, (N, 2) as x, y, half-open."""
    (x0, y0), (x1, y1) = start.T, stop.T
    return np.asarray(table[y1, x1] - table[y0, x1] - table[y1, x0] + table[y0, x0])
