"""Work beside the window: order, newest wish, problems, and an end after which nothing comes. Gates, never a clock."""

import threading
from collections.abc import Callable
from functools import partial

import pytest
from PySide6.QtCore import QCoreApplication
from pytestqt.qtbot import QtBot

from kagezou.errors import Problem, UsageProblem
from kagezou.message import Message
from kagezou.ui.system.background import Latest, Queue, Turn

pytestmark = pytest.mark.usefixtures("qapp")


class Gate:
    """Work that says when it has begun and waits until it may go on."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.has_begun, self.may_end = threading.Event(), threading.Event()

    def __call__(self, turn: Turn[str]) -> None:
        self.has_begun.set()
        assert self.may_end.wait(30)
        turn.tell(self.name)


def telling(name: str) -> Callable[[Turn[str]], None]:
    return lambda turn: turn.tell(name)


def arrived(queue: Queue[str]) -> None:
    """Let the worker end and everything it sent arrive."""
    queue.wait()
    QCoreApplication.processEvents()


def test_what_is_told_arrives_on_the_windows_thread_in_order() -> None:
    told: list[str] = []
    worked_on, came_on = set(), set()

    def take(name: str) -> None:
        came_on.add(threading.get_ident())
        told.append(name)

    def work(name: str, turn: Turn[str]) -> None:
        worked_on.add(threading.get_ident())
        turn.tell(f"{name} 1")
        turn.tell(f"{name} 2")

    queue = Queue[str](take)
    for name in "abc":
        assert queue.ask(partial(work, name))
    assert told == []
    arrived(queue)
    assert told == ["a 1", "a 2", "b 1", "b 2", "c 1", "c 2"]
    assert came_on == {threading.get_ident()}
    assert came_on.isdisjoint(worked_on)


def test_it_is_busy_until_the_end_has_arrived() -> None:
    ends: list[bool] = []
    queue = Queue[str](lambda _: ends.append(queue.is_busy), ended=lambda: ends.append(queue.is_busy))
    queue.ask(telling("a"))
    queue.wait()
    ends.append(queue.is_busy)
    arrived(queue)
    assert ends == [True, True, False]


def test_of_latest_only_the_newest_counts() -> None:
    told: list[str] = []
    latest, first = Latest[str](told.append), Gate("first")
    latest.ask(first)
    assert first.has_begun.wait(30)
    latest.ask(telling("never begun"))
    latest.ask(telling("newest"))
    first.may_end.set()
    arrived(latest)
    assert told == ["newest"]
    assert not latest.is_busy


def test_what_was_sent_and_has_not_arrived_is_old_too() -> None:
    told: list[str] = []
    latest = Latest[str](told.append)
    latest.ask(telling("old"))
    latest.wait()
    latest.ask(telling("new"))
    arrived(latest)
    assert told == ["new"]


def test_work_sees_that_nobody_waits_for_it_any_more() -> None:
    seen: list[bool] = []
    has_begun, may_look = threading.Event(), threading.Event()

    def work(turn: Turn[str]) -> None:
        seen.append(turn.is_unwanted)
        has_begun.set()
        assert may_look.wait(30)
        seen.append(turn.is_unwanted)

    queue = Queue[str](lambda _: None)
    queue.ask(work)
    assert has_begun.wait(30)
    queue.drop()
    may_look.set()
    arrived(queue)
    assert seen == [False, True]


def test_what_is_dropped_never_begins_and_what_comes_after_does() -> None:
    told: list[str] = []
    queue, first = Queue[str](told.append), Gate("first")
    queue.ask(first)
    assert first.has_begun.wait(30)
    queue.ask(telling("waiting"))
    queue.drop()
    queue.ask(telling("later"))
    first.may_end.set()
    arrived(queue)
    assert told == ["later"]


def test_a_problem_is_told_and_the_next_goes_on() -> None:
    told: list[str] = []
    problems: list[Problem] = []
    ends: list[int] = []
    queue = Queue[str](told.append, failed=problems.append, ended=lambda: ends.append(len(told)))
    problem = UsageProblem(Message("no such drawing"))

    def fail(turn: Turn[str]) -> None:
        turn.tell("half")
        raise problem

    queue.ask(fail)
    queue.ask(telling("next"))
    arrived(queue)
    assert (told, problems, ends) == (["half", "next"], [problem], [1, 2])


def test_nobody_hears_of_problems_of_what_was_given_up() -> None:
    problems: list[Problem] = []
    has_begun, may_fail = threading.Event(), threading.Event()

    def fail(_turn: Turn[str]) -> None:
        has_begun.set()
        assert may_fail.wait(30)
        raise UsageProblem(Message("too late"))

    queue = Queue[str](lambda _: None, failed=problems.append)
    queue.ask(fail)
    assert has_begun.wait(30)
    queue.drop()
    may_fail.set()
    arrived(queue)
    assert problems == []


def test_what_nobody_foresaw_is_raised_on_the_windows_thread(qtbot: QtBot) -> None:
    told: list[str] = []
    queue = Queue[str](told.append)

    def fail(_turn: Turn[str]) -> None:
        raise ZeroDivisionError("inside")

    with qtbot.captureExceptions() as raised:
        queue.ask(fail)
        queue.ask(telling("next"))
        arrived(queue)
    assert [(kind, str(error)) for kind, error, _ in raised] == [(ZeroDivisionError, "inside")]
    assert told == ["next"]
    assert not queue.is_busy


def test_a_queue_does_all_before_it_finishes_and_delivers_nothing_then() -> None:
    done: list[str] = []
    told: list[str] = []
    queue, first = Queue[str](told.append, ended=lambda: told.append("ended")), Gate("first")
    queue.ask(first)
    queue.ask(lambda _: done.append("second"))
    assert first.has_begun.wait(30)
    first.may_end.set()
    queue.finish()
    assert done == ["second"]
    QCoreApplication.processEvents()
    assert told == []
    assert not queue.is_busy
    assert not queue.ask(telling("too late"))
    arrived(queue)
    assert told == []


def test_finishing_latest_gives_up_what_is_being_done() -> None:
    told: list[str] = []
    latest = Latest[str](told.append)
    has_begun = threading.Event()

    def until_unwanted(turn: Turn[str]) -> None:
        has_begun.set()
        while not turn.is_unwanted:
            continue
        turn.tell("late")

    latest.ask(until_unwanted)
    assert has_begun.wait(30)
    latest.finish()
    QCoreApplication.processEvents()
    assert told == []


def test_finishing_twice_and_unused_is_nothing() -> None:
    queue = Queue[str](lambda _: None)
    queue.finish()
    queue.finish()
