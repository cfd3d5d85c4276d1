"""Choosing the keys of every command: a set as of another program, and changes of one's own on top of it."""

from collections.abc import Callable, Sequence
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QLineEdit,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from kagezou.document.local_name import LocalName
from kagezou.errors import Problem
from kagezou.io.clips.shortcut_files import SUFFIX, KeySet, load_key_set, save_key_set
from kagezou.ui.commands.actions import Actions, shown_keys
from kagezou.ui.commands.fuzzy import score
from kagezou.ui.commands.shortcut_keys import KeysOfCommand
from kagezou.ui.commands.shortcut_scheme import Shortcuts, normal
from kagezou.ui.commands.table import Command
from kagezou.ui.system.language import in_all_languages
from kagezou.ui.system.menu_words import plain
from kagezou.ui.system.words import named, translated

_NAME = Qt.ItemDataRole.UserRole


class ShortcutEditor(QDialog):
    """The dialog; nothing changes in the window before it is accepted.

    Parameters
    ----------
    parent
        The window.
    actions
        The commands.
    sets
        The sets there are.
    shortcuts
        The shortcuts now.
    """

    def __init__(self, parent: QWidget, actions: Actions, sets: Sequence[KeySet], shortcuts: Shortcuts) -> None:
        super().__init__(parent)
        self.shortcuts = shortcuts
        self._sets = tuple(sets)
        self._items: dict[str, QTreeWidgetItem] = {}
        self._headings: list[tuple[QTreeWidgetItem, list[QTreeWidgetItem]]] = []
        self.setWindowTitle(self.tr("Edit Keyboard Shortcuts"))
        self.sets = QComboBox()
        self.sets.setAccessibleName(self.tr("Set"))
        for each in sets:
            name = named(each.name)
            self.sets.addItem(self.tr("%1 (studio)").replace("%1", name) if each.is_studio else name)
        self.field = QLineEdit()
        self.field.setPlaceholderText(self.tr("Search by name or keys"))
        self.field.setAccessibleName(self.tr("Search by name or keys"))
        self.field.setClearButtonEnabled(True)
        self.tree = self._made_tree(actions)
        self.keys = KeysOfCommand()
        self.note = QLabel()
        self.note.setWordWrap(True)
        self.note.hide()
        self._lay_out()
        self.sets.setCurrentIndex([each.code for each in sets].index(shortcuts.key_set.code))
        self.sets.currentIndexChanged.connect(self._choose_set)
        self.field.textChanged.connect(self._show_fitting)
        self.tree.currentItemChanged.connect(lambda *_: self._show_current())
        self.tree.itemActivated.connect(lambda *_: self.keys.field.setFocus())
        self.keys.given.connect(lambda key: self._change(lambda name: self.shortcuts.given(name, key)))
        self.keys.taken.connect(lambda key: self._change(lambda name: self.shortcuts.taken(name, key)))
        self.keys.reset_asked.connect(lambda: self._change(self.shortcuts.reset))
        self._show()
        self.tree.setCurrentItem(next(iter(self._items.values())))
        self.resize(86 * self.fontMetrics().averageCharWidth(), 40 * self.fontMetrics().height())

    def choose(self, name: str) -> None:
        """Show the keys of a command."""
        self.tree.setCurrentItem(self._items[name])

    def import_from(self, path: Path) -> None:
        """Take the shortcuts of a file for one's own; what it says wrong is shown and changes nothing."""
        try:
            self.shortcuts = self.shortcuts.with_keys(load_key_set(path).keys)
        except Problem as problem:
            self._say(translated(problem))
        else:
            self._say(self.tr("Shortcuts of %1").replace("%1", path.name))
            self._show()

    def export_to(self, path: Path) -> None:
        """Write all shortcuts into a file."""
        whole = path if path.suffix else path.with_suffix(SUFFIX)
        try:
            save_key_set(whole, KeySet("", LocalName(whole.stem), self.shortcuts.keys))
        except Problem as problem:
            self._say(translated(problem))
        else:
            self._say(self.tr("Written to %1").replace("%1", whole.name))

    def reset_all(self) -> None:
        """Go back to the set as it comes."""
        self.shortcuts = self.shortcuts.with_keys(self.shortcuts.of_the_set)
        self._show()

    def _made_tree(self, actions: Actions) -> QTreeWidget:
        tree = QTreeWidget()
        tree.setObjectName("shortcut_tree")
        tree.setColumnCount(3)
        tree.setHeaderLabels([self.tr("Command"), self.tr("Keys"), ""])
        tree.setRootIsDecorated(False)
        tree.setUniformRowHeights(True)
        tree.setAllColumnsShowFocus(True)
        tree.setAccessibleName(self.tr("Commands"))
        for group in actions.groups:
            shown = [command for command in group.commands if actions.is_answered(command.name)]
            if shown:
                heading = QTreeWidgetItem(tree, [group.title])
                heading.setFlags(Qt.ItemFlag.ItemIsEnabled)
                heading.setFirstColumnSpanned(True)
                font = heading.font(0)
                font.setBold(True)
                heading.setFont(0, font)
                items = {command.name: _item(heading, command) for command in shown}
                self._items.update(items)
                self._headings.append((heading, list(items.values())))
        tree.expandAll()
        tree.setItemsExpandable(False)
        tree.header().setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        tree.header().setSectionResizeMode(1, QHeaderView.ResizeMode.ResizeToContents)
        tree.header().setSectionResizeMode(2, QHeaderView.ResizeMode.ResizeToContents)
        tree.header().setStretchLastSection(False)
        return tree

    def _lay_out(self) -> None:
        head = QHBoxLayout()
        head.setSpacing(8)
        head.addWidget(QLabel(self.tr("Keys as in")))
        head.addWidget(self.sets)
        head.addSpacing(12)
        head.addWidget(self.field, 1)
        buttons = QDialogButtonBox()
        roles = QDialogButtonBox.ButtonRole
        for words, role, do in (
            (self.tr("Import…"), roles.ResetRole, self._ask_import),
            (self.tr("Export…"), roles.ResetRole, self._ask_export),
            (self.tr("Reset All"), roles.ResetRole, self.reset_all),
            (self.tr("Cancel"), roles.RejectRole, self.reject),
            (self.tr("OK"), roles.AcceptRole, self.accept),
        ):
            button = buttons.addButton(words, role)
            button.setAutoDefault(False)
            button.clicked.connect(do)
        column = QVBoxLayout(self)
        column.setContentsMargins(18, 16, 18, 14)
        column.setSpacing(10)
        column.addLayout(head)
        for widget in (self.tree, self.keys, self.note, buttons):
            column.addWidget(widget, 1 if widget is self.tree else 0)

    def _choose_set(self, index: int) -> None:
        self.shortcuts = Shortcuts(self.shortcuts.table, self._sets[index], {})
        self._show()

    def _change(self, changed: Callable[[str], Shortcuts]) -> None:
        if name := self._current():
            self.shortcuts = changed(name)
            self._show()

    def _current(self) -> str:
        item = self.tree.currentItem()
        return str(item.data(0, _NAME) or "") if item else ""

    def _show(self) -> None:
        for name, item in self._items.items():
            item.setText(1, shown_keys(self.shortcuts.keys[name]))
            # A word, so that the change is not told by colour alone.
            item.setText(2, self.tr("changed") if self.shortcuts.is_own(name) else "")
        self._show_current()

    def _show_current(self) -> None:
        name = self._current()
        if not name:
            self.keys.show_command("", (), {}, is_own=False)
            return
        # A hidden command's keys are shown as belonging to nobody; the command gives them up.
        owners = {
            key: item.text(0)
            for other, item in self._items.items()
            for key in self.shortcuts.keys[other]
            if other != name
        }
        is_own = self.shortcuts.is_own(name)
        self.keys.show_command(self._items[name].text(0), self.shortcuts.keys[name], owners, is_own=is_own)

    def _show_fitting(self, typed: str) -> None:
        pressed = normal((typed.replace(" ", ""),)) if typed.strip() else ()
        for name, item in self._items.items():
            words = [item.text(0), *item.data(1, _NAME)]
            by_name = any(score(typed, each) is not None for each in words)
            item.setHidden(not by_name and not set(pressed) & set(self.shortcuts.keys[name]))
        for heading, items in self._headings:
            heading.setHidden(all(item.isHidden() for item in items))

    def _ask_import(self) -> None:
        title, files = self.tr("Import Shortcuts"), self.tr("Shortcuts")
        if chosen := QFileDialog.getOpenFileName(self, title, "", f"{files} (*{SUFFIX})")[0]:
            self.import_from(Path(chosen))

    def _ask_export(self) -> None:
        title, files = self.tr("Export Shortcuts"), self.tr("Shortcuts")
        if chosen := QFileDialog.getSaveFileName(self, title, f"kagezou{SUFFIX}", f"{files} (*{SUFFIX})")[0]:
            self.export_to(Path(chosen))

    def _say(self, sentence: str) -> None:
        self.note.setText(sentence)
        self.note.show()


def _item(heading: QTreeWidgetItem, command: Command) -> QTreeWidgetItem:
    item = QTreeWidgetItem(heading, [plain(command.text)])
    item.setData(0, _NAME, command.name)
    # Kept for the search: the command is found by its name in every language.
    item.setData(1, _NAME, [plain(name) for name in in_all_languages("Commands", command.source)])
    return item
