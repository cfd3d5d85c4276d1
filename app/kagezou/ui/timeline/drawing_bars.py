"""The bars of drawings on a layer's row: where they lie, what of one is under the pointer, and how they look."""

from dataclasses import dataclass

from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from kagezou.document.model import Layer
from kagezou.tools.timeline.drawing_drag import BarPart
from kagezou.ui.system.theme import DIM, SELECTED, TEXT
from kagezou.ui.timeline.drawing_choice import DrawingChoice
from kagezou.ui.timeline.time_scale import TimeScale

SUM_LANE_PX = 11
"""Height of the strip under a layer's drawings in which its keys are summed up."""
EDGE_PX = 10.0
"""How near the pointer has to be to take hold of an end."""
_BAR = QColor("#4a4a4a")
_BAR_EDGE = QColor("#6a6a6a")
_CHOSEN = QColor("#5d5a35")


@dataclass(frozen=True, slots=True)
class Bar:
    """An exposure as it is seen, in widget x; ``is_last`` if no other follows."""

    index: int
    left: float
    right: float
    drawing: int | None
    is_last: bool


def bars_of(layer: Layer, scale: TimeScale, width: float) -> list[Bar]:
    """Return the bars that are seen within a width, empty cels included."""
    exposures, end_of_cut = layer.cels.exposures, scale.length + 1
    bars = []
    for index, exposure in enumerate(exposures):
        end = exposures[index + 1].frame if index + 1 < len(exposures) else end_of_cut
        left, right = scale.x_of(max(exposure.frame, 1)), scale.x_of(min(end, end_of_cut))
        if left < right and right > 0 and left < width:
            bars.append(Bar(index, left, right, exposure.drawing, index + 1 == len(exposures)))
    return bars


def part_at(bars: list[Bar], x: float) -> tuple[Bar, BarPart] | None:
    """Return the bar and the part of it at an x; an end wins within reach, and a third of the bar is always middle.

    A boundary between two bars is the end of the left one and the start of the right one, as the pointer comes.
    """
    bar = next((each for each in bars if each.left <= x < each.right), None)
    if bar is None:
        # A hand that comes from behind the last bar finds its end too.
        near = [each for each in bars if each.is_last and 0 <= x - each.right <= EDGE_PX]
        return (near[0], BarPart.END) if near else None
    reach = min(EDGE_PX, (bar.right - bar.left) / 3)
    if x - bar.left <= reach:
        return bar, BarPart.START
    return bar, BarPart.END if bar.right - x < reach else BarPart.MIDDLE


def paint_bars(painter: QPainter, layer: Layer, bars: list[Bar], band: QRectF, choice: DrawingChoice) -> None:
    """Paint the bars into a band of the height of the row."""
    metrics = painter.fontMetrics()
    height = band.height() - SUM_LANE_PX - 3
    for bar in bars:
        chosen = choice.holds(layer.id, bar.index)
        area = QRectF(bar.left + 0.5, band.top() + 2.5, max(bar.right - bar.left - 1, 1), height)
        if bar.drawing is None:
            _paint_empty(painter, area, chosen=chosen)
            continue
        painter.fillRect(area, _CHOSEN if chosen else _BAR)
        edge = SELECTED if chosen else _BAR_EDGE
        painter.fillRect(QRectF(area.left(), area.top(), min(2.0, area.width()), area.height()), edge)
        room = bar.right - max(bar.left, 0) - 8
        if room > metrics.horizontalAdvance("0"):
            painter.setPen(TEXT)
            name = layer.cels.drawings[bar.drawing].name
            shown = metrics.elidedText(name, Qt.TextElideMode.ElideMiddle, int(room))
            place = QRectF(max(bar.left, 0) + 5, area.top(), room, area.height())
            painter.drawText(place, Qt.AlignmentFlag.AlignVCenter, shown if shown != "…" else "")


def _paint_empty(painter: QPainter, area: QRectF, *, chosen: bool) -> None:
    """Paint an empty cel: a cross in its first cell, as on paper sheets, and nothing behind it."""
    if chosen:
        painter.fillRect(area, QColor(_CHOSEN.red(), _CHOSEN.green(), _CHOSEN.blue(), 120))
    painter.setPen(QPen(SELECTED if chosen else DIM, 1.3))
    middle = QPointF(area.left() + min(9.0, area.width() / 2), area.center().y())
    arm = min(3.5, area.width() / 3)
    for turn in (1, -1):
        painter.drawLine(QLineF(middle - QPointF(arm, turn * arm), middle + QPointF(arm, turn * arm)))
