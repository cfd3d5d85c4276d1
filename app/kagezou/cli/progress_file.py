"""What a program that waits reads of how far the work is: a small file, and another by which it asks to stop.

The file has lines of ``name: value``: ``state`` (running, done, failed or stopped), ``done`` and ``total`` steps,
``beat``, which counts seconds while the program lives, ``exit``, the exit code, and ``said`` for each line that a
person was told, the last ones. It is UTF-8, and whole whenever it is read. Where a file of the same name with ``.stop``
behind it appears, the work stops as after Ctrl-C.
"""

import _thread
import contextlib
import os
import signal
import sys
import threading
import time
from collections import deque
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Final, TextIO

from kagezou.errors import UsageProblem
from kagezou.message import Message

OPTION: Final = "--progress-file"
_STOP: Final = ".stop"
_EVERY_S: Final = 0.2
_LOOKING_S: Final = 0.2
_KEPT_LINES: Final = 40
_TRIES: Final = 25
"""On Windows a file that someone is reading cannot be replaced; for the last state it is tried so often."""


class ProgressFile:
    """The file of one run of the program; used as a context manager by whoever runs it.

    Parameters
    ----------
    path
        The file. Its folder must be there.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self._lock = threading.Lock()
        self._over = threading.Event()
        self._told: deque[str] = deque(maxlen=_KEPT_LINES)
        self._done, self._total, self._beat = 0, 0, 0
        self._written_at = 0.0
        self._stderr: TextIO | None = None

    def __enter__(self) -> "ProgressFile":
        self.stop_file.unlink(missing_ok=True)
        self._write("running", 1)
        self._stderr = sys.stderr
        sys.stderr = _Heard(self._stderr, self._hear)
        threading.Thread(target=self._live, name="progress file", daemon=True).start()
        return self

    def __exit__(self, *_: object) -> None:
        self._over.set()
        if self._stderr is not None:
            sys.stderr = self._stderr

    @property
    def stop_file(self) -> Path:
        """What whoever waits makes to have the work stopped."""
        return self._path.with_name(self._path.name + _STOP)

    def update(self, done: int, total: int) -> None:
        """Tell that ``done`` of ``total`` steps are finished; written at most five times a second."""
        self._done, self._total = done, total
        if time.monotonic() - self._written_at >= _EVERY_S:
            self._write("running", 1)

    def end(self, code: int) -> None:
        """Tell how it ended, by the exit code."""
        self._over.set()
        state = "done" if code == 0 else "stopped" if code >= 128 else "failed"
        self._write(state, _TRIES, code)
        self.stop_file.unlink(missing_ok=True)

    def _live(self) -> None:
        """Count on while the work goes on, and pass on that it is to stop."""
        began = time.monotonic()
        while not self._over.wait(_LOOKING_S):
            beat = int(time.monotonic() - began)
            if self.stop_file.exists():
                _thread.interrupt_main(signal.SIGINT)
                self.stop_file.unlink(missing_ok=True)
            if beat > self._beat:
                self._beat = beat
                self._write("running", 1)

    def _hear(self, line: str) -> None:
        self._told.append(line)

    def _write(self, state: str, tries: int, code: int | None = None) -> None:
        """Write all of it; a state that goes on may be skipped, for the next one follows."""
        with self._lock:
            if self._over.is_set() and code is None:
                return
            self._written_at = time.monotonic()
            lines = [f"state: {state}", f"done: {self._done}", f"total: {self._total}", f"beat: {self._beat}"]
            lines += [] if code is None else [f"exit: {code}"]
            lines += [f"said: {line}" for line in self._told]
            data = "".join(f"{line}\n" for line in lines).encode("utf-8", "replace")
            aside = self._path.with_name(f"{self._path.name}.{os.getpid()}")
            for left in reversed(range(tries)):
                try:
                    aside.write_bytes(data)
                    aside.replace(self._path)
                    return
                except OSError:
                    if left:
                        time.sleep(_EVERY_S)
            with contextlib.suppress(OSError):
                aside.unlink(missing_ok=True)


def taken_out(words: Sequence[str]) -> tuple[list[str], Path | None]:
    """Return the words of a command line without the option and its file, and the file; None where it is not there.

    Raises
    ------
    UsageProblem
        The option has no file behind it, or its folder is not there.
    """
    if OPTION not in words:
        return list(words), None
    at = list(words).index(OPTION)
    if at + 1 == len(words) or not words[at + 1]:
        raise UsageProblem(Message("{option} needs a file", option=OPTION))
    path = Path(words[at + 1])
    if not path.absolute().parent.is_dir():
        raise UsageProblem(Message("{option} {file}: its folder is not there", option=OPTION, file=words[at + 1]))
    return [*words[:at], *words[at + 2 :]], path


class _Heard:
    """A stream that whole lines are also taken from."""

    def __init__(self, stream: TextIO, hear: Callable[[str], None]) -> None:
        self._stream, self._hear, self._line = stream, hear, ""

    def write(self, text: str) -> int:
        """Write on, and hand over the lines that are whole by now."""
        *whole, self._line = (self._line + text).split("\n")
        for line in whole:
            # A line that is drawn again and again is for a person who watches.
            if "\r" not in line and line:
                self._hear(line)
        return self._stream.write(text)

    def __getattr__(self, name: str) -> object:
        return getattr(self._stream, name)
