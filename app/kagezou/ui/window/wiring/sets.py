"""Who tells whom about the set: its commands, its list, and what they are about."""

from functools import partial
from typing import TYPE_CHECKING

from kagezou.document.piece_kinds import BUILT_KINDS
from kagezou.ui.viewport.corner_sheet import CornerStroke
from kagezou.ui.widgets.message_bar import Severity

if TYPE_CHECKING:
    from kagezou.ui.window.main_window import MainWindow


def connect_set(window: "MainWindow") -> None:
    """Connect the commands of the set and the list of its pieces."""
    actions, commands, pieces, bridge = (
        window.actions_of,
        window.set_commands,
        window.set_list,
        window.open_project.bridge,
    )
    for kind in BUILT_KINDS:
        actions.on(f"add_{kind}", partial(commands.add, kind))
    actions.on("duplicate_piece", commands.duplicate)
    actions.on("remove_piece", commands.remove)
    actions.on("rename_piece", pieces.rename_current)
    # The list of pieces answers for itself what elsewhere is about keys and layers.
    actions.on("delete", commands.remove, within=pieces)

    actions.on("draw_corner", lambda: _draw(window, CornerStroke.GROUND))
    actions.on("draw_wall", lambda: _draw(window, CornerStroke.WALL))
    window.corner_sheet.turned.connect(window.show_handles)
    needing_a_picture = (*(f"add_{kind}" for kind in BUILT_KINDS), "draw_corner", "draw_wall")

    def follow() -> None:
        for name in needing_a_picture:
            actions[name].setEnabled(not window.open_project.is_blank)
        # Styles are looks of a character's shadow.
        window.styles.setEnabled(bridge.layer_id is not None)
        for name in ("rename_piece", "duplicate_piece", "remove_piece"):
            actions[name].setEnabled(bridge.piece_id is not None)

    for refusal in (commands.refused, pieces.model.refused, window.corner_sheet.refused):
        refusal.connect(lambda sentence: window.bar.say("set", sentence, Severity.NOTE))
    bridge.document_changed.connect(follow)
    bridge.selection_changed.connect(follow)
    follow()


def _draw(window: "MainWindow", stroke: CornerStroke) -> None:
    window.player.stop()
    window.actions_of["match_camera"].setChecked(False)
    window.viewport.hand.cancel()
    window.viewport.hand.hover(None)
    window.corner_sheet.begin(stroke)


def remove_touched(window: "MainWindow") -> None:
    """Take the set piece away of which something is selected in the picture."""
    selected = window.viewport.hand.handles.find(window.viewport.hand.selected_id)
    if window.viewport.hasFocus() and selected is not None and selected.piece_id is not None:
        window.set_commands.remove()
