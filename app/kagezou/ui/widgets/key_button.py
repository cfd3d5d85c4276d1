"""The diamond before a property: not keyed, keyed elsewhere, keyed here."""

from enum import StrEnum

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QAbstractButton, QWidget

from kagezou.ui.system.theme import BRIGHT, DIM, SELECTED, TEXT


class KeyState(StrEnum):
    """What a property has at the frame looked at."""

    NONE = "none"
    KEYED = "keyed"
    HERE = "here"


class KeyButton(QAbstractButton):
    """A click sets a key here, or takes the one that is here away; the shape alone tells the three states apart."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._state = KeyState.NONE
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self.show_state(KeyState.NONE)

    @property
    def state(self) -> KeyState:
        """What is shown."""
        return self._state

    def show_state(self, state: KeyState) -> None:
        """Show one of the three states."""
        said = {
            KeyState.NONE: self.tr("No keys. Click to set a key on this frame"),
            KeyState.KEYED: self.tr("Keyed on other frames. Click to set a key on this frame"),
            KeyState.HERE: self.tr("Keyed on this frame. Click to remove the key"),
        }
        self._state = state
        self.setToolTip(said[state])
        self.setAccessibleName(said[state])
        self.update()

    def sizeHint(self) -> QSize:
        side = max(self.fontMetrics().height(), 18)
        return QSize(side, side)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        middle, radius = QPointF(self.width() / 2, self.height() / 2), 4.6
        hovered = self.isEnabled() and (self.underMouse() or self.hasFocus())
        match self._state:
            case KeyState.NONE:
                painter.setPen(QPen(BRIGHT if hovered else DIM, 1.4))
                painter.drawPolygon(_diamond(middle, radius - 0.8))
            case KeyState.KEYED:
                painter.setPen(QPen(BRIGHT if hovered else TEXT, 1.4))
                painter.drawPolygon(_diamond(middle, radius))
                painter.setBrush(DIM)
                painter.drawPolygon(_diamond(middle, radius / 3))
            case KeyState.HERE:
                painter.setPen(QPen(SELECTED, 1.4))
                painter.setBrush(SELECTED)
                painter.drawPolygon(_diamond(middle, radius))
        if self.hasFocus():
            painter.setPen(QPen(BRIGHT, 1))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRoundedRect(QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3)
        painter.end()


def _diamond(middle: QPointF, radius: float) -> QPolygonF:
    x, y = QPointF(radius, 0), QPointF(0, radius)
    return QPolygonF([middle - y, middle + x, middle + y, middle - x])
