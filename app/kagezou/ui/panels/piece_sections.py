"""The inspector's part for the set piece worked on: whose properties they are, and the properties themselves."""

from PySide6.QtCore import QCoreApplication, QSize
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSizePolicy, QWidget

from kagezou.document import set_properties as lines
from kagezou.document.address import Address
from kagezou.document.piece_kinds import kind_of
from kagezou.document.properties import OF_PIECE
from kagezou.ui.panels.property_row import PropertyRow
from kagezou.ui.panels.row_menu import PropertyMenus
from kagezou.ui.panels.section import Section
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.icons import kind_icon
from kagezou.ui.system.words import choice_name

_DOES = (lines.PIECE_PRESENT, lines.PIECE_RECEIVES, lines.PIECE_BLOCKS, lines.PIECE_CASTS)


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


def piece_sections(bridge: Bridge, piece_id: str, menus: PropertyMenus) -> list[Section]:
    """Return the sections of a piece: where it stands and how large it is, and what it does."""
    place = Section(QCoreApplication.translate("PieceSections", "Place and size"), menus)
    does = Section(QCoreApplication.translate("PieceSections", "What it does"), menus)
    for line in OF_PIECE.values():
        (does if line in _DOES else place).add(PropertyRow(bridge, Address(line, piece_id=piece_id), menus))
    return [place, does]
