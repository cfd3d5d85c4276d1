"""What a pass needs of a drawing whose texels do not fall on pixels."""

from math import ceil
from typing import Final

import numpy as np

from kagezou.geometry.vectors import Matrix
from kagezou.render.prepare.uniforms import Uniform

MOVED: Final = frozenset({"MOVED"})
"""The switch of a picture in colour; of one channel both of the next."""

MOVED_ALPHA: Final = frozenset({"MOVED", "ONE_CHANNEL"})
_MOST_CELLS: Final = 8


def moved_uniforms(target_from_texel: Matrix) -> dict[str, Uniform]:
    """Return what the switch MOVED wants: where a pixel finds its texels, and into how many cells it is split.

    Parameters
    ----------
    target_from_texel
        Affine (3, 3), px of the target from texels, centres of both at +0.5.
    """
    texel_from_pixel: Matrix = np.asarray(np.linalg.inv(target_from_texel), np.float64)
    texels_a_px = float(np.linalg.norm(texel_from_pixel[:2, :2], axis=0).max())
    return {"u_texel_from_pixel": texel_from_pixel, "u_cells": min(max(ceil(texels_a_px - 1e-6), 1), _MOST_CELLS)}


def moved_by(left: float, top: float) -> Matrix:
    """Return the affine map (3, 3) that moves by (left, top)."""
    return np.array([[1.0, 0.0, left], [0.0, 1.0, top], [0.0, 0.0, 1.0]])
