"""The inspector's heading for the set piece worked on: whose properties they are."""

from PySide6.QtCore import QCoreApplication, QSize
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSizePolicy, QWidget

from kagezou.document.piece_kinds import kind_of
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.icons import kind_icon
from kagezou.ui.system.words import choice_name


class PieceName(QWidget):
    """Says whose properties stand below: the piece's picture, name and kind."""

    def __init__(self, bridge: Bridge, piece_id: str) -> None:
        super().__init__()
        self.setObjectName("owner")
        self._bridge = bridge
        self._piece_id = piece_id
        self._picture = QLabel()
        self.name = QLabel()
        # A long name must not widen the panel.
        self.name.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.kind = QLabel()
        self.kind.setObjectName("owner_kind")
        row = QHBoxLayout(self)
        row.setContentsMargins(10, 7, 10, 6)
        row.setSpacing(8)
        row.addWidget(self._picture)
        row.addWidget(self.name, 1)
        row.addWidget(self.kind)
        self.refresh()

    def refresh(self) -> None:
        """Show what the piece is called and is at the frame looked at."""
        piece = self._bridge.document.piece(self._piece_id)
        kind = kind_of(piece, self._bridge.frame)
        self._picture.setPixmap(kind_icon(kind).pixmap(QSize(16, 16)))
        self.name.setText(piece.name)
        words = QCoreApplication.translate("PieceName", "Set piece: %1")
        self.kind.setText(words.replace("%1", choice_name(kind)))
