"""Which feet carry: the lowest, unless it slides while another stays, and a second that stays as it does."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kagezou.standing.motion import SLOW, Flags, Motion, slide_of

_BEHIND = 0.06  # of the height: how much higher in the picture a foot can stand that is farther away
_LEVEL = 0.025  # of the height: two feet of a figure that rests
_PAIR = 0.04  # of the height: two feet that move alike


@dataclass(frozen=True, eq=False, slots=True)
class Carrying:
    """What was decided for N runs of frames and K tracks.

    Attributes
    ----------
    planted
        (N, K) whether a foot carries, as far as the figure is not in the air.
    is_narrow
        (N,) whether it was a close decision: the lowest foot slides.
    """

    planted: Flags
    is_narrow: Flags


def carrying(motion: Motion) -> Carrying:
    """Return which feet carry."""
    lowest = motion.lowest
    above = motion.above(lowest)
    slide = slide_of(motion)
    rows = np.arange(lowest.size)
    own = slide[rows, lowest][:, None]
    stays = (above <= _BEHIND) & (slide <= SLOW) & (own > SLOW)
    instead: Flags = np.any(stays, axis=1)
    chosen = np.where(instead, np.where(stays, above, np.inf).argmin(axis=1), lowest)
    planted: Flags = motion.seen & (np.arange(motion.seen.shape[1]) == chosen[:, None])
    planted |= _second(motion, chosen)
    return Carrying(planted, instead)


def _second(motion: Motion, chosen: NDArray[np.intp]) -> Flags:
    """Return (N, K) the feet that stay as the ``chosen`` ones do."""
    level = np.abs(motion.above(chosen))
    steps = np.arange(chosen.size - 1)
    none = np.zeros((1, motion.seen.shape[1]), np.bool_)
    alike = [
        motion.followed
        & motion.followed[steps, at][:, None]
        & (np.hypot(motion.vx - motion.vx[steps, at][:, None], motion.vy - motion.vy[steps, at][:, None]) <= SLOW)
        for at in (chosen[:-1], chosen[1:])
    ]
    together = np.concatenate((alike[0], none)) | np.concatenate((none, alike[1]))
    second: Flags = (level <= _PAIR) & together | (level <= _LEVEL) & motion.rests[:, None]
    return second
