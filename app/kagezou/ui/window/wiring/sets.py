"""Who tells whom about the set: its commands, its list, and what they are about."""

from functools import partial

from kagezou.document.piece_kinds import BUILT_KINDS
from kagezou.ui.system.words import translated
from kagezou.ui.viewport.corner_sheet import CornerStroke
from kagezou.ui.widgets.message_bar import Severity
from kagezou.ui.window.parts import Parts
from kagezou.ui.window.verbs import WindowVerbs


def connect_set(parts: Parts, verbs: WindowVerbs) -> None:
    """Connect the commands of the set and the list of its pieces."""
    actions, commands, pieces, bridge = parts.actions, parts.sets.commands, parts.sets.pieces, parts.bridge
    for kind in BUILT_KINDS:
        actions.on(f"add_{kind}", partial(commands.add, kind))
    actions.on("duplicate_piece", commands.duplicate)
    actions.on("remove_piece", commands.remove)
    actions.on("rename_piece", pieces.rename_current)
    # The list of pieces answers for itself what elsewhere is about keys and layers.
    actions.on("delete", commands.remove, within=pieces)

    actions.on("draw_corner", lambda: _draw(parts, CornerStroke.GROUND))
    actions.on("draw_wall", lambda: _draw(parts, CornerStroke.WALL))
    parts.sets.corner_sheet.turned.connect(verbs.show_handles)
    needing_a_picture = (*(f"add_{kind}" for kind in BUILT_KINDS), "draw_corner", "draw_wall")

    def follow() -> None:
        for name in needing_a_picture:
            actions[name].setEnabled(not parts.open_project.is_blank)
        # Styles are looks of a character's shadow.
        parts.panels.styles.setEnabled(bridge.layer_id is not None)
        for name in ("rename_piece", "duplicate_piece", "remove_piece"):
            actions[name].setEnabled(bridge.piece_id is not None)

    for refusal in (commands.refused, pieces.model.refused, parts.sets.corner_sheet.refused):
        refusal.connect(lambda sentence: parts.bar.say("set", sentence, Severity.NOTE))
    parts.sets.standing.noted.connect(lambda note: parts.bar.say(translated(note), translated(note), Severity.NOTE))
    bridge.document_changed.connect(follow)
    bridge.selection_changed.connect(follow)
    follow()


def _draw(parts: Parts, stroke: CornerStroke) -> None:
    parts.time.player.stop()
    parts.actions["match_camera"].setChecked(False)
    parts.viewport.controller.cancel()
    parts.viewport.controller.hover(None)
    parts.sets.corner_sheet.begin(stroke)


def remove_touched(parts: Parts) -> None:
    """Take the set piece away of which something is selected in the picture."""
    selected = parts.viewport.controller.handles.find(parts.viewport.controller.selected_id)
    if parts.viewport.hasFocus() and selected is not None and selected.piece_id is not None:
        parts.sets.commands.remove()
