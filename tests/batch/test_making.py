"""One cut: what is kept of it where its files change, or somebody has it open, meanwhile."""

import os
import socket
from pathlib import Path

import pytest

from kagezou.batch.cut import Cut
from kagezou.batch.making import STEPS, Doing, MadeCut, make_cut, unchanged
from kagezou.batch.orders import Orders
from kagezou.batch.record import State
from kagezou.io.project.open_elsewhere import lock_of_window
from kagezou.render.gpu.context import open_headless_context
from tests.batch.cut_folders import drawings, picture


@pytest.fixture
def cut(tmp_path: Path) -> Cut:
    return Cut("c1", drawings(tmp_path / "c1"))


@pytest.fixture
def orders(tmp_path: Path) -> Orders:
    return Orders(tmp_path / "out", skip_existing=True)


def made(cut: Cut, orders: Orders, told: list[int], on_step: object = None) -> MadeCut:
    def progress(done: int, whole: int) -> None:
        assert whole == STEPS
        told.append(done)
        if callable(on_step):
            on_step()

    return make_cut(cut, orders, Doing(open_headless_context, progress, lambda: False))


def test_progress_goes_up_to_the_end(cut: Cut, orders: Orders) -> None:
    told: list[int] = []
    assert made(cut, orders, told).record.state is State.DONE
    assert told[-1] == STEPS
    assert min(told) >= 0
    assert unchanged(cut, orders) is not None


def test_files_that_change_meanwhile_are_said_and_the_cut_is_made_again(cut: Cut, orders: Orders) -> None:
    done = made(cut, orders, [], lambda: picture(cut.path / "walk_0009.png"))
    assert done.record.state is State.DONE
    assert "changed while it was made" in str(done.record.notes[-1])
    assert unchanged(cut, orders) is None
    assert made(cut, orders, []).record.frames == 9


def test_a_project_that_is_open_in_a_window_is_said(cut: Cut, orders: Orders) -> None:
    lock = lock_of_window(orders.output / "c1" / "c1.kage")
    lock.parent.mkdir(parents=True)
    lock.write_text(f"{os.getpid()}\nkagezou\n{socket.gethostname()}\n", encoding="utf-8")
    assert any("is open in a window" in str(note) for note in made(cut, orders, []).record.notes)


def test_stopping_leaves_a_stopped_cut_and_no_half_project(cut: Cut, orders: Orders) -> None:
    stopped = make_cut(cut, orders, Doing(open_headless_context, lambda _done, _whole: None, lambda: True))
    assert stopped.record.state is State.STOPPED
    assert not (orders.output / "c1" / "c1.kage").exists()
    assert made(cut, orders, []).record.state is State.DONE
