"""Who tells whom about imported sets."""

from typing import TYPE_CHECKING

from kagezou.ui.widgets.message_bar import Severity

if TYPE_CHECKING:
    from kagezou.ui.window.main_window import MainWindow

_FAILED, _NOTED = "set-failed", "set-noted"


def connect_set_import(window: "MainWindow") -> None:
    """Connect sets that arrive with who brings them in, and what it says with the bar of messages."""
    sets, bar, actions = window.set_imports, window.bar, window.actions_of

    def say(key: str, sentence: str, severity: Severity) -> None:
        if sentence:
            bar.say(key, sentence, severity)
        else:
            bar.withdraw(key)

    def follow() -> None:
        has_set = any(piece.source is not None for piece in window.open_project.bridge.document.pieces)
        actions["settle_set"].setEnabled(has_set)

    window.project.set_read.connect(sets.bring)
    sets.failed.connect(lambda sentence: say(_FAILED, sentence, Severity.ERROR))
    sets.noted.connect(lambda sentence: say(_NOTED, sentence, Severity.NOTE))
    actions.on("settle_set", sets.settle)
    window.open_project.bridge.document_changed.connect(follow)
    follow()
