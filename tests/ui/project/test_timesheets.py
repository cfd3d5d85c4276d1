"""Timesheets in the window: opened, dropped, and written."""

from pathlib import Path

import pytest
from PySide6.QtWidgets import QFileDialog, QMessageBox
from pytestqt.qtbot import QtBot

from kagezou.io.sheets.reading import read_timesheet
from kagezou.io.sheets.timesheet import SheetTrack, Timesheet
from kagezou.io.sheets.xdts_writing import write_xdts
from kagezou.ui.project.dialogs import Answer
from kagezou.ui.project.dropped_files import dropped_files_of
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.system.settings import Settings
from kagezou.ui.window.main_window import MainWindow
from tests.ui.viewing import OwnClipboard


@pytest.fixture
def sheet(cels: Path) -> Path:
    """A sheet beside the folder of the walker's drawings."""
    path = cels.parent / "c012.xdts"
    write_xdts(path, Timesheet("c012", 30, (SheetTrack("walker", ((0, "1"), (9, "4"), (20, None))),)))
    return path


@pytest.fixture
def plain(qtbot: QtBot, settings: Settings) -> MainWindow:
    made = MainWindow(OpenProject(), settings, OwnClipboard())
    qtbot.addWidget(made)
    return made


def test_a_sheet_begins_a_project_of_the_drawings_beside_it(plain: MainWindow, sheet: Path) -> None:
    assert plain.parts.project.open_path(sheet)
    document = plain.parts.open_project.bridge.document
    assert document.canvas.length_frames == 30
    assert [exposure.frame for exposure in document.layers[0].cels.exposures] == [1, 10, 21]
    assert not plain.parts.open_project.is_saved
    assert plain.parts.open_project.path is None
    plain.close_unasked()


def test_a_sheet_dropped_on_a_project_times_it_in_one_step(plain: MainWindow, cels: Path, sheet: Path) -> None:
    plain.parts.project.bring([cels])
    before = plain.parts.open_project.bridge.document
    plain.parts.project.bring([sheet])
    assert plain.parts.open_project.bridge.document.canvas.length_frames == 30
    assert plain.parts.open_project.bridge.session.undo_name == "Apply timesheet"
    plain.parts.open_project.bridge.session.undo()
    assert plain.parts.open_project.bridge.document is before
    plain.close_unasked()


def test_a_sheet_that_is_opened_puts_the_project_away(
    plain: MainWindow, cels: Path, sheet: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plain.parts.project.bring([cels, cels.parent])
    monkeypatch.setattr(plain.parts.project.dialogs, "project_to_open", lambda: sheet)
    monkeypatch.setattr(plain.parts.project.dialogs, "unsaved", lambda _name: Answer.CANCEL)
    before = plain.parts.open_project.bridge.document
    plain.parts.actions["open"].trigger()
    assert plain.parts.open_project.bridge.document is before
    monkeypatch.setattr(plain.parts.project.dialogs, "unsaved", lambda _name: Answer.DISCARD)
    plain.parts.actions["open"].trigger()
    document = plain.parts.open_project.bridge.document
    assert [layer.name for layer in document.layers] == ["walker"]
    assert document.canvas.length_frames == 30
    assert not plain.parts.open_project.is_saved
    plain.close_unasked()


def test_a_sheet_without_drawings_is_one_sentence(plain: MainWindow, tmp_path: Path) -> None:
    write_xdts(tmp_path / "alone.xdts", Timesheet("", 12, (SheetTrack("Q", ((0, "1"),)),)))
    assert not plain.parts.project.open_path(tmp_path / "alone.xdts")
    assert "there are no drawings of its columns (Q)" in plain.parts.bar.text
    assert plain.parts.open_project.is_blank
    plain.close_unasked()


def test_the_window_asks_for_sheets_and_writes_them(
    plain: MainWindow, cels: Path, sheet: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plain.parts.project.bring([cels])
    monkeypatch.setattr(plain.parts.project.dialogs, "timesheet", lambda: sheet)
    plain.parts.actions["import_timesheet"].trigger()
    monkeypatch.setattr(plain.parts.project.dialogs, "timesheet_to_save", lambda _name: tmp_path / "written")
    plain.parts.actions["export_timesheet"].trigger()
    assert read_timesheet(tmp_path / "written.xdts").tracks == read_timesheet(sheet).tracks
    plain.close_unasked()


@pytest.mark.parametrize("name", ["a.xdts", "a.TDTS", "a.sts"])
def test_sheets_are_known_by_their_names(tmp_path: Path, name: str) -> None:
    assert dropped_files_of([tmp_path / name]).timesheet == tmp_path / name
    assert not dropped_files_of([tmp_path / name]).is_empty


def test_a_name_that_gets_its_suffix_replaces_nothing_unasked(
    plain: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    dialogs = plain.parts.project.dialogs
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
