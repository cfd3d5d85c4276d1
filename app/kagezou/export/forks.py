"""An export that several processes share: forks of one, each with an OpenGL and a Python of its own.

Python runs one thread at a time, so that threads alone leave a second processor half idle. Forks know all that is
imported and planned; from one pipe all of them take what is still to be made, and each tells by a pipe of its own what
it has made. Whatever becomes of one of them, nothing waits for it: its pipe ends, and what it did not tell of is made
by the first.
"""

import os
import pickle
import select
import signal
import struct
import sys
from collections import deque
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import closing, contextmanager, suppress
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path
from types import TracebackType
from typing import Final, Generic, Self

from kagezou.document.model import Document
from kagezou.export.pipeline import Made, Outcome, PipelineSteps, flow
from kagezou.export.planning import PIXEL_BYTES, FrameJob
from kagezou.export.request import Cancelled
from kagezou.io.files.memory import free_memory
from kagezou.io.files.processors import processors
from kagezou.message import Message

_WORTH_ONE: Final = 6
"""Frames that are drawn sooner by a process that has to set up its drawing first."""

_BYTES_OF_ONE: Final = 256 << 20
"""About so much memory a process takes beside the pictures of the canvas."""

_PICTURES: Final = 8
"""Of the size of the canvas are drawn, decoded and encoded at a time."""

_AHEAD: Final = 2
"""Jobs a process takes before it needs them: more would leave another without work at the end."""

_TOKEN: Final = struct.Struct("<I")
_LENGTH: Final = struct.Struct("<I")
_DRIVER_THREADS: Final = "LP_NUM_THREADS"
"""What Mesa asks for the number of threads that draw for a process, where no graphics card does."""


@dataclass(frozen=True, slots=True)
class Sharing:
    """How an export goes: threads that decode and encode, jobs that may wait for them, and processes."""

    workers: int
    window: int
    processes: int = 1


def processes_for(document: Document, jobs: Sequence[FrameJob], most: int) -> int:
    """Return how many processes may share some jobs, at most ``most``.

    One where the system cannot fork, where this process has threads or an open OpenGL, which a fork would not have, and
    where there is a set, of which each would keep all that is known.
    """
    if most < 2 or document.pieces or not _can_fork():
        return 1
    frames = len({id(job.content.scene) for job in jobs})
    canvas, free = document.canvas, free_memory()
    of_one = _BYTES_OF_ONE + canvas.width_px * canvas.height_px * PIXEL_BYTES * _PICTURES
    fitting = most if free is None else free // of_one
    return max(1, min(most, frames // _WORTH_ONE, fitting))


def _can_fork() -> bool:
    """Return whether this process is of a single thread; one that has opened OpenGL has those of the driver."""
    if sys.platform != "linux":
        return False
    try:
        return len(list(Path("/proc/self/task").iterdir())) == 1
    except OSError:
        return False


def shared_flow(
    jobs: Sequence[FrameJob],
    steps: PipelineSteps[Made],
    sharing: Sharing,
    cancelled: Cancelled,
    say: Callable[[Message], None],
) -> Generator[Outcome[Made], None, None]:
    """Yield the outcome of each job as `flow` does, but in any order where processes share them.

    Problems arise in this process alone: a job that fails in another is done again here. Where another has ended by
    itself, that is said.
    """
    if sharing.processes < 2:
        yield from flow(jobs, steps, sharing.workers, sharing.window, cancelled)
        return
    workers = max(1, sharing.workers // sharing.processes)
    part = Sharing(workers, min(sharing.window, _AHEAD * workers))
    missing = set(range(len(jobs)))
    with _driver_threads(sharing.processes), _Forks(jobs, steps, part, sharing.processes - 1) as forks:
        with closing(flow(forks.taken(), steps, part.workers, part.window, cancelled)) as own:
            for outcome in own:
                missing.discard(forks.place_of(outcome.job))
                yield outcome
                yield from forks.told(missing, patience_s=0.0)
        forks.take_all()
        yield from forks.told(missing, patience_s=None)
        if cancelled():
            return
        lost = len(missing - forks.failed)
        if lost:
            say(Message("a process that shared the work ended by itself; {count} pictures were made again", count=lost))
        if left := [jobs[place] for place in sorted(missing)]:
            with closing(flow(left, steps, part.workers, part.window, cancelled)) as own:
                yield from own


class _Forks(Generic[Made]):
    """The processes beside this one; a context manager, which leaves none of them behind."""

    def __init__(self, jobs: Sequence[FrameJob], steps: PipelineSteps[Made], sharing: Sharing, count: int) -> None:
        self._jobs, self._steps, self._sharing = jobs, steps, sharing
        self._places = {id(job): place for place, job in enumerate(jobs)}
        self._again: deque[int] = deque()
        self._tokens, self._spans = _tokens_for(jobs)
        self._parent = os.getpid()
        self._telling: dict[int, int] = {}
        sys.stdout.flush()
        sys.stderr.flush()
        for _ in range(count):
            self._begin()

    def __enter__(self) -> Self:
        """Return them."""
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Wait until the others have made what they have in hand; told to end at once, end them."""
        self.take_all()
        at_once = error is not None and not isinstance(error, Exception | GeneratorExit)
        for reading, process in self._telling.items():
            if at_once:
                os.kill(process, signal.SIGKILL)
            while os.read(reading, 1 << 16):
                pass
            os.close(reading)
            os.waitpid(process, 0)
        os.close(self._tokens)

    @property
    def failed(self) -> frozenset[int]:
        """The places of jobs that others could not do, and that this process has not begun yet."""
        return frozenset(self._again)

    def place_of(self, job: FrameJob) -> int:
        """Return the place of a job among all."""
        return self._places[id(job)]

    def taken(self) -> Iterator[FrameJob]:
        """Yield the jobs that this process makes: what another could not, and what nobody has taken yet."""
        while True:
            if self._again:
                yield self._jobs[self._again.popleft()]
            elif token := os.read(self._tokens, _TOKEN.size):
                first, end = self._spans[_TOKEN.unpack(token)[0]]
                yield from self._jobs[first:end]
            else:
                return

    def take_all(self) -> None:
        """Leave nothing for anybody to take."""
        while os.read(self._tokens, 1 << 16):
            pass

    def told(self, missing: set[int], patience_s: float | None) -> Iterator[Outcome[Made]]:
        """Yield what the others have made since, and strike it out; wait as long as they live with a patience of None.

        What they could not make is made by this process.
        """
        while self._telling and (ready := select.select(list(self._telling), [], [], patience_s)[0]):
            for reading in ready:
                said = _message(reading)
                if said is None:
                    os.close(reading)
                    os.waitpid(self._telling.pop(reading), 0)
                    continue
                place, made = pickle.loads(said)
                if made is None:
                    self._again.append(place)
                else:
                    missing.discard(place)
                    yield Outcome(self._jobs[place], written=made)

    def _begin(self) -> None:
        reading, writing = os.pipe()
        process = os.fork()
        if process:
            os.close(writing)
            self._telling[reading] = process
            return
        # From here on in the other process, which must never return.
        try:
            # Else it would itself keep the pipe open that nobody reads once the first has ended.
            for end in (reading, *self._telling):
                os.close(end)
            for number in (signal.SIGINT, signal.SIGTERM):
                signal.signal(number, signal.SIG_IGN)  # the first takes away what there is to do
            self._make(writing)
        finally:
            os._exit(0)  # whatever went wrong does so again in the first, which says it

    def _make(self, writing: int) -> None:
        """Make what is taken and tell of it, as long as the first process lives."""
        part = self._sharing
        with closing(flow(self.taken(), self._steps, part.workers, part.window, self._is_alone)) as outcomes:
            for outcome in outcomes:
                said = pickle.dumps((self.place_of(outcome.job), outcome.written))
                os.write(writing, _LENGTH.pack(len(said)) + said)

    def _is_alone(self) -> bool:
        return os.getppid() != self._parent


def _tokens_for(jobs: Sequence[FrameJob]) -> tuple[int, list[tuple[int, int]]]:
    """Return the end of a pipe that holds numbers, and for each of them its jobs, as the first and the end.

    Pictures of one frame stay together, as whoever has drawn its shadows knows them.
    """
    import fcntl  # which Windows has not

    spans: list[tuple[int, int]] = []
    for _, group in groupby(enumerate(jobs), key=lambda each: id(each[1].content.scene)):
        places = [place for place, _ in group]
        spans.append((places[0], places[-1] + 1))
    reading, writing = os.pipe()
    held = fcntl.fcntl(writing, fcntl.F_GETPIPE_SZ) // _TOKEN.size
    together = -(-len(spans) // held)
    spans = [(spans[at][0], spans[min(at + together, len(spans)) - 1][1]) for at in range(0, len(spans), together)]
    os.write(writing, b"".join(map(_TOKEN.pack, range(len(spans)))))
    os.close(writing)
    return reading, spans


def _message(reading: int) -> bytes | None:
    """Return what a process says next; None where it is at its end, if only in the middle of a word."""
    head = _exactly(reading, _LENGTH.size)
    return None if head is None else _exactly(reading, _LENGTH.unpack(head)[0])


def _exactly(reading: int, count: int) -> bytes | None:
    parts: list[bytes] = []
    while count:
        part = os.read(reading, count)
        if not part:
            return None
        parts.append(part)
        count -= len(part)
    return b"".join(parts)


@contextmanager
def _driver_threads(processes: int) -> Iterator[None]:
    """Have the driver draw with as many threads as there are processors for each process, where nothing else is set."""
    if _DRIVER_THREADS in os.environ:
        yield
        return
    share = processors() // processes
    # None is the drawing thread itself.
    os.environ[_DRIVER_THREADS] = str(share if share > 1 else 0)
    try:
        yield
    finally:
        with suppress(KeyError):
            del os.environ[_DRIVER_THREADS]
