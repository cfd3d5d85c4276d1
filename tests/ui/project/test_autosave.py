"""Unsaved work is put aside a moment after each step, tried again where it fails, and kept elsewhere at need."""

import logging
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import QLockFile
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from kagezou.document.address import Address
from kagezou.document.edits import set_constant
from kagezou.document.model import Canvas
from kagezou.document.properties import GROUND_DECLINATION
from kagezou.io.project.recovery_file import RecoveredWork, keep, read_recovery_file, recovery_files_in
from kagezou.ui.application import Application
from kagezou.ui.project import autosave as autosaving
from kagezou.ui.project import keepsakes
from kagezou.ui.project.autosave import RETRY_MS, SHORTLY_MS, Autosave
from kagezou.ui.project.keepsakes import left_behind, lock_of
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.system.settings import Settings

DECLINATION = Address(GROUND_DECLINATION)


@pytest.fixture
def saved(filled: OpenProject, tmp_path: Path) -> OpenProject:
    filled.save(tmp_path / "walk.kage")
    return filled


@pytest.fixture
def autosave(saved: OpenProject, settings: Settings) -> Autosave:
    return Autosave(saved, settings.recovery_folder, lambda: "walk", settings.spare_recovery_folder)


def turn(open_project: OpenProject, degrees: float) -> None:
    session = open_project.bridge.session
    session.edit("Turn", set_constant(session.document, DECLINATION, degrees))


def spoil(folder: Path) -> None:
    """Make it impossible to keep anything in a folder, also for those who may do everything."""
    folder.parent.mkdir(parents=True, exist_ok=True)
    folder.write_text("no folder")


class TestWhen:
    def test_it_goes_when_it_is_saved(self, saved: OpenProject, autosave: Autosave) -> None:
        autosave.keep()
        assert recovery_files_in(autosave.file.parent) == (), "nothing is unsaved"
        turn(saved, 33.0)
        autosave.keep()
        autosave.wait()
        work = read_recovery_file(autosave.file)
        assert work.document == saved.bridge.document
        assert (work.name, work.path, work.edits, work.file) == ("walk", saved.path, 1, saved.seen)
        assert saved.path is not None
        saved.save(saved.path)
        autosave.wait()
        assert recovery_files_in(autosave.file.parent) == ()
        autosave.finish()

    def test_it_is_kept_by_itself_a_moment_after_a_step(
        self, qtbot: QtBot, saved: OpenProject, autosave: Autosave
    ) -> None:
        turn(saved, 10.0)
        assert autosave.is_waiting
        assert autosave._shortly.interval() == SHORTLY_MS <= 2000
        turn(saved, 11.0)
        qtbot.waitUntil(lambda: len(recovery_files_in(autosave.file.parent)) == 1)
        assert read_recovery_file(autosave.file).document == saved.bridge.document
        autosave.finish()
        assert recovery_files_in(autosave.file.parent) == (), "a program that ends as it should leaves nothing"
        assert not lock_of(autosave.file).exists()

    def test_steps_made_without_rest_do_not_put_it_off(self, saved: OpenProject, autosave: Autosave) -> None:
        turn(saved, 10.0)
        began = autosave._shortly.timerId()
        for degrees in range(11, 20):
            turn(saved, float(degrees))
        assert autosave._shortly.timerId() == began, "the clock runs from the first step on"
        autosave.finish()

    def test_a_long_drag_does_not_put_off_the_step_before_it(
        self, qtbot: QtBot, saved: OpenProject, autosave: Autosave
    ) -> None:
        turn(saved, 10.0)
        session = saved.bridge.session
        gesture = session.begin("Turn")
        gesture.show(set_constant(session.document, DECLINATION, 12.0))
        qtbot.waitUntil(lambda: len(recovery_files_in(autosave.file.parent)) == 1)
        gesture.cancel()
        assert autosave.is_waiting, "what was kept of the drag is not what is there now"
        autosave.finish()

    def test_the_pause_grows_with_the_time_it_takes(
        self, qtbot: QtBot, saved: OpenProject, autosave: Autosave, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        turn(saved, 10.0)
        times = iter([100.0, 107.0])
        monkeypatch.setattr(autosaving, "monotonic", lambda: next(times, 107.0))
        with qtbot.waitSignal(autosave.kept):
            autosave.keep()
        turn(saved, 11.0)
        assert autosave._shortly.interval() == 70_000, "ten times the seven seconds that it took"
        autosave.finish()

    @pytest.mark.parametrize("wakes_s", [28_800.0, 107.0])
    def test_after_a_sleep_of_the_computer_no_pause_of_before_holds_it_up(
        self, qtbot: QtBot, saved: OpenProject, autosave: Autosave, monkeypatch: pytest.MonkeyPatch, wakes_s: float
    ) -> None:
        """A computer sleeps for hours, on systems whose clock counts these and on those where it stands still."""
        turn(saved, 10.0)
        times = iter([100.0, 107.0])
        monkeypatch.setattr(autosaving, "monotonic", lambda: next(times, wakes_s))
        with qtbot.waitSignal(autosave.kept):
            autosave.keep()
        turn(saved, 11.0)
        assert SHORTLY_MS <= autosave._shortly.interval() <= (SHORTLY_MS if wakes_s > 1000 else 70_000)
        autosave.keep()
        autosave.wait()
        assert read_recovery_file(autosave.file).document == saved.bridge.document
        autosave.finish()

    def test_what_was_undone_to_what_is_saved_leaves_nothing(self, saved: OpenProject, autosave: Autosave) -> None:
        turn(saved, 10.0)
        autosave.keep()
        saved.bridge.session.undo()
        autosave.wait()
        assert recovery_files_in(autosave.file.parent) == ()
        autosave.finish()

    def test_leaving_it_keeps_the_last_step(self, saved: OpenProject, autosave: Autosave) -> None:
        turn(saved, 55.0)
        autosave.finish(leave=True)
        (file,) = left_behind(autosave.file.parent)
        assert read_recovery_file(file).document == saved.bridge.document


class TestWhereItFails:
    def test_it_is_kept_elsewhere_and_said(
        self, qtbot: QtBot, saved: OpenProject, autosave: Autosave, settings: Settings
    ) -> None:
        spoil(settings.recovery_folder)
        turn(saved, 44.0)
        with qtbot.waitSignal(autosave.kept_elsewhere) as said:
            autosave.keep()
        assert said.args is not None
        assert str(settings.spare_recovery_folder) in said.args[0]
        (file,) = recovery_files_in(settings.spare_recovery_folder)
        assert read_recovery_file(file).document == saved.bridge.document
        assert left_behind(settings.spare_recovery_folder) == (), "this program lives"
        settings.recovery_folder.unlink()
        turn(saved, 45.0)
        with qtbot.waitSignal(autosave.kept):
            autosave.keep()
        assert recovery_files_in(settings.spare_recovery_folder) == (), "one copy is enough"
        (file,) = recovery_files_in(settings.recovery_folder)
        assert read_recovery_file(file).document == saved.bridge.document
        autosave.finish()

    def test_it_is_said_and_tried_again_soon_then_at_longer_steps(
        self, qtbot: QtBot, saved: OpenProject, autosave: Autosave, settings: Settings
    ) -> None:
        spoil(settings.recovery_folder)
        spoil(settings.spare_recovery_folder)
        turn(saved, 44.0)
        pauses = []
        for _ in range(len(RETRY_MS) + 1):
            with qtbot.waitSignal(autosave.failed) as said:
                autosave.keep()
            assert said.args is not None
            assert str(settings.recovery_folder) in said.args[0]
            assert autosave.is_waiting
            pauses.append(autosave._shortly.interval())
        assert pauses == [*RETRY_MS, RETRY_MS[-1]]
        settings.recovery_folder.unlink()
        autosave._shortly.start(0)
        qtbot.waitUntil(lambda: len(recovery_files_in(settings.recovery_folder)) == 1)
        qtbot.waitUntil(lambda: autosave.retry_ms == 0)
        autosave.finish()

    def test_a_failed_time_leaves_the_one_before(
        self, qtbot: QtBot, saved: OpenProject, autosave: Autosave, settings: Settings, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        spoil(settings.spare_recovery_folder)
        turn(saved, 44.0)
        with qtbot.waitSignal(autosave.kept):
            autosave.keep()
        before = autosave.file.read_bytes()
        monkeypatch.setattr(Path, "write_bytes", lambda _path, _data: (_ for _ in ()).throw(OSError(28, "full")))
        turn(saved, 45.0)
        with qtbot.waitSignal(autosave.failed) as said:
            autosave.keep()
        assert said.args is not None
        assert "no space left" in said.args[0]
        assert autosave.file.read_bytes() == before
        monkeypatch.undo()
        autosave.finish()

    def test_a_document_that_no_project_can_hold_is_said(
        self, qtbot: QtBot, saved: OpenProject, autosave: Autosave
    ) -> None:
        session = saved.bridge.session
        turn(saved, 5.0)
        # Past the session's own guard, as only what was found in pictures is.
        session.amend(lambda document: replace(document, canvas=Canvas(64, 48, length_frames=2_000_000)))
        with qtbot.waitSignal(autosave.failed) as said:
            autosave.keep()
        assert said.args is not None
        assert "2000000 is not a whole number" in said.args[0]
        session.mark_saved()
        autosave.finish()

    def test_the_bar_says_it_and_is_silent_when_it_works_again(
        self, qtbot: QtBot, settings: Settings, cels: Path
    ) -> None:
        application = QApplication.instance()
        assert isinstance(application, QApplication)
        spoil(settings.recovery_folder)
        spoil(settings.spare_recovery_folder)
        program = Application(application, settings)
        program.show()
        program.window.parts.project.bring([cels])
        program.window.parts.bar.clear()
        turn(program.open_project, 12.0)
        qtbot.waitUntil(lambda: "cannot be put aside" in program.window.parts.bar.text)
        settings.recovery_folder.unlink()
        program.autosave.keep()
        qtbot.waitUntil(lambda: program.window.parts.bar.text == "")
        program.put_away()

    def test_after_an_incident_the_log_says_where_the_work_lies(
        self, settings: Settings, cels: Path, caplog: pytest.LogCaptureFixture
    ) -> None:
        application = QApplication.instance()
        assert isinstance(application, QApplication)
        program = Application(application, settings)
        program.window.parts.project.bring([cels])
        turn(program.open_project, 12.0)
        with caplog.at_level(logging.INFO, "kagezou"):
            program.keep_after_incident()
        program.autosave.wait()
        kept = program.autosave.file
        assert f"unsaved work is kept in {kept}" in caplog.text
        assert read_recovery_file(kept).document == program.open_project.bridge.document
        program.put_away()


class TestWhatWasRecovered:
    @pytest.fixture
    def left(self, saved: OpenProject, tmp_path: Path) -> Path:
        """What a program that is gone put aside."""
        file = tmp_path / "unsaved" / "left.keepsake"
        document = set_constant(saved.bridge.document, DECLINATION, 66.0)
        keep(file, RecoveredWork(document, "walk", saved.path, 1_790_000_000, 3, saved.seen))
        return file

    def test_it_is_kept_anew_before_the_old_one_goes(self, saved: OpenProject, autosave: Autosave, left: Path) -> None:
        work = read_recovery_file(left)
        saved.recover(work)
        autosave.adopt(left)
        autosave.wait()
        assert not left.exists()
        assert read_recovery_file(autosave.file).document == work.document
        autosave.finish()
        assert list(left.parent.iterdir()) == []

    def test_where_it_cannot_be_kept_anew_the_old_one_stays(
        self, qtbot: QtBot, saved: OpenProject, settings: Settings, left: Path, tmp_path: Path
    ) -> None:
        spoil(tmp_path / "closed")
        spoil(settings.spare_recovery_folder)
        autosave = Autosave(saved, tmp_path / "closed", lambda: "walk", settings.spare_recovery_folder)
        work = read_recovery_file(left)
        saved.recover(work)
        with qtbot.waitSignal(autosave.failed):
            autosave.adopt(left)
        assert read_recovery_file(left) == work
        assert left_behind(left.parent) == (), "nobody else takes it meanwhile"
        autosave.finish(leave=True)
        assert left_behind(left.parent) == (left,)

    def test_where_the_old_one_cannot_be_removed_it_is_offered_again(
        self, saved: OpenProject, autosave: Autosave, left: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        unlink = Path.unlink

        def refuse(path: Path, missing_ok: bool = False) -> None:
            if path == left:
                raise OSError(30, "read-only")
            unlink(path, missing_ok=missing_ok)

        monkeypatch.setattr(Path, "unlink", refuse)
        saved.recover(read_recovery_file(left))
        autosave.adopt(left)
        autosave.wait()
        assert read_recovery_file(autosave.file).document == saved.bridge.document
        autosave.finish(leave=True)
        assert set(left_behind(left.parent)) == {left, autosave.file}

    def test_saving_it_leaves_nothing(self, saved: OpenProject, autosave: Autosave, left: Path) -> None:
        saved.recover(read_recovery_file(left))
        autosave.adopt(left)
        assert saved.path is not None
        saved.save(saved.path)
        autosave.finish()
        assert list(left.parent.iterdir()) == []

    def test_other_work_opened_over_it_is_kept_apart(self, saved: OpenProject, autosave: Autosave, left: Path) -> None:
        saved.recover(read_recovery_file(left))
        autosave.adopt(left)
        assert saved.path is not None
        saved.open(saved.path).at_once()
        autosave.wait()
        assert recovery_files_in(left.parent) == (), "it was given up"
        turn(saved, 5.0)
        autosave.keep()
        autosave.wait()
        assert read_recovery_file(autosave.file).edits == 1
        autosave.finish()

    def test_a_folder_that_takes_no_lock_hides_nothing(self, left: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        class Refused(QLockFile):
            def tryLock(self, _timeout: int = 0) -> bool:
                return False

            def error(self) -> QLockFile.LockError:
                return QLockFile.LockError.PermissionError

        monkeypatch.setattr(keepsakes, "QLockFile", Refused)
        assert left_behind(left.parent) == (left,)
