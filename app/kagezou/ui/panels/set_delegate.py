"""How a set piece looks in the list: eye, the picture of its kind, name."""

from functools import cache

from PySide6.QtCore import QAbstractItemModel, QEvent, QModelIndex, QPersistentModelIndex, QRect, QSize, Qt
from PySide6.QtGui import QIcon, QMouseEvent, QPainter, QPen
from PySide6.QtWidgets import QStyle, QStyledItemDelegate, QStyleOptionViewItem, QWidget

from kagezou.locations import resource_folder
from kagezou.ui.icons import icon
from kagezou.ui.panels.set_model import PieceRole, SetModel
from kagezou.ui.theme import BRIGHT, CHOSEN, DIM, LINE, OFF, RAISED, TEXT
from kagezou.ui.words import choice_word

_EYE_WIDTH = 30
_KIND_WIDTH = 24
_ICON = 16

Index = QModelIndex | QPersistentModelIndex


class SetDelegate(QStyledItemDelegate):
    """Paints rows and takes clicks on the eye."""

    def sizeHint(self, option: QStyleOptionViewItem, index: Index) -> QSize:
        return QSize(160, max(option.fontMetrics.height() + 10, _ICON + 8))

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        area, state = QRect(option.rect), option.state
        chosen = bool(state & QStyle.StateFlag.State_Selected)
        present = bool(index.data(PieceRole.IS_PRESENT))
        painter.save()
        if chosen or state & QStyle.StateFlag.State_MouseOver:
            painter.fillRect(area, CHOSEN if chosen else RAISED)
        painter.setPen(QPen(LINE, 1))
        painter.drawLine(area.bottomLeft(), area.bottomRight())
        top = area.center().y() - _ICON // 2
        icon("eye" if present else "eye-off").paint(painter, QRect(area.left() + 7, top, _ICON, _ICON))
        kind = str(index.data(PieceRole.KIND))
        place = QRect(area.left() + _EYE_WIDTH, top, _ICON, _ICON)
        kind_icon(kind).paint(painter, place, mode=QIcon.Mode.Normal if present else QIcon.Mode.Disabled)
        self._paint_words(painter, area, index, choice_word(kind), (BRIGHT if chosen else TEXT) if present else OFF)
        painter.restore()

    def createEditor(self, parent: QWidget, option: QStyleOptionViewItem, index: Index) -> QWidget:
        editor = super().createEditor(parent, option, index)
        editor.setAccessibleName(self.tr("Name of the set piece"))
        return editor

    def updateEditorGeometry(self, editor: QWidget, option: QStyleOptionViewItem, index: Index) -> None:
        editor.setGeometry(_words_area(QRect(option.rect)).adjusted(-6, 1, 2, -2))

    def editorEvent(self, event: QEvent, model: QAbstractItemModel, option: QStyleOptionViewItem, index: Index) -> bool:
        on_eye = isinstance(event, QMouseEvent) and (event.position().x() < QRect(option.rect).left() + _EYE_WIDTH)
        if on_eye and isinstance(model, SetModel):
            if event.type() is QEvent.Type.MouseButtonRelease:
                model.setData(index, not index.data(PieceRole.IS_PRESENT), PieceRole.IS_PRESENT)
            return True
        return super().editorEvent(event, model, option, index)

    def _paint_words(self, painter: QPainter, area: QRect, index: Index, kind: str, tone: object) -> None:
        room = _words_area(area)
        metrics, flag = painter.fontMetrics(), Qt.AlignmentFlag.AlignVCenter
        name = str(index.data())
        # A name such as "Wall 2" says itself what it is.
        beside = "" if name.startswith(kind) else kind
        width = metrics.horizontalAdvance(beside) + 10 if beside else 0
        if width > room.width() // 2:
            beside, width = "", 0
        painter.setPen(tone)
        words = metrics.elidedText(name, Qt.TextElideMode.ElideRight, room.width() - width)
        painter.drawText(room, flag | Qt.AlignmentFlag.AlignLeft, words)
        painter.setPen(DIM)
        painter.drawText(room, flag | Qt.AlignmentFlag.AlignRight, beside)


@cache
def kind_icon(kind: str) -> QIcon:
    """Return the picture of a kind of set piece."""
    is_drawn = (resource_folder() / "icons" / f"{kind}.svg").is_file()
    return icon(kind if is_drawn else "box")


def _words_area(area: QRect) -> QRect:
    return area.adjusted(_EYE_WIDTH + _KIND_WIDTH, 0, -8, 0)
