"""The sheet of shortcuts: what the hand does, and every command with its keys, under headings and searchable."""

from collections.abc import Sequence

from PySide6.QtCore import QCoreApplication, QSize, Qt, Signal
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from kagezou.ui.commands.actions import Actions
from kagezou.ui.commands.fuzzy import score
from kagezou.ui.system.language import in_all_languages
from kagezou.ui.system.menu_words import plain

_COLUMNS = 2
_EDGE_PX = 20
"""So much of the window stays to be seen around the sheet."""


class SheetRow(QWidget):
    """One line: words at the left, keys as caps at the right.

    Parameters
    ----------
    words
        What it does; the first is read, all are searched.
    caps
        The keys or movements.
    """

    def __init__(self, words: tuple[str, ...], caps: Sequence[str]) -> None:
        super().__init__()
        self.words = words
        self.caps = tuple(caps)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 1, 0, 1)
        row.setSpacing(5)
        label = QLabel(words[0])
        label.setObjectName("shortcut_words")
        label.setWordWrap(True)
        row.addWidget(label, 1)
        for cap in caps:
            shown = QLabel(cap)
            shown.setObjectName("key_cap")
            row.addWidget(shown)

    def fits(self, typed: str) -> bool:
        """Whether typed words are found in what it does, or are its keys."""
        pressed = typed.replace(" ", "").casefold()
        by_keys = any(pressed == cap.replace(" ", "").casefold() for cap in self.caps)
        return by_keys or any(score(typed, each) is not None for each in self.words)


class ShortcutSheet(QDialog):
    """The sheet; it may stay open beside the work.

    Parameters
    ----------
    parent
        The window.
    actions
        The commands and their keys now.
    set_name
        The name of the set of shortcuts in use.
    """

    edit_asked = Signal()

    def __init__(self, parent: QWidget, actions: Actions, set_name: str) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Keyboard Shortcuts"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.sections = [_Section(self.tr("With the hand"), [SheetRow((does,), caps) for does, caps in _gestures()])]
        for group in actions.groups:
            if rows := _rows(actions, [each.name for each in group.commands]):
                self.sections.append(_Section(group.title, rows))
        self.field = QLineEdit()
        self.field.setPlaceholderText(self.tr("Search by name or keys"))
        self.field.setAccessibleName(self.tr("Search by name or keys"))
        self.field.setClearButtonEnabled(True)
        self.field.textChanged.connect(self._show_fitting)
        self._nothing = QLabel(self.tr("Nothing of this name"))
        self._nothing.setObjectName("welcome_hint")
        self._nothing.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._nothing.hide()
        self._lay_out(set_name)
        letter = self.fontMetrics().averageCharWidth()
        wanted = QSize(132 * letter, 44 * self.fontMetrics().height())
        # Within the window, which is within the screen: nothing of it is out of reach.
        self.resize(wanted.boundedTo(parent.window().size() - QSize(2 * _EDGE_PX, 2 * _EDGE_PX)))

    def _lay_out(self, set_name: str) -> None:
        head = QHBoxLayout()
        head.addWidget(self.field, 1)
        head.addSpacing(12)
        head.addWidget(QLabel(self.tr("Set: %1").replace("%1", set_name)))
        sheet = QWidget()
        columns = QHBoxLayout(sheet)
        columns.setContentsMargins(2, 2, 12, 2)
        columns.setSpacing(36)
        for sections in _balanced(self.sections):
            column = QVBoxLayout()
            column.setSpacing(14)
            for section in sections:
                column.addWidget(section)
            column.addStretch(1)
            columns.addLayout(column, 1)
        area = QScrollArea()
        area.setWidget(sheet)
        area.setWidgetResizable(True)
        area.setFrameShape(QFrame.Shape.NoFrame)
        area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        buttons = QDialogButtonBox()
        edit = buttons.addButton(self.tr("Edit Shortcuts…"), QDialogButtonBox.ButtonRole.ActionRole)
        edit.setAutoDefault(False)
        edit.clicked.connect(self.edit_asked)
        close = buttons.addButton(self.tr("Close"), QDialogButtonBox.ButtonRole.RejectRole)
        close.setAutoDefault(False)
        buttons.rejected.connect(self.reject)
        column = QVBoxLayout(self)
        column.setContentsMargins(20, 16, 20, 14)
        column.setSpacing(12)
        column.addLayout(head)
        column.addWidget(self._nothing)
        column.addWidget(area, 1)
        column.addWidget(buttons)

    def _show_fitting(self, typed: str) -> None:
        shown = [section.show_fitting(typed) for section in self.sections]
        self._nothing.setVisible(not any(shown))


class _Section(QWidget):
    def __init__(self, title: str, rows: Sequence[SheetRow]) -> None:
        super().__init__()
        self.rows = tuple(rows)
        heading = QLabel(title)
        heading.setObjectName("sheet_heading")
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setVerticalSpacing(2)
        grid.addWidget(heading)
        for row in rows:
            grid.addWidget(row)

    def show_fitting(self, typed: str) -> bool:
        """Show the rows that fit; false if none does."""
        fitting = [row.fits(typed) for row in self.rows]
        for row, fits in zip(self.rows, fitting, strict=True):
            row.setVisible(fits)
        self.setVisible(any(fitting))
        return any(fitting)


def _balanced(sections: Sequence[_Section]) -> list[list[_Section]]:
    """Return the sections in columns of about the same length, in their order."""
    whole = sum(len(section.rows) + 2 for section in sections)
    columns: list[list[_Section]] = [[] for _ in range(_COLUMNS)]
    before = 0
    for section in sections:
        high = len(section.rows) + 2
        columns[min(int((before + high / 2) * _COLUMNS / whole), _COLUMNS - 1)].append(section)
        before += high
    return columns


def _rows(actions: Actions, names: Sequence[str]) -> list[SheetRow]:
    rows = []
    native = QKeySequence.SequenceFormat.NativeText
    commands = {command.name: command for command in actions.commands}
    for name in names:
        if actions.is_answered(name) and actions.keys(name):
            names_of_it = in_all_languages("Commands", commands[name].source)
            words = (plain(commands[name].text), *map(plain, names_of_it))
            rows.append(SheetRow(words, [QKeySequence(key).toString(native) for key in actions.keys(name)]))
    return rows


def _gestures() -> tuple[tuple[str, tuple[str, ...]], ...]:
    translate = QCoreApplication.translate
    return (
        (translate("Help", "Play / stop"), (translate("Help", "Space"),)),
        (
            translate("Help", "Move the picture"),
            (translate("Help", "Space + drag"), translate("Help", "Middle button")),
        ),
        (translate("Help", "Zoom at the pointer"), (translate("Help", "Wheel"),)),
        (translate("Help", "Add a grounding point"), (translate("Help", "Double click on the character"),)),
        (translate("Help", "Keep to one axis, or to steps of 15°"), (translate("Help", "Shift + drag"),)),
        (translate("Help", "Move the counterpart the opposite way"), (translate("Help", "Alt + drag"),)),
        (translate("Help", "Drag at a tenth of the speed"), (translate("Help", "Shift + Alt + drag"),)),
        (translate("Help", "Do not snap"), (translate("Help", "Ctrl + drag"),)),
        (translate("Help", "Take a drag back"), (translate("Help", "Esc"), translate("Help", "Right button"))),
        (translate("Help", "Set the exact value while dragging"), (translate("Help", "Digits"), "412,203", "+10")),
        (translate("Help", "Select the next handle"), (translate("Help", "Tab"),)),
        (
            translate("Help", "Hide or show the panels, while no handle or field has the keyboard"),
            (translate("Help", "Tab"),),
        ),
        (
            translate("Help", "Nudge the selected handle by 1 px, with Shift by 10 px"),
            (translate("Help", "Arrow keys"),),
        ),
        (
            translate("Help", "Change a number faster or slower"),
            (translate("Help", "Shift + drag"), translate("Help", "Ctrl + drag")),
        ),
        (translate("Help", "Calculate in a number field"), ("*2", "/3", "+10", "-=10", "50%")),
    )
