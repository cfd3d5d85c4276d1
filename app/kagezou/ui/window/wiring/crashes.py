"""What the window says of a crash, and what can be done with its report."""

from pathlib import Path

from PySide6.QtCore import QCoreApplication, QUrl
from PySide6.QtGui import QDesktopServices

from kagezou.ui.system.clipboard import SystemClipboard
from kagezou.ui.widgets.message_bar import Offer, Severity
from kagezou.ui.window.parts import Parts


def say_incident(parts: Parts, sentence: str, report: Path | None) -> None:
    """Say what went wrong just now, and offer its report if there is one."""
    parts.bar.say("incident", sentence, offers=() if report is None else _offers(parts, report))


def say_last_end(parts: Parts, report: Path) -> None:
    """Say that the program did not end by itself the last time, and offer the report of it."""
    words = QCoreApplication.translate("Help", "Kagezou crashed the last time. What is known of it is in %1")
    parts.bar.say("last end", words.replace("%1", str(report)), Severity.WARNING, _offers(parts, report))


def _offers(parts: Parts, report: Path) -> tuple[Offer, ...]:
    def copy() -> None:
        try:
            text = report.read_text(encoding="utf-8", errors="replace")
        except OSError as error:
            parts.status.say(f"{report}: {error.strerror}")
            return
        SystemClipboard().put(text)
        parts.status.say(
            QCoreApplication.translate(
                "Help",
                "The report is on the clipboard. It holds names of files from the log: read it before you send it",
            )
        )

    return (
        Offer(QCoreApplication.translate("Help", "Copy Report"), copy),
        Offer(
            QCoreApplication.translate("Help", "Show Folder"),
            lambda: QDesktopServices.openUrl(QUrl.fromLocalFile(str(report.parent))),
        ),
    )
