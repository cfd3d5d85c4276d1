"""Notes pinned to frames and properties: written, answered, ticked off, and gone through one by one."""

from collections.abc import Callable

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtWidgets import (
    QHBoxLayout,
    QInputDialog,
    QListWidget,
    QListWidgetItem,
    QMenu,
    QPushButton,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from kagezou.document.address import Address
from kagezou.document.model import Document
from kagezou.document.note import Note
from kagezou.document.review import add_note, answer_note, change_note, tick_note
from kagezou.errors import UsageProblem
from kagezou.ui.curves.annotating import Annotating
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.note_words import note_heading, note_words
from kagezou.ui.system.words import translated

_WHAT = Qt.ItemDataRole.UserRole


class NoteList(QWidget):
    """The notes of the document; new ones are pinned to the playhead and the property at hand.

    Parameters
    ----------
    bridge
        The session.
    annotating
        Whether notes may be written, and how.
    address_at_hand
        What a new note is about.
    """

    refused = Signal(str)

    def __init__(self, bridge: Bridge, annotating: Annotating, address_at_hand: Callable[[], Address | None]) -> None:
        super().__init__()
        self._bridge, self._annotating, self._at_hand = bridge, annotating, address_at_hand
        self.author = ""
        self.list = QListWidget()
        self.list.setObjectName("note_list")
        self.list.setWordWrap(True)
        self.list.setAlternatingRowColors(True)
        self.list.setAccessibleName(self.tr("Notes"))
        self.list.itemClicked.connect(self._go_there)
        self.list.itemChanged.connect(self._take_tick)
        self.list.itemActivated.connect(lambda _item: self._ask_change())
        self.add_button = _button(self.tr("Add…"), self.tr("Pin a note to this frame"), self.ask_new)
        self.answer_button = _button(self.tr("Answer…"), self.tr("Say something to this note"), self.ask_answer)
        self.more = QToolButton()
        self.more.setText("⋯")
        self.more.setToolTip(self.tr("More"))
        self.more.setAccessibleName(self.tr("More"))
        self.more.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        menu = QMenu(self.more)
        menu.addAction(self.tr("Edit…"), self._ask_change)
        menu.addAction(self.tr("Delete"), self._delete)
        self.more.setMenu(menu)
        row = QHBoxLayout()
        row.setSpacing(4)
        for button in (self.add_button, self.answer_button, self.more):
            row.addWidget(button)
        row.addStretch(1)
        column = QVBoxLayout(self)
        column.setContentsMargins(4, 4, 4, 4)
        column.addWidget(self.list, 1)
        column.addLayout(row)
        annotating.changed.connect(self.refresh)
        self.refresh()

    def refresh(self) -> None:
        """List the notes as they are."""
        chosen, may = self._chosen(), self._annotating.may
        self.list.blockSignals(True)
        self.list.clear()
        for note in sorted(self._bridge.document.notes, key=lambda each: each.frame):
            item = QListWidgetItem(f"{note_heading(note, self._bridge.document)}\n{note_words(note)}")
            item.setData(_WHAT, note)
            item.setCheckState(Qt.CheckState.Checked if note.is_done else Qt.CheckState.Unchecked)
            if not may:
                item.setFlags(item.flags() & ~Qt.ItemFlag.ItemIsUserCheckable)
            font = item.font()
            font.setStrikeOut(note.is_done)
            item.setFont(font)
            self.list.addItem(item)
            if chosen is not None and note.is_as(chosen):
                self.list.setCurrentItem(item)
        self.list.blockSignals(False)
        for button in (self.add_button, self.answer_button, self.more):
            button.setEnabled(may)

    def choose(self, note: Note) -> None:
        """Stand at a note."""
        for row in range(self.list.count()):
            if self.list.item(row).data(_WHAT) == note:
                self.list.setCurrentRow(row)

    def ask_new(self) -> None:
        """Ask for the words of a new note."""
        address = self._at_hand()
        if address is None:
            self.refused.emit(self.tr("A note is pinned to a keyed property, and nothing is keyed yet."))
            return
        frame = self._bridge.frame
        title = (
            self.tr("Note on frame %1, %2").replace("%1", str(frame)).replace("%2", translated(address.property.label))
        )
        self._ask(title, "", lambda text: self.add(address, frame, text))

    def ask_answer(self) -> None:
        """Ask for an answer to the chosen note."""
        note = self._chosen()
        if note is not None and self._annotating.may:
            self._ask(self.tr("Answer"), "", lambda text: self.answer(note, text))

    def add(self, address: Address, frame: int, text: str) -> None:
        """Pin a note."""
        self._try(self.tr("Add note"), lambda document: add_note(document, address, frame, text, self.author))

    def answer(self, note: Note, text: str) -> None:
        """Say something to a note."""
        self._try(self.tr("Answer note"), lambda document: answer_note(document, note, text, self.author))

    def tick(self, note: Note, *, done: bool) -> None:
        """Tick a note off, or take the tick away."""
        self._try(self.tr("Tick note"), lambda document: tick_note(document, note, done=done))

    def change(self, note: Note, text: str) -> None:
        """Give a note other words, or with none take it away."""
        name = self.tr("Change note") if text.strip() else self.tr("Delete note")
        self._try(name, lambda document: change_note(document, note, text))

    def _try(self, name: str, change: Callable[[Document], Document]) -> None:
        try:
            document = change(self._bridge.document)
        except UsageProblem as problem:
            self.refused.emit(translated(problem))
        else:
            self._annotating.edit(name, document)

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
        if note is not None and self._annotating.may:
            self._ask(self.tr("Note"), note.text, lambda text: self.change(note, text))

    def _delete(self) -> None:
        note = self._chosen()
        if note is not None:
            self.change(note, "")

    def _take_tick(self, item: QListWidgetItem) -> None:
        note = item.data(_WHAT)
        if isinstance(note, Note):
            done = item.checkState() is Qt.CheckState.Checked
            # Later: the click is not at its end, and a tick lists all notes anew.
            QTimer.singleShot(0, self, lambda: self.tick(note, done=done))

    def _go_there(self, item: QListWidgetItem) -> None:
        note = item.data(_WHAT)
        if isinstance(note, Note):
            self._bridge.session.go_to(note.frame)


def _button(words: str, tip: str, do: Callable[[], None]) -> QPushButton:
    button = QPushButton(words)
    button.setToolTip(tip)
    button.setObjectName("small_button")
    button.setAutoDefault(False)
    button.clicked.connect(do)
    return button
