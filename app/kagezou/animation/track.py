"""A track: the constant value or the keys of one property over time."""

from bisect import bisect_left, bisect_right
from collections.abc import Iterable
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import TypeAlias

from kagezou.animation.ease import EASY, Ease, eased

Value: TypeAlias = float | bool | str | tuple[float, ...] | tuple[tuple[float, float], ...]
"""What a property holds: a number, a switch, a choice or colour, a point, or a list of canvas points."""


class Interpolation(StrEnum):
    """How a value goes on from a key to the next one."""

    HOLD = "hold"
    """It stays until the next key."""

    LINEAR = "linear"
    """It moves at one speed."""

    BEZIER = "bezier"
    """It follows the eases of the two keys."""


@dataclass(frozen=True, slots=True)
class Key:
    """A value fixed at a frame.

    Parameters
    ----------
    frame
        Counted from 1.
    value
        The value at that frame.
    interpolation
        How the value goes on toward the next key.
    ease_in, ease_out
        One ease a component for bezier segments before and after the key; a missing component is easy (speed 0).
    """

    frame: int
    value: Value
    interpolation: Interpolation = Interpolation.LINEAR
    ease_in: tuple[Ease, ...] = ()
    ease_out: tuple[Ease, ...] = ()


@dataclass(frozen=True, slots=True)
class Track:
    """The value of one property over time: ``constant``, unless there are ``keys`` (ordered, one a frame)."""

    constant: Value
    keys: tuple[Key, ...] = ()

    @property
    def is_keyed(self) -> bool:
        """Whether the track has keys."""
        return bool(self.keys)

    def key_at(self, frame: int) -> Key | None:
        """Return the key on exactly this frame."""
        index = bisect_left(self.keys, frame, key=lambda key: key.frame)
        return self.keys[index] if index < len(self.keys) and self.keys[index].frame == frame else None

    def value_at(self, frame: float) -> Value:
        """Return the value at a frame, which may lie between whole frames; held before the first and after the last."""
        if not self.keys:
            return self.constant
        after = bisect_right(self.keys, frame, key=lambda key: key.frame)
        if after == 0:
            return self.keys[0].value
        key = self.keys[after - 1]
        if after == len(self.keys) or key.interpolation is Interpolation.HOLD or key.frame == frame:
            return key.value
        return _between(key, self.keys[after], frame)

    def with_key(self, key: Key) -> "Track":
        """Return the track with a key added, or put in the place of the one on its frame."""
        return self.with_keys((key,))

    def with_keys(self, keys: Iterable[Key]) -> "Track":
        """Return the track with keys added, or put in the place of those on their frames; of two on one the last."""
        by_frame = {key.frame: key for key in (*self.keys, *keys)}
        return replace(self, keys=ordered(by_frame.values()))

    def without_key(self, frame: int) -> "Track":
        """Return the track without the key on ``frame``; the last key leaves its value as the constant."""
        left = tuple(key for key in self.keys if key.frame != frame)
        if not left and self.keys:
            return Track(self.keys[0].value)
        return replace(self, keys=left)


def ordered(keys: Iterable[Key]) -> tuple[Key, ...]:
    """Return keys in order of their frames."""
    return tuple(sorted(keys, key=lambda key: key.frame))


def components_of(value: Value) -> tuple[float, ...] | None:
    """Return the numbers that make up a value, or None for one that can only be held (a switch, a choice)."""
    match value:
        case bool():
            return None
        case str():
            return _color_components(value)
        case float():
            return (value,)
        case _:
            flat: list[float] = []
            for part in value:
                flat.extend(part) if isinstance(part, tuple) else flat.append(part)
            return tuple(flat)


def _color_components(text: str) -> tuple[float, ...] | None:
    if len(text) != 7 or not text.startswith("#"):
        return None
    return tuple(float(int(text[start : start + 2], 16)) for start in (1, 3, 5))


def rebuilt(like: Value, parts: tuple[float, ...]) -> Value:
    """Return a value of the same shape as ``like`` from its components."""
    match like:
        case str():
            return "#" + "".join(f"{min(max(round(part), 0), 255):02X}" for part in parts)
        case tuple() if like and isinstance(like[0], tuple):
            return tuple((parts[i], parts[i + 1]) for i in range(0, len(parts), 2))
        case tuple():
            return parts
        case _:
            return parts[0]


def _between(key: Key, follower: Key, frame: float) -> Value:
    start, end = components_of(key.value), components_of(follower.value)
    if start is None or end is None or len(start) != len(end):
        return key.value
    span = float(follower.frame - key.frame)
    position = (frame - key.frame) / span
    if key.interpolation is Interpolation.LINEAR:
        parts = tuple(a + (b - a) * position for a, b in zip(start, end, strict=True))
    else:
        parts = tuple(
            eased(position, a, b, span, _component(key.ease_out, i), _component(follower.ease_in, i))
            for i, (a, b) in enumerate(zip(start, end, strict=True))
        )
    return rebuilt(key.value, parts)


def _component(eases: tuple[Ease, ...], index: int) -> Ease:
    return eases[index] if index < len(eases) else EASY
