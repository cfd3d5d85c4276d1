"""What the rows of layers and of set pieces have in common: their ground, and the eye that a click opens and shuts."""

from PySide6.QtCore import QAbstractItemModel, QEvent, QModelIndex, QObject, QPersistentModelIndex, QRect
from PySide6.QtGui import QMouseEvent, QPainter, QPen
from PySide6.QtWidgets import QStyle, QStyledItemDelegate, QStyleOptionViewItem

from kagezou.ui.system.icons import icon
from kagezou.ui.system.theme import CHOSEN, LINE, RAISED

EYE_WIDTH = 30

_ICON = 16

Index = QModelIndex | QPersistentModelIndex


class EyeDelegate(QStyledItemDelegate):
    """Paints the start of a row and takes clicks on its eye.

    Parameters
    ----------
    role
        Of the model, under which it keeps whether the eye is open.
    parent
        The view.
    """

    def __init__(self, role: int, parent: QObject) -> None:
        super().__init__(parent)
        self._role = role

    def editorEvent(self, event: QEvent, model: QAbstractItemModel, option: QStyleOptionViewItem, index: Index) -> bool:
        if isinstance(event, QMouseEvent) and event.position().x() < QRect(option.rect).left() + EYE_WIDTH:
            if event.type() is QEvent.Type.MouseButtonRelease:
                model.setData(index, not index.data(self._role), self._role)
            return True
        return super().editorEvent(event, model, option, index)

    def paint_start(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> tuple[bool, bool]:
        """Paint the ground, the line below and the eye; return whether the row is chosen, and the eye open."""
        area, state = QRect(option.rect), option.state
        is_chosen, is_open = bool(state & QStyle.StateFlag.State_Selected), bool(index.data(self._role))
        if is_chosen or state & QStyle.StateFlag.State_MouseOver:
            painter.fillRect(area, CHOSEN if is_chosen else RAISED)
        painter.setPen(QPen(LINE, 1))
        painter.drawLine(area.bottomLeft(), area.bottomRight())
        eye = QRect(area.left() + 7, area.center().y() - _ICON // 2, _ICON, _ICON)
        icon("eye" if is_open else "eye-off").paint(painter, eye)
        return is_chosen, is_open
