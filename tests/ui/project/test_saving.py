"""Saving beside the window: a slow disk holds nobody up, the newest lies there at the end, and closing waits."""

import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication, QMessageBox
from pytestqt.qtbot import QtBot

from kagezou.document.address import Address, value_of
from kagezou.document.edits import set_constant
from kagezou.document.model import Document
from kagezou.document.properties import GROUND_DECLINATION
from kagezou.errors import OutputProblem
from kagezou.io.project import file as project_file
from kagezou.io.project.file import load
from kagezou.io.project.file_state import FileState
from kagezou.message import Message
from kagezou.ui.project import saving as saving_room
from kagezou.ui.project.dialogs import Answer
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.project.saving import Saving
from kagezou.ui.window.main_window import MainWindow

DECLINATION = Address(GROUND_DECLINATION)


class SlowDisk:
    """Files are written only as far as they are let through; every other one may be refused."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.free = threading.Event()
        self.reached = threading.Event()
        self.refuses = False
        self.written: list[Path] = []
        real = project_file.save

        def save(document: Document, path: Path) -> FileState:
            self.reached.set()
            assert self.free.wait(60)
            if self.refuses:
                raise OutputProblem(Message("{path}: the disk went away", path=path.name))
            self.written.append(path)
            return real(document, path)

        monkeypatch.setattr(project_file, "save", save)


@pytest.fixture
def disk(patient: None, monkeypatch: pytest.MonkeyPatch) -> Iterator[SlowDisk]:  # noqa: ARG001 - comes after it
    monkeypatch.setattr(saving_room, "PATIENCE_S", 0.0)
    made = SlowDisk(monkeypatch)
    yield made
    made.free.set()


@pytest.fixture
def saving(filled: OpenProject, disk: SlowDisk) -> Saving:  # noqa: ARG001 - it is slow
    return Saving(filled)


def under_way(saving: Saving) -> bool:
    return saving.is_running


def where(open_project: OpenProject) -> Path | None:
    return open_project.path


def is_saved(open_project: OpenProject) -> bool:
    return open_project.is_saved


def turn(open_project: OpenProject, degrees: float) -> None:
    session = open_project.bridge.session
    session.edit("Turn", set_constant(session.document, DECLINATION, degrees))


def declination(path: Path) -> object:
    return value_of(load(path), DECLINATION, 1)


def test_the_window_goes_on_and_what_was_written_counts_as_saved(
    qtbot: QtBot, filled: OpenProject, saving: Saving, disk: SlowDisk, tmp_path: Path
) -> None:
    turn(filled, 12.0)
    assert saving.start(tmp_path / "walk")
    assert under_way(saving)
    assert saving.path == tmp_path / "walk.kage"
    assert not is_saved(filled)
    assert where(filled) is None
    disk.free.set()
    qtbot.waitUntil(lambda: not saving.is_running)
    assert is_saved(filled)
    assert filled.path == tmp_path / "walk.kage"
    assert not filled.is_changed_outside(tmp_path / "walk.kage")


def test_what_is_done_meanwhile_is_not_taken_for_saved(
    qtbot: QtBot, filled: OpenProject, saving: Saving, disk: SlowDisk, tmp_path: Path
) -> None:
    turn(filled, 12.0)
    saving.start(tmp_path / "walk.kage")
    turn(filled, 34.0)
    disk.free.set()
    qtbot.waitUntil(lambda: not saving.is_running)
    assert not is_saved(filled)
    assert filled.bridge.session.history.since_saved == 1
    assert declination(tmp_path / "walk.kage") == 12.0
    filled.bridge.session.undo()
    assert is_saved(filled)


def test_asked_again_the_newest_is_written_afterwards(
    qtbot: QtBot, filled: OpenProject, saving: Saving, disk: SlowDisk, tmp_path: Path
) -> None:
    path = tmp_path / "walk.kage"
    saving.start(path)
    for degrees in (12.0, 34.0, 56.0):
        turn(filled, degrees)
        saving.start(path)
    disk.free.set()
    qtbot.waitUntil(lambda: not saving.is_running)
    assert disk.written == [path, path], "once more, not once for each time"
    assert declination(path) == 56.0
    assert is_saved(filled)


def test_asked_again_without_a_change_it_is_written_once(
    qtbot: QtBot, saving: Saving, disk: SlowDisk, tmp_path: Path
) -> None:
    saving.start(tmp_path / "walk.kage")
    saving.start(tmp_path / "walk.kage")
    disk.free.set()
    qtbot.waitUntil(lambda: not saving.is_running)
    assert disk.written == [tmp_path / "walk.kage"]


def test_another_name_meanwhile_is_written_too(
    qtbot: QtBot, filled: OpenProject, saving: Saving, disk: SlowDisk, tmp_path: Path
) -> None:
    saving.start(tmp_path / "walk.kage")
    saving.start(tmp_path / "walk_002.kage")
    disk.free.set()
    qtbot.waitUntil(lambda: not saving.is_running)
    assert disk.written == [tmp_path / "walk.kage", tmp_path / "walk_002.kage"]
    assert filled.path == tmp_path / "walk_002.kage"


def test_what_cannot_be_written_is_said_and_counts_as_unsaved(
    qtbot: QtBot, filled: OpenProject, saving: Saving, disk: SlowDisk, tmp_path: Path
) -> None:
    said: list[str] = []
    saving.failed.connect(lambda problem: said.append(str(problem)))
    turn(filled, 12.0)
    disk.refuses = True
    saving.start(tmp_path / "walk.kage")
    disk.free.set()
    qtbot.waitUntil(lambda: not saving.is_running)
    assert said == ["walk.kage: the disk went away"]
    assert not is_saved(filled)
    assert filled.path is None


def test_a_project_opened_meanwhile_is_not_taken_for_the_one_that_was_written(
    qtbot: QtBot, filled: OpenProject, saving: Saving, disk: SlowDisk, tmp_path: Path
) -> None:
    saving.start(tmp_path / "walk.kage")
    filled.clear()
    disk.free.set()
    qtbot.waitUntil(lambda: not saving.is_running)
    assert filled.path is None
    assert (tmp_path / "walk.kage").exists()


def test_waiting_ends_when_it_is_written(filled: OpenProject, saving: Saving, disk: SlowDisk, tmp_path: Path) -> None:
    saving.start(tmp_path / "walk.kage")
    saving.wait(0.0)
    assert under_way(saving), "nobody waits longer than was said"
    disk.free.set()
    saving.wait()
    assert not under_way(saving)
    assert is_saved(filled)


class TestWindow:
    @pytest.fixture
    def slow(self, walking: MainWindow, disk: SlowDisk, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> MainWindow:
        """The window while its project is being written."""
        turn(walking.parts.open_project, 12.0)
        monkeypatch.setattr(walking.parts.project.dialogs, "project_to_save", lambda _name: tmp_path / "walk.kage")
        walking.parts.actions["save"].trigger()
        assert disk.reached.wait(60)
        return walking

    def test_the_title_says_it(self, qtbot: QtBot, slow: MainWindow, disk: SlowDisk) -> None:
        assert "(saving…)" in slow.windowTitle()
        disk.free.set()
        qtbot.waitUntil(lambda: slow.windowTitle() == "walk[*] — Kagezou")
        assert not slow.isWindowModified()
        assert slow.parts.settings.recent[0].name == "walk.kage"

    def test_once_more_asks_nothing(
        self, qtbot: QtBot, slow: MainWindow, disk: SlowDisk, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        turn(slow.parts.open_project, 34.0)
        monkeypatch.setattr(slow.parts.project.dialogs, "overwrite_changed", pytest.fail)
        slow.parts.actions["save"].trigger()
        disk.free.set()
        qtbot.waitUntil(lambda: slow.parts.open_project.is_saved)
        assert declination(tmp_path / "walk.kage") == 34.0

    def test_a_failure_is_said_as_ever(self, qtbot: QtBot, slow: MainWindow, disk: SlowDisk) -> None:
        disk.refuses = True
        disk.free.set()
        qtbot.waitUntil(lambda: slow.parts.bar.text == "walk.kage: the disk went away")
        assert slow.isWindowModified()

    def test_closing_waits_and_says_so(self, qtbot: QtBot, slow: MainWindow, disk: SlowDisk) -> None:
        said: list[str] = []

        def let_it_end(box: QMessageBox) -> None:
            said.append(box.text())
            disk.free.set()

        when_asked(let_it_end)
        assert slow.close()
        assert said == ["“walk.kage” is being saved."]
        assert slow.parts.open_project.is_saved
        qtbot.waitUntil(slow.isHidden)

    def test_who_will_not_wait_stays(self, slow: MainWindow) -> None:
        when_asked(lambda box: box.button(QMessageBox.StandardButton.Cancel).click())
        assert not slow.close()
        assert slow.isVisible()

    def test_where_it_fails_while_closing_the_work_is_asked_about(
        self, slow: MainWindow, disk: SlowDisk, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        asked: list[str] = []

        def cancel(name: str) -> Answer:
            asked.append(name)
            return Answer.CANCEL

        monkeypatch.setattr(slow.parts.project.dialogs, "unsaved", cancel)
        disk.refuses = True
        when_asked(lambda _box: disk.free.set())
        assert not slow.close()
        assert len(asked) == 1


def when_asked(do: Callable[[QMessageBox], object]) -> None:
    """Do something with the question that is open next."""

    def look() -> None:
        box = QApplication.activeModalWidget()
        if isinstance(box, QMessageBox):
            do(box)
        else:
            QTimer.singleShot(5, look)

    QTimer.singleShot(0, look)
