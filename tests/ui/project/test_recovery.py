"""Work is never lost: put aside, found again after the program was killed, and guarded against others."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from PySide6.QtCore import QSettings, QSysInfo, Qt, QTimer
from PySide6.QtWidgets import QApplication, QMessageBox, QWidget
from pytestqt.qtbot import QtBot

from kagezou.document.address import Address, value_of
from kagezou.document.edits import set_constant
from kagezou.document.properties import GROUND_DECLINATION
from kagezou.io.project.file import load
from kagezou.io.project.recovery_file import SUFFIX, read_recovery_file, recovery_files_in
from kagezou.ui.application import Application
from kagezou.ui.project.dialogs import Changed, Dialogs
from kagezou.ui.project.keepsakes import left_behind
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.project.project_lock import ProjectLock
from kagezou.ui.project.recovery import RecoveryDialog
from kagezou.ui.system.settings import Settings
from kagezou.ui.window.main_window import MainWindow
from tests.ui.viewing import OwnClipboard

DECLINATION = Address(GROUND_DECLINATION)

OTHER_PROGRAM = """
import sys, time
from pathlib import Path
from PySide6.QtCore import QSettings
from kagezou.document.address import Address
from kagezou.document.edits import set_constant
from kagezou.document.properties import GROUND_DECLINATION
from kagezou.ui.application import Application, make_application
from kagezou.ui.system.settings import Settings

folder = Path(sys.argv[1])
application = make_application()
store = QSettings(str(folder / "other.ini"), QSettings.Format.IniFormat)
program = Application(application, Settings(store, folder / "styles", folder / "unsaved"))
program.show()
program.window.parts.project.open_path(Path(sys.argv[2]))
while program.window.parts.project.loading.is_running:
    application.processEvents()
session = program.open_project.bridge.session
for step in range(3):
    session.edit("Turn", set_constant(session.document, Address(GROUND_DECLINATION), 20.0 + step))
program.autosave.keep()
program.autosave.wait()
print("kept", flush=True)
while True:
    application.processEvents()
    time.sleep(0.01)
"""


@pytest.fixture
def saved(filled: OpenProject, tmp_path: Path) -> OpenProject:
    filled.save(tmp_path / "walk.kage")
    return filled


def turn(open_project: OpenProject, degrees: float) -> None:
    session = open_project.bridge.session
    session.edit("Turn", set_constant(session.document, DECLINATION, degrees))


@pytest.mark.skipif(os.name != "posix", reason="SIGKILL is POSIX's")
def test_a_killed_program_loses_nothing(qtbot: QtBot, saved: OpenProject, settings: Settings, tmp_path: Path) -> None:
    assert saved.path is not None
    command = [sys.executable, "-c", OTHER_PROGRAM, str(tmp_path), str(saved.path)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as other:
        assert other.stdout is not None
        assert other.stdout.readline().strip() == "kept"
        assert left_behind(settings.recovery_folder) == (), "its program still lives"
        assert ProjectLock().holder_of(saved.path) == QSysInfo.machineHostName()
        other.send_signal(signal.SIGKILL)
        other.wait()
    assert ProjectLock().holder_of(saved.path) == "", "the lock of a dead program counts for nothing"
    (file,) = left_behind(settings.recovery_folder)
    wanted = read_recovery_file(file)
    assert wanted.document == set_constant(load(saved.path), DECLINATION, 22.0)
    application = QApplication.instance()
    assert isinstance(application, QApplication)
    program = Application(application, settings)
    program.show()
    program.offer_recovery()
    dialog = program.window.findChild(RecoveryDialog)
    assert dialog is not None
    assert "walk\n" in dialog.list.item(0).text()
    assert "3 steps" in dialog.list.item(0).text()
    qtbot.mouseClick(dialog.recover_button, Qt.MouseButton.LeftButton)
    assert program.open_project.bridge.document == wanted.document
    assert program.open_project.path == saved.path
    assert not program.open_project.is_saved
    assert left_behind(settings.recovery_folder) == (), "this program holds it"
    program.autosave.wait()
    (kept,) = recovery_files_in(settings.recovery_folder)
    assert kept == program.autosave.file, "under the name of this program"
    assert read_recovery_file(kept).document == wanted.document
    program.put_away()
    assert recovery_files_in(settings.recovery_folder) == (), "nobody was asked, as nothing but closing was left"


def test_damaged_work_is_a_sentence_and_can_be_discarded(qtbot: QtBot, tmp_path: Path) -> None:
    file = tmp_path / f"bad{SUFFIX}"
    file.write_bytes(b"{")
    dialog = RecoveryDialog((file,))
    qtbot.addWidget(dialog)
    dialog.show()
    assert "the kept work is damaged" in dialog.list.item(0).text()
    assert not dialog.recover_button.isEnabled()
    qtbot.mouseClick(dialog.discard_button, Qt.MouseButton.LeftButton)
    assert not file.exists()
    assert not dialog.isVisible()


def test_an_open_project_is_opened_a_second_time_only_when_agreed(
    qtbot: QtBot, settings: Settings, saved: OpenProject, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert saved.path is not None
    path = saved.path
    first = ProjectLock()
    first.hold(path)
    window = MainWindow(OpenProject(), settings, OwnClipboard())
    qtbot.addWidget(window)
    asked: list[str] = []

    def answer(_name: str, holder: str) -> bool:
        asked.append(holder)
        return len(asked) > 1

    monkeypatch.setattr(window.parts.project.dialogs, "open_twice", answer)
    assert not window.parts.project.open_path(path)
    assert window.parts.open_project.is_blank
    assert asked == [QSysInfo.machineHostName()]
    assert window.parts.project.open_path(path)
    first.release()
    window.close_unasked()


def test_what_others_saved_meanwhile_is_not_overwritten_unasked(
    qtbot: QtBot, settings: Settings, saved: OpenProject, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert saved.path is not None
    window = MainWindow(OpenProject(), settings, OwnClipboard())
    qtbot.addWidget(window)
    window.parts.project.open_path(saved.path)
    turn(saved, 12.0)
    saved.save(saved.path)
    turn(window.parts.open_project, 77.0)
    dialogs, beside = window.parts.project.dialogs, saved.path.with_name("walk_002.kage")
    answers = [Changed.CANCEL, Changed.SAVE_AS, Changed.REPLACE]
    monkeypatch.setattr(dialogs, "overwrite_changed", lambda _name: answers.pop(0))
    assert not window.parts.project.save()
    assert value_of(load(saved.path), DECLINATION, 1) == 12.0
    suggested: list[str] = []
    monkeypatch.setattr(dialogs, "project_to_save", suggested.append)
    assert not window.parts.project.save(), "no name was chosen"
    assert suggested == [beside.name]
    assert value_of(load(saved.path), DECLINATION, 1) == 12.0
    assert window.parts.project.save()
    assert value_of(load(saved.path), DECLINATION, 1) == 77.0
    assert window.parts.project.save(), "nobody changed it since"
    window.close_unasked()


def test_the_next_version_is_saved_beside_the_old_one(qtbot: QtBot, settings: Settings, saved: OpenProject) -> None:
    assert saved.path is not None
    window = MainWindow(OpenProject(), settings, OwnClipboard())
    qtbot.addWidget(window)
    window.parts.project.open_path(saved.path)
    turn(window.parts.open_project, 5.0)
    assert window.parts.project.save_increment()
    assert window.parts.open_project.path == saved.path.with_name("walk_002.kage")
    assert window.parts.open_project.path is not None
    assert value_of(load(window.parts.open_project.path), DECLINATION, 1) == 5.0
    assert value_of(load(saved.path), DECLINATION, 1) != 5.0
    window.close_unasked()


def test_another_language_keeps_watching_over_the_same_work(settings: Settings, cels: Path) -> None:
    application = QApplication.instance()
    assert isinstance(application, QApplication)
    program = Application(application, settings)
    program.show()
    program.window.parts.project.bring([cels])
    program.speak("ja")
    program.autosave.keep()
    program.autosave.wait()
    (file,) = recovery_files_in(settings.recovery_folder)
    assert read_recovery_file(file).document == program.open_project.bridge.document
    assert read_recovery_file(file).name == program.window.parts.project.project_name
    program.open_project.bridge.session.mark_saved()
    program.put_away()


@pytest.mark.parametrize(
    ("button", "answer"),
    [("Save As…", Changed.SAVE_AS), ("Replace", Changed.REPLACE), ("Cancel", Changed.CANCEL)],
)
def test_the_question_about_a_changed_file_offers_another_place(
    qtbot: QtBot, settings: Settings, button: str, answer: Changed
) -> None:
    window = QWidget()
    qtbot.addWidget(window)

    def press() -> None:
        box = QApplication.activeModalWidget()
        assert isinstance(box, QMessageBox)
        assert "walk.kage~" in box.informativeText()
        (found,) = [each for each in box.buttons() if each.text() == button]
        found.click()

    QTimer.singleShot(0, press)
    assert Dialogs(window, settings).overwrite_changed("walk.kage") is answer


def test_settings_say_where_unsaved_work_goes(tmp_path: Path) -> None:
    store = QSettings(str(tmp_path / "a.ini"), QSettings.Format.IniFormat)
    assert Settings(store).recovery_folder.name == "unsaved"
    assert "kagezou" in Settings(store).recovery_folder.parts
    assert Settings(store).spare_recovery_folder.name.startswith("kagezou-unsaved")
