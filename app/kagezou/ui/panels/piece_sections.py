"""The inspector's part for the set piece worked on: whose properties they are, and the properties themselves."""

from PySide6.QtCore import QCoreApplication, QSize
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSizePolicy, QWidget

from kagezou.document import set_properties as lines
from kagezou.document.address import Address
from kagezou.document.properties import OF_PIECE
from kagezou.document.property import Property
from kagezou.document.set_pieces import kind_of
from kagezou.ui.panels.property_row import PropertyRow
from kagezou.ui.panels.row_menu import PropertyMenus
from kagezou.ui.panels.section import Section
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.icons import kind_icon
from kagezou.ui.system.words import choice_word

_DOES = (lines.PIECE_PRESENT, lines.PIECE_RECEIVES, lines.PIECE_BLOCKS, lines.PIECE_CASTS)

_DEEP = ("box", "steps", "ramp")
_OF_FILES = (lines.PIECE_SCALE, lines.PIECE_UP, lines.PIECE_ANCHOR, lines.PIECE_DISPLAY, lines.PIECE_UNDER)
_ONLY_FOR = {
    lines.PIECE_LEAN: ("wall",),
    lines.PIECE_WIDTH: lines.BUILT_KINDS,
    lines.PIECE_HEIGHT: ("wall", *_DEEP, "cylinder"),
    lines.PIECE_DEPTH: _DEEP,
    lines.PIECE_COUNT: ("steps",),
    **dict.fromkeys(_OF_FILES, (lines.MESH,)),
}
"""Properties that mean something for these kinds alone and are hidden for all others."""

_NOT_FOR = {lines.PIECE_ANGLE: ("cylinder", "sphere")}


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
        self.kind.setText(words.replace("%1", choice_word(kind)))


def piece_sections(bridge: Bridge, piece_id: str, menus: PropertyMenus) -> list[Section]:
    """Return the sections of a piece: where it stands and how large it is, and what it does."""
    place = Section(QCoreApplication.translate("PieceSections", "Place and size"), menus)
    does = Section(QCoreApplication.translate("PieceSections", "What it does"), menus)
    for line in OF_PIECE.values():
        (does if line in _DOES else place).add(PropertyRow(bridge, Address(line, piece_id=piece_id), menus))
    return [place, does]


def matters(line: Property, kind: str) -> bool:
    """Whether a property of a set piece means anything for its kind."""
    return kind in _ONLY_FOR.get(line, (kind,)) and kind not in _NOT_FOR.get(line, ())
