"""The runs of frames between which feet are compared."""

from collections.abc import Sequence
from itertools import pairwise
from statistics import median

from kagezou.standing.seen import Seen

_RISE = 0.01  # of the height
_LONGEST_EXPOSURE = 4  # frames: what is held longer is a pose, not a step of a movement


def key_runs(sequence: Sequence[Seen]) -> tuple[list[int], list[int]]:
    """Return the indices of the key runs, and for each run of ``sequence`` which key run, counted from 0, it goes with.

    A looped walk that is drawn on twos and slid across the picture on ones goes forward with every frame and back with
    every drawing: only like frames of drawings can be compared. So the first frame of each drawing is a key. A drawing
    that is moved up or down, as in a jump that is nothing but moved, has one wherever it is seen to have moved so; one
    that is moved for long has one as often as drawings usually change.
    """
    starts = [index for index, each in enumerate(sequence) if not index or not sequence[index - 1].is_moved(each)]
    frames = [sequence[index].frame for index in starts]
    lengths = [after - before for before, after in pairwise(frames)]
    usual = min(_LONGEST_EXPOSURE, median(lengths)) if lengths else 1
    first = set(starts)
    keys: list[int] = []
    key_of: list[int] = []
    for index, each in enumerate(sequence):
        if index in first or each.frame - sequence[keys[-1]].frame >= usual or _rises(sequence[keys[-1]], each):
            keys.append(index)
        key_of.append(len(keys) - 1)
    return keys, key_of


def _rises(key: Seen, moved: Seen) -> bool:
    """Return whether the drawing of ``key`` was moved up or down to be ``moved``."""
    rows = zip(key.feet, moved.feet, strict=True)
    return any(abs(after.place[1] - before.place[1]) >= _RISE * key.height_px for before, after in rows)
