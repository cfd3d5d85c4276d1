"""How a figure stands over time: which foot carries, the ground below each, and how high it is."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from kagezou.standing.carrying import carrying
from kagezou.standing.flights import airborne
from kagezou.standing.foot import Verdict
from kagezou.standing.key_runs import key_runs
from kagezou.standing.motion import Flags, Floats, Motion, motion_of, slide_of
from kagezou.standing.seen import Seen, Stance, Standing

_LEVEL = 0.01  # of the height: a contact is level, but for ground that wanders
_LOW = 0.02  # of the height: over the ground by less than that may be a sole that rolls


def stances(sequence: Sequence[Seen], fps: float = 24.0) -> tuple[Stance, ...]:
    """Return how the figure stands in each run of frames.

    A planted foot has the ground at its own row. Below a lifted one it is interpolated in time between the contact that
    the foot left and the one that it comes to; before the first and after the last it is the nearest. A foot without
    any contact has the ground of those that carry. What a person said wins.

    Parameters
    ----------
    sequence
        In the order of frames.
    fps
        Frames a second: how fast a foot may move while it carries, and must to jump, is a matter of seconds.
    """
    if not sequence:
        return ()
    keys, key_of = key_runs(sequence)
    decided = _decided([sequence[key] for key in keys], fps)
    motion = motion_of(sequence, fps)
    planted = decided.planted[key_of]
    ground = _ground(motion, planted, _rows_said(motion, planted, sequence))
    over = np.where(motion.seen, ground - motion.y, np.inf).min(axis=1)
    lift = np.where(planted.any(axis=1) | ~motion.shown, 0.0, np.maximum(0.0, over))
    is_low = (lift > 0) & (lift < _LOW * motion.height) & ~_said(sequence)
    doubt = decided.doubt[key_of] | is_low
    return tuple(
        Stance(_standings(motion, planted, ground, row), float(lift[row]), bool(doubt[row]))
        for row in range(len(sequence))
    )


@dataclass(frozen=True, eq=False, slots=True)
class _Decided:
    """For N runs of frames and K tracks what carries, (N, K), and where it was close, (N,)."""

    planted: Flags
    doubt: Flags


def _decided(sequence: Sequence[Seen], fps: float) -> _Decided:
    motion = motion_of(sequence, fps)
    slide = slide_of(motion)
    found = carrying(motion, slide)
    air = airborne(motion, slide)
    planted = _with_verdicts(found.planted & ~air[:, None], motion, sequence)
    return _Decided(planted, (found.is_narrow & ~air | _uneven(motion, planted)) & ~_said(sequence))


def _with_verdicts(planted: Flags, motion: Motion, sequence: Sequence[Seen]) -> Flags:
    """Return ``planted`` with what a person said."""
    result = planted.copy()
    for row, seen in enumerate(sequence):
        for foot in seen.feet:
            if foot.verdict is not None:
                result[row, motion.tracks.index(foot.track)] = foot.verdict is Verdict.PLANTED
    return result & motion.seen


def _rows_said(motion: Motion, planted: Flags, sequence: Sequence[Seen]) -> Floats:
    """Return (N, K) the rows of the ground below lifted feet that a person has put, NaN elsewhere."""
    rows = np.full(planted.shape, np.nan)
    for row, seen in enumerate(sequence):
        for foot in seen.feet:
            if foot.ground_row is not None:
                rows[row, motion.tracks.index(foot.track)] = foot.ground_row
    return np.where(planted, np.nan, rows)


def _ground(motion: Motion, planted: Flags, said: Floats) -> Floats:
    """Return (N, K) the row of the ground below each foot, canvas px; ``said`` are rows known beside contacts."""
    some = planted.any(axis=1)
    if some.any():
        carrying_rows = np.where(planted, motion.y, -np.inf).max(axis=1)
        common = np.interp(motion.frames, motion.frames[some], carrying_rows[some])
        ground = np.repeat(common[:, None], motion.seen.shape[1], axis=1)
    else:
        ground = motion.y.copy()
    known = planted | ~np.isnan(said)
    rows = np.where(planted, motion.y, said)
    for column in np.flatnonzero(known.any(axis=0)):
        at = known[:, column]
        ground[:, column] = np.interp(motion.frames, motion.frames[at], rows[at, column])
    return ground


def _uneven(motion: Motion, planted: Flags) -> Flags:
    """Return (N,) where a contact begins or ends that is not level with the rest of it: the foot may be in the air."""
    level = np.abs(np.diff(motion.y, axis=0)) < _LEVEL * motion.height[1:, None]
    uneven = planted[1:] & planted[:-1] & ~level
    begins = uneven[1:] & ~planted[:-2] & motion.shown[:-2, None]
    ends = uneven[:-1] & ~planted[2:] & motion.shown[2:, None]
    result = np.zeros_like(planted)
    result[1:-1] = begins | ends
    uneven_runs: Flags = np.any(result, axis=1)
    return uneven_runs


def _said(sequence: Sequence[Seen]) -> Flags:
    """Return (N,) whether a person has decided: nobody needs to look again."""
    return np.array([any(foot.verdict for foot in seen.feet) for seen in sequence], np.bool_)


def _standings(motion: Motion, planted: Flags, ground: Floats, row: int) -> tuple[Standing, ...]:
    return tuple(
        Standing(
            motion.tracks[column],
            (float(motion.x[row, column]), float(motion.y[row, column])),
            float(ground[row, column]),
            bool(planted[row, column]),
        )
        for column in np.flatnonzero(motion.seen[row]).tolist()
    )
