"""The picture in the real window: handles dragged by the mouse, zoom and pan, and a context that is made anew."""

import re
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QInputDevice, QPointingDevice, QTabletEvent, QWheelEvent
from PySide6.QtWidgets import QApplication, QMenu, QWidget
from pytestqt.qtbot import QtBot

from kagezou.document import properties
from kagezou.document.address import Address, track_of, value_of
from kagezou.document.edits import set_value
from kagezou.document.invariants import check
from kagezou.document.model import Document
from kagezou.document.values import value_at
from kagezou.io.clips.shortcut_files import bundled_key_sets
from kagezou.tools.grounding import add_grounding
from kagezou.ui.panels.groups import Group
from kagezou.ui.viewport import faces
from kagezou.ui.viewport.overlay import pill_corner
from kagezou.ui.window.main_window import MainWindow
from tests.ui.viewing import drag, move, picture, place_of, shadow_is_on_canvas

LAMP_WAYS = {
    "light.lamp": QPoint(60, 30),
    "light.foot": QPoint(40, 10),
    "ground.position": QPoint(20, -20),
    "ground.end": QPoint(0, -40),
    "ground.declination": QPoint(0, 25),
    "tilt.lever": QPoint(30, 0),
    "shadow.tip": QPoint(25, 15),
    "grounding.0": QPoint(12, -9),
}


def prepare(window: MainWindow, handle_id: str) -> None:
    """Put the document into a state that has the handle."""
    session = window.parts.open_project.bridge.session
    document = session.document
    if handle_id == "grounding.0":
        document = add_grounding(document, document.layers[0].id, 1, (110.0, 168.0))
    if handle_id == "light.sun":
        document = set_value(document, Address(properties.LIGHT_KIND), "sun", 1)
    session.edit("Prepare", document)
    session.mark_saved()


def test_a_dropped_folder_shows_a_whole_shadow(walking: MainWindow) -> None:
    assert len(walking.parts.open_project.bridge.document.layers) == 1
    assert shadow_is_on_canvas(walking)
    assert walking.pages.currentWidget() is walking.parts.viewport


@pytest.mark.parametrize("handle_id", [*LAMP_WAYS, "light.sun"])
def test_every_handle_changes_document_and_picture_and_comes_back(
    qtbot: QtBot, walking: MainWindow, handle_id: str
) -> None:
    prepare(walking, handle_id)
    session, viewport = walking.parts.open_project.bridge.session, walking.parts.viewport
    before, before_picture = session.document, picture(viewport)
    way = LAMP_WAYS.get(handle_id, QPoint(25, 18))

    drag(qtbot, viewport, handle_id, way, let_go=False)
    assert session.document is not before
    assert not np.array_equal(picture(viewport), before_picture), "the picture follows the hand"
    qtbot.keyClick(viewport, Qt.Key.Key_Escape)
    assert session.document is before, "Escape restores"
    assert np.array_equal(picture(viewport), before_picture)
    qtbot.mouseRelease(viewport, Qt.MouseButton.LeftButton)

    drag(qtbot, viewport, handle_id, way)
    after, after_picture = session.document, picture(viewport)
    check(after)
    assert after is not before
    walking.parts.actions["undo"].trigger()
    assert session.document is before
    assert np.array_equal(picture(viewport), before_picture)
    walking.parts.actions["redo"].trigger()
    assert session.document is after
    assert np.array_equal(picture(viewport), after_picture)


def test_the_right_button_takes_a_drag_back(qtbot: QtBot, walking: MainWindow) -> None:
    before = walking.parts.open_project.bridge.document
    drag(qtbot, walking.parts.viewport, "light.lamp", QPoint(40, 20), let_go=False)
    qtbot.mousePress(walking.parts.viewport, Qt.MouseButton.RightButton)
    assert walking.parts.open_project.bridge.document is before
    assert walking.parts.open_project.is_saved


def test_a_drag_is_one_step_with_a_name(qtbot: QtBot, walking: MainWindow) -> None:
    drag(qtbot, walking.parts.viewport, "light.lamp", QPoint(40, 20))
    assert walking.parts.open_project.bridge.session.undo_name == "Move Lamp"
    assert walking.parts.actions["undo"].text() == "&Undo Move Lamp"


def test_a_double_click_adds_a_grounding_point_and_delete_removes_it(qtbot: QtBot, walking: MainWindow) -> None:
    viewport, bridge = walking.parts.viewport, walking.parts.open_project.bridge
    x, y = viewport.viewpoint.view.view_from_canvas((112.0, 150.0))
    qtbot.mouseDClick(viewport, Qt.MouseButton.LeftButton, pos=QPoint(round(x), round(y)))
    grounding = Address(properties.GROUNDING, bridge.layer_id)
    points = value_of(bridge.document, grounding, 1)
    assert isinstance(points, tuple)
    assert len(points) == 1
    assert points[0] == pytest.approx((112.0, 150.0), abs=1.0)
    assert viewport.controller.selected_id == "grounding.0"
    walking.parts.actions["delete"].trigger()
    assert value_of(bridge.document, grounding, 1) == ()


def test_a_double_click_beside_the_character_adds_nothing_and_says_so(qtbot: QtBot, walking: MainWindow) -> None:
    viewport, bridge = walking.parts.viewport, walking.parts.open_project.bridge
    before = bridge.document
    x, y = viewport.viewpoint.view.view_from_canvas((20.0, 30.0))
    qtbot.mouseDClick(viewport, Qt.MouseButton.LeftButton, pos=QPoint(round(x), round(y)))
    assert bridge.document is before
    assert walking.parts.bar.text.startswith("Double-click on the character itself")


def test_arrows_step_frames_with_keys_in_which_they_do_though_a_handle_is_selected(
    qtbot: QtBot, walking: MainWindow, focus: Callable[[QWidget], None]
) -> None:
    viewport, bridge, keyboard = walking.parts.viewport, walking.parts.bridge, walking.parts.keyboard
    blender = next(each for each in bundled_key_sets() if "blender" in each.code)
    keyboard.use(replace(keyboard.shortcuts, key_set=blender))
    focus(viewport)
    viewport.controller.select("ground.position")
    before = bridge.document
    qtbot.keyClick(viewport, Qt.Key.Key_Right)
    assert (bridge.frame, bridge.document) == (2, before)
    qtbot.keyClick(viewport, Qt.Key.Key_Down)
    assert bridge.document is not before, "an arrow that lies on no command moves the handle"


def test_tab_reaches_every_handle_and_arrows_nudge_it(qtbot: QtBot, walking: MainWindow) -> None:
    viewport, bridge = walking.parts.viewport, walking.parts.open_project.bridge
    viewport.setFocus()
    ids = [handle.id for handle in viewport.controller.handles.handles]
    reached = []
    for _ in ids:
        qtbot.keyClick(viewport, Qt.Key.Key_Tab)
        reached.append(viewport.controller.selected_id)
    assert sorted(map(str, reached)) == sorted(ids)
    viewport.controller.select("ground.position")
    assert value_of(bridge.document, Address(properties.GROUND_POSITION), 1) == (120.0, 170.0)
    qtbot.keyClick(viewport, Qt.Key.Key_Right)
    qtbot.keyClick(viewport, Qt.Key.Key_Down, Qt.KeyboardModifier.ShiftModifier)
    assert value_of(bridge.document, Address(properties.GROUND_POSITION), 1) == (121.0, 180.0)
    bridge.session.undo()
    assert value_of(bridge.document, Address(properties.GROUND_POSITION), 1) == (121.0, 170.0)


def test_arrows_step_frames_while_no_handle_is_selected(qtbot: QtBot, walking: MainWindow) -> None:
    qtbot.keyClick(walking.parts.viewport, Qt.Key.Key_Right)
    assert walking.parts.open_project.bridge.frame == 2


def wheel(window: MainWindow, at: QPointF, steps: int) -> None:
    event = QWheelEvent(
        at,
        window.parts.viewport.mapToGlobal(at),
        QPoint(),
        QPoint(0, 120 * steps),
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(window.parts.viewport, event)


@pytest.mark.parametrize("steps", [1, -2, 5])
def test_the_wheel_keeps_the_point_under_the_pointer(walking: MainWindow, steps: int) -> None:
    viewpoint = walking.parts.viewport.viewpoint
    at = QPointF(211.0, 97.0)
    before, zoom = viewpoint.view.canvas_from_view((at.x(), at.y())), viewpoint.view.zoom
    wheel(walking, at, steps)
    assert viewpoint.view.canvas_from_view((at.x(), at.y())) == pytest.approx(before, abs=1e-6)
    assert viewpoint.view.zoom == pytest.approx(zoom * 2 ** (steps / 4))
    assert not viewpoint.is_fitted


def test_fit_and_actual_pixels(walking: MainWindow) -> None:
    viewpoint = walking.parts.viewport.viewpoint
    walking.parts.actions["actual"].trigger()
    assert viewpoint.percent == pytest.approx(100.0)
    walking.parts.actions["fit"].trigger()
    left, top = viewpoint.view.view_from_canvas((0.0, 0.0))
    right, bottom = viewpoint.view.view_from_canvas((240.0, 200.0))
    assert 0 < left < right < viewpoint.size[0]
    assert 0 < top < bottom < viewpoint.size[1]


def test_the_fitted_picture_stays_fitted_when_the_window_grows(qtbot: QtBot, walking: MainWindow) -> None:
    before = walking.parts.viewport.viewpoint.view
    walking.resize(1300, 900)
    qtbot.waitUntil(lambda: walking.parts.viewport.viewpoint.view != before)
    assert walking.parts.viewport.viewpoint.is_fitted


def test_the_middle_button_and_the_space_bar_pan(qtbot: QtBot, walking: MainWindow) -> None:
    viewport, origin = walking.parts.viewport, walking.parts.viewport.viewpoint.view.origin_view_px
    qtbot.mousePress(viewport, Qt.MouseButton.MiddleButton, pos=QPoint(50, 50))
    move(viewport, QPoint(80, 40))
    qtbot.mouseRelease(viewport, Qt.MouseButton.MiddleButton, pos=QPoint(80, 40))
    assert viewport.viewpoint.view.origin_view_px == pytest.approx((origin[0] + 30, origin[1] - 10))
    document = walking.parts.open_project.bridge.document
    lamp = place_of(viewport, "light.lamp")
    qtbot.keyPress(viewport, Qt.Key.Key_Space)
    qtbot.mousePress(viewport, Qt.MouseButton.LeftButton, pos=lamp)
    move(viewport, lamp + QPoint(10, 20), Qt.MouseButton.LeftButton)
    qtbot.mouseRelease(viewport, Qt.MouseButton.LeftButton, pos=lamp + QPoint(10, 20))
    qtbot.keyRelease(viewport, Qt.Key.Key_Space)
    assert viewport.viewpoint.view.origin_view_px == pytest.approx((origin[0] + 40, origin[1] + 10))
    assert walking.parts.open_project.bridge.document is document, "no handle was taken"
    assert not walking.parts.time.player.is_playing, "panning does not play"


def test_the_space_bar_plays_without_handles_and_stops(qtbot: QtBot, walking: MainWindow) -> None:
    # However late a picture is, the next frame follows: no loop comes round to where it was.
    walking.parts.time.player.every_frame = True
    qtbot.keyClick(walking.parts.viewport, Qt.Key.Key_Space)
    assert not walking.parts.viewport.overlay.shows_handles
    seen: set[int] = set()
    walking.parts.open_project.bridge.frame_changed.connect(seen.add)
    qtbot.waitUntil(lambda: len(seen) >= 4)
    qtbot.keyClick(walking.parts.viewport, Qt.Key.Key_Space)
    assert not walking.parts.time.player.is_playing
    assert walking.parts.viewport.overlay.shows_handles


def test_following_the_pointer_never_draws_the_picture(walking: MainWindow) -> None:
    frame_painter = walking.parts.viewport.frame_painter
    assert frame_painter is not None
    picture(walking.parts.viewport)
    drawn = frame_painter.pictures_drawn
    lamp = place_of(walking.parts.viewport, "light.lamp")
    for offset in range(0, 40, 4):
        move(walking.parts.viewport, lamp + QPoint(offset, 0))
        QApplication.processEvents()
    wheel(walking, QPointF(100, 100), 1)
    QApplication.processEvents()
    assert frame_painter.pictures_drawn == drawn
    walking.parts.open_project.bridge.session.select(None)
    picture(walking.parts.viewport)
    assert frame_painter.pictures_drawn == drawn


def test_the_pen_drags_as_the_mouse_does(walking: MainWindow) -> None:
    viewport, before = walking.parts.viewport, walking.parts.open_project.bridge.document
    lamp = QPointF(place_of(viewport, "light.lamp"))
    pen = QPointingDevice(
        "pen",
        7,
        QInputDevice.DeviceType.Stylus,
        QPointingDevice.PointerType.Pen,
        QInputDevice.Capability.Position | QInputDevice.Capability.Pressure,
        1,
        2,
    )

    def send(kind: QEvent.Type, at: QPointF, buttons: Qt.MouseButton) -> None:
        event = QTabletEvent(
            kind, pen, at, viewport.mapToGlobal(at), 0.5, 0, 0, 0.0, 0.0, 0.0,
            Qt.KeyboardModifier.NoModifier, Qt.MouseButton.LeftButton, buttons,
        )  # fmt: skip
        QApplication.sendEvent(viewport, event)
        assert event.isAccepted(), "Qt would send the mouse events too"

    near = lamp + QPointF(12, 0)
    send(QEvent.Type.TabletPress, near, Qt.MouseButton.LeftButton)
    assert viewport.controller.held is not None, "a pen may miss by more than a mouse"
    send(QEvent.Type.TabletMove, near + QPointF(30, 10), Qt.MouseButton.LeftButton)
    send(QEvent.Type.TabletRelease, near + QPointF(30, 10), Qt.MouseButton.NoButton)
    assert walking.parts.open_project.bridge.document is not before


@pytest.fixture
def by_card(monkeypatch: pytest.MonkeyPatch) -> None:
    """The face is a widget of OpenGL, as where a graphics card draws."""
    monkeypatch.setattr(faces, "software_beside", lambda: None)


@pytest.mark.usefixtures("by_card")
def test_another_context_draws_the_same_picture(qtbot: QtBot, walking: MainWindow) -> None:
    before, first = picture(walking.parts.viewport), walking.parts.viewport.frame_painter
    walking.parts.viewport.setParent(None)
    walking.parts.viewport.show()
    qtbot.waitUntil(lambda: walking.parts.viewport.frame_painter not in (None, first))
    assert np.array_equal(picture(walking.parts.viewport), before)
    walking.pages.addWidget(walking.parts.viewport)
    walking.pages.setCurrentWidget(walking.parts.viewport)
    assert np.array_equal(picture(walking.parts.viewport), before)


def test_the_pill_stays_in_the_viewport() -> None:
    for at in ((5.0, 5.0), (395.0, 295.0), (200.0, 295.0)):
        corner = pill_corner(at, (120.0, 24.0), (400.0, 300.0))
        assert 0 <= corner.x() <= 280
        assert 0 <= corner.y() <= 276


def test_a_handle_says_its_value_and_its_keys_before_it_is_taken_hold_of(walking: MainWindow) -> None:
    viewport = walking.parts.viewport
    move(viewport, place_of(viewport, "light.lamp"))
    first, second = viewport.controller.words.split("\n")
    assert re.fullmatch(r"Lamp  X [-.0-9]+  Y [-.0-9]+  Z [-.0-9]+", first)
    assert second == "Shift: one way   Shift+Alt or Shift+A: slowly"
    for handle in viewport.controller.handles.handles:
        move(viewport, place_of(viewport, handle.id))
        assert viewport.controller.words.count("\n") == 1


def grounding_points(document: Document) -> tuple[tuple[float, float], ...]:
    return value_at(document.layers[0].tracks, properties.GROUNDING, 1)


def test_the_letter_a_is_alt_while_the_hand_drags(qtbot: QtBot, walking: MainWindow) -> None:
    viewport, bridge = walking.parts.viewport, walking.parts.bridge
    for place in ((100.0, 168.0), (130.0, 168.0)):
        bridge.session.edit("Add", add_grounding(bridge.document, "layer-1", 1, place))
    start = place_of(viewport, "grounding.0")
    qtbot.keyPress(viewport, Qt.Key.Key_A)
    qtbot.mousePress(viewport, Qt.MouseButton.LeftButton, pos=start)
    for x in (4, 8, 12):
        move(viewport, start + QPoint(x, 0), Qt.MouseButton.LeftButton)
    qtbot.mouseRelease(viewport, Qt.MouseButton.LeftButton, pos=start + QPoint(12, 0))
    qtbot.keyRelease(viewport, Qt.Key.Key_A)
    assert not walking.alt_key.is_held
    first, second = grounding_points(bridge.document)
    assert first[0] > 100.0
    assert second[0] == pytest.approx(230.0 - first[0], abs=0.01), "the other one went the other way"


def test_the_letter_a_is_not_held_on_when_the_window_is_left(
    qtbot: QtBot, qapp: QApplication, walking: MainWindow
) -> None:
    qtbot.keyPress(walking.parts.viewport, Qt.Key.Key_A)
    assert walking.alt_key.is_held
    qapp.focusWindowChanged.emit(None)
    assert not walking.alt_key.is_held


def test_messages_step_aside_while_the_hand_drags(qtbot: QtBot, walking: MainWindow) -> None:
    viewport = walking.parts.viewport
    walking.parts.bar.say("x", "Something to know.")
    assert walking.top_bars.isVisible()
    drag(qtbot, viewport, "light.lamp", QPoint(20, 10), let_go=False)
    assert not walking.top_bars.isVisible()
    qtbot.mouseRelease(viewport, Qt.MouseButton.LeftButton)
    assert walking.top_bars.isVisible()


def test_a_right_click_on_a_handle_opens_the_menu_of_what_it_edits(qtbot: QtBot, walking: MainWindow) -> None:
    viewport, inspector, session = walking.parts.viewport, walking.parts.panels.inspector, walking.parts.bridge.session
    inspector.sections[Group.LIGHT].open(opened=False)
    qtbot.mouseClick(viewport, Qt.MouseButton.RightButton, pos=place_of(viewport, "light.lamp"))
    menu = next(each for each in viewport.findChildren(QMenu) if each.isVisible())
    words = [action.text() for action in menu.actions() if not action.isSeparator()]
    assert words[:3] == ["Lamp", "Type Values…", "Copy Value"]
    assert {"Set Key", "Reset to Default"} <= set(words)
    assert inspector.sections[Group.LIGHT].is_open
    assert session.state.selection == (Address(properties.LIGHT_POSITION),)
    menu.close()
    walking.parts.actions["set_keys"].trigger()
    assert [key.frame for key in track_of(session.document, Address(properties.LIGHT_POSITION)).keys] == [1]
    qtbot.mouseClick(viewport, Qt.MouseButton.LeftButton, pos=place_of(viewport, "ground.declination"))
    assert inspector.row("ground.declination").label.property("chosen")
    assert not inspector.row("light.position").label.property("chosen")
