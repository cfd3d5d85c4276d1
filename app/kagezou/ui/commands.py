"""Every command of the window in one list: its words, keys and icon; menus, tool bar and shortcut sheet read it."""

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
    tr = QCoreApplication.translate
    return (
        Command("new", tr("Commands", "&New from Cels…"), ("Ctrl+N",), "cels"),
        Command("open", tr("Commands", "&Open…"), ("Ctrl+O",), "folder"),
        Command("save", tr("Commands", "&Save"), ("Ctrl+S",), "save"),
        Command("save_as", tr("Commands", "Save &As…"), ("Ctrl+Shift+S",)),
        Command("import", tr("Commands", "&Import Character…"), ("Ctrl+I",), "add"),
        Command("import_pictures", tr("Commands", "Import &Pictures…"), ("Ctrl+Shift+I",)),
        Command("background", tr("Commands", "Set &Background…")),
        Command("no_background", tr("Commands", "Remove Background")),
        Command("export", tr("Commands", "&Export Shadow Layers…"), ("Ctrl+M",), "export"),
        Command("quit", tr("Commands", "&Quit"), ("Ctrl+Q",)),
    )


def edit_commands() -> tuple[Command, ...]:
    """Return the commands about the document."""
    tr = QCoreApplication.translate
    return (
        Command("undo", tr("Commands", "&Undo"), ("Ctrl+Z",), "undo"),
        Command("redo", tr("Commands", "&Redo"), ("Ctrl+Shift+Z", "Ctrl+Y"), "redo"),
        Command("delete", tr("Commands", "&Delete"), ("Del", "Backspace")),
        Command("rename_layer", tr("Commands", "Re&name Layer")),
    )


def view_commands() -> tuple[Command, ...]:
    """Return the commands about looking."""
    tr = QCoreApplication.translate
    return (
        Command("fit", tr("Commands", "&Fit in Window"), ("F", "Shift+/", "?", "Ctrl+0"), "fit"),
        Command("actual", tr("Commands", "&Actual Pixels (100 %)"), ("/", "Ctrl+Alt+0"), "actual"),
        Command("zoom_in", tr("Commands", "Zoom &In"), ("Ctrl++", "Ctrl+=")),
        Command("zoom_out", tr("Commands", "Zoom &Out"), ("Ctrl+-",)),
        Command("handles", tr("Commands", "&Handles"), ("Ctrl+Shift+H",), "handles", checkable=True),
    )


def playback_commands() -> tuple[Command, ...]:
    """Return the commands about time; the space bar itself is watched elsewhere, for it also pans."""
    tr = QCoreApplication.translate
    return (
        Command("play", tr("Commands", "&Play / Stop"), (), "play"),
        Command("loop", tr("Commands", "&Loop"), ("L",), "loop", checkable=True),
        Command("every_frame", tr("Commands", "Play &Every Frame"), (), "", checkable=True),
        Command("first", tr("Commands", "&First Frame"), ("Home",), "first"),
        Command("back_10", tr("Commands", "10 Frames Back"), ("Shift+PgUp", "Ctrl+Shift+Left")),
        Command("back", tr("Commands", "P&revious Frame"), ("PgUp", ",", "Ctrl+Left"), "step-back"),
        Command("forward", tr("Commands", "&Next Frame"), ("PgDown", ".", "Ctrl+Right"), "step-forward"),
        Command("forward_10", tr("Commands", "10 Frames On"), ("Shift+PgDown", "Ctrl+Shift+Right")),
        Command("last", tr("Commands", "La&st Frame"), ("End",), "last"),
        Command("key_previous", tr("Commands", "Previous &Key"), ("J",), "key-previous"),
        Command("key_next", tr("Commands", "Next Ke&y"), ("K",), "key-next"),
    )


def help_commands() -> tuple[Command, ...]:
    """Return the commands that explain."""
    tr = QCoreApplication.translate
    return (
        Command("shortcuts", tr("Commands", "&Keyboard Shortcuts"), ("F1",)),
        Command("about", tr("Commands", "&About Kagezou")),
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


def _action(command: Command, owner: QWidget) -> QAction:
    action = QAction(command.text, owner)
    action.setObjectName(command.name)
    action.setShortcuts([QKeySequence(keys) for keys in command.keys])
    action.setCheckable(command.checkable)
    if command.icon:
        action.setIcon(icon(command.icon))
    plain = command.text.replace("&", "").rstrip("…")
    action.setToolTip(f"{plain}  ({action.shortcut().toString()})" if command.keys else plain)
    owner.addAction(action)
    return action
