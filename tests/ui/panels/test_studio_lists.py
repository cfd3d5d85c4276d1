"""A studio's own styles, presets and shortcuts in the lists of the window: marked, chosen like others, not changed."""

import json
from pathlib import Path
from types import MappingProxyType

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from kagezou.document.local_name import LocalName
from kagezou.document.style import Style
from kagezou.export.choices import ExportChoices
from kagezou.export.presets import save_preset
from kagezou.io.clips.shortcut_files import KeySet, save_key_set
from kagezou.io.clips.style_files import bundled_styles, save_style
from kagezou.locations import PRESET_FOLDERS, SHORTCUT_FOLDERS, STYLE_FOLDERS
from kagezou.ui.export.preset_row import PresetRow
from kagezou.ui.panels.style_list import StyleList
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.system.settings import Settings
from kagezou.ui.window.main_window import MainWindow
from tests.ui.viewing import OwnClipboard


@pytest.fixture
def studio(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "studio"
    for name, variable in (("styles", STYLE_FOLDERS), ("presets", PRESET_FOLDERS), ("keys", SHORTCUT_FOLDERS)):
        (folder / name).mkdir(parents=True)
        monkeypatch.setenv(variable, str(folder / name))
    return folder


def test_styles(qtbot: QtBot, walking: MainWindow, settings: Settings, studio: Path) -> None:
    path = save_style(studio / "styles", Style(LocalName("Dusk"), 100.0, MappingProxyType({})))
    styles = StyleList(walking.parts.bridge, settings)
    qtbot.addWidget(styles)
    row = len(bundled_styles())
    item = styles.list.item(row)
    assert item.text() == "◇ Dusk"
    assert item.data(Qt.ItemDataRole.AccessibleTextRole) == "Dusk (studio)"
    assert styles.list.item(0).text() == "Natural"
    assert str(studio / "styles") in item.toolTip()
    styles.list.setCurrentRow(row)
    styles.remove_current()
    assert path.exists()
    steps = walking.parts.bridge.session.history.made
    styles.apply(row)
    assert walking.parts.bridge.session.history.made >= steps


def test_a_broken_file_of_the_studio_is_said(walking: MainWindow, settings: Settings, studio: Path) -> None:
    (studio / "styles" / "broken.json").write_text("{")
    styles = StyleList(walking.parts.bridge, settings)
    said: list[str] = []
    styles.failed.connect(said.append)
    styles.reload()
    assert len(said) == 1
    assert "broken.json" in said[0]


def test_presets(qtbot: QtBot, studio: Path, tmp_path: Path) -> None:
    preset = save_preset(studio / "presets", "to the lab", ExportChoices(depth=16))
    row = PresetRow(tmp_path / "own")
    qtbot.addWidget(row)
    row.show_choices(ExportChoices(depth=16))
    row.reload()
    assert row.box.currentText() == "to the lab (studio)"
    assert not row.remove_button.isEnabled()
    assert not row.rename_button.isEnabled()
    row.remove()
    row.rename("mine")
    assert json.loads(preset.path.read_text())["name"] == "to the lab"
    row.save("to the lab")
    assert row.box.currentText() == "to the lab"
    assert row.remove_button.isEnabled()


def test_shortcuts(qtbot: QtBot, filled: OpenProject, settings: Settings, studio: Path) -> None:
    save_key_set(studio / "keys" / "ours.json", KeySet("", LocalName("Ours"), MappingProxyType({"undo": ("F5",)})))
    (studio / "keys" / "broken.json").write_text("{")
    window = MainWindow(filled, settings, OwnClipboard())
    qtbot.addWidget(window, before_close_func=MainWindow.close_unasked)
    assert "broken.json" in window.parts.bar.text
    editor = window.parts.keyboard.edit()
    assert editor.sets.itemText(editor.sets.count() - 1) == "Ours (studio)"
    editor.sets.setCurrentIndex(editor.sets.count() - 1)
    assert editor.shortcuts.keys["undo"] == ("F5",)
