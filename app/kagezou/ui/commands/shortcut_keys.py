"""The keys of one command, to take away and to add by pressing them."""

from PySide6.QtCore import QCoreApplication, Qt, Signal
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QFrame, QHBoxLayout, QKeySequenceEdit, QLabel, QPushButton, QVBoxLayout

from kagezou.ui.system.icons import icon, icon_size
from kagezou.ui.widgets.retiring import retire

RESERVED = frozenset({"Space", "Esc", "Tab", "Shift+Tab", "Return", "Enter"})
"""Keys that the picture and the fields need for themselves."""

UNSURE = frozenset("[];'=`")
"""Keys that some keyboards lack or have elsewhere; beside one of these a second key is needed."""


class KeysOfCommand(QFrame):
    """The keys as buttons with a cross, and a field that takes the next keys pressed."""

    given = Signal(str)
    taken = Signal(str)
    reset_asked = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("keys_of_command")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self._owner_of: dict[str, str] = {}
        self._waiting = ""
        self._title = QLabel()
        self._title.setObjectName("sheet_heading")
        self._caps = QHBoxLayout()
        self._caps.setSpacing(6)
        self.field = QKeySequenceEdit()
        self.field.setMaximumSequenceLength(1)
        self.field.setMinimumWidth(22 * self.fontMetrics().averageCharWidth())
        self.field.setAccessibleName(self.tr("Press the new keys"))
        self.field.setToolTip(self.tr("Click here, then press the new keys"))
        self.field.editingFinished.connect(self._record)
        self.reset = QPushButton(self.tr("Reset"))
        self.reset.setObjectName("small_button")
        self.reset.setAutoDefault(False)
        self.reset.clicked.connect(self.reset_asked)
        self.note = QLabel()
        self.note.setWordWrap(True)
        self.move_here = QPushButton(self.tr("Move It Here"))
        self.move_here.setObjectName("small_button")
        self.move_here.setAutoDefault(False)
        self.move_here.clicked.connect(self._move_here)
        self._lay_out()
        self.show_command("", (), {}, is_own=False)

    def show_command(self, words: str, keys: tuple[str, ...], owner_of: dict[str, str], *, is_own: bool) -> None:
        """Show the keys of a command; ``owner_of`` names in words what every key of the others does."""
        self._owner_of = owner_of
        self._title.setText(self.tr("Keys of “%1”").replace("%1", words) if words else self.tr("Choose a command"))
        items = iter(lambda: self._caps.takeAt(0), None)
        retire([old for item in items if (old := item.widget()) is not None])
        for key in keys:
            self._caps.addWidget(self._cap(key))
        self.field.setEnabled(bool(words))
        self.reset.setEnabled(is_own)
        unsure = [key for key in keys if key in UNSURE]
        self._say(
            self.tr("Not every keyboard has %1: add a second shortcut.").replace("%1", unsure[0])
            if unsure and len(unsure) == len(keys)
            else ""
        )

    def _lay_out(self) -> None:
        hint = QLabel(self.tr("Add:"))
        row = QHBoxLayout()
        row.setSpacing(8)
        row.addLayout(self._caps)
        row.addWidget(hint)
        row.addWidget(self.field)
        row.addStretch(1)
        row.addWidget(self.reset)
        below = QHBoxLayout()
        below.addWidget(self.note, 1)
        below.addWidget(self.move_here)
        column = QVBoxLayout(self)
        column.setContentsMargins(12, 10, 12, 10)
        column.setSpacing(8)
        column.addWidget(self._title)
        column.addLayout(row)
        column.addLayout(below)
        # Room for one line, so that nothing jumps when it speaks.
        self.note.setMinimumHeight(self.move_here.sizeHint().height())

    def _cap(self, key: str) -> QPushButton:
        shown = _native(key)
        cap = QPushButton(icon("close"), shown)
        cap.setObjectName("key_cap_button")
        cap.setIconSize(icon_size(cap.fontMetrics(), small=True))
        cap.setLayoutDirection(Qt.LayoutDirection.RightToLeft)
        cap.setAutoDefault(False)
        words = QCoreApplication.translate("KeysOfCommand", "Take %1 away").replace("%1", shown)
        cap.setToolTip(words)
        cap.setAccessibleName(words)
        cap.clicked.connect(lambda: self.taken.emit(key))
        return cap

    def _record(self) -> None:
        key = self.field.keySequence().toString(QKeySequence.SequenceFormat.PortableText)
        self.field.clear()
        if not key:
            return
        shown = _native(key)
        if key in RESERVED:
            self._say(self.tr("%1 belongs to the picture and the fields.").replace("%1", shown))
        elif (other := self._owner_of.get(key)) is not None:
            self._waiting = key
            self._say(self.tr("%1 already belongs to “%2”.").replace("%1", shown).replace("%2", other), can_move=True)
        else:
            self.given.emit(key)

    def _move_here(self) -> None:
        key, self._waiting = self._waiting, ""
        self._say("")
        if key:
            self.given.emit(key)

    def _say(self, sentence: str, *, can_move: bool = False) -> None:
        self.note.setText(sentence)
        self.move_here.setVisible(can_move)


def _native(key: str) -> str:
    return QKeySequence(key).toString(QKeySequence.SequenceFormat.NativeText)
