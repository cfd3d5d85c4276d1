"""Bars that come and go at the upper edge of the picture: they lie over it, so that it never moves for them."""

from collections.abc import Iterable

from PySide6.QtCore import QEvent, QObject
from PySide6.QtWidgets import QVBoxLayout, QWidget

_FOLLOWED = frozenset({
    QEvent.Type.Resize, QEvent.Type.Move, QEvent.Type.Show,
    QEvent.Type.ShowToParent, QEvent.Type.HideToParent, QEvent.Type.LayoutRequest,
})  # fmt: skip


class TopBars(QWidget):
    """Stacks bars over the upper edge of a widget, as high as those that are shown need.

    Parameters
    ----------
    over
        What they lie over; it has a parent.
    bars
        From top to bottom; each shows and hides itself.
    """

    def __init__(self, over: QWidget, bars: Iterable[QWidget]) -> None:
        super().__init__(over.parentWidget())
        self._over, self._bars = over, tuple(bars)
        self._column = QVBoxLayout(self)
        self._column.setContentsMargins(0, 0, 0, 0)
        self._column.setSpacing(0)
        for bar in self._bars:
            self._column.addWidget(bar)
            bar.installEventFilter(self)
        over.installEventFilter(self)
        self._place()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in _FOLLOWED:
            self._place()
        return super().eventFilter(watched, event)

    def _place(self) -> None:
        self.setVisible(any(not bar.isHidden() for bar in self._bars))
        if not self.isHidden():
            width, column = self._over.width(), self._column
            column.activate()
            height = column.heightForWidth(width) if column.hasHeightForWidth() else column.sizeHint().height()
            self.setGeometry(self._over.x(), self._over.y(), width, height)
            self.raise_()
