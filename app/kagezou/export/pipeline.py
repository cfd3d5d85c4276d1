"""The pipeline: workers decode ahead and encode behind the one thread that draws.

At most so many drawings are decoded ahead and so many pictures wait to be encoded, so that memory does not grow with
the length of the cut.
"""

from collections import deque
from collections.abc import Callable, Generator, Iterable
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import Final, Generic, TypeVar

from kagezou.errors import InputProblem, Stopped
from kagezou.export.pictures import Picture
from kagezou.export.planning import FrameJob

Draw = Callable[[FrameJob], Picture]

Made = TypeVar("Made")
"""What becomes of a picture when it is written."""

AHEAD_BUDGET_BYTES: Final = 256 << 20
_BYTES_PER_PIXEL: Final = 10
"""What a decoded 16-bit drawing and its matte take."""


@dataclass(frozen=True, slots=True)
class PipelineSteps(Generic[Made]):
    """What is done for each job: decoded and written by workers, drawn on the calling thread.

    Parameters
    ----------
    decode
        May raise InputProblem, which fails its job alone, as for drawing; whatever else is raised ends the run.
    drawing
        Sets up what draws, for the time of the run; meanwhile the first drawings are decoded already.
    write
        Returns what its caller wants to have of it.
    """

    decode: Callable[[FrameJob], None]
    drawing: Callable[[], AbstractContextManager[Draw]]
    write: Callable[[FrameJob, Picture], Made]


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
    upcoming = iter(jobs)
    decoding: deque[tuple[FrameJob, Future[None]]] = deque()
    writing: deque[tuple[FrameJob, Future[Made]]] = deque()
    pool = ThreadPoolExecutor(workers, thread_name_prefix="frames")

    def look_ahead() -> None:
        while len(decoding) < window and (job := next(upcoming, None)) is not None:
            decoding.append((job, pool.submit(steps.decode, job)))

    try:
        look_ahead()
        with steps.drawing() as draw:
            while decoding and not cancelled():
                job, decoded = decoding.popleft()
                look_ahead()
                try:
                    decoded.result()
                    picture = draw(job)
                except InputProblem as problem:
                    yield Outcome(job, problem=problem)
                    continue
                except Stopped:
                    break
                writing.append((job, pool.submit(steps.write, job, picture)))
                while writing and (len(writing) > window or writing[0][1].done()):
                    job, written = writing.popleft()
                    yield Outcome(job, written.result())
        for _, decoded in decoding:
            decoded.cancel()
        for job, written in writing:
            yield Outcome(job, written.result())
    finally:
        pool.shutdown(wait=True, cancel_futures=True)
