"""The value of a property at a frame, as the type that the property has."""

from typing import TypeVar

from kagezou.animation.track import Value
from kagezou.document.model import Tracks
from kagezou.document.property import Property

T = TypeVar("T", bound=Value)


def value_at(tracks: Tracks, prop: Property[T], frame: float) -> T:
    """Return what a property is at a frame, which may lie between whole frames; its default where it was never set.

    Parameters
    ----------
    tracks
        Those of the owner: the document, a layer or a set piece.
    prop
        Which property; it settles the type of the value.
    frame
        Counted from 1.
    """
    track = tracks.get(prop.name)
    return prop.default if track is None else prop.typed(track.value_at(frame))


def values_ever(tracks: Tracks, prop: Property[T]) -> tuple[Value, ...]:
    """Return the values that a property has at its keys, or the one that it has all the time."""
    track = tracks.get(prop.name)
    if track is None:
        return (prop.default,)
    return tuple(key.value for key in track.keys) if track.is_keyed else (track.constant,)


def rgb_at(tracks: Tracks, prop: Property[str], frame: float) -> tuple[int, int, int]:
    """Return a colour at a frame as red, green and blue, sRGB, 0 to 255."""
    red, green, blue = bytes.fromhex(value_at(tracks, prop, frame).removeprefix("#"))
    return (red, green, blue)
