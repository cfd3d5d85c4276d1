"""How a set piece looks in the list: eye, the picture of its kind, name."""

from PySide6.QtCore import QObject, QRect, QSize, Qt
from PySide6.QtGui import QIcon, QPainter
from PySide6.QtWidgets import QStyleOptionViewItem, QWidget

from kagezou.geometry.sets.measures import PieceKind
from kagezou.ui.sets.list_model import PieceRole
from kagezou.ui.system.icons import kind_icon
from kagezou.ui.system.theme import BRIGHT, DIM, TEXT
from kagezou.ui.system.words import choice_name
from kagezou.ui.widgets.eye_delegate import EYE_WIDTH, EyeDelegate, Index

_KIND_WIDTH = 24
_ICON = 16


class SetDelegate(EyeDelegate):
    """Paints rows and takes clicks on the eye."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(PieceRole.IS_PRESENT, parent)

    def sizeHint(self, option: QStyleOptionViewItem, index: Index) -> QSize:
        return QSize(160, max(option.fontMetrics.height() + 10, _ICON + 8))

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        area = QRect(option.rect)
        painter.save()
        chosen, present = self.paint_start(painter, option, index)
        kind = PieceKind(index.data(PieceRole.KIND))
        place = QRect(area.left() + EYE_WIDTH, area.center().y() - _ICON // 2, _ICON, _ICON)
        kind_icon(kind).paint(painter, place, mode=QIcon.Mode.Normal if present else QIcon.Mode.Disabled)
        self._paint_words(painter, area, index, choice_name(kind), (BRIGHT if chosen else TEXT) if present else DIM)
        painter.restore()

    def createEditor(self, parent: QWidget, option: QStyleOptionViewItem, index: Index) -> QWidget:
        editor = super().createEditor(parent, option, index)
        editor.setAccessibleName(self.tr("Name of the set piece"))
        return editor

    def updateEditorGeometry(self, editor: QWidget, option: QStyleOptionViewItem, index: Index) -> None:
        editor.setGeometry(_words_area(QRect(option.rect)).adjusted(-6, 1, 2, -2))

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
        words = metrics.elidedText(name, Qt.TextElideMode.ElideMiddle, room.width() - width)
        painter.drawText(room, flag | Qt.AlignmentFlag.AlignLeft, words)
        painter.setPen(DIM)
        painter.drawText(room, flag | Qt.AlignmentFlag.AlignRight, beside)


def _words_area(area: QRect) -> QRect:
    return area.adjusted(EYE_WIDTH + _KIND_WIDTH, 0, -8, 0)
