"""The hand on the bars of drawings: choosing them, holding them longer or shorter, moving them."""

from PySide6.QtCore import QObject, QPointF, Qt, Signal
from PySide6.QtGui import QMouseEvent

from kagezou.animation.timecode import sheet_text
from kagezou.document.exposure_edits import Exposures, with_exposures
from kagezou.document.frame_numbers import number_of
from kagezou.session.session import Gesture
from kagezou.tools.timeline.drawing_drag import BarPart, DrawingDrag, DrawingGrip, dragging_drawings, grip_on
from kagezou.tools.timeline.lane_pointer import LanePointer
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.words import translated
from kagezou.ui.timeline.drawing_bars import SUM_LANE_PX, Bar, bars_of, part_at
from kagezou.ui.timeline.drawing_choice import DrawingChoice
from kagezou.ui.timeline.row_list import RowList
from kagezou.ui.timeline.rows import RowKind
from kagezou.ui.timeline.time_scale import TimeScale

_DRAG_PX = 4.0
_SHIFT = Qt.KeyboardModifier.ShiftModifier
_ALT = Qt.KeyboardModifier.AltModifier
_CONTROL = Qt.KeyboardModifier.ControlModifier


class DrawingController(QObject):
    """What the mouse does on the bars; a drag is one step of history, and Esc takes it back."""

    changed = Signal()
    menu_asked = Signal(object)
    """The right button went down on a bar at this global point; the bar is chosen."""

    def __init__(self, bridge: Bridge, scale: TimeScale, rows: RowList) -> None:
        super().__init__()
        self._bridge, self._scale, self._rows = bridge, scale, rows
        self.choice = DrawingChoice(bridge)
        self.caught_by: int | None = None
        self.said = ""
        self.place = QPointF()
        self.is_down = False
        self._pressed = QPointF()
        self._grip: DrawingGrip | None = None
        self._gesture: Gesture | None = None
        self._drag: DrawingDrag | None = None
        self._exposures: Exposures = ()

    @property
    def is_busy(self) -> bool:
        """Whether a drag goes on."""
        return self._gesture is not None

    def bar_at(self, place: QPointF) -> tuple[str, Bar, BarPart] | None:
        """Return the layer, the bar and its part at a point; the strip of keys under the bars is not theirs."""
        index = self._rows.index_at(place.y())
        row = None if index is None else self._rows.rows[index]
        if index is None or row is None or row.kind is not RowKind.LAYER or row.layer_id is None:
            return None
        if place.y() >= self._rows.top_of(index) + self._rows.row_px - SUM_LANE_PX:
            return None
        layer = self._bridge.document.layer(row.layer_id)
        found = part_at(bars_of(layer, self._scale, self._scale.width_px), place.x())
        return None if found is None else (layer.id, *found)

    def cursor_at(self, place: QPointF) -> Qt.CursorShape | None:
        """Return what the pointer looks like at a point; None where there is no bar."""
        found = self.bar_at(place)
        if found is None:
            return None
        return Qt.CursorShape.OpenHandCursor if found[2] is BarPart.MIDDLE else Qt.CursorShape.SplitHCursor

    def press(self, event: QMouseEvent) -> bool:
        """Take a button that goes down on a bar; false if it is on none."""
        found = self.bar_at(event.position())
        if found is None or event.button() not in (Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton):
            return False
        layer_id, bar, part = found
        exposures = self._bridge.document.layer(layer_id).cels.exposures
        if not self.choice.holds(layer_id, bar.index) and not event.modifiers() & _SHIFT:
            self.choice.choose(layer_id, exposures[bar.index].frame)
        if event.button() is Qt.MouseButton.RightButton:
            self.menu_asked.emit(event.globalPosition().toPoint())
            return True
        self.is_down, self._pressed, self.place = True, event.position(), event.position()
        run = (bar.index, bar.index)
        if part is BarPart.MIDDLE and self.choice.holds(layer_id, bar.index):
            run = self.choice.run or run
        self._grip = grip_on(self._bridge.document, self._bridge.frame, layer_id, part, run)
        return True

    def move(self, event: QMouseEvent) -> None:
        """Take a move with the left button down."""
        self.place = event.position()
        far = (self.place - self._pressed).manhattanLength() >= _DRAG_PX
        if self._grip is not None and (self.is_busy or far):
            self._go_on(self._grip, event)
            self.changed.emit()

    def release(self, event: QMouseEvent) -> None:
        """Take the button that comes up."""
        grip = self._grip
        if self._gesture is not None and grip is not None:
            self._gesture.show(with_exposures(self._gesture.start, grip.layer_id, self._exposures))
            self._gesture.commit()
        elif grip is not None and event.modifiers() & _SHIFT:
            self.choice.extend(grip.layer_id, grip.exposures[grip.index].frame)
        elif grip is not None and not event.modifiers():
            found = self.bar_at(event.position())
            if found is not None:
                self.choice.choose(grip.layer_id, grip.exposures[found[1].index].frame)
        self._let_go()

    def cancel(self) -> None:
        """Take a drag back; with none, choose nothing."""
        if self._gesture is not None:
            self._gesture.cancel()
        else:
            self.choice.clear()
        self._let_go()

    def words_at(self, place: QPointF) -> str:
        """Return what a tool tip says about the bar at a point: its drawing and how long it is held."""
        found = self.bar_at(place)
        if found is None:
            return ""
        layer_id, bar, _ = found
        cels = self._bridge.document.layer(layer_id).cels
        start = max(cels.exposures[bar.index].frame, 1)
        end = self._scale.length + 1 if bar.is_last else cels.exposures[bar.index + 1].frame
        name = self.tr("empty") if bar.drawing is None else cels.drawings[bar.drawing].name
        words = self.tr("%1: frames %2 to %3, held %4").replace("%1", name)
        canvas = self._bridge.document.canvas
        words = words.replace("%2", str(number_of(canvas, start)))
        hint = self.tr(
            "Drag an end to hold it longer or shorter (Shift: what follows moves along; Alt or A: over its "
            "neighbours), the middle to move it"
        )
        return words.replace("%3", str(number_of(canvas, end - 1))).replace("%4", str(end - start)) + f"\n{hint}"

    def _go_on(self, grip: DrawingGrip, event: QMouseEvent) -> None:
        if self._gesture is None or self._drag is None:
            moves = grip.part is BarPart.MIDDLE
            self._gesture = self._bridge.session.begin(self.tr("Move drawing") if moves else self.tr("Hold drawing"))
            self._drag = dragging_drawings(self._gesture.start, grip)
            self._drag.send(LanePointer(self._pressed.x(), self._scale.cell_px))
        keys = event.modifiers()
        pointer = LanePointer(
            self.place.x(),
            self._scale.cell_px,
            catches=not keys & _CONTROL,
            ripples=bool(keys & _SHIFT),
            goes_over=bool(keys & _ALT),
        )
        shown = self._drag.send(pointer)
        self._gesture.show(shown.document)
        self._exposures, self.caught_by = shown.exposures, shown.caught_by
        self.said = self._words(grip, shown.frame, grip.edge)
        if shown.note is not None:
            self.said += f"   {translated(shown.note)}"
        if grip.part is not BarPart.END:
            first = max(shown.frame, 1)
            self.choice.choose(grip.layer_id, first, first + grip.exposures[grip.last].frame - grip.frame)

    def _words(self, grip: DrawingGrip, frame: int, before: int) -> str:
        frame = max(frame, 1)
        if grip.part is BarPart.END:
            held = max(frame - max(grip.exposures[grip.index].frame, 1), 1)
            return self.tr("held %1").replace("%1", f"{held}  ({frame - before:+d})")
        canvas = self._bridge.document.canvas
        return f"{number_of(canvas, frame)}  ({frame - before:+d})   {sheet_text(frame, canvas.frame_rate)}"

    def _let_go(self) -> None:
        if self._drag is not None:
            self._drag.close()
        self._gesture = self._drag = self._grip = None
        self.is_down = False
        self.caught_by, self.said = None, ""
        self.changed.emit()
