"""The commands as Qt's actions of one window: who answers each, and on which keys it lies now."""

from collections.abc import Callable, Mapping
from types import MappingProxyType

from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QApplication, QWidget

from kagezou.ui.commands.table import Command, all_commands, command_groups
from kagezou.ui.system.icons import icon
from kagezou.ui.system.menu_words import plain

Answer = Callable[[], object]

_ROLES: Mapping[str, QAction.MenuRole] = MappingProxyType({
    "quit": QAction.MenuRole.QuitRole,
    "about": QAction.MenuRole.AboutRole,
    "preferences": QAction.MenuRole.PreferencesRole,
})  # fmt: skip
"""What macOS puts into the program's own menu."""


class Actions:
    """The actions of one window; one that nobody answers is hidden, and its keys do nothing.

    Parameters
    ----------
    owner
        The window whose shortcuts they are.
    """

    def __init__(self, owner: QWidget) -> None:
        self.groups = command_groups()
        self.commands = all_commands(self.groups)
        self._answers: dict[str, list[tuple[QWidget | None, Answer]]] = {}
        self._actions = {command.name: _action(command, owner) for command in self.commands}
        self._guards: dict[str, tuple[Callable[[], bool], Answer]] = {}
        self._keys: dict[str, tuple[str, ...]] = {}
        self.set_keys({command.name: command.keys for command in self.commands})

    def __getitem__(self, name: str) -> QAction:
        return self._actions[name]

    def on(self, name: str, do: Answer, *, within: QWidget | None = None) -> None:
        """Say what a command does, everywhere or only while the keyboard is within a widget.

        So "fit" may fit the curves while they have the keyboard, and the picture at any other time.
        """
        if name not in self._answers:
            self._answers[name] = []
            self._actions[name].triggered.connect(lambda _checked: self._answer(name))
        # The widget that answers only for itself is asked before the one that answers for all.
        self._answers[name].insert(0 if within else len(self._answers[name]), (within, do))
        self._actions[name].setVisible(True)

    def on_toggled(self, name: str, do: Callable[[bool], object]) -> None:
        """Say what a switch does when it is turned on or off."""
        self._actions[name].toggled.connect(do)
        self._actions[name].setVisible(True)

    def guard(self, name: str, may: Callable[[], bool], refuse: Answer) -> None:
        """Say when a command may be done, and what is done instead when it may not."""
        self._guards[name] = (may, refuse)

    def is_answered(self, name: str) -> bool:
        """Whether someone said what the command does."""
        return self._actions[name].isVisible()

    def keys(self, name: str) -> tuple[str, ...]:
        """Return the keys a command lies on now."""
        return self._keys[name]

    def set_keys(self, keys: Mapping[str, tuple[str, ...]]) -> None:
        """Put the commands on these keys; one that is not named gets none."""
        for name, action in self._actions.items():
            self._keys[name] = keys.get(name, ())
            action.setShortcuts([QKeySequence(each) for each in self._keys[name]])
            self.show_tool_tip(name)

    def show_tool_tip(self, name: str) -> None:
        """Say the command's words and its first key where the pointer rests on it."""
        action = self._actions[name]
        words, keys = plain(action.text()), shown_keys(self._keys[name][:1])
        action.setToolTip(f"{words}  ({keys})" if keys else words)

    def _answer(self, name: str) -> None:
        if name in self._guards:
            may, refuse = self._guards[name]
            if not may():
                refuse()
                return
        focused = QApplication.focusWidget()
        for within, do in self._answers[name]:
            if within is None or (focused is not None and (within is focused or within.isAncestorOf(focused))):
                do()
                return


def shown_keys(keys: tuple[str, ...]) -> str:
    """Return keys as this system writes them."""
    return "   ".join(QKeySequence(each).toString(QKeySequence.SequenceFormat.NativeText) for each in keys)


def _action(command: Command, owner: QWidget) -> QAction:
    action = QAction(command.text, owner)
    action.setObjectName(command.name)
    action.setCheckable(command.checkable)
    action.setVisible(False)
    # By name, not by words: macOS would take "Cut Settings…" for the preferences, and none of them in Japanese.
    action.setMenuRole(_ROLES.get(command.name, QAction.MenuRole.NoRole))
    if command.icon:
        action.setIcon(icon(command.icon))
        # A menu shows the tick of a switch in the icon's place.
        action.setIconVisibleInMenu(not command.checkable)
    owner.addAction(action)
    return action
