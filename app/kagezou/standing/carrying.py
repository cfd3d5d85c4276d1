"""Which feet carry: the lowest, unless it slides while another stays, and a second that stays as it does."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kagezou.standing.motion import SLOW, Flags, Floats, Motion

_BEHIND = 0.06  # of the height: how much higher in the picture a foot can stand that is farther away
_LEVEL = 0.025  # of the height: two feet of a figure that rests
_MARGIN = 1.5  # what a decision must stand to be no close one
_FLAT = 0.01  # of the height: two feet where nothing is known of what comes
_FARTHER = 0.1  # of the height: how much higher a foot can stand that rests for long with the lowest
_REST = 24  # frames of the cinema: longer than a leg is held in the air
_STILL = 0.002  # heights a frame: two feet that rest
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
        (alone | _second(motion, chosen, slide, SLOW * lax)) & carries | _rests(motion, chosen, _REST / lax)
        for lax in (1, 1 / _MARGIN, _MARGIN)
    )
    return Carrying(planted, instead | np.any(strict != lax, axis=1) | _is_one(motion, above))


def _rests(motion: Motion, chosen: NDArray[np.intp], rest: float) -> Flags:
    """Return (N, K) the feet that are still together with the ``chosen`` ones for ``rest`` frames of the cinema.

    The ground recedes: of a figure that stands the far foot is higher in the picture. A leg that is lifted is not held
    so still for so long.
    """
    runs = np.arange(chosen.size)
    times = np.concatenate(([0.0], np.cumsum(motion.lengths)))
    still = motion.followed & (np.hypot(motion.vx, motion.vy) <= _STILL)
    still &= still[runs[:-1], chosen[:-1]][:, None]
    result = np.zeros_like(motion.seen)
    for column in range(still.shape[1]):
        ends = np.flatnonzero(np.diff(still[:, column], prepend=False, append=False))
        for first, last in zip(ends[::2].tolist(), ends[1::2].tolist(), strict=True):
            result[first : last + 1, column] = times[last] - times[first] >= rest
    rests: Flags = result & motion.may_carry & (motion.above(chosen) <= _FARTHER)
    return rests


def _is_one(motion: Motion, above: Floats) -> Flags:
    """Return (N,) whether one drawing is all that is known, and another foot in it may be lifted or farther away."""
    higher: Flags = np.any((above > _LEVEL) & (above <= _FARTHER), axis=1)
    return higher & (motion.frames.size == 1)


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
