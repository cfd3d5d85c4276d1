"""The main window: puts the parts together and connects them, and knows nothing else."""

from pathlib import Path

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QCloseEvent, QDragEnterEvent, QDragLeaveEvent, QDropEvent, QKeyEvent
from PySide6.QtWidgets import QMainWindow, QStackedWidget, QVBoxLayout, QWidget

from kagezou.ui.commands.actions import Actions
from kagezou.ui.commands.keyboard import Keyboard
from kagezou.ui.curves.panel import CurvesPanel
from kagezou.ui.export.progress import Exporting
from kagezou.ui.panels.inspector import Inspector
from kagezou.ui.panels.layer_list import LayerList
from kagezou.ui.panels.style_list import StyleList
from kagezou.ui.panels.thumbnails import Thumbnails
from kagezou.ui.project.actions import ProjectActions
from kagezou.ui.project.demo import DemoOpener, MakeDemo
from kagezou.ui.project.dialogs import Dialogs
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.project.welcome import Welcome
from kagezou.ui.sets.commands import SetCommands
from kagezou.ui.sets.import_bar import SetBar
from kagezou.ui.sets.imports import SetImports
from kagezou.ui.sets.list import LayersAndSet, SetList
from kagezou.ui.system.settings import Settings
from kagezou.ui.time.key_commands import KeyCommands
from kagezou.ui.time.playback import Player
from kagezou.ui.time.prefetch import Prefetch
from kagezou.ui.time.transport import Transport
from kagezou.ui.timeline.timeline import Timeline
from kagezou.ui.viewport.corner_sheet import CornerSheet
from kagezou.ui.viewport.onion_skin import OnionSkin
from kagezou.ui.viewport.sheets import Guides, Snapshot
from kagezou.ui.viewport.viewport import Viewport
from kagezou.ui.widgets.dock import Dock
from kagezou.ui.widgets.message_bar import MessageBar
from kagezou.ui.widgets.space_bar import SpaceBar
from kagezou.ui.window.bars import TopBars
from kagezou.ui.window.drop_hint import DropHint, drop_words
from kagezou.ui.window.menus import Menus
from kagezou.ui.window.panel_layout import PanelLayout
from kagezou.ui.window.status import Status
from kagezou.ui.window.wiring.match import connect_match
from kagezou.ui.window.wiring.project_and_frame import connect_frame, connect_messages, connect_project, connect_view
from kagezou.ui.window.wiring.set_import import connect_set_import
from kagezou.ui.window.wiring.sets import connect_set
from kagezou.ui.window.wiring.time import (
    connect_curves,
    connect_drawings,
    connect_jumps,
    connect_keys,
    connect_playback,
    connect_timeline,
)
from kagezou.ui.window.wiring.view import connect_resolution, connect_sheets, connect_views

_BUTTONS = ("first", "key_previous", "back", "play", "forward", "key_next", "last", None, "loop")

_DOCKS = 4
"""Counts up with every new dock: a layout remembered without it is not restored, as it would squeeze the dock in."""

_DOCK_LETTERS = 38
_LAYERS_SHARE = 36
_TIMELINE_SHARE = 27
"""Of 100 parts of the height."""


class MainWindow(QMainWindow):
    """One window over the open project; may be thrown away and made anew while the project stays.

    Parameters
    ----------
    open_project
        The project.
    settings
        What is remembered.
    make_demo
        Who makes the demo; without it none is offered.
    """

    language_chosen = Signal(str)
    guides: Guides
    snapshot: Snapshot
    onion_skin: OnionSkin

    def __init__(self, open_project: OpenProject, settings: Settings, make_demo: MakeDemo | None = None) -> None:
        super().__init__()
        self.open_project = open_project
        self.settings = settings
        self._may_close_unasked = False
        self._make_parts()
        self.demo = DemoOpener(make_demo, self.bar, self.project.open_recent) if make_demo else None
        self.welcome.offer_demo(offered=make_demo is not None)
        self._lay_out()
        connect_project(self)
        connect_set(self)
        connect_view(self)
        connect_views(self)
        connect_resolution(self)
        connect_sheets(self)
        connect_match(self)
        connect_set_import(self)
        connect_playback(self)
        connect_jumps(self)
        connect_keys(self)
        connect_drawings(self)
        connect_timeline(self)
        connect_curves(self)
        connect_messages(self)
        self.show_title()
        self.panel_layout = PanelLayout(self, _DOCKS, self._share_room)
        self._restore_layout()
        connect_frame(self)
        self.show_page()

    def show_title(self) -> None:
        """Show the project's name, and whether it is saved."""
        self.setWindowTitle(f"{self.project.project_name}[*] — Kagezou")
        self.setWindowModified(not self.open_project.is_saved)
        self.setWindowFilePath(str(self.open_project.path) if self.open_project.path else "")

    def show_page(self) -> None:
        """Show the picture, or where to begin while there is none."""
        blank = self.open_project.is_blank
        if blank:
            self.welcome.show_recent(self.settings.recent)
        # On the first page panels would only be empty.
        self.panel_layout.hide(blank, "blank")
        self.pages.setCurrentWidget(self.welcome if blank else self.viewport)
        self.transport.setVisible(not blank)
        self.inspector.setEnabled(not blank)
        self.styles.setEnabled(not blank)
        self.timeline.setEnabled(not blank)
        self.curves.setEnabled(not blank)
        for name in ("save_as", "export", "delete", "rename_layer", "play"):
            self.actions_of[name].setEnabled(not blank)
        self.actions_of["no_background"].setEnabled(self.open_project.bridge.document.background is not None)

    def show_handles(self) -> None:
        """Show the handles if they are wanted; while the cut runs they would only stand in the way of seeing it."""
        is_free = not self.player.is_playing and not self.corner_sheet.is_on
        shown = self.actions_of["handles"].isChecked() and is_free
        self.viewport.show_handles(shown=shown)

    def close_unasked(self) -> None:
        """Close without the question about unsaved work: the open project stays, only the window goes."""
        self._may_close_unasked = True
        self.close()

    def closeEvent(self, event: QCloseEvent) -> None:
        self.player.stop()
        self.viewport.hand.cancel()
        if not self._may_close_unasked and not self.project.may_leave():
            event.ignore()
            return
        self.project.loading.finish()
        self.exporting.finish()
        self.project.put_away()
        if self.demo is not None:
            self.demo.finish()
        self.viewport.finish()
        self.thumbnails.wait()
        self.styles.pictures.finish()
        self.welcome.pictures.finish()
        self.prefetch.finish()
        self.panel_layout.bring_back()
        self.settings.set_layout("geometry", self.saveGeometry())
        self.settings.set_layout("state", self.saveState(_DOCKS))
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if not self.space.press(event):
            super().keyPressEvent(event)

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        if not self.space.release(event):
            super().keyReleaseEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        if event.type() is QEvent.Type.ActivationChange and not self.isActiveWindow():
            self.space.forget()
        super().changeEvent(event)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if paths := _files(event):
            event.acceptProposedAction()
            self._show_drop(drop_words(paths))

    def dragLeaveEvent(self, event: QDragLeaveEvent) -> None:
        self._show_drop(None)

    def dropEvent(self, event: QDropEvent) -> None:
        self._show_drop(None)
        event.acceptProposedAction()
        self.project.bring(_files(event))

    def _show_drop(self, words: str | None) -> None:
        blank = self.open_project.is_blank
        self.welcome.show_hovered(words if blank else None)
        self.drop_hint.show_words(None if blank else words)

    def _make_parts(self) -> None:
        bridge = self.open_project.bridge
        self.actions_of = Actions(self)
        self.bar = MessageBar()
        self.player = Player(bridge)
        self.prefetch = Prefetch(bridge, self.player, self.open_project.cels)
        self.space = SpaceBar()
        self.thumbnails = Thumbnails()
        self.welcome = Welcome(self.settings.picture_folder)
        self.viewport = Viewport(bridge, self.open_project.cels, self.open_project.meshes, self.space)
        self.layers = LayerList(bridge, self.thumbnails)
        self.inspector = Inspector(bridge)
        self.styles = StyleList(bridge, self.settings.style_folder)
        self.transport = Transport(bridge, self.player, [self.actions_of[name] if name else None for name in _BUTTONS])
        self.timeline = Timeline(bridge, self.open_project.cels.kept_sources)
        self.keys = KeyCommands(bridge)
        self.exporting = Exporting(self.bar)
        self.status = Status(bridge, self.exporting)
        self.project = ProjectActions(self.open_project, Dialogs(self, self.settings), self.bar, self.settings)
        self.set_bar = SetBar()
        self.set_imports = SetImports(self.open_project, self.set_bar, self.viewport.picking)
        self.menus = Menus(self, self.actions_of)
        self.set_commands = SetCommands(bridge)
        self.corner_sheet = CornerSheet(self.viewport, bridge, self.space)
        self.set_list = SetList(bridge, self.set_commands, self.menus.fill_set)
        self.curves = CurvesPanel(bridge, self.menus.fill_keys)
        self.keyboard = Keyboard(self, self.actions_of, self.settings, self.bar)

    def _lay_out(self) -> None:
        self.pages = QStackedWidget()
        self.pages.addWidget(self.welcome)
        self.pages.addWidget(self.viewport)
        middle = QWidget()
        column = QVBoxLayout(middle)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.pages, 1)
        column.addWidget(self.transport)
        self.setCentralWidget(middle)
        self.top_bars = TopBars(self.pages, (self.bar, self.project.loading, self.set_bar))
        self.drop_hint = DropHint(middle)
        self.addToolBar(self.menus.tool_bar())
        self.setStatusBar(self.status)
        self.docks = (
            Dock("layers", self.tr("Layers"), LayersAndSet(self.layers, self.set_list)),
            Dock("inspector", self.tr("Inspector"), self.inspector),
            Dock("styles", self.tr("Styles"), self.styles),
            Dock("timeline", self.tr("Timeline"), self.timeline),
            Dock("curves", self.tr("Curves"), self.curves),
        )
        layers, _, styles, timeline, curves = self.docks
        areas = Qt.DockWidgetArea
        for dock in self.docks:
            below = dock in (timeline, curves)
            self.addDockWidget(areas.BottomDockWidgetArea if below else areas.RightDockWidgetArea, dock)
            self.menus.add_panel(dock.toggleViewAction())
        curves.visibilityChanged.connect(self.curves.come)
        styles.visibilityChanged.connect(self.styles.come)
        # The panels at the right reach down beside the timeline, which needs the width less than they the height.
        self.setCorner(Qt.Corner.BottomRightCorner, Qt.DockWidgetArea.RightDockWidgetArea)
        for front, behind in ((layers, styles), (timeline, curves)):
            self.tabifyDockWidget(front, behind)
            front.raise_()
        self.setAcceptDrops(True)
        self.setDockNestingEnabled(True)
        self.resize(1360, 860)
        self._share_room()

    def _share_room(self) -> None:
        layers, inspector, _, timeline = self.docks[:4]
        # In letters, so that it holds at any font size.
        letter = self.fontMetrics().horizontalAdvance("0")
        self.resizeDocks([layers, inspector], [_DOCK_LETTERS * letter] * 2, Qt.Orientation.Horizontal)
        self.resizeDocks([timeline], [self.height() * _TIMELINE_SHARE // 100], Qt.Orientation.Vertical)
        self.resizeDocks([layers, inspector], [_LAYERS_SHARE, 100 - _LAYERS_SHARE], Qt.Orientation.Vertical)

    def _restore_layout(self) -> None:
        geometry, state = self.settings.layout("geometry"), self.settings.layout("state")
        if not geometry.isEmpty():
            self.restoreGeometry(geometry)
        if not state.isEmpty():
            self.restoreState(state, _DOCKS)


def _files(event: QDropEvent) -> list[Path]:
    return [Path(url.toLocalFile()) for url in event.mimeData().urls() if url.isLocalFile()]
