"""Edits of one property on several layers at once: one value for all, or each changed alike."""

from collections.abc import Callable, Sequence

from kagezou.document.address import Address, track_of, usual_value, value_of
from kagezou.document.edits import remove_key, set_constant, set_key, set_value
from kagezou.document.linking import is_linked
from kagezou.document.model import Document

Addresses = Sequence[Address]
"""One property of several owners; the first is the one whose value is shown where one has to be."""


def is_mixed(document: Document, addresses: Addresses, frame: float) -> bool:
    """Return whether the values at a frame differ."""
    first = value_of(document, addresses[0], frame)
    return any(value_of(document, address, frame) != first for address in addresses[1:])


def set_all(document: Document, addresses: Addresses, raw: object, frame: int) -> Document:
    """Set what is seen at a frame everywhere: a key where the property is keyed, else its constant."""
    for address in addresses:
        document = set_value(document, address, raw, frame)
    return document


def change_all(document: Document, addresses: Addresses, change: Callable[[float], float], frame: int) -> Document:
    """Change each number at a frame by itself; what leaves the property's range stays at its end."""
    for address in _apart(document, addresses):
        value, prop = value_of(document, address, frame), address.property
        if isinstance(value, float):
            document = set_value(document, address, min(max(change(value), prop.low), prop.high), frame)
    return document


def reset_all(document: Document, addresses: Addresses) -> Document:
    """Go back to the default everywhere, without keys."""
    for address in addresses:
        document = set_constant(document, address, usual_value(document, address))
    return document


def is_keyed_here(document: Document, addresses: Addresses, frame: int) -> bool:
    """Return whether every one has a key on a frame."""
    return all(track_of(document, address).key_at(frame) is not None for address in addresses)


def toggle_keys(document: Document, addresses: Addresses, frame: int) -> Document:
    """Set a key where there is none on a frame; where all have one, take them away."""
    removes = is_keyed_here(document, addresses, frame)
    for address in _apart(document, addresses):
        if removes:
            document = remove_key(document, address, frame)
        elif track_of(document, address).key_at(frame) is None:
            document = set_key(document, address, frame, value_of(document, address, frame))
    return document


def still_all(document: Document, addresses: Addresses, frame: int) -> Document:
    """Take all keys away; what is seen at a frame stays for the whole cut."""
    for address in addresses:
        document = set_constant(document, address, value_of(document, address, frame))
    return document


def _apart(document: Document, addresses: Addresses) -> list[Address]:
    """Return the addresses without those that follow another of them by a link."""
    seen: set[str] = set()
    found = []
    for address in addresses:
        if is_linked(document, address):
            if address.property.name in seen:
                continue
            seen.add(address.property.name)
        found.append(address)
    return found
