"""Opening the demo: made by someone else beside the window the first time, then opened like any project."""

from collections.abc import Callable
from pathlib import Path
from typing import TypeAlias

from platformdirs import user_data_path
from PySide6.QtCore import QObject, QThread, Signal

from kagezou.errors import Problem
from kagezou.ui.system.words import translated
from kagezou.ui.widgets.message_bar import MessageBar, Severity

MakeDemo: TypeAlias = Callable[[Path, Callable[[int, int], None]], Path]
"""Makes the demo's files in a folder, telling how many of how many are done, and returns the project."""

_KEY = "demo"
_PROJECT = "demo.kage"


def demo_folder() -> Path:
    """Return where the demo is kept between two runs."""
    return user_data_path("kagezou", appauthor=False) / "demo"


class DemoJob(QThread):
    """Makes the demo.

    Parameters
    ----------
    make
        Who makes it.
    folder
        Where it is made.
    """

    progressed = Signal(int, int)
    made = Signal(Path)
    failed = Signal(str)

    def __init__(self, make: MakeDemo, folder: Path) -> None:
        super().__init__()
        self._make = make
        self._folder = folder

    def run(self) -> None:
        try:
            project = self._make(self._folder, self.progressed.emit)
        except Problem as problem:
            self.failed.emit(translated(problem))
        else:
            self.made.emit(project)


class DemoOpener(QObject):
    """Makes the demo where there is none yet, then has it opened.

    Parameters
    ----------
    make
        Who makes it.
    bar
        Where progress and problems are said.
    open_path
        Opens a project.
    folder
        Where the demo is kept.
    """

    def __init__(
        self, make: MakeDemo, bar: MessageBar, open_path: Callable[[Path], object], folder: Path | None = None
    ) -> None:
        super().__init__()
        self._make = make
        self._bar = bar
        self._open_path = open_path
        self._folder = folder or demo_folder()
        self._job: DemoJob | None = None

    def open(self) -> None:
        """Open the demo, after making it where that is needed."""
        project = self._folder / _PROJECT
        if project.is_file():
            self._open_path(project)
        elif self._job is None:
            self._job = DemoJob(self._make, self._folder)
            self._job.progressed.connect(self._say_progress)
            self._job.made.connect(self._open_made)
            self._job.failed.connect(lambda sentence: self._bar.say(_KEY, sentence))
            self._job.finished.connect(self._end)
            self._job.start()

    def finish(self) -> None:
        """Wait until nothing is made any more, before the window goes."""
        if self._job is not None:
            self._job.wait()

    def _say_progress(self, done: int, whole: int) -> None:
        words = self.tr("Drawing the demo: %1 of %2")
        self._bar.say(_KEY, words.replace("%1", str(done)).replace("%2", str(whole)), Severity.NOTE)

    def _open_made(self, project: Path) -> None:
        self._bar.withdraw(_KEY)
        self._open_path(project)

    def _end(self) -> None:
        self._job = None
