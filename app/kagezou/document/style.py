"""Styles: named sets of a shadow's properties that are put on a character at one stroke."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

from kagezou.animation.track import Value
from kagezou.document import properties
from kagezou.document.address import Address, value_of
from kagezou.document.edits import set_value
from kagezou.document.figure_properties import PAINTED
from kagezou.document.local_name import LocalName
from kagezou.document.model import Document
from kagezou.document.property import AnyProperty, Kind

NOT_OF_A_STYLE = frozenset({properties.WAVE_SEED.name, properties.TIMING.name, properties.MATTE.name, PAINTED.name})
"""Properties that belong to a cut, not to a look."""

_ROOMS = ("shadow.", "contact.", "reflection.")
LINES = tuple(
    prop for prop in properties.OF_LAYER.values() if prop.name.startswith(_ROOMS) and prop.name not in NOT_OF_A_STYLE
)
"""What a style may hold of a layer."""

_POWERS = MappingProxyType({"px": 1, "px²": 2})
"""Units of what grows with a character, and how often."""

Values = Mapping[str, Value]


@dataclass(frozen=True, slots=True)
class Style:
    """A look by name.

    Parameters
    ----------
    name
        What people call it.
    figure_px
        How tall a character its lengths are meant for; on another they grow and shrink with it.
    values
        By names of a layer's properties.
    scene
        By names of the scene's properties, where the look needs a light of its own.
    """

    name: LocalName
    figure_px: float
    values: Values
    scene: Values = field(default_factory=lambda: MappingProxyType({}))


def apply_style(document: Document, layer_id: str, style: Style, frame: int) -> Document:
    """Put a style on a layer: keyed properties get a key on ``frame``, the others a new constant."""
    scale = document.layer(layer_id).figure.height / style.figure_px
    for name, value in style.values.items():
        prop = properties.OF_LAYER[name]
        document = set_value(document, Address(prop, layer_id), _scaled(prop, value, scale), frame)
    for name, value in style.scene.items():
        document = set_value(document, Address(properties.OF_DOCUMENT[name]), value, frame)
    return document


def style_of(document: Document, layer_id: str, frame: int, name: str) -> Style:
    """Return the look that a layer has at a frame; the light of the scene is no part of it."""
    values = {prop.name: value_of(document, Address(prop, layer_id), frame) for prop in LINES}
    height = float(document.layer(layer_id).figure.height)
    return Style(LocalName(name), height, MappingProxyType(values))


def _scaled(prop: AnyProperty, value: Value, scale: float) -> Value:
    if prop.kind is not Kind.NUMBER or prop.unit not in _POWERS or not isinstance(value, float):
        return value
    return min(max(value * scale ** _POWERS[prop.unit], prop.low), prop.high)
