"""The set in the picture: outlines that are touched, handles that are dragged, and what keys do to them."""

from collections.abc import Callable
from itertools import pairwise

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from kagezou.document import properties
from kagezou.document import set_properties as s
from kagezou.document.address import Address, value_of
from kagezou.document.edits import set_constant
from kagezou.document.model import Document
from kagezou.document.property import AnyProperty
from kagezou.document.set_pieces import add_piece
from kagezou.scene.set_outlines import outlines_of
from kagezou.tools.handle import GuideKind
from kagezou.ui.viewport.figure_touch import is_on_figure
from kagezou.ui.window.main_window import MainWindow
from tests.ui.viewing import drag, move, place_of

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def furnished(walking: MainWindow) -> MainWindow:
    """The window with a wall and a box; the layer is worked on."""
    document = walking.parts.open_project.bridge.document
    document = add_piece(document, "Back", "wall", {"position": [120, 130], "width": 200, "height": 150})
    document = add_piece(document, "Crate", "box", {"position": [200, 165], "width": 40, "height": 40, "depth": 30})
    walking.parts.open_project.bridge.session.edit("Furnish", document)
    return walking


def value(document: Document, prop: AnyProperty, piece_id: str = "piece-2") -> object:
    return value_of(document, Address(prop, piece_id=piece_id), 1)


def at(window: MainWindow, x: float, y: float) -> QPoint:
    seen = window.parts.viewport.viewpoint.view.view_from_canvas((x, y))
    return QPoint(round(seen[0]), round(seen[1]))


def test_an_outline_under_the_pointer_says_its_name_and_a_click_works_on_it(
    qtbot: QtBot, furnished: MainWindow
) -> None:
    viewport, bridge = furnished.parts.viewport, furnished.parts.open_project.bridge
    edge = at(furnished, 20, 80)
    move(viewport, edge)
    assert viewport.controller.words == "Back"
    assert viewport.controller.pieces.guides
    move(viewport, at(furnished, 60, 40))
    assert viewport.controller.words == ""
    history = bridge.session.undo_name
    qtbot.mouseClick(viewport, LEFT, pos=edge)
    assert (bridge.piece_id, bridge.layer_id) == ("piece-1", None)
    assert bridge.session.undo_name == history, "choosing is no step"
    assert viewport.controller.selected_id == "piece.position"


def test_pieces_are_faintly_outlined_while_a_layer_is_worked_on(furnished: MainWindow) -> None:
    viewport, bridge = furnished.parts.viewport, furnished.parts.open_project.bridge
    bridge.session.select(bridge.document.layers[0].id)
    kinds = {guide.kind for guide in viewport.controller.handles.guides}
    assert kinds >= {GuideKind.PIECE_OTHER, GuideKind.PIECE_FLOOR}
    with_lines = viewport.overlay.grab().toImage()
    without = bridge.document
    for piece in without.pieces:
        without = set_constant(without, Address(s.PIECE_PRESENT, piece_id=piece.id), raw=False)
    bridge.session.edit("Switch off", without)
    assert viewport.overlay.grab().toImage() != with_lines


def test_an_outline_is_dragged_as_the_place_it_stands_on(qtbot: QtBot, furnished: MainWindow) -> None:
    viewport, bridge = furnished.parts.viewport, furnished.parts.open_project.bridge
    start = at(furnished, 20, 80)
    qtbot.mousePress(viewport, LEFT, pos=start)
    for x in (10, 25, 40):
        move(viewport, start + QPoint(x, 0), LEFT)
    zoom = viewport.viewpoint.view.zoom
    assert value(bridge.document, s.PIECE_POSITION, "piece-1") == pytest.approx((120 + 40 / zoom, 130))
    qtbot.keyClick(viewport, Qt.Key.Key_Escape)
    assert value(bridge.document, s.PIECE_POSITION, "piece-1") == (120, 130)


def test_a_double_click_on_an_outline_still_adds_a_grounding_point(qtbot: QtBot, furnished: MainWindow) -> None:
    viewport, bridge = furnished.parts.viewport, furnished.parts.open_project.bridge
    view, cels = viewport.viewpoint.view, furnished.parts.open_project.cels
    edges = [
        (ax + (bx - ax) * step / 50, ay + (by - ay) * step / 50)
        for outline in outlines_of(bridge.document, 1)
        for line in outline.seen
        for (ax, ay), (bx, by) in pairwise(line)
        for step in range(51)
    ]
    x, y = next(each for each in edges if is_on_figure(bridge.document, "layer-1", 1, each, 1.0, cels))
    edge = QPointF(*view.view_from_canvas((x, y))).toPoint()
    qtbot.mouseClick(viewport, LEFT, pos=edge)
    assert bridge.piece_id is not None
    qtbot.mouseDClick(viewport, LEFT, pos=edge)
    assert bridge.layer_id == "layer-1"
    points = value_of(bridge.document, Address(properties.GROUNDING, "layer-1"), 1)
    assert isinstance(points, tuple)
    assert len(points) == 1


def test_handles_are_dragged_typed_and_nudged(qtbot: QtBot, furnished: MainWindow) -> None:
    viewport, bridge = furnished.parts.viewport, furnished.parts.open_project.bridge
    bridge.session.select_piece("piece-2")
    drag(qtbot, viewport, "piece.width", QPoint(30, 0))
    zoom = viewport.viewpoint.view.zoom
    assert value(bridge.document, s.PIECE_WIDTH) == pytest.approx(40 + 2 * 30 / zoom)
    assert bridge.session.undo_name == "Move Width"
    drag(qtbot, viewport, "piece.height", QPoint(0, -20), let_go=False)
    qtbot.keyClicks(viewport, "66")
    qtbot.keyClick(viewport, Qt.Key.Key_Return)
    assert value(bridge.document, s.PIECE_HEIGHT) == 66
    viewport.controller.select("piece.position")
    viewport.setFocus()
    qtbot.keyClick(viewport, Qt.Key.Key_Left)
    assert value(bridge.document, s.PIECE_POSITION) == (199, 165)
    assert bridge.session.undo_name == "Nudge Set piece"


def test_delete_takes_away_the_piece_whose_handle_is_selected_and_no_other(
    qtbot: QtBot, furnished: MainWindow, focus: Callable[[QWidget], None]
) -> None:
    viewport, bridge = furnished.parts.viewport, furnished.parts.open_project.bridge
    focus(viewport)
    bridge.session.select_piece("piece-2")
    viewport.controller.select("light.lamp")
    furnished.parts.actions["delete"].trigger()
    assert len(bridge.document.pieces) == 2
    qtbot.mouseClick(viewport, LEFT, pos=place_of(viewport, "piece.depth"))
    furnished.parts.actions["delete"].trigger()
    assert [piece.name for piece in bridge.document.pieces] == ["Back"]
    assert bridge.layer_id == "layer-1"


def test_the_handles_of_a_piece_go_with_it(furnished: MainWindow) -> None:
    viewport, bridge = furnished.parts.viewport, furnished.parts.open_project.bridge
    bridge.session.select_piece("piece-1")
    assert viewport.controller.handles.find("piece.lean") is not None
    hidden = set_constant(bridge.document, Address(s.PIECE_PRESENT, piece_id="piece-1"), False)
    bridge.session.edit("Hide", hidden)
    assert viewport.controller.handles.find("piece.lean") is None
    bridge.session.undo()
    bridge.session.undo()
    assert viewport.controller.handles.find("piece.position") is None
    viewport.grab()
