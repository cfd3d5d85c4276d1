"""How the frame around the selected keys looks, and the pointer on it."""

import pyqtgraph as pg
from PySide6.QtCore import QRectF, Qt

from kagezou.tools.curves.key_box import BoxGrip, KeyBox
from kagezou.ui.system.theme import SELECTED, WELL

_HANDLE_PX = 8


def cursor_on(part: BoxGrip) -> Qt.CursorShape:
    """Return what the pointer looks like on a part of the frame."""
    if part.is_inside:
        return Qt.CursorShape.SizeAllCursor
    if part.across and part.up:
        rising = part.across == part.up
        return Qt.CursorShape.SizeBDiagCursor if rising else Qt.CursorShape.SizeFDiagCursor
    return Qt.CursorShape.SizeHorCursor if part.across else Qt.CursorShape.SizeVerCursor


class BoxItems:
    """The frame on the graph: its outline and its handles."""

    def __init__(self, plot: pg.PlotItem) -> None:
        self._outline = pg.QtWidgets.QGraphicsRectItem()
        self._outline.setPen(pg.mkPen(SELECTED, width=1, style=Qt.PenStyle.DashLine))
        self._outline.setZValue(-5)
        self._handles = pg.ScatterPlotItem(
            symbol="s", size=_HANDLE_PX, pen=pg.mkPen(SELECTED, width=1.4), brush=pg.mkBrush(WELL)
        )
        self._handles.setZValue(20)
        for item in (self._outline, self._handles):
            plot.addItem(item, ignoreBounds=True)

    def show(self, box: KeyBox | None) -> None:
        """Draw the frame where it is now, or take it away."""
        self._outline.setVisible(box is not None)
        self._handles.setVisible(box is not None)
        if box is not None:
            outline = box.padded
            width, height = outline.right - outline.left, outline.high - outline.low
            self._outline.setRect(QRectF(outline.left, outline.low, width, height))
            self._handles.setData(pos=[box.place_of(part) for part in box.parts])
