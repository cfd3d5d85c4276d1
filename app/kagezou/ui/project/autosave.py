"""Unsaved work is put aside every two minutes and after so many steps, beside the window and never in the project."""

from collections.abc import Callable
from pathlib import Path
from uuid import uuid4

from PySide6.QtCore import QLockFile, QObject, QTimer, Signal

from kagezou.document.model import Document
from kagezou.errors import Problem
from kagezou.io.project import recovery_file
from kagezou.io.project.recovery_file import SUFFIX, RecoveredWork
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.system.background import Queue, Turn
from kagezou.ui.system.words import translated

EVERY_MS = 120_000
EVERY_STEPS = 20
_SHORTLY_MS = 1500
"""The hand rests first: no writing in the middle of a drag."""


class Autosave(QObject):
    """Keeps the open project's unsaved work; a saved or given-up project leaves nothing behind.

    Parameters
    ----------
    open_project
        The project.
    folder
        Where keepsakes lie.
    name
        What the window calls the project.
    """

    failed = Signal(str)
    kept = Signal()

    def __init__(self, open_project: OpenProject, folder: Path, name: Callable[[], str]) -> None:
        super().__init__()
        self._open_project, self._folder, self._name = open_project, folder, name
        self._file = folder / f"{uuid4().hex}{SUFFIX}"
        self._lock: QLockFile | None = None
        self._kept: Document | None = None
        self._kept_at = 0
        # One after the other, so that what is forgotten last stays forgotten.
        self._background = Queue[None](lambda _: self.kept.emit(), failed=self._say)
        self._regularly, self._shortly = QTimer(self), QTimer(self)
        self._regularly.setInterval(EVERY_MS)
        self._regularly.timeout.connect(self.keep)
        self._regularly.start()
        self._shortly.setSingleShot(True)
        self._shortly.setInterval(_SHORTLY_MS)
        self._shortly.timeout.connect(self.keep)
        open_project.bridge.document_changed.connect(self._count)
        open_project.bridge.saved_changed.connect(lambda saved: self.forget() if saved else None)
        open_project.bridge.session_replaced.connect(self._begin_anew)

    @property
    def file(self) -> Path:
        """Where unsaved work is kept."""
        return self._file

    def keep(self) -> None:
        """Put the work aside now, unless it is saved or was put aside as it is."""
        document = self._open_project.bridge.document
        if self._open_project.is_saved or document is self._kept:
            return
        session = self._open_project.bridge.session
        self._kept, self._kept_at = document, session.steps_made
        self._hold_lock()
        path = self._open_project.path
        work = RecoveredWork(document, self._name(), path, recovery_file.now_s(), max(session.steps_since_saved, 1))
        self._do(lambda: recovery_file.keep(self._file, work))

    def forget(self) -> None:
        """Remove what was put aside: the work is saved, or was given up."""
        if self._kept is not None:
            self._kept = None
            self._do(lambda: recovery_file.forget(self._file))
        self._shortly.stop()

    def finish(self) -> None:
        """Forget, and wait until everything is done: the program ends as it should."""
        self._regularly.stop()
        self.forget()
        self._background.finish()
        if self._lock is not None:
            self._lock.unlock()
            self._lock = None

    def wait(self) -> None:
        """Wait until what is being put aside lies on disk."""
        self._background.wait()

    def _do(self, do: Callable[[], object]) -> None:
        def work(turn: Turn[None]) -> None:
            do()
            turn.tell(None)

        self._background.ask(work)

    def _say(self, problem: Problem) -> None:
        self.failed.emit(translated(problem))

    def _count(self) -> None:
        if self._open_project.bridge.session.steps_made - self._kept_at >= EVERY_STEPS:
            self._shortly.start()

    def _begin_anew(self) -> None:
        self.forget()
        self._kept_at = 0

    def _hold_lock(self) -> None:
        """Tell other running programs that this work is not lost; the lock goes with this process."""
        if self._lock is None:
            self._folder.mkdir(parents=True, exist_ok=True)
            self._lock = QLockFile(str(lock_of(self._file)))
            self._lock.setStaleLockTime(0)
            self._lock.tryLock(0)


def lock_of(file: Path) -> Path:
    """Return the lock that the program which keeps this work holds."""
    return file.with_suffix(".lock")


def left_behind(folder: Path) -> tuple[Path, ...]:
    """Return the keepsakes of programs that are gone without saying goodbye, the latest first."""
    return tuple(file for file in recovery_file.recovery_files_in(folder) if _is_abandoned(file))


def _is_abandoned(file: Path) -> bool:
    lock = QLockFile(str(lock_of(file)))
    lock.setStaleLockTime(0)
    # Qt itself finds out whether the process that held the lock still lives.
    taken = lock.tryLock(0)
    if taken:
        lock.unlock()
    return taken
