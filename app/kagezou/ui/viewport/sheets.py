"""Transparent sheets over the picture, under the handles: guides, and a snapshot to compare with."""

from PySide6.QtCore import QEvent, QObject, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QImage, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from kagezou.ui.viewport.viewpoint import Viewpoint

ACTION_SAFE, TITLE_SAFE = 0.9, 0.8
FIELDS = 12
"""Fields of the guide animators frame with: each is a twelfth of the canvas, all around one middle."""

_DARK, _LIGHT = QColor(0, 0, 0, 120), QColor(255, 255, 255, 200)
_PILL = QColor(16, 16, 16, 225)


class OverlaySheet(QWidget):
    """Covers the viewport and lets every event through.

    Parameters
    ----------
    viewport
        What it covers.
    viewpoint
        How the canvas is looked at.
    """

    def __init__(self, viewport: QWidget, viewpoint: Viewpoint) -> None:
        super().__init__(viewport)
        self._viewpoint = viewpoint
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAttribute(Qt.WidgetAttribute.WA_NoSystemBackground)
        viewport.installEventFilter(self)
        viewpoint.changed.connect(self.update)
        self.hide()

    @property
    def canvas(self) -> QRectF:
        """Where the canvas lies, logical px."""
        left, top = self._viewpoint.view.view_from_canvas((0.0, 0.0))
        right, bottom = self._viewpoint.view.view_from_canvas(self._viewpoint.canvas_size)
        return QRectF(QPointF(left, top), QPointF(right, bottom))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        parent = self.parentWidget()
        if event.type() is QEvent.Type.Resize and parent is not None:
            self.resize(parent.size())
        return super().eventFilter(watched, event)


class Guides(OverlaySheet):
    """Safe area and field guide: light lines with a dark rim, to be seen on any picture."""

    def __init__(self, viewport: QWidget, viewpoint: Viewpoint) -> None:
        super().__init__(viewport, viewpoint)
        self._safe = self._fields = False

    def show_safe_area(self, on: bool) -> None:
        """Show or hide what every screen shows, and what is safe for words."""
        self._safe = on
        self._follow()

    def show_field_guide(self, on: bool) -> None:
        """Show or hide the twelve fields."""
        self._fields = on
        self._follow()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setOpacity(0.7)
        for color, width in ((_DARK, 2.0), (_LIGHT, 1.0)):
            painter.setPen(QPen(color, width))
            self._paint_lines(painter)
        painter.end()

    def _paint_lines(self, painter: QPainter) -> None:
        canvas = self.canvas
        middle = canvas.center()
        if self._fields:
            for field in range(1, FIELDS + 1):
                painter.drawRect(_part(canvas, field / FIELDS))
            painter.drawLine(QPointF(canvas.left(), middle.y()), QPointF(canvas.right(), middle.y()))
            painter.drawLine(QPointF(middle.x(), canvas.top()), QPointF(middle.x(), canvas.bottom()))
        if self._safe:
            arm = 0.02 * canvas.width()
            painter.drawRect(_part(canvas, ACTION_SAFE))
            painter.drawRect(_part(canvas, TITLE_SAFE))
            painter.drawLine(middle - QPointF(arm, 0), middle + QPointF(arm, 0))
            painter.drawLine(middle - QPointF(0, arm), middle + QPointF(0, arm))

    def _follow(self) -> None:
        self.setVisible(self._safe or self._fields)
        self.update()


class Snapshot(OverlaySheet):
    """A picture taken before, laid over the present one, whole or only to the left of the pointer."""

    def __init__(self, viewport: QWidget, viewpoint: Viewpoint) -> None:
        super().__init__(viewport, viewpoint)
        self.image = QImage()
        self._wipes = False
        self._edge = 0.5

    def take(self, image: QImage) -> None:
        """Keep a picture."""
        self.image = image
        self.update()

    def wipe(self, on: bool) -> None:
        """Show it only up to the pointer, or whole."""
        self._wipes = on
        self.update()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if self._wipes and self.isVisible() and isinstance(event, QMouseEvent):
            self._edge = event.position().x() / max(self.width(), 1)
            self.update()
        return super().eventFilter(watched, event)

    def paintEvent(self, event: QPaintEvent) -> None:
        if self.image.isNull():
            return
        painter = QPainter(self)
        edge = self._edge * self.width() if self._wipes else self.width()
        painter.setClipRect(QRectF(0, 0, edge, self.height()))
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, self._viewpoint.percent < 200)
        painter.drawImage(self.canvas, self.image)
        painter.setClipping(False)
        if self._wipes:
            for color, width in ((_DARK, 3.0), (_LIGHT, 1.0)):
                painter.setPen(QPen(color, width))
                painter.drawLine(QPointF(edge, 0), QPointF(edge, self.height()))
        self._paint_name(painter)
        painter.end()

    def _paint_name(self, painter: QPainter) -> None:
        words, metrics = self.tr("Snapshot"), self.fontMetrics()
        pill = QRectF(12, 12, metrics.horizontalAdvance(words) + 20, metrics.height() + 8)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(_PILL)
        painter.drawRoundedRect(pill, pill.height() / 2, pill.height() / 2)
        painter.setPen(_LIGHT)
        painter.drawText(pill, Qt.AlignmentFlag.AlignCenter, words)


def _part(canvas: QRectF, part: float) -> QRectF:
    made = QRectF(0, 0, canvas.width() * part, canvas.height() * part)
    made.moveCenter(canvas.center())
    return made
