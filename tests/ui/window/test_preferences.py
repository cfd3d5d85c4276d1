"""Preferences: each takes effect at once and is remembered, the language when the dialog is closed."""

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QColor
from PySide6.QtWidgets import QColorDialog, QComboBox, QWidget
from pytestqt.qtbot import QtBot

from kagezou.io.images.cel_cache import CelCache
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.system.preferences import (
    LEAST_MEMORY_MB,
    Preferences,
    most_memory_mb,
    preferences_in,
    remember_preferences,
    usual_preferences,
)
from kagezou.ui.system.settings import Settings
from kagezou.ui.viewport.resolution import Resolution
from kagezou.ui.window.main_window import MainWindow
from kagezou.ui.window.preferences_dialog import PreferencesDialog, surrounds
from tests.ui.viewing import OwnClipboard

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def plain(qtbot: QtBot, settings: Settings, filled: OpenProject) -> MainWindow:
    made = MainWindow(filled, settings, OwnClipboard())
    qtbot.addWidget(made, before_close_func=MainWindow.close_unasked)
    return made


@pytest.fixture
def dialog(plain: MainWindow) -> PreferencesDialog:
    plain.parts.actions["preferences"].trigger()
    (opened,) = plain.findChildren(PreferencesDialog)
    return opened


def typed(qtbot: QtBot, field: QWidget, text: str) -> None:
    select = getattr(field, "selectAll", None)
    assert callable(select)
    select()
    qtbot.keyClicks(field, text)
    qtbot.keyClick(field, Qt.Key.Key_Return)


def choose(qtbot: QtBot, box: QComboBox, data: object) -> None:
    """Choose an item with the keys, as a person does."""
    wanted = box.findData(data)
    assert wanted >= 0
    qtbot.keyClick(box, Qt.Key.Key_Home)
    for _ in range(wanted):
        qtbot.keyClick(box, Qt.Key.Key_Down)


def test_it_lies_where_every_system_has_it(plain: MainWindow) -> None:
    assert plain.parts.actions["preferences"].menuRole() is QAction.MenuRole.PreferencesRole


def test_memory_takes_effect_and_is_remembered(
    qtbot: QtBot, plain: MainWindow, dialog: PreferencesDialog, settings: Settings
) -> None:
    cels = plain.parts.open_project.cels
    assert cels.limit_bytes == 512 << 20
    typed(qtbot, dialog.memory, "256")
    assert cels.limit_bytes == 256 << 20
    assert preferences_in(settings).memory_mb == 256


def test_what_is_too_much_goes_at_once(cels: Path) -> None:
    kept, paths = CelCache(), sorted(cels.iterdir())
    sizes = [kept.cel(path).nbytes for path in paths]
    kept.limit(sum(sizes[-2:]))
    assert kept.nbytes == sum(sizes[-2:])
    assert kept.kept_sources() == frozenset(paths[-2:])


def test_the_surroundings_change_under_the_dialog(
    qtbot: QtBot, plain: MainWindow, dialog: PreferencesDialog, settings: Settings
) -> None:
    viewpoint = plain.parts.viewport.viewpoint
    assert viewpoint.surround == QColor("#484848")
    choose(qtbot, dialog.surround, surrounds()["Light grey"])
    assert viewpoint.surround == QColor("#9a9a9a")
    qtbot.mouseClick(dialog.swatch, LEFT)
    (picker,) = dialog.findChildren(QColorDialog)
    picker.setCurrentColor(QColor("#123456"))
    assert viewpoint.surround == QColor("#123456")
    assert dialog.surround.currentData() is None
    picker.reject()
    assert viewpoint.surround == QColor("#9a9a9a"), "what was only tried is taken back"
    assert preferences_in(settings).surround == "#9a9a9a"


def test_a_new_window_begins_with_what_was_preferred(qtbot: QtBot, settings: Settings, filled: OpenProject) -> None:
    remember_preferences(settings, Preferences(128, "#9a9a9a"))
    settings.set_word("resolution", Resolution.HALF.value)
    window = MainWindow(filled, settings, OwnClipboard())
    qtbot.addWidget(window, before_close_func=MainWindow.close_unasked)
    assert window.parts.open_project.cels.limit_bytes == 128 << 20
    assert window.parts.viewport.viewpoint.surround == QColor("#9a9a9a")
    window.parts.actions["preferences"].trigger()
    (dialog,) = window.findChildren(PreferencesDialog)
    assert dialog.resolution.currentData() == Resolution.HALF.value
    assert dialog.memory.value() == 128


def test_notes_bear_the_name_that_was_typed(
    qtbot: QtBot, plain: MainWindow, dialog: PreferencesDialog, settings: Settings
) -> None:
    before = plain.parts.curves.made().notes.author
    assert before == dialog.author.placeholderText()
    typed(qtbot, dialog.author, "Sato")
    assert plain.parts.curves.made().notes.author == "Sato"
    assert preferences_in(settings).author == "Sato"
    typed(qtbot, dialog.author, " ")
    assert plain.parts.curves.made().notes.author == before, "without one the system's name is taken again"


def test_the_resolution_is_that_of_the_menu(qtbot: QtBot, plain: MainWindow, dialog: PreferencesDialog) -> None:
    choose(qtbot, dialog.resolution, Resolution.QUARTER.value)
    assert plain.parts.viewport.resolution is Resolution.QUARTER
    assert [action.isChecked() for action in plain.parts.menus.resolutions.actions()] == [False, False, False, True]


def test_another_language_waits_until_the_dialog_is_closed(
    qtbot: QtBot, plain: MainWindow, dialog: PreferencesDialog
) -> None:
    said: list[str] = []
    plain.language_chosen.connect(said.append)
    choose(qtbot, dialog.language, "ja")
    assert said == []
    dialog.accept()
    qtbot.waitUntil(lambda: said == ["ja"])


def test_a_dialog_that_is_closed_as_it_was_changes_no_language(qtbot: QtBot, dialog: PreferencesDialog) -> None:
    with qtbot.assertNotEmitted(dialog.language_chosen):
        dialog.reject()


def test_a_settled_folder_is_where_to_begin(
    qtbot: QtBot, dialog: PreferencesDialog, settings: Settings, tmp_path: Path
) -> None:
    settings.remember_folder("cels", tmp_path / "walker")
    field = dialog.folders["cels"]
    typed(qtbot, field, str(tmp_path))
    assert settings.folder("cels") == str(tmp_path)
    typed(qtbot, field, str(tmp_path / "nowhere"))
    assert "there is no such folder" in dialog.says.text()
    assert field.text() == str(tmp_path)
    field.clear()
    qtbot.keyClick(field, Qt.Key.Key_Return)
    assert settings.folder("cels") == str(tmp_path / "walker")


@pytest.mark.parametrize("memory", ["", "much", "-5", "²", "0", "99999999", "9" * 40])
def test_what_is_remembered_wrongly_costs_nothing(settings: Settings, memory: str) -> None:
    settings.set_word("memory_mb", memory)
    settings.set_word("surround", "tinted")
    found = preferences_in(settings)
    assert LEAST_MEMORY_MB <= found.memory_mb <= most_memory_mb()
    assert found.surround == usual_preferences().surround
