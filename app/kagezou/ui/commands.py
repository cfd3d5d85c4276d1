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
        Command("save_increment", translate("Commands", "Save Ne&xt Version"), ("Ctrl+Alt+Shift+S",)),
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
        Command("ping_pong", translate("Commands", "Play There and &Back"), ("Shift+L",), "", checkable=True),
        Command("key_previous", translate("Commands", "Previous &Key"), ("J",), "key-previous"),
        Command("key_next", translate("Commands", "Next Ke&y"), ("K",), "key-next"),
    )


def key_commands() -> tuple[Command, ...]:
    """Return the commands about keys, work area and markers."""
    translate = QCoreApplication.translate
    return (
        Command("set_keys", translate("Commands", "Set &Keys Here"), ("F6",), "key"),
        Command("copy_keys", translate("Commands", "&Copy Keys"), ("Ctrl+C",)),
        Command("cut_keys", translate("Commands", "C&ut Keys"), ("Ctrl+X",)),
        Command("paste_keys", translate("Commands", "&Paste Keys"), ("Ctrl+V",)),
        Command("paste_in_place", translate("Commands", "Paste Keys at Their &Old Time"), ("Ctrl+Shift+V",)),
        Command("select_keys", translate("Commands", "Select &All Keys"), ("Ctrl+A",)),
        Command("keys_back", translate("Commands", "Move Keys 1 Frame &Back"), ("Alt+Left",)),
        Command("keys_on", translate("Commands", "Move Keys 1 Frame O&n"), ("Alt+Right",)),
        Command("keys_back_10", translate("Commands", "Move Keys 10 Frames Back"), ("Alt+Shift+Left",)),
        Command("keys_on_10", translate("Commands", "Move Keys 10 Frames On"), ("Alt+Shift+Right",)),
        Command("ease_both", translate("Commands", "&Easy Ease"), ("F9",)),
        Command("ease_in", translate("Commands", "Ease &In"), ("Shift+F9",)),
        Command("ease_out", translate("Commands", "Ease &Out"), ("Ctrl+Shift+F9",)),
        Command("hold", translate("Commands", "&Hold"), ("Ctrl+Alt+H",)),
        Command("linear", translate("Commands", "&Linear"), ("Ctrl+Alt+L",)),
        Command("work_in", translate("Commands", "Work Area &Begins Here"), ("B",)),
        Command("work_out", translate("Commands", "Work Area E&nds Here"), ("N",)),
        Command("work_clear", translate("Commands", "Clea&r Work Area"), ("Ctrl+Alt+B",)),
        Command("work_first", translate("Commands", "First Frame of the Work Area"), ("Shift+Home",)),
        Command("work_last", translate("Commands", "Last Frame of the Work Area"), ("Shift+End",)),
        Command("marker", translate("Commands", "Add or Name &Marker"), ("M",)),
    )


def timeline_commands() -> tuple[Command, ...]:
    """Return the commands about what the timeline shows."""
    translate = QCoreApplication.translate
    return (
        Command("timeline_fit", translate("Commands", "Fit the Cut in the &Timeline"), ("Shift+F",)),
        Command("timeline_in", translate("Commands", "Zoom &In on Time"), ("=", "Ctrl+Alt+Up")),
        Command("timeline_out", translate("Commands", "Zoom &Out of Time"), ("-", "Ctrl+Alt+Down")),
        Command("reveal_animated", translate("Commands", "Show Keyed Properties; Again: Cha&nged Ones"), ("U",)),
        Command("reveal_light", translate("Commands", "Show &Light"), ("P",)),
        Command("reveal_ground", translate("Commands", "Show &Ground"), ("G",)),
        Command("reveal_contacts", translate("Commands", "Show Grounding &Points"), ("C",)),
        Command("reveal_shape", translate("Commands", "Show &Shape"), ("S",)),
        Command("reveal_tilt", translate("Commands", "Show Body T&ilt"), ("R",)),
        Command("reveal_opacity", translate("Commands", "Show &Opacity and Fading"), ("T",)),
        Command("reveal_waves", translate("Commands", "Show &Waves"), ("W",)),
        Command("reveal_softness", translate("Commands", "Show So&ftness"), ("Y",)),
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
        groups = (file_commands, edit_commands, view_commands, playback_commands, key_commands, timeline_commands)
        self.commands = tuple(command for group in (*groups, help_commands) for command in group())
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
