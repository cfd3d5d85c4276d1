"""The curve editor under the hand of an animator and the eyes of a lead."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialogButtonBox, QInputDialog, QMenu, QToolButton, QWidget
from pytestqt.qtbot import QtBot

from kagezou.animation.ease import EASY, Ease
from kagezou.animation.track import Interpolation, components_of
from kagezou.document import edits, key_edits, review
from kagezou.document.address import Address, track_of, value_of
from kagezou.document.key_edits import KeyRef
from kagezou.document.model import Canvas, Document, Exposure
from kagezou.document.properties import GROUND_DECLINATION, LIGHT_POSITION, OPACITY, VISIBLE
from kagezou.errors import UsageProblem
from kagezou.importing.staging import CharacterSource
from kagezou.io.project.file import save
from kagezou.tools.curves.curve_list import curves_of, same_in
from kagezou.tools.curves.picture import CurvePicture, differing_frames
from kagezou.ui.curves.curve_editor import CurveEditor
from kagezou.ui.curves.flags import FlagKind, flags_of
from kagezou.ui.curves.key_rows import HEADINGS, parse_row, pasted, rows_of, text_of, with_cell
from kagezou.ui.curves.panel import CurvesPanel
from kagezou.ui.curves.readout import readout
from kagezou.ui.curves.velocity import VelocityDialog
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.widgets.overflow_row import OverflowRow
from kagezou.ui.window.main_window import MainWindow
from tests.ui.viewing import OwnClipboard, move

LIGHT, DECLINATION = Address(LIGHT_POSITION), Address(GROUND_DECLINATION)
NONE = Qt.KeyboardModifier.NoModifier
LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def keyed(open_project: OpenProject, cels: Path) -> OpenProject:
    """A cut of 48 frames: the lamp keyed on 5, 15 and 30, the declination eased from 10 to 40, the opacity on 8."""
    open_project.bring((CharacterSource("Walker", cels),)).at_once()
    session = open_project.bridge.session
    document = edits.set_canvas(session.document, Canvas(240, 200, length_frames=48))
    for frame, x in ((5, 0.0), (15, 100.0), (30, 50.0)):
        document = edits.set_key(document, LIGHT, frame, (x, -200.0, 900.0))
    document = edits.set_key(document, DECLINATION, 10, 30.0, Interpolation.BEZIER)
    document = edits.set_key(document, DECLINATION, 40, 60.0, Interpolation.BEZIER)
    document = edits.set_key(document, Address(OPACITY, document.layers[0].id), 8, 0.5)
    document = edits.set_key(document, Address(VISIBLE, document.layers[0].id), 8, raw=True)
    session.edit("Key", document)
    return open_project


@pytest.fixture
def editor(qtbot: QtBot, keyed: OpenProject, clipboard: OwnClipboard) -> CurveEditor:
    made = CurveEditor(keyed.bridge, clipboard)
    qtbot.addWidget(made)
    made.resize(1300, 420)
    made.show()
    qtbot.waitExposed(made)
    made.graph.fit_all()
    QApplication.processEvents()
    return made


def picture_of(editor: CurveEditor, address: Address, component: int = 0) -> CurvePicture:
    return next(
        each for each in editor.graph.pictures if (each.curve.address, each.curve.component) == (address, component)
    )


def point(editor: CurveEditor, frame: float, ordinate: float) -> QPoint:
    graph = editor.graph
    place = graph.view.mapViewToScene(QPointF(frame, ordinate))
    return graph.mapFromScene(place.x(), place.y())


def frames(open_project: OpenProject, address: Address) -> list[int]:
    return [key.frame for key in track_of(open_project.bridge.document, address).keys]


def drag(
    editor: CurveEditor, start: QPoint, end: QPoint, modifiers: Qt.KeyboardModifier = NONE, *, let_go: bool = True
) -> None:
    viewport = editor.graph.viewport()
    QTest.mousePress(viewport, LEFT, modifiers, start)
    for step in (1, 2, 3, 4):
        move(viewport, start + (end - start) * step / 4, LEFT, modifiers)
    if let_go:
        QTest.mouseRelease(viewport, LEFT, modifiers, end)


def test_one_curve_for_each_component_and_none_for_switches(keyed: OpenProject) -> None:
    curves = curves_of(keyed.bridge.document, keyed.bridge.layer_id)
    names = [(curve.address.property.name, curve.name) for curve in curves]
    assert sorted(names) == [
        ("ground.declination", ""),
        ("light.position", "x"),
        ("light.position", "y"),
        ("light.position", "z"),
        ("shadow.opacity", ""),
    ]
    assert len({(curve.color, curve.component) for curve in curves}) == len(curves)


def test_the_curves_lie_on_the_values(editor: CurveEditor, keyed: OpenProject) -> None:
    picture = picture_of(editor, DECLINATION)
    for frame in range(1, 49):
        drawn = np.interp(frame, picture.line.frames, picture.line.values)
        assert drawn == pytest.approx(value_of(keyed.bridge.document, DECLINATION, frame), abs=0.05)


def test_a_key_is_dragged_in_time_and_value_in_one_step(editor: CurveEditor, keyed: OpenProject) -> None:
    drag(editor, point(editor, 15, 100), point(editor, 19, 180))
    assert frames(keyed, LIGHT) == [5, 19, 30]
    x, y, z = components_of(value_of(keyed.bridge.document, LIGHT, 19)) or ()
    assert x == pytest.approx(180, abs=8)
    assert (y, z) == (-200.0, 900.0)
    assert keyed.bridge.session.state.keys == {KeyRef(LIGHT, 19)}
    assert keyed.bridge.session.undo_name == "Move keys"
    keyed.bridge.session.undo()
    assert frames(keyed, LIGHT) == [5, 15, 30]


def test_shift_keeps_to_one_axis_and_escape_takes_back(editor: CurveEditor, keyed: OpenProject) -> None:
    drag(editor, point(editor, 15, 100), point(editor, 21, 120), Qt.KeyboardModifier.ShiftModifier)
    keyed.bridge.session.select_keys(frozenset({KeyRef(LIGHT, frames(keyed, LIGHT)[1])}))
    assert frames(keyed, LIGHT) == [5, 21, 30]
    assert value_of(keyed.bridge.document, LIGHT, 21) == (100.0, -200.0, 900.0)
    drag(editor, point(editor, 21, 100), point(editor, 25, 300), let_go=False)
    assert frames(keyed, LIGHT) == [5, 25, 30]
    QTest.keyClick(editor.graph, Qt.Key.Key_Escape)
    assert frames(keyed, LIGHT) == [5, 21, 30]


def test_a_box_chooses_keys_and_a_click_beside_none(editor: CurveEditor, keyed: OpenProject) -> None:
    drag(editor, point(editor, 3, 350), point(editor, 17, 75))
    assert {ref for ref in keyed.bridge.session.state.keys if ref.address == LIGHT} == {KeyRef(LIGHT, 15)}
    QTest.mouseClick(editor.graph.viewport(), LEFT, NONE, point(editor, 44, 500))
    assert keyed.bridge.session.state.keys == frozenset()


def test_a_click_on_a_curve_chooses_its_keys_and_ctrl_adds_one(editor: CurveEditor, keyed: OpenProject) -> None:
    QTest.mouseClick(editor.graph.viewport(), LEFT, NONE, point(editor, 22, 900))
    assert keyed.bridge.session.state.keys == {KeyRef(LIGHT, frame) for frame in (5, 15, 30)}
    QTest.mouseClick(editor.graph.viewport(), LEFT, Qt.KeyboardModifier.ControlModifier, point(editor, 22, 900))
    assert frames(keyed, LIGHT) == [5, 15, 22, 30]
    x = value_of(keyed.bridge.document, LIGHT, 22)[0]  # type: ignore[index]
    assert x == pytest.approx(100 - 50 * 7 / 15), "the other components stay on their curves"


def test_a_handle_is_dragged_joined_or_alone(editor: CurveEditor, keyed: OpenProject) -> None:
    document = edits.set_key(keyed.bridge.document, DECLINATION, 25, 45.0, Interpolation.BEZIER)
    keyed.bridge.session.edit("Key", document)
    keyed.bridge.session.select_keys(frozenset({KeyRef(DECLINATION, 25)}))
    editor.graph.fit_chosen()
    QApplication.processEvents()
    handle = next(each for each in picture_of(editor, DECLINATION).handles if not each.is_before)
    assert (handle.frame, handle.ordinate) == pytest.approx((30.0, 45.0))
    drag(editor, point(editor, handle.frame, handle.ordinate), point(editor, 31, 51))
    key = track_of(keyed.bridge.document, DECLINATION).key_at(25)
    assert key is not None
    assert key.ease_out[0].speed == pytest.approx(1.0, abs=0.15)
    assert key.ease_out[0].influence == pytest.approx(6 / 15, abs=0.05)
    assert key.ease_in[0].speed == key.ease_out[0].speed
    assert keyed.bridge.session.undo_name == "Move handle"
    keyed.bridge.session.undo()
    drag(editor, point(editor, handle.frame, handle.ordinate), point(editor, 31, 51), Qt.KeyboardModifier.AltModifier)
    key = track_of(keyed.bridge.document, DECLINATION).key_at(25)
    assert key is not None
    assert key.ease_in[0] == EASY


def test_speeds_are_drawn_and_dragged(editor: CurveEditor, keyed: OpenProject) -> None:
    QTest.keyClick(editor.kind_box, Qt.Key.Key_Down)
    editor.choice.show(tuple(curve for curve in editor.choice.all if curve.address != DECLINATION), shown=False)
    editor.graph.fit_all()
    QApplication.processEvents()
    picture = picture_of(editor, DECLINATION)
    assert picture.line.values.max() == pytest.approx(1.5, abs=0.1)
    drag(editor, point(editor, 10, 0), point(editor, 10, 0.5))
    key = track_of(keyed.bridge.document, DECLINATION).key_at(10)
    assert key is not None
    assert key.ease_out[0].speed == pytest.approx(0.5, abs=0.05)


def test_hidden_isolated_and_normalised_curves(editor: CurveEditor, keyed: OpenProject) -> None:
    item = editor.tree.topLevelItem(0)
    assert item is not None
    assert item.text(0) == "Declination"
    item.setCheckState(0, Qt.CheckState.Unchecked)
    assert DECLINATION not in {picture.curve.address for picture in editor.graph.pictures}
    item.setCheckState(0, Qt.CheckState.Checked)
    keyed.bridge.session.select_keys(frozenset({KeyRef(DECLINATION, 10)}))
    editor.choice.set(isolates=True)
    assert {picture.curve.address for picture in editor.graph.pictures} == {DECLINATION}
    editor.choice.set(isolates=False)
    editor.normalise.trigger()
    QApplication.processEvents()
    values = picture_of(editor, LIGHT).line.values
    assert (float(values.min()), float(values.max())) == (-1, 1)
    drag(editor, point(editor, 15, 1.0), point(editor, 15, 0.5))
    assert value_of(keyed.bridge.document, LIGHT, 15)[0] == pytest.approx(75, abs=4)  # type: ignore[index]


def test_every_switch_switches(editor: CurveEditor) -> None:
    editor.take_snapshot()
    for button in editor.findChildren(QToolButton):
        if button.isCheckable() and button.text():
            before = button.isChecked()
            button.click()
            assert button.isChecked() != before, button.text()
    assert (editor.choice.isolates, editor.choice.is_locked, editor.choice.shows_snapshot) == (True, True, False)


def test_a_snapshot_is_compared_swapped_and_its_differences_found(editor: CurveEditor, keyed: OpenProject) -> None:
    before = keyed.bridge.document
    editor.take_snapshot()
    moved, _ = key_edits.move_keys(before, frozenset({KeyRef(LIGHT, 30)}), 4)
    keyed.bridge.session.edit("Move", moved)
    picture = picture_of(editor, LIGHT)
    assert picture.ghost is not None
    assert np.interp(30, picture.ghost.frames, picture.ghost.values) == pytest.approx(50)
    assert differing_frames(moved, before, picture.curve) == tuple(range(16, 34))
    assert "against the snapshot" in _read(editor, 25)
    editor.swap_snapshot()
    assert keyed.bridge.document is before
    assert editor.choice.snapshot is moved
    assert keyed.bridge.session.undo_name == "Swap with snapshot"


def test_another_saved_version_is_compared_by_layer_id_or_name(
    editor: CurveEditor, keyed: OpenProject, tmp_path: Path
) -> None:
    document = keyed.bridge.document
    opacity = Address(OPACITY, document.layers[0].id)
    other = edits.set_key(document, opacity, 8, 0.9)
    save(other, tmp_path / "other.kage")
    editor.compare_with(tmp_path / "other.kage")
    picture = picture_of(editor, opacity)
    assert picture.ghost is not None
    assert picture.ghost.values[0] == 0.9
    same_name = replace(other, layers=(replace(other.layers[0], id="elsewhere"),))
    assert same_in(same_name, picture.curve, document) == track_of(other, opacity)
    stranger = replace(other, layers=(replace(other.layers[0], id="elsewhere", name="X"),))
    assert same_in(stranger, picture.curve, document) is None
    refused: list[str] = []
    editor.refused.connect(refused.append)
    editor.compare_with(tmp_path / "nowhere.kage")
    assert "nowhere.kage" in refused[0]


def test_the_readout_says_value_speed_and_way(editor: CurveEditor) -> None:
    said = _read(editor, 10)
    assert said.startswith("10  (0+10)    Declination    30°")
    editor._bridge.session.select_keys(frozenset({KeyRef(LIGHT, 5)}))
    assert _read(editor, 10) == "10  (0+10)    Light position x    50 px    +10 px/f    +50 px since key 5"


def test_looking_only_changes_nothing(editor: CurveEditor, keyed: OpenProject) -> None:
    editor.look_only.trigger()
    before = keyed.bridge.document
    refused: list[None] = []
    keyed.bridge.edit_refused.connect(lambda: refused.append(None))
    drag(editor, point(editor, 15, 100), point(editor, 19, 180))
    QTest.mouseClick(editor.graph.viewport(), LEFT, Qt.KeyboardModifier.ControlModifier, point(editor, 22, 900))
    keyed.bridge.session.undo()
    keyed.bridge.session.redo()
    editor._set_velocity(EASY, EASY)
    editor.swap_snapshot()
    assert keyed.bridge.document is before
    assert len(refused) == 4
    editor.look_only.trigger()
    drag(editor, point(editor, 15, 100), point(editor, 19, 180))
    assert keyed.bridge.document is not before


def test_tools_without_room_are_in_the_menu_and_work_there(editor: CurveEditor, qtbot: QtBot) -> None:
    row = editor.findChild(OverflowRow)
    assert isinstance(row, OverflowRow)
    assert row.left_over == ()
    assert row.more.isHidden()
    row.setMaximumWidth(200)
    qtbot.waitUntil(lambda: len(row.left_over) > 3)
    assert row.more.isVisible()
    menu = row.more.menu()
    assert menu.actions() == list(row.left_over)
    editor.compare.trigger()
    assert editor.compare in menu.actions()
    assert editor.choice.shows_snapshot
    assert row.sizeHint().height() <= row.height()


def test_comparing_with_nothing_says_so(editor: CurveEditor) -> None:
    refused: list[str] = []
    editor.refused.connect(refused.append)
    editor.compare.trigger()
    editor.swap_snapshot()
    editor.ask_velocity()
    assert [sentence.split(":")[0] for sentence in refused] == [
        "There is nothing to compare with yet",
        "There is no snapshot to exchange with yet.",
        "No keys are selected.",
    ]


def test_the_tables_own_keys_are_not_swallowed_by_the_window(
    qtbot: QtBot,
    open_project: OpenProject,
    cels: Path,
    window: MainWindow,
    focus: Callable[[QWidget], None],
    clipboard: OwnClipboard,
) -> None:
    open_project.bring((CharacterSource("Walker", cels),)).at_once()
    session = window.parts.bridge.session
    document = edits.set_canvas(session.document, Canvas(240, 200, length_frames=48))
    for frame, x in ((5, 0.0), (15, 100.0)):
        document = edits.set_key(document, LIGHT, frame, (x, -200.0, 900.0))
    session.edit("Key", document)
    window.docks.layout.show("curves")
    table = window.parts.curves.made().table
    qtbot.waitUntil(lambda: table.rowCount() == 6)
    focus(table)
    QTest.keyClick(table, Qt.Key.Key_A, Qt.KeyboardModifier.ControlModifier)
    QTest.keyClick(table, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    assert clipboard.text().splitlines()[0] == "\t".join(HEADINGS)
    assert len(clipboard.text().splitlines()) == 7


def test_exact_velocities_are_typed(qtbot: QtBot, editor: CurveEditor, keyed: OpenProject) -> None:
    keyed.bridge.session.select_keys(frozenset({KeyRef(DECLINATION, 10)}))
    editor.ask_velocity()
    dialog = editor.findChild(VelocityDialog)
    assert dialog is not None
    for field, value in zip(dialog.fields, (0.0, 25.0, 2.0, 60.0), strict=True):
        field.setValue(value)
    box = dialog.findChild(QDialogButtonBox)
    assert box is not None
    qtbot.mouseClick(box.button(QDialogButtonBox.StandardButton.Ok), LEFT)
    key = track_of(keyed.bridge.document, DECLINATION).key_at(10)
    assert key is not None
    assert (key.ease_in, key.ease_out) == ((Ease(0.0, 0.25),), (Ease(2.0, 0.6),))
    assert keyed.bridge.session.undo_name == "Key velocity"


def test_the_table_shows_and_takes_keys(editor: CurveEditor, keyed: OpenProject) -> None:
    keyed.bridge.session.select_keys(frozenset({KeyRef(DECLINATION, 10)}))
    table = editor.table
    assert table.rowCount() == 2
    item = table.item(0, 2)
    assert item is not None
    item.setText("42.5")
    assert value_of(keyed.bridge.document, DECLINATION, 10) == 42.5
    moved = table.item(0, 0)
    assert moved is not None
    moved.setText("12")
    assert frames(keyed, DECLINATION) == [12, 40]
    refused: list[str] = []
    editor.refused.connect(refused.append)
    wrong = table.item(0, 2)
    assert wrong is not None
    wrong.setText("steep")
    assert refused == ["'steep' is not a number; type 12.5, *2, /3, +10, -=10 or 50%"]
    doubled = table.item(0, 2)
    assert doubled is not None
    doubled.setText("*2")
    assert value_of(keyed.bridge.document, DECLINATION, 12) == 85
    kept = table.item(0, 2)
    assert kept is not None
    assert kept.text() == "85"


def test_keys_go_to_a_spreadsheet_and_back(editor: CurveEditor, keyed: OpenProject, clipboard: OwnClipboard) -> None:
    keyed.bridge.session.select_keys(frozenset({KeyRef(LIGHT, 5)}))
    editor.table.copy()
    text = clipboard.text()
    assert text.splitlines()[0] == "\t".join(HEADINGS)
    assert len(text.splitlines()) == 1 + 3 * 3
    before = keyed.bridge.document
    back = pasted(before, LIGHT, text)
    for frame in range(1, 49):
        assert value_of(back, LIGHT, frame) == value_of(before, LIGHT, frame)
    assert pasted(back, LIGHT, text_of(rows_of(back, LIGHT), back.canvas)) is back
    clipboard.put("12\t1\t7\n12\t2\t8\n12\t3\t900\thold\n")
    editor.table.paste()
    assert value_of(keyed.bridge.document, LIGHT, 12) == (7.0, 8.0, 900.0)
    assert keyed.bridge.session.undo_name == "Paste keys"


@pytest.mark.parametrize(
    "line",
    ["x\t1\t2", "0\t1\t2", "1.5\t1\t2", "1\t0\t2", "1\t1\tnan", "1\t1\t2\tsmooth", "1\t1\t2\thold\tfast", "5\t1\t2"],
)
def test_lines_that_are_no_keys_are_refused(keyed: OpenProject, line: str) -> None:
    with pytest.raises(UsageProblem):
        pasted(keyed.bridge.document, LIGHT, line)


def test_copied_rows_count_as_the_cut_does(keyed: OpenProject) -> None:
    document = edits.set_canvas(keyed.bridge.document, replace(keyed.bridge.document.canvas, first_frame=1001))
    text = text_of(rows_of(document, DECLINATION), document.canvas)
    assert [line.split("\t")[0] for line in text.splitlines()[1:]] == ["1010", "1040"]
    back = pasted(document, DECLINATION, text)
    assert [(row.frame, row.value) for row in rows_of(back, DECLINATION)] == [(10, 30.0), (40, 60.0)]
    with pytest.raises(UsageProblem):
        pasted(document, DECLINATION, "1000\t1\t2\n")


def test_shares_are_read_and_typed_in_per_cent(qtbot: QtBot, filled: OpenProject, clipboard: OwnClipboard) -> None:
    session, opacity = filled.bridge.session, Address(OPACITY, filled.bridge.document.layers[0].id)
    document = edits.set_key(edits.set_key(session.document, opacity, 1, 0.25), opacity, 9, 0.5)
    session.edit("Key", document)
    session.select_keys(frozenset({KeyRef(opacity, 1)}))
    editor = CurveEditor(filled.bridge, clipboard)
    qtbot.addWidget(editor)
    table = editor.table
    assert [cell_text(editor, row, 2) for row in (0, 1)] == ["25 %", "50 %"]
    assert editor.graph.getAxis("left").scale == 100.0
    for typed, value in (("30", 0.3), ("45 %", 0.45), ("*2", 0.9), ("+5", 0.95), ("12.5%", 0.125)):
        type_cell(editor, 0, 2, typed)
        assert value_of(filled.bridge.document, opacity, 1) == value, typed
    type_cell(editor, 0, 6, "3")
    key = track_of(filled.bridge.document, opacity).key_at(1)
    assert key is not None
    assert key.ease_out[0].speed == 0.03
    table.selectAll()
    table.copy()
    assert clipboard.text().splitlines()[1].split("\t")[2] == "0.125", "spreadsheets get the number that is kept"
    assert "50 %" in readout(filled.bridge.document, editor.choice, editor.graph.pictures[0], 9)


def cell_text(editor: CurveEditor, row: int, column: int) -> str:
    item = editor.table.item(row, column)
    assert item is not None
    return item.text()


def type_cell(editor: CurveEditor, row: int, column: int, text: str) -> None:
    item = editor.table.item(row, column)
    assert item is not None
    item.setText(text)


def test_each_cell_changes_its_own_number_alone(keyed: OpenProject) -> None:
    document = keyed.bridge.document
    row = rows_of(document, DECLINATION)[0]
    for column, text, check in (
        (3, "hold", lambda key: key.interpolation is Interpolation.HOLD),
        (4, "2", lambda key: key.ease_in == (Ease(2.0, 1 / 3),)),
        (5, "50%", lambda key: key.ease_in == (Ease(0.0, 0.5),)),
        (6, "-3", lambda key: key.ease_out == (Ease(-3.0, 1 / 3),)),
        (7, "0.01", lambda key: key.ease_out == (Ease(0.0, 0.001),)),
    ):
        changed = with_cell(document, DECLINATION, row, column, text)
        key = track_of(changed, DECLINATION).key_at(10)
        assert check(key), (column, text)
    with pytest.raises(UsageProblem, match="component cannot be changed"):
        with_cell(document, DECLINATION, row, 1, "2")
    assert parse_row(["3", "1", "5"]).interpolation is Interpolation.LINEAR
    assert text_of((), document.canvas).count("\n") == 1


def test_notes_are_pinned_gone_to_changed_and_deleted(qtbot: QtBot, editor: CurveEditor, keyed: OpenProject) -> None:
    session = keyed.bridge.session
    session.select_keys(frozenset({KeyRef(LIGHT, 5)}))
    session.go_to(20)
    editor.notes.ask_new()
    dialog = editor.notes.findChild(QInputDialog)
    assert dialog is not None
    dialog.setTextValue("Slower")
    dialog.accept()
    qtbot.waitUntil(lambda: len(session.document.notes) == 1)
    (note,) = session.document.notes
    assert (note.frame, note.property, note.text) == (20, "light.position", "Slower")
    item = editor.notes.list.item(0)
    assert item.text() == "20   Light position\nSlower"
    session.go_to(1)
    editor.notes.list.itemClicked.emit(item)
    assert keyed.bridge.frame == 20
    editor.notes.change(note, "Much slower")
    assert session.document.notes[0].text == "Much slower"
    editor.notes.list.setCurrentRow(0)
    editor.notes._delete()
    assert session.document.notes == ()
    session.undo()
    assert len(session.document.notes) == 1


def test_flags_find_jumps_and_keys_between_drawings(editor: CurveEditor, keyed: OpenProject) -> None:
    document = keyed.bridge.document
    layer = document.layers[0]
    opacity = Address(OPACITY, layer.id)
    document = edits.set_exposures(document, layer.id, (Exposure(1, 0), Exposure(7, 1)))
    document = edits.set_key(document, LIGHT, 31, (400.0, -200.0, 900.0))
    flags = flags_of(document, (LIGHT, opacity), 60.0)
    assert [(flag.kind, flag.frame) for flag in flags] == [(FlagKind.OFF_EXPOSURES, 8), (FlagKind.JUMP, 31)]
    assert flags[1].amount == pytest.approx(350)
    keyed.bridge.session.edit("Jump", document)
    words = [editor.flags.list.item(row).text() for row in range(editor.flags.list.count())]
    assert words == ["8   Walker · Opacity   key between two drawings", "31   Light position   jumps by 350 px"]
    editor.flags.list.itemClicked.emit(editor.flags.list.item(1))
    assert keyed.bridge.frame == 31
    assert keyed.bridge.session.state.keys == {KeyRef(LIGHT, 31)}
    editor.flags.limit.setValue(400)
    assert editor.flags.list.count() == 1


def test_marks_and_notes_stand_in_the_graph(editor: CurveEditor, keyed: OpenProject) -> None:
    before = editor.graph.grab().toImage()
    document: Document = review.add_note(keyed.bridge.document, LIGHT, 12, "Look")
    keyed.bridge.session.edit("Note", document)
    assert editor.graph.grab().toImage() != before


def test_an_empty_editor_says_how_to_begin(qtbot: QtBot, filled: OpenProject) -> None:
    made = CurveEditor(filled.bridge, OwnClipboard())
    qtbot.addWidget(made)
    made.show()
    assert made._empty.isVisible()
    assert made.graph.pictures == ()
    refused: list[str] = []
    made.refused.connect(refused.append)
    made.notes.ask_new()
    assert "nothing is keyed yet" in refused[0]


def test_the_graph_library_is_loaded_only_when_curves_are_shown(qtbot: QtBot, keyed: OpenProject) -> None:
    filled: list[QMenu] = []
    panel = CurvesPanel(keyed.bridge, OwnClipboard(), filled.append)
    qtbot.addWidget(panel)
    assert filled == []
    panel.show()
    panel.come(False)
    assert filled == []
    panel.come(True)
    assert filled == [panel.made().key_menu]


def test_curves_share_the_selection_with_the_timeline_in_the_window(qtbot: QtBot, walking: MainWindow) -> None:
    session = walking.parts.open_project.bridge.session
    session.edit("Key", edits.set_key(session.document, DECLINATION, 3, 50.0))
    assert walking.parts.curves.findChild(CurveEditor) is None, "the timeline lies before it"
    walking.parts.actions["curves"].trigger()
    qtbot.waitUntil(lambda: walking.parts.curves.editor is not None)
    session.select_keys(frozenset({KeyRef(DECLINATION, 3)}))
    editor = walking.parts.curves.editor
    assert editor is not None
    qtbot.waitUntil(editor.isVisible)
    assert any(mark.is_chosen for picture in editor.graph.pictures for mark in picture.keys)
    walking.parts.actions["velocity"].trigger()
    assert editor.findChild(VelocityDialog) is not None


def _read(editor: CurveEditor, frame: int) -> str:
    editor.graph.controller.read.emit(float(frame), 0.0)
    return editor._read.text()
