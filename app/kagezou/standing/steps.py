"""Steps of the lower edge: soles of feet that are half hidden by what stands in front of them."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kagezou.standing.minima import Minimum
from kagezou.standing.outline import Outline

_LEVEL = 0.008  # of the height: a sole is level, a calf slopes
_SLOPE = 0.2  # rows a column: 11 degrees; a foot that hangs, a shin or a tail is steeper
_LEAST_WIDTH = 0.03  # of the height: less is a fold or a heel
_MOST_WIDTH = 0.2  # of the height: no foot is so long, but a hem is
_FALL = 0.02  # of the height: so much lower is what hides the rest of the foot
_AT_ONCE = 0.01  # of the height: within that width the edge falls, as that of a boot or a leg does
_RISE = 0.03  # of the height: by so much the edge rises at the free end, where the figure does not end there
_THIN = 0.12  # of the height: a foot is no thicker
_LOOKS_OUT = 0.25  # of the sole: what has no leg above it
_LEG = 0.09  # of the height: wider than a leg; above a hem is the body
_FARTHEST = 0.1  # of the height: no foot on the same ground stands so much higher in the picture
_HEM = 0.02  # of the height: so level are the parts of one hem that are seen beside a leg


def steps_of(outline: Outline) -> tuple[Minimum, ...]:
    """Return the soles that look out beside something lower, from left to right.

    Each is nearly level, 3 to 20 % of the figure's height wide and no more than 10 % over the lowest pixel. One end is
    free, at the other the edge falls straight down. What is over it is no wider than a leg, or over part of it there is
    nothing but a foot. Two that look out level on both sides of what is lower are one hem and no feet.
    """
    height, lower = outline.height_px, outline.lower
    lefts = _shelves(lower, height)
    rights = [
        _Shelf(lower.size - each.end, lower.size - each.start, each.row) for each in _shelves(lower[::-1], height)
    ]
    level = _HEM * height
    hems = {each for a in lefts for b in rights if a.end <= b.start and abs(a.row - b.row) <= level for each in (a, b)}
    return tuple(
        Minimum((outline.box.left + (each.start + each.end) / 2, float(each.row)), each.width, is_step=True)
        for each in sorted({*lefts, *rights} - hems)
        if _is_of_foot(outline, each)
    )


class _Shelf(NamedTuple):
    """Columns of the box from `start` to before `end` that are nearly level, and their lowest row."""

    start: int
    end: int
    row: int

    @property
    def width(self) -> int:
        return self.end - self.start


def _is_of_foot(outline: Outline, shelf: _Shelf) -> bool:
    """Return whether a shelf is as wide, as low and as thin as a foot that looks out."""
    height = outline.height_px
    thin = np.mean(outline.thickness[shelf.start : shelf.end] <= _THIN * height)
    return (
        _LEAST_WIDTH * height <= shelf.width <= _MOST_WIDTH * height
        and outline.box.bottom - shelf.row <= _FARTHEST * height
        and (shelf.width <= _LEG * height or bool(thin >= _LOOKS_OUT))
    )


def _shelves(lower: NDArray[np.int32], height: float) -> list[_Shelf]:
    """Return what is level and ends on the right in an edge straight down, on the left in a free end."""
    width = max(1, round(_AT_ONCE * height))
    falls = lower[width:] - lower[:-width] >= max(1.0, _FALL * height)
    columns = np.flatnonzero(falls & ~np.concatenate(([False], falls[:-1])))
    found = (_shelf(lower, column, height) for column in columns.tolist())
    return [
        each
        for each in found
        if _slope(lower[each.start : each.end]) <= _SLOPE and _is_free(lower[: each.start][::-1], each.row, height)
    ]


def _slope(rows: NDArray[np.int32]) -> float:
    """Return by how many rows a column the two ends of ``rows`` differ; infinite where there are hardly any."""
    third = rows.size // 3
    return abs(float(rows[-third:].mean() - rows[:third].mean())) / (rows.size - third) if third else float("inf")


def _shelf(lower: NDArray[np.int32], column: int, height: float) -> _Shelf:
    """Return the columns around ``column`` that are about as low."""
    uneven = np.flatnonzero(np.abs(lower - lower[column]) > max(1.0, _LEVEL * height))
    after = int(np.searchsorted(uneven, column))
    start = int(uneven[after - 1]) + 1 if after else 0
    end = int(uneven[after]) if after < uneven.size else lower.size
    return _Shelf(start, end, int(lower[start:end].max()))


def _is_free(beside: NDArray[np.int32], row: int, height: float) -> bool:
    """Return whether the edge ``beside`` a sole, from it outwards, rises before it comes down to the sole again."""
    risen = np.flatnonzero(beside <= row - _RISE * height)
    sunk = np.flatnonzero(beside > row + _LEVEL * height)
    return not sunk.size or bool(risen.size and risen[0] < sunk[0])
