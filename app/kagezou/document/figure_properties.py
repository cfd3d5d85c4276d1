"""The properties of where a figure is and how it stands: lines of the one table, see ``properties``."""

from typing import Final

from kagezou.document.property import AnyProperty, Kind, Property, Scope, Usual
from kagezou.message import Message

SHADOWS_UNITE = Property(
    "scene.shadows_unite", Kind.SWITCH, Scope.DOCUMENT, True,  # noqa: FBT003 - a default, named by its column
    Message("Shadows unite"),
    Message("Whether shadows of like look unite where they meet; else each darkens what the others left."),
)  # fmt: skip

BACKGROUND_POSITION = Property(
    "background.position", Kind.POINT, Scope.DOCUMENT, (0.0, 0.0),
    Message("Background position"),
    Message("Where the middle of the background lies on the canvas: keyed, it pans."),
    unit="px", usual=Usual.CANVAS_MIDDLE,
)  # fmt: skip

POSITION = Property(
    "position", Kind.POINT, Scope.LAYER, (0.0, 0.0),
    Message("Position"),
    Message("Where the anchor of the layer's drawings lies on the canvas."),
    unit="px", usual=Usual.CANVAS_MIDDLE,
)  # fmt: skip
ANCHOR = Property(
    "anchor", Kind.POINT, Scope.LAYER, (0.0, 0.0),
    Message("Anchor"),
    Message("The point of the drawing that is laid on the position; drawings turn and grow about it."),
    unit="px", usual=Usual.DRAWING_MIDDLE,
)  # fmt: skip
SCALE = Property(
    "scale", Kind.POINT, Scope.LAYER, (100.0, 100.0),
    Message("Scale"),
    Message("How large the drawings are; below 0 they are mirrored."),
    unit="%",
)  # fmt: skip
ROTATION = Property(
    "rotation", Kind.NUMBER, Scope.LAYER, 0.0,
    Message("Rotation"),
    Message("Turn of the drawings in the picture, clockwise."),
    unit="°", low=-36000.0, high=36000.0,
)  # fmt: skip
STANCE = Property(
    "stance", Kind.CHOICE, Scope.LAYER, "feet",
    Message("Stance"),
    Message("What the figure stands on: its feet where they were found, its grounding points, or the ground line."),
    choices=("feet", "points", "line"),
)  # fmt: skip
UPRIGHT = Property(
    "upright", Kind.NUMBER, Scope.LAYER, 0.0,
    Message("Upright"),
    Message("0 stands parallel to the screen, 1 along the ground's normal, as walls do."),
    low=0.0, high=1.0, slides=(0.0, 1.0),
)  # fmt: skip

SHAPE = Property(
    "shadow.shape", Kind.CHOICE, Scope.LAYER, "cast",
    Message("Shape"),
    Message("The shadow that the light casts, or a disc under the figure."),
    choices=("cast", "disc"),
)  # fmt: skip
PAINTED = Property(
    "shadow.painted", Kind.CHOICE, Scope.LAYER, "casts",
    Message("Painted shadow"),
    Message("Whether a shadow that is painted into the drawings, half-transparent at the base, casts with them."),
    choices=("casts", "left_out"),
)  # fmt: skip
EDGES = Property(
    "shadow.edges", Kind.CHOICE, Scope.LAYER, "smooth",
    Message("Edges"),
    Message("Smooth: anti-aliased; hard: a pixel is all shadow or none, as in pixel art, whatever the softness."),
    choices=("smooth", "hard"),
)  # fmt: skip
HOLD = Property(
    "shadow.hold", Kind.NUMBER, Scope.LAYER, 0.0,
    Message("Hold at the feet"),
    Message("How far a simplified shadow that has drawn away from the feet is slid back until it begins under them."),
    low=0.0, high=1.0, slides=(0.0, 1.0),
)  # fmt: skip
LEAST_PART = Property(
    "shadow.least_part", Kind.NUMBER, Scope.LAYER, 0.0,
    Message("Least part"),
    Message("Islands and holes of the shadow that are smaller than this are left out."),
    unit="px²", low=0.0, high=1_000_000.0, slides=(0.0, 2000.0),
)  # fmt: skip
LIFT_SHRINK = Property(
    "shadow.lift_shrink", Kind.NUMBER, Scope.LAYER, 0.3,
    Message("Shrink in a jump"),
    Message("How much of its size the shadow loses at a height of one figure over the ground."),
    low=0.0, high=1.0, slides=(0.0, 1.0),
)  # fmt: skip
LIFT_SOFTEN = Property(
    "shadow.lift_soften", Kind.NUMBER, Scope.LAYER, 0.2,
    Message("Soften in a jump"),
    Message("How much softer the shadow's edge becomes in a jump; at 1 by a quarter of the height over the ground."),
    low=0.0, high=1.0, slides=(0.0, 1.0),
)  # fmt: skip
LIFT_FADE = Property(
    "shadow.lift_fade", Kind.NUMBER, Scope.LAYER, 0.4,
    Message("Fade in a jump"),
    Message("How much of its opacity the shadow loses at a height of one figure over the ground."),
    low=0.0, high=1.0, slides=(0.0, 1.0),
)  # fmt: skip

PLACEMENT_LINES: Final[tuple[AnyProperty, ...]] = (POSITION, ANCHOR, SCALE, ROTATION)
STANCE_LINES: Final[tuple[AnyProperty, ...]] = (STANCE, UPRIGHT)
LIFT_LINES: Final[tuple[AnyProperty, ...]] = (LIFT_SHRINK, LIFT_SOFTEN, LIFT_FADE)
