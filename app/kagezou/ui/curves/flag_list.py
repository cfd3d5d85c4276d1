"""Flags of what stands out in the curves of the whole cut: a list to go through one by one."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QListWidget, QListWidgetItem, QVBoxLayout, QWidget

from kagezou.document.frame_numbers import number_of
from kagezou.document.key_edits import KeyRef
from kagezou.ui.curves.flags import Flag, flags_of, keyed_addresses
from kagezou.ui.curves.remarks import flag_words
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.note_words import owner_words
from kagezou.ui.widgets.number_boxes import NumberBox

_WHAT = Qt.ItemDataRole.UserRole
_JUMP_PX = 60.0


class FlagList(QWidget):
    """What stands out in any curve, of whichever layer; a click goes there.

    Parameters
    ----------
    bridge
        The session.
    """

    def __init__(self, bridge: Bridge) -> None:
        super().__init__()
        self._bridge = bridge
        self.list = QListWidget()
        self.list.setAlternatingRowColors(True)
        self.list.setWordWrap(True)
        self.list.setAccessibleName(self.tr("Flags"))
        self.list.itemClicked.connect(self._go_there)
        self.limit = NumberBox()
        self.limit.setRange(1, 10000)
        self.limit.setDecimals(0)
        self.limit.setSuffix(" px")
        self.limit.setValue(_JUMP_PX)
        self.limit.setToolTip(self.tr("Places that move farther than this in a frame"))
        self.limit.valueChanged.connect(self.refresh)
        row = QHBoxLayout()
        row.addWidget(QLabel(self.tr("Too fast:")))
        row.addWidget(self.limit)
        row.addStretch(1)
        column = QVBoxLayout(self)
        column.setContentsMargins(4, 4, 4, 4)
        column.addWidget(self.list, 1)
        column.addLayout(row)
        self.refresh()

    @property
    def flags(self) -> tuple[Flag, ...]:
        """What stands out now."""
        document = self._bridge.document
        return flags_of(document, keyed_addresses(document), self.limit.value())

    def refresh(self) -> None:
        """List what stands out now."""
        self.list.clear()
        for flag in self.flags:
            document = self._bridge.document
            owner, number = owner_words(document, flag.address), number_of(document.canvas, flag.frame)
            item = QListWidgetItem(f"{number}   {owner}   {flag_words(flag)}")
            item.setData(_WHAT, flag)
            self.list.addItem(item)
        if not self.list.count():
            item = QListWidgetItem(self.tr("Nothing stands out."))
            item.setFlags(Qt.ItemFlag.NoItemFlags)
            self.list.addItem(item)

    def go_to(self, flag: Flag) -> None:
        """Go to a flag: work on its layer, and select the key there is."""
        session, address = self._bridge.session, flag.address
        if address.piece_id is not None:
            session.select_piece(address.piece_id)
        elif address.layer_id is not None and address.layer_id not in self._bridge.layer_ids:
            session.select(address.layer_id)
        session.go_to(flag.frame)
        session.select_keys(frozenset({KeyRef(address, flag.frame)}))

    def _go_there(self, item: QListWidgetItem) -> None:
        flag = item.data(_WHAT)
        if isinstance(flag, Flag):
            self.go_to(flag)
