"""The paper of a drawing without alpha: which of its white lies outside of the figure."""

import numpy as np
from numpy.typing import NDArray

Mask = NDArray[np.bool_]
_Indices = NDArray[np.intp]


def reaching_border(white: Mask) -> Mask:
    """Return the part of a mask (H, W) that is connected with the border of the picture, (H, W).

    Pixels are neighbours by their sides, so that a line of one pixel that goes aslant holds. Runs within rows are
    joined with those that they touch in the next row until every connected part has one number; the border's is the
    least.
    """
    height, width = white.shape
    # Rows one after the other with a clear pixel before each, so that no run goes over from one to the next.
    pitch = width + 1
    line = np.zeros(height * pitch + 1, np.bool_)
    line[:-1].reshape(height, pitch)[:, 1:] = white
    turns = np.flatnonzero(line[1:] != line[:-1]) + 1
    starts, ends = turns[0::2], turns[1::2]
    upper, lower = _touching(starts, ends, pitch)
    last = (height - 1) * pitch
    outer = (starts < pitch) | (starts > last) | (starts % pitch == 1) | (ends % pitch == 0)
    (at_border,) = np.nonzero(outer)
    # Number 0 is what lies around the picture.
    numbers = _numbered(
        len(starts) + 1,
        np.concatenate([upper + 1, at_border + 1]),
        np.concatenate([lower + 1, np.zeros_like(at_border)]),
    )
    reached = numbers[1:] == 0
    change = np.zeros(line.size, np.int8)
    change[starts[reached]] += 1
    change[ends[reached]] -= 1
    filled = np.cumsum(change[:-1], dtype=np.int8).astype(np.bool_)
    return filled.reshape(height, pitch)[:, 1:]


def _touching(starts: _Indices, ends: _Indices, pitch: int) -> tuple[_Indices, _Indices]:
    """Return the pairs of runs of which the second lies right below the first, in a part of its columns."""
    first = np.searchsorted(ends, starts + pitch, "right")
    behind = np.searchsorted(starts, ends + pitch, "left")
    counts = np.maximum(behind - first, 0)
    upper = np.repeat(np.arange(len(starts)), counts)
    within = np.arange(len(upper)) - np.repeat(np.cumsum(counts) - counts, counts)
    return upper, within + np.repeat(first, counts)


def _numbered(count: int, one: _Indices, other: _Indices) -> _Indices:
    """Return for each of ``count`` nodes the least number that edges from ``one`` to ``other`` connect it with.

    Every node points at a lower one that it is connected with; pointers are shortened to twice their way and hooked to
    the lower one over every edge until nothing changes, which takes about as many rounds as the count has digits in
    base 2 (FastSV: Zhang, Azad, Hu 2020).
    """
    numbers = np.arange(count)
    while True:
        ahead = numbers[numbers]
        lower = ahead.copy()
        for start, end in ((one, other), (other, one)):
            np.minimum.at(lower, numbers[start], ahead[end])
            np.minimum.at(lower, start, ahead[end])
        if np.array_equal(lower, numbers):
            return numbers
        numbers = lower
