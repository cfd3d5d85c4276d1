"""Works in the window for minutes on end, and tells what memory it takes: edits, undo, playback, saving, reopening.

::

    .venv/bin/python packaging/dev_endurance.py [MINUTES]

On Linux it has a screen of its own. Each minute is one line; the exit code is 1 where memory still grew after the first
five minutes.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from random import Random

from PySide6.QtCore import QSettings, QTimer
from PySide6.QtWidgets import QApplication

from dev_display import private_display
from kagezou.cli.demo.stage import make_demo
from kagezou.document.address import Address
from kagezou.document.properties import GROUND_DECLINATION, LIGHT_POSITION, OPACITY, SOFTNESS
from kagezou.ui.application import Application, make_application
from kagezou.ui.system.settings import Settings

SETTLED_AFTER = 5
"""Minutes in which caches fill."""
MOST_GROWTH_MB = 32
"""More than this between then and the end is growth; less is what the allocator of the system does."""
STEP_MS = 60
STEPS_A_ROUND = 90
COMMANDS = (
    "undo", "undo", "redo", "play", "play", "select_keys", "copy_keys", "paste_keys", "ease_both", "curves", "timeline",
    "zoom_in", "zoom_out", "fit", "handles", "handles", "copy_look", "paste_look",
)  # fmt: skip
"""What is chosen from the menus, those more often that stand here twice."""


class Worker:
    """Somebody who works: a step every few hundredths of a second, another project every round.

    Parameters
    ----------
    program
        The program.
    projects
        What is opened in turn.
    minutes
        How long.
    """

    def __init__(self, program: Application, projects: list[Path], minutes: int) -> None:
        self._program, self._projects, self._minutes = program, projects, minutes
        self._random = Random(7)
        self._steps = self._rounds = 0
        self._began_s = time.monotonic()
        self.told_mb: list[int] = []
        self._timer = QTimer()
        self._timer.setInterval(STEP_MS)
        self._timer.timeout.connect(self._step)
        self._timer.start()

    def _step(self) -> None:
        if time.monotonic() - self._began_s >= 60 * (len(self.told_mb) + 1):
            self._tell()
        parts = self._program.window.parts
        if parts.project.loading.is_running:
            return
        if self._steps % STEPS_A_ROUND == 0:
            self._reopen()
        else:
            do: Callable[[], object] = self._random.choice((self._edit, self._edit, self._go, self._command))
            do()
        self._steps += 1

    def _reopen(self) -> None:
        """Save what there is and open the next project, now and then in another language."""
        open_project, parts = self._program.open_project, self._program.window.parts
        if open_project.path is not None:
            open_project.save(open_project.path)
        self._rounds += 1
        if self._rounds % 6 == 0:
            parts.time.player.stop()
            self._program.speak("ja" if self._rounds % 12 else "en")
        parts = self._program.window.parts
        parts.project.open_path(self._projects[self._rounds % len(self._projects)])

    def _edit(self) -> None:
        """Type another value for a property in the inspector, or key it."""
        bridge = self._program.open_project.bridge
        prop = self._random.choice((GROUND_DECLINATION, LIGHT_POSITION, OPACITY, SOFTNESS))
        rows = [row for row in self._program.window.parts.panels.inspector.rows if row.address.property is prop]
        if not rows:
            return
        row, chance = rows[0], self._random.random()
        if chance < 0.2:
            row.edited.toggle_key()
        elif prop is LIGHT_POSITION:
            row.enter((self._random.uniform(-400, 400), self._random.uniform(-500, -50), self._random.uniform(80, 600)))
        else:
            low, high = (20.0, 80.0) if prop is GROUND_DECLINATION else (0.1, 1.0)
            row.enter(self._random.uniform(low, high))
        if chance > 0.95 and bridge.layer_id is not None:
            bridge.session.select(bridge.layer_id, (Address(LIGHT_POSITION),))

    def _go(self) -> None:
        bridge = self._program.open_project.bridge
        bridge.session.go_to(self._random.randint(1, bridge.document.canvas.length_frames))

    def _command(self) -> None:
        action = self._program.window.parts.actions[self._random.choice(COMMANDS)]
        if action.isEnabled():
            action.trigger()

    def _tell(self) -> None:
        self.told_mb.append(memory_mb())
        steps = f"{self._steps} steps, {self._rounds} projects opened, {len(QApplication.allWidgets())} widgets"
        print(f"minute {len(self.told_mb):2}: {self.told_mb[-1]} MB, {steps}", flush=True)
        if len(self.told_mb) >= self._minutes:
            QApplication.exit(0)


def memory_mb() -> int:
    """Return the memory that this process has in use."""
    lines = Path("/proc/self/status").read_text("ascii").splitlines()
    return next(int(line.split()[1]) >> 10 for line in lines if line.startswith("VmRSS"))


def work(minutes: int) -> int:
    """Work, and return the exit code."""
    with tempfile.TemporaryDirectory(prefix="kagezou-endurance-") as made:
        folder = Path(made)
        projects = [make_demo(folder / name, 2, lambda *_: None).project for name in ("one", "two")]
        application = make_application()
        store = QSettings(str(folder / "settings.ini"), QSettings.Format.IniFormat)
        own = [folder / name for name in ("styles", "unsaved", "pictures", "spare")]
        program = Application(application, Settings(store, *own))
        program.show()
        worker = Worker(program, projects, minutes)
        application.exec()
        program.open_project.bridge.session.mark_saved()
        program.put_away()
    settled = worker.told_mb[min(SETTLED_AFTER, len(worker.told_mb)) - 1]
    grown = worker.told_mb[-1] - settled
    print(f"{grown:+} MB after the first {SETTLED_AFTER} minutes")
    return int(grown > MOST_GROWTH_MB)


def main(arguments: list[str]) -> int:
    """Run on a screen of its own."""
    if os.environ.get("KAGEZOU_ENDURANCE"):
        return work(int(arguments[0]))
    with private_display() as variables:
        command = [sys.executable, __file__, *(arguments or ["20"])]
        return subprocess.call(command, env={**variables, "KAGEZOU_ENDURANCE": "1"})


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
