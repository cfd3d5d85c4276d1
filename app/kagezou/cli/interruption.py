"""Ctrl-C and SIGTERM: a long job is asked to stop; a second time, and elsewhere, the program ends at once."""

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Final

_Handler = Callable[[int, FrameType | None], None]
_SIGNALS: Final = (signal.SIGINT, signal.SIGTERM)


class Interrupted(BaseException):
    """The program was told to end; ``exit_code`` is 128 and the number of the signal, as shells have it."""

    def __init__(self, number: int) -> None:
        super().__init__(number)
        self.exit_code = 128 + number


class Interruption:
    """Whether, and by which signal, the person asked to stop."""

    def __init__(self) -> None:
        self._number: int | None = None

    @property
    def is_asked(self) -> bool:
        """Whether the work should stop."""
        return self._number is not None

    def is_set(self) -> bool:
        """Return whether the work should stop, for those who want to be handed a function."""
        return self.is_asked

    @property
    def exit_code(self) -> int:
        """128 and the number of the signal; 0 without one."""
        return 0 if self._number is None else 128 + self._number

    def take(self, number: int, _frame: FrameType | None) -> None:
        """Take in a signal; the second one ends the program."""
        if self._number is not None:
            raise Interrupted(number)
        self._number = number


@contextmanager
def stopping_at_once() -> Iterator[None]:
    """Turn SIGINT and SIGTERM into `Interrupted` within the block."""

    def stop(number: int, _frame: FrameType | None) -> None:
        raise Interrupted(number)

    with _handled_by(stop):
        yield


@contextmanager
def stopping_gently() -> Iterator[Interruption]:
    """Note SIGINT and SIGTERM within the block instead of ending the program."""
    interruption = Interruption()
    with _handled_by(interruption.take):
        yield interruption


@contextmanager
def _handled_by(handler: _Handler) -> Iterator[None]:
    """Install a handler for the block; threads other than the first are never told of signals."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = {number: signal.signal(number, handler) for number in _SIGNALS}
    try:
        yield
    finally:
        for number, old in before.items():
            signal.signal(number, old)
