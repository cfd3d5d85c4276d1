"""How feet move from each drawing to the next, told in heights of the figure a frame."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from kagezou.standing.foot import Verdict
from kagezou.standing.seen import Seen

Floats: TypeAlias = NDArray[np.float64]
Flags: TypeAlias = NDArray[np.bool_]

SLOW = 0.012
"""Heights a frame: a foot that moves no faster than this stays where it is, but for the drawing's unevenness."""

_HOLD = 3  # times the usual exposure: the figure rests in a drawing that is held so long
_PAN_WINDOW = 15
_UNKNOWN = 1e9


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
    followed
        (N - 1, K) whether a track is seen before and after a step.
    vx, vy
        (N - 1, K) heights a frame; 0 where it is not followed.
    rests
        (N,) whether the figure is held in a drawing for long, or nothing is known before or after it.
    """

    tracks: tuple[int, ...]
    frames: Floats
    height: Floats
    seen: Flags
    x: Floats
    y: Floats
    followed: Flags
    vx: Floats
    vy: Floats
    rests: Flags

    @property
    def shown(self) -> Flags:
        """(N,) whether any foot is seen."""
        shown: Flags = np.any(self.seen, axis=1)
        return shown

    @property
    def lowest(self) -> NDArray[np.intp]:
        """The column of each run's lowest foot; 0 where none is seen."""
        column: NDArray[np.intp] = np.where(self.seen, self.y, -_UNKNOWN).argmax(axis=1)
        return column

    def above(self, columns: NDArray[np.intp]) -> Floats:
        """Return how far each foot is over that of ``columns`` (N,), in heights, (N, K); much where it is not seen."""
        rows = np.take_along_axis(self.y, columns[:, None], axis=1)
        above: Floats = np.where(self.seen, (rows - self.y) / self.height[:, None], _UNKNOWN)
        return above


def motion_of(sequence: Sequence[Seen]) -> Motion:
    """Return the motion of the feet in ``sequence``, which has one run of frames or more, in order."""
    tracks = tuple(sorted({foot.track for seen in sequence for foot in seen.feet})) or (0,)
    column = {track: index for index, track in enumerate(tracks)}
    shape = len(sequence), len(tracks)
    seen, x, y = np.zeros(shape, np.bool_), np.zeros(shape), np.zeros(shape)
    for row, each in enumerate(sequence):
        for foot in each.feet:
            if foot.verdict is not Verdict.NONE:
                at = row, column[foot.track]
                seen[at], x[at], y[at] = True, foot.place[0], foot.place[1]
    frames = np.array([each.frame for each in sequence], np.float64)
    height = np.array([each.height_px or 1.0 for each in sequence])
    lengths = np.diff(frames)
    usual = float(np.median(lengths)) if lengths.size else 1.0
    # A drawing that is held changes at once, not slowly during the hold.
    unit = (np.minimum(lengths, usual) * (height[1:] + height[:-1]) / 2)[:, None]
    followed = seen[1:] & seen[:-1]
    vx, vy = (np.where(followed, np.diff(places, axis=0) / unit, 0.0) for places in (x, y))
    rests = np.concatenate((lengths >= max(_HOLD * usual, 2.0), [True]))
    return Motion(tracks, frames, height, seen, x, y, followed, vx, vy, rests)


def slide_of(motion: Motion) -> Floats:
    """Return (N, K) how fast each foot slides over the ground, heights a frame; on the slower side of the two.

    A figure that walks on the spot has a ground that runs below it: its common speed is the median of that of the
    lowest feet around the time.
    """
    ground = _ground_speed(motion)[:, None]
    speed = np.where(motion.followed, np.hypot(motion.vx - ground, motion.vy), _UNKNOWN)
    # Part of the ground's own speed is granted: it is drawn unevenly, and eases.
    speed = np.maximum(0.0, speed - np.abs(ground) / 3)
    unknown = np.full((1, motion.seen.shape[1]), _UNKNOWN)
    slower = np.minimum(np.concatenate((unknown, speed)), np.concatenate((speed, unknown)))
    return np.where(slower == _UNKNOWN, 0.0, slower)


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
    medians = np.median(np.lib.stride_tricks.sliding_window_view(speeds, width), axis=1)
    middle = np.clip(np.searchsorted(told, rows) - width // 2, 0, medians.size - 1)
    return medians[middle]
