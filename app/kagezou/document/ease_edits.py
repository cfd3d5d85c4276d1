"""Edits of how curves go through keys: interpolation, eases, and single handles."""

from dataclasses import replace

from kagezou.animation.ease import EASY, Ease
from kagezou.animation.track import Interpolation, Key, components_of
from kagezou.document.address import track_of
from kagezou.document.edits import set_track
from kagezou.document.key_edits import KeyRef, Refs, frames_by_address
from kagezou.document.model import Document

Eases = tuple[Ease, ...] | None
"""One ease a component; one alone stands for all; None leaves what is there."""


_LINEAR_INFLUENCE = 1 / 6
"""How far the straight side of a key reaches into a segment that is eased at its other end, as After Effects has it."""


def set_interpolation(document: Document, refs: Refs, interpolation: Interpolation) -> Document:
    """Let values go on from these keys in one way; switches and choices are only ever held.

    A key that is made linear is linear on both sides: where an eased segment reaches it, it is reached straight.
    """
    for address, frames in frames_by_address(refs).items():
        if address.property.holds_only:
            continue
        track = track_of(document, address)
        keys = [_going_on(key, interpolation) if key.frame in frames else key for key in track.keys]
        if interpolation is Interpolation.LINEAR:
            keys = [_reached_straight(keys, index) if key.frame in frames else key for index, key in enumerate(keys)]
        document = set_track(document, address, replace(track, keys=tuple(keys)))
    return document


def set_ease(document: Document, refs: Refs, ease_in: Eases, ease_out: Eases) -> Document:
    """Set how curves reach and leave these keys; the segments beside them become beziers.

    A segment that was linear keeps its speed at its other end, so that only the end that is asked for changes.
    """
    for address, frames in frames_by_address(refs).items():
        if address.property.holds_only:
            continue
        track = track_of(document, address)
        keys = list(track.keys)
        for index, key in enumerate(keys):
            if key.frame not in frames:
                continue
            count = len(components_of(key.value) or ())
            if ease_in is not None:
                if index:
                    keys[index - 1], keys[index] = _as_bezier(keys[index - 1], keys[index])
                keys[index] = replace(keys[index], ease_in=_each(ease_in, count))
            if ease_out is not None:
                if index + 1 < len(keys):
                    keys[index], keys[index + 1] = _as_bezier(keys[index], keys[index + 1])
                keys[index] = replace(keys[index], ease_out=_each(ease_out, count), interpolation=Interpolation.BEZIER)
        document = set_track(document, address, replace(track, keys=tuple(keys)))
    return document


def set_handle(document: Document, ref: KeyRef, component: int, ease: Ease, *, before: bool, joined: bool) -> Document:
    """Give one component of a key another ease on one side.

    Parameters
    ----------
    before
        Whether it is the side before the key.
    joined
        Whether the curve goes on smoothly: the other side, where it is a bezier, gets the same speed.
    """
    key = track_of(document, ref.address).key_at(ref.frame)
    if key is None:
        return document
    count = len(components_of(key.value) or ())
    into, out = _padded(key.ease_in, count), _padded(key.ease_out, count)
    sides = [into, out]
    near, far = (0, 1) if before else (1, 0)
    sides[near] = (*sides[near][:component], ease, *sides[near][component + 1 :])
    if joined:
        other = replace(sides[far][component], speed=ease.speed)
        sides[far] = (*sides[far][:component], other, *sides[far][component + 1 :])
    changed = replace(key, ease_in=sides[0], ease_out=sides[1])
    return set_track(document, ref.address, track_of(document, ref.address).with_key(changed))


def chord_speeds(key: Key, follower: Key) -> tuple[float, ...]:
    """Return the even speed from one key to the next of each component, in units per frame; none for held values."""
    start, end = components_of(key.value) or (), components_of(follower.value) or ()
    if len(start) != len(end):
        return ()
    span = follower.frame - key.frame
    return tuple((b - a) / span for a, b in zip(start, end, strict=True))


def _going_on(key: Key, interpolation: Interpolation) -> Key:
    if key.interpolation is interpolation:
        return key
    eases = key.ease_out
    if interpolation is Interpolation.BEZIER and not eases:
        eases = (EASY,) * len(components_of(key.value) or ())
    return replace(key, interpolation=interpolation, ease_out=eases)


def _reached_straight(keys: list[Key], index: int) -> Key:
    if index == 0 or keys[index - 1].interpolation is not Interpolation.BEZIER:
        return keys[index]
    speeds = chord_speeds(keys[index - 1], keys[index])
    return replace(keys[index], ease_in=tuple(Ease(speed, _LINEAR_INFLUENCE) for speed in speeds))


def _as_bezier(key: Key, follower: Key) -> tuple[Key, Key]:
    """Return two neighbours with a bezier between them; one that was linear keeps its shape."""
    if key.interpolation is Interpolation.BEZIER:
        return key, follower
    chord = tuple(Ease(speed) for speed in chord_speeds(key, follower))
    return replace(key, interpolation=Interpolation.BEZIER, ease_out=chord), replace(follower, ease_in=chord)


def _each(eases: tuple[Ease, ...], count: int) -> tuple[Ease, ...]:
    return eases * count if len(eases) == 1 else eases[:count]


def _padded(eases: tuple[Ease, ...], count: int) -> tuple[Ease, ...]:
    return eases + (EASY,) * (count - len(eases))
