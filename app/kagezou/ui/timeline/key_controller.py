"""The hand on the lanes: choosing, moving and stretching keys with mouse, pen and arrows."""

from collections.abc import Callable

from PySide6.QtCore import QObject, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPointingDevice, QWheelEvent

from kagezou.animation.timecode import sheet_text
from kagezou.document.frame_numbers import number_of
from kagezou.document.key_edits import Refs
from kagezou.session.session import Gesture
from kagezou.tools.timeline.key_drag import KeyDrag, KeyGrip, dragging_keys
from kagezou.tools.timeline.lane_pointer import LanePointer
from kagezou.tools.timeline.snapping import snap_frames
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.words import translated
from kagezou.ui.timeline.key_finder import HIT_PX, KeyFinder
from kagezou.ui.timeline.row_list import RowList
from kagezou.ui.timeline.time_scale import TimeScale

PEN_HIT_PX = 14.0
_DRAG_PX = 4.0
_WHEEL_STEP = 120.0

_SHIFT = Qt.KeyboardModifier.ShiftModifier
_CONTROL = Qt.KeyboardModifier.ControlModifier
_ALT = Qt.KeyboardModifier.AltModifier
_LEFT = Qt.MouseButton.LeftButton
_MIDDLE = Qt.MouseButton.MiddleButton


class KeyController(QObject):
    """What mouse and keyboard do on the lanes; a drag is one step of history, and Esc takes it back."""

    changed = Signal()
    menu_asked = Signal(object)
    """The right button went down at this global point; what lies there is selected."""

    def __init__(self, bridge: Bridge, scale: TimeScale, rows: RowList) -> None:
        super().__init__()
        self._bridge, self._scale, self._rows = bridge, scale, rows
        self.finder = KeyFinder(bridge, scale, rows)
        self.box: QRectF | None = None
        self.caught_by: int | None = None
        self.said = ""
        self.place = QPointF()
        self.cursor = Qt.CursorShape.ArrowCursor
        self._pressed = QPointF()
        self._grip: KeyGrip | None = None
        self._gesture: Gesture | None = None
        self._drag: KeyDrag | None = None
        self._before: Refs = frozenset()
        self._is_panning = False
        self._boxes: Callable[[Refs, Refs], Refs] | None = None

    @property
    def is_busy(self) -> bool:
        """Whether a drag goes on."""
        return self._gesture is not None or self.box is not None

    def press(self, event: QMouseEvent) -> None:
        """Take a button that goes down."""
        self._pressed = self.place = event.position()
        if event.button() is _MIDDLE:
            self._is_panning = True
        elif event.button() is Qt.MouseButton.RightButton:
            self._press_right(event)
        elif event.button() is _LEFT:
            self._press_left(event)

    def move(self, event: QMouseEvent) -> None:
        """Take a move of the pointer."""
        place = event.position()
        if self._is_panning:
            away = place - self.place
            self._scale.scroll_to(self._scale.scroll_px - away.x())
            self._rows.scroll_to(round(self._rows.scroll_px - away.y()))
        self.place = place
        if not event.buttons() & _LEFT:
            shapes = Qt.CursorShape
            self.cursor = shapes.PointingHandCursor if self.finder.keys_at(place, _reach(event)) else shapes.ArrowCursor
            return
        if not self.is_busy and (place - self._pressed).manhattanLength() < _DRAG_PX:
            return
        if self._grip is not None:
            self._go_on(self._grip, catches=not event.modifiers() & _CONTROL)
        elif self._boxes is not None:
            self.box = QRectF(self._pressed, place).normalized()
            self._bridge.session.select_keys(self._boxes(self._before, self.finder.keys_in(self.box)))
        self.changed.emit()

    def release(self, event: QMouseEvent) -> None:
        """Take a button that comes up."""
        if event.button() is _MIDDLE:
            self._is_panning = False
        if event.button() is not _LEFT:
            return
        if self._gesture is not None:
            self._gesture.commit()
        elif self._grip is None and self.box is None and self._boxes is not None and not event.modifiers():
            self._bridge.session.select_keys(frozenset())
        self._let_go()

    def wheel(self, event: QWheelEvent) -> None:
        """Zoom at the pointer with Ctrl, scroll time with Shift or sideways, else scroll the rows."""
        turn = event.angleDelta()
        if event.modifiers() & _CONTROL:
            self._scale.zoom(1.25 ** (turn.y() / _WHEEL_STEP), event.position().x())
        elif event.modifiers() & _SHIFT or abs(turn.x()) > abs(turn.y()):
            self._scale.scroll_to(self._scale.scroll_px - (turn.x() or turn.y()))
        else:
            self._rows.scroll_to(round(self._rows.scroll_px - turn.y() / _WHEEL_STEP * 3 * self._rows.row_px))
        event.accept()

    def wants(self, event: QKeyEvent) -> bool:
        """Return whether a key belongs to the hand, not to the window's commands."""
        plain = not event.modifiers() & (_CONTROL | _ALT | _SHIFT)
        return plain and (event.key() in (Qt.Key.Key_Left, Qt.Key.Key_Right) or self._takes_escape(event))

    def key(self, event: QKeyEvent) -> bool:
        """Take a key that goes down; false if it is another one."""
        if not self.wants(event):
            return False
        if event.key() == Qt.Key.Key_Escape:
            self.cancel()
        else:
            frames = -1 if event.key() == Qt.Key.Key_Left else 1
            self._bridge.session.go_to(self._bridge.frame + frames)
        return True

    def cancel(self) -> None:
        """Take a drag back; with none, select nothing."""
        if self._gesture is not None:
            self._gesture.cancel()
        elif self.box is not None:
            self._bridge.session.select_keys(self._before)
        else:
            self._bridge.session.select_keys(frozenset())
        self._let_go()

    def _takes_escape(self, event: QKeyEvent) -> bool:
        return event.key() == Qt.Key.Key_Escape and (self.is_busy or bool(self._bridge.session.state.keys))

    def _press_left(self, event: QMouseEvent) -> None:
        hit = self.finder.keys_at(event.position(), _reach(event))
        chosen = self._bridge.session.state.keys
        self._before = chosen
        modifiers = event.modifiers()
        if not hit:
            self._choose_layer(event.position())
            adds, takes = bool(modifiers & _SHIFT), bool(modifiers & _CONTROL)
            self._boxes = Refs.union if adds else Refs.difference if takes else lambda _before, found: found
            return
        frame = min(ref.frame for ref in hit)
        ends = {min(ref.frame for ref in chosen), max(ref.frame for ref in chosen)} if chosen else set()
        if modifiers & _SHIFT:
            self._bridge.session.select_keys(chosen - hit if hit <= chosen else chosen | hit)
            return
        stretches = bool(modifiers & _ALT) and hit <= chosen and frame in ends and len(ends) > 1
        if modifiers & _ALT and not stretches:
            hit = self.finder.keys_on_frame(frame)
        if not hit <= chosen or (modifiers & _ALT and not stretches):
            self._bridge.session.select_keys(hit)
            chosen = hit
        about = next(iter(ends - {frame})) if stretches else None
        catching = snap_frames(self._bridge.document, self._bridge.frame, chosen)
        self._grip = KeyGrip(self._bridge.session.state.keys, frame, catching, about)

    def _press_right(self, event: QMouseEvent) -> None:
        hit = self.finder.keys_at(event.position(), _reach(event))
        if hit and not hit <= self._bridge.session.state.keys:
            self._bridge.session.select_keys(hit)
        self.menu_asked.emit(event.globalPosition().toPoint())

    def _choose_layer(self, place: QPointF) -> None:
        row = self.finder.row_at(place)
        if row is not None and row.layer_id is not None and row.layer_id != self._bridge.layer_id:
            self._bridge.session.select(row.layer_id)
        elif row is not None and row.piece_id is not None and row.piece_id != self._bridge.piece_id:
            self._bridge.session.select_piece(row.piece_id)

    def _go_on(self, grip: KeyGrip, *, catches: bool) -> None:
        if self._gesture is None or self._drag is None:
            stretches = grip.stretches_about is not None
            self._gesture = self._bridge.session.begin(self.tr("Stretch keys") if stretches else self.tr("Move keys"))
            self._drag = dragging_keys(self._gesture.start, grip)
            self._drag.send(self._pointer(self._pressed))
        shown = self._drag.send(self._pointer(self.place, catches=catches))
        self._gesture.show(shown.document, shown.refs)
        self.caught_by, frame = shown.caught_by, shown.frame
        canvas = self._gesture.start.canvas
        seconds = sheet_text(frame, canvas.frame_rate)
        self.said = f"{number_of(canvas, frame)}  ({frame - grip.frame:+d})   {seconds}"
        if shown.note is not None:
            self.said += f"   {translated(shown.note)}"

    def _pointer(self, place: QPointF, *, catches: bool = True) -> LanePointer:
        return LanePointer(place.x(), self._scale.cell_px, catches=catches)

    def _let_go(self) -> None:
        if self._drag is not None:
            self._drag.close()
        self._gesture = self._drag = self._grip = self._boxes = None
        self.box, self.caught_by, self.said = None, None, ""
        self.changed.emit()


def _reach(event: QMouseEvent) -> float:
    device = event.pointingDevice()
    is_pen = device is not None and device.pointerType() is QPointingDevice.PointerType.Pen
    return PEN_HIT_PX if is_pen else HIT_PX
