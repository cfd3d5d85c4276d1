"""Where values change from one square to the next."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def span_around(value: Array, reach: int) -> Array:
    """Return by how much values (H, W) differ within ``reach`` squares of each in both directions, none beyond the rim.

    The largest of a square of squares is the largest of its rows' largest, so that both are looked for in turn.
    """
    high = low = np.pad(value, reach, mode="edge")
    for axis, size in enumerate(value.shape):
        shifted = [slice(start, start + size) for start in range(2 * reach + 1)]
        places = [(slice(None),) * axis + (each,) for each in shifted]
        high = _over(np.maximum, high, places)
        low = _over(np.minimum, low, places)
    return np.asarray(high - low)


def _over(choose: np.ufunc, value: Array, places: list[tuple[slice, ...]]) -> Array:
    result = value[places[0]].copy()
    for place in places[1:]:
        choose(result, value[place], out=result)
    return result
