"""Notes pinned to frames and properties, and flags of what stands out: lists to go through one by one."""

from collections.abc import Callable

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QDoubleSpinBox,
    QHBoxLayout,
    QInputDialog,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from kagezou.document.address import Address
from kagezou.document.frame_numbers import number_of
from kagezou.document.key_edits import KeyRef
from kagezou.document.model import Note
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER
from kagezou.document.review import add_note, change_note
from kagezou.errors import UsageProblem
from kagezou.ui.curves.choice import Choice
from kagezou.ui.curves.flags import Flag, FlagKind, flags_of
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.words import translated

_WHAT = Qt.ItemDataRole.UserRole
_JUMP_PX = 60.0


class NoteList(QWidget):
    """The notes of the document; new ones are pinned to the playhead and the property at hand."""

    refused = Signal(str)

    def __init__(self, bridge: Bridge, choice: Choice, address_at_hand: Callable[[], Address | None]) -> None:
        super().__init__()
        self._bridge, self._choice, self._at_hand = bridge, choice, address_at_hand
        self.list = QListWidget()
        self.list.setWordWrap(True)
        self.list.setAlternatingRowColors(True)
        self.list.setAccessibleName(self.tr("Notes"))
        self.list.itemClicked.connect(self._go_there)
        self.list.itemActivated.connect(lambda _item: self._ask_change())
        self._buttons = [
            _button(self.tr("Add Note…"), self.ask_new),
            _button(self.tr("Edit…"), self._ask_change),
            _button(self.tr("Delete"), self._delete),
        ]
        row = QHBoxLayout()
        for button in self._buttons:
            row.addWidget(button)
        row.addStretch(1)
        column = QVBoxLayout(self)
        column.setContentsMargins(4, 4, 4, 4)
        column.addWidget(self.list, 1)
        column.addLayout(row)
        self.refresh()

    def refresh(self) -> None:
        """List the notes as they are."""
        self.list.clear()
        for note in sorted(self._bridge.document.notes, key=lambda each: each.frame):
            prop = (OF_DOCUMENT if note.layer_id is None else OF_LAYER)[note.property]
            layer = "" if note.layer_id is None else f"{self._bridge.document.layer(note.layer_id).name} · "
            author = f" — {note.author}" if note.author else ""
            number = number_of(self._bridge.document.canvas, note.frame)
            item = QListWidgetItem(f"{number}   {layer}{translated(prop.label)}{author}\n{note.text}")
            item.setData(_WHAT, note)
            self.list.addItem(item)
        for button in self._buttons:
            button.setEnabled(not self._choice.is_locked)

    def ask_new(self) -> None:
        """Ask for the words of a new note."""
        address = self._at_hand()
        if address is None:
            self.refused.emit(self.tr("A note is pinned to a keyed property, and nothing is keyed yet."))
            return
        frame = self._bridge.frame
        number = str(number_of(self._bridge.document.canvas, frame))
        title = self.tr("Note on frame %1, %2").replace("%1", number).replace("%2", translated(address.property.label))
        self._ask(title, "", lambda text: self.add(address, frame, text))

    def add(self, address: Address, frame: int, text: str) -> None:
        """Pin a note."""
        try:
            document = add_note(self._bridge.document, address, frame, text)
        except UsageProblem as problem:
            self.refused.emit(translated(problem))
        else:
            self._bridge.session.edit(self.tr("Add note"), document)

    def change(self, note: Note, text: str) -> None:
        """Give a note other words, or with none take it away."""
        name = self.tr("Change note") if text.strip() else self.tr("Delete note")
        self._bridge.session.edit(name, change_note(self._bridge.document, note, text[:4000]))

    def _ask(self, title: str, text: str, then: Callable[[str], None]) -> None:
        dialog = QInputDialog(self)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.setWindowTitle(self.tr("Note"))
        dialog.setOption(QInputDialog.InputDialogOption.UsePlainTextEditForTextInput)
        dialog.setLabelText(title)
        dialog.setTextValue(text)
        dialog.textValueSelected.connect(then)
        dialog.open()

    def _chosen(self) -> Note | None:
        item = self.list.currentItem()
        note = None if item is None else item.data(_WHAT)
        return note if isinstance(note, Note) else None

    def _ask_change(self) -> None:
        note = self._chosen()
        if note is not None and not self._choice.is_locked:
            self._ask(self.tr("Note"), note.text, lambda text: self.change(note, text))

    def _delete(self) -> None:
        note = self._chosen()
        if note is not None:
            self.change(note, "")

    def _go_there(self, item: QListWidgetItem) -> None:
        note = item.data(_WHAT)
        if isinstance(note, Note):
            self._bridge.session.go_to(note.frame)


class FlagList(QWidget):
    """What stands out in the curves that are shown; a click goes there."""

    def __init__(self, bridge: Bridge, choice: Choice) -> None:
        super().__init__()
        self._bridge, self._choice = bridge, choice
        self.list = QListWidget()
        self.list.setAlternatingRowColors(True)
        self.list.setAccessibleName(self.tr("Flags"))
        self.list.itemClicked.connect(self._go_there)
        self.limit = QDoubleSpinBox()
        self.limit.setRange(1, 10000)
        self.limit.setDecimals(0)
        self.limit.setSuffix(" px")
        self.limit.setValue(_JUMP_PX)
        self.limit.valueChanged.connect(self.refresh)
        row = QHBoxLayout()
        row.addWidget(QLabel(self.tr("Jumps farther than, a frame:")))
        row.addWidget(self.limit)
        row.addStretch(1)
        column = QVBoxLayout(self)
        column.setContentsMargins(4, 4, 4, 4)
        column.addWidget(self.list, 1)
        column.addLayout(row)
        self.refresh()

    def refresh(self) -> None:
        """List what stands out now."""
        addresses = tuple(dict.fromkeys(curve.address for curve in self._choice.shown))
        self.list.clear()
        for flag in flags_of(self._bridge.document, addresses, self.limit.value()):
            number = number_of(self._bridge.document.canvas, flag.frame)
            item = QListWidgetItem(f"{number}   {translated(flag.address.property.label)}   {self._words(flag)}")
            item.setData(_WHAT, flag)
            self.list.addItem(item)
        if not self.list.count():
            item = QListWidgetItem(self.tr("Nothing stands out."))
            item.setFlags(Qt.ItemFlag.NoItemFlags)
            self.list.addItem(item)

    def _words(self, flag: Flag) -> str:
        if flag.kind is FlagKind.JUMP:
            return self.tr("jumps by %1 px").replace("%1", f"{flag.amount:.0f}")
        return self.tr("key between two drawings")

    def _go_there(self, item: QListWidgetItem) -> None:
        flag = item.data(_WHAT)
        if isinstance(flag, Flag):
            self._bridge.session.go_to(flag.frame)
            self._bridge.session.select_keys(frozenset({KeyRef(flag.address, flag.frame)}))


def _button(words: str, do: Callable[[], None]) -> QPushButton:
    button = QPushButton(words)
    button.setAutoDefault(False)
    button.clicked.connect(do)
    return button
