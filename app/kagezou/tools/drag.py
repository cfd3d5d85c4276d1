"""A drag as a generator: pointers go in, documents come out, closing it is Escape.

What is the same for all handles lives here: a handle keeps the offset it was taken hold of with (so one shown at the
viewport's edge does not jump to the hand), the fine gear starts from where it was engaged, and every document is made
of the one the drag began with, so that going back gives back the very same values.
"""

from collections.abc import Callable, Generator
from dataclasses import dataclass, replace
from typing import TypeAlias

from kagezou.document.model import Document
from kagezou.geometry.vectors import Point2
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.handle import Handle
from kagezou.tools.pointer import Modifiers, Pointer

FINE_SPEED = 0.1
"""How far a handle goes for one px of the pointer in the fine gear."""

STEP_DEG = 15.0
"""The steps of a constrained angle."""

SNAP_VIEW_PX = 5.0
"""How near a handle must come to a place that draws it, logical view px."""

Drag: TypeAlias = Generator[Document, Pointer, None]
"""The first pointer sent is the press; each answer is the document to show; ``close()`` cancels."""


@dataclass(frozen=True, slots=True)
class Aim:
    """Where a handle is wanted.

    Parameters
    ----------
    target
        The wanted middle, canvas px.
    offset
        The same from where the handle was at the press.
    modifiers
        The keys held now.
    shown
        The document shown last, by which angles know how often they have gone round.
    """

    target: Point2
    offset: Point2
    modifiers: Modifiers
    shown: Document

    def straightened(self, along: Point2) -> "Aim":
        """Return the aim kept, if constrained, to the nearer of the unit direction ``along`` and its normal."""
        if not self.modifiers.constrain:
            return self
        x, y = self.offset
        run, rise = x * along[0] + y * along[1], y * along[0] - x * along[1]
        dx, dy = (run * along[0], run * along[1]) if abs(run) >= abs(rise) else (-rise * along[1], rise * along[0])
        return replace(self, target=(self.target[0] - x + dx, self.target[1] - y + dy), offset=(dx, dy))

    def angle(self, degrees: float) -> float:
        """Return an angle, in whole steps if constrained."""
        return round(degrees / STEP_DEG) * STEP_DEG if self.modifiers.constrain else degrees

    def angle_or_zero(self, degrees: float, miss_canvas_px: float, geometry: FrameGeometry) -> float:
        """Return an angle as above, or zero if snapping and the handle is that little away from where zero is."""
        near = miss_canvas_px <= geometry.view.canvas_length(SNAP_VIEW_PX)
        return 0.0 if near and self.modifiers.snap and not self.modifiers.constrain else self.angle(degrees)


Move: TypeAlias = Callable[[FrameGeometry, Handle, Aim], Document]
"""Makes of the geometry at the press a document in which the handle lies where it is wanted, as nearly as it may."""


def dragging(geometry: FrameGeometry, handle: Handle, move: Move) -> Drag:
    """Return a drag that is ready for the press."""
    drag = _drag(geometry, handle, move)
    next(drag)
    return drag


def _drag(geometry: FrameGeometry, handle: Handle, move: Move) -> Drag:
    shown = geometry.document
    anchor = last = yield shown
    carried: Point2 = (0.0, 0.0)
    while True:
        pointer = yield shown
        if pointer.modifiers.fine != last.modifiers.fine:
            carried = _travelled(carried, anchor, last)
            anchor = replace(last, modifiers=pointer.modifiers)
        last = pointer
        offset = _travelled(carried, anchor, pointer)
        if offset == (0.0, 0.0):
            shown = geometry.document
            continue
        target = (handle.canvas_px[0] + offset[0], handle.canvas_px[1] + offset[1])
        shown = move(geometry, handle, Aim(target, offset, pointer.modifiers, shown))


def _travelled(carried: Point2, anchor: Pointer, pointer: Pointer) -> Point2:
    """Return how far the handle has gone, canvas px: what it was carried before, and the way since the anchor."""
    speed = FINE_SPEED if anchor.modifiers.fine else 1.0
    return (
        carried[0] + speed * (pointer.canvas_px[0] - anchor.canvas_px[0]),
        carried[1] + speed * (pointer.canvas_px[1] - anchor.canvas_px[1]),
    )
