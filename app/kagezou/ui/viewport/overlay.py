"""The transparent sheet over the picture: handles, guides and the pill beside the pointer.

It is a widget of its own, painted by the processor: edges are smooth without multisampling, and following the pointer
repaints only this sheet, never the picture (measured on two cores without a graphics card: 13–16 ms against 18–20 ms
for painting into the OpenGL widget).
"""

from PySide6.QtCore import QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from kagezou.geometry.vectors import Point2
from kagezou.tools.handle import place_in_view
from kagezou.ui.viewport.handle_controller import HandleController
from kagezou.ui.viewport.handle_paths import is_wanted, paint_guide, paint_handle, paint_off_view_arrow
from kagezou.ui.viewport.viewpoint import Viewpoint
from kagezou.ui.widgets.kept_picture import KeptPicture
from kagezou.ui.widgets.picking import Picking

_EDGE = QColor(0, 0, 0, 150)
_MARK = QColor("#f0e442")
_MARK_PX = 7.0
_PILL = QColor(16, 16, 16, 225)
_PILL_EDGE = QColor(255, 255, 255, 46)
_PILL_TEXT = QColor("#f4f4f4")
_PILL_HINT = QColor("#b8b8b8")
_PILL_AWAY_PX = 18.0
_PILL_PADDING_PX = (9.0, 4.0)


class Overlay(QWidget):
    """Paints what the hand can take hold of; lets every event through to the viewport under it."""

    def __init__(self, parent: QWidget, hand: HandleController, viewpoint: Viewpoint, picking: Picking) -> None:
        super().__init__(parent)
        self._controller = hand
        self._picking = picking
        self._viewpoint = viewpoint
        self.shows_handles = True
        self.kept = KeptPicture(self, self._paint_all)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAttribute(Qt.WidgetAttribute.WA_NoSystemBackground)
        hand.changed.connect(self.update)
        viewpoint.changed.connect(self.update)
        picking.changed.connect(self.update)

    def paintEvent(self, event: QPaintEvent) -> None:
        if not self.shows_handles:
            return
        painter = QPainter(self)
        # Under a drag of anything else they stay, though the picture below them, and so they, are painted anew.
        self.kept.paint(painter, self._shown)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if self._controller.place_px is not None and (words := self._controller.words):
            self._paint_pill(painter, words, self._controller.place_px)
        painter.end()

    @property
    def _shown(self) -> tuple[object, ...]:
        """All that is painted but the pill, as a value."""
        hand, viewpoint = self._controller, self._viewpoint
        chosen = (hand.held and hand.held.id, hand.hovered_id, hand.selected_id, hand.is_busy)
        touched = () if hand.is_busy else hand.pieces.guides
        return (hand.handles, touched, chosen, self._picking.marks, viewpoint.view, viewpoint.canvas_size)

    def _paint_all(self, painter: QPainter) -> None:
        self._paint_canvas_edge(painter)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._paint_handles(painter)
        self._paint_marks(painter)

    def _paint_canvas_edge(self, painter: QPainter) -> None:
        left, top = self._viewpoint.view.view_from_canvas((0.0, 0.0))
        right, bottom = self._viewpoint.view.view_from_canvas(self._viewpoint.canvas_size)
        painter.setPen(QPen(_EDGE, 1))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRect(QRectF(QPointF(round(left) - 0.5, round(top) - 0.5), QPointF(round(right), round(bottom))))

    def _paint_handles(self, painter: QPainter) -> None:
        handles, view, size = self._controller.handles, self._viewpoint.view, self._viewpoint.size
        area = QRectF(self.rect())
        active = self._controller.held.id if self._controller.held else self._controller.hovered_id
        for guide in handles.guides:
            if is_wanted(guide.kind, (active, self._controller.selected_id)):
                paint_guide(painter, guide, view, area)
        for guide in () if self._controller.is_busy else self._controller.pieces.guides:
            paint_guide(painter, guide, view, area)
        for handle in handles.handles:
            at, off = place_in_view(handle, view, size)
            selected = handle.id == self._controller.selected_id
            paint_handle(painter, handle, at, hovered=handle.id == active, selected=selected)
            if off is not None:
                paint_off_view_arrow(painter, off, selected=selected)

    def _paint_marks(self, painter: QPainter) -> None:
        places = [QPointF(*self._viewpoint.view.view_from_canvas(place)) for place in self._picking.marks]
        arm = _MARK_PX
        # Dark under light, so that it is seen on any picture.
        for color, width in ((_EDGE, 3.5), (_MARK, 1.5)):
            painter.setPen(QPen(color, width))
            if len(places) > 1:
                painter.drawPolyline(places)
            for at in places:
                painter.drawLine(at - QPointF(arm, 0), at + QPointF(arm, 0))
                painter.drawLine(at - QPointF(0, arm), at + QPointF(0, arm))

    def _paint_pill(self, painter: QPainter, words: str, at: Point2) -> None:
        font = QFont(self.font())
        font.setFeature(QFont.Tag("tnum"), 1)
        metrics, lines = QFontMetricsF(font), words.split("\n")
        across, down = _PILL_PADDING_PX
        size = QSizeF(max(map(metrics.horizontalAdvance, lines)) + 2 * across, len(lines) * metrics.height() + 2 * down)
        pill = QRectF(pill_corner(at, (size.width(), size.height()), (self.width(), self.height())), size)
        painter.setFont(font)
        painter.setPen(QPen(_PILL_EDGE, 1))
        painter.setBrush(_PILL)
        round_px = metrics.height() / 2 + down
        painter.drawRoundedRect(pill, round_px, round_px)
        line = QRectF(pill.left(), pill.top() + down, pill.width(), metrics.height())
        # What is below the first line only explains.
        for number, text in enumerate(lines):
            painter.setPen(_PILL_HINT if number else _PILL_TEXT)
            painter.drawText(line.translated(0, number * metrics.height()), Qt.AlignmentFlag.AlignCenter, text)


def pill_corner(at: Point2, pill: Point2, room: Point2) -> QPointF:
    """Return the top left corner of the pill: below right of the pointer, on its other sides near the room's edges."""
    corner = []
    for place, length, whole in zip(at, pill, room, strict=True):
        after, before = place + _PILL_AWAY_PX, place - _PILL_AWAY_PX - length
        corner.append(after if after + length <= whole - 2 or before < 2 else before)
    return QPointF(*corner)
