"""What nobody foresaw: errors that reach the top and Qt's own warnings are written down and said, never swallowed."""

import logging
import sys
import threading
import traceback
from collections.abc import Callable, Sequence
from logging.handlers import RotatingFileHandler
from pathlib import Path
from types import TracebackType
from typing import Final

from platformdirs import user_log_path
from PySide6.QtCore import QMessageLogContext, QObject, QtMsgType, Signal, qInstallMessageHandler, qVersion

from kagezou.errors import Problem
from kagezou.io.files.crash_reports import LOG_NAME, write_report
from kagezou.io.files.this_system import system_words
from kagezou.ui.system.words import translated
from kagezou.version import __version__

_LEVELS = {
    QtMsgType.QtDebugMsg: logging.DEBUG,
    QtMsgType.QtInfoMsg: logging.INFO,
    QtMsgType.QtWarningMsg: logging.WARNING,
    QtMsgType.QtCriticalMsg: logging.ERROR,
    QtMsgType.QtFatalMsg: logging.CRITICAL,
}
LOG_BYTES = 1 << 20
MOST_REPORTS: Final = 5
"""So many different errors of one run get a report of their own."""

log = logging.getLogger("kagezou")


class UnforeseenErrors(QObject):
    """Hooks into Python and Qt; ``happened`` carries one sentence for the message bar.

    The signal may be sent from any thread; Qt brings it to the window's own.
    """

    happened = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.log_file: Path | None = None
        self.report: Path | None = None
        """The report of what happened last."""
        self.about: Callable[[], Sequence[str]] = tuple
        """What else a report says, line by line."""
        self._reported: dict[str, Path] = {}

    def watch(self) -> None:
        """Begin to write down and to tell."""
        self.log_file = _log_to_file()
        sys.excepthook = self._unhandled
        threading.excepthook = self._unhandled_in_thread
        qInstallMessageHandler(self._from_qt)

    def _unhandled(self, kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
        if issubclass(kind, KeyboardInterrupt):
            sys.__excepthook__(kind, error, trace)
            return
        story = "".join(traceback.format_exception(kind, error, trace))
        log.error("unhandled: %s", story)
        self.report = None if isinstance(error, Problem) else self._reported_in(story)
        self.happened.emit(self._sentence(error))

    def _unhandled_in_thread(self, arguments: threading.ExceptHookArgs) -> None:
        if arguments.exc_value is not None:
            self._unhandled(arguments.exc_type, arguments.exc_value, arguments.exc_traceback)

    def _reported_in(self, story: str) -> Path | None:
        """Return the report of an error, written where it is the first of its kind; the log has all of them."""
        if story not in self._reported and len(self._reported) < MOST_REPORTS:
            try:
                self._reported[story] = write_report(story, self.about())
            except OSError as refusal:
                log.warning("no report: %s", refusal)
        return self._reported.get(story)

    def _sentence(self, error: BaseException) -> str:
        if isinstance(error, Problem):
            return translated(error)
        words = self.tr("Something went wrong inside the program (%1). Save your project. Details: %2")
        written = self.report or self.log_file
        where = str(written) if written else self.tr("no log could be written")
        return words.replace("%1", f"{type(error).__name__}: {error}"[:200]).replace("%2", where)

    def _from_qt(self, kind: QtMsgType, context: QMessageLogContext, text: str) -> None:
        log.log(_LEVELS.get(kind, logging.WARNING), "Qt: %s", text)
        if kind in (QtMsgType.QtCriticalMsg, QtMsgType.QtFatalMsg):
            self.happened.emit(text)


def _log_to_file() -> Path | None:
    """Write to a file of the user's; where that is impossible the terminal alone has to do."""
    log.setLevel(logging.INFO)
    log.addHandler(logging.StreamHandler())
    try:
        path = user_log_path("kagezou", appauthor=False, ensure_exists=True) / LOG_NAME
        handler = RotatingFileHandler(path, maxBytes=LOG_BYTES, backupCount=2, encoding="utf-8")
    except OSError as error:
        log.warning("no log file: %s", error)
        return None
    handler.setFormatter(logging.Formatter("%(asctime)s %(levelname)s %(message)s"))
    log.addHandler(handler)
    # Only into the file: who started the program from a terminal did not ask for it.
    handler.handle(log.makeRecord(log.name, logging.INFO, "", 0, _beginning(), (), None))
    return path


def _beginning() -> str:
    """Return what stands first for each start: what runs, and what becomes of the file."""
    versions = f"Kagezou {__version__}, Python {sys.version.split()[0]}, Qt {qVersion()}, {system_words()}"
    return f"{versions}; this log stays on this computer, is sent nowhere, and may hold names of your files"
