"""The lines of the property table for set pieces: ``set.NAME.*``, and the look of the set's own shadow."""

from kagezou.document.property import AnyProperty, Kind, Property, Scope
from kagezou.geometry.sets.measures import PieceKind
from kagezou.message import Message

UP_AXES = ("y", "z")
DISPLAYS = ("none", "wireframe", "clay")

GROUND_RECEIVES = Property(
    "ground.receives", Kind.SWITCH, Scope.DOCUMENT, True,  # noqa: FBT003 - a default, named by its column
    Message("Flat ground"),
    Message("Whether shadows fall on the flat ground; off where an imported set is all there is."),
)  # fmt: skip

PIECE_KIND = Property(
    "kind", Kind.CHOICE, Scope.PIECE, "wall",
    Message("Shape"),
    Message("What the piece is; it keeps its place and its measures."),
    choices=tuple(kind.value for kind in PieceKind),
)  # fmt: skip
PIECE_PRESENT = Property(
    "present", Kind.SWITCH, Scope.PIECE, True,  # noqa: FBT003 - a default, named by its column
    Message("In the set"),
    Message("Whether the piece is there at all."),
)  # fmt: skip
PIECE_POSITION = Property(
    "position", Kind.POINT, Scope.PIECE, (0.0, 0.0),
    Message("Place"),
    Message("The point of the ground on which the middle of the piece stands, as it is seen on the canvas."),
    unit="px",
)  # fmt: skip
PIECE_ANGLE = Property(
    "angle", Kind.NUMBER, Scope.PIECE, 0.0,
    Message("Turn"),
    Message("Turn about the vertical of the ground; at 0 the front is the viewer's side."),
    unit="°", low=-36000.0, high=36000.0, slides=(-180.0, 180.0),
)  # fmt: skip
PIECE_LEAN = Property(
    "lean", Kind.NUMBER, Scope.PIECE, 0.0,
    Message("Lean"),
    Message("How far a wall leans back; below 0 it leans over its front."),
    unit="°", low=-80.0, high=80.0, slides=(-60.0, 60.0),
)  # fmt: skip
PIECE_WIDTH = Property(
    "width", Kind.NUMBER, Scope.PIECE, 400.0,
    Message("Width"),
    Message("Canvas px at the depth where the piece stands; of a cylinder or a sphere the diameter."),
    unit="px", low=1.0, high=100000.0, slides=(1.0, 2000.0),
)  # fmt: skip
PIECE_HEIGHT = Property(
    "height", Kind.NUMBER, Scope.PIECE, 300.0,
    Message("Height"),
    Message("Canvas px at the depth where the piece stands; a sphere is as high as it is wide."),
    unit="px", low=1.0, high=100000.0, slides=(1.0, 2000.0),
)  # fmt: skip
PIECE_DEPTH = Property(
    "depth", Kind.NUMBER, Scope.PIECE, 200.0,
    Message("Depth"),
    Message("From front to back on the ground, canvas px at the depth where the piece stands: "
            "of boxes, steps and ramps."),
    unit="px", low=1.0, high=100000.0, slides=(1.0, 2000.0),
)  # fmt: skip
PIECE_COUNT = Property(
    "count", Kind.NUMBER, Scope.PIECE, 4.0,
    Message("Steps"),
    Message("How many steps there are; taken as a whole number."),
    low=1.0, high=40.0, slides=(1.0, 20.0),
)  # fmt: skip
PIECE_RECEIVES = Property(
    "receives", Kind.SWITCH, Scope.PIECE, True,  # noqa: FBT003 - a default, named by its column
    Message("Receives"),
    Message("Whether the characters' shadows fall on it; it hides what is behind it in either case."),
)  # fmt: skip
PIECE_BLOCKS = Property(
    "blocks", Kind.SWITCH, Scope.PIECE, True,  # noqa: FBT003 - a default, named by its column
    Message("Blocks light"),
    Message("Whether the characters' shadows end where this piece takes the light."),
)  # fmt: skip
PIECE_CASTS = Property(
    "casts", Kind.SWITCH, Scope.PIECE, False,  # noqa: FBT003 - a default, named by its column
    Message("Casts a shadow"),
    Message("Whether its own shadow is drawn, on itself, the ground and the other pieces; it then blocks light too."),
)  # fmt: skip

PIECE_SCALE = Property(
    "scale", Kind.NUMBER, Scope.PIECE, 100.0,
    Message("Scale"),
    Message("Of an imported set: canvas px for one unit of the file, at the depth where it stands."),
    unit="px", low=1e-6, high=1e6,
)  # fmt: skip
PIECE_UP = Property(
    "up", Kind.CHOICE, Scope.PIECE, "y",
    Message("Up axis"),
    Message("Which axis of the file of an imported set points up."),
    choices=UP_AXES,
)  # fmt: skip
PIECE_ANCHOR = Property(
    "anchor", Kind.PLACE, Scope.PIECE, (0.0, 0.0, 0.0),
    Message("Anchor"),
    Message("The point of an imported set, in the units of its file, that stands on the ground at the piece's place."),
)  # fmt: skip
PIECE_DISPLAY = Property(
    "display", Kind.CHOICE, Scope.PIECE, "wireframe",
    Message("Drawn as"),
    Message("How an imported set is drawn: not at all, as a wireframe in the window only, "
            "or as clay in composites too."),
    choices=DISPLAYS,
)  # fmt: skip
PIECE_UNDER = Property(
    "under", Kind.SWITCH, Scope.PIECE, False,  # noqa: FBT003 - a default, named by its column
    Message("Under the background"),
    Message("Whether an imported set is drawn under the background picture rather than over it."),
)  # fmt: skip

SET_COLOR = Property(
    "set.shadow.color", Kind.COLOR, Scope.DOCUMENT, "#20203A",
    Message("Set shadow colour"),
    Message("Colour of the shadow that set pieces cast, sRGB."),
)  # fmt: skip
SET_OPACITY = Property(
    "set.shadow.opacity", Kind.NUMBER, Scope.DOCUMENT, 0.6,
    Message("Set shadow opacity"),
    Message("Opacity of the shadow that set pieces cast, 0 to 1."),
    low=0.0, high=1.0, slides=(0.0, 1.0),
)  # fmt: skip
SET_BLEND = Property(
    "set.shadow.blend", Kind.CHOICE, Scope.DOCUMENT, "multiply",
    Message("Set shadow blend"),
    Message("How the shadow that set pieces cast lies on what is under it."),
    choices=("multiply", "normal"),
)  # fmt: skip

SET_LINES: tuple[AnyProperty, ...] = (
    GROUND_RECEIVES, SET_COLOR, SET_OPACITY, SET_BLEND,
    PIECE_KIND, PIECE_PRESENT, PIECE_POSITION, PIECE_ANGLE, PIECE_LEAN,
    PIECE_WIDTH, PIECE_HEIGHT, PIECE_DEPTH, PIECE_COUNT,
    PIECE_RECEIVES, PIECE_BLOCKS, PIECE_CASTS,
    PIECE_SCALE, PIECE_UP, PIECE_ANCHOR, PIECE_DISPLAY, PIECE_UNDER,
)  # fmt: skip
"""Every line of the set, in the order in which people read them."""
