"""The unit disc as a matte, for round shadows."""

from functools import cache

import numpy as np

from kagezou.geometry.box import Box
from kagezou.io.images.reading import Matte
from kagezou.scene.disc import DISC_PX, DISC_RADIUS_PX


@cache
def disc_matte() -> Matte:
    """Return the unit disc, anti-aliased, in the middle of its picture; always the same one."""
    from_middle = np.arange(DISC_PX) + 0.5 - DISC_PX / 2
    distance = np.hypot(from_middle, from_middle[:, np.newaxis])
    alpha = np.round(255 * np.clip(DISC_RADIUS_PX + 0.5 - distance, 0, 1)).astype(np.uint8)
    inside = np.flatnonzero(alpha.any(axis=0))
    low, high = int(inside[0]), int(inside[-1]) + 1
    part = np.ascontiguousarray(alpha[low:high, low:high])
    part.flags.writeable = False
    return Matte(DISC_PX, DISC_PX, Box(low, low, high, high), part, hard_edged=False)
