"""The frame ruler: every frame of the cut, its seconds, its keys and the playhead, to click and drag on."""

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from kagezou.ui.bridge import Bridge
from kagezou.ui.key_frames import key_frames
from kagezou.ui.theme import BRIGHT, DIM, LINE, OFF, SELECTED, TEXT, WELL
from kagezou.ui.timecode import frames_per_second, sheet_text

_LABEL_STEPS = (1, 2, 4, 6, 12, 24, 48, 72, 144, 240, 480, 720, 1440, 2880, 7200, 14400)
_MIN_LABEL_PX = 34
_MIN_TICK_PX = 4
_KEY_RADIUS_PX = 4.0
_MARGIN_PX = 10


class Ruler(QWidget):
    """Shows and sets the frame; each frame is a cell, counted from 1."""

    def __init__(self, bridge: Bridge) -> None:
        super().__init__()
        self._bridge = bridge
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setMouseTracking(True)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self.setAccessibleName(self.tr("Frame ruler"))
        bridge.frame_changed.connect(self.update)
        bridge.document_changed.connect(self.update)
        bridge.selection_changed.connect(self.update)

    def sizeHint(self) -> QSize:
        return QSize(400, self.fontMetrics().height() + 20)

    def frame_at(self, x: float) -> int:
        """Return the frame whose cell lies at a widget x, kept within the cut."""
        frame = int((x - _MARGIN_PX) // self._cell_px) + 1
        return min(max(frame, 1), self._length)

    def x_of(self, frame: float) -> float:
        """Return the widget x of the left edge of a frame's cell."""
        return _MARGIN_PX + (frame - 1) * self._cell_px

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() is Qt.MouseButton.LeftButton:
            self._bridge.session.go_to(self.frame_at(event.position().x()))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        frame = self.frame_at(event.position().x())
        self.setToolTip(f"{frame}  ({sheet_text(frame, self._bridge.document.canvas.frame_rate)})")
        if event.buttons() & Qt.MouseButton.LeftButton:
            self._bridge.session.go_to(frame)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), WELL)
        self._paint_ticks(painter)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._paint_keys(painter)
        self._paint_playhead(painter)
        painter.setPen(QPen(LINE, 1))
        painter.drawLine(0, 0, self.width(), 0)
        painter.end()

    @property
    def _length(self) -> int:
        return self._bridge.document.canvas.length_frames

    @property
    def _cell_px(self) -> float:
        return max((self.width() - 2 * _MARGIN_PX) / self._length, 1e-6)

    def _step(self, smallest_px: float) -> int:
        return next((step for step in _LABEL_STEPS if step * self._cell_px >= smallest_px), _LABEL_STEPS[-1])

    def _paint_ticks(self, painter: QPainter) -> None:
        rate = frames_per_second(self._bridge.document.canvas.frame_rate)
        label_step, tick_step = self._step(_MIN_LABEL_PX), self._step(_MIN_TICK_PX)
        text_height = self.fontMetrics().height()
        for frame in range(1, self._length + 2, tick_step):
            x = round(self.x_of(frame)) + 0.5
            is_second, is_labelled = (frame - 1) % rate == 0, (frame - 1) % label_step == 0
            top = 4 if is_second else text_height + (4 if is_labelled else 9)
            painter.setPen(QPen(DIM if is_second else QColor("#4c4c4c") if is_labelled else QColor("#383838"), 1))
            painter.drawLine(QPointF(x, top), QPointF(x, self.height()))
            if is_labelled and frame <= self._length:
                painter.setPen(TEXT if is_second else DIM)
                painter.drawText(QPointF(x + 4, text_height), str(frame))

    def _paint_keys(self, painter: QPainter) -> None:
        painter.setPen(Qt.PenStyle.NoPen)
        y = self.height() - _KEY_RADIUS_PX - 3
        for frame in key_frames(self._bridge.document, self._bridge.layer_id):
            painter.setBrush(SELECTED if frame == self._bridge.frame else TEXT)
            x, r = self.x_of(frame + 0.5), _KEY_RADIUS_PX
            diamond = [QPointF(x, y - r), QPointF(x + r, y), QPointF(x, y + r), QPointF(x - r, y)]
            painter.drawPolygon(QPolygonF(diamond))

    def _paint_playhead(self, painter: QPainter) -> None:
        left, width = self.x_of(self._bridge.frame), max(self._cell_px, 2.0)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(255, 255, 255, 34))
        painter.drawRect(QRectF(left, 1, width, self.height()))
        painter.setBrush(BRIGHT if self.isEnabled() else OFF)
        middle = left + width / 2
        painter.drawRect(QRectF(middle - 0.75, 1, 1.5, self.height()))
        head = [QPointF(middle - 5, 1), QPointF(middle + 5, 1), QPointF(middle + 5, 5), QPointF(middle, 10)]
        painter.drawPolygon(QPolygonF([*head, QPointF(middle - 5, 5)]))
