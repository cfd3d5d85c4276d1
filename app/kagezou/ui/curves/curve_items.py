"""What is drawn on the graph for the curves: lines, keys, handles, ghosts, differences, markers and notes."""

from collections.abc import Iterable

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor

from kagezou.document.model import Document
from kagezou.tools.curves.picture import CurvePicture, HandleMark, KeyMark, Pictures, differing_frames, runs
from kagezou.ui.curves.key_symbols import SYMBOLS
from kagezou.ui.system.theme import CHANGED, SELECTED, WARNING, WELL

_KEY_PX = 11
_HANDLE_PX = 7
_DASHES = (None, [7, 4], [2, 4], [9, 3, 2, 3])
_GHOST_DASH = [4, 4]
_UNDER_ALL, _OVER_LINES = -20, 10


class CurveItems:
    """The items of a plot; those of a curve are made anew when it changes, the others with every change of theirs.

    Parameters
    ----------
    plot
        Where they are put.
    """

    def __init__(self, plot: pg.PlotItem) -> None:
        self._plot = plot
        self._items: list[pg.GraphicsObject] = []
        self._marked: list[pg.GraphicsObject] = []
        self._marked_of: tuple[object, ...] = ()
        self._curves: list[tuple[CurvePicture, list[pg.GraphicsObject]]] = []
        self.curves_drawn = 0

    def draw(self, document: Document, ghost: Document | None, pictures: Pictures) -> None:
        """Draw what is another than last time; ``ghost`` is the other version whose differences are marked."""
        marked_of = _marks_of(document, ghost, pictures)
        if marked_of != self._marked_of:
            self._marked_of = marked_of
            self._take_away(self._marked)
            self._items = self._marked = []
            if ghost is not None:
                self._draw_differences(document, ghost, pictures)
            self._draw_marks(document)
            self._draw_notes(document, pictures)
        # Pictures hold arrays, which have no equality; those that stayed are the very same.
        known = {id(picture): items for picture, items in self._curves}
        kept = {id(picture) for picture in pictures}
        for picture, items in self._curves:
            if id(picture) not in kept:
                self._take_away(items)
        self._curves = [(picture, known.get(id(picture)) or self._drawn(picture)) for picture in pictures]

    def _drawn(self, picture: CurvePicture) -> list[pg.GraphicsObject]:
        self._items = []
        self._draw_curve(picture)
        self._draw_keys(picture)
        self.curves_drawn += 1
        return self._items

    def _take_away(self, items: list[pg.GraphicsObject]) -> None:
        for item in items:
            self._plot.removeItem(item)

    def _put(self, item: pg.GraphicsObject, height: int = 0) -> None:
        item.setZValue(height)
        # With all curves over each other, drawing the lines of those that stay would take most of a painting.
        item.setCacheMode(pg.QtWidgets.QGraphicsItem.CacheMode.DeviceCoordinateCache)
        self._plot.addItem(item, ignoreBounds=True)
        self._items.append(item)

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
        # Symbols are drawn once for each pen and brush, which are told apart as objects.
        plain = pg.mkPen(picture.curve.color, width=1.5), pg.mkBrush(WELL)
        chosen = pg.mkPen(SELECTED, width=1.5), pg.mkBrush(SELECTED)
        ends = pg.mkPen("#101010", width=1), chosen[1]
        looks = [chosen if mark.is_chosen else plain for mark in picture.keys] + [ends for _ in picture.handles]
        marks: list[KeyMark | HandleMark] = [*picture.keys, *picture.handles]
        spots = pg.ScatterPlotItem(
            x=[mark.frame for mark in marks],
            y=[mark.ordinate for mark in marks],
            symbol=[SYMBOLS[mark.interpolation] for mark in picture.keys] + ["o" for _ in picture.handles],
            pen=[pen for pen, _ in looks],
            brush=[brush for _, brush in looks],
            size=[_KEY_PX for _ in picture.keys] + [_HANDLE_PX for _ in picture.handles],
        )
        self._put(spots, _OVER_LINES)

    def _draw_differences(self, document: Document, ghost: Document, pictures: Iterable[CurvePicture]) -> None:
        differing = {frame for picture in pictures for frame in differing_frames(document, ghost, picture.curve)}
        for first, last in runs(sorted(differing)):
            color = QColor(WARNING)
            color.setAlpha(30)
            band = pg.LinearRegionItem((first - 0.5, last + 0.5), movable=False, brush=color, pen=pg.mkPen(None))
            self._put(band, _UNDER_ALL)

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


def _marks_of(document: Document, ghost: Document | None, pictures: Pictures) -> tuple[object, ...]:
    """Return what the marks of a document are drawn by; with a ghost also its curves, for they differ from it."""
    shown = tuple((each.curve.address.property.name, each.curve.address.layer_id) for each in pictures)
    tracks = () if ghost is None else tuple(id(each.track) for each in pictures)
    return (document.played, document.work_area, document.markers, document.notes, shown, tracks, id(ghost))
