"""The one kind of number field: drag it, type into it, calculate in it."""

from PySide6.QtCore import QPointF, Qt, Signal
from PySide6.QtGui import QFocusEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPalette
from PySide6.QtWidgets import QLabel, QLineEdit

from kagezou.document.typed_number import evaluate, is_relative
from kagezou.errors import UsageProblem
from kagezou.ui.system.theme import CHANGED, DIM, TEXT
from kagezou.ui.system.words import translated

DRAG_BEGINS_PX = 3.0
_AXIS_PX = 5
COARSE, FINE = 10.0, 0.1
MIXED = "–"
"""Shown where several values differ."""


class ScrubField(QLineEdit):
    """A number to drag sideways, or to click and type over.

    While it is dragged it sends ``dragged`` with each value, between ``drag_began`` and ``drag_ended``; a typed value
    comes as ``entered``. It never changes what it shows by itself: the owner sets the value that was accepted.

    Parameters
    ----------
    step
        The change a px of dragging, in the value's unit.
    decimals
        Digits shown behind the point at most.
    unit
        Written behind the number while it is not typed in.
    """

    drag_began = Signal()
    dragged = Signal(float)
    drag_ended = Signal(bool)
    """With whether the result is kept; false after Escape or a right click."""
    entered = Signal(float)
    calculated = Signal(str)
    """Typed while several values differ: a change of each of them, such as ``*2``."""

    def __init__(self, step: float = 1.0, decimals: int = 2, unit: str = "") -> None:
        super().__init__()
        self._value = 0.0
        self._is_mixed = False
        self._step, self._decimals, self._unit = step, decimals, unit
        self._low, self._high = float("-inf"), float("inf")
        self._pressed_at: QPointF | None = None
        self._dragging = False
        self._drag_value = self._drag_start = 0.0
        self.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setReadOnly(True)
        self.setCursor(Qt.CursorShape.SizeHorCursor)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.NoContextMenu)
        self._show()

    @property
    def value(self) -> float:
        """The number shown."""
        return self._value

    @property
    def is_typing(self) -> bool:
        """Whether someone is typing in it."""
        return not self.isReadOnly()

    @property
    def is_dragged(self) -> bool:
        """Whether it is being dragged."""
        return self._dragging

    def set_range(self, low: float, high: float) -> None:
        """Keep what is dragged and typed within a range, both ends included."""
        self._low, self._high = low, high

    def set_value(self, value: float) -> None:
        """Show a number; what is being typed stays as it is."""
        self._value, self._is_mixed = value, False
        if not self.is_typing:
            self._show()

    def show_mixed(self) -> None:
        """Show that the number is one of several that differ; a drag shows how far all of them go."""
        self._is_mixed = True
        if not self.is_typing:
            self._show()

    def begin_drag(self, at: QPointF) -> None:
        """Begin what may become a drag; also called by the label that belongs to the field."""
        self._pressed_at = at
        self._drag_value = self._drag_start = self._value

    def drag_to(self, at: QPointF, modifiers: Qt.KeyboardModifier) -> None:
        """Go on dragging."""
        if self._pressed_at is None:
            return
        if not self._dragging:
            if abs(at.x() - self._pressed_at.x()) < DRAG_BEGINS_PX:
                return
            self._dragging = True
            self._pressed_at = at
            self.drag_began.emit()
        self._drag_value += (at.x() - self._pressed_at.x()) * self._step * _speed(modifiers)
        if not self._is_mixed:
            self._drag_value = min(max(self._drag_value, self._low), self._high)
        self._pressed_at = at
        self.dragged.emit(round(self._drag_value, self._decimals))

    def end_drag(self, *, keep: bool = True) -> bool:
        """End the drag; returns whether there was one."""
        was_dragging, self._dragging, self._pressed_at = self._dragging, False, None
        if was_dragging:
            self.drag_ended.emit(keep)
        return was_dragging

    def begin_typing(self) -> None:
        """Make the number text to type over."""
        self.setReadOnly(False)
        self.setCursor(Qt.CursorShape.IBeamCursor)
        self.setText("" if self._is_mixed else _plain(self._value, self._decimals))
        self.selectAll()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if self._dragging and event.button() is Qt.MouseButton.RightButton:
            self.end_drag(keep=False)
        elif self.is_typing:
            super().mousePressEvent(event)
        elif event.button() is Qt.MouseButton.LeftButton:
            self.begin_drag(event.globalPosition())
        else:
            event.ignore()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self.is_typing:
            super().mouseMoveEvent(event)
        else:
            self.drag_to(event.globalPosition(), event.modifiers())

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self.is_typing:
            super().mouseReleaseEvent(event)
        elif event.button() is Qt.MouseButton.LeftButton and self._pressed_at is not None and not self.end_drag():
            self.begin_typing()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        match event.key():
            case Qt.Key.Key_Escape:
                self._escape(event)
            case Qt.Key.Key_Return | Qt.Key.Key_Enter:
                if self.is_typing:
                    self._accept()
                else:
                    self.begin_typing()
            case Qt.Key.Key_Up | Qt.Key.Key_Down:
                sign = 1 if event.key() == Qt.Key.Key_Up else -1
                self._step_by(sign * _speed(event.modifiers()))
            case _ if self.is_typing:
                super().keyPressEvent(event)
            case _ if event.text() and event.text() in "0123456789.+-*/(":
                self.begin_typing()
                super().keyPressEvent(event)
            case _:
                event.ignore()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        if self.is_typing:
            self._accept()
        super().focusOutEvent(event)

    def _escape(self, event: QKeyEvent) -> None:
        if self._dragging:
            self.end_drag(keep=False)
        elif self.is_typing:
            self._stop_typing()
        else:
            event.ignore()

    def _step_by(self, steps: float) -> None:
        self._stop_typing()
        step = _at_least_seen(self._step * steps, self._decimals)
        if self._is_mixed:
            self.calculated.emit(f"+={step:.9f}")
        else:
            self.entered.emit(round(min(max(self._value + step, self._low), self._high), self._decimals))

    def _accept(self) -> None:
        text = self.text()
        typed_over = text.strip() != ("" if self._is_mixed else _plain(self._value, self._decimals))
        self._stop_typing()
        if not typed_over:
            return
        try:
            number = evaluate(text, self._value)
            if self._is_mixed and is_relative(text):
                self.calculated.emit(text)
            else:
                self.entered.emit(min(max(number, self._low), self._high))
        except UsageProblem as problem:
            # What was typed is no number: the old one stays, and the field says why when one asks.
            self.setToolTip(translated(problem))

    def _stop_typing(self) -> None:
        self.setReadOnly(True)
        self.setCursor(Qt.CursorShape.SizeHorCursor)
        self.deselect()
        self._show()

    def _show(self) -> None:
        if self._is_mixed:
            away = self._drag_value - self._drag_start
            self.setText(f"{'+' if away >= 0 else ''}{_plain(away, self._decimals)}" if self._dragging else MIXED)
            return
        self.setText(f"{_plain(self._value, self._decimals)}{_gap_before(self._unit)}{self._unit}")
        self.setCursorPosition(0)


class AxisField(ScrubField):
    """A coordinate: its letter, such as ``X``, stands before the number."""

    def __init__(self, step: float, decimals: int, axis: str) -> None:
        super().__init__(step, decimals)
        self._axis = axis

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if not self.is_typing:
            painter = QPainter(self)
            painter.setPen(DIM)
            painter.drawText(self.rect().adjusted(_AXIS_PX, 0, 0, 0), Qt.AlignmentFlag.AlignVCenter, self._axis)
            painter.end()


class ScrubLabel(QLabel):
    """The name beside a number; dragging it drags the number, a double click asks for the default."""

    reset_asked = Signal()

    def __init__(self, text: str, field: ScrubField | None = None) -> None:
        super().__init__(text)
        self._field = field
        if field is not None:
            self.setCursor(Qt.CursorShape.SizeHorCursor)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if self._field is not None and self._field.isEnabled() and event.button() is Qt.MouseButton.LeftButton:
            self._field.begin_drag(event.globalPosition())
        elif self._field is not None and self._field.is_dragged:
            self._field.end_drag(keep=False)
        else:
            event.ignore()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._field is not None:
            self._field.drag_to(event.globalPosition(), event.modifiers())

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._field is not None and event.button() is Qt.MouseButton.LeftButton:
            self._field.end_drag()

    def show_changed(self, *, changed: bool) -> None:
        """Show whether the value is not the default."""
        palette = self.palette()
        for group in (QPalette.ColorGroup.Active, QPalette.ColorGroup.Inactive):
            palette.setColor(group, QPalette.ColorRole.WindowText, CHANGED if changed else TEXT)
        self.setPalette(palette)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if event.button() is Qt.MouseButton.LeftButton:
            self.reset_asked.emit()


def _speed(modifiers: Qt.KeyboardModifier) -> float:
    if modifiers & Qt.KeyboardModifier.ShiftModifier:
        return COARSE
    if modifiers & Qt.KeyboardModifier.ControlModifier:
        return FINE
    return 1.0


def _at_least_seen(step: float, decimals: int) -> float:
    """Return a step that changes at least the last digit shown."""
    smallest = 10.0**-decimals
    return max(step, smallest, key=abs) if step > 0 else min(step, -smallest)


def _gap_before(unit: str) -> str:
    return "" if unit in ("", "°", "%") else " "


def _plain(value: float, decimals: int) -> str:
    text = f"{value:.{decimals}f}"
    short = text.rstrip("0").rstrip(".") if "." in text else text
    return "0" if short == "-0" else short
