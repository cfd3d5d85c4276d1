"""What is left of a crash: one text file each beside the log, the newest few, for whoever helps.

Nothing is sent. Names of the user's home folder are left out.
"""

import faulthandler
import os
import secrets
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Final, TextIO

from kagezou.io.files.exclusive import locks
from kagezou.io.files.this_system import system_words
from kagezou.version import __version__

KEPT: Final = 5
"""So many reports stay; older ones go when another is written."""
LOG_NAME: Final = "window.log"
LOG_LINES: Final = 60
_TAIL_BYTES: Final = 16 << 10
_REPORT: Final = "crash-"
_RUNNING: Final = "running-"
_FATAL: Final = "\nended by the system or a library:\n"
"""Behind this line stands what Python writes as it is ended from outside its own code."""


def log_folder() -> Path:
    """Return the folder of the window's log."""
    import platformdirs

    return Path(platformdirs.user_log_path("kagezou", appauthor=False))


def report_folder() -> Path:
    """Return the folder of the reports."""
    return log_folder() / "crashes"


def reports_in(folder: Path) -> tuple[Path, ...]:
    """Return the reports that lie in a folder, the newest first; none where it cannot be read."""
    try:
        found = [each for each in folder.iterdir() if each.name.startswith(_REPORT)]
    except OSError:
        return ()
    return tuple(sorted(found, key=lambda each: each.name, reverse=True))


def write_report(story: str, about: Sequence[str], folder: Path | None = None) -> Path:
    """Write a report, and let the oldest go.

    Parameters
    ----------
    story
        What happened, such as a traceback.
    about
        What else is to be known, line by line.
    folder
        Where; by default the folder of all reports.

    Raises
    ------
    OSError
        The system refuses.
    """
    folder = folder or report_folder()
    folder.mkdir(parents=True, exist_ok=True)
    path = _new_name(folder)
    text = "\n".join([*_head(), *about, "", story.rstrip(), "", *_end_of_log()]) + "\n"
    with path.open("x", encoding="utf-8", errors="backslashreplace") as file:
        file.write(without_home(text))
    _sweep(folder)
    return path


@contextmanager
def watching_for_fatal_ends(words: Sequence[str], folder: Path | None = None) -> Iterator[None]:
    """Have Python write down where it was when a signal such as a segmentation fault ends it; see ``left_by_dead``.

    Does nothing where someone else listens for that already, or where the folder takes no file.

    Parameters
    ----------
    words
        What the program was called with.
    folder
        Where it is written; by default the folder of all reports.
    """
    stream = None if faulthandler.is_enabled() else _running_file(words, folder or report_folder())
    if stream is None:
        yield
        return
    with stream:
        faulthandler.enable(stream)
        try:
            yield
        finally:
            faulthandler.disable()
            # Windows removes no file that is open.
            if sys.platform != "win32":
                Path(stream.name).unlink(missing_ok=True)
    if sys.platform == "win32":
        with suppress(OSError):
            Path(stream.name).unlink(missing_ok=True)


def left_by_dead(folder: Path | None = None) -> tuple[Path, ...]:
    """Make reports of what programs left behind that were ended by a signal, and return them, the newest first."""
    folder = folder or report_folder()
    try:
        running = [path for path in folder.iterdir() if path.name.startswith(_RUNNING)]
    except OSError:
        return ()
    made = [report for path in running if (report := _taken_over(path))]
    if made:
        _sweep(folder)
    return tuple(sorted(made, key=lambda each: each.name, reverse=True))


def end_of(log: Path) -> list[str]:
    """Return the last lines of a log, or why there are none."""
    try:
        with log.open("rb") as stream:
            stream.seek(max(0, log.stat().st_size - _TAIL_BYTES))
            text = stream.read().decode("utf-8", "replace")
    except OSError as error:
        return [f"(it cannot be read: {error.strerror})"]
    return text.splitlines()[-LOG_LINES:]


def without_home(text: str) -> str:
    """Return a text in which the user's home folder is called ``~``."""
    home = str(Path.home())
    return text if len(home) < 2 else text.replace(home, "~")


def _running_file(words: Sequence[str], folder: Path) -> TextIO | None:
    """Open what a fatal signal is written to, locked as long as this program lives; None where that cannot be."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        path = folder / f"{_RUNNING}{os.getpid()}-{secrets.token_hex(16)}.txt"
        # At once and without a buffer, so that nothing is left to be written where the disk is full.
        path.write_text(
            without_home("\n".join([*_head(), f"called with: {list(words)!r}"])) + _FATAL, "utf-8", errors="replace"
        )
        stream = path.open("a", encoding="utf-8", errors="replace")
    except OSError:
        return None
    locks(stream.fileno())
    return stream


def _taken_over(path: Path) -> Path | None:
    """Return the report made of what a program left; None where it lives, or was ended without a word."""
    try:
        with path.open("r+", encoding="utf-8", errors="replace") as file:
            if not locks(file.fileno()):
                return None
            text, written_s = file.read(), os.fstat(file.fileno()).st_mtime
    except OSError:
        return None
    try:
        if not text.partition(_FATAL)[2].strip():
            path.unlink()
            return None
        return path.replace(_new_name(path.parent, written_s))
    except OSError:
        return None


def _new_name(folder: Path, at_s: float | None = None) -> Path:
    when = time.strftime("%Y%m%d-%H%M%S", time.localtime(at_s))
    return folder / f"{_REPORT}{when}-{secrets.token_hex(4)}.txt"


def _head() -> list[str]:
    return [
        f"Kagezou {__version__}, Python {sys.version.split()[0]}, {system_words()}",
        f"{time.strftime('%Y-%m-%d %H:%M:%S %z')}; this file stays on this computer, is sent nowhere, and may hold "
        "names of your files",
    ]


def _end_of_log() -> list[str]:
    log = log_folder() / LOG_NAME
    return [f"log: {log}", *end_of(log)]


def _sweep(folder: Path) -> None:
    for path in reports_in(folder)[KEPT:]:
        with suppress(OSError):
            path.unlink()
