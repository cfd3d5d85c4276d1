"""The set pieces of the document as Qt's item views want them, in the order in which they were put there."""

from enum import IntEnum

from PySide6.QtCore import QAbstractListModel, QModelIndex, QPersistentModelIndex, Qt, Signal

from kagezou.document.address import Address
from kagezou.document.edits import set_value
from kagezou.document.model import Piece
from kagezou.document.piece_kinds import kind_of
from kagezou.document.set_pieces import rename_piece
from kagezou.document.set_properties import PIECE_PRESENT
from kagezou.document.values import value_at
from kagezou.errors import UsageProblem
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.words import translated

Index = QModelIndex | QPersistentModelIndex
_NO_INDEX = QModelIndex()


class PieceRole(IntEnum):
    """What the delegate asks for beside the name."""

    PIECE_ID = Qt.ItemDataRole.UserRole + 1
    IS_PRESENT = Qt.ItemDataRole.UserRole + 2
    KIND = Qt.ItemDataRole.UserRole + 3


class SetModel(QAbstractListModel):
    """Shows the session's set pieces; every change goes back through its edits."""

    refused = Signal(str)
    """A name that cannot be, with the sentence that says why."""

    def __init__(self, bridge: Bridge) -> None:
        super().__init__()
        self._bridge = bridge
        self._pieces: tuple[Piece, ...] = bridge.document.pieces
        bridge.document_changed.connect(self._follow)
        bridge.frame_settled.connect(self._repaint)

    def row_of(self, piece_id: str | None) -> int | None:
        """Return the row of a piece."""
        return next((row for row, piece in enumerate(self._pieces) if piece.id == piece_id), None)

    def rowCount(self, parent: Index = _NO_INDEX) -> int:
        return 0 if parent.isValid() else len(self._pieces)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        piece = self._pieces[index.row()]
        match role:
            case Qt.ItemDataRole.DisplayRole | Qt.ItemDataRole.EditRole | Qt.ItemDataRole.ToolTipRole:
                return piece.name
            case PieceRole.PIECE_ID:
                return piece.id
            case PieceRole.IS_PRESENT:
                return value_at(piece.tracks, PIECE_PRESENT, self._bridge.frame)
            case PieceRole.KIND:
                return kind_of(piece, self._bridge.frame).value
            case _:
                return None

    def setData(self, index: Index, value: object, role: int = Qt.ItemDataRole.EditRole) -> bool:
        piece = self._pieces[index.row()]
        document, session = self._bridge.document, self._bridge.session
        if role == PieceRole.IS_PRESENT:
            name = self.tr("Show set piece") if value else self.tr("Hide set piece")
            session.edit(name, set_value(document, _present(piece), bool(value), self._bridge.frame))
            return True
        try:
            session.edit(self.tr("Rename set piece"), rename_piece(document, piece.id, str(value).strip()))
        except UsageProblem as problem:
            self.refused.emit(translated(problem))
            return False
        return True

    def flags(self, index: Index) -> Qt.ItemFlag:
        if not index.isValid():
            return Qt.ItemFlag.NoItemFlags
        return Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable | Qt.ItemFlag.ItemIsEditable

    def _follow(self) -> None:
        pieces = self._bridge.document.pieces
        if [piece.id for piece in pieces] != [piece.id for piece in self._pieces]:
            self.beginResetModel()
            self._pieces = pieces
            self.endResetModel()
        elif pieces is not self._pieces:
            self._pieces = pieces
            self._repaint()

    def _repaint(self) -> None:
        if self._pieces:
            self.dataChanged.emit(self.index(0), self.index(len(self._pieces) - 1))


def _present(piece: Piece) -> Address:
    return Address(PIECE_PRESENT, piece_id=piece.id)
