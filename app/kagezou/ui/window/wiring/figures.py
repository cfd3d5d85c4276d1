"""Who tells whom about cels that are transformed, and about feet."""

from PySide6.QtCore import QCoreApplication

from kagezou.scene.stances import stances_of
from kagezou.ui.system.words import translated
from kagezou.ui.viewport.handle_source import Task
from kagezou.ui.widgets.message_bar import Severity
from kagezou.ui.window.parts import Parts

_TRANSFORM, _DOUBT = "transform-cel", "doubtful-drawing"
translate = QCoreApplication.translate


def connect_transform(parts: Parts) -> None:
    """Connect the switch that puts the handles of a cel in the place of all others."""
    actions, hand, bar = parts.actions, parts.viewport.controller, parts.bar

    def switch(on: bool) -> None:
        if not on:
            if hand.task is Task.TRANSFORM:
                hand.take_up(Task.SCENE)
            bar.withdraw(_TRANSFORM)
            return
        actions["match_camera"].setChecked(False)
        hand.take_up(Task.TRANSFORM)
        actions["handles"].setChecked(True)
        parts.viewport.setFocus()
        words = translate(
            "Figures",
            "Drag the cel to move it, a corner to scale it, outside of a corner to turn it; Shift constrains. Esc ends "
            "it.",
        )
        bar.say(_TRANSFORM, words, Severity.NOTE)

    actions.on_toggled("transform_cel", switch)
    hand.laid_down.connect(lambda: actions["transform_cel"].setChecked(False))
    parts.bridge.session_replaced.connect(lambda: actions["transform_cel"].setChecked(False))


def connect_feet(parts: Parts) -> None:
    """Connect the search for feet, and the way from one doubtful drawing to the next."""
    actions, bridge, finder = parts.actions, parts.bridge, parts.feet
    actions.on("find_feet", lambda: finder.search(bridge.layer_ids))
    actions.on("doubtful_next", lambda: _go_to_doubt(parts, 1))
    actions.on("doubtful_previous", lambda: _go_to_doubt(parts, -1))
    parts.open_project.imported.connect(finder.search)
    finder.progressed.connect(parts.status.show_work)
    finder.noted.connect(lambda note: parts.bar.say(str(note), translated(note), Severity.NOTE))
    bridge.session_replaced.connect(finder.forget)


def _go_to_doubt(parts: Parts, step: int) -> None:
    """Look at the next drawing of which it is doubtful how a figure stands, of the one worked on first."""
    bridge = parts.bridge
    document, frame = bridge.document, bridge.frame
    ids = [layer.id for layer in document.layers if layer.joins is None]
    found = {(at, layer_id) for layer_id in ids if (known := stances_of(document, layer_id)) for at in known.doubtful}
    ahead = sorted((at, layer_id) for at, layer_id in found if (at - frame) * step > 0)
    if not ahead:
        words = translate("Figures", "There is no more drawing with doubtful feet in this direction.")
        parts.bar.say(_DOUBT, words, Severity.NOTE)
        return
    parts.bar.withdraw(_DOUBT)
    at, layer_id = ahead[0] if step > 0 else ahead[-1]
    bridge.session.select(layer_id)
    bridge.session.go_to(at)
