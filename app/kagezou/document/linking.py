"""Links: a layer property that is the same for all layers, with its values and its keys.

`edits.set_track` gives a linked property's track to every layer, so that whatever changes one changes all.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import Final

from kagezou.document.address import Address, track_of
from kagezou.document.edits import set_track
from kagezou.document.figure_properties import PLACEMENT_LINES
from kagezou.document.model import Document
from kagezou.document.properties import GROUNDING, OF_LAYER
from kagezou.document.property import AnyProperty
from kagezou.errors import UsageProblem
from kagezou.message import Message

LINKABLE: Final[Mapping[str, AnyProperty]] = MappingProxyType({
    name: prop for name, prop in OF_LAYER.items() if prop is not GROUNDING and prop not in PLACEMENT_LINES
})  # fmt: skip
"""Every layer property but the places on the canvas, which are each character's own."""


def is_linked(document: Document, address: Address) -> bool:
    """Return whether a property is the same for all layers."""
    return address.layer_id is not None and address.property.name in document.linked


def link(document: Document, address: Address) -> Document:
    """Make a layer's property that of all layers: the others get its values and keys.

    Raises
    ------
    UsageProblem
        If the property is each layer's own.
    """
    name = address.property.name
    if address.layer_id is None or name not in LINKABLE:
        raise UsageProblem(Message("{name} cannot be the same for all characters", name=name))
    track = track_of(document, address)
    for layer in document.layers:
        document = set_track(document, Address(address.property, layer.id), track)
    return document if name in document.linked else replace(document, linked=document.linked | {name})


def unlink(document: Document, name: str) -> Document:
    """Let every layer have a property of its own again; all keep what they have."""
    return document if name not in document.linked else replace(document, linked=document.linked - {name})


def twins(document: Document, address: Address) -> Iterator[Address]:
    """Yield the addresses that always have the same track, this one first."""
    yield address
    if is_linked(document, address):
        for layer in document.layers:
            if layer.id != address.layer_id:
                yield replace(address, layer_id=layer.id)
