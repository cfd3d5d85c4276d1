"""Who tells whom about time: playback, the timeline and the commands on keys."""

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication

from kagezou.animation.timecode import Count
from kagezou.animation.track import Interpolation
from kagezou.document.keyed_frames import key_frames, next_key, previous_key
from kagezou.ui.system.icons import icon
from kagezou.ui.timeline.drawing_menu import open_drawing_menu
from kagezou.ui.timeline.revealing import REVEALED, added, animated_or_changed, toggled
from kagezou.ui.widgets.message_bar import Severity
from kagezou.ui.window.panel_layout import PanelLayout
from kagezou.ui.window.parts import Parts
from kagezou.ui.window.verbs import WindowVerbs

_Neighbour = Callable[[tuple[int, ...], int], int | None]


def connect_playback(parts: Parts, verbs: WindowVerbs) -> None:
    """Connect the commands of time."""
    actions, player, bridge = parts.actions, parts.time.player, parts.bridge

    def step(frames: int) -> None:
        player.stop()
        bridge.session.go_to(bridge.frame + frames)

    for name, frames in {"back": -1, "forward": 1, "back_10": -10, "forward_10": 10}.items():
        actions.on(name, partial(step, frames))
    actions.on("first", lambda: bridge.session.go_to(1))
    actions.on("work_first", lambda: bridge.session.go_to(bridge.document.played[0]))
    actions.on("work_last", lambda: bridge.session.go_to(bridge.document.played[1]))
    actions.on("last", lambda: bridge.session.go_to(bridge.document.canvas.length_frames))
    actions.on("go_to_frame", parts.time.transport.ask_frame)
    actions.on("read_ahead", parts.project.read_ahead)
    parts.project.loading.progressed.connect(parts.time.timeline.ruler.refresh)
    actions.on("play", lambda: _play(parts))
    parts.space.tapped.connect(lambda: _play(parts))
    parts.viewport.keys.step_asked.connect(step)

    def shown() -> None:
        # While drawings are read the last picture stays; that is no new frame.
        if parts.viewport.is_current:
            player.picture_shown()

    parts.viewport.shown.connect(shown)
    player.playing_changed.connect(lambda _: _show_playing(parts, verbs))
    for name in ("loop", "every_frame", "ping_pong"):
        _remember_switch(parts, name)


def connect_jumps(parts: Parts) -> None:
    """Connect the commands that lead to the next key, drawing or marker."""
    actions, bridge = parts.actions, parts.bridge

    def keyed() -> tuple[int, ...]:
        return key_frames(bridge.document, bridge.layer_id, bridge.piece_id)

    def drawn() -> tuple[int, ...]:
        layers = [layer for layer in bridge.document.layers if layer.id == bridge.layer_id]
        return tuple(max(each.frame, 1) for layer in layers for each in layer.cels.exposures)

    def marked() -> tuple[int, ...]:
        return tuple(marker.frame for marker in bridge.document.markers)

    def jump(neighbour: _Neighbour, frames: Callable[[], tuple[int, ...]]) -> None:
        frame = neighbour(frames(), bridge.frame)
        if frame is not None:
            bridge.session.go_to(frame)

    for name, frames in {"key": keyed, "drawing": drawn, "marker": marked}.items():
        actions.on(f"{name}_previous", partial(jump, previous_key, frames))
        actions.on(f"{name}_next", partial(jump, next_key, frames))


def connect_keys(parts: Parts) -> None:
    """Connect the commands on keys, work area and markers."""
    keys, timeline, actions = parts.time.keys, parts.time.timeline, parts.actions
    connected: dict[str, Callable[[], object]] = {
        "set_keys": keys.set_here,
        "copy_keys": keys.copy,
        "cut_keys": keys.cut,
        "paste_keys": keys.paste,
        "paste_in_place": keys.paste_in_place,
        "select_keys": keys.select_all,
        "keys_back": partial(keys.nudge, -1),
        "keys_on": partial(keys.nudge, 1),
        "keys_back_10": partial(keys.nudge, -10),
        "keys_on_10": partial(keys.nudge, 10),
        "ease_both": partial(keys.ease, into=True, out=True),
        "ease_in": partial(keys.ease, into=True, out=False),
        "ease_out": partial(keys.ease, into=False, out=True),
        "hold": keys.hold,
        "linear": partial(keys.interpolate, Interpolation.LINEAR),
        "work_in": keys.begin_work_area,
        "work_out": keys.end_work_area,
        "work_clear": keys.clear_work_area,
        "marker": timeline.add_marker,
    }
    for name, do in connected.items():
        actions.on(name, do)
    keys.refused.connect(lambda sentence: parts.bar.say("keys", sentence, Severity.NOTE))
    parts.menus.fill_keys(timeline.key_menu)


def connect_drawings(parts: Parts) -> None:
    """Connect the commands on exposures; within the timeline copy and paste are theirs while drawings are chosen."""
    drawings, actions, timeline, keys = (
        parts.time.timeline.drawings,
        parts.actions,
        parts.time.timeline,
        parts.time.keys,
    )
    connected: dict[str, Callable[[], object]] = {
        "drawing_split": drawings.split,
        "drawing_empty": drawings.empty,
        "drawing_remove": drawings.remove,
        "drawing_longer": partial(drawings.hold_longer, 1),
        "drawing_shorter": partial(drawings.hold_longer, -1),
        "on_ones": partial(drawings.expose_on, 1),
        "on_twos": partial(drawings.expose_on, 2),
        "on_threes": partial(drawings.expose_on, 3),
        "on_fours": partial(drawings.expose_on, 4),
        "drawing_copy": drawings.copy,
        "drawing_paste": drawings.paste,
    }
    for name, do in connected.items():
        actions.on(name, do)

    actions.on("copy_keys", lambda: drawings.copy() if drawings.are_chosen else keys.copy(), within=timeline)
    actions.on("paste_keys", lambda: drawings.paste() if drawings.has_copy else keys.paste(), within=timeline)
    drawings.refused.connect(lambda sentence: parts.bar.say("drawings", sentence, Severity.NOTE))
    timeline.drawing_menu_asked.connect(lambda place: open_drawing_menu(timeline, parts.menus.fill_drawings, place))


def connect_timeline(parts: Parts) -> None:
    """Connect what the timeline shows."""
    timeline, actions, settings = parts.time.timeline, parts.actions, parts.settings
    actions.on("timeline_fit", timeline.fit)
    actions.on("timeline_in", partial(timeline.zoom, 1.5))
    actions.on("timeline_out", partial(timeline.zoom, 1 / 1.5))
    actions.on("reveal_animated", lambda: timeline.rows.show_only(animated_or_changed(timeline.rows.reveal)))
    for name in REVEALED:
        actions.on(name, partial(_reveal, parts, name))
    kept = settings.word("ruler", Count.FRAMES.value)
    timeline.ruler.show_count(Count(kept) if kept in list(Count) else Count.FRAMES)
    timeline.count_chosen.connect(lambda count: settings.set_word("ruler", count.value))


def connect_curves(parts: Parts, layout: PanelLayout) -> None:
    """Connect what the curve editor answers; it is made when it is first shown."""
    curves, actions = parts.curves, parts.actions

    def show_velocity() -> None:
        layout.show("curves")
        curves.ask_velocity()

    actions.on("curves", lambda: layout.show("curves"))
    actions.on("velocity", show_velocity)
    actions.on("fit", curves.fit_chosen, within=curves)
    actions.on("timeline_fit", curves.fit_all, within=curves)
    curves.refused.connect(lambda sentence: parts.bar.say("curves", sentence, Severity.NOTE))


def _reveal(parts: Parts, name: str) -> None:
    rows = parts.time.timeline.rows
    adds = QGuiApplication.keyboardModifiers() & Qt.KeyboardModifier.ShiftModifier
    rows.show_only(added(rows.reveal, name) if adds else toggled(rows.reveal, name))


def _play(parts: Parts) -> None:
    if not parts.viewport.controller.is_busy and not parts.open_project.is_blank:
        parts.time.player.toggle()


def _show_playing(parts: Parts, verbs: WindowVerbs) -> None:
    parts.actions["play"].setIcon(icon("pause" if parts.time.player.is_playing else "play"))
    verbs.show_handles()


def _remember_switch(parts: Parts, name: str) -> None:
    action, player, settings = parts.actions[name], parts.time.player, parts.settings

    def switch(on: bool) -> None:
        setattr(player, name, on)
        settings.set_flag(name, on=on)

    action.setChecked(settings.flag(name, default=getattr(player, name)))
    setattr(player, name, action.isChecked())
    parts.actions.on_toggled(name, switch)
