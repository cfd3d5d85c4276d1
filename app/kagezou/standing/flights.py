"""When a figure is in the air."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from kagezou.standing.motion import SLOW, UNKNOWN, Flags, Floats, Motion, usual_exposure

_FAST = 0.03  # heights a frame: a jump of a twentieth of the height begins with 0.032, at 24 frames a second
_NEAR = 0.1  # of the height: feet that would carry if they stayed
_STRIDE = 0.015  # of the height: less over the line of the contacts is a sole that rolls
_LONGEST_STRIDE = 5  # drawings
_HANG = 12  # times the usual exposure: the longest that a figure is still in the air


@dataclass(frozen=True, slots=True)
class _Course:
    """Steps from `first` to before `last` in which all low feet rise, or all fall."""

    first: int
    last: int
    rises: bool


def airborne(motion: Motion, slide: Floats) -> Flags:
    """Return (N,) whether the figure is in the air, by how fast each foot slides (`slide_of`)."""
    air: Flags = (_jumps(motion) | _strides(motion, slide)) & motion.shown
    return air


def _strides(motion: Motion, slide: Floats) -> Flags:
    """Return (N,) whether the figure is between two contacts of a run.

    There one foot rises while the other falls, none stays on the ground, and the lower of them is over the line
    between the contacts before and after.
    """
    low = motion.above(motion.lowest) <= _NEAR
    leaps: Flags = motion.shown & np.all(~low | (slide > SLOW) & (slide < UNKNOWN), axis=1)
    result = np.zeros_like(leaps)
    rows = _lowest_rows(motion)
    ends = np.flatnonzero(np.diff(leaps, prepend=False, append=False))
    for first, last in zip(ends[::2].tolist(), ends[1::2].tolist(), strict=True):
        sides = [first - 1, last]
        if first == 0 or last == leaps.size or not motion.shown[sides].all() or last - first > _LONGEST_STRIDE:
            continue
        within = slice(first, last)
        line = np.interp(motion.frames[within], motion.frames[sides], rows[sides])
        result[within] = line - rows[within] >= _STRIDE * motion.height[within]
    return result


def _jumps(motion: Motion) -> Flags:
    """Return (N,) whether the figure is in a jump.

    It is from where all its low feet rise, fast somewhere, until they come to the end of a fast fall. What rises and
    then stays has jumped on something; what falls without having risen has jumped down. Ground that wanders does so
    slowly.
    """
    air = np.zeros(motion.frames.size, np.bool_)
    up: _Course | None = None
    for course in _courses(_common_rise(motion)):
        if course.rises:
            air[course.first + 1 : course.last] = True
            up = course
            continue
        begin = course.first + 1
        if up is None and _is_short(motion, 0, course.first):
            begin = 0
        elif up is not None and _is_short(motion, up.last, course.first):
            begin = up.first + 1
        air[begin : course.last] = True
        up = None
    if up is not None and _is_short(motion, up.last, motion.frames.size - 1):
        air[up.last :] = True
    return air


def _common_rise(motion: Motion) -> Floats:
    """Return (N - 1,) how fast all low feet rise together, heights a frame, negative where they fall; 0 where not."""
    near = motion.above(motion.lowest) <= _NEAR
    low = motion.followed & near[1:] & near[:-1]
    rise = -motion.vy
    least = np.where(low, rise, np.inf).min(axis=1)
    most = np.where(low, rise, -np.inf).max(axis=1)
    common = np.where(least > 0, least, np.where(most < 0, most, 0.0))
    # Where no foot is known before and after, the lowest pixel of the figure has to do.
    both = motion.shown[1:] & motion.shown[:-1]
    rows = _lowest_rows(motion)
    return np.where(low.any(axis=1), common, np.where(both, -np.diff(rows) / motion.unit_px, 0.0))


def _lowest_rows(motion: Motion) -> Floats:
    """Return (N,) the row of the lowest foot, canvas px."""
    rows: Floats = motion.y[np.arange(motion.frames.size), motion.lowest]
    return rows


def _courses(rise: Floats) -> list[_Course]:
    """Return the runs of steps that go one way, fast somewhere among them."""
    ways = np.where(rise >= SLOW, 1, np.where(rise <= -SLOW, -1, 0))
    borders = [0, *(np.flatnonzero(np.diff(ways)) + 1).tolist(), ways.size]
    return [
        _Course(first, last, bool(ways[first] > 0))
        for first, last in pairwise(borders)
        if last > first and np.abs(rise[first:last]).max() >= _FAST
    ]


def _is_short(motion: Motion, first: int, last: int) -> bool:
    """Return whether no more time passes from run ``first`` to run ``last`` than a figure hangs in the air."""
    return bool(motion.frames[last] - motion.frames[first] <= _HANG * usual_exposure(motion.frames))
