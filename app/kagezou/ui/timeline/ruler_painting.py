"""How time looks on the ruler: ticks and labels, the work area, markers with their flags, and the playhead."""

from collections.abc import Sequence, Set
from dataclasses import dataclass
from typing import Final

from PySide6.QtCore import QLineF, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetrics, QPainter, QPen, QPolygonF

from kagezou.animation.timecode import Count, counted, frames_per_second
from kagezou.document.model import Canvas, Document, Layer, Marker
from kagezou.picture_source import PictureSource
from kagezou.ui.system.theme import BRIGHT, CHANGED, DIM, TEXT, WARNING
from kagezou.ui.timeline.time_scale import TimeScale

STRIP_PX: Final = 7
"""Height of the strip of the work area, at the bottom."""
_STEPS: Final = (1, 2, 4, 6, 12, 24, 48, 72, 144, 240, 480, 720, 1440, 2880, 7200, 14400)
_MIN_LABEL_PX: Final = 40
_MIN_TICK_PX: Final = 4
_READY_PX, _FINISHED_PX = 2.5, 4.0
_READY, _FINISHED = QColor("#2f6b4c"), QColor("#5fd39a")
_AREA = QColor("#9a7a35")
_AREA_END = QColor("#e0b04c")


@dataclass(frozen=True, slots=True)
class Ready:
    """What can be seen at once: the pictures that are decoded, and the frames that are kept as they are seen."""

    kept: Set[PictureSource]
    finished: Set[int]


def paint_ready(painter: QPainter, scale: TimeScale, layers: Sequence[Layer], ready: Ready, size: QSize) -> None:
    """Paint a bar under frames that are decoded, and a higher one under those that are kept as they are seen."""
    bottom = size.height() - STRIP_PX - 1
    for frame in range(scale.frame_at(0), scale.frame_at(size.width()) + 1):
        needed = (layer.cels.drawing_at(frame) for layer in layers)
        # The higher bar reads without its colour.
        if frame in ready.finished:
            high, color = _FINISHED_PX, _FINISHED
        elif all(drawing is None or drawing.source in ready.kept for drawing in needed):
            high, color = _READY_PX, _READY
        else:
            continue
        left, right = scale.x_of(frame), scale.x_of(frame + 1)
        painter.fillRect(QRectF(left, bottom - high, right - left, high), color)


def paint_area(painter: QPainter, scale: TimeScale, document: Document, height_px: int) -> None:
    """Paint the strip of the work area at the bottom, or of the whole cut where none is set."""
    first, last = document.played
    left, right = scale.x_of(first), scale.x_of(last + 1)
    top = height_px - STRIP_PX
    is_set = document.work_area is not None
    painter.fillRect(QRectF(left, top, right - left, STRIP_PX - 1), _AREA if is_set else QColor("#3c3c3c"))
    for x in (left, right - 3):
        painter.fillRect(QRectF(x, top - 1, 3, STRIP_PX), _AREA_END if is_set else QColor("#7a7a7a"))


def paint_ticks(painter: QPainter, scale: TimeScale, size: QSize, canvas: Canvas, count: Count) -> None:
    """Paint ticks as close as they can be told apart, and frames counted in one way as close as they can be read."""
    rate = canvas.frame_rate
    a_second = frames_per_second(rate)
    label_step, tick_step = _step(scale, _MIN_LABEL_PX), _step(scale, _MIN_TICK_PX)
    text_height, bottom = painter.fontMetrics().height(), size.height() - STRIP_PX
    first = max(int((scale.position_at(0) - 1) // label_step), 0) * label_step + 1
    last = min(int(scale.position_at(size.width())) + 1, scale.length + 1)
    for frame in range(first, last + 1, tick_step):
        x = round(scale.x_of(frame)) + 0.5
        is_second, is_labelled = (frame - 1) % a_second == 0, (frame - 1) % label_step == 0
        top = 4 if is_second else text_height + (2 if is_labelled else 6)
        painter.setPen(QPen(DIM if is_second else QColor("#4c4c4c") if is_labelled else QColor("#383838"), 1))
        painter.drawLine(QLineF(x, top, x, bottom))
        if is_labelled and frame <= scale.length:
            painter.setPen(TEXT if is_second else DIM)
            painter.drawText(QPointF(x + 4, text_height - 1), counted(frame, rate, count, canvas.first_frame))


def flag_of(marker: Marker, scale: TimeScale, metrics: QFontMetrics) -> QRectF:
    """Return where the flag of a marker lies."""
    width = min(metrics.horizontalAdvance(marker.comment), 120) + 12 if marker.comment else 9
    return QRectF(scale.middle_of(marker.frame), 1, width, metrics.height() + 1)


def paint_marker(painter: QPainter, scale: TimeScale, marker: Marker, height_px: int) -> None:
    """Paint a marker: a line with a flag, which bears its comment, and how long it lasts."""
    metrics = painter.fontMetrics()
    flag = flag_of(marker, scale, metrics)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(CHANGED)
    if marker.duration_frames:
        end = scale.x_of(marker.frame + marker.duration_frames)
        painter.drawRect(QRectF(flag.left(), flag.bottom() - 2, max(end - flag.left(), 0), 2))
    x, bottom = flag.left(), float(height_px - STRIP_PX)
    painter.drawRect(QRectF(x - 0.75, 1, 1.5, bottom - 1))
    if not marker.comment:
        painter.drawPolygon(QPolygonF([QPointF(x, 1), QPointF(x + 9, 5), QPointF(x, 10)]))
        return
    painter.setBrush(QColor("#22414f"))
    painter.drawRoundedRect(flag, 2, 2)
    painter.setPen(BRIGHT)
    words = metrics.elidedText(marker.comment, Qt.TextElideMode.ElideRight, int(flag.width()) - 8)
    painter.drawText(flag.adjusted(5, 0, -3, 0), Qt.AlignmentFlag.AlignVCenter, words)


def note_mark(frame: int, scale: TimeScale, height_px: int) -> QRectF:
    """Return where the mark of the notes on a frame lies."""
    return QRectF(scale.middle_of(frame) - 4, height_px - STRIP_PX - 12, 8, 8)


def paint_note(painter: QPainter, mark: QRectF, *, is_done: bool) -> None:
    """Paint the mark of notes: a diamond, hollow where all of them are ticked off."""
    painter.setPen(QPen(WARNING, 1.2))
    painter.setBrush(Qt.BrushStyle.NoBrush if is_done else WARNING)
    middle = mark.center()
    left, right = QPointF(mark.left(), middle.y()), QPointF(mark.right(), middle.y())
    top, bottom = QPointF(middle.x(), mark.top()), QPointF(middle.x(), mark.bottom())
    painter.drawPolygon(QPolygonF([left, top, right, bottom]))


def paint_playhead(painter: QPainter, left: float, width: float, height_px: int, color: QColor) -> None:
    """Paint the cell of the frame looked at, and a line with a head in the middle of it."""
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QColor(255, 255, 255, 34))
    painter.drawRect(QRectF(left, 1, width, height_px))
    painter.setBrush(color)
    middle = left + width / 2
    painter.drawRect(QRectF(middle - 0.75, 1, 1.5, height_px))
    head = [QPointF(middle - 5, 1), QPointF(middle + 5, 1), QPointF(middle + 5, 5), QPointF(middle, 10)]
    painter.drawPolygon(QPolygonF([*head, QPointF(middle - 5, 5)]))


def _step(scale: TimeScale, smallest_px: float) -> int:
    return next((step for step in _STEPS if step * scale.cell_px >= smallest_px), _STEPS[-1])
