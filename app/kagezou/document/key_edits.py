"""Edits of many keys at once: what the timeline and the curve editor do with the keys that are selected.

As every edit they give a new document, the very same one if nothing changes; those that move keys also say where the
keys are afterwards, so that a selection can follow them.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Final

from kagezou.animation.ease import Ease
from kagezou.animation.track import Key, Track, Value, components_of, ordered, rebuilt
from kagezou.document.address import Address, track_of
from kagezou.document.edits import set_track
from kagezou.document.linking import is_linked
from kagezou.document.model import Document
from kagezou.document.property import Kind

Amounts = Mapping[Address, tuple[float, ...]]

NO_AMOUNTS: Final[Amounts] = MappingProxyType({})


@dataclass(frozen=True, slots=True)
class KeyRef:
    """The key of one property on one frame."""

    address: Address
    frame: int


Refs = frozenset[KeyRef]


@dataclass(frozen=True, slots=True)
class KeyClip:
    """Copied keys with where they were taken from; ``frame`` is that of the earliest."""

    frame: int
    keys: tuple[tuple[Address, Key], ...]


def present_keys(document: Document, refs: Refs) -> Refs:
    """Return those of the keys that are there."""
    found: set[KeyRef] = set()
    is_there = _presence(document)
    for address, frames in frames_by_address(refs).items():
        if is_there(address):
            there = {key.frame for key in track_of(document, address).keys}
            found.update(KeyRef(address, frame) for frame in frames & there)
    return refs if len(found) == len(refs) else frozenset(found)


def all_keys(document: Document, address: Address) -> Refs:
    """Return all keys of a property."""
    return frozenset(KeyRef(address, key.frame) for key in track_of(document, address).keys)


def move_keys(document: Document, refs: Refs, frames: int, amounts: Amounts = NO_AMOUNTS) -> tuple[Document, Refs]:
    """Move keys in time, together and never before frame 1, and in value.

    Keys that lie where others come to lie are replaced by them.

    Parameters
    ----------
    refs
        Keys that are there.
    frames
        Later, or earlier if negative.
    amounts
        What is added to the components of the keys of an address, in the property's units; the result is kept within
        the property's range.
    """
    frames = max(frames, 1 - min((ref.frame for ref in refs), default=1))

    def moved(address: Address, key: Key) -> Key:
        value = _added(address, key.value, amounts.get(address, ()))
        return replace(key, frame=key.frame + frames, value=value)

    return replaced_keys(document, refs, moved)


def stretch_keys(document: Document, refs: Refs, about: int, factor: float) -> tuple[Document, Refs]:
    """Spread keys in time about a frame; they land on whole frames, and the speeds of their eases follow.

    Where two land on one frame the one farther from ``about`` stays. A factor of 0 or less counts as almost 0.
    """
    factor = max(factor, 1e-6)

    def stretched(_address: Address, key: Key) -> Key:
        def slower(eases: tuple[Ease, ...]) -> tuple[Ease, ...]:
            return tuple(replace(ease, speed=ease.speed / factor) for ease in eases)

        frame = max(about + round((key.frame - about) * factor), 1)
        if frame == key.frame:
            return key
        return replace(key, frame=frame, ease_in=slower(key.ease_in), ease_out=slower(key.ease_out))

    return replaced_keys(document, refs, stretched, rank=lambda frame: abs(frame - about))


def remove_keys(document: Document, refs: Refs) -> Document:
    """Take keys away; a property's last ones leave the value of the first of them as its constant."""
    for address, frames in frames_by_address(refs).items():
        track = track_of(document, address)
        left = tuple(key for key in track.keys if key.frame not in frames)
        gone = [key for key in track.keys if key.frame in frames]
        if gone:
            document = set_track(document, address, replace(track, keys=left) if left else Track(gone[0].value))
    return document


def copy_keys(document: Document, refs: Refs) -> KeyClip | None:
    """Return copies of keys, None if there are none."""
    found = [
        (address, key)
        for address, frames in frames_by_address(refs).items()
        for key in track_of(document, address).keys
        if key.frame in frames
    ]
    return KeyClip(min(key.frame for _, key in found), tuple(found)) if found else None


def paste_keys(document: Document, clip: KeyClip, frame: int | None, onto: str | None = None) -> tuple[Document, Refs]:
    """Put copied keys down so that the earliest lies on ``frame``; None puts them where they were taken.

    Parameters
    ----------
    onto
        The layer that gets keys which were all taken from one layer; those from several layers, and the scene's, go
        to where they came from, if that is still there.
    """
    is_there = _presence(document)
    sources = {address.layer_id for address, _ in clip.keys if address.layer_id is not None}
    away = 0 if frame is None else frame - clip.frame
    moves = onto is not None and len(sources) == 1
    put: dict[Address, list[Key]] = {}
    for address, key in clip.keys:
        target = replace(address, layer_id=onto) if moves and address.layer_id is not None else address
        if is_there(target):
            put.setdefault(target, []).append(replace(key, frame=key.frame + away))
    for target, keys in put.items():
        document = set_track(document, target, track_of(document, target).with_keys(keys))
    return document, frozenset(KeyRef(target, key.frame) for target, keys in put.items() for key in keys)


def _presence(document: Document) -> Callable[[Address], bool]:
    """Return what tells whether the layer or the set piece of an address is there."""
    layers = {None, *(layer.id for layer in document.layers)}
    pieces = {None, *(piece.id for piece in document.pieces)}
    return lambda address: address.layer_id in layers and address.piece_id in pieces


def _added(address: Address, value: Value, amounts: tuple[float, ...]) -> Value:
    parts = components_of(value)
    if parts is None or not any(amounts):
        return value
    prop = address.property
    low, high = (0.0, 255.0) if prop.kind is Kind.COLOR else (prop.low, prop.high)
    padded = amounts + (0.0,) * (len(parts) - len(amounts))
    moved = tuple(min(max(part + more, low), high) for part, more in zip(parts, padded, strict=False))
    return rebuilt(value, moved)


def frames_by_address(refs: Iterable[KeyRef]) -> dict[Address, set[int]]:
    """Return the frames of keys by their address."""
    found: dict[Address, set[int]] = {}
    for ref in refs:
        found.setdefault(ref.address, set()).add(ref.frame)
    return found


def replaced_keys(
    document: Document,
    refs: Refs,
    change: Callable[[Address, Key], Key],
    rank: Callable[[int], int] = lambda frame: frame,
) -> tuple[Document, Refs]:
    """Put the changed keys in the place of the old ones; of two on one frame the one of higher rank stays."""
    put: set[KeyRef] = set()
    for addresses, frames in _together(document, refs):
        track = track_of(document, addresses[0])
        chosen = [key for key in track.keys if key.frame in frames]
        others = {key.frame: key for key in track.keys if key.frame not in frames}
        changed = (change(addresses[0], key) for key in sorted(chosen, key=lambda key: rank(key.frame)))
        new = {key.frame: key for key in changed}
        document = set_track(document, addresses[0], replace(track, keys=ordered({**others, **new}.values())))
        put.update(KeyRef(address, frame) for address in addresses for frame in new)
    return document, frozenset(put)


def _together(document: Document, refs: Refs) -> list[tuple[list[Address], set[int]]]:
    """Return frames by address; the layers of a linked property come together, as they have the same keys."""
    found: dict[object, tuple[list[Address], set[int]]] = {}
    for address, frames in frames_by_address(refs).items():
        shared = address.property.name if is_linked(document, address) else address
        addresses, together = found.setdefault(shared, ([], set()))
        addresses.append(address)
        together |= frames
    return list(found.values())
