"""The lines by which a session of Open Job Description follows a task: progress, status and failure, on stdout."""

import sys
import time
from typing import TYPE_CHECKING, TextIO

from kagezou.message import Message

if TYPE_CHECKING:
    from kagezou.export.request import Summary

_EVERY_S = 0.5


class JobLines:
    """Progress for a farm's session, in the place of the line for people; used as a context manager like that.

    Parameters
    ----------
    stream
        Where the session listens.
    """

    def __init__(self, stream: TextIO | None = None) -> None:
        self._stream = stream or sys.stdout
        self._told_at = 0.0

    def __enter__(self) -> "JobLines":
        self._tell("status", "Opening OpenGL")
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, _trace: object) -> None:
        if kind is not None and error is not None:
            self._tell("fail", str(error) or kind.__name__)

    def update(self, done: int, total: int) -> None:
        """Tell that ``done`` of ``total`` files are finished; at most twice a second, and the last one."""
        now = time.monotonic()
        if now - self._told_at >= _EVERY_S or done >= total:
            self._told_at = now
            self._tell("progress", f"{100 * done / max(total, 1):.1f}")
            self._tell("status", f"{done} of {total} files")

    def say(self, words: Message) -> None:
        """Tell what is worth knowing of the task."""
        self._tell("status", str(words))

    def sum_up(self, summary: "Summary") -> None:
        """Tell what is worth knowing of what was made, and why the task is not whole where it is not."""
        for sentence in summary.notes:
            self.say(sentence)
        for failure in summary.failures[:1]:
            self._tell("fail", str(failure.message))

    def _tell(self, what: str, text: str) -> None:
        # A session reads line by line: one sentence is one line.
        self._stream.write(f"openjd_{what}: {' '.join(text.split())}\n")
        self._stream.flush()
