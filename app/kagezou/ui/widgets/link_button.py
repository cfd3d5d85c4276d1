"""The chain behind a property: whether it is the same for all characters."""

from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QAbstractButton

from kagezou.ui.widgets.link_sign import paint_link_sign


class LinkButton(QAbstractButton):
    """A click links or unlinks; linked is a closed chain, apart two halves, so that the shape alone tells."""

    def __init__(self) -> None:
        super().__init__()
        self._is_linked = False
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self.show_linked(linked=False)

    @property
    def is_linked(self) -> bool:
        """What is shown."""
        return self._is_linked

    def show_linked(self, *, linked: bool) -> None:
        """Show whether the property is linked."""
        self._is_linked = linked
        said = (
            self.tr("The same for all characters. Click to give each its own")
            if linked
            else self.tr("Click to make it the same for all characters, values and keys")
        )
        self.setToolTip(said)
        self.setAccessibleName(said)
        self.update()

    def sizeHint(self) -> QSize:
        height = max(self.fontMetrics().height(), 18)
        return QSize(18, height)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        hovered = self.isEnabled() and (self.underMouse() or self.hasFocus())
        paint_link_sign(painter, QPointF(self.width() / 2, self.height() / 2), linked=self._is_linked, hovered=hovered)
        painter.end()
