"""The list of layers: choose, show and hide, rename, reorder by dragging, remove, add."""

from functools import partial

from PySide6.QtCore import (
    QEvent,
    QItemSelection,
    QItemSelectionModel,
    QModelIndex,
    QPersistentModelIndex,
    QPoint,
    Qt,
    Signal,
)
from PySide6.QtGui import QKeyEvent, QMouseEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QLabel,
    QListView,
    QMenu,
    QStackedLayout,
    QVBoxLayout,
    QWidget,
)

from kagezou.document.edits import remove_layer
from kagezou.document.paper import paper_of
from kagezou.picture_source import Paper
from kagezou.ui.panels.layer_delegate import LayerDelegate
from kagezou.ui.panels.layer_model import LayerModel, Role
from kagezou.ui.panels.look_clipboard import LookClipboard
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.clipboard import Clipboard
from kagezou.ui.system.thumbnails import Thumbnails
from kagezou.ui.widgets.eye_delegate import EYE_WIDTH
from kagezou.ui.widgets.tool_button import tool_button


class LayerView(QListView):
    """The rows; F2 and a double click rename."""

    def __init__(self, model: LayerModel) -> None:
        super().__init__()
        self.setModel(model)
        self.setItemDelegate(LayerDelegate(self))
        self.setMouseTracking(True)
        self.setUniformItemSizes(True)
        self.setDragDropMode(QAbstractItemView.DragDropMode.InternalMove)
        self.setDefaultDropAction(Qt.DropAction.MoveAction)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.DoubleClicked | QAbstractItemView.EditTrigger.EditKeyPressed)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setAccessibleName(self.tr("Layers"))

    def selectionCommand(
        self, index: QModelIndex | QPersistentModelIndex, event: QEvent | None = None
    ) -> QItemSelectionModel.SelectionFlag:
        # The eye of any row is clicked without letting go of what is chosen.
        if isinstance(event, QMouseEvent) and event.position().x() < EYE_WIDTH:
            return QItemSelectionModel.SelectionFlag.NoUpdate
        return super().selectionCommand(index, event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        # The space bar plays, wherever the focus is.
        if event.key() == Qt.Key.Key_Space:
            event.ignore()
        else:
            super().keyPressEvent(event)


class LayerList(QWidget):
    """The panel: the rows over a small footer."""

    add_asked = Signal()
    menu_opening = Signal(QMenu)
    """The menu of a layer is about to open; whoever knows more that can be done with it adds that."""

    def __init__(self, bridge: Bridge, clipboard: Clipboard, thumbnails: Thumbnails) -> None:
        super().__init__()
        self._bridge = bridge
        self._follows = False
        self.looks = LookClipboard(bridge, clipboard)
        self.model = LayerModel(bridge, thumbnails)
        self.view = LayerView(self.model)
        self.view.selectionModel().selectionChanged.connect(self._choose)
        self.view.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.view.customContextMenuRequested.connect(self._open_menu)
        self.model.modelReset.connect(self._follow_selection)
        bridge.selection_changed.connect(self._follow_selection)
        bridge.document_changed.connect(self._follow_selection)
        self._lay_out()
        self._follow_selection()

    def remove_current(self) -> None:
        """Take the chosen layers away."""
        document = self._bridge.document
        for layer_id in self._bridge.layer_ids:
            document = remove_layer(document, layer_id)
        self._bridge.session.edit(self.tr("Remove layer"), document)

    def rename_current(self) -> None:
        """Begin to type another name for the chosen layer."""
        if self.view.currentIndex().isValid():
            self.view.edit(self.view.currentIndex())

    def _lay_out(self) -> None:
        self._empty = QLabel(self.tr("No layers yet.\nDrop a folder of cels here."))
        self._empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._empty.setWordWrap(True)
        self._empty.setObjectName("welcome_hint")
        rows = QWidget()
        self._pages = QStackedLayout(rows)
        self._pages.addWidget(self.view)
        self._pages.addWidget(self._empty)
        footer = QWidget()
        footer.setObjectName("panel_footer")
        footer.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        row = QHBoxLayout(footer)
        row.setContentsMargins(4, 2, 4, 2)
        row.addWidget(tool_button("add", self.tr("Add cels as a new layer"), self.add_asked.emit))
        row.addStretch(1)
        self._remove = tool_button("remove", self.tr("Remove layer"), self.remove_current)
        row.addWidget(self._remove)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(rows, 1)
        column.addWidget(footer)

    def _choose(self) -> None:
        indexes = self.view.selectionModel().selectedIndexes()
        if self._follows or not indexes:
            return
        ids = [str(index.data(Role.LAYER_ID)) for index in indexes]
        # The one that was there before stays the one worked on, so that more are added to it.
        first = self._bridge.layer_id if self._bridge.layer_id in ids else ids[-1]
        self._bridge.session.select(str(first), others=frozenset(ids) - {first})

    def _follow_selection(self) -> None:
        self._pages.setCurrentIndex(0 if self.model.rowCount() else 1)
        self._remove.setEnabled(self._bridge.layer_id is not None)
        rows = self.model.rows_of(self._bridge.layer_ids)
        selection = QItemSelection()
        for row in rows:
            if row is not None:
                selection.select(self.model.index(row), self.model.index(row))
        chosen, flag = self.view.selectionModel(), QItemSelectionModel.SelectionFlag
        if {index.row() for index in chosen.selectedIndexes()} == set(rows):
            return
        self._follows = True
        chosen.select(selection, flag.ClearAndSelect)
        if rows and rows[0] is not None:
            chosen.setCurrentIndex(self.model.index(rows[0]), flag.NoUpdate)
        self._follows = False

    def _offer_joining(self, menu: QMenu) -> None:
        """Offer the figures that the chosen layers could be parts of, and to be figures of their own."""
        ids, document = self._bridge.layer_ids, self._bridge.document
        figures = [layer for layer in document.layers if layer.joins is None and layer.id not in ids]
        join = menu.addMenu(self.tr("Join Figure"))
        for figure in reversed(figures):
            join.addAction(figure.name, partial(self.model.join, ids, figure.id))
        join.setEnabled(bool(figures))
        split = menu.addAction(self.tr("Make a Figure of Its Own"), partial(self.model.join, ids, None))
        split.setEnabled(any(document.layer(each).joins is not None for each in ids))
        menu.addSeparator()

    def _open_menu(self, at: QPoint) -> None:
        index = self.view.indexAt(at)
        if not index.isValid():
            return
        if not self.view.selectionModel().isSelected(index):
            self.view.setCurrentIndex(index)
        layer_id = str(index.data(Role.LAYER_ID))
        visible = bool(index.data(Role.IS_VISIBLE))
        menu = QMenu(self.view)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.addAction(self.tr("Rename"), self.rename_current)
        self._offer_joining(menu)
        self.menu_opening.emit(menu)
        hide_or_show = self.tr("Hide") if visible else self.tr("Show")
        menu.addAction(hide_or_show, lambda: self.model.show_layers(self._bridge.layer_ids, shown=not visible))
        menu.addSeparator()
        menu.addAction(self.tr("Copy Look"), self.looks.copy)
        menu.addAction(self.tr("Paste Look"), self.looks.paste).setEnabled(self.looks.can_paste)
        self._add_paper(menu, layer_id)
        menu.addSeparator()
        up = menu.addAction(self.tr("Move up"), lambda: self.model.move(layer_id, index.row() - 1))
        up.setEnabled(index.row() > 0)
        down = menu.addAction(self.tr("Move down"), lambda: self.model.move(layer_id, index.row() + 2))
        down.setEnabled(index.row() < self.model.rowCount() - 1)
        menu.addSeparator()
        menu.addAction(self.tr("Remove"), self.remove_current)
        menu.popup(self.view.viewport().mapToGlobal(at))

    def _add_paper(self, menu: QMenu, layer_id: str) -> None:
        """Add the switch of what is clear on the paper of drawings that are files of their own."""
        layer = self._bridge.document.layer(layer_id)
        if not any(drawing.part is None for drawing in layer.cels.drawings):
            return
        outlined = menu.addAction(self.tr("White inside Outlines Stays"))
        outlined.setCheckable(True)
        outlined.setChecked(paper_of(layer) is Paper.BORDER)
        outlined.setToolTip(
            self.tr(
                "For drawings without alpha: only white that reaches the border is clear, so that white shirts, hair "
                "and eyes stay. White between arm and body stays, too."
            )
        )
        menu.setToolTipsVisible(True)
        outlined.triggered.connect(lambda on: self.model.put_on_paper(self._bridge.layer_ids, outlined=on))
