"""The hand on the graph: choosing and dragging keys and handles, adding keys, and reading values off."""

from dataclasses import dataclass
from math import hypot
from typing import TYPE_CHECKING, TypeVar

import numpy as np
from PySide6.QtCore import QObject, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent

from kagezou.document.address import Address
from kagezou.document.key_edits import Refs, move_keys
from kagezou.session.session import Gesture
from kagezou.ui.curves.box_hand import BoxController
from kagezou.ui.curves.choice import Choice, GraphKind
from kagezou.ui.curves.graph_edits import with_handle, with_key, with_speed
from kagezou.ui.curves.picture import CurvePicture, HandleMark, KeyMark
from kagezou.ui.system.bridge import Bridge

if TYPE_CHECKING:
    from kagezou.ui.curves.graph import Graph

KEY_REACH_PX = 10.0
CURVE_REACH_PX = 7.0
_DRAG_PX = 4.0

_SHIFT = Qt.KeyboardModifier.ShiftModifier
_CONTROL = Qt.KeyboardModifier.ControlModifier
_ALT = Qt.KeyboardModifier.AltModifier

Mark = TypeVar("Mark", KeyMark, HandleMark)


@dataclass(frozen=True, slots=True)
class CurveGrip:
    """What the hand has taken hold of, and where, in graph coordinates."""

    picture: CurvePicture
    mark: KeyMark | HandleMark
    start: tuple[float, float]
    refs: Refs


class GraphController(QObject):
    """What mouse and keyboard do on the graph; a drag is one step of history, and Esc takes it back."""

    read = Signal(float, float)
    """The pointer is at this frame and ordinate."""
    left = Signal()
    exact_asked = Signal()
    """The selected key's speeds and influences shall be typed."""

    def __init__(self, bridge: Bridge, choice: Choice, graph: "Graph") -> None:
        super().__init__()
        self._bridge, self._choice, self._graph = bridge, choice, graph
        self.is_down = False
        self._pressed = QPointF()
        self._grip: CurveGrip | None = None
        self._box: BoxController | None = None
        self._gesture: Gesture | None = None
        self._before: Refs = frozenset()
        self._adds = False
        self._scrubs = False

    @property
    def is_busy(self) -> bool:
        """Whether a drag goes on."""
        return self._gesture is not None

    def press(self, event: QMouseEvent) -> None:
        """Take the left button going down."""
        self.is_down, self._pressed = True, event.position()
        place = self._graph.place_of(event.position())
        self._adds = bool(event.modifiers() & _SHIFT)
        self._before = self._bridge.session.state.keys
        if (handle := self._handle_at(place)) is not None:
            self._grip = CurveGrip(*handle, place, self._before)
        elif (key := self._key_at(place)) is not None:
            self._choose(key[1])
            self._grip = CurveGrip(*key, place, self._bridge.session.state.keys)
        elif self._takes_box(place, event):
            pass
        elif (picture := self._curve_at(place)) is not None:
            if event.modifiers() & _CONTROL:
                self._add_key(picture, place)
            else:
                self._bridge.session.select_keys(frozenset(mark.ref for mark in picture.keys))
        else:
            across, _ = self._graph.pixels()
            self._scrubs = abs(place[0] - self._bridge.frame) <= KEY_REACH_PX / 2 * across

    def move(self, event: QMouseEvent) -> None:
        """Take a move with the left button down."""
        place = self._graph.place_of(event.position())
        self.read.emit(*place)
        if self._scrubs:
            self._bridge.session.go_to(round(place[0]))
            return
        if not self.is_busy and (event.position() - self._pressed).manhattanLength() < _DRAG_PX:
            return
        if self._box is not None:
            self._drag_box(self._box, place, event)
        elif self._grip is None:
            self._draw_box(place)
        elif not self._choice.is_locked:
            self._drag(self._grip, place, event)

    def release(self, event: QMouseEvent) -> None:
        """Take the left button coming up."""
        if self._gesture is not None:
            self._gesture.commit()
        elif self._box is not None and self._box.part.is_inside:
            self._click_inside(self._graph.place_of(event.position()))
        elif self._grip is None and not self._scrubs and not self._moved(event) and self._is_empty(event):
            self._bridge.session.select_keys(frozenset())
        self._let_go()

    def double_click(self, event: QMouseEvent) -> None:
        """Ask for numbers on a key; elsewhere go to the frame."""
        place = self._graph.place_of(event.position())
        if self._key_at(place) is not None:
            self.exact_asked.emit()
        else:
            self._bridge.session.go_to(round(place[0]))

    def hover(self, point: QPointF) -> None:
        """Take note of the pointer."""
        place = self._graph.place_of(point)
        near = self._handle_at(place) is not None or self._key_at(place) is not None
        box = self._graph.key_box
        part = None if near or box is None else box.part_at(place)
        elsewhere = Qt.CursorShape.CrossCursor if part is None else part.cursor
        self._graph.setCursor(Qt.CursorShape.PointingHandCursor if near else elsewhere)
        self.read.emit(*place)

    def leave(self) -> None:
        """Take note that the pointer is elsewhere."""
        self.left.emit()

    def wants(self, event: QKeyEvent) -> bool:
        """Return whether a key belongs to the hand, not to the window's commands."""
        if event.modifiers() & (_CONTROL | _ALT | _SHIFT):
            return False
        if event.key() == Qt.Key.Key_Escape:
            return self.is_down or bool(self._bridge.session.state.keys)
        return event.key() in (Qt.Key.Key_Left, Qt.Key.Key_Right)

    def key(self, event: QKeyEvent) -> bool:
        """Take a key going down; false if it is another one."""
        if not self.wants(event):
            return False
        if event.key() == Qt.Key.Key_Escape:
            self.cancel()
        else:
            self._bridge.session.go_to(self._bridge.frame + (1 if event.key() == Qt.Key.Key_Right else -1))
        return True

    def cancel(self) -> None:
        """Take a drag back; with none, select nothing."""
        if self._gesture is not None:
            self._gesture.cancel()
        else:
            self._bridge.session.select_keys(self._before if self.is_down else frozenset())
        self._let_go()

    def _is_empty(self, event: QMouseEvent) -> bool:
        return not event.modifiers() and self._curve_at(self._graph.place_of(event.position())) is None

    def _moved(self, event: QMouseEvent) -> bool:
        return (event.position() - self._pressed).manhattanLength() >= _DRAG_PX

    def _let_go(self) -> None:
        was_busy = self.is_busy
        self.is_down = self._scrubs = False
        self._grip = self._gesture = self._box = None
        self._graph.show_box(None)
        self._graph.show_words("", QPointF())
        if was_busy:
            # What was held while the hand moved fits anew.
            self._graph.refresh()

    def _takes_box(self, place: tuple[float, float], event: QMouseEvent) -> bool:
        box = self._graph.key_box
        part = None if box is None else box.part_at(place)
        if box is None or part is None or (part.is_inside and event.modifiers()):
            return False
        self._box = BoxController(box, part, self._graph.pictures, place)
        return True

    def _drag_box(self, box: BoxController, place: tuple[float, float], event: QMouseEvent) -> None:
        if self._gesture is None:
            self._gesture = self._bridge.session.begin(box.name)
        centred, one_axis = bool(event.modifiers() & _CONTROL), bool(event.modifiers() & _SHIFT)
        self._gesture.show(*box.dragged(self._gesture.start, place, about_centre=centred, one_axis=one_axis))
        self._graph.show_words(box.said, event.position())

    def _click_inside(self, place: tuple[float, float]) -> None:
        """Take a click within the frame for what it is without one."""
        picture = self._curve_at(place)
        found = () if picture is None else picture.keys
        self._bridge.session.select_keys(frozenset(mark.ref for mark in found))

    def _choose(self, mark: KeyMark) -> None:
        chosen = self._before
        if self._adds:
            self._bridge.session.select_keys(chosen ^ {mark.ref})
        elif mark.ref not in chosen:
            self._bridge.session.select_keys(frozenset({mark.ref}))

    def _draw_box(self, place: tuple[float, float]) -> None:
        start = self._graph.place_of(self._pressed)
        box = QRectF(QPointF(*start), QPointF(*place)).normalized()
        self._graph.show_box(box)
        inside = {
            mark.ref
            for picture in self._graph.pictures
            for mark in picture.keys
            if box.left() <= mark.frame <= box.right() and box.top() <= mark.ordinate <= box.bottom()
        }
        self._bridge.session.select_keys(frozenset(inside) | (self._before if self._adds else frozenset()))

    def _drag(self, grip: CurveGrip, place: tuple[float, float], event: QMouseEvent) -> None:
        if self._gesture is None:
            is_handle = isinstance(grip.mark, HandleMark)
            self._gesture = self._bridge.session.begin(self.tr("Move handle") if is_handle else self.tr("Move keys"))
        if isinstance(grip.mark, HandleMark):
            joined = not event.modifiers() & _ALT
            self._gesture.show(with_handle(self._gesture.start, grip.picture, grip.mark, place, joined=joined))
        elif self._choice.kind is GraphKind.SPEED:
            self._gesture.show(with_speed(self._gesture.start, grip.picture, grip.mark, place[1]))
        else:
            along = event.position() - self._pressed
            frames, ordinates = round(place[0] - grip.start[0]), place[1] - grip.start[1]
            if event.modifiers() & _SHIFT:
                # One axis alone, the one along which the hand goes farther.
                frames, ordinates = (frames, 0.0) if abs(along.x()) >= abs(along.y()) else (0, ordinates)
            amounts = self._amounts(grip, ordinates)
            self._gesture.show(*move_keys(self._gesture.start, grip.refs, frames, amounts))

    def _amounts(self, grip: CurveGrip, ordinates: float) -> dict[Address, tuple[float, ...]]:
        curve = grip.picture.curve
        amount = ordinates / grip.picture.fitting.factor
        return {curve.address: (0.0,) * curve.component + (amount,)}

    def _add_key(self, picture: CurvePicture, place: tuple[float, float]) -> None:
        if not self._choice.is_locked:
            level = place[1] if self._choice.kind is GraphKind.VALUE else None
            added = with_key(self._bridge.document, picture, max(round(place[0]), 1), level)
            self._bridge.session.edit(self.tr("Add key"), added)

    def _key_at(self, place: tuple[float, float]) -> tuple[CurvePicture, KeyMark] | None:
        found = [(picture, mark) for picture in self._graph.pictures for mark in picture.keys]
        return self._nearest(place, found)

    def _handle_at(self, place: tuple[float, float]) -> tuple[CurvePicture, HandleMark] | None:
        if self._choice.is_locked:
            return None
        found = [(picture, mark) for picture in self._graph.pictures for mark in picture.handles]
        return self._nearest(place, found)

    def _nearest(
        self, place: tuple[float, float], found: list[tuple[CurvePicture, Mark]]
    ) -> tuple[CurvePicture, Mark] | None:
        across, up = self._graph.pixels()

        def away(each: tuple[CurvePicture, Mark]) -> float:
            return hypot((each[1].frame - place[0]) / across, (each[1].ordinate - place[1]) / up)

        near = min(found, key=away, default=None)
        return near if near is not None and away(near) <= KEY_REACH_PX else None

    def _curve_at(self, place: tuple[float, float]) -> CurvePicture | None:
        across, up = self._graph.pixels()

        def away(picture: CurvePicture) -> float:
            line = picture.line
            # The curve near the pointer, a pixel's width to both sides.
            frames = place[0] + np.array([-2.0, 0.0, 2.0]) * across
            levels = np.interp(frames, line.frames, line.values)
            return float(np.min(np.abs(levels - place[1])) / up)

        near = min(self._graph.pictures, key=away, default=None)
        return near if near is not None and away(near) <= CURVE_REACH_PX else None
