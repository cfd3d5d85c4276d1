"""Styles in the window: pictures of the present drawing, one step to put one on, the user's own."""

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage
from PySide6.QtTest import QSignalSpy
from pytestqt.qtbot import QtBot

from kagezou.document import properties
from kagezou.document.address import Address, value_of
from kagezou.document.edits import set_key
from kagezou.ui.panels.style_list import StyleList
from kagezou.ui.system.language import Language
from kagezou.ui.system.settings import Settings
from kagezou.ui.window.main_window import MainWindow


@pytest.fixture
def styles(qtbot: QtBot, walking: MainWindow) -> StyleList:
    walking.docks.all[2].raise_()
    made = walking.parts.panels.styles
    last = made.list.count() - 1
    with qtbot.waitSignal(made.pictures.made, timeout=10_000, check_params_cb=lambda index, _: index == last):
        made.reload()
    return made


def row_of(styles: StyleList, name: str) -> int:
    (item,) = styles.list.findItems(name, Qt.MatchFlag.MatchExactly)
    return styles.list.row(item)


def simplify(window: MainWindow) -> object:
    bridge = window.parts.open_project.bridge
    return value_of(bridge.document, Address(properties.SIMPLIFY, bridge.layer_id), bridge.frame)


def test_every_style_has_a_picture_of_its_own(styles: StyleList) -> None:
    pictures = [styles.list.item(row).icon().pixmap(64, 64).toImage() for row in range(styles.list.count())]
    seen = {bytes(each.convertToFormat(QImage.Format.Format_RGB32).constBits()) for each in pictures}
    assert len(seen) == styles.list.count() >= 7
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
    steps = bridge.session.steps_made
    styles.apply(1)
    assert bar.text == "Simple: nothing looks otherwise than before"
    assert bridge.session.steps_made == steps


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
        bridge.session.select_layers(first.id, frozenset({second.id}))
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
