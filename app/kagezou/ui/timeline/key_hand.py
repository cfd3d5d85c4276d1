"""The hand on the lanes: choosing, moving and stretching keys with mouse, pen and arrows."""

from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QObject, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPointingDevice, QWheelEvent

from kagezou.animation.timecode import sheet_text
from kagezou.document.key_edits import Refs, move_keys, stretch_keys
from kagezou.session.session import Gesture
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.timeline.drawing_bars import SUM_LANE_PX
from kagezou.ui.timeline.row_list import RowList
from kagezou.ui.timeline.rows import RowKind, frames_of, keys_on
from kagezou.ui.timeline.snapping import snap_frames, snapped
from kagezou.ui.timeline.time_scale import TimeScale

HIT_PX = 10.0
PEN_HIT_PX = 14.0
_DRAG_PX = 4.0
_OVER_BARS_PX = 2.0
"""How far the keys summed up under a layer's drawings reach up into them."""
_WHEEL_STEP = 120.0

_SHIFT = Qt.KeyboardModifier.ShiftModifier
_CONTROL = Qt.KeyboardModifier.ControlModifier
_ALT = Qt.KeyboardModifier.AltModifier
_LEFT = Qt.MouseButton.LeftButton
_MIDDLE = Qt.MouseButton.MiddleButton


@dataclass(frozen=True, slots=True)
class KeyGrip:
    """What the hand has taken hold of: keys by one of them, with what they may catch on."""

    refs: Refs
    frame: int
    catching: tuple[int, ...]
    stretches_about: int | None


class KeyController(QObject):
    """What mouse and keyboard do on the lanes; a drag is one step of history, and Esc takes it back."""

    changed = Signal()
    menu_asked = Signal(object)
    """The right button went down at this global point; what lies there is selected."""

    def __init__(self, bridge: Bridge, scale: TimeScale, rows: RowList) -> None:
        super().__init__()
        self._bridge, self._scale, self._rows = bridge, scale, rows
        self.box: QRectF | None = None
        self.caught_by: int | None = None
        self.said = ""
        self.place = QPointF()
        self.cursor = Qt.CursorShape.ArrowCursor
        self._pressed = QPointF()
        self._grip: KeyGrip | None = None
        self._gesture: Gesture | None = None
        self._before: Refs = frozenset()
        self._is_panning = False
        self._boxes: Callable[[Refs, Refs], Refs] | None = None

    @property
    def is_busy(self) -> bool:
        """Whether a drag goes on."""
        return self._gesture is not None or self.box is not None

    def keys_at(self, place: QPointF, reach_px: float = HIT_PX) -> Refs:
        """Return the keys nearest to a point in its row, none beyond reach."""
        index = self._rows.index_at(place.y())
        if index is None:
            return frozenset()
        row = self._rows.rows[index]
        frames = frames_of(self._bridge.document, row)
        near = min(frames, key=lambda frame: abs(self._scale.middle_of(frame) - place.x()), default=None)
        if near is None or abs(self._scale.middle_of(near) - place.x()) > reach_px:
            return frozenset()
        top = self._rows.top_of(index)
        if row.kind is RowKind.LAYER and place.y() < top + self._rows.row_px - SUM_LANE_PX - _OVER_BARS_PX:
            # The upper part of a layer's row is its drawings'.
            return frozenset()
        return keys_on(self._bridge.document, row, near)

    def words_at(self, place: QPointF) -> str:
        """Return what a tool tip says about the key at a point: its frame."""
        rate = self._bridge.document.canvas.frame_rate
        if hit := self.keys_at(place):
            frame = min(ref.frame for ref in hit)
            return f"{frame}  ({sheet_text(frame, rate)})"
        return ""

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
            self.cursor = (
                Qt.CursorShape.PointingHandCursor if self.keys_at(place, _reach(event)) else Qt.CursorShape.ArrowCursor
            )
            return
        if not self.is_busy and (place - self._pressed).manhattanLength() < _DRAG_PX:
            return
        if self._grip is not None:
            self._drag(self._grip, catches=not event.modifiers() & _CONTROL)
        elif self._boxes is not None:
            self.box = QRectF(self._pressed, place).normalized()
            self._bridge.session.select_keys(self._boxes(self._before, self._keys_in(self.box)))
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
        hit = self.keys_at(event.position(), _reach(event))
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
            hit = frozenset().union(*(keys_on(self._bridge.document, row, frame) for row in self._rows.rows))
        if not hit <= chosen or (modifiers & _ALT and not stretches):
            self._bridge.session.select_keys(hit)
            chosen = hit
        about = next(iter(ends - {frame})) if stretches else None
        catching = snap_frames(self._bridge.document, self._bridge.frame, chosen)
        self._grip = KeyGrip(self._bridge.session.state.keys, frame, catching, about)

    def _press_right(self, event: QMouseEvent) -> None:
        hit = self.keys_at(event.position(), _reach(event))
        if hit and not hit <= self._bridge.session.state.keys:
            self._bridge.session.select_keys(hit)
        self.menu_asked.emit(event.globalPosition().toPoint())

    def _choose_layer(self, place: QPointF) -> None:
        index = self._rows.index_at(place.y())
        row = self._rows.rows[index] if index is not None else None
        if row is not None and row.layer_id is not None and row.layer_id != self._bridge.layer_id:
            self._bridge.session.select(row.layer_id)
        elif row is not None and row.piece_id is not None and row.piece_id != self._bridge.piece_id:
            self._bridge.session.select_piece(row.piece_id)

    def _drag(self, grip: KeyGrip, *, catches: bool) -> None:
        stretches = grip.stretches_about is not None
        if self._gesture is None:
            self._gesture = self._bridge.session.begin(self.tr("Stretch keys") if stretches else self.tr("Move keys"))
        away = (self.place.x() - self._pressed.x()) / self._scale.cell_px
        frame, self.caught_by = snapped(grip.frame + away, grip.catching if catches else (), self._scale.cell_px)
        start = self._gesture.start
        if grip.stretches_about is not None:
            about = grip.stretches_about
            document, refs = stretch_keys(start, grip.refs, about, (frame - about) / (grip.frame - about))
        else:
            document, refs = move_keys(start, grip.refs, frame - grip.frame)
        self._gesture.show(document, refs)
        self.said = f"{frame}  ({frame - grip.frame:+d})   {sheet_text(frame, start.canvas.frame_rate)}"

    def _keys_in(self, box: QRectF) -> Refs:
        refs: Refs = frozenset()
        half = self._rows.row_px / 2
        for index, row in enumerate(self._rows.rows):
            middle = self._rows.top_of(index) + half
            # The keys of an open group lie below it, each in its own row.
            if not box.top() - half <= middle <= box.bottom() + half or row.is_open:
                continue
            for frame in frames_of(self._bridge.document, row):
                if box.left() <= self._scale.middle_of(frame) <= box.right():
                    refs |= keys_on(self._bridge.document, row, frame)
        return refs

    def _let_go(self) -> None:
        self._gesture, self._grip, self._boxes = None, None, None
        self.box, self.caught_by, self.said = None, None, ""
        self.changed.emit()


def _reach(event: QMouseEvent) -> float:
    device = event.pointingDevice()
    is_pen = device is not None and device.pointerType() is QPointingDevice.PointerType.Pen
    return PEN_HIT_PX if is_pen else HIT_PX
