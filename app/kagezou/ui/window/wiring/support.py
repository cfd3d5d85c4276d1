"""Who tells whom what whoever helps wants to know: the report that is copied, and memory under the hand."""

from PySide6.QtCore import QCoreApplication

from kagezou.ui.system.clipboard import SystemClipboard
from kagezou.ui.system.support_report import Shown, memory_words, support_report
from kagezou.ui.window.parts import Parts


def connect_support(parts: Parts) -> None:
    """Connect the command of the Help menu and the status bar."""
    parts.actions.on("support_report", lambda: _copy_report(parts))
    _tell_memory(parts)


def _copy_report(parts: Parts) -> None:
    """Put the report on the clipboard, and say so."""
    document, cels = parts.bridge.document, parts.open_project.cels
    canvas = document.canvas
    words = f"{canvas.width_px} x {canvas.height_px} px, {canvas.length_frames} frames"
    shown = Shown(
        parts.viewport.device, words, len(document.layers), len(document.pieces), cels.nbytes, cels.limit_bytes
    )
    SystemClipboard().put(support_report(shown, parts.settings))
    parts.status.say(
        QCoreApplication.translate(
            "Help", "The report is on the clipboard. It holds names of files from the log: read it before you send it"
        )
    )


def _tell_memory(parts: Parts) -> None:
    """Let the status bar say under the hand what memory drawings take, and what is free."""
    cels = parts.open_project.cels

    def words() -> str:
        taken, most, free = memory_words(cels.nbytes, cels.limit_bytes)
        text = QCoreApplication.translate("Help", "Drawings in memory: %1 of %2. Free memory: %3")
        return text.replace("%1", taken).replace("%2", most).replace("%3", free)

    parts.status.watch_memory(words)
