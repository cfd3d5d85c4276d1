"""The lines of the table about what a figure has beside its shadow: patches of contact, and its reflection."""

from typing import Final

from kagezou.document.property import AnyProperty, Kind, Property, Scope
from kagezou.message import Message

CONTACT_STRENGTH = Property(
    "contact.strength", Kind.NUMBER, Scope.LAYER, 0.0,
    Message("Contact"),
    Message("Opacity of a small dark patch under each foot on the ground, in the colour of the shadow; 0 is none."),
    low=0.0, high=1.0, slides=(0.0, 1.0),
)  # fmt: skip
CONTACT_SIZE = Property(
    "contact.size", Kind.NUMBER, Scope.LAYER, 1.0,
    Message("Contact size"),
    Message("How wide each patch is; 1 is a tenth of the figure's height, about a shoe."),
    low=0.1, high=10.0, slides=(0.3, 3.0),
)  # fmt: skip
CONTACT_SOFTNESS = Property(
    "contact.softness", Kind.NUMBER, Scope.LAYER, 0.6,
    Message("Contact softness"),
    Message("How soft the edge of each patch is; 0 is crisp, 1 fades from its middle."),
    low=0.0, high=1.0, slides=(0.0, 1.0),
)  # fmt: skip

REFLECTION_OPACITY = Property(
    "reflection.opacity", Kind.NUMBER, Scope.LAYER, 0.0,
    Message("Reflection"),
    Message("Opacity of the figure mirrored in the ground, moved by the waves of its shadow; 0 is none."),
    low=0.0, high=1.0, slides=(0.0, 1.0),
)  # fmt: skip
REFLECTION_TONE = Property(
    "reflection.tone", Kind.NUMBER, Scope.LAYER, 0.0,
    Message("Reflection tone"),
    Message("0 keeps the figure's own colours, 1 has the colour of the reflection alone."),
    low=0.0, high=1.0, slides=(0.0, 1.0),
)  # fmt: skip
REFLECTION_COLOR = Property(
    "reflection.color", Kind.COLOR, Scope.LAYER, "#3A5A7A",
    Message("Reflection colour"),
    Message("Colour that the reflection takes on, sRGB."),
)  # fmt: skip
REFLECTION_FADE = Property(
    "reflection.fade", Kind.NUMBER, Scope.LAYER, 0.0,
    Message("Reflection fade"),
    Message("At this distance from the feet the reflection has faded away; 0 does not fade."),
    unit="px", low=0.0, high=10000.0, slides=(0.0, 2000.0),
)  # fmt: skip
REFLECTION_UPRIGHT = Property(
    "reflection.upright", Kind.NUMBER, Scope.LAYER, 1.0,
    Message("Reflection upright"),
    Message("1 mirrors the figure as a body that stands up from the ground, 0 as the card that casts its shadow."),
    low=0.0, high=1.0, slides=(0.0, 1.0),
)  # fmt: skip

CONTACT_LINES: Final[tuple[AnyProperty, ...]] = (CONTACT_STRENGTH, CONTACT_SIZE, CONTACT_SOFTNESS)
REFLECTION_LINES: Final[tuple[AnyProperty, ...]] = (
    REFLECTION_OPACITY, REFLECTION_TONE, REFLECTION_COLOR, REFLECTION_FADE, REFLECTION_UPRIGHT,
)  # fmt: skip
