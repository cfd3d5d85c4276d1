"""The frame around the selected keys: where it lies, what of it is under the pointer, and how it looks."""

from collections.abc import Iterable
from dataclasses import dataclass

import pyqtgraph as pg
from PySide6.QtCore import QRectF, Qt

from kagezou.ui.curves.picture import CurvePicture, KeyMark
from kagezou.ui.system.theme import SELECTED, WELL

REACH_PX = 10.0
PADDING_PX = 16.0
"""The frame stands off from its keys so that both can be taken hold of."""
_HANDLE_PX = 8


@dataclass(frozen=True, slots=True)
class BoxGrip:
    """A part of the frame: −1, 0 or 1 across and up; (0, 0) is its inside."""

    across: int
    up: int

    @property
    def is_inside(self) -> bool:
        """Whether it moves the keys instead of scaling them."""
        return self.across == self.up == 0

    @property
    def cursor(self) -> Qt.CursorShape:
        """What the pointer looks like on it."""
        if self.is_inside:
            return Qt.CursorShape.SizeAllCursor
        if self.across and self.up:
            rising = self.across == self.up
            return Qt.CursorShape.SizeBDiagCursor if rising else Qt.CursorShape.SizeFDiagCursor
        return Qt.CursorShape.SizeHorCursor if self.across else Qt.CursorShape.SizeVerCursor


@dataclass(frozen=True, slots=True)
class KeyBox:
    """The smallest box around keys in graph coordinates, and the px that a frame and a unit measure."""

    left: float
    right: float
    low: float
    high: float
    frame_px: float
    unit_px: float

    @property
    def parts(self) -> tuple[BoxGrip, ...]:
        """The handles there are; without any breadth, or height, there is nothing to scale that way."""
        wide, tall = self.right > self.left, (self.high - self.low) * self.unit_px > 1e-6
        across, up = (-1, 0, 1) if wide else (0,), (-1, 0, 1) if tall else (0,)
        return tuple(BoxGrip(a, u) for a in across for u in up if a or u)

    @property
    def padded(self) -> QRectF:
        """The frame as it is drawn."""
        across, up = PADDING_PX / self.frame_px, PADDING_PX / self.unit_px
        width, height = self.right - self.left + 2 * across, self.high - self.low + 2 * up
        return QRectF(self.left - across, self.low - up, width, height)

    def place_of(self, part: BoxGrip) -> tuple[float, float]:
        """Return where the handle of a part is drawn."""
        frame, middle = self.padded, self.padded.center()
        x = (frame.left(), middle.x(), frame.right())[part.across + 1]
        return x, (frame.top(), middle.y(), frame.bottom())[part.up + 1]

    def edge_of(self, part: BoxGrip) -> tuple[float, float]:
        """Return the edge of the keys themselves on the side of a part."""
        middle = (self.left + self.right) / 2, (self.low + self.high) / 2
        x = (self.left, middle[0], self.right)[part.across + 1]
        return x, (self.low, middle[1], self.high)[part.up + 1]

    def part_at(self, place: tuple[float, float]) -> BoxGrip | None:
        """Return the part under a place of the graph, a handle within reach before the inside."""

        def away(part: BoxGrip) -> float:
            x, y = self.place_of(part)
            return float(max(abs(x - place[0]) * self.frame_px, abs(y - place[1]) * self.unit_px))

        near = min(self.parts, key=away, default=None)
        if near is not None and away(near) <= REACH_PX:
            return near
        return BoxGrip(0, 0) if self.padded.contains(*place) else None


def box_around(pictures: Iterable[CurvePicture], pixels: tuple[float, float]) -> KeyBox | None:
    """Return the box around the selected keys that are seen; None for fewer than two keys.

    Parameters
    ----------
    pictures
        What is drawn.
    pixels
        Frames and units a pixel.
    """
    marks: list[KeyMark] = [mark for picture in pictures for mark in picture.keys if mark.is_chosen]
    if len({mark.ref for mark in marks}) < 2:
        return None
    frames, levels = [mark.frame for mark in marks], [mark.ordinate for mark in marks]
    return KeyBox(min(frames), max(frames), min(levels), max(levels), 1 / pixels[0], 1 / pixels[1])


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
            self._outline.setRect(box.padded)
            self._handles.setData(pos=[box.place_of(part) for part in box.parts])
