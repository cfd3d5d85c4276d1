"""The list of set pieces under the layers: add, choose, show and hide, rename, duplicate, remove."""

from collections.abc import Callable

from PySide6.QtCore import QItemSelection, QModelIndex, QPoint, QSize, Qt
from PySide6.QtGui import QKeyEvent, QResizeEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QLabel,
    QListView,
    QMenu,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from kagezou.ui.sets.commands import SetCommands
from kagezou.ui.sets.list_delegate import SetDelegate
from kagezou.ui.sets.list_model import PieceRole, SetModel
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.widgets.tool_button import tool_button

_MOST_ROWS = 5
"""How many rows the list grows to before it scrolls."""


class SetView(QListView):
    """The rows; F2 and a double click rename."""

    def __init__(self, model: SetModel) -> None:
        super().__init__()
        self.setModel(model)
        self.setItemDelegate(SetDelegate(self))
        self.setMouseTracking(True)
        self.setUniformItemSizes(True)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.DoubleClicked | QAbstractItemView.EditTrigger.EditKeyPressed)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setAccessibleName(self.tr("Set pieces"))

    def sizeHint(self) -> QSize:
        return QSize(160, self.rows_px(_MOST_ROWS))

    def minimumSizeHint(self) -> QSize:
        return QSize(80, self.rows_px(2))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.scrollTo(self.currentIndex())

    def rows_px(self, most: int) -> int:
        """Return the height of as many rows as there are, up to a number."""
        return min(self.model().rowCount(), most) * max(self.sizeHintForRow(0), 0)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        # The space bar plays, wherever the focus is.
        if event.key() == Qt.Key.Key_Space:
            event.ignore()
        else:
            super().keyPressEvent(event)


class SetList(QWidget):
    """A header with what can be done, over as many rows as there are pieces.

    Parameters
    ----------
    bridge
        The session.
    commands
        What is done to pieces.
    fill_add
        Fills a menu with the kinds of pieces that can be added.
    """

    def __init__(self, bridge: Bridge, commands: SetCommands, fill_add: Callable[[QMenu], None]) -> None:
        super().__init__()
        self._bridge = bridge
        self._commands = commands
        self.model = SetModel(bridge)
        self.view = SetView(self.model)
        self.view.selectionModel().selectionChanged.connect(self._choose)
        self.view.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.view.customContextMenuRequested.connect(self._open_menu)
        self._lay_out(fill_add)
        self.model.modelReset.connect(self._follow)
        bridge.selection_changed.connect(self._follow)
        bridge.document_changed.connect(self._follow)
        self._follow()

    def rename_current(self) -> None:
        """Begin to type another name for the piece worked on."""
        row = self.model.row_of(self._bridge.piece_id)
        if row is not None:
            self.view.edit(self.model.index(row))

    def _lay_out(self, fill_add: Callable[[QMenu], None]) -> None:
        header = QWidget()
        header.setObjectName("set_header")
        header.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        row = QHBoxLayout(header)
        row.setContentsMargins(8, 1, 4, 1)
        row.setSpacing(2)
        row.addWidget(QLabel(self.tr("Set")), 1)
        self.add_menu = QMenu(self)
        fill_add(self.add_menu)
        self.add_button = tool_button("add", self.tr("Add a wall, box or other set piece"), lambda: None)
        self.add_button.setMenu(self.add_menu)
        self.add_button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self._duplicate = tool_button("duplicate", self.tr("Duplicate set piece"), self._commands.duplicate)
        self._remove = tool_button("remove", self.tr("Remove set piece"), self._commands.remove)
        for button in (self.add_button, self._duplicate, self._remove):
            row.addWidget(button)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(header)
        column.addWidget(self.view)

    def _choose(self, chosen: QItemSelection) -> None:
        indexes = chosen.indexes()
        if indexes:
            self._bridge.session.select_piece(str(indexes[0].data(PieceRole.PIECE_ID)))

    def _follow(self) -> None:
        self.view.setVisible(self.model.rowCount() > 0)
        self.view.setMaximumHeight(self.view.rows_px(_MOST_ROWS))
        self.view.updateGeometry()
        row = self.model.row_of(self._bridge.piece_id)
        self._duplicate.setEnabled(row is not None)
        self._remove.setEnabled(row is not None)
        if row is None:
            self.view.setCurrentIndex(QModelIndex())
        elif row != self.view.currentIndex().row():
            self.view.setCurrentIndex(self.model.index(row))

    def _open_menu(self, at: QPoint) -> None:
        index = self.view.indexAt(at)
        if not index.isValid():
            return
        self.view.setCurrentIndex(index)
        present = bool(index.data(PieceRole.IS_PRESENT))
        menu = QMenu(self.view)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.addAction(self.tr("Rename"), self.rename_current)
        hide_or_show = self.tr("Hide") if present else self.tr("Show")
        menu.addAction(hide_or_show, lambda: self.model.setData(index, not present, PieceRole.IS_PRESENT))
        menu.addAction(self.tr("Duplicate"), self._commands.duplicate)
        menu.addSeparator()
        menu.addAction(self.tr("Remove"), self._commands.remove)
        menu.popup(self.view.viewport().mapToGlobal(at))
