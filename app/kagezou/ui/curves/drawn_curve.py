"""How a curve is drawn on the graph: its line, its ghost, its handles and its keys."""

from bisect import bisect_left, bisect_right
from functools import cache, cached_property

import numpy as np
import pyqtgraph as pg
from pyqtgraph.graphicsItems.ScatterPlotItem import renderSymbol
from PySide6.QtCore import QLineF, QPointF
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen, QPixmap

from kagezou.animation.curve import Line
from kagezou.animation.track import Interpolation
from kagezou.tools.curves.differences import Span
from kagezou.tools.curves.picture import CurvePicture
from kagezou.ui.curves.key_symbols import SYMBOLS
from kagezou.ui.system.theme import SELECTED, WELL

_KEY_PX = 11
_HANDLE_PX = 7
_DASHES = (None, [7, 4], [2, 4], [9, 3, 2, 3])
_GHOST_DASH = [4, 4]


class DrawnCurve:
    """A picture of a curve with what it is drawn by, made once.

    Parameters
    ----------
    picture
        The curve as it is seen.
    """

    def __init__(self, picture: CurvePicture) -> None:
        self.picture = picture
        self.name = _name_of(picture)

    @property
    def is_dashed(self) -> bool:
        """Whether a change moves every dash after it."""
        return self._dash is not None

    def draw_line(self, painter: QPainter, span: Span) -> None:
        """Draw ghost, line and handles between two frames."""
        picture, antialiasing = self.picture, QPainter.RenderHint.Antialiasing
        painter.setRenderHint(antialiasing, on=False)
        if picture.ghost is not None:
            painter.setPen(pg.mkPen(QColor(picture.curve.color).darker(130), width=1, dash=_GHOST_DASH))
            painter.drawPath(_path(picture.ghost))
        painter.setRenderHint(antialiasing)
        painter.setPen(self._pen)
        painter.drawPath(self._whole if self.is_dashed else self._part(span))
        painter.setRenderHint(antialiasing, on=False)
        painter.setPen(pg.mkPen(SELECTED, width=1))
        for handle in picture.handles:
            ends = QPointF(handle.key.frame, handle.key.ordinate), QPointF(handle.frame, handle.ordinate)
            painter.drawLine(QLineF(*ends))

    def draw_keys(self, painter: QPainter, span: Span) -> None:
        """Draw keys and ends of handles between two frames, each of a size of its own on screen."""
        painter.save()
        view_from_graph, color = painter.transform(), self.picture.curve.color
        painter.resetTransform()
        ratio = painter.device().devicePixelRatioF()
        frames = self._key_frames
        for mark in self.picture.keys[bisect_left(frames, span[0]) : bisect_right(frames, span[1])]:
            place = view_from_graph.map(QPointF(mark.frame, mark.ordinate))
            symbol = _key_symbol(mark.interpolation, None if mark.is_chosen else color, ratio)
            painter.drawPixmap(place - QPointF(symbol.width(), symbol.height()) / (2 * ratio), symbol)
        for handle in self.picture.handles:
            place, symbol = view_from_graph.map(QPointF(handle.frame, handle.ordinate)), _handle_symbol(ratio)
            painter.drawPixmap(place - QPointF(symbol.width(), symbol.height()) / (2 * ratio), symbol)
        painter.restore()

    @property
    def _dash(self) -> list[int] | None:
        # Several curves of one colour's neighbourhood are told apart by their dashes.
        return _DASHES[self.picture.curve.component % len(_DASHES)]

    @cached_property
    def _pen(self) -> QPen:
        dash = {"dash": self._dash} if self._dash else {}
        return QPen(pg.mkPen(self.picture.curve.color, width=2 if self.picture.chosen else 1, **dash))

    @cached_property
    def _whole(self) -> QPainterPath:
        return _path(self.picture.line)

    @cached_property
    def _key_frames(self) -> list[float]:
        return [mark.frame for mark in self.picture.keys]

    def _part(self, span: Span) -> QPainterPath:
        """Return the line from the last point before two frames to the first after them.

        A long line two pixels wide takes a hundred times as long as the part of it that changed.
        """
        frames, values = self.picture.line.frames, self.picture.line.values
        first = max(int(np.searchsorted(frames, span[0], "left")) - 1, 0)
        last = int(np.searchsorted(frames, span[1], "right")) + 1
        if last - first >= len(frames):
            return self._whole
        return _path(Line(frames[first:last], values[first:last]))


def _name_of(picture: CurvePicture) -> tuple[object, ...]:
    """Return what a curve is known by: a property as a whole takes long to hash."""
    address = picture.curve.address
    return address.property.name, address.layer_id, address.piece_id, picture.curve.component


def _path(line: Line) -> QPainterPath:
    path = pg.arrayToQPath(line.frames, line.values)
    assert isinstance(path, QPainterPath)
    return path


@cache
def _key_symbol(interpolation: Interpolation, color: str | None, ratio: float) -> QPixmap:
    """Return a key of a curve of some colour, of none if it is chosen."""
    brush = pg.mkBrush(SELECTED if color is None else WELL)
    pen = pg.mkPen(SELECTED if color is None else color, width=1.5)
    return QPixmap.fromImage(renderSymbol(SYMBOLS[interpolation], _KEY_PX, pen, brush, dpr=ratio))


@cache
def _handle_symbol(ratio: float) -> QPixmap:
    pen = pg.mkPen("#101010", width=1)
    return QPixmap.fromImage(renderSymbol("o", _HANDLE_PX, pen, pg.mkBrush(SELECTED), dpr=ratio))
