"""Saving beside the window: a document is frozen, so it is written on a thread of its own while it is worked on."""

import threading
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject, QTimer, Signal
from PySide6.QtWidgets import QMessageBox, QWidget

from kagezou.errors import Problem
from kagezou.io.project import file as project_file
from kagezou.io.project.file_state import FileState
from kagezou.session.session import Session
from kagezou.ui.project.open_project import OpenProject, whole_name

PATIENCE_S = 0.3
"""So long a save is waited for before the window goes on: what is quick is done when the command is."""

LAST_WAIT_S = 10.0
_LOOK_EVERY_MS = 30


class _Job(threading.Thread):
    """Writes one document. A daemon: what hangs on a lost network disk leaves the old file and lets the program end."""

    def __init__(self, session: Session, path: Path) -> None:
        super().__init__(daemon=True, name="save")
        self.session, self.path = session, path
        self.point = session.save_point
        self.state: FileState | None = None
        self.problem: BaseException | None = None

    def run(self) -> None:
        try:
            self.state = project_file.save(self.point.document, self.path)
        except BaseException as problem:  # raised again on the window's thread
            self.problem = problem


class Saving(QObject):
    """Writes the open project, one document after the other; of what is asked for meanwhile the newest is written.

    Parameters
    ----------
    open_project
        The project.
    """

    changed = Signal()
    """Something is being written now, or nothing any more."""
    saved = Signal(Path)
    """The project lies there."""
    failed = Signal(object)
    """A Problem; the old file is still there."""

    def __init__(self, open_project: OpenProject) -> None:
        super().__init__()
        self._open_project = open_project
        self._job: _Job | None = None
        self._next: Path | None = None
        self._timer = QTimer(self)
        self._timer.setInterval(_LOOK_EVERY_MS)
        self._timer.timeout.connect(self._look)

    @property
    def path(self) -> Path | None:
        """What is being written; None while nothing is."""
        return self._job.path if self._job else None

    @property
    def is_running(self) -> bool:
        """Whether something is being written."""
        return self._job is not None

    @property
    def is_saved(self) -> bool:
        """Whether the project lies on the disk as it is now, and nothing more is being written."""
        return not self.is_running and self._open_project.is_saved

    def start(self, path: Path) -> bool:
        """Write the project as it is now, and what is being written first; false if it turned out at once to fail."""
        if self._job is not None:
            self._next = whole_name(path)
            return True
        return self._begin(whole_name(path))

    def wait(self, longest_s: float | None = None) -> None:
        """Wait until everything is written, or so long for each file that is."""
        while (job := self._job) is not None:
            job.join(longest_s)
            if job.is_alive():
                return
            self._finish(job)

    def _begin(self, path: Path) -> bool:
        job = self._job = _Job(self._open_project.bridge.session, path)
        job.start()
        job.join(PATIENCE_S)
        if not job.is_alive():
            return self._finish(job)
        self._timer.start()
        self.changed.emit()
        return True

    def _look(self) -> None:
        if self._job is not None and not self._job.is_alive():
            self._finish(self._job)

    def _finish(self, job: _Job) -> bool:
        """Take for saved what was written, or say why it was not, and write what was asked for meanwhile."""
        self._job = None
        self._timer.stop()
        path, self._next = self._next, None
        try:
            if isinstance(job.problem, Problem):
                self.failed.emit(job.problem)
            elif job.problem is not None:
                raise job.problem
            else:
                self._take(job)
        finally:
            if path is not None and not (path == job.path and self._open_project.is_saved):
                self._begin(path)
            self.changed.emit()
        return job.problem is None

    def _take(self, job: _Job) -> None:
        assert job.state is not None
        if job.session is self._open_project.bridge.session:
            self._open_project.take_saved(job.point, job.path, job.state)
        self.saved.emit(job.path)


def is_saved_by_now(saving: Saving, parent: QWidget) -> bool:
    """Return whether all is saved, and say that it is being written as long as it is; who will not wait ends that."""
    if saving.path is not None:
        _wait(saving, saving.path, parent)
    return saving.is_saved


def _wait(saving: Saving, path: Path, parent: QWidget) -> None:
    question = QCoreApplication.translate("Dialogs", "“%1” is being saved.").replace("%1", path.name)
    note = QCoreApplication.translate("Dialogs", "This goes on by itself as soon as it is written.")
    box, cancel = QMessageBox(parent), QMessageBox.StandardButton.Cancel
    box.setWindowTitle("Kagezou")
    box.setText(question)
    box.setInformativeText(note)
    box.setStandardButtons(cancel)
    box.button(cancel).setText(QCoreApplication.translate("Dialogs", "Cancel"))
    look = QTimer(box)
    look.timeout.connect(lambda: None if saving.is_running else box.accept())
    look.start(_LOOK_EVERY_MS)
    box.exec()
