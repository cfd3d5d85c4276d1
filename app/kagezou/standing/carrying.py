"""Which feet carry: the lowest, unless it slides while another stays, and a second that stays as it does."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kagezou.standing.motion import SLOW, Flags, Floats, Motion

_BEHIND = 0.06  # of the height: how much higher in the picture a foot can stand that is farther away
_LEVEL = 0.025  # of the height: two feet of a figure that rests
_MARGIN = 1.5  # what a decision must stand to be no close one
_FLAT = 0.01  # of the height: two feet where nothing is known of what comes
_PAIR = 0.04  # of the height: two feet that move alike


@dataclass(frozen=True, eq=False, slots=True)
class Carrying:
    """What was decided for N runs of frames and K tracks.

    Attributes
    ----------
    planted
        (N, K) whether a foot carries, as far as the figure is not in the air.
    is_narrow
        (N,) whether it was a close decision: the lowest foot slides, or a second
        one stays almost as it does.
    """

    planted: Flags
    is_narrow: Flags


def carrying(motion: Motion, slide: Floats) -> Carrying:
    """Return which feet carry, by how fast each slides (`slide_of`)."""
    lowest = motion.lowest_of(motion.may_carry)
    above = np.where(motion.may_carry, motion.above(lowest), np.inf)
    rows = np.arange(lowest.size)
    own = slide[rows, lowest][:, None]
    stays = (above <= _BEHIND) & (slide <= SLOW) & (own > SLOW)
    instead: Flags = np.any(stays, axis=1)
    chosen = np.where(instead, np.where(stays, above, np.inf).argmin(axis=1), lowest)
    carries: Flags = motion.may_carry & (motion.above(motion.lowest) <= _BEHIND)
    alone: Flags = np.arange(motion.seen.shape[1]) == chosen[:, None]
    planted, strict, lax = (
        (alone | _second(motion, chosen, slide, slow)) & carries for slow in (SLOW, SLOW / _MARGIN, SLOW * _MARGIN)
    )
    return Carrying(planted, instead | np.any(strict != lax, axis=1))


def _second(motion: Motion, chosen: NDArray[np.intp], slide: Floats, slow: float) -> Flags:
    """Return (N, K) the feet that are about level with the ``chosen`` ones and stay as they do.

    One that has just come down and one that is just about to leave move alike in no step, but each with the ground in
    one of them. Where the figure rests, what it did before and does later tells nothing.
    """
    level = np.abs(motion.above(chosen))
    stays = slide <= slow
    stays[:-1] |= _alike(motion, chosen[:-1], slow)
    stays[1:] |= _alike(motion, chosen[1:], slow)
    rest = np.where(motion.is_held, _LEVEL, 0.0)
    rest[-1] = _FLAT if rest.size > 1 else _LEVEL
    second: Flags = (level <= _PAIR) & stays | (level <= rest[:, None])
    return second


def _alike(motion: Motion, column: NDArray[np.intp], slow: float) -> Flags:
    """Return (N - 1, K) the feet that move in each step as that of ``column`` (N - 1,) does."""
    steps = np.arange(column.size)
    vx, vy = (each - each[steps, column][:, None] for each in (motion.vx, motion.vy))
    alike: Flags = motion.followed & motion.followed[steps, column][:, None] & (np.hypot(vx, vy) <= slow)
    return alike
