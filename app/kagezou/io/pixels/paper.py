"""The paper of a drawing without alpha: which of its white lies outside of the figure."""

import numpy as np
from numpy.typing import NDArray

from kagezou.io.pixels.connected import Runs

Mask = NDArray[np.bool_]


def reaching_border(white: Mask) -> Mask:
    """Return the part of a mask (H, W) that is connected with the border of the picture, (H, W).

    Pixels are neighbours by their sides, so that a line of one pixel that goes aslant holds.
    """
    padded = np.pad(white, 1)
    runs = Runs.of(padded, diagonal=False)
    return runs.mask(runs.reach_border(padded.shape), padded.shape)[1:-1, 1:-1]
