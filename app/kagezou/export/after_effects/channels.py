"""From tracks to channels: the same curve in After Effects' units (seconds, per cent)."""

from collections.abc import Callable
from fractions import Fraction

from kagezou.animation.ease import EASY, MIN_INFLUENCE, Ease
from kagezou.animation.track import Interpolation, Key, Track, components_of
from kagezou.export.after_effects.comp import Channel, ChannelKey

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
    keys = track.keys
    made = []
    for index, key in enumerate(keys):
        before = keys[index - 1].interpolation if index else Interpolation.LINEAR
        made.append(
            ChannelKey(
                time=seconds(key.frame, rate),
                value=_component(key, component) * scale,
                # Also behind a hold: After Effects itself makes keys there with an incoming hold, and the outgoing side
                # of a key alone decides whether it is held.
                into=_TYPES[before],
                out=_TYPES[key.interpolation],
                ease_in=_ease(key.ease_in, component, rate, scale),
                ease_out=_ease(key.ease_out, component, rate, scale),
            )
        )
    parts = components_of(track.constant) or ()
    value = parts[component] * scale if component < len(parts) else 0.0
    return Channel(made[0].value if made else value, tuple(made))


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


def _component(key: Key, component: int) -> float:
    return (components_of(key.value) or (0.0,))[component]


def _ease(eases: tuple[Ease, ...], component: int, rate: Fraction, scale: float) -> tuple[float, float]:
    ease = eases[component] if component < len(eases) else EASY
    influence = min(max(ease.influence, MIN_INFLUENCE), 1.0)
    return ease.speed * scale * float(rate), influence * 100
