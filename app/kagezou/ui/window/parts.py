"""The parts of one window, as the connections between them see them."""

from collections.abc import Callable
from dataclasses import dataclass, field

from PySide6.QtWidgets import QMainWindow

from kagezou.ui.commands.actions import Actions
from kagezou.ui.commands.keyboard import Keyboard
from kagezou.ui.commands.search import CommandSearch
from kagezou.ui.curves.panel import CurvesPanel
from kagezou.ui.curves.review_bar import ReviewBar
from kagezou.ui.export.progress import Exporting
from kagezou.ui.panels.folds import Folds
from kagezou.ui.panels.inspector import Inspector
from kagezou.ui.panels.layer_list import LayerList
from kagezou.ui.panels.style_list import StyleList
from kagezou.ui.project.actions import ProjectActions
from kagezou.ui.project.canvas_offer import CanvasOffer
from kagezou.ui.project.demo import DemoOpener, MakeDemo
from kagezou.ui.project.dialogs import Dialogs
from kagezou.ui.project.feet_finder import FeetFinder
from kagezou.ui.project.layer_files import LayerFiles
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.project.welcome import Welcome
from kagezou.ui.sets.commands import SetCommands
from kagezou.ui.sets.import_bar import SetBar
from kagezou.ui.sets.imports import SetImports
from kagezou.ui.sets.list import SetList
from kagezou.ui.sets.standing import StandingNotes
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.clipboard import Clipboard
from kagezou.ui.system.missing import MissingDrawings
from kagezou.ui.system.settings import Settings
from kagezou.ui.system.thumbnails import Thumbnails
from kagezou.ui.time.key_commands import KeyCommands
from kagezou.ui.time.playback import Player
from kagezou.ui.time.prefetch import Prefetch
from kagezou.ui.time.transport import Transport
from kagezou.ui.timeline.ruler import Finished
from kagezou.ui.timeline.timeline import Timeline
from kagezou.ui.viewport.corner_sheet import CornerSheet
from kagezou.ui.viewport.onion_skin import OnionSkin
from kagezou.ui.viewport.sheets import Guides, Snapshot
from kagezou.ui.viewport.viewport import Viewport
from kagezou.ui.widgets.message_bar import MessageBar
from kagezou.ui.widgets.space_bar import SpaceBar
from kagezou.ui.window.menus import Menus
from kagezou.ui.window.status import Status

_BUTTONS = ("first", "key_previous", "back", "play", "forward", "key_next", "last", None, "loop")


@dataclass(frozen=True, slots=True)
class SetParts:
    """What the window has for sets: the list of pieces, what is done to them, drawing them, and importing."""

    commands: SetCommands
    pieces: SetList
    corner_sheet: CornerSheet
    bar: SetBar
    imports: SetImports
    standing: StandingNotes


@dataclass(frozen=True, slots=True)
class Sheets:
    """What is laid over the picture, under its handles."""

    guides: Guides
    snapshot: Snapshot
    onion_skin: OnionSkin


@dataclass(frozen=True, slots=True)
class TimeParts:
    """What runs, shows and changes time."""

    player: Player
    prefetch: Prefetch
    transport: Transport
    timeline: Timeline
    keys: KeyCommands


@dataclass(frozen=True, slots=True)
class Panels:
    """What stands beside the picture: layers, the properties of what is worked on, and styles."""

    thumbnails: Thumbnails
    layers: LayerList
    inspector: Inspector
    styles: StyleList


@dataclass(frozen=True, slots=True)
class FilesOfLayers:
    """What is done with the files of layers and of the background, and which of them are missing."""

    missing: MissingDrawings
    layers: LayerFiles
    canvas_offer: CanvasOffer


@dataclass(frozen=True, slots=True)
class Parts:
    """Every part of one window; no part knows another."""

    open_project: OpenProject
    settings: Settings
    actions: Actions
    menus: Menus
    keyboard: Keyboard
    search: CommandSearch
    bar: MessageBar
    space: SpaceBar
    status: Status
    exporting: Exporting
    project: ProjectActions
    demo: DemoOpener | None
    welcome: Welcome
    viewport: Viewport
    sheets: Sheets
    panels: Panels
    sets: SetParts
    time: TimeParts
    curves: CurvesPanel
    feet: FeetFinder
    files: FilesOfLayers
    review_bar: ReviewBar = field(default_factory=ReviewBar)

    @property
    def bridge(self) -> Bridge:
        """The session at hand, as signals."""
        return self.open_project.bridge

    def finish(self) -> None:
        """End what works beside the window, and put the project away."""
        self.project.loading.finish()
        self.feet.finish()
        self.exporting.finish()
        self.project.put_away()
        if self.demo is not None:
            self.demo.finish()
        self.viewport.finish()
        self.panels.thumbnails.finish()
        self.files.missing.finish()
        self.panels.styles.pictures.finish()
        self.welcome.pictures.finish()
        self.time.prefetch.finish()


def make_parts(
    window: QMainWindow,
    open_project: OpenProject,
    settings: Settings,
    clipboard: Clipboard,
    make_demo: MakeDemo | None,
) -> Parts:
    """Return new parts for a window, to which menus and dialogs belong; without ``make_demo`` no demo is offered."""
    bridge, actions, bar, space = open_project.bridge, Actions(window), MessageBar(), SpaceBar()
    player = Player(bridge)
    viewport = Viewport(bridge, open_project.cels, open_project.meshes, space)
    panels = _panels(bridge, clipboard, settings)
    exporting = Exporting(bar)
    # Before the menus: made later, its labels come after the first layout, and the first picture is drawn twice.
    status = Status(bridge, exporting)
    project = ProjectActions(open_project, Dialogs(window, settings), bar, settings)
    menus = Menus(window, actions)
    return Parts(
        open_project=open_project,
        settings=settings,
        actions=actions,
        menus=menus,
        bar=bar,
        space=space,
        exporting=exporting,
        project=project,
        demo=DemoOpener(make_demo, bar, project.open_recent) if make_demo else None,
        welcome=Welcome(settings.picture_folder),
        viewport=viewport,
        panels=panels,
        time=_time_parts(open_project, clipboard, player, actions, lambda: viewport.finished.frames),
        status=status,
        sets=_set_parts(open_project, viewport, space, menus),
        feet=FeetFinder(bridge),
        files=_files_of_layers(bridge, project),
        curves=CurvesPanel(bridge, clipboard, menus.fill_keys),
        keyboard=Keyboard(window, actions, settings, bar),
        search=CommandSearch(window, actions),
        sheets=_sheets(viewport, bridge, lambda: not (player.is_playing or viewport.controller.is_busy)),
    )


def _files_of_layers(bridge: Bridge, project: ProjectActions) -> FilesOfLayers:
    files = LayerFiles(bridge, project.dialogs, project.loading)
    return FilesOfLayers(MissingDrawings(bridge), files, CanvasOffer(bridge))


def _panels(bridge: Bridge, clipboard: Clipboard, settings: Settings) -> Panels:
    thumbnails = Thumbnails()
    return Panels(
        thumbnails,
        LayerList(bridge, clipboard, thumbnails),
        Inspector(bridge, clipboard, Folds(settings)),
        StyleList(bridge, settings),
    )


def _time_parts(
    open_project: OpenProject, clipboard: Clipboard, player: Player, actions: Actions, finished: Finished
) -> TimeParts:
    bridge, cels = open_project.bridge, open_project.cels
    return TimeParts(
        player,
        Prefetch(bridge, player, cels),
        Transport(bridge, player, [actions[name] if name else None for name in _BUTTONS]),
        Timeline(bridge, clipboard, cels.kept_sources, finished),
        KeyCommands(bridge, clipboard),
    )


def _set_parts(open_project: OpenProject, viewport: Viewport, space: SpaceBar, menus: Menus) -> SetParts:
    bridge, bar = open_project.bridge, SetBar()
    commands = SetCommands(bridge)
    return SetParts(
        commands,
        SetList(bridge, commands, menus.fill_set),
        CornerSheet(viewport, bridge, space),
        bar,
        SetImports(bridge, open_project.meshes, bar, viewport.picking),
        StandingNotes(bridge),
    )


def _sheets(viewport: Viewport, bridge: Bridge, is_still: Callable[[], bool]) -> Sheets:
    guides, snapshot = Guides(viewport, viewport.viewpoint), Snapshot(viewport, viewport.viewpoint)
    onion_skin = OnionSkin(viewport, bridge, is_still)
    guides.stackUnder(viewport.overlay)
    snapshot.stackUnder(guides)
    onion_skin.stackUnder(guides)
    return Sheets(guides, snapshot, onion_skin)
