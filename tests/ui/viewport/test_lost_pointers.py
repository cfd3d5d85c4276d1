"""A pointer that goes away in the middle of a drag: the drag is over, and nothing goes on by itself."""

from collections.abc import Callable

import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QInputDevice, QPointingDevice, QTabletEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from kagezou.ui.panels.editors import NumbersEditor
from kagezou.ui.viewport.viewport import Viewport
from kagezou.ui.window.main_window import MainWindow
from tests.ui.viewing import place_of

PRESS, MOVE = QEvent.Type.TabletPress, QEvent.Type.TabletMove
DOWN, UP = Qt.MouseButton.LeftButton, Qt.MouseButton.NoButton


@pytest.fixture
def pen() -> QPointingDevice:
    kind, position = QInputDevice.DeviceType.Stylus, QInputDevice.Capability.Position
    return QPointingDevice("pen", 7, kind, QPointingDevice.PointerType.Pen, position, 1, 2)


def event_of(
    pen: QPointingDevice, viewport: Viewport, kind: QEvent.Type, at: QPointF, down: Qt.MouseButton
) -> QTabletEvent:
    keys = Qt.KeyboardModifier.NoModifier
    return QTabletEvent(kind, pen, at, viewport.mapToGlobal(at), 0.5, 0, 0, 0.0, 0.0, 0.0, keys, DOWN, down)


def dragged(viewport: Viewport, pen: QPointingDevice) -> QPointF:
    """Take the lamp with the pen and move it; return where the pen is."""
    at = QPointF(place_of(viewport, "light.lamp"))
    QApplication.sendEvent(viewport, event_of(pen, viewport, PRESS, at, DOWN))
    at += QPointF(30, 10)
    QApplication.sendEvent(viewport, event_of(pen, viewport, MOVE, at, DOWN))
    assert viewport.controller.is_busy
    return at


def drags(window: MainWindow) -> bool:
    return window.parts.bridge.session.is_in_gesture


def deactivated(window: MainWindow, monkeypatch: pytest.MonkeyPatch) -> None:
    """Tell a window that it is active no more, as Qt does."""
    monkeypatch.setattr(type(window), "isActiveWindow", lambda _self: False)
    QApplication.sendEvent(window, QEvent(QEvent.Type.ActivationChange))


def leave_tablet(pen: QPointingDevice, viewport: Viewport) -> None:
    leaving = event_of(pen, viewport, QEvent.Type.TabletLeaveProximity, QPointF(1, 1), UP)
    application = QApplication.instance()
    assert application is not None
    QApplication.sendEvent(application, leaving)


def come_back(pen: QPointingDevice, viewport: Viewport) -> None:
    QApplication.sendEvent(viewport, event_of(pen, viewport, MOVE, QPointF(9, 9), UP))


@pytest.mark.parametrize("lose", [leave_tablet, come_back])
def test_a_pen_that_goes_away_ends_the_drag_as_it_is(
    walking: MainWindow, pen: QPointingDevice, lose: Callable[[QPointingDevice, Viewport], None]
) -> None:
    viewport, session = walking.parts.viewport, walking.parts.bridge.session
    before = session.document
    at = dragged(viewport, pen)
    lose(pen, viewport)
    assert not viewport.controller.is_busy
    assert not session.is_in_gesture
    kept = session.document
    assert kept is not before
    QApplication.sendEvent(viewport, event_of(pen, viewport, MOVE, at + QPointF(50, 50), UP))
    assert session.document is kept, "a pen in the air drags nothing"
    session.undo()
    assert session.document is before, "it was one step"


def test_a_window_that_is_left_ends_the_drag(
    walking: MainWindow, pen: QPointingDevice, monkeypatch: pytest.MonkeyPatch
) -> None:
    viewport = walking.parts.viewport
    dragged(viewport, pen)
    deactivated(walking, monkeypatch)
    assert not viewport.controller.is_busy
    assert not walking.parts.bridge.session.is_in_gesture


def test_without_a_drag_nothing_is_done(walking: MainWindow, monkeypatch: pytest.MonkeyPatch) -> None:
    session = walking.parts.bridge.session
    before = session.document
    deactivated(walking, monkeypatch)
    assert session.document is before
    assert session.undo_name is not None, "only the import"


def test_a_number_that_is_dragged_is_let_go(walking: MainWindow, monkeypatch: pytest.MonkeyPatch) -> None:
    session, name = walking.parts.bridge.session, walking.parts.panels.inspector.row("shadow.softness").label
    before = session.document
    QTest.mousePress(name, DOWN, pos=QPoint(2, 2))
    QTest.mouseMove(name, QPoint(30, 2))
    QTest.mouseMove(name, QPoint(60, 2))
    assert drags(walking)
    deactivated(walking, monkeypatch)
    assert not drags(walking)
    kept = session.document
    assert kept is not before
    QTest.mouseMove(name, QPoint(90, 2))
    assert session.document is kept


def test_a_slider_that_is_dragged_is_let_go(walking: MainWindow, monkeypatch: pytest.MonkeyPatch) -> None:
    editors = (row.editor for row in walking.parts.panels.inspector.rows)
    slider = next(each.slider for each in editors if isinstance(each, NumbersEditor) and each.slider is not None)
    slider.setSliderDown(True)
    assert drags(walking)
    deactivated(walking, monkeypatch)
    assert not drags(walking)


def test_a_key_that_is_dragged_goes_back(walking: MainWindow, monkeypatch: pytest.MonkeyPatch) -> None:
    session, lanes = walking.parts.bridge.session, walking.parts.time.timeline.lanes
    before = session.document
    QTest.mousePress(lanes, DOWN, pos=QPoint(4, lanes.height() - 6))
    QTest.mouseMove(lanes, QPoint(80, lanes.height() - 30))
    deactivated(walking, monkeypatch)
    assert not lanes.controller.is_busy
    assert not lanes.drawings.is_busy
    assert session.document is before
