import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext
from pathlib import Path

import numpy as np
import pytest

from kagezou.errors import DiskFullProblem, InputProblem
from kagezou.export.pictures import FlatPicture, Picture
from kagezou.export.pipeline import Draw, PipelineSteps, flow, window_for
from kagezou.export.planning import FrameJob, planned
from kagezou.export.request import ExportRequest
from kagezou.message import Message
from tests.export.small_cuts import cut

PATIENCE_S = 60
"""Nothing takes so long but what would hang."""


@pytest.fixture
def jobs(tmp_path: Path) -> tuple[FrameJob, ...]:
    return planned(cut(tmp_path, count=20), ExportRequest(tmp_path)).jobs


def nothing(_job: FrameJob) -> None:
    """Decode nothing."""


def picture(_job: FrameJob) -> Picture:
    return FlatPicture(np.zeros((1, 1, 4), np.uint8))


def number(job: FrameJob) -> int:
    return job.targets[0].frame


def written(job: FrameJob, _drawn: Picture) -> str:
    return str(number(job))


def steps(
    decode: Callable[[FrameJob], None], draw: Draw, write: Callable[[FrameJob, Picture], str]
) -> PipelineSteps[str]:
    return PipelineSteps(decode, lambda: nullcontext(draw), write)


def never() -> bool:
    return False


def test_outcomes_come_in_order_whatever_the_workers_do(jobs: tuple[FrameJob, ...]) -> None:
    done = {number(job): threading.Event() for job in jobs}
    order: list[int] = []

    def write(job: FrameJob, drawn: Picture) -> str:
        own = number(job)
        if own % 2:
            assert done[own + 1].wait(PATIENCE_S), "each second frame is written before the one before it"
        order.append(own)
        done[own].set()
        return written(job, drawn)

    outcomes = list(flow(jobs, steps(nothing, picture, write), 4, 8, never))
    assert [outcome.written for outcome in outcomes] == [str(n) for n in range(1, 21)]
    assert order != sorted(order)


def test_no_more_is_decoded_or_waits_than_the_window_holds(jobs: tuple[FrameJob, ...]) -> None:
    window = 3
    drawn_of = {number(job): threading.Event() for job in jobs}
    counts = {"asked for": 0, "drawn": 0, "out": 0}
    ahead: list[int] = []
    waiting: list[int] = []

    def asked_for() -> Iterator[FrameJob]:
        for job in jobs:
            counts["asked for"] += 1
            yield job

    def draw(job: FrameJob) -> Picture:
        ahead.append(counts["asked for"] - counts["drawn"])
        counts["drawn"] += 1
        waiting.append(counts["drawn"] - counts["out"])
        drawn_of[number(job)].set()
        return picture(job)

    def write(job: FrameJob, drawn: Picture) -> str:
        last_of_window = min(number(job) + window, len(jobs))
        assert drawn_of[last_of_window].wait(PATIENCE_S), "so many may be drawn while the first is written"
        return written(job, drawn)

    # Enough workers for all that wait, and for those that decode.
    for _ in flow(asked_for(), steps(nothing, draw, write), 4 * window, window, never):
        counts["out"] += 1
    assert max(ahead) == max(waiting) == window + 1
    assert counts == {"asked for": 20, "drawn": 20, "out": 20}


def test_the_first_drawings_are_decoded_while_drawing_is_set_up(jobs: tuple[FrameJob, ...]) -> None:
    decoded = threading.Semaphore(0)

    @contextmanager
    def drawing() -> Iterator[Draw]:
        for _ in range(3):
            assert decoded.acquire(timeout=PATIENCE_S)
        yield picture

    several = PipelineSteps(lambda _: decoded.release(), drawing, written)
    assert len(list(flow(jobs, several, 2, 3, never))) == 20


def test_drawing_happens_on_the_calling_thread(jobs: tuple[FrameJob, ...]) -> None:
    threads: set[str] = set()

    def draw(job: FrameJob) -> Picture:
        threads.add(threading.current_thread().name)
        return picture(job)

    list(flow(jobs, steps(nothing, draw, written), 2, 4, never))
    assert threads == {threading.current_thread().name}


def failing_on(frame: int, problem: Exception) -> Callable[[FrameJob], None]:
    def decode(job: FrameJob) -> None:
        if number(job) == frame:
            raise problem

    return decode


def test_a_drawing_that_cannot_be_read_fails_alone(jobs: tuple[FrameJob, ...]) -> None:
    failing = steps(failing_on(7, InputProblem(Message("broken"))), picture, written)
    outcomes = list(flow(jobs, failing, 2, 4, never))
    assert [number(outcome.job) for outcome in outcomes if outcome.problem] == [7]
    assert len(outcomes) == 20


def test_a_full_disk_ends_everything_and_leaves_no_worker(jobs: tuple[FrameJob, ...]) -> None:
    def write(job: FrameJob, drawn: Picture) -> str:
        if number(job) == 5:
            raise DiskFullProblem(Message("full"))
        return written(job, drawn)

    with pytest.raises(DiskFullProblem):
        list(flow(jobs, steps(nothing, picture, write), 2, 4, never))
    assert not [thread for thread in threading.enumerate() if thread.name.startswith("frames")]


def test_when_asked_to_stop_what_is_drawn_is_still_written(jobs: tuple[FrameJob, ...]) -> None:
    drawn: list[int] = []

    def draw(job: FrameJob) -> Picture:
        drawn.append(number(job))
        return picture(job)

    outcomes = list(flow(jobs, steps(nothing, draw, written), 2, 4, lambda: len(drawn) >= 6))
    assert [number(outcome.job) for outcome in outcomes] == drawn == [1, 2, 3, 4, 5, 6]


def test_an_iterator_that_is_left_leaves_no_worker(jobs: tuple[FrameJob, ...]) -> None:
    outcomes = flow(jobs, steps(nothing, picture, written), 2, 4, never)
    next(outcomes)
    outcomes.close()
    assert not [thread for thread in threading.enumerate() if thread.name.startswith("frames")]


@pytest.mark.parametrize(
    ("size", "workers", "window"), [((1000, 1000), 2, 8), ((1920, 1080), 8, 12), ((16384, 16384), 4, 1)]
)
def test_large_canvases_have_small_windows(size: tuple[int, int], workers: int, window: int) -> None:
    assert window_for(*size, workers) == window
