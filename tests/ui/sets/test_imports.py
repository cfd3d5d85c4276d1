"""Sets from files in the window: dropped, seen by their camera, stood upon, sized by two points, taken back."""

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from pytestqt.qtbot import QtBot

from kagezou.document import set_properties as lines
from kagezou.document.address import Address, value_of
from kagezou.document.edits import set_constant
from kagezou.document.invariants import check
from kagezou.document.properties import FOV, GROUND_POSITION, VISIBLE
from kagezou.document.property import AnyProperty
from kagezou.geometry.vectors import Point2
from kagezou.importing.set_sizing import figure_height
from kagezou.scene.evaluate import camera_at, evaluate
from kagezou.ui.sets.import_bar import KEEP_VIEW
from kagezou.ui.window.main_window import MainWindow
from tests.ui.viewing import write_garbage
from tests.ui.window.test_window import drop, reply

FLOOR = "v -9 0 -9\nv 9 0 -9\nv 9 0 3\nv -9 0 3\nf 1 4 3 2\nv -9 2 -9\nv 9 2 -9\nf 1 2 6 5\n"
"""A floor of 18 by 12 and a wall of 2 at its back."""


@pytest.fixture
def dungeon(samples: Path) -> Path:
    return samples / "bg3d_dungeon_stairs" / "scene.glb"


@pytest.fixture
def floor(tmp_path: Path) -> Path:
    path = tmp_path / "floor.obj"
    path.write_text(FLOOR)
    return path


def value(window: MainWindow, prop: AnyProperty) -> object:
    document = window.parts.open_project.bridge.document
    piece_id = document.pieces[-1].id if prop in lines.SET_LINES and prop is not lines.GROUND_RECEIVES else None
    return value_of(document, Address(prop, piece_id=piece_id), 1)


def click(qtbot: QtBot, window: MainWindow, canvas_px: Point2) -> None:
    x, y = window.parts.viewport.viewpoint.view.view_from_canvas(canvas_px)
    qtbot.mouseClick(window.parts.viewport, Qt.MouseButton.LeftButton, pos=QPoint(round(x), round(y)))


def seen(window: MainWindow, point: tuple[float, float, float]) -> Point2:
    document = window.parts.open_project.bridge.document
    mesh = evaluate(document, 1).pieces[-1].mesh
    assert mesh is not None
    x, y, w = camera_at(document, 1).canvas_from_world() @ np.array(mesh.world_from_mesh) @ [*point, 1.0]
    return (float(x / w), float(y / w))


def choose_camera(window: MainWindow, number: int) -> None:
    camera = window.parts.sets.bar.camera
    camera.setCurrentIndex(camera.findData(number))
    camera.activated.emit(camera.currentIndex())


def test_a_set_dropped_on_the_window_is_seen_by_its_camera(walking: MainWindow, dungeon: Path) -> None:
    before = walking.parts.open_project.bridge.document
    drop(walking, dungeon)
    document, bar = walking.parts.open_project.bridge.document, walking.parts.sets.bar
    check(document)
    (piece,) = document.pieces
    assert (piece.name, piece.source) == ("scene", dungeon)
    assert value(walking, FOV) == pytest.approx(42.0)
    assert value(walking, lines.GROUND_RECEIVES) is False
    assert bar.isVisible()
    assert bar.camera.currentText() == "shot_cam"
    assert not bar.size_by_points.isEnabled()
    walking.parts.actions["undo"].trigger()
    assert walking.parts.open_project.bridge.document is before
    assert not bar.isVisible()


def test_another_choice_right_after_the_import_stays_one_step(walking: MainWindow, dungeon: Path) -> None:
    before = walking.parts.open_project.bridge.document
    drop(walking, dungeon)
    choose_camera(walking, KEEP_VIEW)
    assert value(walking, FOV) == 0.0
    assert walking.parts.sets.bar.size_by_points.isEnabled()
    choose_camera(walking, 0)
    assert value(walking, FOV) == pytest.approx(42.0)
    walking.parts.actions["undo"].trigger()
    assert walking.parts.open_project.bridge.document is before


def test_a_choice_after_other_work_keeps_that_work(walking: MainWindow, dungeon: Path) -> None:
    drop(walking, dungeon)
    document = walking.parts.open_project.bridge.document
    hidden = set_constant(document, Address(VISIBLE, document.layers[0].id), raw=False)
    walking.parts.open_project.bridge.session.edit("Hide", hidden)
    walking.parts.actions["settle_set"].trigger()
    choose_camera(walking, 0)
    document = walking.parts.open_project.bridge.document
    assert not evaluate(document, 1).layers
    assert value(walking, FOV) == pytest.approx(42.0)


def test_a_click_stands_the_character_on_a_step(qtbot: QtBot, walking: MainWindow, dungeon: Path) -> None:
    drop(walking, dungeon)
    places = {point: seen(walking, point) for point in ((0.0, 0.0, 0.0), (2.0, 1.0, -3.0), (-3.0, 0.5, -5.0))}
    qtbot.mouseClick(walking.parts.sets.bar.stand, Qt.MouseButton.LeftButton)
    assert "Click where the character's feet are" in walking.parts.sets.bar.hint
    assert walking.parts.viewport.cursor().shape() is Qt.CursorShape.CrossCursor
    click(qtbot, walking, (120.0, 2.0))
    assert "nothing of the set" in walking.parts.sets.bar.hint
    click(qtbot, walking, (150.0, 110.0))
    anchor = value(walking, lines.PIECE_ANCHOR)
    assert isinstance(anchor, tuple)
    assert float(str(anchor[1])) > 0.3, "metres above the floor"
    assert value(walking, GROUND_POSITION) == pytest.approx((150.0, 110.0), abs=1.0)
    for point, place in places.items():
        assert seen(walking, point) == pytest.approx(place, abs=1e-6)
    assert not walking.parts.viewport.picking.is_on
    assert not walking.parts.sets.bar.stand.isChecked()


def test_two_clicks_and_a_number_settle_the_size(qtbot: QtBot, walking: MainWindow, floor: Path) -> None:
    drop(walking, floor)
    bar = walking.parts.sets.bar
    assert bar.camera.currentText() == "None in the file"
    qtbot.mouseClick(bar.size_by_points, Qt.MouseButton.LeftButton)
    foot, head = seen(walking, (0.0, 0.01, -9.0)), seen(walking, (0.0, 1.9, -9.0))
    click(qtbot, walking, foot)
    click(qtbot, walking, head)
    assert [round(place[0]) for place in walking.parts.viewport.picking.marks] == pytest.approx(
        [foot[0], head[0]], abs=2
    )
    assert bar.length.isVisible()
    bar.length.set_value(1.6)
    bar.measure.setCurrentIndex(1)
    bar.length_entered.emit(bar.length.value, bar.measure.currentData())
    scale = value(walking, lines.PIECE_SCALE)
    # What was marked, nearly 1.9 units, is now as tall as the figure, which stands for 1.6 metres.
    assert scale == pytest.approx(figure_height(walking.parts.open_project.bridge.document) / 1.9, rel=0.05)
    assert not walking.parts.viewport.picking.marks
    assert not bar.length.isVisible()


def test_escape_gives_up_a_click_and_handles_come_back(qtbot: QtBot, walking: MainWindow, floor: Path) -> None:
    drop(walking, floor)
    qtbot.mouseClick(walking.parts.sets.bar.stand, Qt.MouseButton.LeftButton)
    before = walking.parts.open_project.bridge.document
    qtbot.keyClick(walking.parts.viewport, Qt.Key.Key_Escape)
    assert not walking.parts.sets.bar.stand.isChecked()
    assert walking.parts.sets.bar.hint == ""
    click(qtbot, walking, (120.0, 150.0))
    assert walking.parts.open_project.bridge.document is before


def test_the_other_axis_may_point_up(walking: MainWindow, floor: Path) -> None:
    drop(walking, floor)
    up = walking.parts.sets.bar.up
    up.setCurrentIndex(up.findData("z"))
    up.activated.emit(up.currentIndex())
    assert value(walking, lines.PIECE_UP) == "z"
    assert len(walking.parts.open_project.bridge.document.pieces) == 1


def test_a_set_may_come_first(qtbot: QtBot, window: MainWindow, dungeon: Path, cels: Path) -> None:
    drop(window, dungeon)
    assert window.pages.currentWidget() is window.parts.viewport
    stairs = seen(window, (2.0, 1.0, -3.0))
    drop(window, cels)
    qtbot.waitUntil(
        lambda: (
            window.parts.viewport.frame_painter is not None and window.parts.viewport.frame_painter.pictures_drawn > 0
        )
    )
    assert seen(window, (2.0, 1.0, -3.0)) == pytest.approx(stairs, abs=1e-6)


def test_what_is_broken_is_said_and_changes_nothing(walking: MainWindow, tmp_path: Path) -> None:
    before = walking.parts.open_project.bridge.document
    write_garbage(tmp_path / "set.glb")
    drop(walking, tmp_path / "set.glb")
    assert "set.glb" in walking.parts.bar.text
    assert walking.parts.open_project.bridge.document is before
    assert not walking.parts.sets.bar.isVisible()


def test_a_set_whose_file_went_is_left_out_of_the_picture(qtbot: QtBot, walking: MainWindow, floor: Path) -> None:
    drop(walking, floor)
    floor.unlink()
    walking.parts.viewport.reread()
    qtbot.waitUntil(lambda: "floor.obj" in walking.parts.bar.text)
    assert walking.parts.viewport.read_picture() is not None


def test_the_menu_asks_for_a_file(walking: MainWindow, floor: Path) -> None:
    replies = reply(walking, floor)
    walking.parts.actions["import_set"].trigger()
    assert replies.asked == ["set_file"]
    assert [piece.name for piece in walking.parts.open_project.bridge.document.pieces] == ["floor"]
    assert walking.parts.actions["settle_set"].isEnabled()
