"""Drawings on the dope sheet under the hand: held, moved, split, replaced, emptied, stepped, copied."""

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMenu, QWidget
from pytestqt.qtbot import QtBot

from kagezou.document import edits
from kagezou.document.address import Address
from kagezou.document.key_edits import KeyRef
from kagezou.document.model import Canvas, Cels, Drawing, Exposure
from kagezou.document.properties import OPACITY
from kagezou.geometry.box import Box
from kagezou.tools.timeline.drawing_drag import BarPart
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.system.menu_words import plain
from kagezou.ui.timeline.drawing_bars import Bar, bars_of, part_at
from kagezou.ui.timeline.drawing_menu import fill_drawing_menu
from kagezou.ui.timeline.rows import RowKind
from kagezou.ui.timeline.timeline import Timeline
from kagezou.ui.window.main_window import MainWindow
from tests.ui.viewing import OwnClipboard, move

NONE, SHIFT, CONTROL = (
    Qt.KeyboardModifier.NoModifier,
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.ControlModifier,
)
LEFT = Qt.MouseButton.LeftButton
SHEET = "AAAAAABBBBBBCCCCCCDDDDDD"


@pytest.fixture
def sheet(open_project: OpenProject) -> OpenProject:
    """Two layers over 24 frames: Upper with four drawings of six frames each, Lower with one drawing."""
    session = open_project.bridge.session
    drawings = tuple(Drawing(name, Path(f"/nowhere/{name}.png")) for name in "ABCD")
    document = edits.set_canvas(session.document, Canvas(240, 200, length_frames=24))
    document = edits.add_layer(document, "Lower", Cels(drawings[2:], (Exposure(1, 0),)), Box(0, 0, 9, 9))
    exposures = tuple(Exposure(1 + 6 * index, index) for index in range(4))
    document = edits.add_layer(document, "Upper", Cels(drawings, exposures), Box(0, 0, 9, 9))
    session.edit("Sheet", document)
    session.select("layer-2")
    return open_project


@pytest.fixture
def timeline(qtbot: QtBot, sheet: OpenProject) -> Timeline:
    made = Timeline(sheet.bridge, OwnClipboard())
    qtbot.addWidget(made)
    made.resize(1000, 300)
    made.show()
    qtbot.waitExposed(made)
    return made


def seen(open_project: OpenProject, layer_id: str = "layer-2") -> str:
    cels = open_project.bridge.document.layer(layer_id).cels
    found = (cels.drawing_at(frame) for frame in range(1, open_project.bridge.document.canvas.length_frames + 1))
    return "".join("." if drawing is None else drawing.name for drawing in found)


def place(timeline: Timeline, frame: float, layer_id: str = "layer-2") -> QPoint:
    """Return a place on the bars of a layer, at the left edge of a frame's cell."""
    rows = timeline.rows
    index = next(n for n, row in enumerate(rows.rows) if row.kind is RowKind.LAYER and row.layer_id == layer_id)
    return QPoint(round(timeline.scale.x_of(frame)), rows.top_of(index) + 6)


def drag(
    timeline: Timeline,
    frame: float,
    frames_on: float,
    modifiers: Qt.KeyboardModifier = NONE,
    *,
    aside: int = 0,
    let_go: bool = True,
) -> None:
    start = place(timeline, frame) + QPoint(aside, 0)
    end = start + QPoint(round(frames_on * timeline.scale.cell_px), 0)
    QTest.mousePress(timeline.lanes, LEFT, modifiers, start)
    for step in (1, 2, 3, 4):
        move(timeline.lanes, start + (end - start) * step / 4, LEFT, modifiers)
    if let_go:
        QTest.mouseRelease(timeline.lanes, LEFT, modifiers, end)


@pytest.mark.parametrize("aside", [-5, 5])
def test_a_boundary_is_dragged_from_either_side(timeline: Timeline, sheet: OpenProject, aside: int) -> None:
    drag(timeline, 7, 3, aside=aside)
    assert seen(sheet) == "AAAAAAAAABBBCCCCCCDDDDDD"
    assert sheet.bridge.session.undo_name == "Hold drawing"
    drag(timeline, 10, -6, aside=aside)
    assert seen(sheet) == "AAABBBBBBBBBCCCCCCDDDDDD"
    sheet.bridge.session.undo()
    sheet.bridge.session.undo()
    assert seen(sheet) == SHEET


def test_with_shift_what_follows_moves_along(timeline: Timeline, sheet: OpenProject) -> None:
    drag(timeline, 7, 3, SHIFT, aside=-5)
    assert seen(sheet) == "AAAAAAAAABBBBBBCCCCCCDDD"
    drag(timeline, 10, -7, SHIFT, aside=-5)
    assert seen(sheet)[:21] == "AABBBBBBCCCCCCDDDDDDD"


def test_the_cut_grows_when_the_hand_lets_go(timeline: Timeline, sheet: OpenProject) -> None:
    cell_px, lengths = timeline.scale.cell_px, list[int]()
    drag(timeline, 7, 9, SHIFT, aside=-5, let_go=False)
    lengths.append(sheet.bridge.document.canvas.length_frames)
    assert timeline.scale.cell_px == cell_px
    QTest.mouseRelease(timeline.lanes, LEFT, SHIFT)
    lengths.append(sheet.bridge.document.canvas.length_frames)
    assert lengths == [24, 28]
    assert seen(sheet) == "AAAAAAAAAAAAAAABBBBBBCCCCCCD"
    sheet.bridge.session.undo()
    assert seen(sheet) == SHEET


def test_the_hud_says_how_long_and_escape_takes_back(timeline: Timeline, sheet: OpenProject) -> None:
    before = sheet.bridge.document
    drag(timeline, 7, 2, aside=-5, let_go=False)
    assert timeline.lanes.drawings.said == "held 8  (+2)"
    assert seen(sheet) == "AAAAAAAABBBBCCCCCCDDDDDD"
    QTest.keyClick(timeline.lanes, Qt.Key.Key_Escape)
    assert sheet.bridge.document is before
    QTest.mouseRelease(timeline.lanes, LEFT)
    assert sheet.bridge.document is before
    assert timeline.lanes.drawings.said == ""


def test_the_middle_of_a_bar_moves_the_drawing(timeline: Timeline, sheet: OpenProject) -> None:
    drag(timeline, 10, 2)
    assert seen(sheet) == "AAAAAAAABBBBBBCCCCDDDDDD"
    assert sheet.bridge.session.undo_name == "Move drawing"
    assert timeline.lanes.drawings.choice.run == (1, 1)


def test_several_are_chosen_with_shift_and_moved_together(timeline: Timeline, sheet: OpenProject) -> None:
    QTest.mouseClick(timeline.lanes, LEFT, NONE, place(timeline, 9))
    QTest.mouseClick(timeline.lanes, LEFT, SHIFT, place(timeline, 15))
    assert timeline.lanes.drawings.choice.run == (1, 2)
    drag(timeline, 15, 4)
    assert seen(sheet) == "AAAAAAAAAABBBBBBCCCCCCDD"
    QTest.mouseClick(timeline.lanes, LEFT, NONE, place(timeline, 18))
    assert timeline.lanes.drawings.choice.run == (2, 2)
    QTest.keyClick(timeline.lanes, Qt.Key.Key_Escape)
    assert timeline.lanes.drawings.choice.run is None


def test_the_end_of_the_last_bar_leaves_an_empty_cel(timeline: Timeline, sheet: OpenProject) -> None:
    drag(timeline, 25, -2, aside=3)
    assert seen(sheet) == "AAAAAABBBBBBCCCCCCDDDD.."
    drag(timeline, 23, 2, aside=-4)
    assert seen(sheet)[:24] == SHEET


def test_drawings_catch_on_keys_and_control_lets_them_go(timeline: Timeline, sheet: OpenProject) -> None:
    session = sheet.bridge.session
    session.edit("Key", edits.set_key(session.document, Address(OPACITY, "layer-1"), 11, 0.5))
    caught: list[int | None] = []
    drag(timeline, 7, 3.7, aside=-5, let_go=False)
    caught.append(timeline.lanes.drawings.caught_by)
    QTest.mouseRelease(timeline.lanes, LEFT)
    assert seen(sheet) == "AAAAAAAAAABBCCCCCCDDDDDD"
    drag(timeline, 11, 1.6, CONTROL, aside=-5, let_go=False)
    caught.append(timeline.lanes.drawings.caught_by)
    QTest.keyClick(timeline.lanes, Qt.Key.Key_Escape)
    QTest.mouseRelease(timeline.lanes, LEFT)
    assert caught == [11, None]


def test_keys_under_the_bars_are_still_keys(timeline: Timeline, sheet: OpenProject) -> None:
    session, address = sheet.bridge.session, Address(OPACITY, "layer-2")
    session.edit("Key", edits.set_key(session.document, address, 9, 0.5))
    timeline.lanes.drawings.choice.choose("layer-2", 7)
    below = QPoint(round(timeline.scale.middle_of(9)), place(timeline, 9).y() + timeline.rows.row_px - 12)
    QTest.mouseClick(timeline.lanes, LEFT, NONE, below)
    assert session.state.keys == {KeyRef(address, 9)}
    assert timeline.lanes.drawings.choice.run is None, "keys and drawings are never chosen together"
    QTest.mouseClick(timeline.lanes, LEFT, NONE, place(timeline, 9.5))
    assert not session.state.keys
    assert timeline.lanes.drawings.choice.run == (1, 1)


def test_what_of_a_bar_is_under_the_pointer(timeline: Timeline, sheet: OpenProject) -> None:
    bars = [Bar(0, 0, 60, 0, is_last=False), Bar(1, 60, 66, 1, is_last=False), Bar(2, 66, 166, 2, is_last=True)]

    def at(x: float) -> tuple[int, BarPart] | None:
        found = part_at(bars, x)
        return None if found is None else (found[0].index, found[1])

    assert [at(x) for x in (3, 10, 11, 30, 51, 59)] == [
        (0, BarPart.START), (0, BarPart.START), (0, BarPart.MIDDLE), (0, BarPart.MIDDLE), (0, BarPart.END),
        (0, BarPart.END),
    ]  # fmt: skip
    assert [at(x) for x in (61, 63, 65)] == [(1, BarPart.START), (1, BarPart.MIDDLE), (1, BarPart.END)]
    assert (at(-1), at(170), at(180)) == (None, (2, BarPart.END), None)
    seen_bars = bars_of(sheet.bridge.document.layer("layer-2"), timeline.scale, timeline.lanes.width())
    assert [bar.drawing for bar in seen_bars] == [0, 1, 2, 3]
    cursors = [timeline.lanes.drawings.cursor_at(QPointF(place(timeline, frame))) for frame in (7, 10)]
    assert cursors == [Qt.CursorShape.SplitHCursor, Qt.CursorShape.OpenHandCursor]
    words = timeline.lanes.drawings.words_at(QPointF(place(timeline, 10)))
    assert words.startswith("B: frames 7 to 12, held 6\n")


def test_the_commands_on_the_chosen_drawing(timeline: Timeline, sheet: OpenProject) -> None:
    session, drawings = sheet.bridge.session, timeline.drawings
    timeline.lanes.drawings.choice.choose("layer-2", 7)
    steps: list[tuple[Callable[[], object], str, str]] = [
        (lambda: drawings.replace(3), "Replace drawing", "AAAAAADDDDDDCCCCCCDDDDDD"),
        (drawings.empty, "Empty cel", "AAAAAA......CCCCCCDDDDDD"),
        (lambda: drawings.hold_longer(1), "Hold longer", "AAAAAABBBBBBBCCCCCCDDDDD"),
        (lambda: drawings.hold_longer(-1), "Hold shorter", "AAAAAABBBBBCCCCCCDDDDDDD"),
        (drawings.remove, "Remove drawing", "AAAAAAAAAAAACCCCCCDDDDDD"),
    ]
    for do, name, after in steps:
        do()
        assert (session.undo_name, seen(sheet)) == (name, after)
        session.undo()
        assert seen(sheet) == SHEET
    timeline.lanes.drawings.choice.clear()
    session.go_to(9)
    drawings.insert(0)
    assert seen(sheet) == "AAAAAABBAAAACCCCCCDDDDDD"
    session.go_to(11)
    drawings.split()
    drawings.empty()
    assert seen(sheet) == "AAAAAABBAA..CCCCCCDDDDDD"


def test_on_twos_for_the_whole_layer_or_what_is_chosen(timeline: Timeline, sheet: OpenProject) -> None:
    timeline.drawings.expose_on(2)
    assert seen(sheet)[:9] == "AABBCCDDD"
    assert sheet.bridge.session.undo_name == "Expose on 2s"
    sheet.bridge.session.undo()
    timeline.lanes.drawings.choice.choose("layer-2", 7, 13)
    timeline.drawings.expose_on(3)
    assert seen(sheet) == "AAAAAABBBCCCDDDDDDDDDDDD"
    assert timeline.lanes.drawings.choice.run == (1, 2)
    sheet.bridge.session.undo()
    timeline.lanes.drawings.choice.clear()
    timeline.drawings.expose_on(8)
    assert sheet.bridge.document.canvas.length_frames == 32
    assert seen(sheet).endswith("DDDDDDDD")


def test_drawings_are_pasted_at_the_playhead_on_another_layer(timeline: Timeline, sheet: OpenProject) -> None:
    session, drawings, said = sheet.bridge.session, timeline.drawings, list[str]()
    drawings.refused.connect(said.append)
    drawings.paste()
    assert len(said) == 1
    timeline.lanes.drawings.choice.choose("layer-2", 7, 13)
    drawings.copy()
    session.select("layer-1")
    session.go_to(3)
    drawings.paste()
    assert seen(sheet, "layer-1") == "CC......CCCCCCCCCCCCCCCC"
    assert "stay empty: B" in said[-1]
    session.undo()
    assert seen(sheet, "layer-1") == "C" * 24


def test_the_menu_lists_the_drawings(timeline: Timeline, sheet: OpenProject) -> None:
    menu = QMenu(timeline)
    timeline.lanes.drawings.choice.choose("layer-2", 13)
    fill_drawing_menu(timeline, lambda inner: inner.setTitle("Filled"), menu)
    inner = menu.actions()[0].menu()
    assert isinstance(inner, QMenu)
    assert [action.text() for action in inner.actions()] == ["A", "B", "C", "D"]
    inner.actions()[1].trigger()
    assert seen(sheet) == "AAAAAABBBBBBBBBBBBDDDDDD"
    assert menu.title() == "Filled"


def test_the_window_answers_copy_paste_and_delete_for_drawings(
    walking: MainWindow, focus: Callable[[QWidget], None]
) -> None:
    timeline, session, actions = (
        walking.parts.time.timeline,
        walking.parts.open_project.bridge.session,
        walking.parts.actions,
    )
    layer = session.document.layers[0]
    focus(timeline.lanes)
    timeline.lanes.drawings.choice.choose(layer.id, 2)
    actions["copy_keys"].trigger()
    session.go_to(5)
    actions["paste_keys"].trigger()
    shown = [each.drawing for each in session.document.layer(layer.id).cels.exposures]
    assert shown == [0, 1, 2, 3, 1, 5]
    actions["delete"].trigger()
    assert session.document.layer(layer.id).cels.exposures[4].drawing is None
    menu = QMenu()
    walking.parts.menus.fill_drawings(menu)
    assert "Expose on Twos" in [plain(action.text()) for action in menu.actions()]
    session.edit("Key", edits.set_key(session.document, Address(OPACITY, layer.id), 3, 0.5))
    session.select_keys(frozenset({KeyRef(Address(OPACITY, layer.id), 3)}))
    actions["copy_keys"].trigger()
    assert not timeline.drawings.has_copy
