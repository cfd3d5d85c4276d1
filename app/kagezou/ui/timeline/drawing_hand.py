"""The hand on the bars of drawings: choosing them, holding them longer or shorter, moving them."""

from dataclasses import dataclass

from PySide6.QtCore import QObject, QPointF, Qt, Signal
from PySide6.QtGui import QMouseEvent

from kagezou.animation.timecode import sheet_text
from kagezou.document.edits import set_exposures
from kagezou.document.exposure_edits import Exposures, end_at, move_boundary, move_run, ripple, with_exposures
from kagezou.session.session import Gesture
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.timeline.drawing_bars import SUM_LANE_PX, Bar, BarPart, bars_of, part_at
from kagezou.ui.timeline.drawing_choice import DrawingChoice
from kagezou.ui.timeline.row_list import RowList
from kagezou.ui.timeline.rows import RowKind
from kagezou.ui.timeline.snapping import snap_frames, snapped
from kagezou.ui.timeline.time_scale import TimeScale

_DRAG_PX = 4.0
_SHIFT = Qt.KeyboardModifier.ShiftModifier
_CONTROL = Qt.KeyboardModifier.ControlModifier


@dataclass(frozen=True, slots=True)
class DrawingGrip:
    """What the hand has taken hold of, with the exposures as they were and the frames that catch."""

    layer_id: str
    part: BarPart
    index: int
    last: int
    exposures: Exposures
    catching: tuple[int, ...]

    @property
    def frame(self) -> int:
        """Where what is dragged lay."""
        if self.part is BarPart.END and self.index + 1 < len(self.exposures):
            return self.exposures[self.index + 1].frame
        return max(self.exposures[self.index].frame, 1)


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
        first, last = bar.index, bar.index
        if part is BarPart.MIDDLE and self.choice.holds(layer_id, bar.index):
            first, last = self.choice.run or (first, last)
        catching = snap_frames(self._bridge.document, self._bridge.frame)
        own = {exposures[each].frame for each in range(first, last + 1)}
        grip = DrawingGrip(layer_id, part, first, last, exposures, ())
        kept = tuple(frame for frame in (*catching, self._scale.length + 1) if frame not in {*own, grip.frame})
        self._grip = DrawingGrip(layer_id, part, first, last, exposures, tuple(sorted(kept)))
        return True

    def move(self, event: QMouseEvent) -> None:
        """Take a move with the left button down."""
        self.place = event.position()
        far = (self.place - self._pressed).manhattanLength() >= _DRAG_PX
        if self._grip is not None and (self.is_busy or far):
            self._drag(self._grip, event)
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
        words = self.tr("%1: frames %2 to %3, held %4").replace("%1", name).replace("%2", str(start))
        hint = self.tr(
            "Drag an end to hold it longer or shorter (Shift: what follows moves along), the middle to move it"
        )
        return words.replace("%3", str(end - 1)).replace("%4", str(end - start)) + f"\n{hint}"

    def _drag(self, grip: DrawingGrip, event: QMouseEvent) -> None:
        moves = grip.part is BarPart.MIDDLE
        if self._gesture is None:
            self._gesture = self._bridge.session.begin(self.tr("Move drawing") if moves else self.tr("Hold drawing"))
        away = (self.place.x() - self._pressed.x()) / self._scale.cell_px
        catches = not event.modifiers() & _CONTROL
        last_of_cut = grip.part is BarPart.END and grip.index + 1 == len(grip.exposures)
        start = self._scale.length + 1 if last_of_cut else grip.frame
        frame, self.caught_by = snapped(start + away, grip.catching if catches else (), self._scale.cell_px)
        self._exposures = self._dragged(grip, frame, ripples=bool(event.modifiers() & _SHIFT))
        # The cut grows when the hand lets go: before that the frames would move under the hand.
        self._gesture.show(set_exposures(self._gesture.start, grip.layer_id, self._exposures))
        self.said = self._words(grip, frame, start)
        if grip.part is not BarPart.END:
            first = max(frame, 1)
            self.choice.choose(grip.layer_id, first, first + grip.exposures[grip.last].frame - grip.frame)

    def _dragged(self, grip: DrawingGrip, frame: int, *, ripples: bool) -> Exposures:
        match grip.part:
            case BarPart.MIDDLE if not ripples:
                return move_run(grip.exposures, grip.index, grip.last, frame)
            case BarPart.END:
                if grip.index + 1 == len(grip.exposures) and frame > self._scale.length:
                    return grip.exposures
                return end_at(grip.exposures, grip.index, frame, ripples=ripples)
            case _:
                return (ripple if ripples else move_boundary)(grip.exposures, grip.index, frame)

    def _words(self, grip: DrawingGrip, frame: int, before: int) -> str:
        frame = max(frame, 1)
        if grip.part is BarPart.END:
            held = max(frame - max(grip.exposures[grip.index].frame, 1), 1)
            return self.tr("held %1").replace("%1", f"{held}  ({frame - before:+d})")
        return f"{frame}  ({frame - before:+d})   {sheet_text(frame, self._bridge.document.canvas.frame_rate)}"

    def _let_go(self) -> None:
        self._gesture, self._grip, self.is_down = None, None, False
        self.caught_by, self.said = None, ""
        self.changed.emit()
