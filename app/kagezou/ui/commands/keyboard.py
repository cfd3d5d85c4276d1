"""The shortcuts in use: remembered between two runs, put on the actions, shown in a sheet and changed in a dialog."""

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QWidget

from kagezou.errors import ProjectProblem
from kagezou.io.clips.shortcut_files import key_sets_there, keys_from_text, text_of_keys
from kagezou.ui.commands.actions import Actions
from kagezou.ui.commands.shortcut_editor import ShortcutEditor
from kagezou.ui.commands.shortcut_scheme import Shortcuts, table_of
from kagezou.ui.commands.shortcut_sheet import ShortcutSheet
from kagezou.ui.system.settings import Settings
from kagezou.ui.system.words import named, translated
from kagezou.ui.widgets.message_bar import MessageBar, Severity

_SET, _OWN = "shortcut_set", "own_shortcuts"


class Keyboard(QObject):
    """Keeps the shortcuts of one window.

    Parameters
    ----------
    window
        The window the dialogs belong to.
    actions
        The commands.
    settings
        Where the choice is remembered.
    bar
        Where it is said when the remembered choice cannot be read.
    """

    def __init__(self, window: QWidget, actions: Actions, settings: Settings, bar: MessageBar) -> None:
        super().__init__(window)
        self._window = window
        self._actions = actions
        self._settings = settings
        self._sets, problems = key_sets_there()
        if problems:
            bar.say("studio shortcuts", "\n".join(map(translated, problems)), Severity.WARNING)
        self._sheet: ShortcutSheet | None = None
        self.shortcuts = self._remembered(bar)
        actions.set_keys(self.shortcuts.keys)

    def use(self, shortcuts: Shortcuts) -> None:
        """Put the commands on these keys, and remember them."""
        self.shortcuts = shortcuts
        self._settings.set_word(_SET, shortcuts.key_set.code)
        self._settings.set_word(_OWN, text_of_keys(shortcuts.own))
        self._actions.set_keys(shortcuts.keys)

    def show_sheet(self) -> ShortcutSheet:
        """Open the sheet, or close the one that is open; return the one opened last."""
        if self._sheet is not None:
            sheet, self._sheet = self._sheet, None
            sheet.close()
            return sheet
        self._sheet = ShortcutSheet(self._window, self._actions, named(self.shortcuts.key_set.name))
        self._sheet.edit_asked.connect(self.edit)
        self._sheet.finished.connect(self._forget_sheet)
        self._sheet.show()
        return self._sheet

    def edit(self) -> ShortcutEditor:
        """Open the dialog that changes them."""
        if self._sheet is not None:
            self._sheet.close()
        editor = ShortcutEditor(self._window, self._actions, self._sets, self.shortcuts)
        editor.accepted.connect(lambda: self.use(editor.shortcuts))
        editor.finished.connect(editor.deleteLater)
        editor.open()
        return editor

    def _forget_sheet(self) -> None:
        self._sheet = None

    def _remembered(self, bar: MessageBar) -> Shortcuts:
        table = table_of(self._actions.commands)
        code = self._settings.word(_SET, self._sets[0].code)
        chosen = next((each for each in self._sets if each.code == code), self._sets[0])
        try:
            own = keys_from_text(self._settings.word(_OWN, "{}"))
        except ProjectProblem:
            own = {}
            words = self.tr("Your own shortcuts could not be read; the set's are used.")
            bar.say("shortcuts", words, Severity.WARNING)
        return Shortcuts(table, chosen, own)
