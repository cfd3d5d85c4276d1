"""What an edit changed, as it is seen at one frame: values from and to, and the keys that were set there."""

from dataclasses import dataclass

from kagezou.animation.track import Value
from kagezou.document.address import Address, addresses, track_of, value_of
from kagezou.document.model import Document


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
