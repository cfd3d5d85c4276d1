"""How feet move from each drawing to the next, told in heights of the figure a frame of the cinema: 1/24 s."""

from collections.abc import Sequence
from dataclasses import dataclass
from statistics import median
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from kagezou.standing.foot import Verdict
from kagezou.standing.seen import Seen

Floats: TypeAlias = NDArray[np.float64]
Flags: TypeAlias = NDArray[np.bool_]

SLOW = 0.012
"""Heights a frame: a foot that moves no faster than this stays where it is, but for the drawing's unevenness."""

UNKNOWN = 1e9
"""Heights, or heights a frame: more than any that is known."""

_FPS = 24
_HOLD = 3  # times the usual exposure: the figure rests in a drawing that is held so long
_PAN_WINDOW = 15


@dataclass(frozen=True, eq=False, slots=True)
class Motion:
    """The feet of N runs of frames in K tracks, and their N - 1 steps from run to run.

    Attributes
    ----------
    tracks
        (K,) the track of each column.
    frames
        (N,) the first frames.
    height
        (N,) the figure's height, px; 1 where it is 0.
    seen
        (N, K) whether a track is seen, and nobody said that it is no foot.
    x, y
        (N, K) places, canvas px; 0 where it is not seen.
    may_carry
        (N, K) whether a track is seen, and nobody said that it is lifted.
    unit_px
        (N - 1,) how far a step of one height a frame goes.
    followed
        (N - 1, K) whether a track is seen before and after a step.
    vx, vy
        (N - 1, K) heights a frame; 0 where it is not followed.
    is_held
        (N,) whether the figure rests in a drawing that is held for long; in the last one nobody knows.
    """

    tracks: tuple[int, ...]
    frames: Floats
    height: Floats
    seen: Flags
    x: Floats
    y: Floats
    may_carry: Flags
    unit_px: Floats
    followed: Flags
    vx: Floats
    vy: Floats
    is_held: Flags

    @property
    def lengths(self) -> Floats:
        """(N - 1,) how long each step is, frames of the cinema; a hold counts as a usual exposure."""
        lengths: Floats = 2 * self.unit_px / (self.height[1:] + self.height[:-1])
        return lengths

    @property
    def shown(self) -> Flags:
        """(N,) whether any foot is seen."""
        shown: Flags = np.any(self.seen, axis=1)
        return shown

    @property
    def lowest(self) -> NDArray[np.intp]:
        """The column of each run's lowest foot; 0 where none is seen."""
        return self.lowest_of(self.seen)

    def lowest_of(self, feet: Flags) -> NDArray[np.intp]:
        """Return the column of each run's lowest among ``feet`` (N, K); 0 where there are none."""
        column: NDArray[np.intp] = np.where(feet, self.y, -UNKNOWN).argmax(axis=1)
        return column

    def above(self, columns: NDArray[np.intp]) -> Floats:
        """Return how far each foot is over that of ``columns`` (N,), in heights, (N, K); much where it is not seen."""
        rows = np.take_along_axis(self.y, columns[:, None], axis=1)
        above: Floats = np.where(self.seen, (rows - self.y) / self.height[:, None], UNKNOWN)
        return above


def motion_of(sequence: Sequence[Seen], fps: float) -> Motion:
    """Return the motion of the feet in ``sequence``, one run of frames or more, in order, at ``fps`` a second."""
    tracks = tuple(sorted({foot.track for seen in sequence for foot in seen.feet})) or (0,)
    column = {track: index for index, track in enumerate(tracks)}
    shape = len(sequence), len(tracks)
    seen, may_carry, x, y = np.zeros(shape, np.bool_), np.zeros(shape, np.bool_), np.zeros(shape), np.zeros(shape)
    for row, each in enumerate(sequence):
        for foot in each.feet:
            if foot.verdict is not Verdict.NONE:
                at = row, column[foot.track]
                seen[at], may_carry[at] = True, foot.verdict is not Verdict.LIFTED
                x[at], y[at] = foot.place
    frames = np.array([each.frame for each in sequence], np.float64)
    height = np.array([each.height_px or 1.0 for each in sequence])
    lengths = np.diff(frames)
    usual = usual_exposure(frames)
    # A drawing that is held changes at once, not slowly during the hold.
    unit_px = np.minimum(lengths, usual) * (_FPS / fps) * (height[1:] + height[:-1]) / 2
    followed = seen[1:] & seen[:-1]
    vx, vy = (np.where(followed, np.diff(places, axis=0) / unit_px[:, None], 0.0) for places in (x, y))
    is_held = np.concatenate((lengths >= _HOLD * usual, [False]))
    return Motion(tracks, frames, height, seen, x, y, may_carry, unit_px, followed, vx, vy, is_held)


def usual_exposure(frames: Floats) -> float:
    """Return for how many frames a drawing is seen in most cases; ``frames`` (N,) are the first ones of each."""
    return float(median(np.diff(frames).tolist())) if frames.size > 1 else 1.0


def slide_of(motion: Motion) -> Floats:
    """Return (N, K) how fast each foot slides over the ground, heights a frame; on the slower side of the two.

    `UNKNOWN` where it is seen neither before nor after.
    A figure that walks on the spot has a ground that runs below it: its common speed is the median of that of the
    lowest feet around the time.
    """
    ground = _ground_speed(motion)[:, None]
    # Part of the ground's own speed is granted: it is drawn unevenly, and eases.
    along = np.maximum(0.0, np.abs(motion.vx - ground) - np.abs(ground) / 3)
    speed = np.where(motion.followed, np.hypot(along, motion.vy), UNKNOWN)
    unknown = np.full((1, motion.seen.shape[1]), UNKNOWN)
    slower: Floats = np.minimum(np.concatenate((unknown, speed)), np.concatenate((speed, unknown)))
    return slower


def _ground_speed(motion: Motion) -> Floats:
    """Return (N - 1,) the common speed of what stands on the ground, heights a frame, to the right."""
    steps = motion.followed.shape[0]
    low = motion.lowest[:-1]
    rows = np.arange(steps)
    told = np.flatnonzero(motion.followed[rows, low] & (np.abs(motion.vy[rows, low]) <= SLOW))
    if not told.size:
        return np.zeros(steps)
    speeds = motion.vx[told, low[told]]
    width = min(_PAN_WINDOW, told.size)
    medians = _medians(np.lib.stride_tricks.sliding_window_view(speeds, width))
    middle = np.clip(np.searchsorted(told, rows) - width // 2, 0, medians.size - 1)
    return medians[middle]


def _medians(rows: Floats) -> Floats:
    """Return the median (N,) of each row (N, K).

    That of numpy imports its masked arrays, for as long as two frames of an export take.
    """
    ordered = np.sort(rows, axis=1)
    middle = ordered.shape[1] // 2
    result: Floats = (ordered[:, (ordered.shape[1] - 1) // 2] + ordered[:, middle]) / 2
    return result
