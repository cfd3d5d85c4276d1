"""Where the lower edge of a figure comes down: the places at which it may touch the ground."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.vectors import Point2
from kagezou.standing.outline import Outline

_PROMINENCE = 0.03  # of the height: less is a crease of a sole or the unevenness of a line
_SOLE = 0.008  # of the height: what lies no higher over the lowest pixel touches the ground with it
_LEAST_WIDTH_PX = 2
_APART = 0.08  # of the height: heel and toe of one foot lie closer


@dataclass(frozen=True, slots=True)
class Minimum:
    """A place where the lower edge comes down.

    Attributes
    ----------
    place
        The middle of the sole, and the row below its lowest pixel; drawing px.
    width_px
        How wide the sole is.
    is_step
        Whether something lower hides the rest of it (`steps`): the edge rises on one side only.
    """

    place: Point2
    width_px: int
    is_step: bool = False


def minima_of(outline: Outline) -> tuple[Minimum, ...]:
    """Return the minima of the lower edge, from left to right.

    Each stands out by 3 % of the figure's height on both sides, is at least 2 px wide, and lies 8 % of the height
    apart from its neighbours; of closer ones the lower stays. There is always one, as thin as the figure may be.
    """
    height = outline.height_px
    found = [_sole(outline, column) for column in _turns(outline.lower, max(1.0, _PROMINENCE * height))]
    wide = [minimum for minimum in found if minimum.width_px >= _LEAST_WIDTH_PX]
    kept: list[Minimum] = []
    for minimum in sorted(wide or found, key=lambda each: (-each.place[1], each.place[0])):
        if all(abs(minimum.place[0] - other.place[0]) >= _APART * height for other in kept):
            kept.append(minimum)
    return tuple(sorted(kept, key=lambda each: each.place))


def _turns(lower: NDArray[np.int32], prominence_px: float) -> list[int]:
    """Return the columns in which the edge is lowest between two ways up of at least ``prominence_px``."""
    # Only where the edge changes its row can it turn: a Python loop over some tens of places instead of all columns.
    steps = np.flatnonzero(np.diff(lower)) + 1
    columns = np.concatenate(([0], steps))
    turns: list[int] = []
    lowest, lowest_at, highest, falling = -1.0, -1, float("-inf"), True
    for column, row in zip(columns.tolist(), lower[columns].tolist(), strict=True):
        if falling:
            if row > lowest:
                lowest, lowest_at = row, column
            elif lowest - row >= prominence_px:
                turns.append(lowest_at)
                highest, falling = row, False
        else:
            highest = min(highest, row)
            if row - highest >= prominence_px:
                lowest, lowest_at, falling = row, column, True
    return [*turns, lowest_at] if falling else turns


def _sole(outline: Outline, column: int) -> Minimum:
    """Return the sole around the lowest ``column`` of the box: neighbours that are as low within a small part."""
    row = int(outline.lower[column])
    high = np.flatnonzero(outline.lower < row - max(1.0, _SOLE * outline.height_px))
    after = int(np.searchsorted(high, column))
    left = int(high[after - 1]) + 1 if after else 0
    right = int(high[after]) if after < high.size else outline.lower.size
    return Minimum((outline.box.left + (left + right) / 2, float(row)), right - left)
