"""The layers of the document as Qt's item views want them: the topmost first."""

from collections.abc import Iterable, Sequence
from enum import IntEnum

from PySide6.QtCore import QAbstractListModel, QMimeData, QModelIndex, QPersistentModelIndex, Qt, Signal
from PySide6.QtGui import QImage

from kagezou.document import properties
from kagezou.document.address import Address
from kagezou.document.common_edits import set_all
from kagezou.document.edits import join_layer, move_layer, rename_layer
from kagezou.document.model import Layer
from kagezou.document.paper import set_paper
from kagezou.document.values import value_at
from kagezou.errors import UsageProblem
from kagezou.picture_source import Paper
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.missing import NOTHING_MISSING, Missing, missing_words
from kagezou.ui.system.thumbnails import Thumbnails
from kagezou.ui.system.words import translated

Index = QModelIndex | QPersistentModelIndex
MIME = "application/x-kagezou-layer"
_NO_INDEX = QModelIndex()


class Role(IntEnum):
    """What the delegate asks for beside the name."""

    LAYER_ID = Qt.ItemDataRole.UserRole + 1
    IS_VISIBLE = Qt.ItemDataRole.UserRole + 2
    THUMBNAIL = Qt.ItemDataRole.UserRole + 3
    SUMMARY = Qt.ItemDataRole.UserRole + 4
    IS_PART = Qt.ItemDataRole.UserRole + 5
    MARKS = Qt.ItemDataRole.UserRole + 6
    IS_MISSING = Qt.ItemDataRole.UserRole + 7


class LayerModel(QAbstractListModel):
    """Shows the session's layers; every change goes back through its edits."""

    refused = Signal(str)
    """What was typed cannot be the name of a layer."""

    def __init__(self, bridge: Bridge, thumbnails: Thumbnails) -> None:
        super().__init__()
        self._bridge = bridge
        self._thumbnails = thumbnails
        self._layers: tuple[Layer, ...] = bridge.document.layers
        self._missing = NOTHING_MISSING
        bridge.document_changed.connect(self._follow)
        bridge.frame_settled.connect(self._repaint)
        thumbnails.ready.connect(self._repaint)

    def layer(self, row: int) -> Layer:
        """Return the layer of a row, counted from the top."""
        return self._layers[len(self._layers) - 1 - row]

    def row_of(self, layer_id: str | None) -> int | None:
        """Return the row of a layer."""
        return None if layer_id is None else self.rows_of((layer_id,))[0]

    def rows_of(self, layer_ids: Iterable[str]) -> list[int | None]:
        """Return the rows of layers."""
        rows = {layer.id: row for row, layer in enumerate(reversed(self._layers))}
        return [rows.get(layer_id) for layer_id in layer_ids]

    def rowCount(self, parent: Index = _NO_INDEX) -> int:
        return 0 if parent.isValid() else len(self._layers)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        layer = self.layer(index.row())
        match role:
            case Qt.ItemDataRole.DisplayRole | Qt.ItemDataRole.EditRole:
                return layer.name
            case Qt.ItemDataRole.ToolTipRole:
                return self._tool_tip(layer)
            case Role.MARKS:
                return layer.marks
            case Role.IS_MISSING:
                return layer.id in self._missing
            case Role.LAYER_ID:
                return layer.id
            case Role.IS_VISIBLE:
                return value_at(layer.tracks, properties.VISIBLE, self._bridge.frame)
            case Role.THUMBNAIL:
                return self._thumbnail(layer)
            case Role.SUMMARY:
                return self._summary(layer)
            case Role.IS_PART:
                return layer.joins is not None
            case _:
                return None

    def setData(self, index: Index, value: object, role: int = Qt.ItemDataRole.EditRole) -> bool:
        layer = self.layer(index.row())
        document, session = self._bridge.document, self._bridge.session
        if role == Role.IS_VISIBLE:
            # One of several that are chosen stands for all of them.
            chosen = self._bridge.layer_ids
            self.show_layers(chosen if layer.id in chosen else (layer.id,), shown=bool(value))
            return True
        try:
            session.edit(self.tr("Rename layer"), rename_layer(document, layer.id, str(value).strip()))
        except UsageProblem as problem:
            self.refused.emit(translated(problem))
            return False
        return True

    def show_missing(self, missing: Missing) -> None:
        """Mark the layers whose files are not all there."""
        self._missing = missing
        self._repaint()

    def show_layers(self, layer_ids: tuple[str, ...], *, shown: bool) -> None:
        """Show or hide layers at the frame looked at, as one step."""
        visible = [Address(properties.VISIBLE, layer_id) for layer_id in layer_ids]
        name = self.tr("Show layer") if shown else self.tr("Hide layer")
        self._bridge.session.edit(name, set_all(self._bridge.document, visible, shown, self._bridge.frame))

    def put_on_paper(self, layer_ids: tuple[str, ...], *, outlined: bool) -> None:
        """Say for layers whether white inside an outline stays in drawings without alpha, as one step."""
        document = self._bridge.document
        for layer_id in layer_ids:
            document = set_paper(document, layer_id, Paper.BORDER if outlined else Paper.WHITE)
        self._bridge.session.edit(self.tr("Paper of drawings"), document)

    def flags(self, index: Index) -> Qt.ItemFlag:
        if not index.isValid():
            return Qt.ItemFlag.ItemIsDropEnabled
        usual = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable | Qt.ItemFlag.ItemIsEditable
        return usual | Qt.ItemFlag.ItemIsDragEnabled | Qt.ItemFlag.ItemIsDropEnabled

    def supportedDropActions(self) -> Qt.DropAction:
        return Qt.DropAction.MoveAction

    def mimeTypes(self) -> list[str]:
        return [MIME]

    def mimeData(self, indexes: Sequence[QModelIndex]) -> QMimeData:
        carried = QMimeData()
        ids = [self.layer(row).id for row in sorted({index.row() for index in indexes})]
        carried.setData(MIME, "\n".join(ids).encode())
        return carried

    def dropMimeData(self, data: QMimeData, action: Qt.DropAction, row: int, column: int, parent: Index) -> bool:
        if action is not Qt.DropAction.MoveAction or not data.hasFormat(MIME):
            return False
        ids = bytes(data.data(MIME).data()).decode().split("\n")
        if parent.isValid():
            self.join(tuple(ids), self.layer(parent.row()).id)
            return False
        below = [self.layer(each).id for each in range(max(row, 0), self.rowCount()) if row >= 0]
        anchor = next((each for each in below if each not in ids), None)
        with self._bridge.session.gesture(self.tr("Reorder layers")):
            for layer_id in ids:
                place = self.row_of(anchor)
                self.move(layer_id, self.rowCount() if place is None else place)
        # False: the model has already moved the layer, the view must not remove the row it dragged.
        return False

    def join(self, layer_ids: tuple[str, ...], figure_id: str | None) -> None:
        """Make layers parts of another one's figure, or with None figures of their own, as one step."""
        document = self._bridge.document
        for layer_id in layer_ids:
            if figure_id is None or (document.layer(figure_id).joins or figure_id) != layer_id:
                document = join_layer(document, layer_id, figure_id)
        name = self.tr("Split figure") if figure_id is None else self.tr("Join figure")
        self._bridge.session.edit(name, document)

    def move(self, layer_id: str, before_row: int) -> None:
        """Put a layer above the row that stands at ``before_row`` now."""
        old_row = self.row_of(layer_id)
        if old_row is None:
            return
        row = before_row - 1 if old_row < before_row else before_row
        moved = move_layer(self._bridge.document, layer_id, len(self._layers) - 1 - row)
        self._bridge.session.edit(self.tr("Reorder layers"), moved)

    def _tool_tip(self, layer: Layer) -> str:
        lost = self._missing.get(layer.id)
        return layer.name if lost is None else missing_words(lost, self.tr("%1 missing files in", "then a folder"))

    def _summary(self, layer: Layer) -> str:
        drawings = self.tr("%n drawing(s)", "", len(layer.cels.drawings))
        if lost := self._missing.get(layer.id):
            missing = self.tr("%1, %2 missing").replace("%2", str(len(lost)))
            drawings = missing.replace("%1", drawings)
        if layer.joins is None:
            return drawings
        figure = self._bridge.document.layer(layer.joins).name
        return self.tr("%1, part of %2").replace("%1", drawings).replace("%2", figure)

    def _thumbnail(self, layer: Layer) -> QImage | None:
        drawing = layer.cels.drawings[0] if layer.cels.drawings else None
        return None if drawing is None else self._thumbnails.image(drawing.source)

    def _follow(self) -> None:
        layers = self._bridge.document.layers
        if [layer.id for layer in layers] != [layer.id for layer in self._layers]:
            self.beginResetModel()
            self._layers = layers
            self.endResetModel()
        elif layers is not self._layers:
            before, self._layers = self._layers, layers
            if [_shown_of(layer) for layer in before] != [_shown_of(layer) for layer in layers]:
                self._repaint()

    def _repaint(self) -> None:
        if self._layers:
            self.dataChanged.emit(self.index(0), self.index(len(self._layers) - 1))


def _shown_of(layer: Layer) -> tuple[object, ...]:
    """Return what of a layer its row shows, or those of the layers that join it."""
    return layer.name, layer.marks, layer.joins, layer.cels, layer.tracks.get(properties.VISIBLE.name)
