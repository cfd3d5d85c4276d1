"""Pictures of one shadow, each half as fine as the one before, laid out in one target."""

from dataclasses import dataclass
from math import ceil, floor

import numpy as np

from kagezou.geometry.bands import Extent
from kagezou.geometry.box import Box
from kagezou.geometry.vectors import Matrix

CELL_VARIANCE = 1 / 12
"""The variance of a mean over one texel, texels squared."""

_HALVING_VARIANCE = 3 / 16
"""What weights of 1, 3, 3, 1 add to it, in texels twice as large squared."""

_MARGIN = 2


@dataclass(frozen=True, slots=True)
class ShadowLevels:
    """A shadow on its receiver in several finenesses: the finest lies uppermost, the others beside each other below it.

    Parameters
    ----------
    finest, coarsest
        Levels: texels are 2^level px wide.
    corner
        Where the finest begins, in its own texels from u = v = 0; a whole number of texels of the coarsest.
    width, height
        Texels of the finest; whole numbers of texels of the coarsest.
    """

    finest: int
    coarsest: int
    corner: tuple[int, int]
    width: int
    height: int

    @staticmethod
    def of(extent: Extent, finest: int, coarsest: int) -> "ShadowLevels":
        """Return the levels of an extent, px of the receiver, with a margin that holds nothing."""
        side, texel = 1 << (coarsest - finest), 2.0**coarsest
        left, low = (floor(each / texel) - _MARGIN for each in (extent.left, extent.low))
        right, high = (ceil(each / texel) + _MARGIN for each in (extent.right, extent.high))
        return ShadowLevels(finest, coarsest, (left * side, low * side), (right - left) * side, (high - low) * side)

    @property
    def box(self) -> Box:
        """All that they take up of a target."""
        return Box(0, 0, self.width, max(self.box_of(each).bottom for each in range(self.finest, self.coarsest + 1)))

    def box_of(self, level: int) -> Box:
        """Return where a level lies in the target."""
        steps = level - self.finest
        width, height = self.width >> steps, self.height >> steps
        left = sum(self.width >> each for each in range(1, steps))
        top = self.height if steps else 0
        return Box(left, top, left + width, top + height)

    def corner_of(self, level: int) -> tuple[int, int]:
        """Return where a level begins, in its own texels from u = v = 0."""
        steps = level - self.finest
        return (self.corner[0] >> steps, self.corner[1] >> steps)

    @property
    def plane_from_target(self) -> Matrix:
        """The (3, 3) map from px of the target to (u, v), for the finest."""
        texel = 2.0**self.finest
        return np.array([[texel, 0.0, self.corner[0] * texel], [0.0, texel, self.corner[1] * texel], [0.0, 0.0, 1.0]])


def halved(held: Box) -> Box:
    """Return which texels of the next level may hold something, by those that do; both counted from their corners."""
    return Box(-(-(held.left - 2) // 2), -(-(held.top - 2) // 2), held.right // 2 + 1, held.bottom // 2 + 1)


def variance_of(steps: int) -> float:
    """Return the variance of what a texel stands for, texels squared, after halving so often."""
    variance = CELL_VARIANCE
    for _ in range(steps):
        variance = variance / 4 + _HALVING_VARIANCE
    return variance
