"""The frame around several selected keys: moved, stretched, scaled, taken back, and in every view."""

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel
from pytestqt.qtbot import QtBot

from kagezou.document import edits
from kagezou.document.address import Address, track_of
from kagezou.document.key_edits import KeyRef
from kagezou.document.linking import link
from kagezou.document.model import Canvas, Cels
from kagezou.document.properties import GROUND_DECLINATION, GROUND_ROLL, OPACITY, SIMPLIFY
from kagezou.geometry.box import Box
from kagezou.tools.curves.key_box import BoxGrip, KeyBox
from kagezou.tools.curves.picture import GraphKind
from kagezou.ui.curves.curve_editor import CurveEditor
from kagezou.ui.project.open_project import OpenProject
from tests.ui.viewing import OwnClipboard, move

ROLL, DECLINATION = Address(GROUND_ROLL), Address(GROUND_DECLINATION)
NONE, CONTROL, SHIFT = (
    Qt.KeyboardModifier.NoModifier,
    Qt.KeyboardModifier.ControlModifier,
    Qt.KeyboardModifier.ShiftModifier,
)
LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def editor(qtbot: QtBot, open_project: OpenProject) -> CurveEditor:
    """A cut of 48 frames: the roll on 10, 20 and 30, of which it is at 0, 20 and 10; all three keys selected."""
    session = open_project.bridge.session
    document = edits.set_canvas(session.document, Canvas(240, 200, length_frames=48))
    for frame, value in ((10, 0.0), (20, 20.0), (30, 10.0)):
        document = edits.set_key(document, ROLL, frame, value)
    session.edit("Key", document)
    made = CurveEditor(open_project.bridge, OwnClipboard())
    qtbot.addWidget(made)
    made.resize(1300, 420)
    made.show()
    qtbot.waitExposed(made)
    session.select_keys(frozenset(KeyRef(ROLL, frame) for frame in (10, 20, 30)))
    made.graph.fit_all()
    QApplication.processEvents()
    return made


def keys(open_project: OpenProject) -> list[tuple[int, float]]:
    return [(key.frame, round(float(str(key.value)), 1)) for key in track_of(open_project.bridge.document, ROLL).keys]


def box_of(editor: CurveEditor) -> KeyBox:
    box = editor.graph.key_box
    assert box is not None
    return box


def point(editor: CurveEditor, place: tuple[float, float]) -> QPoint:
    where = editor.graph.view.mapViewToScene(QPointF(*place))
    return editor.graph.mapFromScene(where.x(), where.y())


def pull(
    editor: CurveEditor,
    part: BoxGrip,
    frames: float,
    units: float,
    modifiers: Qt.KeyboardModifier = NONE,
    *,
    let_go: bool = True,
) -> None:
    viewport, x, y = editor.graph.viewport(), *box_of(editor).place_of(part)
    if part.is_inside:
        x, y = x - 3, y + 6
    start, end = point(editor, (x, y)), point(editor, (x + frames, y + units))
    QTest.mousePress(viewport, LEFT, modifiers, start)
    for step in (1, 2, 3, 4):
        move(viewport, start + (end - start) * step / 4, LEFT, modifiers)
    if let_go:
        QTest.mouseRelease(viewport, LEFT, modifiers, end)


def words(editor: CurveEditor) -> str:
    found = [label for label in editor.graph.findChildren(QLabel) if label.objectName() == "graph_words"]
    return found[0].text() if found[0].isVisible() else ""


def test_an_edge_stretches_time_about_the_other_one(editor: CurveEditor, open_project: OpenProject) -> None:
    pull(editor, BoxGrip(1, 0), 10, 3, let_go=False)
    assert words(editor) == "time × 1.50"
    QTest.mouseRelease(editor.graph.viewport(), LEFT)
    assert keys(open_project) == [(10, 0.0), (25, 20.0), (40, 10.0)]
    assert words(editor) == ""
    assert {ref.frame for ref in open_project.bridge.session.state.keys} == {10, 25, 40}
    assert open_project.bridge.session.undo_name == "Stretch keys"
    open_project.bridge.session.undo()
    assert keys(open_project) == [(10, 0.0), (20, 20.0), (30, 10.0)]


def test_with_control_the_middle_stays(editor: CurveEditor, open_project: OpenProject) -> None:
    pull(editor, BoxGrip(-1, 0), 5, 0, CONTROL)
    assert keys(open_project) == [(15, 0.0), (20, 20.0), (25, 10.0)]


def test_pulled_over_the_other_edge_the_order_stays(editor: CurveEditor, open_project: OpenProject) -> None:
    pull(editor, BoxGrip(1, 0), -30, 0)
    assert keys(open_project) == [(10, 0.0), (11, 20.0), (12, 10.0)]


def test_the_upper_edge_scales_values_and_a_corner_both(editor: CurveEditor, open_project: OpenProject) -> None:
    pull(editor, BoxGrip(0, 1), 0, -10)
    assert [frame for frame, _ in keys(open_project)] == [10, 20, 30]
    assert [value for _, value in keys(open_project)] == pytest.approx([0, 10, 5], abs=0.3)
    open_project.bridge.session.undo()
    pull(editor, BoxGrip(-1, -1), 10, 10)
    assert [frame for frame, _ in keys(open_project)] == [20, 25, 30]
    assert [value for _, value in keys(open_project)] == pytest.approx([10, 20, 15], abs=0.3)
    assert open_project.bridge.session.undo_name == "Scale keys"


def test_inside_moves_and_shift_keeps_to_one_axis(editor: CurveEditor, open_project: OpenProject) -> None:
    pull(editor, BoxGrip(0, 0), 5, -6)
    assert [frame for frame, _ in keys(open_project)] == [15, 25, 35]
    assert [value for _, value in keys(open_project)] == pytest.approx([-6, 14, 4], abs=0.3)
    assert open_project.bridge.session.undo_name == "Move keys"


def test_escape_takes_the_drag_back(editor: CurveEditor, open_project: OpenProject) -> None:
    before = open_project.bridge.document
    pull(editor, BoxGrip(1, 1), 8, 4, let_go=False)
    assert open_project.bridge.document is not before
    QTest.keyClick(editor.graph, Qt.Key.Key_Escape)
    assert open_project.bridge.document is before
    assert words(editor) == ""
    QTest.mouseRelease(editor.graph.viewport(), LEFT)
    assert open_project.bridge.document is before


def test_in_the_normalised_view_the_curve_follows_the_hand_and_fits_anew_afterwards(
    editor: CurveEditor, open_project: OpenProject
) -> None:
    editor.normalise.trigger()
    QApplication.processEvents()
    pull(editor, BoxGrip(0, 1), 0, -1, let_go=False)
    assert max(mark.ordinate for mark in editor.graph.pictures[0].keys) == pytest.approx(0, abs=0.05)
    assert [value for _, value in keys(open_project)] == pytest.approx([0, 10, 5], abs=0.3)
    QTest.mouseRelease(editor.graph.viewport(), LEFT)
    assert max(mark.ordinate for mark in editor.graph.pictures[0].keys) == pytest.approx(1)


def test_two_properties_are_scaled_each_in_its_own_units(editor: CurveEditor, open_project: OpenProject) -> None:
    session, document = open_project.bridge.session, open_project.bridge.document
    for frame, value in ((10, 40.0), (30, 60.0)):
        document = edits.set_key(document, DECLINATION, frame, value)
    session.edit("Key", document)
    session.select_keys(session.state.keys | {KeyRef(DECLINATION, 10), KeyRef(DECLINATION, 30)})
    editor.normalise.trigger()
    QApplication.processEvents()
    pull(editor, BoxGrip(1, 1), -10, -1)
    assert [value for _, value in keys(open_project)] == pytest.approx([0, 10, 5], abs=0.3)
    declination = [float(str(key.value)) for key in track_of(session.document, DECLINATION).keys]
    assert declination == pytest.approx([40, 50], abs=0.3)
    assert [key.frame for key in track_of(session.document, DECLINATION).keys] == [10, 20]


def test_layers_that_are_chosen_together_have_their_curves_and_linked_ones_once(
    editor: CurveEditor, open_project: OpenProject
) -> None:
    session, document = open_project.bridge.session, open_project.bridge.document
    for name in "AB":
        document = edits.add_layer(document, name, Cels(), Box(0, 0, 9, 9))
    of_layers = [Address(prop, layer.id) for layer in document.layers for prop in (OPACITY, SIMPLIFY)]
    for address in of_layers:
        document = edits.set_key(document, address, 5, 0.5)
    session.edit("Layers", link(document, of_layers[1]))
    session.select("layer-1", others=frozenset({"layer-2"}))
    shown = [(each.curve.address.property, each.curve.address.layer_id) for each in editor.graph.pictures]
    assert shown[1:] == [(SIMPLIFY, "layer-1"), (OPACITY, "layer-1"), (OPACITY, "layer-2")]


def test_there_is_no_frame_for_one_key_for_speeds_and_when_only_looking(
    editor: CurveEditor, open_project: OpenProject
) -> None:
    session = open_project.bridge.session
    session.select_keys(frozenset({KeyRef(ROLL, 10)}))
    shown = [editor.graph.key_box is not None]
    session.select_keys(frozenset({KeyRef(ROLL, 10), KeyRef(ROLL, 30)}))
    shown.append(editor.graph.key_box is not None)
    editor.choice.set(kind=GraphKind.SPEED)
    shown.append(editor.graph.key_box is not None)
    editor.choice.set(kind=GraphKind.VALUE)
    editor.look_only.trigger()
    shown.append(editor.graph.key_box is not None)
    assert shown == [False, True, False, False]


def test_keys_on_one_level_have_no_handles_up_and_down() -> None:
    flat = KeyBox(1, 9, 5, 5, 10, 10)
    assert set(flat.parts) == {BoxGrip(-1, 0), BoxGrip(1, 0)}
    upright = KeyBox(4, 4, 0, 5, 10, 10)
    assert set(upright.parts) == {BoxGrip(0, -1), BoxGrip(0, 1)}
    assert flat.part_at((9.0 + 1.6 + 0.9, 5.0)) == BoxGrip(1, 0)
    assert flat.part_at((5.0, 5.5)) == BoxGrip(0, 0)
    assert flat.part_at((20.0, 5.0)) is None


def test_a_click_within_the_frame_chooses_as_it_does_elsewhere(editor: CurveEditor, open_project: OpenProject) -> None:
    QTest.mouseClick(editor.graph.viewport(), LEFT, pos=point(editor, (12, 16)))
    assert not open_project.bridge.session.state.keys
    open_project.bridge.session.select_keys(frozenset({KeyRef(ROLL, 10), KeyRef(ROLL, 20)}))
    QTest.mouseClick(editor.graph.viewport(), LEFT, pos=point(editor, (15, 10)))
    assert len(open_project.bridge.session.state.keys) == 3, "the curve was clicked"
