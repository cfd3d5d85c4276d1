"""What a drag of the frame around keys is called, and what is said of it beside the pointer."""

from typing import assert_never

from PySide6.QtCore import QCoreApplication

from kagezou.tools.curves.box_drag import MovedBy, ScaledBy
from kagezou.tools.curves.key_box import BoxGrip


def step_name(part: BoxGrip) -> str:
    """Return what the step of history is called."""
    words = {
        (False, False): QCoreApplication.translate("BoxDrag", "Move keys"),
        (True, False): QCoreApplication.translate("BoxDrag", "Stretch keys"),
        (False, True): QCoreApplication.translate("BoxDrag", "Scale keys in value"),
        (True, True): QCoreApplication.translate("BoxDrag", "Scale keys"),
    }
    return words[bool(part.across), bool(part.up)]


def words_of(change: MovedBy | ScaledBy, factor: float) -> str:
    """Return what was done so far; values are shown times a factor."""
    match change:
        case MovedBy():
            value = "" if change.amount is None else f"{change.amount * factor:+.4g}"
            moved = QCoreApplication.translate("BoxDrag", "%1 frames").replace("%1", f"{change.frames:+d}")
            return f"{moved}    {value}".strip()
        case ScaledBy():
            shown = []
            if change.time is not None:
                time = QCoreApplication.translate("BoxDrag", "time × %1")
                shown.append(time.replace("%1", f"{change.time:.2f}"))
            if change.value is not None:
                value = QCoreApplication.translate("BoxDrag", "value × %1")
                shown.append(value.replace("%1", f"{change.value:.2f}"))
            return "    ".join(shown)
        case _:
            assert_never(change)
