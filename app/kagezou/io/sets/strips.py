"""Strips and fans of triangles."""

import numpy as np
from numpy.typing import NDArray

from kagezou.io.sets.triangles import Indices


def of_strip(corners: Indices) -> NDArray[np.int64]:
    """Return a strip (N,), in which every corner makes a triangle with the two before, as triangles (N - 2, 3)."""
    along = np.asarray(corners, np.int64)
    if len(along) < 3:
        return np.zeros((0, 3), np.int64)
    made = np.stack([along[:-2], along[1:-1], along[2:]], axis=1)
    # Every second one runs the other way round.
    made[1::2] = made[1::2, [1, 0, 2]]
    return made


def of_fan(corners: Indices) -> NDArray[np.int64]:
    """Return a fan (N,) around its first corner as triangles (N - 2, 3)."""
    along = np.asarray(corners, np.int64)
    if len(along) < 3:
        return np.zeros((0, 3), np.int64)
    return np.stack([np.broadcast_to(along[:1], len(along) - 2), along[1:-1], along[2:]], axis=1)
