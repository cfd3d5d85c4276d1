"""The one table of properties that timeline, inspector, file, command line and exporter share (spec 6).

A new property is one line here.
"""

from types import MappingProxyType

from kagezou.document.companion_properties import CONTACT_LINES, REFLECTION_LINES
from kagezou.document.figure_properties import (
    BACKGROUND_POSITION,
    EDGES,
    HOLD,
    LEAST_PART,
    LIFT_LINES,
    PAINTED,
    PLACEMENT_LINES,
    SHADOWS_UNITE,
    SHAPE,
    STANCE_LINES,
)
from kagezou.document.property import AnyProperty, Kind, Property, Scope
from kagezou.document.set_properties import SET_LINES
from kagezou.document.wave_properties import SLIT_GROWTH, SLIT_SPACING, SLITS, wave_lines
from kagezou.geometry.vectors import Point2
from kagezou.message import Message

FOV = Property(
    "camera.fov", Kind.NUMBER, Scope.DOCUMENT, 0.0,
    Message("Field of view"),
    Message("Vertical field of view of the camera; 0 is orthographic."),
    unit="°", low=0.0, high=120.0,
)  # fmt: skip
GROUND_POSITION = Property(
    "ground.position", Kind.POINT, Scope.DOCUMENT, (0.0, 0.0),
    Message("Ground position"),
    Message("A point of the ground line, where the ground meets the drawing."),
    unit="px",
)  # fmt: skip
GROUND_ROLL = Property(
    "ground.roll", Kind.NUMBER, Scope.DOCUMENT, 0.0,
    Message("Ground roll"),
    Message("Turn of the ground line in the picture."),
    unit="°", low=-90.0, high=90.0,
)  # fmt: skip
GROUND_DECLINATION = Property(
    "ground.declination", Kind.NUMBER, Scope.DOCUMENT, 60.0,
    Message("Declination"),
    Message("Angle between drawing and ground; 90 is seen edge-on, less is seen from higher."),
    unit="°", low=1.0, high=90.0,
    slides=(1.0, 90.0),
)  # fmt: skip
LIGHT_KIND = Property(
    "light.kind", Kind.CHOICE, Scope.DOCUMENT, "point",
    Message("Light"),
    Message("A lamp at a position, or the sun in a direction."),
    choices=("point", "sun"),
)  # fmt: skip
LIGHT_POSITION = Property(
    "light.position", Kind.PLACE, Scope.DOCUMENT, (0.0, -600.0, 900.0),
    Message("Light position"),
    Message("Where the lamp stands; z > 0 is on the viewer's side and throws shadows behind the character."),
    unit="px",
)  # fmt: skip
LIGHT_AZIMUTH = Property(
    "light.azimuth", Kind.NUMBER, Scope.DOCUMENT, 35.0,
    Message("Sun azimuth"),
    Message("Direction of the sun around the ground; 0 stands on the viewer's side."),
    unit="°", low=-36000.0, high=36000.0,
)  # fmt: skip
LIGHT_ELEVATION = Property(
    "light.elevation", Kind.NUMBER, Scope.DOCUMENT, 45.0,
    Message("Sun elevation"),
    Message("Height of the sun over the ground; a low sun throws long shadows."),
    unit="°", low=-90.0, high=90.0,
)  # fmt: skip
LIGHT_STEP = Property(
    "light.step", Kind.NUMBER, Scope.DOCUMENT, 0.0,
    Message("Light step"),
    Message("The lamp moves by whole steps of this length, so that pixel art does not shimmer; 0 moves freely."),
    unit="px", low=0.0, high=1000.0, slides=(0.0, 32.0),
)  # fmt: skip
OVERHEAD_RADIUS = Property(
    "light.overhead_radius", Kind.NUMBER, Scope.DOCUMENT, 0.0,
    Message("Overhead radius"),
    Message("Within this distance over the character the lamp is spread into four, so that light from straight above "
          "still casts."),
    unit="px", low=0.0, high=100000.0,
)  # fmt: skip
OVERHEAD_SIMPLIFY = Property(
    "light.overhead_simplify", Kind.NUMBER, Scope.DOCUMENT, 0.0,
    Message("Overhead simplify"),
    Message("So much at least shadows are simplified while the lamp is straight above, which joins its four to one."),
    unit="px", low=0.0, high=500.0, slides=(0.0, 200.0),
)  # fmt: skip

GROUNDING: Property[tuple[Point2, ...]] = Property(
    "grounding", Kind.POINTS, Scope.LAYER, (),
    Message("Grounding points"),
    Message("Where the character touches the ground; with two or more the card is folded through them."),
    unit="px",
)  # fmt: skip
TILT = Property(
    "tilt", Kind.NUMBER, Scope.LAYER, 0.0,
    Message("Body tilt"),
    Message("Turn of the body about the vertical; measured, not set, with two grounding points."),
    unit="°", low=-75.0, high=75.0,
)  # fmt: skip
VISIBLE = Property(
    "visible", Kind.SWITCH, Scope.LAYER, True,  # noqa: FBT003 - a default, named by its column
    Message("Visible"),
    Message("Whether the layer and its shadow are shown and rendered."),
)  # fmt: skip
RECEIVES = Property(
    "receives", Kind.SWITCH, Scope.LAYER, False,  # noqa: FBT003 - a default, named by its column
    Message("Receives shadows"),
    Message("Whether the shadows of the other characters fall on this one, where the light meets them first."),
)  # fmt: skip
MATTE = Property(
    "shadow.matte", Kind.CHOICE, Scope.LAYER, "solid",
    Message("Matte"),
    Message("Solid: half-opaque and more casts fully; translucent: alpha casts as it is (smoke, glass)."),
    choices=("solid", "translucent"),
)  # fmt: skip
SIMPLIFY = Property(
    "shadow.simplify", Kind.NUMBER, Scope.LAYER, 0.0,
    Message("Simplify"),
    Message("How far the shape is rounded toward an ellipse; its edge stays crisp and its area stays the same."),
    unit="px", low=0.0, high=500.0,
    slides=(0.0, 200.0),
)  # fmt: skip
DISTANCE = Property(
    "shadow.distance", Kind.NUMBER, Scope.LAYER, 0.0,
    Message("Distance"),
    Message("Over this distance from the feet the rounding grows to its full strength; 0 rounds everywhere alike."),
    unit="px", low=0.0, high=5000.0,
    slides=(0.0, 600.0),
)  # fmt: skip
SIMPLIFY_ON = Property(
    "shadow.simplify_on", Kind.SWITCH, Scope.LAYER, True,  # noqa: FBT003 - a default, named by its column
    Message("Simplification"),
    Message("Whether the shape is simplified; off keeps the values and leaves them out."),
)  # fmt: skip
ELONGATION = Property(
    "shadow.elongation", Kind.NUMBER, Scope.LAYER, 0.0,
    Message("Elongation"),
    Message("0 rounds toward a disc on the ground, 1 toward the shadow's own long ellipse."),
    low=0.0, high=1.0,
    slides=(0.0, 1.0),
)  # fmt: skip
GROW = Property(
    "shadow.grow", Kind.NUMBER, Scope.LAYER, 0.0,
    Message("Grow"),
    Message("Moves the outline outward, or inward below 0."),
    unit="px", low=-100.0, high=100.0,
    slides=(-20.0, 20.0),
)  # fmt: skip
SOFTNESS = Property(
    "shadow.softness", Kind.NUMBER, Scope.LAYER, 0.0,
    Message("Softness"),
    Message("Width of the edge; 0 is a crisp cel edge."),
    unit="px", low=0.0, high=200.0,
    slides=(0.0, 60.0),
)  # fmt: skip
PENUMBRA = Property(
    "shadow.penumbra", Kind.NUMBER, Scope.LAYER, 0.0,
    Message("Penumbra"),
    Message("How much wider the edge grows with every px of distance from the feet."),
    low=0.0, high=1.0,
    slides=(0.0, 0.3),
)  # fmt: skip
FADE = Property(
    "shadow.fade", Kind.NUMBER, Scope.LAYER, 0.0,
    Message("Fade"),
    Message("At this distance from the feet the shadow has faded away; 0 does not fade."),
    unit="px", low=0.0, high=10000.0,
    slides=(0.0, 2000.0),
)  # fmt: skip
FADE_CURVE = Property(
    "shadow.fade_curve", Kind.NUMBER, Scope.LAYER, 1.0,
    Message("Fade curve"),
    Message("1 fades evenly, more fades early, less fades late."),
    low=0.1, high=10.0,
    slides=(0.1, 4.0),
)  # fmt: skip
TIP_COLOR = Property(
    "shadow.tip_color", Kind.COLOR, Scope.LAYER, "#4A4A7A",
    Message("Tip colour"),
    Message("Colour toward the tip, where a tip distance is set; sRGB."),
)  # fmt: skip
TIP_DISTANCE = Property(
    "shadow.tip_distance", Kind.NUMBER, Scope.LAYER, 0.0,
    Message("Tip distance"),
    Message("At this distance from the feet the shadow has the tip colour; 0 keeps one colour."),
    unit="px", low=0.0, high=10000.0,
    slides=(0.0, 2000.0),
)  # fmt: skip
TIMING = Property(
    "shadow.timing", Kind.CHOICE, Scope.LAYER, "ones",
    Message("Shadow timing"),
    Message("On ones the shadow moves every frame; with the exposures it waits for the next drawing."),
    choices=("ones", "exposures"),
)  # fmt: skip
COLOR = Property(
    "shadow.color", Kind.COLOR, Scope.LAYER, "#20203A",
    Message("Colour"),
    Message("Colour of the shadow, sRGB."),
)  # fmt: skip
OPACITY = Property(
    "shadow.opacity", Kind.NUMBER, Scope.LAYER, 0.6,
    Message("Opacity"),
    Message("Opacity of the shadow, 0 to 1."),
    low=0.0, high=1.0,
    slides=(0.0, 1.0),
)  # fmt: skip
BLEND = Property(
    "shadow.blend", Kind.CHOICE, Scope.LAYER, "multiply",
    Message("Blend"),
    Message("How the shadow lies on what is under it."),
    choices=("multiply", "normal"),
)  # fmt: skip

WAVES_ON = Property(
    "shadow.waves_on", Kind.SWITCH, Scope.LAYER, True,  # noqa: FBT003 - a default, named by its column
    Message("Waves"),
    Message("Whether the shadow lies on water; off keeps the values and leaves them out."),
)  # fmt: skip
WAVE_SEED = Property(
    "shadow.wave_seed", Kind.NUMBER, Scope.LAYER, 0.0,
    Message("Wave seed"),
    Message("0 takes the waves as they are set; any other whole number varies them, always in the same way."),
    low=0.0, high=999999.0,
)  # fmt: skip
WAVE_ANCHOR = Property(
    "shadow.wave_anchor", Kind.NUMBER, Scope.LAYER, 0.0,
    Message("Wave anchor"),
    Message("Over this distance from the feet the waves grow to their full strength; 0 moves the feet too."),
    unit="px", low=0.0, high=5000.0,
)  # fmt: skip
WAVE1 = wave_lines(1, 60.0, 90.0, 3.0)
WAVE2 = wave_lines(2, 37.0, 70.0, 2.0)

TABLE: tuple[AnyProperty, ...] = (
    FOV, GROUND_POSITION, GROUND_ROLL, GROUND_DECLINATION,
    LIGHT_KIND, LIGHT_POSITION, LIGHT_AZIMUTH, LIGHT_ELEVATION, OVERHEAD_RADIUS, OVERHEAD_SIMPLIFY,
    LIGHT_STEP, SHADOWS_UNITE, BACKGROUND_POSITION,
    GROUNDING, TILT, *STANCE_LINES, VISIBLE, RECEIVES, *PLACEMENT_LINES, TIMING, SHAPE, MATTE, PAINTED, EDGES,
    SIMPLIFY_ON, SIMPLIFY, DISTANCE, ELONGATION, HOLD, LEAST_PART, GROW, SOFTNESS, PENUMBRA,
    COLOR, OPACITY, BLEND, FADE, FADE_CURVE, TIP_COLOR, TIP_DISTANCE, *LIFT_LINES,
    WAVES_ON, *WAVE1.all, *WAVE2.all, WAVE_ANCHOR, WAVE_SEED, SLITS, SLIT_SPACING, SLIT_GROWTH,
    *CONTACT_LINES, *REFLECTION_LINES,
    *SET_LINES,
)  # fmt: skip
"""Every property, in the order in which people read them."""

OF_DOCUMENT = MappingProxyType({prop.name: prop for prop in TABLE if prop.scope is Scope.DOCUMENT})
OF_LAYER = MappingProxyType({prop.name: prop for prop in TABLE if prop.scope is Scope.LAYER})
OF_PIECE = MappingProxyType({prop.name: prop for prop in TABLE if prop.scope is Scope.PIECE})
