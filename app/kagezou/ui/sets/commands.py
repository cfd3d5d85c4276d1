"""What the commands on the set do: pieces come, are copied and go; each is one step with a name."""

from PySide6.QtCore import QObject, Signal

from kagezou.document.address import Address, track_of
from kagezou.document.edits import set_constant
from kagezou.document.model import Document
from kagezou.document.set_pieces import copy_piece, remove_piece
from kagezou.document.set_properties import PIECE_POSITION
from kagezou.errors import Problem
from kagezou.geometry.sets.measures import PieceKind
from kagezou.importing.silhouettes import silhouettes_of
from kagezou.tools.placing import NewPiece, add_placed
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.kind_words import words_for_adding
from kagezou.ui.system.words import choice_name, translated

_COPY_AWAY = 0.04
"""How far aside a copy stands, as a part of the canvas' width."""


class SetCommands(QObject):
    """Adding, copying and removing set pieces.

    Parameters
    ----------
    bridge
        The session.
    """

    refused = Signal(str)
    """One sentence on why nothing happened."""

    def __init__(self, bridge: Bridge) -> None:
        super().__init__()
        self._bridge = bridge

    def add(self, kind: PieceKind) -> None:
        """Put a piece where it is seen, and work on it."""
        bridge = self._bridge
        layer_id = bridge.layer_id
        try:
            shapes = silhouettes_of(bridge.document, bridge.frame)
            new = NewPiece(kind, choice_name(kind))
            document, piece_id = add_placed(bridge.document, bridge.frame, layer_id, new, shapes)
        except Problem as problem:
            self.refused.emit(translated(problem))
            return
        self._edit(words_for_adding(kind), document, piece_id)

    def duplicate(self) -> None:
        """Put a second piece like the one worked on a little aside, and work on that."""
        piece_id = self._bridge.piece_id
        if piece_id is None:
            return
        try:
            document = copy_piece(self._bridge.document, piece_id)
        except Problem as problem:
            self.refused.emit(translated(problem))
            return
        twin = document.pieces[-1].id
        self._edit(self.tr("Duplicate set piece"), _aside(document, twin), twin)

    def remove(self) -> None:
        """Take the piece worked on out of the set."""
        piece_id = self._bridge.piece_id
        if piece_id is not None:
            self._bridge.session.edit(self.tr("Remove set piece"), remove_piece(self._bridge.document, piece_id))

    def _edit(self, name: str, document: Document, piece_id: str) -> None:
        # The piece is chosen within the step, so that redo brings it back chosen.
        with self._bridge.session.gesture(name) as gesture:
            gesture.show(document)
            self._bridge.session.select_piece(piece_id)


def _aside(document: Document, piece_id: str) -> Document:
    address = Address(PIECE_POSITION, piece_id=piece_id)
    track = track_of(document, address)
    if track.is_keyed:
        # What moves keeps its way.
        return document
    x, y = PIECE_POSITION.typed(track.constant)
    return set_constant(document, address, (x + round(_COPY_AWAY * document.canvas.width_px), y))
