"""Which properties mean something now: for the kind of the light, of the set pieces, and of the layers chosen."""

from collections.abc import Callable, Iterable

from kagezou.document import properties
from kagezou.document.address import Address
from kagezou.document.figure_properties import PLACEMENT_LINES
from kagezou.document.model import Document
from kagezou.document.piece_kinds import kind_of, matters
from kagezou.document.property import AnyProperty, Scope
from kagezou.document.values import value_at

_ONLY_FOR_LIGHT = {
    properties.LIGHT_POSITION.name: "point",
    properties.OVERHEAD_RADIUS.name: "point",
    properties.OVERHEAD_SIMPLIFY.name: "point",
    properties.LIGHT_STEP.name: "point",
    properties.LIGHT_AZIMUTH.name: "sun",
    properties.LIGHT_ELEVATION.name: "sun",
}
"""Properties that mean nothing for the other kind of light and are hidden then."""

_OF_A_PART = frozenset((properties.VISIBLE, properties.RECEIVES, *PLACEMENT_LINES))
"""What a part of another layer's figure has of its own."""


def meaning_on(document: Document, frame: int, layer_ids: Iterable[str]) -> Callable[[Address], bool]:
    """Return what tells whether a property means something on a frame, while layers are chosen."""
    kind = value_at(document.tracks, properties.LIGHT_KIND, frame)
    has_figure = any(document.layer(each).joins is None for each in layer_ids)

    def is_its_own(prop: AnyProperty) -> bool:
        # A part shares its figure's shadow.
        return prop.scope is not Scope.LAYER or prop in _OF_A_PART or has_figure

    def means_something(address: Address) -> bool:
        prop, piece_id = address.property, address.piece_id
        is_of_kind = piece_id is None or matters(prop, kind_of(document.piece(piece_id), frame))
        return _ONLY_FOR_LIGHT.get(prop.name, kind) == kind and is_of_kind and is_its_own(prop)

    return means_something


def decides_meaning(addresses: Iterable[Address]) -> bool:
    """Return whether it hangs on any of some properties which others mean something."""
    return any(each.property is properties.LIGHT_KIND or each.piece_id is not None for each in addresses)
