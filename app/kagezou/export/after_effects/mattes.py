"""The mattes a compositor may ask for: renderings of the same document with another look."""

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import Final

from kagezou.animation.track import Track, Value
from kagezou.document import properties
from kagezou.document.address import Address
from kagezou.document.companion_properties import CONTACT_STRENGTH, REFLECTION_OPACITY
from kagezou.document.edits import set_constant
from kagezou.document.figure_properties import LIFT_FADE
from kagezou.document.figures import height_of
from kagezou.document.model import Document, Layer
from kagezou.document.property import AnyProperty
from kagezou.document.set_properties import SET_COLOR, SET_OPACITY
from kagezou.export.selection import ever_has_contact, ever_is_mirrored

MATTES: Final[Mapping[str, str]] = MappingProxyType({
    "shadow": "the shadow alone, white",
    "core": "its part near the feet, fading out over a fifth of the character's height",
    "distance": "white at the feet to black at twice the character's height, within the shadow",
    "lit": "what no shadow lies on, white on black; a composition of the shadows alone",
    "receivers": "the ground and every set piece, each white where it is seen",
})  # fmt: skip

_CORE_HEIGHT: Final = 0.2
_REACH_HEIGHTS: Final = 2.0
_WHITE: Final = "#FFFFFF"
_BLACK: Final = "#000000"


def at_full_opacity(document: Document) -> Document:
    """Return the document with what figures cast and are mirrored in at opacity 1.

    After Effects has the opacity as a property of its own. What is never seen stays so.
    """
    for layer in document.layers:
        document = set_constant(document, Address(properties.OPACITY, layer.id), 1.0)
        for prop, is_there in ((CONTACT_STRENGTH, ever_has_contact), (REFLECTION_OPACITY, ever_is_mirrored)):
            if is_there(layer):
                document = set_constant(document, Address(prop, layer.id), 1.0)
    return set_constant(document, Address(SET_OPACITY), 1.0) if document.pieces else document


def matte_document(document: Document, matte: str) -> Document:
    """Return the document whose shadow layers are a matte ("shadow", "core" or "distance")."""
    looks = {"shadow": _plain, "core": _core, "distance": _distance}
    look = looks[matte]
    layers = tuple(_changed(layer, look(layer)) for layer in document.layers)
    document = replace(document, layers=layers)
    if not document.pieces:
        return document
    return set_constant(set_constant(document, Address(SET_OPACITY), 1.0), Address(SET_COLOR), _WHITE)


def _plain(_layer: Layer) -> dict[AnyProperty, Value]:
    return {
        properties.COLOR: _WHITE,
        properties.TIP_COLOR: _WHITE,
        properties.OPACITY: 1.0,
        LIFT_FADE: 0.0,
        properties.FADE: 0.0,
        properties.TIP_DISTANCE: 0.0,
    }


def _core(layer: Layer) -> dict[AnyProperty, Value]:
    height = height_of(layer, 1)
    return {**_plain(layer), properties.FADE: max(height * _CORE_HEIGHT, 1.0), properties.FADE_CURVE: 1.0}


def _distance(layer: Layer) -> dict[AnyProperty, Value]:
    reach = min(height_of(layer, 1) * _REACH_HEIGHTS, properties.TIP_DISTANCE.high)
    return {**_plain(layer), properties.TIP_COLOR: _BLACK, properties.TIP_DISTANCE: reach}


def _changed(layer: Layer, values: dict[AnyProperty, Value]) -> Layer:
    tracks = {**layer.tracks, **{prop.name: Track(prop.canonical(value)) for prop, value in values.items()}}
    return replace(layer, tracks=MappingProxyType(tracks))
