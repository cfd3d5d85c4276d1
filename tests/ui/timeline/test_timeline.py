"""The dope sheet under the hand: choosing, moving, stretching, copying, marking and playing."""

from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import pytest
from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QInputDialog, QLineEdit, QWidget
from pytestqt.qtbot import QtBot

from kagezou.animation.timecode import Count
from kagezou.animation.track import Interpolation
from kagezou.document import edits, review
from kagezou.document.address import Address, track_of
from kagezou.document.ease_edits import set_interpolation
from kagezou.document.key_edits import KeyRef, Refs
from kagezou.document.model import Canvas, Document, Marker
from kagezou.document.properties import GROUND_DECLINATION, LIGHT_POSITION, OPACITY
from kagezou.document.set_pieces import add_piece, remove_piece
from kagezou.document.set_properties import PIECE_ANGLE
from kagezou.geometry.box import Box
from kagezou.importing.staging import CharacterSource
from kagezou.io.images.cel_cache import CelCache
from kagezou.tools.timeline.snapping import snap_frames, snapped
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.time.key_commands import KeyCommands
from kagezou.ui.time.playback import Player, bounced
from kagezou.ui.timeline.revealing import ANIMATED, CHANGED, REVEALED, added, animated_or_changed, toggled
from kagezou.ui.timeline.row_names import Spot
from kagezou.ui.timeline.rows import Reveal, RowKind
from kagezou.ui.timeline.timeline import Timeline
from kagezou.ui.window.main_window import MainWindow
from tests.ui.viewing import OwnClipboard, move

LIGHT, DECLINATION = Address(LIGHT_POSITION), Address(GROUND_DECLINATION)
NO_KEYS: Refs = frozenset()


@pytest.fixture
def keyed(open_project: OpenProject, cels: Path) -> OpenProject:
    """A cut of 48 frames: the lamp keyed on 5, 10 and 20, the declination on 10, the opacity on 8."""
    open_project.bring((CharacterSource("Walker", cels),)).at_once()
    session = open_project.bridge.session
    document = edits.set_canvas(session.document, Canvas(240, 200, length_frames=48))
    for frame in (5, 10, 20):
        document = edits.set_key(document, LIGHT, frame, (float(frame), 0.0, 900.0))
    document = edits.set_key(document, DECLINATION, 10, 50.0)
    document = edits.set_key(document, Address(OPACITY, document.layers[0].id), 8, 0.5)
    session.edit("Key", document)
    return open_project


@pytest.fixture
def timeline(qtbot: QtBot, keyed: OpenProject) -> Timeline:
    made = Timeline(keyed.bridge, OwnClipboard(), keyed.cels.kept_sources)
    qtbot.addWidget(made)
    made.resize(1000, 300)
    made.show()
    qtbot.waitExposed(made)
    return made


class Paints(QObject):
    """How often widgets are painted."""

    def __init__(self, *widgets: QWidget) -> None:
        super().__init__()
        self.counts = dict.fromkeys(widgets, 0)
        for widget in widgets:
            widget.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() is QEvent.Type.Paint and isinstance(watched, QWidget):
            self.counts[watched] += 1
        return False

    def settle(self) -> None:
        """Let all that is to be painted be painted, and count from there."""
        before: dict[QWidget, int] | None = None
        while before != self.counts:
            before = dict(self.counts)
            QApplication.sendPostedEvents()
            QApplication.processEvents()
        self.counts = dict.fromkeys(self.counts, 0)


def test_a_drag_of_a_keyed_value_paints_the_names_alone(qtbot: QtBot, timeline: Timeline, keyed: OpenProject) -> None:
    ruler, lanes, names = timeline.ruler, timeline.lanes, timeline.names
    paints = Paints(ruler, lanes, names)
    document = keyed.bridge.document

    def are_names_painted_alone(x: float) -> bool:
        nonlocal document
        paints.settle()
        document = edits.set_key(document, LIGHT, 10, (x, 0.0, 900.0))
        keyed.bridge.session.edit("Move the lamp", document)
        qtbot.waitUntil(lambda: paints.counts[names] > 0)
        return (paints.counts[ruler], paints.counts[lanes]) == (0, 0)

    # A window that has just come may be asked for all of itself once more, however long it was waited for; only once.
    assert sum(are_names_painted_alone(12.0 + turn) for turn in range(4)) >= 3

    def is_painted_after(widget: QWidget, changed: Document) -> bool:
        before = paints.counts[widget]
        keyed.bridge.session.edit("Change", changed)
        qtbot.waitUntil(lambda: paints.counts[widget] > before)
        return True

    assert is_painted_after(lanes, edits.set_key(document, LIGHT, 12, (12.0, 0.0, 900.0)))
    assert is_painted_after(lanes, set_interpolation(document, frozenset({KeyRef(LIGHT, 10)}), Interpolation.HOLD))
    assert is_painted_after(ruler, review.set_work_area(document, 3, 9))


def frames(open_project: OpenProject, address: Address) -> list[int]:
    return [key.frame for key in track_of(open_project.bridge.document, address).keys]


def row_y(timeline: Timeline, address: Address) -> int:
    for index, row in enumerate(timeline.rows.rows):
        if row.kind is RowKind.PROPERTY and row.addresses == (address,):
            return timeline.rows.top_of(index) + timeline.rows.row_px // 2
    raise AssertionError(f"{address.property.name} has no row")


def key_point(timeline: Timeline, address: Address, frame: int) -> QPoint:
    return QPoint(round(timeline.scale.middle_of(frame)), row_y(timeline, address))


def drag(
    timeline: Timeline,
    start: QPoint,
    frames_on: float,
    modifiers: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier,
    *,
    let_go: bool = True,
) -> None:
    lanes, button = timeline.lanes, Qt.MouseButton.LeftButton
    end = start + QPoint(round(frames_on * timeline.scale.cell_px), 0)
    QTest.mousePress(lanes, button, modifiers, start)
    for step in (1, 2, 3, 4):
        move(lanes, start + (end - start) * step / 4, button, modifiers)
    if let_go:
        QTest.mouseRelease(lanes, button, modifiers, end)


def test_a_row_for_the_scene_the_layers_and_what_is_keyed(timeline: Timeline, keyed: OpenProject) -> None:
    names = [timeline.names.name_of(row) for row in timeline.rows.rows]
    assert names == ["Scene", "Declination", "Light position", keyed.bridge.document.layers[0].name, "Opacity"]
    timeline.rows.fold(timeline.rows.rows[0])
    assert [row.kind for row in timeline.rows.rows] == [RowKind.SCENE, RowKind.LAYER, RowKind.PROPERTY]
    timeline.rows.fold_all(timeline.rows.rows[1])
    assert len(timeline.rows.rows) == 2


def test_set_pieces_have_rows_of_their_own(timeline: Timeline, keyed: OpenProject) -> None:
    document = add_piece(keyed.bridge.document, "back", "wall")
    address = Address(PIECE_ANGLE, piece_id=document.pieces[0].id)
    keyed.bridge.session.edit("Wall", edits.set_key(document, address, 4, 20.0))
    names = [timeline.names.name_of(row) for row in timeline.rows.rows]
    assert names[names.index("back") + 1] == "Turn"
    QTest.mouseClick(timeline.lanes, Qt.MouseButton.LeftButton, pos=key_point(timeline, address, 4))
    assert keyed.bridge.session.state.keys == {KeyRef(address, 4)}
    keyed.bridge.session.edit("Away", remove_piece(keyed.bridge.document, address.piece_id or ""))
    assert keyed.bridge.session.state.keys == frozenset()


def test_a_click_chooses_a_key_and_shift_adds_or_takes_one(timeline: Timeline, keyed: OpenProject) -> None:
    session, button = keyed.bridge.session, Qt.MouseButton.LeftButton
    QTest.mouseClick(timeline.lanes, button, pos=key_point(timeline, LIGHT, 10) + QPoint(5, 4))
    assert session.state.keys == {KeyRef(LIGHT, 10)}
    shift = Qt.KeyboardModifier.ShiftModifier
    QTest.mouseClick(timeline.lanes, button, shift, key_point(timeline, LIGHT, 20))
    assert session.state.keys == {KeyRef(LIGHT, 10), KeyRef(LIGHT, 20)}
    QTest.mouseClick(timeline.lanes, button, shift, key_point(timeline, LIGHT, 10))
    assert session.state.keys == {KeyRef(LIGHT, 20)}
    QTest.mouseClick(timeline.lanes, button, pos=key_point(timeline, LIGHT, 30))
    assert session.state.keys == NO_KEYS


def test_alt_click_chooses_the_whole_column(timeline: Timeline, keyed: OpenProject) -> None:
    alt = Qt.KeyboardModifier.AltModifier
    QTest.mouseClick(timeline.lanes, Qt.MouseButton.LeftButton, alt, key_point(timeline, LIGHT, 10))
    assert keyed.bridge.session.state.keys == {KeyRef(LIGHT, 10), KeyRef(DECLINATION, 10)}


def test_a_box_chooses_what_lies_in_it(timeline: Timeline, keyed: OpenProject) -> None:
    start = QPoint(round(timeline.scale.x_of(7)), row_y(timeline, DECLINATION) - 8)
    lanes, button = timeline.lanes, Qt.MouseButton.LeftButton
    QTest.mousePress(lanes, button, pos=start)
    end = QPoint(round(timeline.scale.x_of(22)), row_y(timeline, LIGHT))
    move(timeline.lanes, end, Qt.MouseButton.LeftButton)
    assert lanes.controller.box is not None
    QTest.mouseRelease(lanes, button, pos=end)
    assert keyed.bridge.session.state.keys == {KeyRef(DECLINATION, 10), KeyRef(LIGHT, 10), KeyRef(LIGHT, 20)}


def test_a_summary_key_stands_for_all_below_it(timeline: Timeline, keyed: OpenProject) -> None:
    place = QPoint(round(timeline.scale.middle_of(10)), timeline.rows.row_px // 2)
    QTest.mouseClick(timeline.lanes, Qt.MouseButton.LeftButton, pos=place)
    assert keyed.bridge.session.state.keys == {KeyRef(LIGHT, 10), KeyRef(DECLINATION, 10)}


def test_a_drag_moves_keys_in_one_step_and_they_stay_chosen(timeline: Timeline, keyed: OpenProject) -> None:
    drag(timeline, key_point(timeline, LIGHT, 10), 4)
    assert frames(keyed, LIGHT) == [5, 14, 20]
    assert keyed.bridge.session.state.keys == {KeyRef(LIGHT, 14)}
    assert keyed.bridge.session.undo_name == "Move keys"
    keyed.bridge.session.undo()
    assert frames(keyed, LIGHT) == [5, 10, 20]


def test_escape_takes_a_drag_back(timeline: Timeline, keyed: OpenProject) -> None:
    drag(timeline, key_point(timeline, LIGHT, 10), 4, let_go=False)
    assert frames(keyed, LIGHT) == [5, 14, 20]
    QTest.keyClick(timeline.lanes, Qt.Key.Key_Escape)
    assert frames(keyed, LIGHT) == [5, 10, 20]
    assert keyed.bridge.session.undo_name == "Key"
    QTest.mouseRelease(timeline.lanes, Qt.MouseButton.LeftButton, pos=key_point(timeline, LIGHT, 14))


def test_alt_drag_of_an_end_stretches_about_the_other(timeline: Timeline, keyed: OpenProject) -> None:
    keyed.bridge.session.select_keys(frozenset(KeyRef(LIGHT, frame) for frame in (5, 10, 20)))
    drag(timeline, key_point(timeline, LIGHT, 20), 15, Qt.KeyboardModifier.AltModifier)
    assert frames(keyed, LIGHT) == [5, 15, 35]
    assert keyed.bridge.session.undo_name == "Stretch keys"


def test_dragged_keys_catch_on_others_and_ctrl_lets_them_pass(timeline: Timeline, keyed: OpenProject) -> None:
    timeline.scale.fit()
    catching = snap_frames(keyed.bridge.document, 30, frozenset({KeyRef(LIGHT, 20)}))
    assert set(catching) >= {1, 5, 8, 10, 30, 48}
    assert 20 not in catching
    assert snapped(9.7, catching, 4.0) == (10, 10)
    assert snapped(12.6, catching, 4.0) == (13, None)
    assert snapped(9.4, (), 4.0) == (9, None)


def test_the_line_of_what_caught_is_shown(timeline: Timeline, keyed: OpenProject) -> None:
    keyed.bridge.session.go_to(30)
    drag(timeline, key_point(timeline, LIGHT, 20), -12, let_go=False)
    assert timeline.lanes.controller.caught_by == 8
    assert timeline.lanes.controller.said == "8  (-12)   0+08"
    image = timeline.lanes.grab().toImage()
    middle = round(timeline.scale.middle_of(8))
    colors = [image.pixelColor(x, image.height() - 4) for x in range(middle - 2, middle + 3)]
    assert any(color.red() > 150 and color.blue() < 90 for color in colors), "an orange line"
    timeline.lanes.controller.cancel()


def test_keys_are_copied_from_window_to_window(keyed: OpenProject, cels: Path, clipboard: OwnClipboard) -> None:
    session = keyed.bridge.session
    opacity = Address(OPACITY, session.document.layers[0].id)
    session.select_keys(frozenset({KeyRef(LIGHT, 10), KeyRef(LIGHT, 20), KeyRef(opacity, 8)}))
    KeyCommands(keyed.bridge, clipboard).copy()
    other = OpenProject()
    commands, refused = KeyCommands(other.bridge, clipboard), list[str]()
    commands.refused.connect(refused.append)
    other.bring((CharacterSource("Stranger", cels),)).at_once()
    other.bridge.session.go_to(3)
    commands.paste()
    document = other.bridge.document
    assert [key.frame for key in track_of(document, LIGHT).keys] == [5, 15]
    assert track_of(document, LIGHT).keys[0].value == track_of(keyed.bridge.document, LIGHT).keys[1].value
    assert [key.frame for key in track_of(document, Address(OPACITY, document.layers[0].id)).keys] == [3]
    assert other.bridge.session.undo_name == "Paste keys"
    assert refused == []
    second = edits.add_layer(session.document, "Second", session.document.layers[0].cels, Box(0, 0, 9, 9))
    second = edits.set_key(second, Address(OPACITY, second.layers[1].id), 4, 0.5)
    session.edit("Second", second)
    session.select_keys(frozenset({KeyRef(opacity, 8), KeyRef(Address(OPACITY, second.layers[1].id), 4)}))
    KeyCommands(keyed.bridge, clipboard).copy()
    before = other.bridge.document
    commands.paste()
    assert other.bridge.document is before
    assert refused == ["The copied keys belong to layers that are not in this project."]


def test_copied_keys_that_cannot_be_read_are_told_from_none(keyed: OpenProject, clipboard: OwnClipboard) -> None:
    commands = KeyCommands(keyed.bridge, clipboard)
    refused: list[str] = []
    commands.refused.connect(refused.append)
    clipboard.put('{"kagezou-keys": {"light.position": [' + " " * (1 << 24))
    before = keyed.bridge.document
    commands.paste()
    assert keyed.bridge.document is before
    assert refused == ["Nothing in this project takes the copied keys, or they are more than a project holds."]


def test_keys_are_copied_to_the_playhead_and_back_to_their_time(keyed: OpenProject, clipboard: OwnClipboard) -> None:
    commands, session = KeyCommands(keyed.bridge, clipboard), keyed.bridge.session
    refused: list[str] = []
    commands.refused.connect(refused.append)
    commands.paste()
    commands.copy()
    assert refused == ["No keys were copied yet.", "No keys are selected."]
    session.select_keys(frozenset({KeyRef(LIGHT, 10), KeyRef(LIGHT, 20)}))
    commands.cut()
    assert frames(keyed, LIGHT) == [5]
    session.go_to(30)
    commands.paste()
    assert frames(keyed, LIGHT) == [5, 30, 40]
    assert session.state.keys == {KeyRef(LIGHT, 30), KeyRef(LIGHT, 40)}
    commands.paste_in_place()
    assert frames(keyed, LIGHT) == [5, 10, 20, 30, 40]
    commands.nudge(1)
    assert frames(keyed, LIGHT) == [5, 11, 21, 30, 40]
    assert commands.delete()
    assert frames(keyed, LIGHT) == [5, 30, 40]
    assert not commands.delete()


def test_easing_holding_and_setting_keys(keyed: OpenProject) -> None:
    commands, session = KeyCommands(keyed.bridge, OwnClipboard()), keyed.bridge.session
    commands.select_all()
    assert len(session.state.keys) == 5
    session.select_keys(frozenset({KeyRef(LIGHT, 10)}))
    commands.ease(into=True, out=True)
    assert [key.interpolation for key in track_of(session.document, LIGHT).keys][:2] == [Interpolation.BEZIER] * 2
    commands.hold()
    assert track_of(session.document, LIGHT).keys[1].interpolation is Interpolation.HOLD
    commands.hold()
    assert track_of(session.document, LIGHT).keys[1].interpolation is Interpolation.LINEAR
    session.go_to(15)
    commands.set_here()
    assert frames(keyed, LIGHT) == [5, 10, 15, 20]
    assert frames(keyed, DECLINATION) == [10], "only the chosen key's property"
    session.select_keys(NO_KEYS)
    session.go_to(16)
    commands.set_here()
    assert frames(keyed, DECLINATION) == [10, 16], "all that are keyed"


@pytest.mark.parametrize(
    ("spot", "at", "check"),
    [
        (Spot.NEXT, 6, lambda open_project: open_project.bridge.frame == 10),
        (Spot.PREVIOUS, 16, lambda open_project: open_project.bridge.frame == 10),
        (Spot.KEY, 7, lambda open_project: frames(open_project, LIGHT) == [5, 7, 10, 20]),
        (Spot.KEY, 10, lambda open_project: frames(open_project, LIGHT) == [5, 20]),
        (Spot.NAME, 1, lambda open_project: len(open_project.bridge.session.state.keys) == 3),
    ],
)
def test_the_navigator_of_a_row(
    timeline: Timeline, keyed: OpenProject, spot: Spot, at: int, check: Callable[[OpenProject], bool]
) -> None:
    keyed.bridge.session.go_to(at)
    names, y = timeline.names, row_y(timeline, LIGHT)
    places = (QPointF(x, y) for x in range(names.width() - 1, 30, -2))
    place = next(each for each in places if (found := names.spot_at(each)) and found[1] is spot)
    QTest.mouseClick(names, Qt.MouseButton.LeftButton, pos=place.toPoint())
    assert check(keyed)


def test_the_work_area_is_set_dragged_played_and_cleared(timeline: Timeline, keyed: OpenProject) -> None:
    commands, session = KeyCommands(keyed.bridge, OwnClipboard()), keyed.bridge.session
    session.go_to(10)
    commands.begin_work_area()
    session.go_to(13)
    commands.end_work_area()
    assert session.document.played == (10, 13)
    ruler, scale = timeline.ruler, timeline.scale
    place = QPoint(round(scale.x_of(14)), ruler.height() - 3)
    assert ruler.end_at(place.toPointF()) == "last"
    player = Player(keyed.bridge, clock=lambda: now[0])
    now = [0.0]
    seen: list[int] = []
    session.go_to(40)
    keyed.bridge.frame_changed.connect(seen.append)
    keyed.bridge.frame_changed.connect(player.picture_shown)
    player.start()
    for _ in range(6):
        now[0] += 1 / 24
        player._tick()
    player.stop()
    assert seen == [10, 11, 12, 13, 10, 11, 12]
    QTest.mouseDClick(ruler, Qt.MouseButton.LeftButton, pos=place)
    assert session.document.work_area is None


def test_playing_there_and_back_shows_the_ends_once() -> None:
    seen, frame, way = [], 1, 1
    for _ in range(8):
        frame, way = bounced(frame, way, 1, (1, 4))
        seen.append(frame)
    assert seen == [2, 3, 4, 3, 2, 1, 2, 3]
    assert bounced(3, 1, 2, (1, 4)) == (3, -1)


def test_markers_are_added_named_and_dragged(qtbot: QtBot, timeline: Timeline, keyed: OpenProject) -> None:
    session = keyed.bridge.session
    session.go_to(12)
    timeline.add_marker()
    assert session.document.markers == (Marker(12),)
    timeline.add_marker()
    asked = timeline.findChild(QInputDialog)
    field = asked.findChild(QLineEdit) if asked is not None else None
    assert asked is not None
    assert field is not None
    field.setText("turn")
    asked.accept()
    qtbot.waitUntil(lambda: session.document.markers == (Marker(12, "turn"),))
    timeline.ruler.repaint()
    start = QPoint(round(timeline.scale.middle_of(12)) + 3, 6)
    assert timeline.ruler.marker_at(start.toPointF()) == Marker(12, "turn")
    ruler, button = timeline.ruler, Qt.MouseButton.LeftButton
    QTest.mousePress(ruler, button, pos=start)
    ruler._drag(12, 15)
    QTest.mouseRelease(ruler, button, pos=start)
    assert session.document.markers == (Marker(15, "turn"),)
    assert session.undo_name == "Move marker"


def test_letters_reveal_properties_and_a_second_press_goes_back() -> None:
    light = toggled(ANIMATED, "reveal_light")
    assert light == Reveal(REVEALED["reveal_light"])
    assert toggled(light, "reveal_light") == ANIMATED
    assert animated_or_changed(ANIMATED) == CHANGED
    assert animated_or_changed(light) == ANIMATED
    assert all(REVEALED.values()), "every letter shows something"


def test_with_shift_a_letter_adds_what_it_reveals(walking: MainWindow, focus: Callable[[QWidget], None]) -> None:
    both = added(toggled(ANIMATED, "reveal_light"), "reveal_tilt")
    assert both == Reveal(REVEALED["reveal_light"] | REVEALED["reveal_tilt"])
    assert added(ANIMATED, "reveal_tilt") == Reveal(REVEALED["reveal_tilt"])
    focus(walking.parts.time.timeline.lanes)
    QTest.keyClick(walking.parts.time.timeline.lanes, Qt.Key.Key_P)
    QTest.keyClick(walking.parts.time.timeline.lanes, Qt.Key.Key_R, Qt.KeyboardModifier.ShiftModifier)
    assert walking.parts.time.timeline.rows.reveal == both
    QTest.keyClick(walking.parts.time.timeline.lanes, Qt.Key.Key_R)
    assert walking.parts.time.timeline.rows.reveal == Reveal(REVEALED["reveal_tilt"])


def test_revealed_properties_have_rows_whether_keyed_or_not(timeline: Timeline, keyed: OpenProject) -> None:
    timeline.rows.show_only(toggled(ANIMATED, "reveal_contacts"))
    assert "Grounding points" in [timeline.names.name_of(row) for row in timeline.rows.rows]
    timeline.rows.show_only(CHANGED)
    document = edits.set_constant(keyed.bridge.document, Address(OPACITY, keyed.bridge.layer_id), 0.3)
    keyed.bridge.session.edit("Change", document)
    assert "Opacity" in [timeline.names.name_of(row) for row in timeline.rows.rows]


def test_zooming_keeps_what_is_under_the_pointer(timeline: Timeline) -> None:
    scale = timeline.scale
    place = scale.position_at(300)
    scale.zoom(4, 300)
    assert scale.position_at(300) == pytest.approx(place)
    assert scale.furthest_px > 0
    scale.scroll_to(1e9)
    assert scale.frame_at(scale.width_px) == 48
    scale.reveal(1)
    assert scale.x_of(1) >= 0
    scale.zoom(1e-9, 300)
    assert scale.furthest_px == 0, "never smaller than the whole cut"


def test_the_ruler_counts_as_it_is_told(timeline: Timeline) -> None:
    pictures = []
    for count in (Count.FRAMES, Count.SECONDS, Count.TIMECODE, Count.SHEET_3):
        timeline.ruler.show_count(count)
        pictures.append(timeline.ruler.grab().toImage())
    assert all(one != other for one, other in pairwise(pictures))


def test_frames_that_are_decoded_are_marked_ready(timeline: Timeline, keyed: OpenProject) -> None:
    def green(frame: int) -> bool:
        # Nobody tells what is decoded; the window looks now and then.
        timeline.ruler.refresh()
        image = timeline.ruler.grab().toImage()
        y = image.height() - 9
        color = image.pixelColor(round(timeline.scale.middle_of(frame)) + 6, y)
        return color.green() > color.red() + 40

    cache: CelCache = keyed.cels
    assert not green(3)
    cache.cel(keyed.bridge.document.layers[0].cels.drawings[2].path)
    assert green(3)
    assert not green(2)


def test_arrows_step_while_the_lanes_have_the_keyboard(timeline: Timeline, keyed: OpenProject) -> None:
    timeline.lanes.setFocus()
    keyed.bridge.session.go_to(5)
    QTest.keyClick(timeline.lanes, Qt.Key.Key_Right)
    QTest.keyClick(timeline.lanes, Qt.Key.Key_Right)
    QTest.keyClick(timeline.lanes, Qt.Key.Key_Left)
    assert keyed.bridge.frame == 6


def test_an_empty_sheet_says_how_to_begin(qtbot: QtBot, open_project: OpenProject, cels: Path) -> None:
    open_project.bring((CharacterSource("Walker", cels),)).at_once()
    made = Timeline(open_project.bridge, OwnClipboard())
    qtbot.addWidget(made)
    made.resize(1000, 300)
    made.show()
    assert made._empty.isVisible()
    open_project.bridge.session.edit("Key", edits.set_key(open_project.bridge.document, DECLINATION, 1, 50.0))
    assert not made._empty.isVisible()


def test_what_is_outside_the_work_area_is_dimmed(timeline: Timeline, keyed: OpenProject) -> None:
    before = timeline.lanes.grab().toImage()
    keyed.bridge.session.edit("Area", review.set_work_area(keyed.bridge.document, 20, 30))
    after = timeline.lanes.grab().toImage()
    # Between two grid lines, below the last row.
    x, inside = round(timeline.scale.x_of(4)) + 6, round(timeline.scale.x_of(25)) + 6
    y = after.height() - 5
    assert after.pixelColor(x, y).lightness() < before.pixelColor(x, y).lightness()
    assert after.pixelColor(inside, y) == before.pixelColor(inside, y)
