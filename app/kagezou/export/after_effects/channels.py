"""From tracks to channels: the same curve in After Effects' units (seconds, per cent)."""

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction

from kagezou.animation.ease import EASY, MIN_INFLUENCE, Ease
from kagezou.animation.track import Interpolation, Key, Track, Value, components_of
from kagezou.export.after_effects.comp import Channel, ChannelKey, Pair, PairKey

_TYPES = {Interpolation.HOLD: "HOLD", Interpolation.LINEAR: "LINEAR", Interpolation.BEZIER: "BEZIER"}


def seconds(frame: float, rate: Fraction) -> float:
    """Return when a frame begins, with frame 1 at 0."""
    return float((Fraction(frame) - 1) / rate)


def channel_of(track: Track, component: int, rate: Fraction, scale: float = 1.0) -> Channel:
    """Return one component of a track.

    Parameters
    ----------
    track
        All its values have as many components.
    component
        Which one, from 0.
    rate
        Frames a second.
    scale
        The property's units in After Effects' ones, such as 100 for a part in per cent.
    """
    keys = tuple(
        ChannelKey(
            time=seconds(key.frame, rate),
            value=_component(key, component) * scale,
            into=_TYPES[before],
            out=_TYPES[key.interpolation],
            ease_in=_ease(key.ease_in, component, rate, scale),
            ease_out=_ease(key.ease_out, component, rate, scale),
        )
        for key, before in _reached(track)
    )
    parts = components_of(track.constant) or ()
    value = parts[component] * scale if component < len(parts) else 0.0
    return Channel(keys[0].value if keys else value, keys)


def pair_of(track: Track, rate: Fraction, shift: tuple[float, float] = (0.0, 0.0)) -> Pair:
    """Return a track of points as one property, all of it moved by ``shift``."""
    keys = tuple(
        PairKey(
            time=seconds(key.frame, rate),
            value=_shifted(key.value, shift),
            into=_TYPES[before],
            out=_TYPES[key.interpolation],
            ease_in=tuple(_ease(key.ease_in, part, rate, 1.0) for part in (0, 1)),
            ease_out=tuple(_ease(key.ease_out, part, rate, 1.0) for part in (0, 1)),
        )
        for key, before in _reached(track)
    )
    return Pair(keys[0].value if keys else _shifted(track.constant, shift), keys)


def baked_pair(track: Track, frames: int, rate: Fraction, shift: tuple[float, float] = (0.0, 0.0)) -> Pair:
    """Return a track of points with a key on each frame on which one of them does not go straight on."""
    return pair_through([_shifted(track.value_at(frame), shift) for frame in range(1, frames + 1)], rate)


def pair_through(values: Sequence[tuple[float, float]], rate: Fraction) -> Pair:
    """Return the points of all frames as one property, with keys where one of their numbers does not go straight on."""
    if all(value == values[0] for value in values):
        return Pair(values[0])
    parts = [list(part) for part in zip(*values, strict=True)]
    keys = tuple(
        PairKey(seconds(frame, rate), value, "LINEAR", "LINEAR")
        for frame, value in enumerate(values, start=1)
        if not all(_goes_straight_on(part, frame - 1) for part in parts)
    )
    return Pair(values[0], keys)


def baked(value_at: Callable[[int], float], frames: int, rate: Fraction) -> Channel:
    """Return a channel with a key on each frame on which the value does not go straight on."""
    values = [value_at(frame) for frame in range(1, frames + 1)]
    if all(value == values[0] for value in values):
        return Channel(values[0])
    keys = tuple(
        ChannelKey(seconds(frame, rate), value, "LINEAR", "LINEAR")
        for frame, value in enumerate(values, start=1)
        if not _goes_straight_on(values, frame - 1)
    )
    return Channel(values[0], keys)


def _goes_straight_on(values: list[float], index: int) -> bool:
    if not 0 < index < len(values) - 1:
        return False
    # Exact: a tolerance would add up along a gentle curve.
    return values[index] - values[index - 1] == values[index + 1] - values[index]


def _reached(track: Track) -> Iterator[tuple[Key, Interpolation]]:
    """Yield each key, and how it is reached.

    Behind a hold too it is by a hold, as After Effects makes keys itself: the outgoing side of a key alone decides
    whether it is held.
    """
    before = Interpolation.LINEAR
    for key in track.keys:
        yield key, before
        before = key.interpolation


def _shifted(value: Value, shift: tuple[float, float]) -> tuple[float, float]:
    x, y = components_of(value) or (0.0, 0.0)
    return (x + shift[0], y + shift[1])


def _component(key: Key, component: int) -> float:
    return (components_of(key.value) or (0.0,))[component]


def _ease(eases: tuple[Ease, ...], component: int, rate: Fraction, scale: float) -> tuple[float, float]:
    ease = eases[component] if component < len(eases) else EASY
    influence = min(max(ease.influence, MIN_INFLUENCE), 1.0)
    return ease.speed * scale * float(rate), influence * 100
