"""Styles in the window: pictures of the present drawing, one step to put one on, the user's own."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QImage, QMouseEvent
from PySide6.QtTest import QSignalSpy, QTest
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from kagezou.document import properties
from kagezou.document.address import Address, value_of
from kagezou.document.edits import set_constant, set_key
from kagezou.io.images.reading import Steps
from kagezou.io.project.file import load
from kagezou.io.project.recovery_file import read_recovery_file
from kagezou.ui.panels.style_list import StyleList
from kagezou.ui.panels.style_name import StyleName
from kagezou.ui.project.autosave import Autosave
from kagezou.ui.system.language import Language
from kagezou.ui.system.settings import Settings
from kagezou.ui.window.main_window import MainWindow


@pytest.fixture
def styles(walking: MainWindow, monkeypatch: pytest.MonkeyPatch) -> StyleList:
    """The panel in front; its pictures, which nobody looks at, are not drawn."""
    made = walking.parts.panels.styles
    monkeypatch.setattr(made.pictures, "ask", lambda _wanted: None)
    walking.docks.all[2].raise_()
    made.reload()
    return made


@pytest.fixture
def pictured(qtbot: QtBot, walking: MainWindow) -> StyleList:
    """The panel in front when all of its pictures are there."""
    walking.docks.all[2].raise_()
    made = walking.parts.panels.styles
    last = made.list.count() - 1
    with qtbot.waitSignal(made.pictures.made, check_params_cb=lambda index, _: index == last):
        made.reload()
    return made


def row_of(styles: StyleList, name: str) -> int:
    (item,) = styles.list.findItems(name, Qt.MatchFlag.MatchExactly)
    return styles.list.row(item)


def rest_on(qtbot: QtBot, window: MainWindow, row: int) -> None:
    """Let the pointer rest on a style until the picture shows it; it comes again if the screen's own pointer leaves."""
    styles, bridge = window.parts.panels.styles.list, window.parts.bridge

    def is_shown() -> bool:
        at = QPointF(styles.visualItemRect(styles.item(row)).center())
        view, none = styles.viewport(), Qt.MouseButton.NoButton
        move = QMouseEvent(QEvent.Type.MouseMove, at, view.mapToGlobal(at), none, none, Qt.KeyboardModifier.NoModifier)
        QApplication.sendEvent(view, move)
        return bridge.shown is not bridge.document

    qtbot.waitUntil(is_shown)


def picture(window: MainWindow) -> Steps:
    """Return the picture after it was painted anew."""
    window.parts.viewport.repaint()
    window.parts.viewport.grab()
    found = window.parts.viewport.read_picture()
    assert found is not None
    return found


def simplify(window: MainWindow) -> object:
    bridge = window.parts.open_project.bridge
    return value_of(bridge.document, Address(properties.SIMPLIFY, bridge.layer_id), bridge.frame)


def test_every_style_has_a_picture_of_its_own(pictured: StyleList) -> None:
    pictures = [pictured.list.item(row).icon().pixmap(64, 64).toImage() for row in range(pictured.list.count())]
    seen = {bytes(each.convertToFormat(QImage.Format.Format_RGB32).constBits()) for each in pictures}
    assert len(seen) == pictured.list.count() >= 7
    assert all(np.frombuffer(each, np.uint8).std() > 5 for each in seen)


def test_a_click_is_one_step(walking: MainWindow, styles: StyleList) -> None:
    before = walking.parts.open_project.bridge.document
    styles.apply(1)
    assert simplify(walking) != 0.0
    assert walking.parts.open_project.bridge.session.undo_name == "Style: Simple"
    walking.parts.open_project.bridge.session.undo()
    assert walking.parts.open_project.bridge.document is before


def test_what_changed_is_said_and_which_keyed_ones_got_a_key(walking: MainWindow, styles: StyleList) -> None:
    bridge, bar = walking.parts.bridge, walking.parts.bar
    bridge.session.edit("", set_key(bridge.document, Address(properties.SIMPLIFY, bridge.layer_id), 1, 5.0))
    bridge.session.go_to(3)
    styles.apply(1)
    assert bar.text.splitlines()[0].startswith("Simple: ")
    assert bar.text.splitlines()[1] == "1 keyed property got a key on frame 3: Simplify"
    steps = bridge.session.history.made
    styles.apply(1)
    assert bar.text == "Simple: nothing looks otherwise than before"
    assert bridge.session.history.made == steps


class TestLight:
    def test_it_is_left_out_and_said_until_the_tick_is_set(self, walking: MainWindow, styles: StyleList) -> None:
        bridge, bar = walking.parts.bridge, walking.parts.bar
        row = row_of(styles, "Long evening")
        before = bridge.document.tracks
        styles.apply(row)
        assert bridge.document.tracks == before
        assert "Long evening came without its own light: “With its light” in the Styles panel" in bar.text
        styles.light.click()
        styles.apply(row)
        assert value_of(bridge.document, Address(properties.LIGHT_KIND), 1) == "sun"
        assert "light" not in bar.text

    def test_the_tick_is_remembered(self, walking: MainWindow, styles: StyleList, settings: Settings) -> None:
        assert not styles.brings_light
        styles.light.click()
        again = StyleList(walking.parts.bridge, settings)
        assert again.brings_light

    def test_it_does_not_come_for_one_of_two(self, walking: MainWindow, styles: StyleList, cels: Path) -> None:
        walking.parts.project.bring([cels])
        bridge = walking.parts.bridge
        assert len(bridge.document.layers) == 2
        styles.light.click()
        before = bridge.document.tracks
        styles.apply(row_of(styles, "Long evening"))
        assert bridge.document.tracks == before
        assert "only some are meant" in walking.parts.bar.text
        first, second = bridge.document.layers
        bridge.session.select(first.id, others=frozenset({second.id}))
        styles.apply(row_of(styles, "Long evening"))
        assert bridge.document.tracks != before


def test_a_look_becomes_a_style_and_goes_again(walking: MainWindow, styles: StyleList) -> None:
    styles.apply(1)
    count = styles.list.count()
    styles.save("朝の影")
    assert styles.list.count() == count + 1
    assert styles.list.item(count).text() == "朝の影"
    kept = simplify(walking)
    styles.apply(0)
    styles.apply(count)
    assert simplify(walking) == pytest.approx(kept)
    styles.list.setCurrentRow(0)
    styles.remove_current()
    assert styles.list.count() == count + 1
    styles.list.setCurrentRow(count)
    styles.remove_current()
    assert styles.list.count() == count


class TestName:
    def test_a_look_may_be_kept_with_its_light(self, qtbot: QtBot, walking: MainWindow, styles: StyleList) -> None:
        styles.ask_name()
        question = styles.findChild(StyleName)
        assert isinstance(question, StyleName)
        assert not question.ok.isEnabled()
        assert not question.with_scene.isChecked()
        QTest.keyClicks(question.name, "Night")
        question.with_scene.click()
        question.ok.click()
        kept = styles.list.item(row_of(styles, "Night"))
        assert kept.toolTip() == "Night\nHas a light of its own"
        bridge = walking.parts.bridge
        azimuth = Address(properties.LIGHT_AZIMUTH)
        before = value_of(bridge.document, azimuth, 1)
        bridge.session.edit("", set_constant(bridge.document, azimuth, 77.0))
        styles.light.click()
        styles.apply(styles.list.row(kept))
        assert value_of(bridge.document, azimuth, 1) == before

    def test_one_of_the_same_name_is_replaced_and_that_is_said(self, walking: MainWindow, styles: StyleList) -> None:
        styles.save("Night")
        count = styles.list.count()
        styles.save("Night")
        assert styles.list.count() == count
        assert walking.parts.bar.text == "The style Night took the place of the one before"


class TestLookingAtOne:
    """A style under the pointer is seen in the picture and nowhere else."""

    def test_the_picture_shows_it_and_the_document_stays(
        self, qtbot: QtBot, walking: MainWindow, pictured: StyleList
    ) -> None:
        bridge, viewport = walking.parts.bridge, walking.parts.viewport
        document, steps = bridge.document, bridge.session.history.made
        before = picture(walking)
        rest_on(qtbot, walking, 1)
        assert bridge.document is document
        assert (bridge.session.history.made, bridge.session.undo_name) == (steps, "Import character")
        assert bridge.session.is_saved
        assert not walking.isWindowModified()
        assert not np.array_equal(picture(walking), before)
        QApplication.sendEvent(pictured.list.viewport(), QEvent(QEvent.Type.Leave))
        assert bridge.shown is document
        assert np.array_equal(picture(walking), before)
        assert viewport.is_current

    def test_what_is_put_aside_and_saved_is_without_it(
        self, qtbot: QtBot, walking: MainWindow, styles: StyleList, tmp_path: Path
    ) -> None:
        bridge = walking.parts.bridge
        bridge.session.edit("", set_constant(bridge.document, Address(properties.LIGHT_AZIMUTH), 77.0))
        rest_on(qtbot, walking, 1)
        seen = bridge.shown
        autosave = Autosave(walking.parts.open_project, tmp_path / "unsaved", lambda: "walk")
        autosave.keep()
        autosave.wait()
        kept = read_recovery_file(autosave.file).document
        bridge.look_at(seen)
        walking.parts.open_project.save(tmp_path / "cut.kage")
        assert bridge.shown is seen
        assert bridge.session.is_saved
        for written in (kept, load(tmp_path / "cut.kage")):
            assert written.layers[0].tracks == bridge.document.layers[0].tracks != seen.layers[0].tracks
        autosave.finish()

    def test_escape_takes_it_back_wherever_the_keyboard_is(
        self, qtbot: QtBot, walking: MainWindow, styles: StyleList
    ) -> None:
        bridge = walking.parts.bridge
        rest_on(qtbot, walking, 1)
        QTest.keyClick(walking.parts.viewport, Qt.Key.Key_Escape)
        assert bridge.shown is bridge.document

    def test_a_click_puts_it_on_as_one_step(self, qtbot: QtBot, walking: MainWindow, styles: StyleList) -> None:
        bridge = walking.parts.bridge
        rest_on(qtbot, walking, 1)
        seen, steps = bridge.shown, bridge.session.history.made
        place = styles.list.visualItemRect(styles.list.item(1)).center()
        QTest.mouseClick(styles.list.viewport(), Qt.MouseButton.LeftButton, pos=place)
        assert bridge.document == seen
        assert bridge.shown is bridge.document
        QTest.mouseDClick(styles.list.viewport(), Qt.MouseButton.LeftButton, pos=place)
        assert bridge.session.history.made == steps + 1

    def test_the_arrows_go_through_the_list(
        self, qtbot: QtBot, walking: MainWindow, styles: StyleList, focus: Callable[[QWidget], None]
    ) -> None:
        bridge = walking.parts.bridge
        styles.list.setCurrentRow(0)
        focus(styles.list)
        QTest.keyClick(styles.list, Qt.Key.Key_Right)
        assert styles.list.currentRow() == 1
        qtbot.waitUntil(lambda: bridge.shown is not bridge.document)
        seen = bridge.shown
        QTest.keyClick(styles.list, Qt.Key.Key_Return)
        assert bridge.document == seen
        QTest.keyClick(styles.list, Qt.Key.Key_Right)
        qtbot.waitUntil(lambda: bridge.shown is not bridge.document)
        focus(walking.parts.viewport)
        assert bridge.shown is bridge.document

    def test_what_is_done_meanwhile_takes_its_place(self, qtbot: QtBot, walking: MainWindow, styles: StyleList) -> None:
        bridge = walking.parts.bridge
        for do in (lambda: bridge.session.go_to(3), bridge.session.undo):
            bridge.session.edit("", set_constant(bridge.document, Address(properties.LIGHT_AZIMUTH), 77.0))
            rest_on(qtbot, walking, 1)
            do()
            assert bridge.shown is bridge.document
            QApplication.sendEvent(styles.list.viewport(), QEvent(QEvent.Type.Leave))


def test_what_cannot_be_kept_is_said(styles: StyleList) -> None:
    said: list[str] = []
    styles.failed.connect(said.append)
    styles.save("")
    assert len(said) == 1


def test_what_cannot_be_removed_is_said_in_the_language_of_the_window(
    styles: StyleList, settings: Settings, english: Language
) -> None:
    count = styles.list.count()
    styles.save("mine")
    (file,) = settings.style_folder.iterdir()
    file.unlink()
    file.mkdir()
    said: list[str] = []
    styles.failed.connect(said.append)
    styles.list.setCurrentRow(count)
    english.speak("ja")
    styles.remove_current()
    assert said[0] == f"{file}：削除できません：フォルダーです"


def test_no_pictures_are_drawn_behind_another_panel(
    qtbot: QtBot, walking: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[object] = []
    monkeypatch.setattr(walking.parts.panels.styles.pictures, "ask", asked.append)
    walking.parts.open_project.bridge.session.go_to(3)
    styles = walking.parts.panels.styles
    rested = QSignalSpy(styles._rest.timeout)
    qtbot.waitUntil(lambda: rested.count() > 0)
    assert asked == [], "the layers lie before the styles"
    walking.docks.layout.show("styles")
    qtbot.waitUntil(lambda: len(asked) == 1)
