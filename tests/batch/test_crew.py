"""Processes of cuts: bounded, and one that crashes or hangs takes only itself along."""

import sys
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from kagezou.batch.batch import Batch, Telling
from kagezou.batch.crew import Ended, Pace, fitting, work_through
from kagezou.batch.cut import Cut
from kagezou.batch.record import CutRecord, State, write_record

CRASHES = "import os; os.abort()"
HANGS = "import time; time.sleep(600)"
FAILS = "import sys; sys.stderr.write('kagezou: it is so\\n'); sys.exit(1)"
WELL = "pass"


class Clock:
    """A clock that goes on by a minute whenever someone waits for it."""

    def __init__(self) -> None:
        self.now_s = 0.0

    def wait(self, _seconds: float) -> None:
        self.now_s += 60


class Seen:
    """Takes down what a crew tells."""

    def __init__(self) -> None:
        self.busy, self.most = 0, 0
        self.ends: dict[str, Ended] = {}

    def began(self, _cut: Cut) -> None:
        self.busy += 1
        self.most = max(self.most, self.busy)

    def ended(self, how: Ended) -> None:
        self.busy -= 1
        self.ends[how.cut.name] = how

    def moved(self, parts: float) -> None:
        assert 0 <= parts <= self.most


def cuts(*names: str) -> tuple[Cut, ...]:
    return tuple(Cut(name, Path("/nowhere")) for name in names)


def running(**code: str) -> Callable[[Cut], Sequence[str]]:
    return lambda cut: [sys.executable, "-c", code[cut.name]]


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no signals")
def test_what_crashes_or_fails_ends_alone() -> None:
    seen = Seen()
    words = running(a=CRASHES, b=WELL, c=FAILS, d=WELL)
    work_through(cuts("a", "b", "c", "d"), words, Pace(2, 600), seen, lambda: False)
    assert {name: how.code for name, how in seen.ends.items()} == {"a": -6, "b": 0, "c": 1, "d": 0}
    assert seen.ends["c"].said == "it is so"
    assert seen.most == 2


def test_what_hangs_is_ended_and_the_next_is_made() -> None:
    clock, seen = Clock(), Seen()
    pace = Pace(1, 300, lambda: clock.now_s, clock.wait)
    work_through(cuts("a", "b"), running(a=HANGS, b=HANGS), pace, seen, lambda: False)
    assert [how.is_stuck for how in seen.ends.values()] == [True, True]


def test_once_it_is_cancelled_nothing_is_begun_and_what_does_not_end_is_ended() -> None:
    clock, seen, asked = Clock(), Seen(), [False]

    def wait(seconds: float) -> None:
        clock.wait(seconds)
        asked[0] = True

    pace = Pace(1, 1e9, lambda: clock.now_s, wait)
    work_through(cuts("a", "b"), running(a=HANGS, b=WELL), pace, seen, lambda: asked[0])
    assert [(name, how.is_stopped) for name, how in seen.ends.items()] == [("a", True)]


def test_a_crew_is_bounded_by_cuts_and_processors(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("kagezou.batch.crew.free_memory", lambda: 3 << 30)
    assert [fitting(10, 2), fitting(1, 8), fitting(10, 8), fitting(0, 8)] == [2, 1, 3, 1]
    monkeypatch.setattr("kagezou.batch.crew.free_memory", lambda: None)
    assert fitting(100, 64) == 16


def test_what_left_no_word_of_its_own_is_a_failed_cut(tmp_path: Path) -> None:
    told: list[CutRecord] = []
    (cut,) = cuts("a")
    (tmp_path / "a").mkdir()
    write_record(CutRecord(name="a", state=State.DONE, frames=7), tmp_path / "a")
    batch = Batch([cut], tmp_path, Telling(told.append, lambda _done, _whole: None, lambda _records: None))
    for how, said in (
        (Ended(cut, 0, ""), "exit code 0"),
        (Ended(cut, 1, "a defect"), "exit code 1: a defect"),
        (Ended(cut, -9, ""), "SIGKILL" if sys.platform != "win32" else "9"),
        (Ended(cut, -9, "", is_stuck=True), "nothing moved"),
    ):
        batch.began(cut)
        batch.ended(how)
        assert told[-1].state is State.FAILED
        assert said in str(told[-1].problem), "what an earlier batch left does not count"
    batch.began(cut)
    batch.ended(Ended(cut, -9, "", is_stopped=True))
    assert told[-1].state is State.STOPPED
    batch.began(cut)
    write_record(CutRecord(name="a", state=State.DONE, frames=8), tmp_path / "a")
    batch.ended(Ended(cut, 0, ""))
    assert (told[-1].state, told[-1].frames) == (State.DONE, 8)
