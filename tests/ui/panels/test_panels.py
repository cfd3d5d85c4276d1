"""The panels over a session, without the picture: layers, inspector, frame strip."""

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu
from pytestqt.qtbot import QtBot

from kagezou.document import properties
from kagezou.document.address import Address, track_of, value_of
from kagezou.document.common_edits import set_all
from kagezou.document.figure_properties import HOLD
from kagezou.document.invariants import check
from kagezou.document.properties import TABLE
from kagezou.document.property import Scope
from kagezou.importing.staging import CharacterSource
from kagezou.picture_source import Paper
from kagezou.ui.panels.groups import Group, is_rare
from kagezou.ui.panels.inspector import Inspector
from kagezou.ui.panels.layer_list import LayerList
from kagezou.ui.panels.layer_model import Role
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.time.playback import Player
from kagezou.ui.time.transport import FrameField, Transport
from kagezou.ui.timeline.ruler import Ruler
from kagezou.ui.timeline.time_scale import TimeScale
from kagezou.ui.widgets.key_button import KeyState
from kagezou.ui.widgets.scrub_field import AxisField, ScrubField
from tests.ui.viewing import move

# The platform plugin without a screen says this of every view with a size hint.
pytestmark = pytest.mark.qt_log_ignore("This plugin does not support propagateSizeHints")

DECLINATION = Address(properties.GROUND_DECLINATION)


def field_of(inspector: Inspector, name: str, index: int = 0) -> ScrubField:
    fields = inspector.row(name).editor.findChildren(ScrubField)
    return fields[index]


def test_the_inspector_has_a_row_for_every_property(inspector: Inspector) -> None:
    assert {each.address.property for each in inspector.edited} == {
        prop for prop in TABLE if prop.scope is not Scope.PIECE
    }


def test_a_row_is_made_when_it_is_first_to_be_seen(inspector: Inspector, filled: OpenProject) -> None:
    reflection, shape = inspector.sections[Group.REFLECTION], inspector.sections[Group.SHAPE]
    assert reflection.rows == []
    reflection.open(opened=True)
    assert [row.edited for row in reflection.rows] == reflection.edited
    assert all(row.editor.isVisibleTo(inspector) for row in reflection.rows)

    grow = Address(properties.GROW, filled.bridge.layer_id)
    hold = Address(HOLD, filled.bridge.layer_id)
    made = [row.address for row in shape.rows]
    assert grow in made
    assert hold not in made
    # What is not the default is seen without being asked for.
    filled.bridge.session.edit("Hold", set_all(filled.bridge.document, (hold,), 0.5, 1))
    assert {row.address for row in shape.rows if row.editor.isVisibleTo(inspector)} == {*made, hold}


def test_the_tab_key_goes_from_row_to_row_whenever_they_were_made(inspector: Inspector) -> None:
    light = inspector.sections[Group.LIGHT]
    light.show_more(shown=True)
    inspector.row("light.azimuth")
    order, widget = [], light.header.nextInFocusChain()
    while widget is not None and widget is not light.more:
        order += [row for row in light.rows if widget is row.key]
        widget = widget.nextInFocusChain()
    assert order == sorted(light.rows, key=lambda row: is_rare(row.address.property))


def test_typing_sets_a_value_as_one_step(qtbot: QtBot, inspector: Inspector, filled: OpenProject) -> None:
    field = field_of(inspector, "ground.declination")
    qtbot.mouseClick(field, Qt.MouseButton.LeftButton)
    qtbot.keyClicks(field, "/2")
    qtbot.keyClick(field, Qt.Key.Key_Return)
    assert value_of(filled.bridge.document, DECLINATION, 1) == 30.0
    assert field.text() == "30°"
    assert filled.bridge.session.undo_name == "Change Declination"
    filled.bridge.session.undo()
    assert field.text() == "60°"


def test_nonsense_and_escape_leave_the_value(qtbot: QtBot, inspector: Inspector, filled: OpenProject) -> None:
    field = field_of(inspector, "ground.declination")
    before = filled.bridge.document
    for typed, key in (("abc", Qt.Key.Key_Return), ("12", Qt.Key.Key_Escape)):
        qtbot.mouseClick(field, Qt.MouseButton.LeftButton)
        qtbot.keyClicks(field, typed)
        qtbot.keyClick(field, key)
        assert field.text() == "60°"
    assert filled.bridge.document is before


def test_a_typed_value_is_kept_to_the_range(qtbot: QtBot, inspector: Inspector) -> None:
    field = field_of(inspector, "shadow.opacity")
    qtbot.mouseClick(field, Qt.MouseButton.LeftButton)
    qtbot.keyClicks(field, "700")
    qtbot.keyClick(field, Qt.Key.Key_Return)
    assert (field.value, field.text()) == (100.0, "100%")


def test_shares_are_read_and_typed_as_per_cent_and_kept_as_shares(
    qtbot: QtBot, inspector: Inspector, filled: OpenProject
) -> None:
    field, opacity = field_of(inspector, "shadow.opacity"), Address(properties.OPACITY, "layer-1")
    assert field.text() == "60%"
    for typed, share in (("7", 0.07), ("*2", 0.14), ("45.5", 0.455)):
        qtbot.mouseClick(field, Qt.MouseButton.LeftButton)
        qtbot.keyClicks(field, typed)
        qtbot.keyClick(field, Qt.Key.Key_Return)
        assert value_of(filled.bridge.document, opacity, 1) == pytest.approx(share)
    assert field.text() == "45.5%"
    assert field_of(inspector, "shadow.wave1.velocity").text() == "3 px/frame"


def test_places_bear_the_letters_of_their_axes(inspector: Inspector) -> None:
    bare, lettered = ScrubField(), AxisField(1.0, 2, "X")
    for field in (bare, lettered):
        field.resize(90, 26)
    assert bare.grab().toImage() != lettered.grab().toImage()
    assert [each.accessibleName()[-1] for each in inspector.row("light.position").editor.findChildren(ScrubField)] == [
        *"xyz"
    ]


def test_a_drag_on_a_number_is_one_step_and_escape_takes_it_back(
    qtbot: QtBot, inspector: Inspector, filled: OpenProject
) -> None:
    field = field_of(inspector, "light.position", 0)
    start = field.value
    before = filled.bridge.document
    field.begin_drag(QPointF(0, 0))
    for x in (5, 15, 25):
        field.drag_to(QPointF(x, 0), Qt.KeyboardModifier.NoModifier)
    assert field.value == start + 20, "the way that told a drag from a click does not count"
    qtbot.keyClick(field, Qt.Key.Key_Escape)
    assert filled.bridge.document is before
    field.begin_drag(QPointF(0, 0))
    field.drag_to(QPointF(10, 0), Qt.KeyboardModifier.ShiftModifier)
    field.drag_to(QPointF(20, 0), Qt.KeyboardModifier.ShiftModifier)
    field.end_drag()
    filled.bridge.session.undo()
    assert filled.bridge.document is before
    check(before)


def test_the_label_drags_and_a_double_click_resets(qtbot: QtBot, inspector: Inspector, filled: OpenProject) -> None:
    row = inspector.row("ground.roll")
    qtbot.mousePress(row.label, Qt.MouseButton.LeftButton, pos=QPoint(5, 5))
    move(row.label, QPoint(30, 5), Qt.MouseButton.LeftButton)
    move(row.label, QPoint(60, 5), Qt.MouseButton.LeftButton)
    qtbot.mouseRelease(row.label, Qt.MouseButton.LeftButton, pos=QPoint(60, 5))
    assert value_of(filled.bridge.document, row.address, 1) != 0.0
    qtbot.mouseDClick(row.label, Qt.MouseButton.LeftButton)
    assert value_of(filled.bridge.document, row.address, 1) == 0.0


def test_the_diamond_sets_and_removes_keys(qtbot: QtBot, inspector: Inspector, filled: OpenProject) -> None:
    row, session = inspector.row("ground.declination"), filled.bridge.session
    states = [row.key.state]
    qtbot.mouseClick(row.key, Qt.MouseButton.LeftButton)
    states.append(row.key.state)
    session.go_to(3)
    states.append(row.key.state)
    assert states == [KeyState.NONE, KeyState.HERE, KeyState.KEYED]
    row.enter(20.0)
    assert [key.frame for key in track_of(session.document, DECLINATION).keys] == [1, 3]
    session.go_to(2)
    assert field_of(inspector, "ground.declination").value == 40.0
    session.go_to(3)
    qtbot.mouseClick(row.key, Qt.MouseButton.LeftButton)
    states = [row.key.state]
    row.edited.remove_all_keys()
    states.append(row.key.state)
    assert states == [KeyState.KEYED, KeyState.NONE]


def test_only_the_properties_of_the_light_there_is_are_shown(inspector: Inspector) -> None:
    assert inspector.row("light.position").editor.isVisibleTo(inspector)
    assert not inspector.row("light.azimuth").editor.isVisibleTo(inspector)
    inspector.row("light.kind").enter("sun")
    assert not inspector.row("light.position").editor.isVisibleTo(inspector)
    assert inspector.row("light.azimuth").editor.isVisibleTo(inspector)


def test_a_measured_tilt_is_shown_and_cannot_be_set(inspector: Inspector) -> None:
    row = inspector.row("grounding")
    assert inspector.row("tilt").editor.isEnabledTo(inspector)
    row.enter(((90.0, 170.0), (150.0, 150.0)))
    assert not inspector.row("tilt").editor.isEnabledTo(inspector)
    assert field_of(inspector, "tilt").value != 0.0


def test_a_choice_a_switch_and_a_colour(inspector: Inspector, filled: OpenProject) -> None:
    document = filled.bridge.document
    layer_id = document.layers[0].id
    inspector.row("shadow.blend").enter("normal")
    inspector.row("visible").enter(False)
    inspector.row("shadow.color").enter("#AA0000")
    for prop, value in ((properties.BLEND, "normal"), (properties.VISIBLE, False), (properties.COLOR, "#AA0000")):
        assert value_of(filled.bridge.document, Address(prop, layer_id), 1) == value


def test_layers_are_listed_chosen_hidden_renamed_moved_and_removed(layers: LayerList, filled: OpenProject) -> None:
    session, model = filled.bridge.session, layers.model
    filled.bring((CharacterSource("Second", session.document.layers[0].cels.drawings[0].path),)).at_once()
    assert [model.layer(row).name for row in range(model.rowCount())] == ["Second", "Walker"]
    layers.view.setCurrentIndex(model.index(1))
    assert session.document.layer(session.state.layer_id or "").name == "Walker"

    model.setData(model.index(1), False, Role.IS_VISIBLE)
    assert not model.index(1).data(Role.IS_VISIBLE)
    assert model.setData(model.index(1), "Runner")
    assert not model.setData(model.index(1), "Second"), "two layers of one name"
    model.move(session.state.layer_id or "", 0)
    assert [layer.name for layer in session.document.layers] == ["Second", "Runner"]
    layers.remove_current()
    assert [layer.name for layer in session.document.layers] == ["Second"]
    for _ in range(4):
        session.undo()
    assert [layer.name for layer in session.document.layers] == ["Walker", "Second"]


def test_the_eye_is_clicked_in_the_list(qtbot: QtBot, layers: LayerList) -> None:
    place = layers.view.visualRect(layers.model.index(0))
    qtbot.mouseClick(
        layers.view.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(place.left() + 12, place.center().y())
    )
    assert not layers.model.index(0).data(Role.IS_VISIBLE)


def test_white_inside_outlines_is_switched_in_the_menu(layers: LayerList, filled: OpenProject) -> None:
    def switch() -> QAction:
        layers.view.customContextMenuRequested.emit(layers.view.visualRect(layers.model.index(0)).center())
        *_, (menu, found) = (
            (menu, each)
            for menu in layers.view.findChildren(QMenu)
            for each in menu.actions()
            if each.text() == "White inside Outlines Stays"
        )
        menu.close()
        return found

    assert not switch().isChecked()
    switch().trigger()
    assert {drawing.paper for drawing in filled.bridge.document.layers[0].cels.drawings} == {Paper.BORDER}
    check(filled.bridge.document)
    assert switch().isChecked()
    filled.bridge.session.undo()
    assert not switch().isChecked()


def test_dropping_a_row_moves_its_layer(layers: LayerList, filled: OpenProject) -> None:
    session, model = filled.bridge.session, layers.model
    filled.bring((CharacterSource("Second", session.document.layers[0].cels.drawings[0].path),)).at_once()
    carried = model.mimeData([model.index(0)])
    assert not model.dropMimeData(carried, Qt.DropAction.MoveAction, 2, 0, model.index(-1))
    assert [layer.name for layer in session.document.layers] == ["Second", "Walker"]


def test_a_thumbnail_comes_beside_the_window(qtbot: QtBot, layers: LayerList) -> None:
    layers.model.index(0).data(Role.THUMBNAIL)
    qtbot.waitUntil(lambda: layers.model.index(0).data(Role.THUMBNAIL) is not None)
    image = layers.model.index(0).data(Role.THUMBNAIL)
    assert max(image.width(), image.height()) == 96
    assert image.height() > image.width(), "cropped to the figure, which is upright"


def test_the_ruler_and_the_field_set_the_frame(qtbot: QtBot, filled: OpenProject) -> None:
    scale = TimeScale()
    scale.set_length(6)
    ruler, field = Ruler(filled.bridge, scale), FrameField(filled.bridge)
    for widget in (ruler, field):
        qtbot.addWidget(widget)
        widget.show()
    ruler.resize(600, 40)
    for frame in (1, 4, 6):
        qtbot.mouseClick(ruler, Qt.MouseButton.LeftButton, pos=QPoint(round(scale.middle_of(frame)), 16))
        assert filled.bridge.frame == frame
        assert field.text() == str(frame)
    for typed, frame in (("2", 2), ("+3", 5), ("0+01", 1), ("nonsense", 1), ("999", 6)):
        field.selectAll()
        qtbot.keyClicks(field, typed)
        qtbot.keyClick(field, Qt.Key.Key_Return)
        assert filled.bridge.frame == frame


def test_playback_follows_the_clock_and_drops_no_frame_unless_asked(filled: OpenProject) -> None:
    now = [0.0]
    player = Player(filled.bridge, clock=lambda: now[0])
    seen: list[int] = []
    filled.bridge.frame_changed.connect(seen.append)
    filled.bridge.frame_changed.connect(player.picture_shown)
    player.start()
    for _ in range(8):
        now[0] += 1 / 24
        player._tick()
    assert seen == [2, 3, 4, 5, 6, 1, 2, 3]
    now[0] += 10 / 24
    player._tick()
    assert seen[-1] == 4, "every frame is shown, however late"
    player.every_frame = False
    now[0] += 3 / 24
    player._tick()
    assert seen[-1] == 1, "frames are dropped to be on time"
    player.loop = False
    now[0] += 30 / 24
    player._tick()
    assert seen[-1] == 6
    assert not player.is_playing


def test_the_rate_shown_is_the_rate_seen(qtbot: QtBot, filled: OpenProject) -> None:
    now = [0.0]
    player = Player(filled.bridge, clock=lambda: now[0])
    rates: list[float] = []
    transport = Transport(filled.bridge, player, [QAction("Play", filled), None])
    qtbot.addWidget(transport)
    player.rate_measured.connect(rates.append)
    player.start()
    for _ in range(20):
        now[0] += 1 / 12
        player._tick()
        player.picture_shown()
        player.picture_shown()
    assert rates[-1] == pytest.approx(12.0)
    assert "12.0 / 24 fps (slow)" in transport.rate.text()
    player.stop()
