"""What an edit changed, as it is seen at one frame: values from and to, and the keys that were set there."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields
from typing import TypeAlias

from kagezou.animation.track import Value
from kagezou.document.address import Address, addresses, track_of, value_of
from kagezou.document.model import Document, Layer, Piece
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER, OF_PIECE
from kagezou.document.property import AnyProperty

_Owner: TypeAlias = Document | Layer | Piece


@dataclass(frozen=True, slots=True)
class Change:
    """A property that is seen otherwise than before."""

    address: Address
    before: Value
    after: Value


def changes_between(before: Document, after: Document, frame: int) -> tuple[Change, ...]:
    """Return the properties whose values at a frame differ, in table order; both have the same layers and pieces."""
    pairs = ((each, value_of(before, each, frame), value_of(after, each, frame)) for each in addresses(before))
    return tuple(Change(address, old, new) for address, old, new in pairs if old != new)


def keys_set_between(before: Document, after: Document, frame: int) -> tuple[Address, ...]:
    """Return the keyed properties that have another key on a frame than before, or a new one, in table order."""
    found: list[Address] = []
    for address in addresses(before):
        key = track_of(after, address).key_at(frame)
        if key is not None and key != track_of(before, address).key_at(frame):
            found.append(address)
    return tuple(found)


def tracks_changed(before: Document, after: Document) -> frozenset[Address] | None:
    """Return the properties that have another track; None where the documents differ in anything else.

    Told by identity: an edit keeps what it does not change. What is equal but not the same may count as changed.
    """
    pairs: list[tuple[_Owner, _Owner]] = [(before, after), *zip(before.layers, after.layers, strict=False)]
    pairs += zip(before.pieces, after.pieces, strict=False)
    counts = (len(before.layers), len(before.pieces)), (len(after.layers), len(after.pieces))
    if counts[0] != counts[1] or not all(_differ_in_tracks_alone(old, new) for old, new in pairs):
        return None
    return frozenset(address for old, new in pairs for address in _changed(old, new))


def _differ_in_tracks_alone(old: _Owner, new: _Owner) -> bool:
    owned = ("tracks", "layers", "pieces") if isinstance(old, Document) else ("tracks",)
    names = (each.name for each in fields(old) if each.name not in owned)
    return old is new or all(getattr(old, name) is getattr(new, name) for name in names)


def _changed(old: _Owner, new: _Owner) -> Iterator[Address]:
    if old.tracks is new.tracks:
        return
    table: Mapping[str, AnyProperty]
    if isinstance(new, Document):
        table, layer_id, piece_id = OF_DOCUMENT, None, None
    elif isinstance(new, Layer):
        table, layer_id, piece_id = OF_LAYER, new.id, None
    else:
        table, layer_id, piece_id = OF_PIECE, None, new.id
    for name in old.tracks.keys() | new.tracks.keys():
        if old.tracks.get(name) is not new.tracks.get(name):
            yield Address(table[name], layer_id, piece_id)
