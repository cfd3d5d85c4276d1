"""What is drawn on the graph for the curves: they themselves, differences, markers and notes."""

from collections.abc import Iterable
from functools import reduce

import pyqtgraph as pg
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor

from kagezou.document.model import Document
from kagezou.tools.curves.differences import EVERYWHERE, NOWHERE, Span, differing_span, joined
from kagezou.tools.curves.picture import CurvePicture, Pictures, differing_frames, runs
from kagezou.ui.curves.curve_sheet import CurveSheet
from kagezou.ui.curves.drawn_curve import DrawnCurve
from kagezou.ui.system.theme import CHANGED, WARNING

_UNDER_ALL, _OVER_LINES = -20, 10


class CurveItems:
    """The items of a plot.

    Curves that changed last lie on sheets of their own over the others, so that a hand that drags one has the others
    stay as they were drawn.

    Parameters
    ----------
    plot
        Where they are put.
    """

    def __init__(self, plot: pg.PlotItem) -> None:
        self._plot = plot
        self._marked: list[pg.GraphicsObject] = []
        self._marked_of: tuple[object, ...] = ()
        self._curves: tuple[DrawnCurve, ...] = ()
        self._moving: frozenset[object] = frozenset()
        self._labels: dict[object, pg.TextItem] = {}
        self.resting, self.moving = (
            (CurveSheet(DrawnCurve.draw_line, 0), CurveSheet(DrawnCurve.draw_keys, _OVER_LINES)) for _ in range(2)
        )
        for sheet in (*self.resting, *self.moving):
            plot.addItem(sheet, ignoreBounds=True)
        self.curves_drawn = 0

    def draw(self, document: Document, ghost: Document | None, pictures: Pictures) -> None:
        """Draw what is another than last time; ``ghost`` is the other version whose differences are marked."""
        marked_of = _marks_of(document, ghost, pictures)
        if marked_of != self._marked_of:
            self._marked_of = marked_of
            for item in self._marked:
                self._plot.removeItem(item)
            self._marked = []
            if ghost is not None:
                self._draw_differences(document, ghost, pictures)
            self._draw_marks(document)
            self._draw_notes(document, pictures)
        self._draw_curves(pictures)

    def _draw_curves(self, pictures: Pictures) -> None:
        # Pictures hold arrays, which have no equality; those that stayed are the very same.
        known = {id(each.picture): each for each in self._curves}
        before, self._curves = self._curves, tuple(known.get(id(each)) or DrawnCurve(each) for each in pictures)
        new = [each for each in self._curves if id(each.picture) not in known]
        self.curves_drawn += len(new)
        self._show_labels(new)
        changed = frozenset(each.name for each in new)
        are_the_same = [each.name for each in before] == [each.name for each in self._curves]
        if are_the_same and changed <= self._moving and len(self._moving) <= 2 * len(changed):
            old = {each.name: each for each in before}
            self._show(self.moving, reduce(joined, (_differing(old[each.name], each) for each in new), NOWHERE))
        elif new or not are_the_same:
            self._moving = changed
            self._show(self.resting, EVERYWHERE)
            self._show(self.moving, EVERYWHERE)

    def _show(self, sheets: tuple[CurveSheet, ...], changed: Span) -> None:
        is_moving = sheets is self.moving
        curves = [each for each in self._curves if (each.name in self._moving) is is_moving]
        for sheet in sheets:
            sheet.show_curves(curves, changed)

    def _show_labels(self, new: Iterable[DrawnCurve]) -> None:
        """Have the name of each curve that has one stand at its end."""
        for name in self._labels.keys() - {each.name for each in self._curves}:
            self._plot.removeItem(self._labels.pop(name))
        for each in new:
            curve, line = each.picture.curve, each.picture.line
            if curve.name:
                label = self._labels.get(each.name)
                if label is None:
                    label = self._labels[each.name] = pg.TextItem(curve.name, anchor=(0, 0.5))
                    self._put(label)
                label.setColor(curve.color)
                label.setPos(line.frames[-1], line.values[-1])

    def _put(self, item: pg.GraphicsObject, height: int = 0) -> None:
        item.setZValue(height)
        item.setCacheMode(pg.QtWidgets.QGraphicsItem.CacheMode.DeviceCoordinateCache)
        self._plot.addItem(item, ignoreBounds=True)

    def _mark(self, item: pg.GraphicsObject, height: int = 0) -> None:
        self._put(item, height)
        self._marked.append(item)

    def _draw_differences(self, document: Document, ghost: Document, pictures: Iterable[CurvePicture]) -> None:
        differing = {frame for picture in pictures for frame in differing_frames(document, ghost, picture.curve)}
        for first, last in runs(sorted(differing)):
            color = QColor(WARNING)
            color.setAlpha(30)
            band = pg.LinearRegionItem((first - 0.5, last + 0.5), movable=False, brush=color, pen=pg.mkPen(None))
            self._mark(band, _UNDER_ALL)

    def _draw_marks(self, document: Document) -> None:
        first, last = document.played
        for frame in (first, last) if document.work_area else ():
            self._mark(pg.InfiniteLine(frame, angle=90, pen=pg.mkPen("#9a7a35", width=1)))
        for marker in document.markers:
            pen = pg.mkPen(CHANGED, width=1, style=Qt.PenStyle.DotLine)
            label = {"position": 0.96, "color": CHANGED, "movable": False}
            self._mark(pg.InfiniteLine(marker.frame, angle=90, pen=pen, label=marker.comment or None, labelOpts=label))

    def _draw_notes(self, document: Document, pictures: Iterable[CurvePicture]) -> None:
        shown = {(each.curve.address.property.name, each.curve.address.layer_id) for each in pictures}
        for note in document.notes:
            if (note.property, note.layer_id) in shown:
                pen = pg.mkPen(WARNING, width=1, style=Qt.PenStyle.DashLine)
                label = {"position": 0.06, "color": WARNING, "movable": False}
                self._mark(pg.InfiniteLine(note.frame, angle=90, pen=pen, label="✎", labelOpts=label))


def _differing(before: DrawnCurve, after: DrawnCurve) -> Span:
    """Return between which frames a curve has to be drawn anew."""
    span = differing_span(before.picture, after.picture)
    return EVERYWHERE if after.is_dashed and span != NOWHERE else span


def _marks_of(document: Document, ghost: Document | None, pictures: Pictures) -> tuple[object, ...]:
    """Return what the marks of a document are drawn by; with a ghost also its curves, for they differ from it."""
    shown = tuple((each.curve.address.property.name, each.curve.address.layer_id) for each in pictures)
    tracks = () if ghost is None else tuple(id(each.track) for each in pictures)
    return (document.played, document.work_area, document.markers, document.notes, shown, tracks, id(ghost))
