"""The program ends without anybody being asked: killed at any moment of a recovery, or told to end by the system."""

import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import IO

import pytest
from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QApplication, QMessageBox
from pytestqt.qtbot import QtBot

from kagezou.document.address import Address, value_of
from kagezou.document.edits import set_constant
from kagezou.document.properties import GROUND_DECLINATION
from kagezou.io.project.file import load, save
from kagezou.io.project.recovery_file import RecoveredWork, keep, read_recovery_file
from kagezou.ui.application import Application
from kagezou.ui.project.dialogs import Changed
from kagezou.ui.project.keepsakes import left_behind
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.project.recovery import RecoveryDialog
from kagezou.ui.system.settings import Settings

DECLINATION = Address(GROUND_DECLINATION)
HOUR_S = 3600

on_posix = pytest.mark.skipif(os.name != "posix", reason="these signals are POSIX's")

RECOVERING = """
import json, os, signal, sys
from pathlib import Path
from PySide6.QtCore import QSettings
from kagezou.io.files import atomic
from kagezou.io.project import recovery_file
from kagezou.ui.application import Application, make_application
from kagezou.ui.project.autosave import Autosave
from kagezou.ui.project.keepsakes import Keepsakes
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.project.recovery import RecoveryDialog
from kagezou.ui.system.settings import Settings

def die(*_, **__):
    print("at the point", flush=True)
    os.kill(os.getpid(), signal.SIGKILL)

def die_before(owner, name):
    setattr(owner, name, die)

def die_after(owner, name):
    real = getattr(owner, name)
    def then_die(*given, **named):
        real(*given, **named)
        die()
    setattr(owner, name, then_die)

def write_half(path, data):
    path.open("wb").write(data[: len(data) // 2])
    die()

points = {
    "before the project is replaced": lambda: die_before(OpenProject, "recover"),
    "after the project is replaced": lambda: die_after(OpenProject, "recover"),
    "before the old file is taken over": lambda: die_before(Keepsakes, "adopt"),
    "after the old file is taken over": lambda: die_after(Keepsakes, "adopt"),
    "before the new file is begun": lambda: die_before(recovery_file, "replace_by"),
    "in the middle of the new file": lambda: setattr(Path, "write_bytes", write_half),
    "before the new file is read back": lambda: die_before(recovery_file, "_check"),
    "before the new file has its name": lambda: die_before(atomic, "_replace"),
    "after the new file has its name": lambda: die_after(atomic, "_replace"),
    "before the old file goes": lambda: die_before(recovery_file, "remove_file"),
    "after the old file is gone": lambda: die_after(recovery_file, "remove_file"),
    "when all is done": lambda: die_after(Autosave, "wait"),
}

def recover(folder, point):
    application = make_application()
    store = QSettings(str(folder / "other.ini"), QSettings.Format.IniFormat)
    program = Application(application, Settings(store, folder / "styles", folder / "unsaved", None, folder / "spare"))
    program.show()
    program.offer_recovery()
    dialog = program.window.findChild(RecoveryDialog)
    points[point]()
    dialog.recover_button.click()
    program.autosave.wait()

for line in sys.stdin:
    child = os.fork()
    if not child:
        recover(*json.loads(line, object_hook=lambda given: (Path(given["folder"]), given["point"])))
        os._exit(0)
    print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), flush=True)
"""
"""A program for each line it is given, out of one that has imported all there is to import."""

POINTS = [
    "before the project is replaced",
    "after the project is replaced",
    "before the old file is taken over",
    "after the old file is taken over",
    "before the new file is begun",
    "in the middle of the new file",
    "before the new file is read back",
    "before the new file has its name",
    "after the new file has its name",
    "before the old file goes",
    "after the old file is gone",
    "when all is done",
]

WORKING = """
import signal
import sys
from pathlib import Path
from PySide6.QtCore import QTimer
from kagezou.document.address import Address
from kagezou.document.edits import set_constant
from kagezou.document.properties import GROUND_DECLINATION
from kagezou.ui import application
from kagezou.ui.project import autosave

autosave.SHORTLY_MS = 3_600_000  # only the end itself keeps
for number in (signal.SIGHUP, signal.SIGINT, signal.SIGTERM):
    # Whoever runs the tests may have been started to ignore them, as by nohup.
    signal.signal(number, signal.SIG_DFL)

def work(program):
    session = program.open_project.bridge.session
    session.edit("Turn", set_constant(session.document, Address(GROUND_DECLINATION), 71.0))
    if sys.argv[2] == "asking":
        QTimer.singleShot(0, program.window.close)
        QTimer.singleShot(0, lambda: print("ready", flush=True))
    else:
        print("ready", flush=True)

application.Application.offer_recovery = lambda program: QTimer.singleShot(0, lambda: work(program))
sys.exit(application.run(Path(sys.argv[1])))
"""


@dataclass(frozen=True)
class Left:
    """What a program that is gone left behind.

    Parameters
    ----------
    work
        What was put aside.
    project
        The project's file, which is older.
    settings
        Where the next program looks.
    """

    work: RecoveredWork
    project: Path
    settings: Settings


@pytest.fixture
def left(filled: OpenProject, settings: Settings, tmp_path: Path) -> Left:
    project = tmp_path / "walk.kage"
    filled.save(project)
    document = set_constant(filled.bridge.document, DECLINATION, 66.0)
    work = RecoveredWork(document, "walk", project, 1_790_000_000, 3, filled.seen)
    keep(settings.recovery_folder / "left.keepsake", work)
    return Left(work, project, settings)


@pytest.fixture(scope="module")
def recovering() -> Iterator[subprocess.Popen[str]]:
    """What starts programs that recover, and are killed."""
    command = [sys.executable, "-c", RECOVERING]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as programs:
        yield programs


def started(settings: Settings) -> Application:
    application = QApplication.instance()
    assert isinstance(application, QApplication)
    program = Application(application, settings)
    program.show()
    return program


def recover(qtbot: QtBot, program: Application) -> None:
    """Press the button that a person presses."""
    program.offer_recovery()
    dialog = program.window.findChild(RecoveryDialog)
    assert dialog is not None
    qtbot.mouseClick(dialog.recover_button, Qt.MouseButton.LeftButton)


class TestRecovery:
    @on_posix
    @pytest.mark.parametrize("point", POINTS)
    def test_killed_at_any_moment_it_is_offered_again(
        self, left: Left, tmp_path: Path, point: str, recovering: subprocess.Popen[str]
    ) -> None:
        assert recovering.stdin is not None
        assert recovering.stdout is not None
        recovering.stdin.write(json.dumps({"folder": str(tmp_path), "point": point}) + "\n")
        recovering.stdin.flush()
        lines = [recovering.stdout.readline().strip(), recovering.stdout.readline().strip()]
        assert lines == ["at the point", str(-signal.SIGKILL)]
        files = left_behind(left.settings.recovery_folder, left.settings.spare_recovery_folder)
        assert files, "all is gone"
        for file in files:
            assert read_recovery_file(file).document == left.work.document

    def test_then_saved_nothing_is_left(self, qtbot: QtBot, left: Left) -> None:
        program = started(left.settings)
        recover(qtbot, program)
        assert program.window.parts.project.save(), "the file is as it was: nobody needs to be asked"
        program.autosave.wait()
        assert left_behind(left.settings.recovery_folder) == ()
        assert list(left.settings.recovery_folder.glob("*.keepsake")) == []
        assert value_of(load(left.project), DECLINATION, 1) == 66.0
        program.put_away()

    @pytest.mark.parametrize("of_earlier_program", [False, True])
    def test_older_work_goes_over_a_newer_file_only_when_agreed(
        self, qtbot: QtBot, left: Left, monkeypatch: pytest.MonkeyPatch, of_earlier_program: bool
    ) -> None:
        if of_earlier_program:
            (file,) = left_behind(left.settings.recovery_folder)
            keep(file, RecoveredWork(left.work.document, "walk", left.project, left.work.kept_at_s, 3))
        newer = set_constant(left.work.document, DECLINATION, 5.0)
        save(newer, left.project)
        later_s = left.work.kept_at_s + HOUR_S
        os.utime(left.project, (later_s, later_s))
        program = started(left.settings)
        recover(qtbot, program)
        project = program.window.parts.project
        assert "was saved after this work began from it" in program.window.parts.bar.text
        answers = [Changed.CANCEL, Changed.SAVE_AS, Changed.REPLACE]
        monkeypatch.setattr(project.dialogs, "overwrite_changed", lambda _name: answers.pop(0))
        monkeypatch.setattr(project.dialogs, "project_to_save", lambda _name: None)
        assert not project.save()
        assert not project.save()
        assert value_of(load(left.project), DECLINATION, 1) == 5.0
        assert not program.open_project.is_saved
        program.put_away()

    def test_recovered_twice_it_still_asks(self, qtbot: QtBot, left: Left, monkeypatch: pytest.MonkeyPatch) -> None:
        save(set_constant(left.work.document, DECLINATION, 5.0), left.project)
        for _ in range(2):
            program = started(left.settings)
            recover(qtbot, program)
            program.autosave.finish(leave=True)
            program.window.close_unasked()
        program = started(left.settings)
        recover(qtbot, program)
        asked: list[str] = []

        def answer(name: str) -> Changed:
            asked.append(name)
            return Changed.CANCEL

        monkeypatch.setattr(program.window.parts.project.dialogs, "overwrite_changed", answer)
        assert not program.window.parts.project.save()
        assert asked == ["walk.kage"]
        program.put_away()

    def test_with_the_folder_closed_it_is_kept_elsewhere(
        self, qtbot: QtBot, left: Left, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        folder = left.settings.recovery_folder
        write_bytes, unlink = Path.write_bytes, Path.unlink

        def write(path: Path, data: bytes) -> int:
            if path.parent == folder:
                raise OSError(30, "read-only")
            return write_bytes(path, data)

        def remove(path: Path, missing_ok: bool = False) -> None:
            if path.parent == folder and path.suffix == ".keepsake" and not path.name.startswith("."):
                raise OSError(30, "read-only")
            unlink(path, missing_ok=missing_ok)

        monkeypatch.setattr(Path, "write_bytes", write)
        monkeypatch.setattr(Path, "unlink", remove)
        program = started(left.settings)
        recover(qtbot, program)
        qtbot.waitUntil(lambda: str(left.settings.spare_recovery_folder) in program.window.parts.bar.text)
        program.autosave.finish(leave=True)
        files = left_behind(folder, left.settings.spare_recovery_folder)
        assert [file.parent for file in files] == [folder, left.settings.spare_recovery_folder]
        assert all(read_recovery_file(file).document == left.work.document for file in files)
        program.window.close_unasked()

    def test_what_another_window_took_meanwhile_is_not_taken_twice(self, qtbot: QtBot, left: Left) -> None:
        first, second = started(left.settings), started(left.settings)
        second.offer_recovery()
        recover(qtbot, first)
        dialog = second.window.findChild(RecoveryDialog)
        assert dialog is not None
        (left.settings.recovery_folder / "left.keepsake").touch()
        first.autosave.adopt(left.settings.recovery_folder / "left.keepsake")
        qtbot.mouseClick(dialog.recover_button, Qt.MouseButton.LeftButton)
        assert second.open_project.is_blank
        assert "recovered this work already" in second.window.parts.bar.text
        first.put_away()
        second.put_away()


class TestEnding:
    @on_posix
    @pytest.mark.parametrize("name", ["SIGTERM", "SIGHUP", "SIGINT"])
    @pytest.mark.parametrize("state", ["working", "asking"])
    def test_a_signal_keeps_the_work_first(self, filled: OpenProject, tmp_path: Path, name: str, state: str) -> None:
        project = tmp_path / "walk.kage"
        filled.save(project)
        number = getattr(signal, name)
        with _running(tmp_path, project, state) as other:
            assert other.stdout is not None
            _wait_for(other.stdout, "ready")
            other.send_signal(number)
            assert other.wait() == 128 + number
        (file,) = left_behind(tmp_path / "state" / "kagezou" / "unsaved")
        assert read_recovery_file(file).document == set_constant(load(project), DECLINATION, 71.0)

    def test_logout_keeps_the_work_and_asks_nothing(self, left: Left, monkeypatch: pytest.MonkeyPatch) -> None:
        program = started(left.settings)
        program.window.parts.project.open_path(left.project)
        session = program.open_project.bridge.session
        session.edit("Turn", set_constant(session.document, DECLINATION, 12.0))
        asked: list[str] = []
        monkeypatch.setattr(QMessageBox, "exec", _cancelling(asked))
        program.be_ended()
        assert program.window.close()
        program.put_away()
        assert asked == []
        files = left_behind(left.settings.recovery_folder)
        assert [value_of(read_recovery_file(file).document, DECLINATION, 1) for file in files] == [12.0, 66.0]

    def test_after_a_logout_that_was_called_off_the_question_comes_back(
        self, left: Left, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        program = started(left.settings)
        program.window.parts.project.open_path(left.project)
        session = program.open_project.bridge.session
        session.edit("Turn", set_constant(session.document, DECLINATION, 12.0))
        program.be_ended()
        session.edit("Turn", set_constant(session.document, DECLINATION, 13.0))
        asked: list[str] = []
        monkeypatch.setattr(QMessageBox, "exec", _cancelling(asked))
        assert not program.window.close()
        assert len(asked) == 1
        program.put_away()

    def test_closing_still_asks(self, left: Left) -> None:
        program = started(left.settings)
        program.window.parts.project.open_path(left.project)
        session = program.open_project.bridge.session
        session.edit("Turn", set_constant(session.document, DECLINATION, 12.0))
        seen: list[str] = []

        def answer() -> None:
            box = QApplication.activeModalWidget()
            assert isinstance(box, QMessageBox)
            seen.append(box.text())
            box.button(QMessageBox.StandardButton.Cancel).click()

        QTimer.singleShot(0, answer)
        assert not program.window.close()
        assert len(seen) == 1
        program.put_away()


def _cancelling(asked: list[str]) -> Callable[[QMessageBox], int]:
    """Answer every question with Cancel, and note it."""

    def answer(box: QMessageBox) -> int:
        asked.append(box.text())
        return QMessageBox.StandardButton.Cancel.value

    return answer


def _running(folder: Path, project: Path, state: str) -> subprocess.Popen[str]:
    """Start the program with folders of its own."""
    own = {name: str(folder / name[4:-5].lower()) for name in ("XDG_STATE_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME")}
    command = [sys.executable, "-c", WORKING, str(project), state]
    return subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env={**os.environ, **own})


def _wait_for(lines: IO[str], wanted: str) -> None:
    for line in lines:
        if line.strip() == wanted:
            return
    raise AssertionError(wanted)
