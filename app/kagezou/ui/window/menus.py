"""The menu bar and the tool bar, filled from the commands."""

from collections.abc import Callable, Iterable
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, QSize, Qt
from PySide6.QtGui import QAction, QActionGroup, QIcon
from PySide6.QtWidgets import QMainWindow, QMenu, QMenuBar, QSizePolicy, QToolBar, QToolButton, QWidget

from kagezou.document.piece_kinds import BUILT_KINDS
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.ui.commands.actions import Actions
from kagezou.ui.commands.table import timeline_commands
from kagezou.ui.system.icons import icon, icon_size
from kagezou.ui.system.language import languages
from kagezou.ui.system.menu_words import plain
from kagezou.ui.viewport.resolution import Resolution

_SEPARATOR = ""
_EDITING = (
    *("undo", "redo", _SEPARATOR, "copy_look", "paste_look", "take_from", _SEPARATOR),
    *("rename_layer", "delete", _SEPARATOR, "edit_shortcuts", "preferences"),
)
_ON_KEYS = (
    *("set_keys", _SEPARATOR, "copy_keys", "cut_keys", "paste_keys", "paste_in_place", "delete", _SEPARATOR),
    *("ease_both", "ease_in", "ease_out", "linear", "hold", "velocity"),
)
_ON_DRAWINGS = (
    *("drawing_split", "drawing_empty", "drawing_remove", _SEPARATOR, "drawing_longer", "drawing_shorter", _SEPARATOR),
    *("on_ones", "on_twos", "on_threes", "on_fours", _SEPARATOR, "drawing_copy", "drawing_paste"),
)
_ADD_TO_SET = tuple(f"add_{kind}" for kind in BUILT_KINDS)
_DRAW = ("draw_corner", "draw_wall", "import_set")
_ON_LAYERS = (
    *("layer_replace", "layer_relink", "layer_folder", _SEPARATOR),
    *("layer_duplicate", _SEPARATOR, "layer_lock", "layer_solo"),
)
_ON_HELP = (
    *("manual", "first_cut", _SEPARATOR, "command_search", "shortcuts", _SEPARATOR),
    *("missing_parts", "support_report", "about"),
)
_NUDGES = ("keys_back", "keys_on", "keys_back_10", "keys_on_10")


class Menus(QObject):
    """The menus of one window; what changes while it lives is kept here.

    Parameters
    ----------
    window
        Whose menus they are.
    actions
        The commands.
    """

    def __init__(self, window: QMainWindow, actions: Actions) -> None:
        super().__init__(window)
        self._window = window
        self._actions = actions
        self.recent = QMenu(self.tr("Open &Recent"), window)
        self.recent.setIcon(icon("folder"))
        self.view = QMenu(self.tr("&View"), window)
        self.panels = QMenu(self.tr("&Panels"), window)
        self.views = QMenu(self.tr("Loo&k At"), window)
        self.onion = QMenu(self.tr("Onion Skin &Drawings"), window)
        self.backdrops = QMenu(self.tr("&Backdrop"), window)
        self.resolutions = QMenu(self.tr("Preview &Resolution"), window)
        self.labels = QMenu(self.tr("La&bel"), window)
        self._build()

    def add_backdrops(self, current: Backdrop, choose: Callable[[Backdrop], None]) -> None:
        """Fill the choice of backdrops."""
        words = {
            Backdrop.BACKGROUND: self.tr("Background Picture"),
            Backdrop.CHECKER: self.tr("Checker"),
            Backdrop.GREY: self.tr("Middle Grey"),
            Backdrop.WHITE: self.tr("White"),
            Backdrop.BLACK: self.tr("Black"),
        }
        choices = [(words[backdrop], backdrop is current, partial(choose, backdrop)) for backdrop in words]
        _exclusive(self.backdrops, choices)

    def add_resolutions(self, current: Resolution, choose: Callable[[Resolution], None]) -> None:
        """Fill the choice of the preview's resolution."""
        words = {
            Resolution.AUTO: self.tr("Automatic: Lower While Dragging"),
            Resolution.FULL: self.tr("Full"),
            Resolution.HALF: self.tr("Half"),
            Resolution.QUARTER: self.tr("Quarter"),
        }
        choices = [(words[each], each is current, partial(choose, each)) for each in words]
        _exclusive(self.resolutions, choices)

    def add_onion_counts(self, most: int, current: int, choose: Callable[[int], None]) -> None:
        """Fill the choice of how many drawings the onion skin shows on each side."""
        choices = [(str(count), count == current, partial(choose, count)) for count in range(1, most + 1)]
        _exclusive(self.onion, choices)

    def add_languages(self, current: str, choose: Callable[[str], None]) -> None:
        """Fill the choice of languages; each is written in its own words."""
        menu = QMenu(self.tr("&Language"), self._window)
        known = {"": self.tr("System Default"), **languages()}
        choices = [(words, code == current, partial(choose, code)) for code, words in known.items()]
        _exclusive(menu, choices)
        self.view.addSeparator()
        self.view.addMenu(menu)

    def add_panel(self, show: QAction) -> None:
        """List a panel among those that can be shown and hidden."""
        self.panels.insertAction(self._actions["timeline"], show)

    def show_recent(self, projects: Iterable[Path], choose: Callable[[Path], None]) -> None:
        """List the projects of before."""
        self.recent.clear()
        for path in projects:
            action = self.recent.addAction(path.name, partial(choose, path))
            action.setToolTip(str(path))
        self.recent.setToolTipsVisible(True)
        self.recent.setEnabled(not self.recent.isEmpty())

    def show_steps(self, undo: str | None, redo: str | None) -> None:
        """Name what undo and redo would do."""
        for name, words, step in (("undo", self.tr("&Undo"), undo), ("redo", self.tr("&Redo"), redo)):
            action = self._actions[name]
            action.setEnabled(step is not None)
            action.setText(words if step is None else self.tr("%1 %2").replace("%1", words).replace("%2", step))
            self._actions.show_tool_tip(name)

    def fill_keys(self, menu: QMenu) -> None:
        """Fill a menu with what can be done to the selected keys."""
        self._fill(menu, _ON_KEYS)

    def fill_drawings(self, menu: QMenu) -> None:
        """Fill a menu with what can be done to the chosen drawings of the timeline."""
        self._fill(menu, _ON_DRAWINGS)

    def add_labels(self, choices: Iterable[tuple[str, QIcon, Callable[[], None]]]) -> None:
        """Fill the choice of a layer's colour; several layers may have several, so that none is ticked."""
        for words, picture, choose in choices:
            self.labels.addAction(picture, words, choose)

    def fill_layers(self, menu: QMenu) -> None:
        """Fill a menu with what can be done with the chosen layers."""
        self._fill(menu, _ON_LAYERS)
        menu.addMenu(self.labels)
        menu.addSeparator()

    def fill_set(self, menu: QMenu) -> None:
        """Fill a menu with the pieces that can be added to the set."""
        self._fill(menu, [*_ADD_TO_SET, _SEPARATOR, *_DRAW])

    def tool_bar(self) -> QToolBar:
        """Return the tool bar."""
        bar = QToolBar(self.tr("Tools"), self._window)
        bar.setObjectName("tools")
        bar.setMovable(False)
        bar.setIconSize(icon_size(bar.fontMetrics()))
        bar.setContextMenuPolicy(Qt.ContextMenuPolicy.PreventContextMenu)
        self._fill(bar, ["new", "open", "save", _SEPARATOR, "undo", "redo", _SEPARATOR, "import"])
        spring = QWidget()
        spring.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        bar.addWidget(spring)
        for name, menu in (("views", self.views), ("backdrop", self.backdrops)):
            bar.addWidget(_chooser(name, menu, bar.iconSize()))
        self._fill(bar, ["handles", _SEPARATOR, "fit", "actual", _SEPARATOR, "export"])
        return bar

    def _build(self) -> None:
        bar = self._window.menuBar()
        # Not &File: Alt+F shows the curves, as the graph of other programs.
        file = self._menu(bar, self.tr("F&ile"), ["new", "open"])
        file.addMenu(self.recent)
        self._fill(file, ["save", "save_as", "save_increment", _SEPARATOR, "import", "import_pictures"])
        self._fill(file, ["import_set", "import_timesheet", "background", "background_pictures"])
        self._fill(file, ["no_background", _SEPARATOR, "cut_settings", _SEPARATOR])
        self._fill(file, ["export", "export_timesheet", "export_notes", _SEPARATOR, "quit"])
        self._menu(bar, self.tr("&Edit"), _EDITING)
        self._menu(bar, self.tr("&Keys"), [*_ON_KEYS, _SEPARATOR, "select_keys", *_NUDGES])
        self._menu(bar, self.tr("&Drawings"), _ON_DRAWINGS)
        self._menu(
            bar,
            self.tr("Fi&gure"),
            ["transform_cel", _SEPARATOR, "find_feet", "doubtful_next", "doubtful_previous"],
        )
        self._menu(bar, self.tr("La&yer"), _ON_LAYERS).addMenu(self.labels)
        self._menu(
            bar,
            self.tr("&Set"),
            [*_ADD_TO_SET, _SEPARATOR, *_DRAW, _SEPARATOR, "rename_piece", "duplicate_piece", "remove_piece"],
        )
        bar.addMenu(self.view)
        self._build_view()
        time = self._menu(bar, self.tr("&Playback"), ["play", "loop", "ping_pong", "every_frame", _SEPARATOR])
        self._fill(time, ["first", "back_10", "back", "forward", "forward_10", "last", "go_to_frame", _SEPARATOR])
        self._fill(time, ["key_previous", "key_next", "drawing_previous", "drawing_next", _SEPARATOR])
        self._fill(time, ["work_in", "work_out", "work_first", "work_last", "work_clear", "read_ahead", _SEPARATOR])
        self._fill(time, ["marker", "marker_previous", "marker_next", _SEPARATOR])
        self._fill(time, ["remark_previous", "remark_next", "remark_tick"])
        self._menu(bar, self.tr("&Help"), _ON_HELP)

    def _build_view(self) -> None:
        self._fill(self.view, ["fit", "actual", "zoom_in", "zoom_out", _SEPARATOR])
        self._fill(self.views, ["view_composite", "view_shadow", "view_outline", "view_matte"])
        self.view.addMenu(self.views)
        self.view.addMenu(self.backdrops)
        self.view.addMenu(self.resolutions)
        self._fill(self.view, ["handles", "look_only", "review", "match_camera", "settle_set", "onion_skin"])
        self.view.addMenu(self.onion)
        self._fill(self.view, ["safe_area", "field_guide", _SEPARATOR, "snapshot_take", "snapshot_show"])
        self._fill(self.view, ["snapshot_wipe"])
        self.view.addSeparator()
        names = [command.name for command in timeline_commands()]
        self.view.addMenu(self._menu(None, self.tr("&Timeline Shows"), [*names[3:], _SEPARATOR, *names[:3]]))
        self.view.addMenu(self.panels)
        self._fill(
            self.panels, ["timeline", "curves", _SEPARATOR, "hide_docks", "fill_window", "full_screen", "reset_layout"]
        )

    def _menu(self, bar: QMenuBar | None, title: str, names: Iterable[str]) -> QMenu:
        menu = QMenu(title, self._window)
        self._fill(menu, names)
        if bar is not None:
            bar.addMenu(menu)

        def follow() -> None:
            menu.menuAction().setVisible(any(each.isVisible() for each in menu.actions() if not each.isSeparator()))

        for action in menu.actions():
            action.visibleChanged.connect(follow)
        follow()
        return menu

    def _fill(self, place: QMenu | QToolBar, names: Iterable[str]) -> None:
        for name in names:
            if name == _SEPARATOR:
                place.addSeparator()
            else:
                place.addAction(self._actions[name])


def _exclusive(menu: QMenu, choices: Iterable[tuple[str, bool, Callable[[], None]]]) -> None:
    """Fill a menu with choices of which one is ticked."""
    group = QActionGroup(menu)
    for words, is_current, choose in choices:
        action = QAction(words, menu)
        action.setCheckable(True)
        action.setChecked(is_current)
        action.triggered.connect(lambda _checked, do=choose: do())
        group.addAction(action)
        menu.addAction(action)


def _chooser(name: str, menu: QMenu, size: QSize) -> QToolButton:
    """Return a button of the tool bar that opens a menu of choices."""
    button = QToolButton()
    button.setIcon(icon(name))
    button.setIconSize(size)
    button.setMenu(menu)
    button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
    button.setToolTip(plain(menu.title()))
    button.setAccessibleName(plain(menu.title()))
    return button
