"""Every command of the window in one table: its words, keys and icon; menus, search and shortcut sheet read it.

The keys are the skeleton that animators know from After Effects; the files in ``resources/shortcuts`` change them to
those of other programs. A command that nothing answers yet stays hidden, so it may stand here first.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import chain

from PySide6.QtCore import QCoreApplication

from kagezou.document.piece_kinds import BUILT_KINDS
from kagezou.ui.system.kind_words import KIND_WORDS


def translate(_context: str, text: str) -> str:
    """Mark a text for the translators and leave it English: a command is found by its English words in any language."""
    return text


@dataclass(frozen=True, slots=True)
class Command:
    """One command.

    Parameters
    ----------
    name
        How the program calls it.
    source
        Its English words, with the menu's mnemonic.
    keys
        Shortcuts; the first is shown in the menu. Nothing lies only on keys that some keyboards lack.
    icon
        The icon's name, empty for none.
    checkable
        Whether it is a switch.
    """

    name: str
    source: str
    keys: tuple[str, ...] = ()
    icon: str = ""
    checkable: bool = False

    @property
    def text(self) -> str:
        """What people read, in the language of the window, with the menu's mnemonic."""
        return QCoreApplication.translate("Commands", self.source)


@dataclass(frozen=True, slots=True)
class CommandGroup:
    """Commands under one heading, whose English words are ``source``."""

    source: str
    commands: tuple[Command, ...]

    @property
    def title(self) -> str:
        """The heading in the language of the window."""
        return QCoreApplication.translate("Commands", self.source)


def file_commands() -> tuple[Command, ...]:
    """Return the commands about files."""
    return (
        Command("new", translate("Commands", "&New from Cels…"), ("Ctrl+N",), "cels"),
        Command("open", translate("Commands", "&Open…"), ("Ctrl+O",), "folder"),
        Command("save", translate("Commands", "&Save"), ("Ctrl+S",), "save"),
        Command("save_as", translate("Commands", "Save &As…"), ("Ctrl+Shift+S",)),
        Command("save_increment", translate("Commands", "Save Ne&xt Version"), ("Ctrl+Alt+Shift+S",)),
        Command("import", translate("Commands", "A&dd Characters…"), ("Ctrl+I",), "add"),
        Command("import_pictures", translate("Commands", "Import &Pictures…"), ("Ctrl+Shift+I",)),
        Command("import_set", translate("Commands", "Import &3-D Set…")),
        Command("import_timesheet", translate("Commands", "Import &Timesheet…")),
        Command("export_timesheet", translate("Commands", "Export Times&heet…")),
        Command("background", translate("Commands", "Set &Background…")),
        Command("background_pictures", translate("Commands", "Set Background Sequence…")),
        Command("no_background", translate("Commands", "Remove Background")),
        Command("cut_settings", translate("Commands", "&Cut Settings…"), ("Ctrl+K",)),
        Command("export", translate("Commands", "&Export…"), ("Ctrl+M",), "export"),
        Command("export_notes", translate("Commands", "Export Notes…")),
        Command("quit", translate("Commands", "&Quit"), ("Ctrl+Q",)),
    )


def edit_commands() -> tuple[Command, ...]:
    """Return the commands about the document."""
    return (
        Command("undo", translate("Commands", "&Undo"), ("Ctrl+Z",), "undo"),
        Command("redo", translate("Commands", "&Redo"), ("Ctrl+Shift+Z", "Ctrl+Y"), "redo"),
        Command("delete", translate("Commands", "&Delete"), ("Del", "Backspace")),
        Command("copy_look", translate("Commands", "&Copy Look"), ("Ctrl+Alt+C",)),
        Command("paste_look", translate("Commands", "&Paste Look"), ("Ctrl+Alt+V",)),
        Command("take_from", translate("Commands", "&Take From Project…")),
        Command("rename_layer", translate("Commands", "Re&name Layer"), ("F2",)),
        Command("transform_cel", translate("Commands", "&Transform Cel"), ("Ctrl+T",), checkable=True),
        Command("find_feet", translate("Commands", "Find &Feet")),
        Command("doubtful_next", translate("Commands", "Next Dou&btful Drawing"), ("Ctrl+Alt+.",)),
        Command("doubtful_previous", translate("Commands", "Previous Doubtful Drawing"), ("Ctrl+Alt+,",)),
        Command("preferences", translate("Commands", "Pre&ferences…"), ("Ctrl+Alt+Shift+P",)),
        Command("edit_shortcuts", translate("Commands", "Edit &Keyboard Shortcuts…"), ("Ctrl+Alt+Shift+K",)),
    )


def layer_commands() -> tuple[Command, ...]:
    """Return the commands about layers."""
    return (
        Command("layer_replace", translate("Commands", "Re&place Drawings…")),
        Command("layer_relink", translate("Commands", "&Relink Missing Drawings…")),
        Command("layer_folder", translate("Commands", "Show Drawings in &Folder")),
        Command("layer_duplicate", translate("Commands", "&Duplicate Layer")),
        Command("layer_lock", translate("Commands", "&Lock Layer"), ("Ctrl+L",), checkable=True),
        Command("layer_solo", translate("Commands", "&Solo Layer"), ("Ctrl+Alt+S",), checkable=True),
    )


def key_commands() -> tuple[Command, ...]:
    """Return the commands about keys and their eases."""
    return (
        Command("set_keys", translate("Commands", "Set &Keys Here"), ("F6",), "key"),
        Command("copy_keys", translate("Commands", "&Copy Keys"), ("Ctrl+C",)),
        Command("cut_keys", translate("Commands", "C&ut Keys"), ("Ctrl+X",)),
        Command("paste_keys", translate("Commands", "&Paste Keys"), ("Ctrl+V",)),
        Command("paste_in_place", translate("Commands", "Paste Keys at Their Old Ti&me"), ("Ctrl+Shift+V",)),
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
        Command("velocity", translate("Commands", "Key &Velocity…"), ("Ctrl+Shift+K",)),
    )


def drawing_commands() -> tuple[Command, ...]:
    """Return the commands about when drawings are exposed."""
    return (
        Command("drawing_split", translate("Commands", "&Split Drawing Here"), ("Ctrl+Shift+D",)),
        Command("drawing_empty", translate("Commands", "&Empty Cel"), ("Shift+X",)),
        Command("drawing_remove", translate("Commands", "&Remove, Hold the Drawing Before")),
        Command("drawing_longer", translate("Commands", "Hold 1 Frame &Longer"), ("Ctrl+Alt+Right",)),
        Command("drawing_shorter", translate("Commands", "Hold 1 Frame S&horter"), ("Ctrl+Alt+Left",)),
        Command("on_ones", translate("Commands", "Expose on &Ones")),
        Command("on_twos", translate("Commands", "Expose on &Twos")),
        Command("on_threes", translate("Commands", "E&xpose on Threes")),
        Command("on_fours", translate("Commands", "Expose on &Fours")),
        Command("drawing_copy", translate("Commands", "&Copy Drawings"), ("Ctrl+Shift+C",)),
        Command("drawing_paste", translate("Commands", "&Paste Drawings")),
    )


def view_commands() -> tuple[Command, ...]:
    """Return the commands about looking."""
    return (
        Command("fit", translate("Commands", "&Fit in Window"), ("F", "Shift+/", "?", "Ctrl+0"), "fit"),
        Command("actual", translate("Commands", "&Actual Pixels (100 %)"), ("/", "Ctrl+Alt+0"), "actual"),
        Command("zoom_in", translate("Commands", "Zoom &In"), ("Ctrl++", "Ctrl+=")),
        Command("zoom_out", translate("Commands", "Zoom &Out"), ("Ctrl+-",)),
        Command("view_composite", translate("Commands", "View &Composite"), ("Alt+1",), checkable=True),
        Command("view_shadow", translate("Commands", "View Shadow &Only"), ("Alt+2",), checkable=True),
        Command("view_outline", translate("Commands", "View O&utline"), ("Alt+3",), checkable=True),
        Command("view_matte", translate("Commands", "View &Matte"), ("Alt+4",), checkable=True),
        Command("handles", translate("Commands", "&Handles"), ("Ctrl+Shift+H",), "handles", checkable=True),
        Command("settle_set", translate("Commands", "Camera and Size of the 3-D Set")),
        Command("match_camera", translate("Commands", "Match Ca&mera to Picture"), ("Ctrl+Alt+M",), checkable=True),
        Command("review", translate("Commands", "Review"), ("Ctrl+Alt+Shift+R",), checkable=True),
        Command("look_only", translate("Commands", "Look Onl&y"), ("Ctrl+Alt+Shift+L",), checkable=True),
        Command("onion_skin", translate("Commands", "O&nion Skin"), ("Alt+O",), checkable=True),
        Command("safe_area", translate("Commands", "&Safe Area"), ("'", "Ctrl+Alt+Shift+G"), checkable=True),
        Command("field_guide", translate("Commands", "Field &Guide"), ("Ctrl+'", "Ctrl+Shift+G"), checkable=True),
        Command("snapshot_take", translate("Commands", "Tak&e Snapshot"), ("Shift+F5",)),
        Command("snapshot_show", translate("Commands", "Sho&w Snapshot"), ("F5",), checkable=True),
        Command("snapshot_wipe", translate("Commands", "Wipe Snapshot"), ("Ctrl+F5",), checkable=True),
    )


def window_commands() -> tuple[Command, ...]:
    """Return the commands about the window and its panels."""
    return (
        Command("timeline", translate("Commands", "Show &Timeline"), ("Ctrl+Shift+T",)),
        Command("curves", translate("Commands", "Show &Curve Editor"), ("Shift+F3", "Alt+F")),
        Command("hide_docks", translate("Commands", "&Hide Panels"), ("Ctrl+Tab",), checkable=True),
        Command(
            "fill_window",
            translate("Commands", "What Is under the Pointer &Fills the Window; Again: Back"),
            ("`", "Ctrl+Alt+F"),
        ),
        Command("reset_layout", translate("Commands", "&Reset Layout")),
        Command("full_screen", translate("Commands", "F&ull Screen"), ("F11",), checkable=True),
    )


def playback_commands() -> tuple[Command, ...]:
    """Return the commands about time; the space bar itself is watched elsewhere, for it also pans."""
    return (
        Command("play", translate("Commands", "&Play / Stop"), ("Num+0",), "play"),
        Command("loop", translate("Commands", "&Loop"), ("L",), "loop", checkable=True),
        Command("ping_pong", translate("Commands", "Play &There and Back"), ("Shift+L",), "", checkable=True),
        Command("every_frame", translate("Commands", "Play &Every Frame"), (), "", checkable=True),
        Command("first", translate("Commands", "&First Frame"), ("Home",), "first"),
        Command("back_10", translate("Commands", "10 Frames Back"), ("Shift+PgUp", "Ctrl+Shift+Left")),
        Command("back", translate("Commands", "P&revious Frame"), ("PgUp", ",", "Ctrl+Left"), "step-back"),
        Command("forward", translate("Commands", "&Next Frame"), ("PgDown", ".", "Ctrl+Right"), "step-forward"),
        Command("forward_10", translate("Commands", "10 Frames On"), ("Shift+PgDown", "Ctrl+Shift+Right")),
        Command("last", translate("Commands", "La&st Frame"), ("End",), "last"),
        Command("go_to_frame", translate("Commands", "&Go to Frame…"), ("Ctrl+G", "Alt+Shift+J")),
        Command("key_previous", translate("Commands", "Previous &Key"), ("J",), "key-previous"),
        Command("key_next", translate("Commands", "Next Ke&y"), ("K",), "key-next"),
        Command("drawing_previous", translate("Commands", "Previous &Drawing"), ("Ctrl+,",)),
        Command("drawing_next", translate("Commands", "Next Dra&wing"), ("Ctrl+.",)),
        Command("work_in", translate("Commands", "Work Area &Begins Here"), ("B",)),
        Command("work_out", translate("Commands", "Work Are&a Ends Here"), ("N",)),
        Command("read_ahead", translate("Commands", "Read the Work Area &into Memory")),
        Command("work_clear", translate("Commands", "&Clear Work Area"), ("Ctrl+Alt+B",)),
        Command("work_first", translate("Commands", "First Frame of the Work Area"), ("Shift+Home",)),
        Command("work_last", translate("Commands", "Last Frame of the Work Area"), ("Shift+End",)),
        Command("marker", translate("Commands", "Add or Name &Marker"), ("M", "Num+*")),
        Command("remark_previous", translate("Commands", "Previous Note or Flag"), ("Alt+Shift+PgUp",)),
        Command("remark_next", translate("Commands", "Next Note or Flag"), ("Alt+Shift+PgDown",)),
        Command("remark_tick", translate("Commands", "Tick Note Off"), ("Ctrl+Alt+Return",)),
        Command("marker_previous", translate("Commands", "Previous Marker"), ("Alt+PgUp",)),
        Command("marker_next", translate("Commands", "Next Marker"), ("Alt+PgDown",)),
    )


def timeline_commands() -> tuple[Command, ...]:
    """Return the commands about what the timeline shows."""
    return (
        Command("timeline_fit", translate("Commands", "Fit the Cut in the &Timeline"), ("Shift+F",)),
        Command("timeline_in", translate("Commands", "Zoom &In on Time"), ("=", "Ctrl+Alt+Up")),
        Command("timeline_out", translate("Commands", "Zoom &Out of Time"), ("-", "Ctrl+Alt+Down")),
        Command("reveal_animated", translate("Commands", "Show Keyed Properties; Again: Cha&nged Ones"), ("U",)),
        Command("reveal_light", translate("Commands", "Show &Light"), ("P", "Shift+P")),
        Command("reveal_ground", translate("Commands", "Show &Ground"), ("G", "Shift+G")),
        Command("reveal_contacts", translate("Commands", "Show Grounding &Points"), ("C", "Shift+C")),
        Command("reveal_shape", translate("Commands", "Show &Shape"), ("S", "Shift+S")),
        Command("reveal_tilt", translate("Commands", "Show &Body Tilt"), ("R", "Shift+R")),
        Command("reveal_opacity", translate("Commands", "Show Op&acity and Fading"), ("T", "Shift+T")),
        Command("reveal_waves", translate("Commands", "Show &Waves"), ("W", "Shift+W")),
        Command("reveal_softness", translate("Commands", "Show So&ftness"), ("Y", "Shift+Y")),
    )


def set_commands() -> tuple[Command, ...]:
    """Return the commands about the set."""
    return (
        *(Command(f"add_{kind}", KIND_WORDS[kind].command, (), KIND_WORDS[kind].icon) for kind in BUILT_KINDS),
        Command("draw_corner", translate("Commands", "Draw &Ground and Wall Line"), (), "corner"),
        Command("draw_wall", translate("Commands", "Draw Wall &Line"), (), ""),
        Command("duplicate_piece", translate("Commands", "&Duplicate Set Piece"), ("Ctrl+D",), "duplicate"),
        Command("rename_piece", translate("Commands", "Re&name Set Piece")),
        Command("remove_piece", translate("Commands", "Re&move Set Piece"), (), "remove"),
    )


def help_commands() -> tuple[Command, ...]:
    """Return the commands that explain."""
    return (
        Command("manual", translate("Commands", "&Manual"), ("F1",)),
        Command("first_cut", translate("Commands", "&Guided First Cut")),
        Command("command_search", translate("Commands", "&Find Command…"), ("Ctrl+Shift+P",)),
        Command("shortcuts", translate("Commands", "&Keyboard Shortcuts"), ("Shift+F1", "Ctrl+/")),
        Command("support_report", translate("Commands", "Copy &Support Report")),
        Command("missing_parts", translate("Commands", "Missing Parts…")),
        Command("about", translate("Commands", "&About Kagezou")),
    )


def command_groups() -> tuple[CommandGroup, ...]:
    """Return the whole table."""
    return (
        CommandGroup(translate("Commands", "File"), file_commands()),
        CommandGroup(translate("Commands", "Edit"), edit_commands()),
        CommandGroup(translate("Commands", "Layer"), layer_commands()),
        CommandGroup(translate("Commands", "Keys"), key_commands()),
        CommandGroup(translate("Commands", "Drawings"), drawing_commands()),
        CommandGroup(translate("Commands", "Time"), playback_commands()),
        CommandGroup(translate("Commands", "View"), view_commands()),
        CommandGroup(translate("Commands", "Timeline"), timeline_commands()),
        CommandGroup(translate("Commands", "Set"), set_commands()),
        CommandGroup(translate("Commands", "Window"), window_commands()),
        CommandGroup(translate("Commands", "Help"), help_commands()),
    )


def all_commands(groups: Iterable[CommandGroup]) -> tuple[Command, ...]:
    """Return the commands of some groups, one after the other."""
    return tuple(chain.from_iterable(group.commands for group in groups))
