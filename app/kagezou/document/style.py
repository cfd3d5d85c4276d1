"""Styles: named sets of a shadow's properties that are put on a character at one stroke."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Final

from kagezou.animation.track import Value
from kagezou.document import properties
from kagezou.document.address import Address, value_of
from kagezou.document.figure_properties import BACKGROUND_POSITION, PAINTED
from kagezou.document.figures import height_of
from kagezou.document.local_name import LocalName
from kagezou.document.model import Document

NOT_OF_A_STYLE: Final = frozenset(
    {properties.WAVE_SEED.name, properties.TIMING.name, properties.MATTE.name, PAINTED.name}
)
"""Properties that belong to a cut, not to a look."""

_ROOMS: Final = ("shadow.", "contact.", "reflection.")
LINES: Final = tuple(
    prop for prop in properties.OF_LAYER.values() if prop.name.startswith(_ROOMS) and prop.name not in NOT_OF_A_STYLE
)
"""What a style says of a layer: the whole look. A line that it does not name has its default."""

SCENE_LINES: Final = tuple(prop for prop in properties.OF_DOCUMENT.values() if prop is not BACKGROUND_POSITION)
"""What a style may hold of the scene: light, ground and set-up."""

Values = Mapping[str, Value]
NO_VALUES: Final[Values] = MappingProxyType({})


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
        By names of a layer's properties; what is not named has its default, so that a style is a whole look.
    scene
        By names of the scene's properties, where the look has a light of its own, perhaps with ground and set-up.
        They are taken only where somebody asks for them, and as they are: px of the canvas.
    """

    name: LocalName
    figure_px: float
    values: Values
    scene: Values = field(default_factory=lambda: NO_VALUES)

    @property
    def has_only_light(self) -> bool:
        """Whether it says nothing of the scene but its light."""
        return all(name.startswith("light.") for name in self.scene)


def style_of(document: Document, layer_id: str, frame: int, name: str, *, with_scene: bool = False) -> Style:
    """Return the look that a layer has at a frame; light, ground and set-up are part of it only if they are wished."""
    values = {prop.name: value_of(document, Address(prop, layer_id), frame) for prop in LINES}
    scene = {prop.name: value_of(document, Address(prop), frame) for prop in SCENE_LINES if with_scene}
    height = height_of(document.layer(layer_id), frame)
    return Style(LocalName(name.strip()), height, MappingProxyType(values), MappingProxyType(scene))
