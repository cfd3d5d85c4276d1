"""Mouse and pen in one form, so that whatever listens cannot tell them apart except by how exact they are."""

from dataclasses import dataclass
from enum import StrEnum

from PySide6.QtCore import Qt
from PySide6.QtGui import QSinglePointEvent

from kagezou.geometry.vectors import Point2
from kagezou.tools.handle import HIT_RADIUS_PX, PEN_HIT_RADIUS_PX
from kagezou.tools.pointer import Modifiers, Pointer
from kagezou.tools.view import CanvasView


class Device(StrEnum):
    """What points."""

    MOUSE = "mouse"
    PEN = "pen"


@dataclass(frozen=True, slots=True)
class PointerReport:
    """Where something points, logical px of the viewport, and the keys held."""

    view_px: Point2
    modifiers: Modifiers
    device: Device = Device.MOUSE

    @property
    def reach_px(self) -> float:
        """How far from its middle it can take hold of a handle."""
        return PEN_HIT_RADIUS_PX if self.device is Device.PEN else HIT_RADIUS_PX

    def pointer(self, view: CanvasView) -> Pointer:
        """Return it as the tools take it."""
        return Pointer.seen_at(view, self.view_px, self.modifiers)


def report_of(event: QSinglePointEvent, device: Device = Device.MOUSE) -> PointerReport:
    """Return what a mouse or pen event says."""
    at, keys = event.position(), event.modifiers()
    modifiers = Modifiers.of_keys(
        shift=bool(keys & Qt.KeyboardModifier.ShiftModifier),
        alt=bool(keys & Qt.KeyboardModifier.AltModifier),
        ctrl=bool(keys & Qt.KeyboardModifier.ControlModifier),
    )
    return PointerReport((at.x(), at.y()), modifiers, device)
