"""Curves as they are drawn: values and speeds of one component over time, and the handles of its eases."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kagezou.animation.ease import EASY, MIN_INFLUENCE, Ease
from kagezou.animation.track import Interpolation, Key, Track, components_of

Floats = NDArray[np.float64]

_POINTS_A_BEZIER = 33
_ALONG: Final = np.linspace(0.0, 1.0, _POINTS_A_BEZIER)
"""How far along a bezier its points lie, (P,)."""


@dataclass(frozen=True, slots=True)
class Line:
    """Points of a polyline, both (N,): frames, and values or speeds in units a frame; NaN breaks it."""

    frames: Floats
    values: Floats


@dataclass(frozen=True, slots=True)
class EaseHandle:
    """Where the end of an ease's handle lies: a frame, which may lie between whole ones, and a value."""

    frame: float
    value: float


def component_count(track: Track) -> int:
    """Return how many numbers all values of a track have; 0 if they differ or can only be held."""
    counts = {len(components_of(value) or ()) for value in (track.constant, *(key.value for key in track.keys))}
    return counts.pop() if len(counts) == 1 else 0


def value_line(track: Track, component: int, first: float, last: float) -> Line:
    """Return the values from frame ``first`` to ``last``; exact at every point, beziers as 32 chords each."""
    keys = track.keys
    if not keys:
        level = (components_of(track.constant) or (0.0,))[component]
        return Line(np.array([first, last], np.float64), np.array([level, level], np.float64))
    segments = _segments(keys, component)
    return _whole(keys, segments, (first, last), (_number(keys[0], component), _number(keys[-1], component)))


def speed_line(track: Track, component: int, first: float, last: float) -> Line:
    """Return the speeds from frame ``first`` to ``last``, units a frame; 0 where a value is held."""
    keys = track.keys
    if not keys:
        return Line(np.array([first, last], np.float64), np.zeros(2))
    return _whole(keys, _segment_speeds(keys, component), (first, last), (0.0, 0.0))


def speeds_at(track: Track, index: int, component: int) -> tuple[float, float]:
    """Return the speeds before and after a key, units a frame; 0 where nothing lies on that side."""
    before = after = 0.0
    if index:
        before = float(_segment_speeds(track.keys[index - 1 : index + 1], component)[0][1][-1])
    if index + 1 < len(track.keys):
        after = float(_segment_speeds(track.keys[index : index + 2], component)[0][1][0])
    return before, after


def handles_of(track: Track, index: int, component: int) -> tuple[EaseHandle | None, EaseHandle | None]:
    """Return the ends of a key's handles before and after it; None on a side without a bezier."""
    key = track.keys[index]
    level = _number(key, component)
    left = right = None
    if index and track.keys[index - 1].interpolation is Interpolation.BEZIER:
        ease, span = _ease(key.ease_in, component), key.frame - track.keys[index - 1].frame
        left = EaseHandle(key.frame - _reach(ease) * span, level - ease.speed * _reach(ease) * span)
    if index + 1 < len(track.keys) and key.interpolation is Interpolation.BEZIER:
        ease, span = _ease(key.ease_out, component), track.keys[index + 1].frame - key.frame
        right = EaseHandle(key.frame + _reach(ease) * span, level + ease.speed * _reach(ease) * span)
    return left, right


def ease_toward(track: Track, index: int, component: int, place: EaseHandle) -> Ease:
    """Return the ease whose handle ends at a place; on which side of the key that lies says which ease it is.

    A handle never reaches beyond the neighbouring key, nor back over its own.
    """
    key = track.keys[index]
    is_left = place.frame < key.frame
    neighbour = track.keys[index - 1] if is_left else track.keys[index + 1]
    span = abs(neighbour.frame - key.frame)
    away = max(abs(place.frame - key.frame), MIN_INFLUENCE * span)
    rise = place.value - _number(key, component)
    return Ease((-rise if is_left else rise) / away, min(away / span, 1.0))


def largest_steps(track: Track, first: int, last: int) -> tuple[tuple[int, float], ...]:
    """Return (frame, distance) of how far a value moves from each frame to the next, in its own units.

    The distance is that of the components taken together, so that a point's is its way on the canvas.
    """
    found = []
    before = components_of(track.value_at(first)) or ()
    for frame in range(first + 1, last + 1):
        now = components_of(track.value_at(frame)) or ()
        if len(now) == len(before):
            found.append((frame, float(np.hypot.reduce(np.subtract(now, before))) if now else 0.0))
        before = now
    return tuple(found)


_Points = tuple[Floats, Floats]
"""Frames and values or speeds, both (N,)."""


def _whole(
    keys: Sequence[Key], segments: Iterable[_Points], ends: tuple[float, float], levels: tuple[float, float]
) -> Line:
    """Return a line through segments between keys, which goes on level to both ends."""
    before = np.array([min(ends[0], keys[0].frame), keys[0].frame], np.float64), np.full(2, levels[0])
    after = np.array([keys[-1].frame, max(ends[1], keys[-1].frame)], np.float64), np.full(2, levels[1])
    frames, values = zip(before, *segments, after, strict=True)
    return Line(np.concatenate(frames), np.concatenate(values))


def _segments(keys: Sequence[Key], component: int) -> list[_Points]:
    """Return the values from each key to the next."""
    starts, x, y = _beziers(keys, component)
    curves = iter(zip(starts + _bezier(x), _bezier(y), strict=True))
    return [
        next(curves) if key.interpolation is Interpolation.BEZIER else _straight(key, follower, component)
        for key, follower in pairwise(keys)
    ]


def _straight(key: Key, follower: Key, component: int) -> _Points:
    start, end = _number(key, component), _number(follower, component)
    if key.interpolation is Interpolation.HOLD:
        return (
            np.array([key.frame, follower.frame, follower.frame], np.float64),
            np.array([start, start, end], np.float64),
        )
    return np.array([key.frame, follower.frame], np.float64), np.array([start, end], np.float64)


def _segment_speeds(keys: Sequence[Key], component: int) -> list[_Points]:
    """Return the speeds from each key to the next."""
    starts, x, y = _beziers(keys, component)
    # Handles of full influence on both sides stand the curve upright in its middle.
    speeds = _slope(y) / np.maximum(_slope(x), 1e-9 * x[:, 3:])
    curves = iter(zip(starts + _bezier(x), speeds, strict=True))
    return [
        next(curves) if key.interpolation is Interpolation.BEZIER else _straight_speeds(key, follower, component)
        for key, follower in pairwise(keys)
    ]


def _straight_speeds(key: Key, follower: Key, component: int) -> _Points:
    ends = np.array([key.frame, follower.frame], np.float64)
    if key.interpolation is Interpolation.HOLD:
        return ends, np.zeros(2)
    rise = _number(follower, component) - _number(key, component)
    return ends, np.full(2, rise / float(follower.frame - key.frame))


def _beziers(keys: Sequence[Key], component: int) -> tuple[Floats, Floats, Floats]:
    """Return the first frames (N, 1) of all bezier segments, and frames from there and values of control points (N, 4).

    All are computed at once: one by one they took ten times as long.
    """
    eased = [(key, follower) for key, follower in pairwise(keys) if key.interpolation is Interpolation.BEZIER]
    starts = np.array([key.frame for key, _ in eased], np.float64).reshape(-1, 1)
    controls = np.array([_controls(*each, component) for each in eased], np.float64).reshape(-1, 2, 4)
    return starts, controls[:, 0], controls[:, 1]


def _controls(key: Key, follower: Key, component: int) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Return the four control points of a bezier segment: frames from its first key, and values (see `eased`)."""
    span = float(follower.frame - key.frame)
    start, end = _number(key, component), _number(follower, component)
    out, into = _ease(key.ease_out, component), _ease(follower.ease_in, component)
    leave, reach = _reach(out) * span, _reach(into) * span
    return (
        (0.0, leave, span - reach, span),
        (start, start + out.speed * leave, end - into.speed * reach, end),
    )


def _bezier(controls: Floats) -> Floats:
    """Return points (N, P) along beziers with control points (N, 4)."""
    u, v, p = _ALONG, 1 - _ALONG, controls[:, :, None]
    return np.asarray(v**3 * p[:, 0] + 3 * v**2 * u * p[:, 1] + 3 * v * u**2 * p[:, 2] + u**3 * p[:, 3], np.float64)


def _slope(controls: Floats) -> Floats:
    u, v, p = _ALONG, 1 - _ALONG, controls[:, :, None]
    rises = (p[:, 1] - p[:, 0]), (p[:, 2] - p[:, 1]), (p[:, 3] - p[:, 2])
    return np.asarray(3 * (v**2 * rises[0] + 2 * v * u * rises[1] + u**2 * rises[2]), np.float64)


def _number(key: Key, component: int) -> float:
    return (components_of(key.value) or (0.0,))[component]


def _ease(eases: tuple[Ease, ...], component: int) -> Ease:
    return eases[component] if component < len(eases) else EASY


def _reach(ease: Ease) -> float:
    return min(max(ease.influence, MIN_INFLUENCE), 1.0)
