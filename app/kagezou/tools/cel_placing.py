"""A cel on the picture: moved as a whole, scaled at its corners, turned outside of them, about an anchor."""

from math import atan2, degrees, hypot
from typing import Final

import numpy as np

from kagezou.document.figure_properties import ANCHOR, POSITION, ROTATION, SCALE
from kagezou.document.model import Document, drawing_offset, drawing_size
from kagezou.geometry.box import Box, centred_offset
from kagezou.geometry.placement import Placement
from kagezou.geometry.vectors import Point2
from kagezou.message import Message
from kagezou.scene.placing import whole_placement
from kagezou.tools.drag import SNAP_VIEW_PX, STEP_DEG, Aim
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.handle import Cursor, Guide, GuideKind, Handle, HandleShape

ANCHOR_POINT: Final = "cel.anchor"
CORNER: Final = "cel.corner"
TURN: Final = "cel.turn"
MOVE: Final = "cel.move"

OUTSIDE_VIEW_PX: Final = 24.0
"""How far outside of a corner the handle lies that turns the cel."""

_LEAST_WAY_PX: Final = 1.0
_SCALE_LABEL, _TURN_LABEL = Message("Scale of the cel"), Message("Turn of the cel")
_SIDES: Final = ((0, 0), (1, 0), (1, 1), (0, 1))


def handles(geometry: FrameGeometry) -> tuple[Handle, ...]:
    """Return the corners of the drawing shown, what turns it, and its anchor."""
    if geometry.layer is None or geometry.layer.cels.drawing_at(geometry.frame) is None:
        return ()
    layer_id, placement = geometry.layer.id, _placement(geometry)
    scale, turn = geometry.address(SCALE), geometry.address(ROTATION)
    made = []
    for index, at in enumerate(_corners(geometry)):
        out = _outward(geometry, at)
        made.append(
            Handle(
                f"{TURN}.{index}",
                HandleShape.TURN,
                out,
                turn,
                _TURN_LABEL,
                Cursor.ROTATE,
                layer_id=layer_id,
            )
        )
        made.append(Handle(f"{CORNER}.{index}", HandleShape.SQUARE, at, scale, _SCALE_LABEL, layer_id=layer_id))
    anchor = Handle(
        ANCHOR_POINT,
        HandleShape.ANCHOR,
        placement.position,
        geometry.address(ANCHOR),
        ANCHOR.label,
        also=(geometry.address(POSITION),),
        layer_id=layer_id,
        stays_in_view=True,
    )
    return (*made, anchor)  # fmt: skip


def guides(geometry: FrameGeometry) -> tuple[Guide, ...]:
    """Return the frame around the drawing shown."""
    if geometry.layer is None or geometry.layer.cels.drawing_at(geometry.frame) is None:
        return ()
    return (Guide(GuideKind.CEL_FRAME, _corners(geometry), closed=True),)


def mover(geometry: FrameGeometry, canvas_px: Point2) -> Handle | None:
    """Return the handle that moves the whole cel, where the hand is within its frame."""
    if geometry.layer is None or geometry.layer.cels.drawing_at(geometry.frame) is None:
        return None
    placement = _placement(geometry)
    if not placement.is_seen:
        return None
    x, y, _ = placement.centred_from_canvas() @ (*canvas_px, 1.0)
    box = _box(geometry)
    if not (box.left <= x <= box.right and box.top <= y <= box.bottom):
        return None
    address = geometry.address(POSITION)
    return Handle(MOVE, HandleShape.PEG, placement.position, address, POSITION.label, layer_id=geometry.layer.id)


def move_cel(geometry: FrameGeometry, _handle: Handle, aim: Aim) -> Document:
    """Move the cel as far as the hand goes; constrained along one axis of the picture."""
    return geometry.edited(POSITION, aim.straightened((1.0, 0.0)).target)


def move_anchor(geometry: FrameGeometry, _handle: Handle, aim: Aim) -> Document:
    """Put the anchor under the hand; the drawing stays where it is seen."""
    placement, target = _placement(geometry), aim.straightened((1.0, 0.0)).target
    if not placement.is_seen or geometry.layer is None:
        return geometry.document
    x, y, _ = placement.centred_from_canvas() @ (*target, 1.0)
    left, top = drawing_offset(geometry.document.canvas, geometry.layer)
    document = geometry.edited(ANCHOR, (float(x) - left, float(y) - top))
    return geometry.edited(POSITION, target, document)


def move_corner(geometry: FrameGeometry, handle: Handle, aim: Aim) -> Document:
    """Scale the cel about its anchor so that a corner lies under the hand; constrained it keeps its proportions."""
    placement = _placement(geometry)
    corner = _box_corner(_box(geometry), int(handle.id.rpartition(".")[2]))
    way = (corner[0] - placement.anchor[0], corner[1] - placement.anchor[1])
    # The hand as seen without the turn: then each axis has a scale of its own.
    straight = Placement((0.0, 0.0), placement.position, rotation_deg=-placement.rotation_deg)
    hand = straight.placed(aim.target)
    sx, sy = placement.scale
    if aim.modifiers.constrain:
        before = (way[0] * sx, way[1] * sy)
        length = before[0] ** 2 + before[1] ** 2
        grown = (hand[0] * before[0] + hand[1] * before[1]) / length if length >= _LEAST_WAY_PX else 1.0
        scale = (sx * grown, sy * grown)
    else:
        scale = (
            hand[0] / way[0] if abs(way[0]) >= _LEAST_WAY_PX else sx,
            hand[1] / way[1] if abs(way[1]) >= _LEAST_WAY_PX else sy,
        )
    return geometry.edited(SCALE, (scale[0] * 100, scale[1] * 100))


def move_turn(geometry: FrameGeometry, handle: Handle, aim: Aim) -> Document:
    """Turn the cel about its anchor after the hand, often round if need be; constrained in steps."""
    x, y = _placement(geometry).position
    was, now = (atan2(at[1] - y, at[0] - x) for at in (handle.canvas_px, aim.target))
    turned = geometry.value(ROTATION) + (degrees(now - was) + 180) % 360 - 180
    shown = geometry.value(ROTATION, aim.shown)
    turned += 360 * round((shown - turned) / 360)
    if aim.modifiers.constrain:
        turned = round(turned / STEP_DEG) * STEP_DEG
    else:
        turned = _snapped(geometry, aim, turned, hypot(aim.target[0] - x, aim.target[1] - y))
    return geometry.edited(ROTATION, turned)


def _snapped(geometry: FrameGeometry, aim: Aim, turned: float, arm_px: float) -> float:
    """Return an angle, or the upright one that it nearly is."""
    level = round(turned / 90) * 90.0
    miss = abs(np.radians(turned - level)) * arm_px
    return level if aim.modifiers.snap and miss <= geometry.view.canvas_length(SNAP_VIEW_PX) else turned


def _placement(geometry: FrameGeometry) -> Placement:
    assert geometry.layer is not None
    return whole_placement(geometry.document, geometry.layer, geometry.frame)


def _box(geometry: FrameGeometry) -> Box:
    """Return the opaque part of the drawing shown as it lies centred on the canvas."""
    assert geometry.layer is not None
    canvas, drawing = geometry.document.canvas, geometry.layer.cels.drawing_at(geometry.frame)
    if drawing is None or drawing.figure is None:
        return geometry.layer.figure
    return drawing.figure.moved(*centred_offset(canvas.box, *drawing_size(canvas, drawing)))


def _corners(geometry: FrameGeometry) -> tuple[Point2, ...]:
    placement, box = _placement(geometry), _box(geometry)
    return tuple(placement.placed(_box_corner(box, index)) for index in range(4))


def _box_corner(box: Box, index: int) -> Point2:
    x, y = _SIDES[index]
    return (float(box.right if x else box.left), float(box.bottom if y else box.top))


def _outward(geometry: FrameGeometry, corner: Point2) -> Point2:
    """Return the place outside of a corner, away from the middle of the frame."""
    xs, ys = zip(*_corners(geometry), strict=True)
    away = (corner[0] - sum(xs) / 4, corner[1] - sum(ys) / 4)
    length = max(hypot(*away), 1e-9)
    reach = geometry.view.canvas_length(OUTSIDE_VIEW_PX)
    return (corner[0] + away[0] / length * reach, corner[1] + away[1] / length * reach)
