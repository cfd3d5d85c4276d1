"""All handles of a frame, and the drag that belongs to each."""

from types import MappingProxyType

from kagezou.document.model import Document
from kagezou.geometry.vectors import Point2
from kagezou.tools import (
    cel_placing,
    feet,
    filters,
    ground,
    grounding,
    light,
    matching,
    overhead,
    set_piece,
    set_size,
    shadow,
    sun,
    tilt,
)
from kagezou.tools.drag import Drag, Move, dragging
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.handle import Handle, HandleSet
from kagezou.tools.pointer import Modifiers, Pointer
from kagezou.tools.view import CanvasView

_ROOMS = (ground, tilt, filters, grounding, feet, shadow, set_size, set_piece, overhead, light, sun)
"""Whose handles lie over whose: the last one's are topmost."""

_MOVES: MappingProxyType[str, Move] = MappingProxyType(
    {
        ground.POSITION: ground.move_position,
        ground.END: ground.move_end,
        ground.DECLINATION: ground.move_declination,
        tilt.TILT: tilt.move_tilt,
        grounding.GROUNDING: grounding.move_point,
        shadow.TIP: shadow.move_tip,
        filters.DISTANCE: filters.move_distance,
        filters.WAVE1: filters.move_wave,
        filters.WAVE2: filters.move_wave,
        light.FOOT: light.move_foot,
        light.LAMP: light.move_lamp,
        overhead.OVERHEAD: overhead.move_rim,
        sun.SUN: sun.move_sun,
        set_piece.POSITION: set_piece.move_position,
        set_piece.TURN: set_piece.move_turn,
        set_piece.LEAN: set_piece.move_lean,
        set_size.WIDTH: set_size.move_size,
        set_size.DEPTH: set_size.move_size,
        set_size.HEIGHT: set_size.move_size,
        feet.FOOT: feet.move_foot,
        feet.GROUND: feet.move_ground,
        cel_placing.MOVE: cel_placing.move_cel,
        cel_placing.ANCHOR_POINT: cel_placing.move_anchor,
        cel_placing.CORNER: cel_placing.move_corner,
        cel_placing.TURN: cel_placing.move_turn,
        matching.END: matching.move_end,
        matching.HORIZON: matching.move_horizon,
        matching.HORIZON_END: matching.move_horizon_end,
    }
)


def handles_of(
    document: Document, frame: int, layer_id: str | None, view: CanvasView, piece_id: str | None = None
) -> HandleSet:
    """Return what lies over the picture while a layer or a set piece is worked on, or neither is.

    The view only matters for what hangs on arms and dials of constant length on screen: sun, tilt, declination, the
    end of the ground line, and a piece's turn and lean.
    """
    geometry = FrameGeometry.of(document, frame, layer_id, view, piece_id)
    return HandleSet(
        tuple(handle for room in _ROOMS for handle in room.handles(geometry)),
        tuple(guide for room in _ROOMS for guide in room.guides(geometry)),
    )


def matching_handles_of(document: Document, frame: int, view: CanvasView) -> HandleSet:
    """Return what lies over the picture while the camera is matched to it."""
    geometry = FrameGeometry.of(document, frame, None, view)
    return HandleSet(matching.handles(geometry), matching.guides(geometry), matching.note_of(geometry))


def placing_handles_of(document: Document, frame: int, layer_id: str | None, view: CanvasView) -> HandleSet:
    """Return what lies over the picture while a cel is transformed."""
    geometry = FrameGeometry.of(document, frame, layer_id, view)
    return HandleSet(cel_placing.handles(geometry), cel_placing.guides(geometry))


def cel_mover(
    document: Document, frame: int, layer_id: str | None, view: CanvasView, canvas_px: Point2
) -> Handle | None:
    """Return the handle that moves the whole cel, where the hand is within its frame; it is not shown."""
    return cel_placing.mover(FrameGeometry.of(document, frame, layer_id, view), canvas_px)


def drag_of(handle: Handle, document: Document, frame: int, view: CanvasView) -> Drag:
    """Return the drag of a handle, ready for the press: send that first, then every move; ``close()`` cancels.

    Each answer is a whole document made of ``document``, so cancelling is showing that one again.
    """
    whole, _, number = handle.id.rpartition(".")
    name = whole if number.isdigit() else handle.id
    return dragging(FrameGeometry.of(document, frame, handle.layer_id, view, handle.piece_id), handle, _MOVES[name])


def nudge(handle: Handle, document: Document, frame: int, dx: float, dy: float, view: CanvasView) -> Document:
    """Return the document with a handle moved by canvas px, as an arrow key does; nothing snaps."""
    x, y = handle.canvas_px
    drag = drag_of(handle, document, frame, view)
    for canvas_px in ((x, y), (x + dx, y + dy)):
        document = drag.send(Pointer(view.view_from_canvas(canvas_px), canvas_px, Modifiers(snap=False)))
    drag.close()
    return document
