"""The pipeline: workers decode ahead and encode behind those who draw, which are the calling thread and one beside it.

At most so many drawings are decoded ahead and so many pictures wait to be encoded, so that memory does not grow with
the length of the cut.
"""

from collections import deque
from collections.abc import Callable, Generator, Iterable
from concurrent.futures import CancelledError, Future, ThreadPoolExecutor
from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import Final, Generic, TypeVar

from kagezou.errors import InputProblem, Stopped
from kagezou.export.pictures import Picture
from kagezou.export.planning import FrameJob
from kagezou.export.second_painter import Drawing, SecondPainter

Draw = Callable[[FrameJob], Picture]

Made = TypeVar("Made")
"""What becomes of a picture when it is written."""

AHEAD_BUDGET_BYTES: Final = 256 << 20
_BYTES_PER_PIXEL: Final = 10
"""What a decoded 16-bit drawing and its matte take."""


@dataclass(frozen=True, slots=True)
class PipelineSteps(Generic[Made]):
    """What is done for each job: decoded and written by workers, drawn on the calling thread and perhaps one beside it.

    Parameters
    ----------
    decode
        May raise InputProblem, which fails its job alone, as for drawing; whatever else is raised ends the run.
    drawing
        Sets up what draws, for the time of the run; meanwhile the first drawings are decoded already.
    write
        Returns what its caller wants to have of it.
    drawing_beside
        The same for a second thread; None where one draws alone.
    """

    decode: Callable[[FrameJob], None]
    drawing: Callable[[], AbstractContextManager[Draw]]
    write: Callable[[FrameJob, Picture], Made]
    drawing_beside: Drawing | None = None


@dataclass(frozen=True, slots=True)
class Outcome(Generic[Made]):
    """A job that is done: what its writer returned, or why it could not be drawn."""

    job: FrameJob
    written: Made | None = None
    problem: InputProblem | None = None


def window_for(width_px: int, height_px: int, workers: int) -> int:
    """Return how many jobs may be decoded ahead, and how many may wait for their writer."""
    fitting = AHEAD_BUDGET_BYTES // (width_px * height_px * _BYTES_PER_PIXEL)
    return max(1, min(4 * workers, fitting))


def flow(
    jobs: Iterable[FrameJob], steps: PipelineSteps[Made], workers: int, window: int, cancelled: Callable[[], bool]
) -> Generator[Outcome[Made], None, None]:
    """Yield the outcome of each job, in their order but for failed ones, which come as soon as they are known.

    When ``cancelled`` says so, what is drawn is still written and yielded, and nothing more is begun; so it is when
    drawing raises `Stopped`, as it may where a frame takes minutes, and that frame is not made. Whatever ends
    the run, no worker is left when the iterator is closed.
    """
    pool = ThreadPoolExecutor(workers, thread_name_prefix="frames")
    ahead = _Ahead(jobs, steps, pool, window)
    line = _Line(steps, pool)
    try:
        ahead.look()
        with steps.drawing() as draw, SecondPainter(steps.drawing_beside) as second:
            while ahead.has_more and not line.is_stopped and not cancelled():
                # A picture of the frame that was just drawn is drawn by the same hands, which know its shadows.
                group = ahead.next_group()
                if second.is_free():
                    line.add(group, second.take(group))
                else:
                    for job, decoded in group:
                        line.add([(job, decoded)], [_drawn(draw, job, decoded)])
                yield from line.settled(window)
            if ahead.has_more:
                line.leave()
            yield from line.rest()
        ahead.cancel()
        yield from line.written()
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


class _Ahead(Generic[Made]):
    """The jobs to come, of which the next are being decoded."""

    def __init__(
        self, jobs: Iterable[FrameJob], steps: PipelineSteps[Made], pool: ThreadPoolExecutor, window: int
    ) -> None:
        self._upcoming = iter(jobs)
        self._steps, self._pool, self._window = steps, pool, window
        self._decoding: deque[tuple[FrameJob, Future[None]]] = deque()

    @property
    def has_more(self) -> bool:
        """Whether there are any."""
        return bool(self._decoding)

    def look(self) -> None:
        """Begin to decode as far ahead as the window goes."""
        while len(self._decoding) < self._window and (job := next(self._upcoming, None)) is not None:
            self._decoding.append((job, self._pool.submit(self._steps.decode, job)))

    def next_group(self) -> list[tuple[FrameJob, Future[None]]]:
        """Return the next job, and with it those pictures of the same frame that are being decoded already."""
        group = [self._decoding.popleft()]
        if self._steps.drawing_beside is not None:
            while self._decoding and self._decoding[0][0].content.scene is group[0][0].content.scene:
                group.append(self._decoding.popleft())
        self.look()
        return group

    def cancel(self) -> None:
        """Decode no more."""
        for _, decoded in self._decoding:
            decoded.cancel()


class _Line(Generic[Made]):
    """The jobs that are being drawn or written, in their order."""

    def __init__(self, steps: PipelineSteps[Made], pool: ThreadPoolExecutor) -> None:
        self._steps, self._pool = steps, pool
        self._drawing: deque[tuple[FrameJob, Future[Picture]]] = deque()
        self._writing: deque[tuple[FrameJob, Future[Made]]] = deque()
        self.is_stopped = False

    def add(self, group: list[tuple[FrameJob, Future[None]]], pictures: list[Future[Picture]]) -> None:
        """Put jobs at the end of the line, with the pictures that become of them."""
        self._drawing.extend((job, picture) for (job, _), picture in zip(group, pictures, strict=True))

    def settled(self, window: int) -> Generator[Outcome[Made], None, None]:
        """Hand over to writers what is drawn, and yield what is done, until no more than a window's jobs wait."""
        while self._drawing and (self._drawing[0][1].done() or len(self._drawing) + len(self._writing) > window):
            yield from self._handed_over()
        while self._writing and (len(self._writing) > window or self._writing[0][1].done()):
            job, written = self._writing.popleft()
            yield Outcome(job, written.result())

    def leave(self) -> None:
        """Draw nothing more that has not been begun."""
        for _, picture in self._drawing:
            picture.cancel()

    def rest(self) -> Generator[Outcome[Made], None, None]:
        """Hand over to writers what is still being drawn; yield what failed of it."""
        while self._drawing:
            yield from self._handed_over()

    def written(self) -> Generator[Outcome[Made], None, None]:
        """Yield what is still being written."""
        for job, written in self._writing:
            yield Outcome(job, written.result())

    def _handed_over(self) -> Generator[Outcome[Made], None, None]:
        """Hand over the first picture, when it is drawn."""
        job, drawn = self._drawing.popleft()
        try:
            picture = drawn.result()
        except InputProblem as problem:
            yield Outcome(job, problem=problem)
        except (Stopped, CancelledError):
            self.is_stopped = True
        else:
            self._writing.append((job, self._pool.submit(self._steps.write, job, picture)))


def _drawn(draw: Draw, job: FrameJob, decoded: Future[None]) -> Future[Picture]:
    """Draw a job when it is decoded."""
    made: Future[Picture] = Future()
    try:
        decoded.result()
        made.set_result(draw(job))
    except (InputProblem, Stopped) as problem:
        made.set_exception(problem)
    return made
