"""What runs after an export of the window: beside it, told in its result, ended by Cancel."""

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QToolButton
from pytestqt.qtbot import QtBot

from kagezou.export.after.hooks import COMMAND_VARIABLE
from kagezou.export.choices import ExportChoices, Place
from kagezou.ui.export.dialog import ExportDialog
from kagezou.ui.export.result import ExportResult
from kagezou.ui.system.preferences import preferences_in, remember_preferences
from kagezou.ui.system.settings import Settings
from kagezou.ui.window.main_window import MainWindow
from kagezou.ui.window.preferences_dialog import PreferencesDialog


@pytest.fixture(autouse=True)
def _none_by_the_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(COMMAND_VARIABLE, raising=False)


def script(folder: Path, text: str) -> str:
    path = folder / "publish.py"
    path.write_text("import json, os, sys, time\n" + text)
    return f"'{path}'"


def start(window: MainWindow, folder: Path) -> None:
    """Export as a hand does: by the dialog."""
    window.parts.actions["export"].trigger()
    (dialog,) = window.findChildren(ExportDialog)
    dialog.chosen.emit(ExportChoices(), Place(folder / "out", None, "walk"))
    dialog.close()


def result(qtbot: QtBot, window: MainWindow) -> ExportResult:
    qtbot.waitUntil(lambda: not window.parts.exporting.is_running)
    qtbot.waitUntil(lambda: len(window.findChildren(ExportResult)) == 1)
    return window.findChildren(ExportResult)[0]


def prefer(settings: Settings, command: str) -> None:
    preferences = preferences_in(settings)
    remember_preferences(settings, type(preferences)(preferences.memory_mb, preferences.surround, "", command))


def test_a_command_of_the_preferences_runs_and_is_told(
    qtbot: QtBot, walking: MainWindow, settings: Settings, tmp_path: Path
) -> None:
    said = "print(len(json.load(open(sys.argv[-1], encoding='utf-8'))['files']), 'files taken')\n"
    prefer(settings, script(tmp_path, said))
    start(walking, tmp_path)
    assert result(qtbot, walking).notes == ["Handed on to publish.py: 6 files taken"]


def test_one_that_fails_leaves_the_export_whole(
    qtbot: QtBot, walking: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(COMMAND_VARIABLE, script(tmp_path, "sys.exit('no such task')\n"))
    start(walking, tmp_path)
    shown = result(qtbot, walking)
    assert shown.title.text() == "The export is complete."
    assert shown.notes == ["The export is whole, but publish.py failed with code 1: no such task"]


def test_one_that_hangs_freezes_nothing_and_is_ended_by_cancel(
    qtbot: QtBot, walking: MainWindow, settings: Settings, tmp_path: Path
) -> None:
    begun = tmp_path / "begun"
    prefer(settings, script(tmp_path, f"open({str(begun)!r}, 'w').close()\ntime.sleep(600)\n"))
    start(walking, tmp_path)
    qtbot.waitUntil(begun.exists)
    stop = walking.parts.exporting.findChild(QToolButton)
    assert stop is not None
    qtbot.mouseClick(stop, Qt.MouseButton.LeftButton)
    assert result(qtbot, walking).notes == ["publish.py was stopped; the export is whole"]


def test_a_command_that_cannot_be_is_told_with_the_export(
    qtbot: QtBot, walking: MainWindow, settings: Settings, tmp_path: Path
) -> None:
    prefer(settings, "publish 'x")
    start(walking, tmp_path)
    shown = result(qtbot, walking)
    assert shown.title.text() == "The export is complete."
    assert "has no end" in shown.notes[0]


def test_the_command_is_typed_in_the_preferences(
    qtbot: QtBot, walking: MainWindow, settings: Settings, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(COMMAND_VARIABLE, "studio-publish")
    walking.parts.actions["preferences"].trigger()
    (dialog,) = walking.findChildren(PreferencesDialog)
    assert dialog.after_export.placeholderText() == "studio-publish"
    dialog.after_export.setText("  mine --now ")
    qtbot.keyClick(dialog.after_export, Qt.Key.Key_Return)
    assert preferences_in(settings).after_export == "mine --now"
