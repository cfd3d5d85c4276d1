"""What of a widget stays as it is while something small moves over it."""

from collections.abc import Callable

from PySide6.QtCore import QRect
from PySide6.QtGui import QPainter, QPixmap
from PySide6.QtWidgets import QWidget


class StillPicture:
    """Keeps what a widget painted until that is forgotten, or the widget has another size.

    Parameters
    ----------
    widget
        The widget.
    paint
        Paints what stays, all of it opaque.
    """

    def __init__(self, widget: QWidget, paint: Callable[[QPainter], None]) -> None:
        self._widget, self._paint = widget, paint
        self._kept: QPixmap | None = None
        self.times_painted = 0

    def forget(self) -> None:
        """Paint anew next time, which is soon."""
        self._kept = None
        self._widget.update()

    def paint(self, painter: QPainter, part: QRect) -> None:
        """Paint a part of the widget as it was kept."""
        ratio = self._widget.devicePixelRatioF()
        size = self._widget.size() * ratio
        if self._kept is None or self._kept.size() != size:
            self._kept = QPixmap(size)
            self._kept.setDevicePixelRatio(ratio)
            self._kept.fill(self._widget.palette().window().color())
            within = QPainter(self._kept)
            within.setFont(self._widget.font())
            self._paint(within)
            within.end()
            self.times_painted += 1
        painter.setClipRect(part)
        painter.drawPixmap(0, 0, self._kept)
        painter.setClipping(False)
