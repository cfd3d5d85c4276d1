"""Opening the demo: made by someone else beside the window the first time, then opened like any project."""

from collections.abc import Callable
from pathlib import Path
from typing import TypeAlias

from platformdirs import user_data_path
from PySide6.QtCore import QObject

from kagezou.errors import Problem
from kagezou.ui.system.background import Queue, Turn
from kagezou.ui.system.words import translated
from kagezou.ui.widgets.message_bar import MessageBar, Severity

MakeDemo: TypeAlias = Callable[[Path, Callable[[int, int], None]], Path]
"""Makes the demo's files in a folder, telling how many of how many are done, and returns the project."""

_KEY = "demo"
_PROJECT = "demo.kage"


def demo_folder() -> Path:
    """Return where the demo is kept between two runs."""
    return user_data_path("kagezou", appauthor=False) / "demo"


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
        self._background = Queue[tuple[int, int] | Path](self._take, failed=self._say)

    @property
    def project(self) -> Path:
        """The demo's project, made or not."""
        return self._folder / _PROJECT

    def open(self) -> None:
        """Open the demo, after making it where that is needed."""
        if self.project.is_file():
            self._open_path(self.project)
        elif not self._background.is_busy:
            self._background.ask(self._make_project)

    def finish(self) -> None:
        """Wait until nothing is made any more, before the window goes."""
        self._background.finish()

    def _make_project(self, turn: Turn[tuple[int, int] | Path]) -> None:
        turn.tell(self._make(self._folder, lambda done, whole: turn.tell((done, whole))))

    def _take(self, told: tuple[int, int] | Path) -> None:
        if isinstance(told, Path):
            self._open_made(told)
        else:
            self._say_progress(*told)

    def _say(self, problem: Problem) -> None:
        self._bar.say(_KEY, translated(problem))

    def _say_progress(self, done: int, whole: int) -> None:
        words = self.tr("Drawing the demo: %1 of %2")
        self._bar.say(_KEY, words.replace("%1", str(done)).replace("%2", str(whole)), Severity.NOTE)

    def _open_made(self, project: Path) -> None:
        self._bar.withdraw(_KEY)
        self._open_path(project)
