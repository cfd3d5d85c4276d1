"""Who tells whom about matching the camera to the background picture."""

from PySide6.QtCore import QCoreApplication

from kagezou.ui.viewport.handle_source import Task
from kagezou.ui.widgets.message_bar import Severity
from kagezou.ui.window.parts import Parts

_TOPIC = "match-camera"


def connect_match(parts: Parts) -> None:
    """Connect the switch that puts floor edges and horizon in the place of all other handles."""
    actions, hand, bar = parts.actions, parts.viewport.controller, parts.bar

    def switch(on: bool) -> None:
        if not on:
            if hand.task is Task.MATCH:
                hand.take_up(Task.SCENE)
            bar.withdraw(_TOPIC)
            return
        actions["transform_cel"].setChecked(False)
        hand.take_up(Task.MATCH)
        actions["handles"].setChecked(True)
        # So that Esc reaches the hand, wherever the command was chosen.
        parts.viewport.setFocus()
        words = QCoreApplication.translate(
            "Match",
            "Lay the two orange lines along edges of the floor that run away, the two blue ones along edges square to "
            "them. The dash-dotted line is the horizon. Esc ends it.",
        )
        bar.say(_TOPIC, words, Severity.NOTE)

    actions.on_toggled("match_camera", switch)
    hand.laid_down.connect(lambda: actions["match_camera"].setChecked(False))
    parts.bridge.session_replaced.connect(lambda: actions["match_camera"].setChecked(False))
