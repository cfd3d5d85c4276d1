"""Works in the window for minutes on end, and tells what it takes: edits, undo, playback, saving, reopening, exports.

::

    python3 packaging/dev.py endurance [--minutes MINUTES]

On Linux it has a screen of its own. Each minute is a line of a table; at the end a straight line is laid through the
second half of each column by least squares. The exit code is 1 where memory, descriptors or threads still grew then,
by more than the allocator of the system does.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields
from itertools import cycle
from pathlib import Path
from random import Random

import numpy as np
from PySide6.QtCore import QSettings, QTimer
from PySide6.QtWidgets import QApplication

from dev_display import private_display
from kagezou.cli.demo.stage import make_demo
from kagezou.document.address import Address
from kagezou.document.properties import GROUND_DECLINATION, LIGHT_POSITION, OPACITY, SOFTNESS
from kagezou.export.choices import ExportChoices
from kagezou.export.remembered import dumps_choices
from kagezou.ui.application import Application, make_application
from kagezou.ui.export.dialog import ExportDialog
from kagezou.ui.export.result import ExportResult
from kagezou.ui.system.settings import Settings

STEP_MS = 60
STEPS_A_ROUND = 90
ROUNDS_AN_EXPORT = 2
KINDS = ("layers", "video", "layered", "after effects")
COMMANDS = (
    "undo", "undo", "redo", "play", "play", "select_keys", "copy_keys", "paste_keys", "ease_both", "curves", "timeline",
    "zoom_in", "zoom_out", "fit", "handles", "handles", "copy_look", "paste_look",
)  # fmt: skip
"""What is chosen from the menus, those more often that stand here twice."""


@dataclass(frozen=True)
class Taken:
    """What the program has in use.

    Parameters
    ----------
    memory_mb
        Memory of the process.
    descriptors
        Files, sockets and pipes that are open.
    threads
        Threads of the process.
    widgets
        Widgets that Qt knows.
    """

    memory_mb: int
    descriptors: int
    threads: int
    widgets: int

    @classmethod
    def now(cls) -> Taken:
        """Count what this process has."""
        told = dict(line.split(":", 1) for line in Path("/proc/self/status").read_text("ascii").splitlines())
        return cls(
            int(told["VmRSS"].split()[0]) >> 10,
            len(list(Path("/proc/self/fd").iterdir())),
            int(told["Threads"]),
            len(QApplication.allWidgets()),
        )


MOST_GROWTH = {"memory_mb": 32.0, "descriptors": 4.0, "threads": 4.0, "widgets": 400.0}
"""How much a straight line through the second half may climb there."""


def growth(counts: Sequence[float]) -> float:
    """Return how far a straight line through the second half of what was counted climbs from its start to its end."""
    half = np.asarray(counts[len(counts) // 2 :], np.float64)
    if len(half) < 2:
        return 0.0
    slope = np.polyfit(np.arange(len(half)), half, 1)[0]
    return float(slope * (len(half) - 1))


def grown(told: Sequence[Taken]) -> dict[str, float]:
    """Return the columns that climb more than they may, and by how much."""
    climbs = {each.name: growth([getattr(row, each.name) for row in told]) for each in fields(Taken)}
    return {name: climb for name, climb in climbs.items() if climb > MOST_GROWTH[name]}


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
        self._kinds = cycle(KINDS)
        self._steps = self._rounds = self._exports = 0
        self._began_s = time.monotonic()
        self.told: list[Taken] = []
        self._timer = QTimer()
        self._timer.setInterval(STEP_MS)
        self._timer.timeout.connect(self._step)
        self._timer.start()

    def _step(self) -> None:
        if time.monotonic() - self._began_s >= 60 * (len(self.told) + 1):
            self._tell()
        parts = self._program.window.parts
        if parts.project.loading.is_running or parts.exporting.is_running:
            return
        for shown in self._program.window.findChildren(ExportResult):
            shown.close()
        if self._steps % STEPS_A_ROUND == 0:
            self._reopen()
        elif self._steps % (STEPS_A_ROUND * ROUNDS_AN_EXPORT) == STEPS_A_ROUND // 2:
            self._export()
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

    def _export(self) -> None:
        """Export one kind after the other, by the dialog, over what the last one of its kind made."""
        parts = self._program.window.parts
        parts.settings.set_word("export_plan", dumps_choices(ExportChoices(next(self._kinds))))
        parts.actions["export"].trigger()
        for dialog in self._program.window.findChildren(ExportDialog):
            dialog.go.click()
            self._exports += 1

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
        self.told.append(Taken.now())
        counts = [len(self.told), *(getattr(self.told[-1], each.name) for each in fields(Taken))]
        print("".join(f"{count:12}" for count in (*counts, self._steps, self._rounds, self._exports)), flush=True)
        if len(self.told) >= self._minutes:
            QApplication.exit(0)


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
        heads = ("minute", *(each.name for each in fields(Taken)), "steps", "projects", "exports")
        print("".join(f"{head:>12}" for head in heads), flush=True)
        worker = Worker(program, projects, minutes)
        application.exec()
        program.open_project.bridge.session.mark_saved()
        program.put_away()
    for each in fields(Taken):
        climb = growth([getattr(row, each.name) for row in worker.told])
        print(f"{each.name}: {climb:+.1f} over the second half, at most {MOST_GROWTH[each.name]:+.0f}")
    return int(bool(grown(worker.told)))


def main(arguments: list[str]) -> int:
    """Run on a screen of its own."""
    parser = argparse.ArgumentParser(prog="dev.py endurance", description="Work in the window, and tell what grows.")
    parser.add_argument("--minutes", type=int, default=60, help="how long (60)")
    minutes = parser.parse_args(arguments).minutes
    if os.environ.get("KAGEZOU_ENDURANCE"):
        return work(minutes)
    with private_display() as variables:
        command = [sys.executable, __file__, "--minutes", str(minutes)]
        return subprocess.call(command, env={**variables, "KAGEZOU_ENDURANCE": "1"})


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
