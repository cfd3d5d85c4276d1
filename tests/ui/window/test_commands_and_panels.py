"""The frame of the window: commands found and run, their keys shown and changed, panels hidden and put back."""

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDockWidget, QLineEdit, QMenu, QWidget
from pytestqt.qtbot import QtBot

from kagezou.document.edits import set_exposures
from kagezou.document.model import Exposure, Marker
from kagezou.document.review import set_marker
from kagezou.ui.commands.actions import Actions
from kagezou.ui.commands.search import CommandSearch
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.system.language import Language
from kagezou.ui.system.settings import Settings
from kagezou.ui.window.main_window import MainWindow
from tests.ui.viewing import OwnClipboard

CTRL_SHIFT = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier
AWAITED = {
    *("save_increment", "velocity", "curves"),
    "first_cut",  # leads through the demo, which this window has not
}
"""Commands of parts that may not be there; whoever makes one says what it does by ``Actions.on``."""


def search_of(window: MainWindow) -> CommandSearch:
    found = window.findChild(CommandSearch)
    assert isinstance(found, CommandSearch)
    return found


def names_found(search: CommandSearch) -> list[str]:
    return [search.model.index(row, 0).data() for row in range(search.model.rowCount())]


def shown_docks(window: MainWindow) -> set[str]:
    return {dock.objectName() for dock in window.findChildren(QDockWidget) if not dock.isHidden()}


class TestActions:
    def test_only_commands_of_parts_that_are_not_there_are_hidden(self, window: MainWindow) -> None:
        hidden = {
            command.name
            for command in window.parts.actions.commands
            if not window.parts.actions.is_answered(command.name)
        }
        assert hidden <= AWAITED, "commands without Actions.on or Actions.on_toggled"

    def test_a_command_nobody_answers_shows_up_once_someone_does(self, qtbot: QtBot) -> None:
        owner = QWidget()
        qtbot.addWidget(owner)
        actions = Actions(owner)
        done: list[str] = []
        assert not actions["velocity"].isVisible()
        assert not actions["velocity"].isEnabled()
        actions.on("velocity", lambda: done.append("velocity"))
        assert actions["velocity"].isVisible()
        actions["velocity"].trigger()
        assert done == ["velocity"]

    def test_a_command_goes_to_the_part_that_has_the_keyboard(
        self, qtbot: QtBot, focus: Callable[[QWidget], None]
    ) -> None:
        owner = QWidget()
        qtbot.addWidget(owner)
        curves, field = QWidget(owner), QLineEdit(owner)
        inside = QLineEdit(curves)
        actions = Actions(owner)
        done: list[str] = []
        actions.on("fit", lambda: done.append("picture"))
        actions.on("fit", lambda: done.append("curves"), within=curves)
        owner.show()
        for focused in (field, inside, field):
            focus(focused)
            actions["fit"].trigger()
        assert done == ["picture", "curves", "picture"]

    def test_tool_tips_carry_the_keys(self, window: MainWindow) -> None:
        for command in window.parts.actions.commands:
            for key in command.keys[:1]:
                native = QKeySequence(key).toString(QKeySequence.SequenceFormat.NativeText)
                assert f"({native})" in window.parts.actions[command.name].toolTip()


class TestTime:
    def test_the_playhead_goes_from_drawing_to_drawing_and_from_marker_to_marker(self, walking: MainWindow) -> None:
        session, actions = walking.parts.open_project.bridge.session, walking.parts.actions
        document = session.document
        layer = document.layers[0]
        held = set_exposures(document, layer.id, (Exposure(1, 0), Exposure(3, 1), Exposure(6, None)))
        session.edit("Hold", set_marker(held, Marker(2, "step")))
        for name, frame in (("drawing_next", 3), ("drawing_next", 6), ("drawing_previous", 3), ("marker_previous", 2)):
            actions[name].trigger()
            assert walking.parts.open_project.bridge.frame == frame, name
        actions["marker_next"].trigger()
        assert walking.parts.open_project.bridge.frame == 2, "there is no further one"

    def test_a_frame_is_typed(self, qtbot: QtBot, active: MainWindow) -> None:
        QTest.keyClick(active, Qt.Key.Key_G, Qt.KeyboardModifier.ControlModifier)
        field = active.parts.time.transport.frame_field
        qtbot.waitUntil(field.hasFocus)
        QTest.keyClicks(field, "4")
        QTest.keyClick(field, Qt.Key.Key_Return)
        assert active.parts.open_project.bridge.frame == 4


class TestSearch:
    def test_it_opens_finds_and_runs(self, qtbot: QtBot, active: MainWindow) -> None:
        active.parts.viewport.setFocus()
        qtbot.waitUntil(active.parts.viewport.hasFocus)
        QTest.keyClick(active, Qt.Key.Key_P, CTRL_SHIFT)
        search = search_of(active)
        qtbot.waitUntil(search.field.hasFocus)
        assert len(names_found(search)) > 30
        QTest.keyClicks(search.field, "last fr")
        assert names_found(search)[0] == "Last Frame"
        QTest.keyClick(search.field, Qt.Key.Key_Return)
        qtbot.waitUntil(lambda: active.parts.open_project.bridge.frame == 6)
        assert not search.isVisible()
        qtbot.waitUntil(active.parts.viewport.hasFocus)

    def test_both_languages_are_found_in_both(self, qtbot: QtBot, active: MainWindow, english: Language) -> None:
        search = search_of(active)
        search.open()
        search.field.setText("保存")
        assert names_found(search)[:2] == ["Save", "Save As"]
        english.speak("ja")
        search.field.setText("save as")
        assert names_found(search)[0] == "Save As"
        QTest.keyClick(search.field, Qt.Key.Key_Escape)
        assert not search.isVisible()

    def test_what_the_menus_offer_beside_the_commands_is_found_too(self, active: MainWindow) -> None:
        search = search_of(active)
        search.open()
        search.field.setText("middle grey")
        assert names_found(search) == ["Middle Grey"]
        search.field.setText("inspector")
        assert names_found(search) == ["Inspector"]
        search.run_current()
        QApplication.processEvents()
        assert "inspector" not in shown_docks(active)

    def test_arrows_choose_and_what_was_run_lately_comes_first(self, qtbot: QtBot, active: MainWindow) -> None:
        search = search_of(active)
        search.open()
        search.field.setText("frame")
        second = names_found(search)[1]
        QTest.keyClick(search.field, Qt.Key.Key_Down)
        assert search.view.currentIndex().row() == 1
        QTest.keyClick(search.field, Qt.Key.Key_Return)
        search.open()
        assert names_found(search)[0] == second

    def test_what_cannot_be_done_now_is_not_run(self, qtbot: QtBot, window: MainWindow) -> None:
        search = search_of(window)
        search.open()
        search.field.setText("rename lay")
        assert names_found(search) == ["Rename Layer"]
        search.run_current()
        assert search.isVisible()
        search.field.setText("no such thing")
        search.run_current()
        assert search.isVisible()


class TestSheet:
    @pytest.mark.parametrize(
        ("key", "modifier"),
        [(Qt.Key.Key_F1, Qt.KeyboardModifier.ShiftModifier), (Qt.Key.Key_Slash, Qt.KeyboardModifier.ControlModifier)],
    )
    def test_its_keys_open_and_close_it(self, active: MainWindow, key: Qt.Key, modifier: Qt.KeyboardModifier) -> None:
        QTest.keyClick(active, key, modifier)
        sheet = active.parts.keyboard.show_sheet()
        assert not sheet.isVisible(), "the second time closes the one that the key opened"

    def test_rows_are_searched_by_words_of_both_languages_and_by_keys(self, active: MainWindow) -> None:
        sheet = active.parts.keyboard.show_sheet()
        for typed, words in (
            ("save as", "Save As"),
            ("ctrl+shift+s", "Save As"),
            ("名前を", "Save As"),
            ("wheel", "Zoom at the pointer"),
        ):
            sheet.field.setText(typed)
            shown = [row.words[0] for section in sheet.sections for row in section.rows if not row.isHidden()]
            assert words in shown
            assert len(shown) < 8
        sheet.close()


class TestEditor:
    def test_a_key_of_another_command_moves_only_when_asked(self, active: MainWindow, settings: Settings) -> None:
        editor = active.parts.keyboard.edit()
        editor.choose("fit")
        editor.keys.field.setKeySequence(QKeySequence("Ctrl+S"))
        editor.keys.field.editingFinished.emit()
        assert "Save" in editor.keys.note.text()
        assert editor.shortcuts.owner("Ctrl+S") == "save"
        editor.keys.move_here.click()
        assert editor.shortcuts.owner("Ctrl+S") == "fit"
        assert active.parts.actions["save"].shortcut() == QKeySequence("Ctrl+S"), "nothing changes before OK"
        editor.accept()
        assert QKeySequence("Ctrl+S") in active.parts.actions["fit"].shortcuts()
        assert active.parts.actions["save"].shortcuts() == []
        assert active.parts.actions["save"].toolTip() == "Save"

    def test_a_recorded_key_is_pressed_and_works(self, qtbot: QtBot, active: MainWindow) -> None:
        editor = active.parts.keyboard.edit()
        editor.choose("last")
        editor.keys.field.setFocus()
        QTest.keyClick(editor.keys.field, Qt.Key.Key_F7)
        qtbot.waitUntil(lambda: editor.shortcuts.owner("F7") == "last")
        editor.accept()
        QTest.keyClick(active, Qt.Key.Key_F7)
        assert active.parts.open_project.bridge.frame == 6

    def test_keys_of_the_picture_and_unsure_keys_are_said(self, active: MainWindow) -> None:
        editor = active.parts.keyboard.edit()
        editor.choose("about")
        for key, sentence in (("Space", "belongs to the picture"), (";", "Not every keyboard has ;")):
            editor.keys.field.setKeySequence(QKeySequence(key))
            editor.keys.field.editingFinished.emit()
            assert sentence in editor.keys.note.text()
        assert editor.shortcuts.own == {"about": (";",)}
        editor.keys.reset.click()
        assert editor.shortcuts.own == {}

    def test_sets_and_own_keys_are_remembered(
        self, qtbot: QtBot, active: MainWindow, open_project: OpenProject, settings: Settings
    ) -> None:
        editor = active.parts.keyboard.edit()
        editor.sets.setCurrentIndex(1)
        editor.choose("about")
        editor.keys.given.emit("F12")
        editor.accept()
        assert active.parts.actions["play"].shortcut() == QKeySequence("P")
        active.close_unasked()
        another = MainWindow(open_project, settings, OwnClipboard())
        assert another.parts.actions["play"].shortcut() == QKeySequence("P")
        assert another.parts.actions["about"].shortcut() == QKeySequence("F12")
        assert another.parts.keyboard.shortcuts.key_set.name.en == "OpenToonz"
        another.close_unasked()
        another.deleteLater()

    def test_what_cannot_be_read_of_the_remembered_keys_is_said(
        self, active: MainWindow, open_project: OpenProject, settings: Settings
    ) -> None:
        settings.set_word("own_shortcuts", "{{")
        active.close_unasked()
        another = MainWindow(open_project, settings, OwnClipboard())
        assert "shortcuts could not be read" in another.parts.bar.text
        assert another.parts.actions["save"].shortcut() == QKeySequence("Ctrl+S")
        another.close_unasked()
        another.deleteLater()

    def test_shortcuts_go_into_a_file_and_come_back(self, active: MainWindow, tmp_path: Path) -> None:
        editor = active.parts.keyboard.edit()
        editor.choose("about")
        editor.keys.given.emit("F12")
        editor.export_to(tmp_path / "mine")
        editor.reset_all()
        assert editor.shortcuts.owner("F12") is None
        editor.import_from(tmp_path / "mine.json")
        assert editor.shortcuts.own == {"about": ("F12",)}
        (tmp_path / "mine.json").write_text("[", encoding="utf-8")
        editor.import_from(tmp_path / "mine.json")
        assert "mine.json does not hold shortcuts" in editor.note.text()
        assert editor.shortcuts.own == {"about": ("F12",)}
        editor.reject()

    def test_commands_are_searched(self, active: MainWindow) -> None:
        editor = active.parts.keyboard.edit()
        for typed in ("save as", "Ctrl+Shift+S", "名前を付"):
            editor.field.setText(typed)
            shown = [name for name, item in editor._items.items() if not item.isHidden()]
            assert "save_as" in shown
            assert len(shown) < 5
        editor.reject()


class TestPanels:
    def test_panels_are_hidden_and_come_back_as_they_were(self, active: MainWindow) -> None:
        styles = next(dock for dock in active.docks.all if dock.objectName() == "styles")
        styles.close()
        before = shown_docks(active)
        active.parts.actions["hide_docks"].trigger()
        assert shown_docks(active) == set()
        active.parts.actions["hide_docks"].trigger()
        assert shown_docks(active) == before

    def test_tab_hides_them_while_nothing_has_the_keyboard_and_brings_them_back(
        self, qtbot: QtBot, active: MainWindow
    ) -> None:
        active.parts.viewport.setFocus()
        QTest.keyClick(active.parts.viewport, Qt.Key.Key_Tab)
        assert shown_docks(active), "over the picture Tab goes from handle to handle"
        assert active.parts.viewport.controller.selected_id is not None
        active.parts.viewport.clearFocus()
        QTest.keyClick(active, Qt.Key.Key_Tab)
        qtbot.waitUntil(lambda: not shown_docks(active))
        active.parts.viewport.setFocus()
        QTest.keyClick(active.parts.viewport, Qt.Key.Key_Tab)
        qtbot.waitUntil(lambda: bool(shown_docks(active)))

    def test_tab_still_goes_from_field_to_field(self, active: MainWindow) -> None:
        field = active.parts.time.transport.frame_field
        field.setFocus()
        QTest.keyClick(field, Qt.Key.Key_Tab)
        assert not field.hasFocus()
        assert shown_docks(active)

    def test_the_layout_is_reset(self, qtbot: QtBot, active: MainWindow) -> None:
        before = shown_docks(active)
        sizes = [dock.size() for dock in active.docks.all[:2]]
        active.docks.all[1].setFloating(True)
        active.docks.all[0].close()
        active.parts.actions["hide_docks"].trigger()
        active.parts.actions["reset_layout"].trigger()
        assert shown_docks(active) == before
        assert not active.docks.all[1].isFloating()
        assert not active.parts.actions["hide_docks"].isChecked()
        qtbot.waitUntil(lambda: [dock.size() for dock in active.docks.all[:2]] == sizes)

    def test_hidden_panels_are_there_again_the_next_time(
        self, qtbot: QtBot, active: MainWindow, open_project: OpenProject, settings: Settings
    ) -> None:
        before = shown_docks(active)
        active.parts.actions["hide_docks"].trigger()
        active.close_unasked()
        another = MainWindow(open_project, settings, OwnClipboard())
        assert shown_docks(another) == before
        another.close_unasked()
        another.deleteLater()

    def test_the_view_menu_lists_them(self, window: MainWindow) -> None:
        listed = [action.text() for action in window.parts.menus.panels.actions()]
        assert listed[: len(window.docks.all)] == [dock.windowTitle() for dock in window.docks.all]


def test_no_two_entries_of_a_menu_share_a_letter(window: MainWindow) -> None:
    menus = [window.parts.menus.view, window.parts.menus.views, window.parts.menus.panels]
    menus += [menu for action in window.menuBar().actions() if isinstance(menu := action.menu(), QMenu)]
    for menu in menus:
        letters = [action.text().split("&")[1][0].lower() for action in menu.actions() if "&" in action.text()]
        assert len(set(letters)) == len(letters), (menu.title(), sorted(letters))


def test_what_is_under_the_pointer_fills_the_window_and_goes_back(qtbot: QtBot, walking: MainWindow) -> None:
    layout, timeline = walking.docks.layout, walking.parts.time.timeline
    before = {dock.objectName(): dock.isVisible() for dock in walking.docks.all}
    high = timeline.height()
    layout.fill(timeline.lanes)
    qtbot.waitUntil(lambda: timeline.height() > 2 * high)
    assert [dock.objectName() for dock in walking.docks.all if dock.isVisible()] == ["timeline"]
    assert not walking.parts.viewport.isVisible()
    layout.fill(timeline.lanes)
    qtbot.waitUntil(walking.parts.viewport.isVisible)
    assert {dock.objectName(): dock.isVisible() for dock in walking.docks.all} == before
    layout.fill(walking.parts.viewport)
    assert not any(dock.isVisible() for dock in walking.docks.all)
    assert walking.parts.viewport.isVisible()
    layout.reset()
    assert {dock.objectName(): dock.isVisible() for dock in walking.docks.all} == before
