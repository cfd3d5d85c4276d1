"""Every command of the window in one list: its words, keys and icon; menus, tool bar and shortcut sheet read it."""

import re
from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QCoreApplication
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QWidget

from kagezou.ui.icons import icon


@dataclass(frozen=True, slots=True)
class Command:
    """One command.

    Parameters
    ----------
    name
        How the program calls it.
    text
        What people read, with the menu's mnemonic.
    keys
        Shortcuts; the first is shown in the menu. Nothing lies only on keys that some keyboards lack.
    icon
        The icon's name, empty for none.
    checkable
        Whether it is a switch.
    """

    name: str
    text: str
    keys: tuple[str, ...] = ()
    icon: str = ""
    checkable: bool = False


def file_commands() -> tuple[Command, ...]:
    """Return the commands about files."""
    translate = QCoreApplication.translate
    return (
        Command("new", translate("Commands", "&New from Cels…"), ("Ctrl+N",), "cels"),
        Command("open", translate("Commands", "&Open…"), ("Ctrl+O",), "folder"),
        Command("save", translate("Commands", "&Save"), ("Ctrl+S",), "save"),
        Command("save_as", translate("Commands", "Save &As…"), ("Ctrl+Shift+S",)),
        Command("import", translate("Commands", "&Import Character…"), ("Ctrl+I",), "add"),
        Command("import_pictures", translate("Commands", "Import &Pictures…"), ("Ctrl+Shift+I",)),
        Command("background", translate("Commands", "Set &Background…")),
        Command("no_background", translate("Commands", "Remove Background")),
        Command("export", translate("Commands", "&Export Shadow Layers…"), ("Ctrl+M",), "export"),
        Command("quit", translate("Commands", "&Quit"), ("Ctrl+Q",)),
    )


def edit_commands() -> tuple[Command, ...]:
    """Return the commands about the document."""
    translate = QCoreApplication.translate
    return (
        Command("undo", translate("Commands", "&Undo"), ("Ctrl+Z",), "undo"),
        Command("redo", translate("Commands", "&Redo"), ("Ctrl+Shift+Z", "Ctrl+Y"), "redo"),
        Command("delete", translate("Commands", "&Delete"), ("Del", "Backspace")),
        Command("rename_layer", translate("Commands", "Re&name Layer")),
    )


def view_commands() -> tuple[Command, ...]:
    """Return the commands about looking."""
    translate = QCoreApplication.translate
    return (
        Command("fit", translate("Commands", "&Fit in Window"), ("F", "Shift+/", "?", "Ctrl+0"), "fit"),
        Command("actual", translate("Commands", "&Actual Pixels (100 %)"), ("/", "Ctrl+Alt+0"), "actual"),
        Command("zoom_in", translate("Commands", "Zoom &In"), ("Ctrl++", "Ctrl+=")),
        Command("zoom_out", translate("Commands", "Zoom &Out"), ("Ctrl+-",)),
        Command("handles", translate("Commands", "&Handles"), ("Ctrl+Shift+H",), "handles", checkable=True),
    )


def playback_commands() -> tuple[Command, ...]:
    """Return the commands about time; the space bar itself is watched elsewhere, for it also pans."""
    translate = QCoreApplication.translate
    return (
        Command("play", translate("Commands", "&Play / Stop"), (), "play"),
        Command("loop", translate("Commands", "&Loop"), ("L",), "loop", checkable=True),
        Command("every_frame", translate("Commands", "Play &Every Frame"), (), "", checkable=True),
        Command("first", translate("Commands", "&First Frame"), ("Home",), "first"),
        Command("back_10", translate("Commands", "10 Frames Back"), ("Shift+PgUp", "Ctrl+Shift+Left")),
        Command("back", translate("Commands", "P&revious Frame"), ("PgUp", ",", "Ctrl+Left"), "step-back"),
        Command("forward", translate("Commands", "&Next Frame"), ("PgDown", ".", "Ctrl+Right"), "step-forward"),
        Command("forward_10", translate("Commands", "10 Frames On"), ("Shift+PgDown", "Ctrl+Shift+Right")),
        Command("last", translate("Commands", "La&st Frame"), ("End",), "last"),
        Command("key_previous", translate("Commands", "Previous &Key"), ("J",), "key-previous"),
        Command("key_next", translate("Commands", "Next Ke&y"), ("K",), "key-next"),
    )


def help_commands() -> tuple[Command, ...]:
    """Return the commands that explain."""
    translate = QCoreApplication.translate
    return (
        Command("shortcuts", translate("Commands", "&Keyboard Shortcuts"), ("F1",)),
        Command("about", translate("Commands", "&About Kagezou")),
    )


class Actions:
    """The commands as Qt's actions of one window.

    Parameters
    ----------
    owner
        The window whose shortcuts they are.
    """

    def __init__(self, owner: QWidget) -> None:
        groups = (file_commands(), edit_commands(), view_commands(), playback_commands(), help_commands())
        self.commands = tuple(command for group in groups for command in group)
        self._actions = {command.name: _action(command, owner) for command in self.commands}

    def __getitem__(self, name: str) -> QAction:
        return self._actions[name]

    def on(self, name: str, do: Callable[[], object]) -> None:
        """Say what a command does."""
        self._actions[name].triggered.connect(lambda _checked: do())


def plain(text: str) -> str:
    """Return a menu's words without mnemonic and dots; Japanese menus write the mnemonic behind them, as (&S)."""
    return re.sub(r"\s*\(&.\)", "", text).replace("&", "").replace("…", "")


def _action(command: Command, owner: QWidget) -> QAction:
    action = QAction(command.text, owner)
    action.setObjectName(command.name)
    action.setShortcuts([QKeySequence(keys) for keys in command.keys])
    action.setCheckable(command.checkable)
    if command.icon:
        action.setIcon(icon(command.icon))
        # A menu shows the tick of a switch in the icon's place.
        action.setIconVisibleInMenu(not command.checkable)
    words = plain(command.text)
    action.setToolTip(f"{words}  ({action.shortcut().toString()})" if command.keys else words)
    owner.addAction(action)
    return action
