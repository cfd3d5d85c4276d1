"""Two threads that draw make the same files as one, and leave nothing behind."""

import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from contextlib import AbstractContextManager, contextmanager, nullcontext
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from kagezou.errors import GraphicsProblem, InputProblem, Stopped
from kagezou.export import painters
from kagezou.export.painters import are_worth_two
from kagezou.export.pictures import FlatPicture, Picture
from kagezou.export.pipeline import Draw, Outcome, PipelineSteps, flow
from kagezou.export.planning import FrameJob, planned
from kagezou.export.request import ExportRequest
from kagezou.export.second_painter import SecondPainter
from kagezou.message import Message
from kagezou.render.gpu.context import GraphicsContext, another, open_headless_context
from tests.export.small_cuts import bytes_below, cut, export, with_key, with_values

PATIENCE_S = 60
COUNT = 12


@pytest.fixture
def jobs(tmp_path: Path) -> tuple[FrameJob, ...]:
    return planned(cut(tmp_path, count=COUNT), ExportRequest(tmp_path)).jobs


def picture(_job: FrameJob) -> Picture:
    return FlatPicture(np.zeros((1, 1, 4), np.uint8))


def number(job: FrameJob) -> int:
    return job.targets[0].frame


def nothing(_job: FrameJob) -> None:
    """Decode nothing."""


def steps(draw: Draw, beside: Draw | None, decode: Callable[[FrameJob], None] = nothing) -> PipelineSteps[str]:
    return PipelineSteps(
        decode, lambda: nullcontext(draw), lambda job, _: str(number(job)), lambda: nullcontext(beside)
    )


def outcomes_of(jobs: tuple[FrameJob, ...], wanted: PipelineSteps[str], window: int = 4) -> list[Outcome[str]]:
    return list(flow(jobs, wanted, 2, window, lambda: False))


def test_both_draw_and_outcomes_come_in_order(jobs: tuple[FrameJob, ...]) -> None:
    threads: dict[int, str] = {}
    second_drew = threading.Event()

    def draw(job: FrameJob) -> Picture:
        threads[number(job)] = threading.current_thread().name
        assert second_drew.wait(PATIENCE_S)
        return picture(job)

    def beside(job: FrameJob) -> Picture:
        threads[number(job)] = threading.current_thread().name
        second_drew.set()
        return picture(job)

    @contextmanager
    def set_up() -> Iterator[Draw]:
        yield beside

    # The first waits in its first frame until the second has drawn one, and can be offered none before it is set up.
    ready = PipelineSteps(nothing, lambda: nullcontext(draw), lambda job, _: str(number(job)), set_up)
    many = tuple(replace(job) for job in jobs)
    with SecondPainter(set_up) as second:
        while not second.is_free():
            pass
        future: Future[None] = Future()
        future.set_result(None)
        assert second.take([(many[0], future)])[0].result(PATIENCE_S) is not None
    outcomes = outcomes_of(many, ready)
    assert [outcome.written for outcome in outcomes] == [str(n) for n in range(1, COUNT + 1)]
    assert not [thread for thread in threading.enumerate() if thread.name.startswith("frames")]


@pytest.mark.parametrize("why", ["none", "no driver"])
def test_where_there_is_no_second_the_first_draws_all(jobs: tuple[FrameJob, ...], why: str) -> None:
    threads: set[str] = set()

    def draw(job: FrameJob) -> Picture:
        threads.add(threading.current_thread().name)
        return picture(job)

    def refused() -> AbstractContextManager[Draw]:
        raise GraphicsProblem(Message("there is no OpenGL context to draw with"))

    wanted = steps(draw, None) if why == "none" else replace(steps(draw, None), drawing_beside=refused)
    assert len(outcomes_of(jobs, wanted)) == COUNT
    assert threads == {threading.current_thread().name}


def test_what_is_wrong_with_the_second_beyond_the_driver_ends_the_run(jobs: tuple[FrameJob, ...]) -> None:
    tried = threading.Event()

    def broken() -> AbstractContextManager[Draw]:
        tried.set()
        raise ZeroDivisionError

    def draw(job: FrameJob) -> Picture:
        assert tried.wait(PATIENCE_S)
        return picture(job)

    with pytest.raises(ZeroDivisionError):
        outcomes_of(jobs, replace(steps(draw, None), drawing_beside=broken))
    assert not [thread for thread in threading.enumerate() if thread.name.startswith("frames")]


def test_pictures_of_a_frame_stay_together_and_a_broken_one_fails_alone(jobs: tuple[FrameJob, ...]) -> None:
    pairs = tuple(each for job in jobs for each in (job, replace(job)))
    by_thread: dict[str, list[int]] = {}

    def draw(job: FrameJob) -> Picture:
        by_thread.setdefault(threading.current_thread().name, []).append(number(job))
        return picture(job)

    def decode(job: FrameJob) -> None:
        if number(job) == 5:
            raise InputProblem(Message("broken"))

    outcomes = outcomes_of(pairs, steps(draw, draw, decode), window=6)
    assert [number(outcome.job) for outcome in outcomes if outcome.problem] == [5, 5]
    assert len(outcomes) == 2 * COUNT
    for numbers in by_thread.values():
        assert all(numbers.count(each) == 2 for each in numbers)


def test_a_second_that_stops_within_a_frame_ends_the_run(jobs: tuple[FrameJob, ...]) -> None:
    def beside(_job: FrameJob) -> Picture:
        raise Stopped

    set_up = threading.Event()

    @contextmanager
    def setting_up() -> Iterator[Draw]:
        set_up.set()
        yield beside

    def draw(job: FrameJob) -> Picture:
        assert set_up.wait(PATIENCE_S)
        return picture(job)

    outcomes = outcomes_of(jobs, replace(steps(draw, None), drawing_beside=setting_up), window=2)
    assert len(outcomes) < COUNT
    assert not [thread for thread in threading.enumerate() if thread.name.startswith("frames")]


def test_when_asked_to_stop_what_is_not_begun_is_left(jobs: tuple[FrameJob, ...]) -> None:
    drawn: list[int] = []

    def draw(job: FrameJob) -> Picture:
        drawn.append(number(job))
        return picture(job)

    outcomes = list(flow(jobs, steps(draw, draw), 2, 4, lambda: len(drawn) >= 5))
    assert sorted(number(outcome.job) for outcome in outcomes) == sorted(drawn)
    assert len(drawn) < COUNT


def test_files_are_the_same_by_one_or_two(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    document = with_values(cut(tmp_path / "in", count=COUNT), layers__A__shadow__simplify=3)
    document = with_key(document, "light.position", 1, [10.0, -20.0, 40.0])
    document = with_key(document, "light.position", COUNT, [30.0, -20.0, 40.0])
    opened: list[GraphicsContext] = []

    def counted(context: GraphicsContext) -> Callable[[], GraphicsContext] | None:
        opened.append(context)
        return another(context)

    export(document, tmp_path / "one", workers=1, composite=True)
    monkeypatch.setattr(painters, "another", counted)
    export(document, tmp_path / "two", workers=2, composite=True)
    assert len(opened) == 1
    assert bytes_below(tmp_path / "one") == bytes_below(tmp_path / "two") != {}


def test_few_frames_and_one_worker_have_one(tmp_path: Path, jobs: tuple[FrameJob, ...]) -> None:
    document = cut(tmp_path, count=COUNT)
    assert are_worth_two(document, jobs, 2)
    assert not are_worth_two(document, jobs, 1)
    assert not are_worth_two(document, jobs[:3], 2)


def test_another_context_is_of_the_processor_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    with open_headless_context() as context:
        make = another(context)
        if context.info.is_software:
            assert make is not None
        monkeypatch.setattr("sys.platform", "win32")
        assert another(context) is None
    assert another(object()) is None  # type: ignore[arg-type]
