"""How the inspector groups properties: which section each is in, their order, and what of it is used every day."""

from collections.abc import Mapping
from enum import Enum
from types import MappingProxyType
from typing import Final

from PySide6.QtCore import QCoreApplication

from kagezou.document import properties
from kagezou.document import set_properties as of_set
from kagezou.document.figure_properties import HOLD, LEAST_PART, LIFT_LINES, PLACEMENT_LINES, SHADOWS_UNITE
from kagezou.document.property import AnyProperty, Scope


class Group(Enum):
    """A section of the inspector, in the order in which they stand: the light first."""

    LIGHT = "light"
    GROUND = "ground"
    PIECE_PLACE = "piece.place"
    PIECE_DOES = "piece.does"
    SET_SHADOW = "set.shadow"
    CHARACTER = ""
    SHADOW = "shadow"
    SHAPE = "shape"
    FADING = "fading"
    JUMP = "jump"
    CONTACT = "contact"
    REFLECTION = "reflection"
    WAVES = "waves"
    PLACEMENT = "placement"
    CAMERA = "camera"
    BACKGROUND = "background"

    @property
    def title(self) -> str:
        """What stands over the section, in the language of the window."""
        return QCoreApplication.translate("Inspector", _TITLES[self])


def translate(_context: str, text: str) -> str:
    """Mark a text for the translators where it is written, to be translated where it is shown."""
    return text


_TITLES: Final[Mapping[Group, str]] = MappingProxyType({
    Group.LIGHT: translate("Inspector", "Light"),
    Group.GROUND: translate("Inspector", "Ground"),
    Group.PIECE_PLACE: translate("Inspector", "Place and size"),
    Group.PIECE_DOES: translate("Inspector", "What it does"),
    Group.SET_SHADOW: translate("Inspector", "Shadow of the set"),
    Group.CHARACTER: translate("Inspector", "Character"),
    Group.SHADOW: translate("Inspector", "Shadow"),
    Group.SHAPE: translate("Inspector", "Shape"),
    Group.FADING: translate("Inspector", "Fading"),
    Group.JUMP: translate("Inspector", "In a jump"),
    Group.CONTACT: translate("Inspector", "Contact with the ground"),
    Group.REFLECTION: translate("Inspector", "Reflection"),
    Group.WAVES: translate("Inspector", "Waves"),
    Group.PLACEMENT: translate("Inspector", "Placement"),
    Group.CAMERA: translate("Inspector", "Camera"),
    Group.BACKGROUND: translate("Inspector", "Background"),
})  # fmt: skip

OPEN_AT_FIRST: Final = frozenset({
    Group.LIGHT, Group.GROUND, Group.PIECE_PLACE, Group.PIECE_DOES, Group.CHARACTER, Group.SHADOW, Group.SHAPE,
})  # fmt: skip
"""Sections that are open before anyone opened or closed one; of the others nothing is set in most cuts."""

_SHAPE = (
    properties.SIMPLIFY_ON, properties.SIMPLIFY, properties.DISTANCE, properties.ELONGATION, HOLD, LEAST_PART,
    properties.GROW, properties.SOFTNESS, properties.PENUMBRA,
)  # fmt: skip
_FADING = (properties.FADE, properties.FADE_CURVE, properties.TIP_COLOR, properties.TIP_DISTANCE)
_SHADOW_OF_SET = (of_set.SET_COLOR, of_set.SET_OPACITY, of_set.SET_BLEND)
_DOES = (of_set.PIECE_PRESENT, of_set.PIECE_RECEIVES, of_set.PIECE_BLOCKS, of_set.PIECE_CASTS)

_GROUPS: Final[Mapping[Group, tuple[AnyProperty, ...]]] = MappingProxyType({
    Group.PLACEMENT: PLACEMENT_LINES, Group.SHAPE: _SHAPE, Group.FADING: _FADING, Group.JUMP: LIFT_LINES,
    Group.LIGHT: (SHADOWS_UNITE,), Group.SET_SHADOW: _SHADOW_OF_SET,
})  # fmt: skip
"""Sections whose lines are not told by the names of their properties."""

_RARE: Final = frozenset({
    "light.overhead_radius", "light.overhead_simplify", "light.step", "scene.shadows_unite",
    "receives", "upright",
    "shadow.timing", "shadow.matte", "shadow.painted", "shadow.edges",
    "shadow.elongation", "shadow.hold", "shadow.least_part", "shadow.penumbra",
    "shadow.wave_anchor", "shadow.wave_seed", "shadow.slits", "shadow.slit_spacing", "shadow.slit_growth",
})  # fmt: skip
_RARE_ENDINGS: Final = (".sideways", ".depth", ".sideways_shear", ".depth_shear")


def group_of(prop: AnyProperty) -> Group:
    """Return which section a property is shown in."""
    if prop.scope is Scope.PIECE:
        return Group.PIECE_DOES if prop in _DOES else Group.PIECE_PLACE
    for group, lines in _GROUPS.items():
        if prop in lines:
            return group
    name, _, last = prop.name.rpartition(".")
    return Group.WAVES if last.startswith(("wave", "slit")) or name.startswith("shadow.wave") else Group(name)


def is_rare(prop: AnyProperty) -> bool:
    """Whether a property stands behind the others of its section, out of sight until it is asked for or set."""
    if prop.scope is Scope.PIECE:
        return False
    return prop.name in _RARE or prop.name.startswith("shadow.wave2.") or prop.name.endswith(_RARE_ENDINGS)
