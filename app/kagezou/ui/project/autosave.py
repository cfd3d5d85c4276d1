"""Unsaved work is put aside a moment after each step, in a folder of the user's own and never in the project."""

from collections.abc import Callable
from pathlib import Path
from time import monotonic

from PySide6.QtCore import QCoreApplication, QObject, QTimer, Signal

from kagezou.document.model import Document
from kagezou.errors import Problem
from kagezou.io.project import recovery_file
from kagezou.io.project.recovery_file import RecoveredWork
from kagezou.ui.project.keepsakes import Keepsakes, Kept
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.system.background import Queue, Turn
from kagezou.ui.system.words import translated

SHORTLY_MS = 1000
"""So long after a step the work is put aside; all steps made until then come with it."""
PAUSE = 10
"""The pause between two times is so many times as long as the last one took: a large project is not written always."""
RETRY_MS = (2_000, 5_000, 15_000, 30_000, 60_000)
"""The pauses before what failed is tried again; the last one again and again."""


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
    spare
        Where they lie while the folder takes none.
    """

    failed = Signal(str)
    """Nothing was kept; a sentence. It is tried again."""
    kept_elsewhere = Signal(str)
    """The work was kept, but not where it is meant to be; a sentence."""
    kept = Signal()
    """All is well: the work was kept, or there is none that would have to be."""

    def __init__(
        self, open_project: OpenProject, folder: Path, name: Callable[[], str], spare: Path | None = None
    ) -> None:
        super().__init__()
        self._open_project, self._name = open_project, name
        self._keepsakes = Keepsakes((folder,) if spare is None else (folder, spare))
        self._asked: Document | None = None
        self._failures, self._may_not_before_s = 0, 0.0
        # One after the other, so that what is forgotten last stays forgotten.
        self._background = Queue[Kept | None](self._take, failed=self._fail)
        self._shortly = QTimer(self)
        self._shortly.setSingleShot(True)
        self._shortly.timeout.connect(self.keep)
        bridge = open_project.bridge
        bridge.document_changed.connect(self._keep_shortly)
        bridge.saved_changed.connect(lambda saved: self.forget() if saved else self._keep_shortly())
        bridge.session_replaced.connect(self.forget)

    @property
    def file(self) -> Path:
        """Where unsaved work is kept."""
        return self._keepsakes.file

    @property
    def retry_ms(self) -> int:
        """How soon what failed is tried again; 0 while nothing failed."""
        return RETRY_MS[min(self._failures, len(RETRY_MS)) - 1] if self._failures else 0

    @property
    def is_waiting(self) -> bool:
        """Whether something will be kept by itself."""
        return self._shortly.isActive()

    def adopt(self, file: Path) -> None:
        """Keep the work now that was brought back from a file; the file goes once it lies elsewhere, read back."""
        self._background.wait()
        self._keepsakes.adopt(file)
        self.keep()

    def keep(self) -> None:
        """Put the work aside now, unless it is saved or was put aside as it is."""
        document = self._open_project.bridge.document
        if self._open_project.is_saved or document is self._asked:
            return
        session = self._open_project.bridge.session
        self._asked = document
        self._shortly.stop()
        edits = max(session.history.since_saved, 1)
        path, seen = self._open_project.path, self._open_project.seen
        work = RecoveredWork(document, self._name(), path, recovery_file.now_s(), edits, seen)
        self._do(lambda: self._keepsakes.keep(work))

    def forget(self) -> None:
        """Remove what was put aside: the work is saved, or was given up."""
        self._asked = None
        self._failures = 0
        self._shortly.stop()
        self._do(self._keepsakes.forget)

    def finish(self, *, leave: bool = False) -> None:
        """Wait until everything is done, as the program ends.

        Parameters
        ----------
        leave
            Leave unsaved work where it is found again, as nobody was asked whether it may go.
        """
        if leave:
            self.keep()
        else:
            self.forget()
        self._shortly.stop()
        self._background.finish()
        self._keepsakes.release()

    def wait(self) -> None:
        """Wait until what is being put aside lies on disk."""
        self._background.wait()

    def _do(self, do: Callable[[], Kept | None]) -> None:
        def work(turn: Turn[Kept | None]) -> None:
            began_s = monotonic()
            kept = do()
            ended_s = monotonic()
            self._may_not_before_s = ended_s + PAUSE * (ended_s - began_s)
            turn.tell(kept)

        self._background.ask(work)

    def _take(self, kept: Kept | None) -> None:
        self._failures = 0
        if kept is not None and kept.refused is not None:
            words = QCoreApplication.translate("Autosave", "Unsaved work is put aside in %1 for now: %2")
            folder = str(kept.file.parent)
            self.kept_elsewhere.emit(words.replace("%1", folder).replace("%2", translated(kept.refused)))
        else:
            self.kept.emit()
        self._keep_shortly()

    def _fail(self, problem: Problem) -> None:
        self._asked = None
        if self._open_project.is_saved:
            # What could not be removed is no work of anybody's; it is offered, and can be discarded, at the next start.
            self.failed.emit(translated(problem))
            return
        self._failures += 1
        words = QCoreApplication.translate(
            "Autosave", "Unsaved work cannot be put aside (%1). It is tried again; save your project meanwhile."
        )
        self.failed.emit(words.replace("%1", translated(problem)))
        self._shortly.start(self.retry_ms)

    def _keep_shortly(self) -> None:
        is_kept = self._open_project.is_saved or self._open_project.bridge.document is self._asked
        if not is_kept and not self._shortly.isActive():
            self._shortly.start(max(SHORTLY_MS, round(1000 * (self._may_not_before_s - monotonic()))))
