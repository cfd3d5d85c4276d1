"""Drawing a corner in the window: two drags, two steps, and every way out."""

import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QInputDevice, QPointingDevice, QTabletEvent
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from kagezou.document import properties as p
from kagezou.document import set_properties as s
from kagezou.document.address import Address, value_of
from kagezou.ui.viewport.corner_sheet import CornerStroke
from kagezou.ui.window.main_window import MainWindow
from tests.ui.viewing import move

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def cornering(active: MainWindow) -> MainWindow:
    """The window, asked for a corner."""
    active.parts.actions["draw_corner"].trigger()
    return active


def stroke(
    qtbot: QtBot, window: MainWindow, start: tuple[float, float], end: tuple[float, float], *, let_go: bool = True
) -> None:
    view = window.parts.viewport.viewpoint.view
    (ax, ay), (bx, by) = view.view_from_canvas(start), view.view_from_canvas(end)
    qtbot.mousePress(window.parts.viewport, LEFT, pos=QPoint(round(ax), round(ay)))
    for part in (0.3, 0.7, 1.0):
        move(window.parts.viewport, QPoint(round(ax + part * (bx - ax)), round(ay + part * (by - ay))), LEFT)
    if let_go:
        qtbot.mouseRelease(window.parts.viewport, LEFT, pos=QPoint(round(bx), round(by)))


def shows_handles(window: MainWindow) -> bool:
    return window.parts.viewport.overlay.shows_handles


def scene(window: MainWindow, name: str) -> object:
    return value_of(window.parts.open_project.bridge.document, Address(getattr(p, name)), 1)


def test_two_drags_make_a_corner_in_two_steps(qtbot: QtBot, cornering: MainWindow) -> None:
    sheet, bridge = cornering.parts.sets.corner_sheet, cornering.parts.open_project.bridge
    before = bridge.document
    assert sheet.isVisible()
    assert "the figure stands on" in sheet.hint
    assert not shows_handles(cornering)
    stroke(qtbot, cornering, (30, 160), (210, 170))
    assert bridge.session.undo_name == "Draw ground line"
    assert scene(cornering, "GROUND_ROLL") == pytest.approx(3.2, abs=0.3)
    assert "foot of the wall" in sheet.hint
    stroke(qtbot, cornering, (40, 140), (220, 150))
    assert bridge.session.undo_name == "Draw wall"
    assert not sheet.is_on
    assert shows_handles(cornering)
    assert bridge.piece_id == "piece-1"
    width = value_of(bridge.document, Address(s.PIECE_WIDTH, piece_id="piece-1"), 1)
    assert width == pytest.approx(180, abs=4)
    bridge.session.undo()
    assert bridge.document.pieces == ()
    bridge.session.undo()
    assert bridge.document is before
    bridge.session.redo()
    bridge.session.redo()
    assert bridge.piece_id == "piece-1"


def test_escape_drops_the_line_in_the_hand_then_leaves(qtbot: QtBot, cornering: MainWindow) -> None:
    sheet, bridge = cornering.parts.sets.corner_sheet, cornering.parts.open_project.bridge
    before = bridge.document
    stroke(qtbot, cornering, (30, 160), (210, 120), let_go=False)
    assert bridge.document is not before
    qtbot.keyClick(cornering.parts.viewport, Qt.Key.Key_Escape)
    assert bridge.document is before
    assert sheet.stroke is CornerStroke.GROUND
    qtbot.keyClick(cornering.parts.viewport, Qt.Key.Key_Escape)
    assert not sheet.isVisible()
    assert not sheet.is_on
    assert shows_handles(cornering)
    assert bridge.session.undo_name == "Import character"


def test_enter_keeps_the_ground_and_the_right_button_steps_back(qtbot: QtBot, cornering: MainWindow) -> None:
    sheet, ground = cornering.parts.sets.corner_sheet, scene(cornering, "GROUND_POSITION")
    qtbot.keyClick(cornering.parts.viewport, Qt.Key.Key_Return)
    assert sheet.stroke is CornerStroke.WALL
    stroke(qtbot, cornering, (40, 150), (200, 150))
    assert scene(cornering, "GROUND_POSITION") == ground
    assert len(cornering.parts.open_project.bridge.document.pieces) == 1
    cornering.parts.actions["draw_wall"].trigger()
    assert sheet.stroke is CornerStroke.WALL
    qtbot.mousePress(cornering.parts.viewport, Qt.MouseButton.RightButton, pos=QPoint(80, 80))
    assert not sheet.is_on


def test_undo_with_the_line_in_the_hand_leaves_nothing_behind(qtbot: QtBot, cornering: MainWindow) -> None:
    bridge = cornering.parts.open_project.bridge
    qtbot.keyClick(cornering.parts.viewport, Qt.Key.Key_Return)
    stroke(qtbot, cornering, (40, 150), (200, 150), let_go=False)
    bridge.session.undo()
    bridge.session.undo()
    before = bridge.document
    qtbot.mouseRelease(cornering.parts.viewport, LEFT, pos=QPoint(200, 200))
    assert bridge.document is before


def test_a_click_draws_nothing_and_asks_on(qtbot: QtBot, cornering: MainWindow) -> None:
    before = cornering.parts.open_project.bridge.document
    qtbot.mouseClick(cornering.parts.viewport, LEFT, pos=QPoint(200, 200))
    qtbot.mouseDClick(cornering.parts.viewport, LEFT, pos=QPoint(200, 200))
    qtbot.mouseRelease(cornering.parts.viewport, LEFT, pos=QPoint(200, 200))
    assert cornering.parts.open_project.bridge.document is before
    assert cornering.parts.sets.corner_sheet.stroke is CornerStroke.GROUND


def test_where_no_ground_is_seen_it_says_so(qtbot: QtBot, cornering: MainWindow) -> None:
    cornering.parts.panels.inspector.row("ground.declination").enter(90.0)
    qtbot.keyClick(cornering.parts.viewport, Qt.Key.Key_Return)
    before = cornering.parts.open_project.bridge.document
    stroke(qtbot, cornering, (40, 150), (200, 150))
    assert cornering.parts.open_project.bridge.document is before
    assert "no ground here" in cornering.parts.bar.text
    assert cornering.parts.sets.corner_sheet.is_on


def test_the_picture_can_be_panned_meanwhile_and_another_project_ends_it(qtbot: QtBot, cornering: MainWindow) -> None:
    viewport = cornering.parts.viewport
    origin = viewport.viewpoint.view.origin_view_px
    qtbot.mousePress(viewport, Qt.MouseButton.MiddleButton, pos=QPoint(100, 100))
    viewport.viewpoint.pan(5, 5)
    qtbot.mouseRelease(viewport, Qt.MouseButton.MiddleButton, pos=QPoint(105, 105))
    assert viewport.viewpoint.view.origin_view_px != origin
    viewport.grab()
    cornering.parts.open_project.clear()
    assert not cornering.parts.sets.corner_sheet.is_on


def test_a_pen_draws_as_the_mouse_does(cornering: MainWindow) -> None:
    viewport, before = cornering.parts.viewport, cornering.parts.open_project.bridge.document
    pen = QPointingDevice(
        "pen",
        7,
        QInputDevice.DeviceType.Stylus,
        QPointingDevice.PointerType.Pen,
        QInputDevice.Capability.Position,
        1,
        2,
    )
    places = [QPointF(*viewport.viewpoint.view.view_from_canvas(at)) for at in ((30, 160), (120, 165), (210, 170))]
    kinds = (QEvent.Type.TabletPress, QEvent.Type.TabletMove, QEvent.Type.TabletMove, QEvent.Type.TabletRelease)
    for kind, at in zip(kinds, (*places, places[-1]), strict=True):
        held = Qt.MouseButton.NoButton if kind is QEvent.Type.TabletRelease else LEFT
        event = QTabletEvent(
            kind, pen, at, viewport.mapToGlobal(at), 0.5, 0, 0, 0.0, 0.0, 0.0,
            Qt.KeyboardModifier.NoModifier, LEFT, held,
        )  # fmt: skip
        QApplication.sendEvent(viewport, event)
        assert event.isAccepted(), "Qt would send the mouse events too"
    assert cornering.parts.open_project.bridge.document is not before
    assert cornering.parts.sets.corner_sheet.stroke is CornerStroke.WALL
