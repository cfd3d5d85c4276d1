"""A transparent sheet on the graph on which several curves are drawn, and drawn anew only where they changed."""

from collections.abc import Callable, Sequence

import pyqtgraph as pg
from PySide6.QtCore import QRectF
from PySide6.QtGui import QPainter
from PySide6.QtWidgets import QGraphicsItem, QStyleOptionGraphicsItem, QWidget

from kagezou.tools.curves.differences import NOWHERE, Span
from kagezou.ui.curves.drawn_curve import DrawnCurve

_ROOM_PX = 8
"""So far from where it is something may be seen: half a key, and half a line."""

Drawing = Callable[[DrawnCurve, QPainter, Span], None]
"""Draws what is between two frames of a curve, or more, in graph coordinates."""


class CurveSheet(pg.GraphicsObject):
    """What is drawn of some curves, as one item that is kept as a picture.

    As an item each, forty things of twenty curves took half of a painting: for each of them Qt asks Python for its
    bounds, and puts a picture of the whole graph over the others.

    Parameters
    ----------
    draw
        Draws a curve.
    height
        Sheets that are higher lie over others.
    """

    def __init__(self, draw: Drawing, height: int) -> None:
        self._bounds = QRectF()
        super().__init__()
        self._draw = draw
        self._curves: Sequence[DrawnCurve] = ()
        self.times_painted = 0
        self.painted: Span = NOWHERE
        self.setZValue(height)
        self.setFlag(QGraphicsItem.GraphicsItemFlag.ItemUsesExtendedStyleOption)
        self.setCacheMode(QGraphicsItem.CacheMode.DeviceCoordinateCache)

    def show_curves(self, curves: Sequence[DrawnCurve], changed: Span) -> None:
        """Draw these curves, which are others than before between two frames."""
        self._curves = curves
        if changed == NOWHERE:
            return
        room = _ROOM_PX * self._frames_a_px()
        left = max(changed[0] - room, self._bounds.left())
        right = min(changed[1] + room, self._bounds.right())
        if left < right:
            self.update(QRectF(left, self._bounds.top(), right - left, self._bounds.height()))

    def boundingRect(self) -> QRectF:
        return self._bounds

    def paint(self, painter: QPainter, option: QStyleOptionGraphicsItem, widget: QWidget | None = None) -> None:
        del widget
        exposed = QRectF(option.exposedRect)
        room = _ROOM_PX * self._frames_a_px()
        self.times_painted += 1
        self.painted = exposed.left(), exposed.right()
        for curve in self._curves:
            self._draw(curve, painter, (exposed.left() - room, exposed.right() + room))

    def viewTransformChanged(self) -> None:
        super().viewTransformChanged()
        self.prepareGeometryChange()
        self._bounds = self.viewRect() or QRectF()
        self.update()

    def _frames_a_px(self) -> float:
        view = self.getViewBox()
        return 0.0 if view is None else float(view.viewPixelSize()[0])
