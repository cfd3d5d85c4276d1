"""The body's tilt: a lever over the head that points where the figure faces.

It is seen as from slightly above: its end swings on a flat arc, sideways by the sine of the tilt. It stands at the
figure, over the vertical about which that turns: the one of its own feet where it has some. With two grounding points
the tilt is measured; then the lever is only shown.
"""

from math import asin, cos, degrees, radians, sin

from kagezou.document import properties
from kagezou.document.model import Document
from kagezou.geometry.card import MAX_SLOPE_DEG
from kagezou.geometry.sight import seen
from kagezou.geometry.vectors import Point2
from kagezou.tools.drag import Aim
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.handle import Cursor, Guide, GuideKind, Handle, HandleShape

TILT = "tilt.lever"

ARM_VIEW_PX = 70.0
ABOVE_HEAD_VIEW_PX = 44.0
SQUASH = 0.35
"""How flat the arc is seen."""

_ARC_POINTS = 25


def handles(geometry: FrameGeometry) -> tuple[Handle, ...]:
    """Return the lever's end where the tilt can be set."""
    if geometry.layer is None or geometry.card is None or geometry.card.is_tilt_measured:
        return ()
    return (
        Handle(
            TILT, HandleShape.LEVER, _end(geometry, geometry.value(properties.TILT)), geometry.address(properties.TILT),
            properties.TILT.label, Cursor.HORIZONTAL, layer_id=geometry.layer.id,
        ),
    )  # fmt: skip


def guides(geometry: FrameGeometry) -> tuple[Guide, ...]:
    """Return the lever's arm and the arc of its end; for a card folded more than once there is no one tilt."""
    card = geometry.card
    if card is None or (card.is_tilt_measured and len(card.pieces) > 1):
        return ()
    arc = (-MAX_SLOPE_DEG + 2 * MAX_SLOPE_DEG * step / (_ARC_POINTS - 1) for step in range(_ARC_POINTS))
    return (
        Guide(GuideKind.TILT_ARC, tuple(_end(geometry, angle) for angle in arc)),
        Guide(GuideKind.TILT_ARM, (_pivot(geometry), _end(geometry, card.tilt_deg))),
    )


def move_tilt(geometry: FrameGeometry, _handle: Handle, aim: Aim) -> Document:
    """Turn the body so that the lever's end lies under the hand, in x."""
    away = aim.target[0] - _pivot(geometry)[0]
    part = away / geometry.view.canvas_length(ARM_VIEW_PX)
    tilt = -degrees(asin(min(max(part, -1.0), 1.0)))
    return geometry.edited(properties.TILT, aim.angle_or_zero(tilt, abs(away), geometry))


def _pivot(geometry: FrameGeometry) -> Point2:
    """Return where the vertical that the card turns about passes over the head, kept at the figure and in the picture.

    A figure on the ground line may turn about a vertical far away from it.
    """
    figure, canvas, canvas_length = geometry.figure_box, geometry.document.canvas, geometry.view.canvas_length
    axis = None if geometry.card is None else geometry.card.axis
    x = min(max(seen(geometry.camera, axis or geometry.contact)[0], figure.left), figure.right)
    y = figure.top - canvas_length(ABOVE_HEAD_VIEW_PX)
    room = canvas_length(ABOVE_HEAD_VIEW_PX / 2)
    return (min(max(x, 0.0), float(canvas.width_px)), max(min(y, canvas.height_px - room), room))


def _end(geometry: FrameGeometry, tilt_deg: float) -> Point2:
    x, y = _pivot(geometry)
    arm, angle = geometry.view.canvas_length(ARM_VIEW_PX), radians(tilt_deg)
    return (x - arm * sin(angle), y + SQUASH * arm * cos(angle))
