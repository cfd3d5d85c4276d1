"""Matching the camera in the window."""

from PySide6.QtCore import QPoint, Qt
from pytestqt.qtbot import QtBot

from kagezou.document import properties
from kagezou.document.address import Address, value_of
from kagezou.document.property import AnyProperty
from kagezou.ui.window.main_window import MainWindow
from tests.ui.viewing import drag, place_of


def number(window: MainWindow, prop: AnyProperty) -> object:
    return value_of(window.parts.open_project.bridge.document, Address(prop), 1)


def test_lines_take_the_place_of_the_handles_and_find_the_camera(qtbot: QtBot, walking: MainWindow) -> None:
    viewport, action = walking.parts.viewport, walking.parts.actions["match_camera"]
    action.trigger()
    assert "orange" in walking.parts.bar.text
    ids = {handle.id for handle in viewport.controller.handles.handles}
    assert "match.horizon" in ids
    assert "light.lamp" not in ids
    session, before = walking.parts.open_project.bridge.session, walking.parts.open_project.bridge.document
    drag(qtbot, viewport, "match.end.1", QPoint(20, 12), let_go=False)
    assert "Field of view" in viewport.controller.words
    qtbot.mouseRelease(viewport, Qt.MouseButton.LeftButton)
    assert number(walking, properties.FOV) != properties.FOV.default
    assert walking.parts.open_project.bridge.document.vanishing is not None
    walking.parts.actions["undo"].trigger()
    assert session.document is before


def test_escape_ends_it_wherever_the_keyboard_is(qtbot: QtBot, walking: MainWindow) -> None:
    viewport, action = walking.parts.viewport, walking.parts.actions["match_camera"]
    action.trigger()
    qtbot.mouseClick(viewport, Qt.MouseButton.LeftButton, pos=place_of(viewport, "match.end.0"))
    qtbot.keyClick(viewport, Qt.Key.Key_Escape)
    assert not action.isChecked()
    assert walking.parts.bar.text == ""
    action.trigger()
    qtbot.keyClick(walking, Qt.Key.Key_Escape)
    assert not action.isChecked()
    assert viewport.controller.handles.find("light.lamp") is not None


def test_lines_that_are_no_floor_say_so_beside_the_pointer(qtbot: QtBot, walking: MainWindow) -> None:
    viewport = walking.parts.viewport
    walking.parts.actions["match_camera"].trigger()
    start, end = (place_of(viewport, f"match.end.{index}") for index in (0, 1))
    before = walking.parts.open_project.bridge.document
    drag(qtbot, viewport, "match.end.1", start - end, let_go=False)
    assert "lies on the other" in viewport.controller.words
    assert walking.parts.open_project.bridge.document.tracks == before.tracks
    qtbot.mouseRelease(viewport, Qt.MouseButton.LeftButton)
