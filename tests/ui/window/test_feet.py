"""Feet in the window: found beside it, shown on the picture, judged by a person, and gone through."""

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QAction
from pytestqt.qtbot import QtBot

from kagezou.document.feet_edits import judge_foot, pin_of
from kagezou.io.images.writing import write_rgba
from kagezou.scene.stances import stances_of
from kagezou.standing.foot import Verdict
from kagezou.tools.handle import Handle
from kagezou.ui.timeline.feet_lane import feet_over_time, words_at
from kagezou.ui.timeline.rows import RowKind
from kagezou.ui.viewport.handle_source import Task
from kagezou.ui.window.main_window import MainWindow
from kagezou.ui.window.parts import Parts

pytestmark = pytest.mark.feet

DRAWINGS = 8
RISES_PX = {3: 16, 4: 28, 5: 14}
"""How far the right leg is lifted, by drawing."""


@pytest.fixture
def two_legs(tmp_path: Path) -> Path:
    """A figure that lifts its right leg, drawing by drawing, and sets it down."""
    folder = tmp_path / "stepper"
    folder.mkdir()
    for number in range(1, DRAWINGS + 1):
        rgba = np.zeros((300, 240, 4), np.uint8)
        up = RISES_PX.get(number, 0)
        rgba[40:190, 80:160] = (60, 110, 190, 255)
        rgba[190:280, 85:105] = (70, 60, 50, 255)
        rgba[190 : 280 - up, 135:155] = (70, 60, 50, 255)
        write_rgba(folder / f"step_{number:04d}.png", rgba)
    return folder


@pytest.fixture
def stepping(qtbot: QtBot, window: MainWindow, two_legs: Path) -> MainWindow:
    """The window with that figure, its feet found."""
    with qtbot.waitSignal(window.parts.feet.found, timeout=60_000):
        window.parts.project.bring([two_legs])
    return window


def is_for(parts: Parts, task: Task) -> bool:
    return parts.viewport.controller.task is task


def hand(window: MainWindow, handle_id: str) -> Handle:
    handle = window.parts.viewport.controller.handles.find(handle_id)
    assert handle is not None
    return handle


def place_of(window: MainWindow, handle_id: str) -> QPoint:
    at = window.parts.viewport.viewpoint.view.view_from_canvas(hand(window, handle_id).canvas_px)
    return QPointF(*at).toPoint()


def test_feet_are_found_after_import_and_are_no_step_of_their_own(stepping: MainWindow) -> None:
    session = stepping.parts.bridge.session
    (layer,) = session.document.layers
    assert all(drawing.feet for drawing in layer.cels.drawings)
    assert session.undo_name == "Import character"
    session.undo()
    assert session.document.is_blank
    session.redo()
    assert session.document.layers[0].cels.drawings[0].feet


def test_a_lifted_foot_has_a_mark_on_the_ground(stepping: MainWindow) -> None:
    session = stepping.parts.bridge.session
    session.go_to(4)
    known = stances_of(session.document, session.document.layers[0].id)
    assert known is not None
    lifted = [foot for foot in known.at(4).feet if not foot.is_planted]
    assert len(lifted) == 1
    assert hand(stepping, f"foot_ground.{lifted[0].track}").canvas_px[1] == pytest.approx(lifted[0].ground_row)


def test_a_right_click_says_what_a_foot_does(qtbot: QtBot, stepping: MainWindow) -> None:
    session, viewport = stepping.parts.bridge.session, stepping.parts.viewport
    session.go_to(4)
    foot = next(handle for handle in viewport.controller.handles.handles if handle.id.startswith("foot."))
    qtbot.mouseClick(viewport, Qt.MouseButton.RightButton, pos=place_of(stepping, foot.id))
    menu = viewport.foot_menu
    assert menu is not None
    chosen: QAction = next(action for action in menu.actions() if action.text() == "Lifted")
    chosen.trigger()
    pin = pin_of(session.document.layers[0].cels.drawings[3], foot.index or 0)
    assert pin is not None
    assert pin.verdict is Verdict.LIFTED
    assert session.undo_name == "Lift foot"
    menu.close()


def test_a_foot_is_dragged_and_added_by_a_double_click(qtbot: QtBot, stepping: MainWindow) -> None:
    session, viewport = stepping.parts.bridge.session, stepping.parts.viewport
    start = place_of(stepping, "foot.0")
    qtbot.mousePress(viewport, Qt.MouseButton.LeftButton, pos=start)
    qtbot.mouseMove(viewport, start + QPoint(6, 0))
    qtbot.mouseMove(viewport, start + QPoint(12, -3))
    qtbot.mouseRelease(viewport, Qt.MouseButton.LeftButton, pos=start + QPoint(12, -3))
    assert pin_of(session.document.layers[0].cels.drawings[0], 0) is not None
    middle = viewport.viewpoint.view.view_from_canvas((120.0, 150.0))
    qtbot.mouseDClick(viewport, Qt.MouseButton.LeftButton, pos=QPointF(*middle).toPoint())
    assert session.undo_name == "Add foot"


def test_what_a_person_said_survives_a_new_search(qtbot: QtBot, stepping: MainWindow) -> None:
    parts = stepping.parts
    session = parts.bridge.session
    foot = parts.viewport.contacts.contacts.foot_of(hand(stepping, "foot.0"))
    assert foot is not None
    parts.viewport.contacts.contacts.judge(foot, Verdict.LIFTED)
    with qtbot.waitSignal(parts.feet.found, timeout=60_000):
        parts.actions["find_feet"].trigger()
    pin = pin_of(session.document.layers[0].cels.drawings[0], foot.track)
    assert pin is not None
    assert pin.verdict is Verdict.LIFTED


def test_without_doubt_there_is_nowhere_to_go(stepping: MainWindow) -> None:
    before = stepping.parts.bridge.frame
    known = stances_of(stepping.parts.bridge.document, stepping.parts.bridge.document.layers[0].id)
    assert known is not None
    stepping.parts.actions["doubtful_next"].trigger()
    assert stepping.parts.bridge.frame == next((at for at in known.doubtful if at > before), before)


def test_a_cel_is_transformed_by_hand(qtbot: QtBot, stepping: MainWindow) -> None:
    parts = stepping.parts
    parts.actions["transform_cel"].setChecked(True)
    assert is_for(parts, Task.TRANSFORM)
    corner = place_of(stepping, "cel.corner.2")
    qtbot.mousePress(parts.viewport, Qt.MouseButton.LeftButton, pos=corner)
    qtbot.mouseMove(parts.viewport, corner + QPoint(10, 10))
    qtbot.mouseMove(parts.viewport, corner + QPoint(20, 20))
    qtbot.mouseRelease(parts.viewport, Qt.MouseButton.LeftButton, pos=corner + QPoint(20, 20))
    layer = parts.bridge.document.layers[0]
    assert layer.tracks["scale"].constant != (100.0, 100.0)
    qtbot.keyClick(parts.viewport, Qt.Key.Key_Escape)
    qtbot.keyClick(parts.viewport, Qt.Key.Key_Escape)
    assert is_for(parts, Task.SCENE)
    assert not parts.actions["transform_cel"].isChecked()


def test_the_timeline_has_a_row_of_feet(stepping: MainWindow) -> None:
    document = stepping.parts.bridge.document
    figure = document.layers[0]
    found = stances_of(document, figure.id)
    assert found is not None
    shown = feet_over_time(document, figure.id, found)
    lifted = [span for span in shown.spans if not span.is_planted]
    assert [(span.frame, span.end) for span in lifted] == [(3, 6)]
    assert all(span.end > span.frame for span in shown.spans)
    assert (shown.flights, shown.pinned) == ((), ())
    assert words_at(shown, found, 4).startswith("1 of 2")
    rows = stepping.parts.time.timeline.rows.rows
    assert [row.kind for row in rows][1:3] == [RowKind.LAYER, RowKind.FEET]
    pinned = judge_foot(document, figure.id, 2, 0, Verdict.LIFTED)
    again = stances_of(pinned, figure.id)
    assert again is not None
    shown = feet_over_time(pinned, figure.id, again)
    assert shown.pinned == (3,)
    assert "pinned" in words_at(shown, again, 3)
