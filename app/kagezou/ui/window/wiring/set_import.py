"""Who tells whom about imported sets."""

from kagezou.ui.widgets.message_bar import Severity
from kagezou.ui.window.parts import Parts

_FAILED = "set-failed"


def connect_set_import(parts: Parts) -> None:
    """Connect sets that arrive with who brings them in, and what it says with the bar of messages."""
    sets, bar, actions = parts.sets.imports, parts.bar, parts.actions

    def say(key: str, sentence: str, severity: Severity) -> None:
        if sentence:
            bar.say(key, sentence, severity)
        else:
            bar.withdraw(key)

    def follow() -> None:
        has_set = any(piece.source is not None for piece in parts.bridge.document.pieces)
        actions["settle_set"].setEnabled(has_set)

    parts.project.set_read.connect(sets.bring)
    sets.failed.connect(lambda sentence: say(_FAILED, sentence, Severity.ERROR))
    sets.noted.connect(lambda sentence: say(sentence, sentence, Severity.NOTE))
    actions.on("settle_set", sets.settle)
    parts.bridge.document_changed.connect(follow)
    follow()
