"""Handles and guides as plain values, and which handle the hand means."""

from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum
from math import hypot

from kagezou.document.address import Address
from kagezou.geometry.vectors import Point2
from kagezou.message import Message
from kagezou.tools.view import CanvasView

HIT_RADIUS_PX = 10.0
"""How far from its middle a handle can be taken hold of with a mouse, logical view px."""

PEN_HIT_RADIUS_PX = 14.0
"""The same for a pen or a finger."""

EDGE_MARGIN_PX = 18.0
"""How far inside the viewport's edge a handle is shown that lies outside, logical view px."""


class HandleShape(StrEnum):
    """What a handle looks like; the shape tells its kind."""

    SUN_DISC = "sun-disc"
    """The lamp."""
    FOOT = "foot"
    """The lamp's foot on the ground."""
    DIAL = "dial"
    """The sun on its dial."""
    CROSS = "cross"
    """The ground's position."""
    SQUARE = "square"
    """An end of the ground line."""
    LEVER = "lever"
    """The end of an arm that turns something."""
    DIAMOND = "diamond"
    """A grounding point."""
    RING = "ring"
    """The tip of the shadow."""
    ARROW = "arrow"
    """The end of a wave's arrow."""
    PEG = "peg"
    """Where a set piece stands."""
    GRIP = "grip"
    """A side of a set piece."""
    SOLE = "sole"
    """A foot that carries."""
    SOLE_LIFTED = "sole-lifted"
    """A foot in the air."""
    GROUND_MARK = "ground-mark"
    """The ground below a foot in the air."""
    TURN = "turn"
    """Outside of a corner: turns a cel."""
    ANCHOR = "anchor"
    """The point about which a cel is turned and scaled."""


class Cursor(StrEnum):
    """Which way a handle can be moved."""

    MOVE = "move"
    HORIZONTAL = "horizontal"
    VERTICAL = "vertical"
    ROTATE = "rotate"


@dataclass(frozen=True, slots=True)
class Handle:
    """Something on the canvas a hand can take hold of.

    Parameters
    ----------
    id
        Stable while the same thing is edited: ``light.lamp``, ``light.foot``, ``light.sun``, ``light.overhead``,
        ``ground.position``, ``ground.end``, ``ground.declination``, ``tilt.lever``, ``shadow.tip``,
        ``filter.distance``, ``filter.wave1``, ``filter.wave2``, ``grounding.0``, ``grounding.1`` …,
        ``match.horizon``, ``match.horizon_end``, ``match.end.0`` …; of the set piece worked on ``piece.position``,
        ``piece.turn``, ``piece.width``, ``piece.depth``, ``piece.height``, ``piece.lean``; of the figure worked on
        ``foot.0`` …, ``foot_ground.0`` …; while a cel is transformed ``cel.anchor``, ``cel.corner.0`` …,
        ``cel.turn.0`` …, ``cel.move``.
    shape
        Its look, of constant size on screen.
    canvas_px
        Its middle.
    address
        The property it edits, for key marks and menus.
    label
        Its name for people.
    cursor
        Which way it can be moved.
    also
        Further properties it edits.
    layer_id, piece_id
        The layer or set piece it was made for.
    index
        Its place in a list of points; of a foot its track in the figure.
    stays_in_view
        Whether it is shown at the viewport's edge while it lies outside.
    """

    id: str
    shape: HandleShape
    canvas_px: Point2
    address: Address | None
    label: Message
    cursor: Cursor = Cursor.MOVE
    also: tuple[Address, ...] = ()
    layer_id: str | None = None
    index: int | None = None
    stays_in_view: bool = False
    piece_id: str | None = None

    @property
    def addresses(self) -> tuple[Address, ...]:
        """Every property the handle edits."""
        return (*((self.address,) if self.address else ()), *self.also)


class GuideKind(StrEnum):
    """What a guide line shows."""

    GROUND_LINE = "ground-line"
    GROUND_OUTLINE = "ground-outline"
    """A square of the ground around its position, which shows declination and roll."""
    DECLINATION = "declination"
    LAMP_TO_FOOT = "lamp-to-foot"
    FOOT_TO_CONTACT = "foot-to-contact"
    OVERHEAD_AREA = "overhead-area"
    """Within it a lamp above is spread into four."""
    SUN_DIAL = "sun-dial"
    """The dial's rim: elevation 0."""
    SUN_RAY = "sun-ray"
    TILT_ARC = "tilt-arc"
    TILT_ARM = "tilt-arm"
    CARD_FOOT = "card-foot"
    """Where the card meets the ground through the grounding points."""
    SHADOW_RAY = "shadow-ray"
    """From the head to the tip of its shadow."""
    FILTER_DISTANCE = "filter-distance"
    """Across the shadow, where simplifying is at its full strength."""
    WAVE = "wave"
    """From crest to crest."""
    PIECE_EDGE = "piece-edge"
    """An edge of the set piece worked on."""
    PIECE_HIDDEN = "piece-hidden"
    """The same where the piece itself hides it."""
    PIECE_TOUCHED = "piece-touched"
    """An edge of the set piece under the pointer."""
    PIECE_OTHER = "piece-other"
    """An edge of another piece of the set."""
    PIECE_FLOOR = "piece-floor"
    """Where another piece meets the ground."""
    PIECE_ARM = "piece-arm"
    """From where a piece stands out of its front."""
    LEAN_ARM = "lean-arm"
    """A wall seen from its side."""
    LEAN_ARC = "lean-arc"
    FLOOR_FIRST = "floor-first"
    """An edge of the floor in the background picture."""
    FLOOR_SECOND = "floor-second"
    """One square to it."""
    FLOOR_RAY = "floor-ray"
    """From an edge to where it vanishes."""
    HORIZON = "horizon"
    FOOT_HEIGHT = "foot-height"
    """From a lifted foot down to the ground below it."""
    CEL_FRAME = "cel-frame"
    """Around the drawing that is transformed."""


@dataclass(frozen=True, slots=True)
class Guide:
    """A line that explains: a polyline in canvas px, perhaps closed. It cannot be taken hold of."""

    kind: GuideKind
    points: tuple[Point2, ...]
    closed: bool = False


@dataclass(frozen=True, slots=True)
class HandleSet:
    """What lies over the picture, in drawing order: the last handle is topmost."""

    handles: tuple[Handle, ...] = ()
    guides: tuple[Guide, ...] = ()
    note: Message | None = None
    """What keeps the handles from having an effect now."""

    def find(self, handle_id: str | None) -> Handle | None:
        """Return the handle with this id, None where it is not shown now."""
        return next((handle for handle in self.handles if handle.id == handle_id), None)


@dataclass(frozen=True, slots=True)
class OffView:
    """Where a handle outside the viewport is shown instead.

    Parameters
    ----------
    view_px
        The place at the edge, logical view px.
    direction
        Unit vector from there toward the true place, for the arrow.
    distance_px
        How far away the true place is, logical view px.
    """

    view_px: Point2
    direction: Point2
    distance_px: float


def clamped(view_px: Point2, view_size: Point2, margin_px: float = EDGE_MARGIN_PX) -> OffView | None:
    """Return the place at the viewport's edge for something outside it, or None for what is seen.

    The margin applies to the place at the edge only: what is within the viewport, even in the margin, stays.
    """
    if all(0 <= at <= size for at, size in zip(view_px, view_size, strict=True)):
        return None
    x, y = (
        min(max(at, min(margin_px, size / 2)), max(size - margin_px, size / 2))
        for at, size in zip(view_px, view_size, strict=True)
    )
    distance = hypot(view_px[0] - x, view_px[1] - y)
    return OffView((x, y), ((view_px[0] - x) / distance, (view_px[1] - y) / distance), distance)


def place_in_view(handle: Handle, view: CanvasView, view_size: Point2 | None) -> tuple[Point2, OffView | None]:
    """Return where a handle is drawn and hit, view px, and how it was moved to the edge if it was."""
    view_px = view.view_from_canvas(handle.canvas_px)
    off = clamped(view_px, view_size) if handle.stays_in_view and view_size is not None else None
    return (off.view_px if off else view_px, off)


def hit(
    handles: Iterable[Handle],
    view: CanvasView,
    view_px: Point2,
    radius: float = HIT_RADIUS_PX,
    view_size: Point2 | None = None,
) -> Handle | None:
    """Return the nearest handle within ``radius`` view px, the topmost of equally near ones.

    With a ``view_size``, handles that stay in view are looked for at the edge where they are shown.
    """
    best: Handle | None = None
    nearest = radius
    for handle in handles:
        x, y = place_in_view(handle, view, view_size)[0]
        distance = hypot(x - view_px[0], y - view_px[1])
        if distance <= nearest:
            best, nearest = handle, distance
    return best
