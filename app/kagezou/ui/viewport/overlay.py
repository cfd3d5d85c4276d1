"""The transparent sheet over the picture: handles, guides and the pill beside the pointer.

It is a widget of its own, painted by the processor: edges are smooth without multisampling, and following the pointer
repaints only this sheet, never the picture (measured on two cores without a graphics card: 13–16 ms against 18–20 ms
for painting into the OpenGL widget).
"""

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from kagezou.geometry.vectors import Point2
from kagezou.tools.handle import place_in_view
from kagezou.ui.viewport.hand import Hand
from kagezou.ui.viewport.handle_paths import paint_guide, paint_handle, paint_off_view_arrow
from kagezou.ui.viewport.viewpoint import Viewpoint

_PILL = QColor(16, 16, 16, 225)
_PILL_EDGE = QColor(255, 255, 255, 46)
_PILL_TEXT = QColor("#f4f4f4")
_PILL_AWAY_PX = 18.0
_PILL_PADDING_PX = (9.0, 4.0)


class Overlay(QWidget):
    """Paints what the hand can take hold of; lets every event through to the viewport under it."""

    def __init__(self, parent: QWidget, hand: Hand, viewpoint: Viewpoint) -> None:
        super().__init__(parent)
        self._hand = hand
        self._viewpoint = viewpoint
        self.shows_handles = True
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAttribute(Qt.WidgetAttribute.WA_NoSystemBackground)
        hand.changed.connect(self.update)
        viewpoint.changed.connect(self.update)

    def paintEvent(self, event: QPaintEvent) -> None:
        if not self.shows_handles:
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._paint_handles(painter)
        if self._hand.place_px is not None and (words := self._hand.words):
            self._paint_pill(painter, words, self._hand.place_px)
        painter.end()

    def _paint_handles(self, painter: QPainter) -> None:
        handles, view, size = self._hand.handles, self._viewpoint.view, self._viewpoint.size
        area = QRectF(self.rect())
        for guide in handles.guides:
            paint_guide(painter, guide, view, area)
        active = self._hand.held.id if self._hand.held else self._hand.hovered_id
        for handle in handles.handles:
            at, off = place_in_view(handle, view, size)
            selected = handle.id == self._hand.selected_id
            if off is not None:
                paint_off_view_arrow(painter, off, selected=selected)
            paint_handle(painter, handle, at, hovered=handle.id == active, selected=selected)

    def _paint_pill(self, painter: QPainter, words: str, at: Point2) -> None:
        font = QFont(self.font())
        font.setFeature(QFont.Tag("tnum"), 1)
        metrics = QFontMetricsF(font)
        wide = metrics.horizontalAdvance(words) + 2 * _PILL_PADDING_PX[0]
        high = metrics.height() + 2 * _PILL_PADDING_PX[1]
        pill = QRectF(pill_corner(at, (wide, high), (self.width(), self.height())), QPointF())
        pill.setSize(QRectF(0, 0, wide, high).size())
        painter.setFont(font)
        painter.setPen(QPen(_PILL_EDGE, 1))
        painter.setBrush(_PILL)
        painter.drawRoundedRect(pill, high / 2, high / 2)
        painter.setPen(_PILL_TEXT)
        painter.drawText(pill, Qt.AlignmentFlag.AlignCenter, words)


def pill_corner(at: Point2, pill: Point2, room: Point2) -> QPointF:
    """Return the top left corner of the pill: below right of the pointer, on its other sides near the room's edges."""
    corner = []
    for place, length, whole in zip(at, pill, room, strict=True):
        after, before = place + _PILL_AWAY_PX, place - _PILL_AWAY_PX - length
        corner.append(after if after + length <= whole - 2 or before < 2 else before)
    return QPointF(*corner)
