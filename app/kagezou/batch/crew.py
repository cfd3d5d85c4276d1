"""Several cuts at a time, each in a process of its own: one that crashes or hangs takes only itself along."""

import os
import subprocess
import sys
import tempfile
import time
from collections import deque
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final, Protocol

from kagezou.batch.cut import Cut
from kagezou.io.files.memory import free_memory

LOOKING_S: Final = 0.1
_BYTES_OF_CUT: Final = 1 << 30
"""About so much memory a process takes for a cut of 1920 × 1080."""

_MOST_AT_ONCE: Final = 16
_PATIENCE_S: Final = 20.0
"""So long a process that was asked to stop has for the frames in hand."""


@dataclass(frozen=True, slots=True)
class Ended:
    """How the process of a cut ended.

    Parameters
    ----------
    cut
        The cut.
    code
        Its exit code; negative where a signal ended it.
    said
        Its last line on stderr.
    is_stuck
        Whether it was ended because nothing moved any more.
    is_stopped
        Whether it was asked to stop.
    """

    cut: Cut
    code: int
    said: str
    is_stuck: bool = False
    is_stopped: bool = False


class Watcher(Protocol):
    """Who is told of the crew's work."""

    def began(self, cut: Cut) -> None:
        """Take in that a cut is being made."""

    def ended(self, how: Ended) -> None:
        """Take in how it ended."""

    def moved(self, parts: float) -> None:
        """Take in how many cuts are being made and how far they are, as parts of whole ones."""


@dataclass(frozen=True, slots=True)
class Pace:
    """How a crew works.

    Parameters
    ----------
    at_once
        How many cuts at a time.
    stuck_s
        A process in which nothing moves for so long is ended, seconds.
    now, wait
        A clock in seconds, and what waits a while.
    """

    at_once: int
    stuck_s: float
    now: Callable[[], float] = time.monotonic
    wait: Callable[[float], None] = time.sleep


def fitting(cuts: int, processors: int) -> int:
    """Return how many cuts are made at a time on a machine with so many processors and the memory that is free."""
    free = free_memory()
    by_memory = _MOST_AT_ONCE if free is None else free // _BYTES_OF_CUT
    return max(min(cuts, processors, by_memory, _MOST_AT_ONCE), 1)


def work_through(
    cuts: Iterable[Cut],
    words_of: Callable[[Cut], Sequence[str]],
    pace: Pace,
    watcher: Watcher,
    cancelled: Callable[[], bool],
) -> None:
    """Make cuts, each by a command of its own; once it is cancelled none is begun, and those under way stop gently.

    Parameters
    ----------
    cuts
        What is made, in this order.
    words_of
        The command that makes a cut; it is given ``--progress-file FILE`` as well.
    """
    waiting, busy = deque(cuts), list[_Worker]()
    asked_at: float | None = None
    with tempfile.TemporaryDirectory(prefix="kagezou-") as folder:
        try:
            while busy or (waiting and not cancelled()):
                while waiting and len(busy) < pace.at_once and not cancelled():
                    cut = waiting.popleft()
                    watcher.began(cut)
                    busy.append(_Worker.begun(cut, words_of(cut), Path(folder), pace.now()))
                if cancelled():
                    asked_at = pace.now() if asked_at is None else asked_at
                    _ask_to_stop(busy, is_impatient=pace.now() - asked_at > _PATIENCE_S)
                for worker in tuple(busy):
                    if (how := worker.look(pace)) is not None:
                        busy.remove(worker)
                        watcher.ended(how)
                watcher.moved(sum(worker.part for worker in busy))
                if busy:
                    pace.wait(LOOKING_S)
        finally:
            for worker in busy:
                worker.kill()


def _ask_to_stop(workers: Iterable["_Worker"], *, is_impatient: bool) -> None:
    for worker in workers:
        if is_impatient:
            worker.kill()
        else:
            worker.stop()


@dataclass(slots=True)
class _Worker:
    """A process at work on a cut, and the file by which it tells how far it is."""

    cut: Cut
    process: subprocess.Popen[bytes]
    progress: Path
    errors: Path
    moved_at: float
    seen: tuple[str, ...] = ()
    part: float = 0.0
    is_stuck: bool = False
    is_stopped: bool = False

    @classmethod
    def begun(cls, cut: Cut, words: Sequence[str], folder: Path, now: float) -> "_Worker":
        """Begin with a cut."""
        descriptor, name = tempfile.mkstemp(suffix=".txt", dir=folder)
        errors = Path(name)
        progress = errors.with_suffix(".progress")
        with os.fdopen(descriptor, "wb") as stream:
            process = subprocess.Popen(
                [*words, "--progress-file", str(progress)],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=stream,
                # Ctrl-C in a terminal goes to everyone in it; here only the crew decides.
                start_new_session=sys.platform != "win32",
                creationflags=getattr(subprocess, "CREATE_NEW_PROCESS_GROUP", 0),
            )
        return cls(cut, process, progress, errors, now)

    def look(self, pace: Pace) -> Ended | None:
        """Return how it ended; None while it works. One in which nothing moves is ended."""
        code = self.process.poll()
        if code is not None:
            return Ended(self.cut, code, self._last_line(), self.is_stuck, self.is_stopped)
        seen = self._told()
        if seen != self.seen:
            self.seen, self.moved_at = seen, pace.now()
        elif pace.now() - self.moved_at > pace.stuck_s:
            self.is_stuck = True
            self.kill()
        return None

    def stop(self) -> None:
        """Ask it to stop after what it has in hand."""
        self.is_stopped = True
        self.progress.with_name(self.progress.name + ".stop").touch()

    def kill(self) -> None:
        """End it at once."""
        self.process.kill()
        self.process.wait()

    def _told(self) -> tuple[str, ...]:
        """Return how far it says it is."""
        try:
            lines = self.progress.read_text(encoding="utf-8", errors="replace").splitlines()
        except OSError:
            return self.seen
        told = dict(line.partition(": ")[::2] for line in lines)
        done, total = told.get("done", "0"), told.get("total", "0")
        if done.isdecimal() and total.isdecimal() and int(total):
            self.part = min(int(done) / int(total), 1.0)
        return done, total

    def _last_line(self) -> str:
        text = self.errors.read_bytes().decode("utf-8", "replace").strip()
        return text.rpartition("\n")[2].removeprefix("kagezou: ")
