"""Bars that come and go at the upper edge of the picture: they lie over it, so that it never moves for them."""

from collections.abc import Iterable

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt, Signal
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

    _changed = Signal()

    def __init__(self, over: QWidget, bars: Iterable[QWidget]) -> None:
        super().__init__(over.parentWidget())
        self._over, self._bars = over, tuple(bars)
        self._is_aside = False
        self._column = QVBoxLayout(self)
        self._column.setContentsMargins(0, 0, 0, 0)
        self._column.setSpacing(0)
        for bar in self._bars:
            self._column.addWidget(bar)
            bar.installEventFilter(self)
        over.installEventFilter(self)
        self._changed.connect(self._place, Qt.ConnectionType.QueuedConnection)
        self._follow()

    def step_aside(self, aside: bool) -> None:
        """Hide while the hand works on what lies below, or come back."""
        if aside != self._is_aside:
            self._is_aside = aside
            self._follow()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in _FOLLOWED:
            self._follow()
        return super().eventFilter(watched, event)

    def _follow(self) -> None:
        self.setVisible(not self._is_aside and any(not bar.isHidden() for bar in self._bars))
        self._place()
        # What a bar makes of its words it may know only later.
        self._changed.emit()

    def _place(self) -> None:
        if self.isHidden():
            return
        for bar in self._bars:
            # Without its style a bar would not know how high it is when it is shown for the first time.
            for widget in (bar, *bar.findChildren(QWidget)):
                widget.ensurePolished()
            inner = bar.layout()
            if inner is not None:
                inner.invalidate()
        width, column = self._over.width(), self._column
        column.invalidate()
        height = column.heightForWidth(width) if column.hasHeightForWidth() else column.sizeHint().height()
        self.setGeometry(self._over.x(), self._over.y(), width, height)
        column.activate()
        for bar in self._bars:
            if (inner := bar.layout()) is not None:
                inner.activate()
            # Asked for by what was done here: followed, it would have the bars placed again and again without an end.
            QCoreApplication.removePostedEvents(bar, QEvent.Type.LayoutRequest.value)
        self.raise_()
