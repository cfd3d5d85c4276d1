"""A transparent picture that is painted again and again, and kept from the second time on that it is the same."""

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtGui import QPainter, QPixmap
from PySide6.QtWidgets import QWidget


class KeptPicture:
    """Paints what covers a widget; what is another with every painting is never put into a picture first.

    Parameters
    ----------
    widget
        The widget.
    paint
        Paints what is seen.
    """

    def __init__(self, widget: QWidget, paint: Callable[[QPainter], None]) -> None:
        self._widget, self._paint = widget, paint
        self._made_of: object = None
        self._kept: QPixmap | None = None
        self.times_painted = 0

    def paint(self, painter: QPainter, made_of: object) -> None:
        """Paint it, which depends on a value and on the widget's size and nothing else."""
        ratio = self._widget.devicePixelRatioF()
        whole = (made_of, self._widget.size(), ratio)
        if whole != self._made_of:
            self._made_of, self._kept = whole, None
            self._paint_now(painter)
            return
        if self._kept is None:
            self._kept = QPixmap(self._widget.size() * ratio)
            self._kept.setDevicePixelRatio(ratio)
            self._kept.fill(Qt.GlobalColor.transparent)
            within = QPainter(self._kept)
            self._paint_now(within)
            within.end()
        painter.drawPixmap(0, 0, self._kept)

    def _paint_now(self, painter: QPainter) -> None:
        self._paint(painter)
        self.times_painted += 1
