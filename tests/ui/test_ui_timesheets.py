"""Timesheets in the window: opened, dropped, and written."""

from pathlib import Path

import pytest
from PySide6.QtWidgets import QFileDialog, QMessageBox
from pytestqt.qtbot import QtBot

from kagezou.io.timesheet import SheetTrack, Timesheet
from kagezou.io.xdts import read_timesheet, write_xdts
from kagezou.ui.arrivals import arrivals_of
from kagezou.ui.desk import Desk
from kagezou.ui.dialogs import Answer
from kagezou.ui.main_window import MainWindow
from kagezou.ui.settings import Settings


@pytest.fixture
def sheet(cels: Path) -> Path:
    """A sheet beside the folder of the walker's drawings."""
    path = cels.parent / "c012.xdts"
    write_xdts(path, Timesheet("c012", 30, (SheetTrack("walker", ((0, "1"), (9, "4"), (20, None))),)))
    return path


@pytest.fixture
def plain(qtbot: QtBot, settings: Settings) -> MainWindow:
    made = MainWindow(Desk(), settings)
    qtbot.addWidget(made)
    return made


def test_a_sheet_begins_a_project_of_the_drawings_beside_it(plain: MainWindow, sheet: Path) -> None:
    assert plain.project.open_path(sheet)
    document = plain.desk.bridge.document
    assert document.canvas.length_frames == 30
    assert [exposure.frame for exposure in document.layers[0].cels.exposures] == [1, 10, 21]
    assert not plain.desk.is_saved
    assert plain.desk.path is None
    plain.close_unasked()


def test_a_sheet_dropped_on_a_project_times_it_in_one_step(plain: MainWindow, cels: Path, sheet: Path) -> None:
    plain.project.bring([cels])
    before = plain.desk.bridge.document
    plain.project.bring([sheet])
    assert plain.desk.bridge.document.canvas.length_frames == 30
    assert plain.desk.bridge.session.undo_name == "Apply timesheet"
    plain.desk.bridge.session.undo()
    assert plain.desk.bridge.document is before
    plain.close_unasked()


def test_a_sheet_that_is_opened_puts_the_project_away(
    plain: MainWindow, cels: Path, sheet: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plain.project.bring([cels, cels.parent])
    monkeypatch.setattr(plain.project.dialogs, "project_to_open", lambda: sheet)
    monkeypatch.setattr(plain.project.dialogs, "unsaved", lambda _name: Answer.CANCEL)
    before = plain.desk.bridge.document
    plain.actions_of["open"].trigger()
    assert plain.desk.bridge.document is before
    monkeypatch.setattr(plain.project.dialogs, "unsaved", lambda _name: Answer.DISCARD)
    plain.actions_of["open"].trigger()
    document = plain.desk.bridge.document
    assert [layer.name for layer in document.layers] == ["walker"]
    assert document.canvas.length_frames == 30
    assert not plain.desk.is_saved
    plain.close_unasked()


def test_a_sheet_without_drawings_is_one_sentence(plain: MainWindow, tmp_path: Path) -> None:
    write_xdts(tmp_path / "alone.xdts", Timesheet("", 12, (SheetTrack("Q", ((0, "1"),)),)))
    assert not plain.project.open_path(tmp_path / "alone.xdts")
    assert "there are no drawings of its columns (Q)" in plain.bar.text
    assert plain.desk.is_blank
    plain.close_unasked()


def test_the_window_asks_for_sheets_and_writes_them(
    plain: MainWindow, cels: Path, sheet: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plain.project.bring([cels])
    monkeypatch.setattr(plain.project.dialogs, "timesheet", lambda: sheet)
    plain.actions_of["import_timesheet"].trigger()
    monkeypatch.setattr(plain.project.dialogs, "timesheet_to_save", lambda _name: tmp_path / "written")
    plain.actions_of["export_timesheet"].trigger()
    assert read_timesheet(tmp_path / "written.xdts").tracks == read_timesheet(sheet).tracks
    plain.close_unasked()


@pytest.mark.parametrize("name", ["a.xdts", "a.TDTS", "a.sts"])
def test_sheets_are_known_by_their_names(tmp_path: Path, name: str) -> None:
    assert arrivals_of([tmp_path / name]).timesheet == tmp_path / name
    assert not arrivals_of([tmp_path / name]).is_empty


def test_a_name_that_gets_its_suffix_replaces_nothing_unasked(
    plain: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    dialogs = plain.project.dialogs
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_words: (str(tmp_path / "c012"), ""))
    assert dialogs.timesheet_to_save("c012.xdts") == tmp_path / "c012.xdts"
    (tmp_path / "c012.xdts").write_text("mine")
    (tmp_path / "c012.kage").write_text("mine")
    asked: list[str] = []

    def answer(box: QMessageBox) -> int:
        asked.append(box.text())
        buttons = QMessageBox.StandardButton
        return (buttons.Cancel if len(asked) < 3 else buttons.Yes).value

    monkeypatch.setattr(QMessageBox, "exec", answer)
    assert dialogs.timesheet_to_save("c012.xdts") is None
    assert dialogs.project_to_save("c012.kage") is None
    assert dialogs.timesheet_to_save("c012.xdts") == tmp_path / "c012.xdts"
    assert ["c012.xdts" in words for words in asked] == [True, False, True]
    plain.close_unasked()
