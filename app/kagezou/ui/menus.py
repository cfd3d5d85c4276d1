"""The menu bar and the tool bar, filled from the commands."""

from collections.abc import Callable, Iterable
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QAction, QActionGroup
from PySide6.QtWidgets import QMainWindow, QMenu, QSizePolicy, QToolBar, QToolButton, QWidget

from kagezou.render.backdrop import Backdrop
from kagezou.ui.commands import Actions, plain
from kagezou.ui.icons import icon, icon_size
from kagezou.ui.language import LANGUAGES

_SEPARATOR = ""


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
        self.backdrops = QMenu(self.tr("&Backdrop"), window)
        self._build()

    def add_backdrops(self, current: Backdrop, choose: Callable[[Backdrop], None]) -> None:
        """Fill the choice of backdrops."""
        words = {
            Backdrop.BACKGROUND: self.tr("Background Picture"),
            Backdrop.CHECKER: self.tr("Checker"),
            Backdrop.GREY: self.tr("Middle Grey"),
            Backdrop.WHITE: self.tr("White"),
        }
        choices = [(words[backdrop], backdrop is current, partial(choose, backdrop)) for backdrop in words]
        self._exclusive(self.backdrops, choices)

    def add_languages(self, current: str, choose: Callable[[str], None]) -> None:
        """Fill the choice of languages; each is written in its own words."""
        menu = QMenu(self.tr("&Language"), self._window)
        known = {"": self.tr("System Default"), **LANGUAGES}
        choices = [(words, code == current, partial(choose, code)) for code, words in known.items()]
        self._exclusive(menu, choices)
        self.view.addSeparator()
        self.view.addMenu(menu)

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
            action.setToolTip(f"{plain(action.text())}  ({action.shortcut().toString()})")

    def fill_keys(self, menu: QMenu) -> None:
        """Fill a menu with what can be done to the selected keys."""
        self._fill(menu, ["set_keys", _SEPARATOR, "copy_keys", "cut_keys", "paste_keys", "paste_in_place", "delete"])
        self._fill(menu, [_SEPARATOR, "ease_both", "ease_in", "ease_out", "linear", "hold"])

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
        backdrop = QToolButton()
        backdrop.setIcon(icon("backdrop"))
        backdrop.setIconSize(bar.iconSize())
        backdrop.setMenu(self.backdrops)
        backdrop.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        backdrop.setToolTip(self.tr("Backdrop"))
        backdrop.setAccessibleName(self.tr("Backdrop"))
        bar.addWidget(backdrop)
        self._fill(bar, ["handles", _SEPARATOR, "fit", "actual", _SEPARATOR, "export"])
        return bar

    def _build(self) -> None:
        bar = self._window.menuBar()
        file = bar.addMenu(self.tr("&File"))
        self._fill(file, ["new", "open"])
        file.addMenu(self.recent)
        self._fill(
            file,
            [
                "save",
                "save_as",
                "save_increment",
                _SEPARATOR,
                "import",
                "import_pictures",
                "background",
                "no_background",
            ],
        )
        self._fill(file, [_SEPARATOR, "export", _SEPARATOR, "quit"])
        edit = bar.addMenu(self.tr("&Edit"))
        self._fill(edit, ["undo", "redo", _SEPARATOR, "rename_layer", "delete"])
        keys = bar.addMenu(self.tr("&Keys"))
        self.fill_keys(keys)
        self._fill(keys, [_SEPARATOR, "select_keys", "keys_back", "keys_on", "keys_back_10", "keys_on_10"])
        bar.addMenu(self.view)
        self._fill(self.view, ["fit", "actual", "zoom_in", "zoom_out", _SEPARATOR])
        self.view.addMenu(self.backdrops)
        self._fill(self.view, ["handles", _SEPARATOR])
        reveal = self.view.addMenu(self.tr("&Timeline Shows"))
        self._fill(reveal, [command.name for command in self._actions.commands if command.name.startswith("reveal")])
        self._fill(reveal, [_SEPARATOR, "timeline_fit", "timeline_in", "timeline_out"])
        self.view.addSeparator()
        playback = bar.addMenu(self.tr("&Playback"))
        self._fill(playback, ["play", "loop", "ping_pong", "every_frame", _SEPARATOR, "first", "back_10", "back"])
        self._fill(playback, ["forward", "forward_10", "last", _SEPARATOR, "key_previous", "key_next", _SEPARATOR])
        self._fill(playback, ["work_in", "work_out", "work_clear", "work_first", "work_last", _SEPARATOR, "marker"])
        help_menu = bar.addMenu(self.tr("&Help"))
        self._fill(help_menu, ["shortcuts", _SEPARATOR, "about"])

    def _fill(self, place: QMenu | QToolBar, names: Iterable[str]) -> None:
        for name in names:
            if name == _SEPARATOR:
                place.addSeparator()
            else:
                place.addAction(self._actions[name])

    def _exclusive(self, menu: QMenu, choices: Iterable[tuple[str, bool, Callable[[], None]]]) -> None:
        group = QActionGroup(menu)
        for words, is_current, choose in choices:
            action = QAction(words, menu)
            action.setCheckable(True)
            action.setChecked(is_current)
            action.triggered.connect(lambda _checked, do=choose: do())
            group.addAction(action)
            menu.addAction(action)
