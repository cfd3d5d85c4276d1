import threading
import time
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
    def slow(job: FrameJob, drawn: Picture) -> str:
        time.sleep(0.002 * (number(job) % 3))
        return written(job, drawn)

    outcomes = list(flow(jobs, steps(nothing, picture, slow), 4, 8, never))
    assert [outcome.written for outcome in outcomes] == [str(n) for n in range(1, 21)]


def test_no_more_is_decoded_or_waits_than_the_window_holds(jobs: tuple[FrameJob, ...]) -> None:
    lock = threading.Lock()
    alive = {"decoded": 0, "drawn": 0}
    most = dict(alive)

    def count(name: str, step: int) -> None:
        with lock:
            alive[name] += step
            most[name] = max(most[name], alive[name])

    def draw(job: FrameJob) -> Picture:
        count("decoded", -1)
        count("drawn", 1)
        return picture(job)

    def write(job: FrameJob, drawn: Picture) -> str:
        time.sleep(0.003)
        count("drawn", -1)
        return written(job, drawn)

    list(flow(jobs, steps(lambda _: count("decoded", 1), draw, write), 2, 3, never))
    assert most["decoded"] <= 4
    assert most["drawn"] <= 4


def test_the_first_drawings_are_decoded_while_drawing_is_set_up(jobs: tuple[FrameJob, ...]) -> None:
    decoded: list[int] = []

    @contextmanager
    def drawing() -> Iterator[Draw]:
        while len(decoded) < 3:
            time.sleep(0.001)
        yield picture

    several = PipelineSteps(lambda job: decoded.append(number(job)), drawing, written)
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
