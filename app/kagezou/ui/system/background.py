"""Work beside the window: what it finds comes back on the window's thread, and nothing comes after the end."""

import threading
from collections import deque
from collections.abc import Callable
from functools import partial
from typing import Generic, TypeAlias, TypeVar

from PySide6.QtCore import QObject, QRunnable, Qt, QThread, QThreadPool, Signal

from kagezou.errors import Problem

T = TypeVar("T")


class Turn(Generic[T]):
    """What work may ask and tell while it is done; both on the worker's thread."""

    def __init__(self, tell: Callable[["Turn[T]", T], None]) -> None:
        self._tell = tell
        self._unwanted = threading.Event()

    @property
    def is_unwanted(self) -> bool:
        """Whether nobody waits for it any more: it should end soon, and nothing of it is delivered."""
        return self._unwanted.is_set()

    def tell(self, found: T) -> None:
        """Send something that was found to the window's thread."""
        self._tell(self, found)

    def give_up(self) -> None:
        """Want nothing of it any more."""
        self._unwanted.set()


Work: TypeAlias = Callable[[Turn[T]], None]
"""What is to be done; whatever it finds it tells its turn."""


def _nothing(_problem: Problem) -> None:
    """Leave a problem to whoever meets it in the window."""


class Queue(Generic[T]):
    """Carries out all that is asked for, one after the other in that order, on a thread of its own.

    It belongs to the thread it is made on, which is the window's, and all methods are called there. What is told and
    what goes wrong arrives through that thread's event loop. An exception that is no Problem is raised there, so that
    it goes where all go that nobody foresaw.

    Parameters
    ----------
    told
        Takes what was found.
    failed
        Takes a Problem; without it, who shows the same thing in the window says what is wrong with it.
    ended
        Told after each piece of work, also after one that failed.
    low_priority
        Whether the window goes first where the system can tell threads apart.
    """

    def __init__(
        self,
        told: Callable[[T], None],
        *,
        failed: Callable[[Problem], None] = _nothing,
        ended: Callable[[], None] = lambda: None,
        low_priority: bool = False,
    ) -> None:
        self._told, self._failed, self._ended = told, failed, ended
        self._delivery = _Delivery()
        self._lock = threading.Lock()
        self._waiting: deque[tuple[Turn[T], Work[T]]] = deque()
        self._has_thread = False
        self._open: set[Turn[T]] = set()
        self._is_finished = False
        self._pool = QThreadPool()
        self._pool.setMaxThreadCount(1)
        if low_priority:
            self._pool.setThreadPriority(QThread.Priority.LowPriority)

    @property
    def is_busy(self) -> bool:
        """Whether something that was asked for has not come to its end yet."""
        return bool(self._open)

    def ask(self, work: Work[T]) -> bool:
        """Have something done; false if nothing is done any more."""
        if self._is_finished:
            return False
        turn = Turn(self._tell)
        self._open.add(turn)
        with self._lock:
            self._waiting.append((turn, work))
            begins, self._has_thread = not self._has_thread, True
        if begins:
            self._pool.start(_Thread(self._carry_out))
        return True

    def drop(self) -> None:
        """Forget what has not begun, and want nothing more of what is being done or on its way."""
        with self._lock:
            dropped = [turn for turn, _ in self._waiting]
            self._waiting.clear()
        self._open.difference_update(dropped)
        for turn in self._open:
            turn.give_up()

    def wait(self) -> None:
        """Wait until all that was asked for is done; what it told is delivered later."""
        self._pool.waitForDone()

    def finish(self) -> None:
        """Wait until all that was asked for is done; nothing is delivered, and nothing done, afterwards."""
        self._is_finished = True
        self.wait()
        self._open.clear()

    def _carry_out(self) -> None:
        """Do what waits; on the worker's thread."""
        while (chosen := self._next()) is not None:
            turn, work = chosen
            error: BaseException | None = None
            try:
                work(turn)
            except BaseException as raised:  # raised again on the window's thread
                error = raised
            self._delivery.send(partial(self._end, turn, error))

    def _next(self) -> tuple[Turn[T], Work[T]] | None:
        with self._lock:
            chosen = self._waiting.popleft() if self._waiting else None
            self._has_thread = chosen is not None
            return chosen

    def _tell(self, turn: Turn[T], found: T) -> None:
        self._delivery.send(partial(self._deliver, turn, found))

    def _deliver(self, turn: Turn[T], found: T) -> None:
        if not self._is_finished and not turn.is_unwanted:
            self._told(found)

    def _end(self, turn: Turn[T], error: BaseException | None) -> None:
        if self._is_finished:
            return
        self._open.discard(turn)
        try:
            if isinstance(error, Problem):
                if not turn.is_unwanted:
                    self._failed(error)
            elif error is not None:
                raise error
        finally:
            self._ended()


class Latest(Queue[T]):
    """Carries out only what was asked for last: what is being done is given up for it, what waits is forgotten."""

    def ask(self, work: Work[T]) -> bool:
        """Have something done instead of all before; false if nothing is done any more."""
        self.drop()
        return super().ask(work)

    def finish(self) -> None:
        """Give up what is being done and wait for it to end; nothing is delivered, and nothing done, afterwards."""
        self.drop()
        super().finish()


class _Delivery(QObject):
    """Brings calls from any thread to the one it was made on."""

    _sent = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self._sent.connect(self._call, Qt.ConnectionType.QueuedConnection)

    def send(self, call: Callable[[], None]) -> None:
        """Have something called on the window's thread, after what was sent before."""
        self._sent.emit(call)

    def _call(self, call: Callable[[], None]) -> None:
        call()


class _Thread(QRunnable):
    """The pool's thread as long as there is something to do."""

    def __init__(self, run: Callable[[], None]) -> None:
        super().__init__()
        self._run = run

    def run(self) -> None:
        self._run()
