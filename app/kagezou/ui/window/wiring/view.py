"""Who tells whom about looking closer: the views of the frame, and what is laid over the picture."""

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QActionGroup, QImage

from kagezou.ui.viewport.onion_skin import MOST, OnionSkin
from kagezou.ui.viewport.picture_view import PictureView
from kagezou.ui.viewport.resolution import Resolution
from kagezou.ui.viewport.sheets import Guides, Snapshot

if TYPE_CHECKING:
    from kagezou.ui.window.main_window import MainWindow


def connect_views(window: "MainWindow") -> None:
    """Connect the choice of what is looked at."""
    actions, viewport = window.actions_of, window.viewport
    group = QActionGroup(window)
    for view in PictureView:
        action = actions[f"view_{view.value}"]
        group.addAction(action)
        action.setChecked(view is viewport.view)

        def show(on: bool, chosen: PictureView = view) -> None:
            if on:
                viewport.show_view(chosen)

        actions.on_toggled(f"view_{view.value}", show)


def connect_resolution(window: "MainWindow") -> None:
    """Connect the choice of the preview's resolution, and tell in the status bar when it is not the full one."""
    viewport, settings = window.viewport, window.settings

    def choose(resolution: Resolution) -> None:
        viewport.show_resolution(resolution)
        settings.set_word("resolution", resolution.value)

    kept = settings.word("resolution", Resolution.AUTO.value)
    viewport.show_resolution(Resolution(kept) if kept in list(Resolution) else Resolution.AUTO)
    window.menus.add_resolutions(viewport.resolution, choose)
    viewport.divisor_changed.connect(window.status.show_divisor, Qt.ConnectionType.QueuedConnection)


def connect_sheets(window: "MainWindow") -> None:
    """Lay guides, snapshot and onion skin over the picture, under the handles."""
    actions, viewport = window.actions_of, window.viewport
    window.guides = Guides(viewport, viewport.viewpoint)
    window.snapshot = Snapshot(viewport, viewport.viewpoint)
    window.onion_skin = OnionSkin(viewport, window.open_project.bridge, lambda: not _moves(window))
    for sheet in (window.guides, window.snapshot, window.onion_skin):
        sheet.stackUnder(viewport.overlay if sheet is window.guides else window.guides)
    actions.on_toggled("safe_area", window.guides.show_safe_area)
    actions.on_toggled("field_guide", window.guides.show_field_guide)
    actions.on_toggled("onion_skin", window.onion_skin.turn)
    actions.on_toggled("snapshot_show", window.snapshot.setVisible)
    actions.on_toggled("snapshot_wipe", lambda on: _wipe(window, on))
    actions.on("snapshot_take", lambda: _take_snapshot(window))
    for name in ("snapshot_show", "snapshot_wipe"):
        actions[name].setEnabled(False)
    _remember_count(window)


def _moves(window: "MainWindow") -> bool:
    return window.player.is_playing or window.viewport.hand.is_busy


def _take_snapshot(window: "MainWindow") -> None:
    picture = window.viewport.read_picture()
    if picture is None:
        return
    height, width = picture.shape[:2]
    # The copy outlives the array.
    image = QImage(picture.tobytes(), width, height, width * 4, QImage.Format.Format_RGBA8888).copy()
    window.snapshot.take(image)
    for name in ("snapshot_show", "snapshot_wipe"):
        window.actions_of[name].setEnabled(True)


def _wipe(window: "MainWindow", on: bool) -> None:
    window.snapshot.wipe(on)
    if on:
        window.actions_of["snapshot_show"].setChecked(True)


def _remember_count(window: "MainWindow") -> None:
    settings, onion_skin = window.settings, window.onion_skin

    def choose(count: int) -> None:
        onion_skin.show_count(count)
        settings.set_word("onion_drawings", str(count))
        window.actions_of["onion_skin"].setChecked(True)

    kept = settings.word("onion_drawings", "1")
    count = int(kept) if kept in map(str, range(1, MOST + 1)) else 1
    onion_skin.show_count(count)
    window.menus.add_onion_counts(MOST, count, choose)
