"""Who tells whom about looking closer: the views of the frame, and what is laid over the picture."""

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QActionGroup, QImage

from kagezou.ui.viewport.onion_skin import MOST
from kagezou.ui.viewport.picture_view import PictureView
from kagezou.ui.viewport.resolution import Resolution
from kagezou.ui.widgets.message_bar import Severity
from kagezou.ui.window.parts import Parts

_BRINGING = (
    *("import", "import_pictures", "import_set", "import_timesheet"),
    *("background", "background_pictures", "no_background"),
)
"""Commands that would ask for files before they are refused."""


def connect_views(parts: Parts) -> None:
    """Connect the choice of what is looked at."""
    actions, viewport = parts.actions, parts.viewport
    group = QActionGroup(viewport)
    for view in PictureView:
        action = actions[f"view_{view.value}"]
        group.addAction(action)
        action.setChecked(view is viewport.view)

        def show(on: bool, chosen: PictureView = view) -> None:
            if on:
                viewport.show_view(chosen)

        actions.on_toggled(f"view_{view.value}", show)


def connect_resolution(parts: Parts) -> None:
    """Connect the choice of the preview's resolution, and tell in the status bar when it is not the full one."""
    viewport, settings = parts.viewport, parts.settings

    def choose(resolution: Resolution) -> None:
        viewport.show_resolution(resolution)
        settings.set_word("resolution", resolution.value)

    kept = settings.word("resolution", Resolution.AUTO.value)
    viewport.show_resolution(Resolution(kept) if kept in list(Resolution) else Resolution.AUTO)
    parts.menus.add_resolutions(viewport.resolution, choose)
    viewport.divisor_changed.connect(parts.status.show_divisor, Qt.ConnectionType.QueuedConnection)


def connect_lock(parts: Parts) -> None:
    """Connect the switch that lets everything only be looked at; whoever tries to change something is told."""
    bridge, bar, look_only = parts.bridge, parts.bar, parts.actions["look_only"]
    parts.actions.on_toggled("look_only", bridge.lock)
    bridge.lock_changed.connect(look_only.setChecked)
    bridge.lock_changed.connect(lambda on: parts.status.show_locked(locked=on))
    words = QCoreApplication.translate("Lock", "Look Only is on, so nothing is changed; it is in the View menu.")
    bridge.edit_refused.connect(lambda: bar.say("lock", words, Severity.NOTE))
    for name in _BRINGING:
        parts.actions.guard(name, lambda: not bridge.is_locked, bridge.edit_refused.emit)


def connect_sheets(parts: Parts) -> None:
    """Connect what is laid over the picture: guides, snapshot and onion skin."""
    actions, sheets = parts.actions, parts.sheets
    actions.on_toggled("safe_area", sheets.guides.show_safe_area)
    actions.on_toggled("field_guide", sheets.guides.show_field_guide)
    actions.on_toggled("onion_skin", sheets.onion_skin.turn)
    actions.on_toggled("snapshot_show", sheets.snapshot.setVisible)
    actions.on_toggled("snapshot_wipe", lambda on: _wipe(parts, on))
    actions.on("snapshot_take", lambda: _take_snapshot(parts))
    for name in ("snapshot_show", "snapshot_wipe"):
        actions[name].setEnabled(False)
    _remember_count(parts)


def _take_snapshot(parts: Parts) -> None:
    picture = parts.viewport.read_picture()
    if picture is None:
        return
    height, width = picture.shape[:2]
    # The copy outlives the array.
    image = QImage(picture.tobytes(), width, height, width * 4, QImage.Format.Format_RGBA8888).copy()
    parts.sheets.snapshot.take(image)
    for name in ("snapshot_show", "snapshot_wipe"):
        parts.actions[name].setEnabled(True)


def _wipe(parts: Parts, on: bool) -> None:
    parts.sheets.snapshot.wipe(on)
    if on:
        parts.actions["snapshot_show"].setChecked(True)


def _remember_count(parts: Parts) -> None:
    settings, onion_skin = parts.settings, parts.sheets.onion_skin

    def choose(count: int) -> None:
        onion_skin.show_count(count)
        settings.set_word("onion_drawings", str(count))
        parts.actions["onion_skin"].setChecked(True)

    kept = settings.word("onion_drawings", "1")
    count = int(kept) if kept in map(str, range(1, MOST + 1)) else 1
    onion_skin.show_count(count)
    parts.menus.add_onion_counts(MOST, count, choose)
