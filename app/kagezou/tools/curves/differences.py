"""Between which frames a curve looks another than before, so that no more of it has to be drawn anew."""

from itertools import chain
from typing import Final

import numpy as np

from kagezou.animation.curve import Floats, Line
from kagezou.tools.curves.picture import CurvePicture, HandleMark, KeyMark

Span = tuple[float, float]
"""First and last frame."""

EVERYWHERE: Final[Span] = (-np.inf, np.inf)
NOWHERE: Final[Span] = (np.inf, -np.inf)


def joined(one: Span, other: Span) -> Span:
    """Return the least span that holds two."""
    return min(one[0], other[0]), max(one[1], other[1])


def differing_span(before: CurvePicture, after: CurvePicture) -> Span:
    """Return where the picture of a curve is another than before.

    It is another everywhere where its look is, or its number of keys.
    """
    if _look(before) != _look(after) or not _same_line(before.ghost, after.ghost):
        return EVERYWHERE
    keys = zip(before.keys, after.keys, strict=True)
    changed = [mark.frame for pair in keys if _seen(pair[0]) != _seen(pair[1]) for mark in pair]
    if before.handles != after.handles:
        changed += chain.from_iterable(_frames_of(handle) for handle in (*before.handles, *after.handles))
    span = _differing(before.line, after.line)
    return joined(span, (min(changed), max(changed))) if changed else span


def _look(picture: CurvePicture) -> tuple[object, ...]:
    """Return what the whole of a curve is drawn by; one with chosen keys stands out."""
    return picture.curve, bool(picture.chosen), len(picture.keys), picture.line.frames.shape


def _seen(mark: KeyMark) -> tuple[object, ...]:
    return mark.frame, mark.ordinate, mark.interpolation, mark.is_chosen


def _frames_of(handle: HandleMark) -> tuple[float, float]:
    return handle.frame, handle.key.frame


def _differing(before: Line, after: Line) -> Span:
    """Return where two lines of equally many points differ, from the points that still are the same."""
    differs = np.flatnonzero(~(_equal(before.frames, after.frames) & _equal(before.values, after.values)))
    if not len(differs):
        return NOWHERE
    first, last = max(differs[0] - 1, 0), differs[-1] + 1
    frames = [line.frames[first : last + 1] for line in (before, after)]
    return float(min(map(np.min, frames))), float(max(map(np.max, frames)))


def _same_line(before: Line | None, after: Line | None) -> bool:
    if before is None or after is None:
        return before is after
    return before.frames.shape == after.frames.shape and _differing(before, after) == NOWHERE


def _equal(one: Floats, other: Floats) -> np.ndarray:
    """Compare numbers (N,); a break of a line equals a break."""
    return np.asarray((one == other) | (np.isnan(one) & np.isnan(other)))
