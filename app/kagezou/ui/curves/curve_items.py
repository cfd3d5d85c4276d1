"""What is drawn on the graph for the curves: lines, keys, handles, ghosts, differences, markers and notes."""

from collections.abc import Iterable

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor

from kagezou.document.model import Document
from kagezou.tools.curves.picture import CurvePicture, Pictures, differing_frames, runs
from kagezou.ui.curves.key_symbols import SYMBOLS
from kagezou.ui.system.theme import CHANGED, SELECTED, WARNING, WELL

_KEY_PX = 11
_HANDLE_PX = 7
_DASHES = (None, [7, 4], [2, 4], [9, 3, 2, 3])
_GHOST_DASH = [4, 4]


class CurveItems:
    """The items of a plot that are made anew with every change.

    Parameters
    ----------
    plot
        Where they are put.
    """

    def __init__(self, plot: pg.PlotItem) -> None:
        self._plot = plot
        self._drawn: list[pg.GraphicsObject] = []

    def draw(self, document: Document, ghost: Document | None, pictures: Pictures) -> None:
        """Draw everything anew; ``ghost`` is the other version whose differences are marked."""
        for item in self._drawn:
            self._plot.removeItem(item)
        self._drawn.clear()
        if ghost is not None:
            self._draw_differences(document, ghost, pictures)
        self._draw_marks(document)
        self._draw_notes(document, pictures)
        for picture in pictures:
            self._draw_curve(picture)
        for picture in pictures:
            self._draw_keys(picture)

    def _put(self, item: pg.GraphicsObject) -> None:
        self._plot.addItem(item, ignoreBounds=True)
        self._drawn.append(item)

    def _draw_curve(self, picture: CurvePicture) -> None:
        curve = picture.curve
        if picture.ghost is not None:
            pen = pg.mkPen(QColor(curve.color).darker(130), width=1, dash=_GHOST_DASH)
            self._put(pg.PlotCurveItem(picture.ghost.frames, picture.ghost.values, pen=pen))
        hot = any(mark.is_chosen for mark in picture.keys)
        # Several curves of one colour's neighbourhood are told apart by their dashes.
        dash = _DASHES[curve.component % len(_DASHES)]
        pen = pg.mkPen(curve.color, width=2 if hot else 1, **({"dash": dash} if dash else {}))
        self._put(pg.PlotCurveItem(picture.line.frames, picture.line.values, pen=pen, antialias=True))
        if curve.name and len(picture.line.frames):
            label = pg.TextItem(curve.name, color=curve.color, anchor=(0, 0.5))
            label.setPos(picture.line.frames[-1], picture.line.values[-1])
            self._put(label)

    def _draw_keys(self, picture: CurvePicture) -> None:
        for handle in picture.handles:
            pen = pg.mkPen(SELECTED, width=1)
            ends = np.array([handle.key.frame, handle.frame]), np.array([handle.key.ordinate, handle.ordinate])
            self._put(pg.PlotCurveItem(*ends, pen=pen))
        spots = [
            {
                "pos": (mark.frame, mark.ordinate),
                "symbol": SYMBOLS[mark.interpolation],
                "brush": pg.mkBrush(SELECTED if mark.is_chosen else WELL),
                "pen": pg.mkPen(SELECTED if mark.is_chosen else picture.curve.color, width=1.5),
                "size": _KEY_PX,
            }
            for mark in picture.keys
        ]
        spots += [
            {
                "pos": (handle.frame, handle.ordinate),
                "symbol": "o",
                "brush": pg.mkBrush(SELECTED),
                "pen": pg.mkPen("#101010", width=1),
                "size": _HANDLE_PX,
            }
            for handle in picture.handles
        ]
        self._put(pg.ScatterPlotItem(spots))

    def _draw_differences(self, document: Document, ghost: Document, pictures: Iterable[CurvePicture]) -> None:
        differing = {frame for picture in pictures for frame in differing_frames(document, ghost, picture.curve)}
        for first, last in runs(sorted(differing)):
            color = QColor(WARNING)
            color.setAlpha(30)
            band = pg.LinearRegionItem((first - 0.5, last + 0.5), movable=False, brush=color, pen=pg.mkPen(None))
            band.setZValue(-20)
            self._put(band)

    def _draw_marks(self, document: Document) -> None:
        first, last = document.played
        for frame in (first, last) if document.work_area else ():
            self._put(pg.InfiniteLine(frame, angle=90, pen=pg.mkPen("#9a7a35", width=1)))
        for marker in document.markers:
            pen = pg.mkPen(CHANGED, width=1, style=Qt.PenStyle.DotLine)
            label = {"position": 0.96, "color": CHANGED, "movable": False}
            self._put(pg.InfiniteLine(marker.frame, angle=90, pen=pen, label=marker.comment or None, labelOpts=label))

    def _draw_notes(self, document: Document, pictures: Iterable[CurvePicture]) -> None:
        shown = {(each.curve.address.property.name, each.curve.address.layer_id) for each in pictures}
        for note in document.notes:
            if (note.property, note.layer_id) in shown:
                pen = pg.mkPen(WARNING, width=1, style=Qt.PenStyle.DashLine)
                label = {"position": 0.06, "color": WARNING, "movable": False}
                self._put(pg.InfiniteLine(note.frame, angle=90, pen=pen, label="✎", labelOpts=label))
