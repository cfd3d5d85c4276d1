"""The list of what can be exported: an icon, a name and what it is for."""

from typing import Final

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRect, QSize, Qt, Signal
from PySide6.QtGui import QFont, QFontMetrics, QPainter
from PySide6.QtWidgets import QListWidget, QListWidgetItem, QStyle, QStyledItemDelegate, QStyleOptionViewItem

from kagezou.export.exporters.table import EXPORTERS
from kagezou.ui.system.icons import icon
from kagezou.ui.system.theme import BRIGHT, CHOSEN, DIM, HOVERED, TEXT
from kagezou.ui.system.words import translated

_KEY: Final = Qt.ItemDataRole.UserRole
_PURPOSE: Final = Qt.ItemDataRole.UserRole + 1
_ICON_PX: Final = 24
_GAP_PX: Final = 10
_ROW_GAP_PX: Final = 8

Index = QModelIndex | QPersistentModelIndex


class TargetList(QListWidget):
    """Every kind of export; its size is the same whichever is chosen."""

    picked = Signal(str)
    """The key of the exporter that was picked."""

    def __init__(self) -> None:
        super().__init__()
        self.setAccessibleName(self.tr("What for"))
        self.setItemDelegate(_TargetDelegate(self))
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setMouseTracking(True)
        for exporter in EXPORTERS:
            item = QListWidgetItem(icon(exporter.icon), translated(exporter.label))
            purpose = translated(exporter.purpose)
            item.setData(_KEY, exporter.key)
            item.setData(_PURPOSE, purpose)
            item.setData(Qt.ItemDataRole.AccessibleTextRole, f"{item.text()}: {purpose}")
            self.addItem(item)
        self.setFixedWidth(self._width())
        self.setMinimumHeight(self.count() * self.sizeHintForRow(0) + 2 * self.frameWidth())
        self.currentRowChanged.connect(self._tell)

    def show_kind(self, kind: str) -> None:
        """Stand at an exporter."""
        keys = [self.item(row).data(_KEY) for row in range(self.count())]
        self.blockSignals(True)
        self.setCurrentRow(keys.index(kind))
        self.blockSignals(False)

    def _tell(self, row: int) -> None:
        self.picked.emit(self.item(row).data(_KEY))

    def _width(self) -> int:
        bold = QFontMetrics(_bold(self.font()))
        rows = [self.item(row) for row in range(self.count())]
        words = [bold.horizontalAdvance(each.text()) for each in rows]
        words += [self.fontMetrics().horizontalAdvance(each.data(_PURPOSE)) for each in rows]
        return max(words) + _ICON_PX + 3 * _GAP_PX + 2 * self.frameWidth() + 4


class _TargetDelegate(QStyledItemDelegate):
    """Paints two lines beside an icon."""

    def sizeHint(self, option: QStyleOptionViewItem, index: Index) -> QSize:
        return QSize(_ICON_PX, 2 * option.fontMetrics.height() + _ROW_GAP_PX)

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        area = QRect(option.rect)
        is_chosen = bool(option.state & QStyle.StateFlag.State_Selected)
        painter.save()
        if is_chosen or option.state & QStyle.StateFlag.State_MouseOver:
            painter.fillRect(area, CHOSEN if is_chosen else HOVERED)
        frame = QRect(area.left() + _GAP_PX, area.center().y() - _ICON_PX // 2, _ICON_PX, _ICON_PX)
        index.data(Qt.ItemDataRole.DecorationRole).paint(painter, frame)
        words = area.adjusted(_ICON_PX + 2 * _GAP_PX, _ROW_GAP_PX // 2, -_GAP_PX, -_ROW_GAP_PX // 2)
        painter.setPen(BRIGHT if is_chosen else TEXT)
        painter.setFont(_bold(option.font))
        painter.drawText(words, Qt.AlignmentFlag.AlignTop, str(index.data()))
        painter.setPen(TEXT if is_chosen else DIM)
        painter.setFont(option.font)
        painter.drawText(words, Qt.AlignmentFlag.AlignBottom, index.data(_PURPOSE))
        painter.restore()


def _bold(font: QFont) -> QFont:
    bold = QFont(font)
    bold.setWeight(QFont.Weight.DemiBold)
    return bold
