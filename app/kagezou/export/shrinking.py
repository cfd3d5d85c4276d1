"""Pictures made small for sheets of many: each pixel is the mean of those that it stands for."""

import numpy as np
from numpy.typing import NDArray

from kagezou.io.images.reading import Steps

_Numbers = NDArray[np.float64]


def shrunk(picture: Steps, most_px: int) -> NDArray[np.uint8]:
    """Return a picture, (H, W, C) 8 bit, with no side over ``most_px``; a smaller one stays as large as it is."""
    longest = max(picture.shape[:2])
    height, width = (max(round(side * min(most_px / longest, 1.0)), 1) for side in picture.shape[:2])
    lower = _means(picture, height)
    means = _means(lower.swapaxes(0, 1), width).swapaxes(0, 1)
    return np.ascontiguousarray(np.rint(means), np.uint8)


def _means(lines: NDArray[np.uint8 | np.uint16 | np.float64], count: int) -> _Numbers:
    """Return the means over ``count`` equal parts of the first axis, which may cut lines."""
    edges = np.linspace(0, len(lines), count + 1)
    whole = np.minimum(edges.astype(np.intp), len(lines) - 1)
    summed = np.zeros((len(lines) + 1, *lines.shape[1:]))
    np.cumsum(lines, axis=0, out=summed[1:])
    rest = (edges - whole).reshape(-1, *[1] * (lines.ndim - 1))
    at_edges: _Numbers = summed[whole] + rest * lines[whole]
    return np.diff(at_edges, axis=0) * (count / len(lines))
