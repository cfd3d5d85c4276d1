"""Several layers in the inspector at once, links between them, and values and looks on the clipboard."""

from collections.abc import Callable

import pytest
from PySide6.QtCore import QItemSelectionModel, QPoint, QPointF, Qt
from PySide6.QtGui import QAction, QGuiApplication
from PySide6.QtWidgets import QCheckBox, QComboBox, QLineEdit, QMenu, QToolButton
from pytestqt.qtbot import QtBot

from kagezou.document import edits, properties
from kagezou.document.address import Address, track_of, value_of
from kagezou.document.invariants import check
from kagezou.importing.staging import CharacterSource
from kagezou.io.clips.style_files import loads_style
from kagezou.ui.panels.groups import Group
from kagezou.ui.panels.inspector import Inspector
from kagezou.ui.panels.layer_list import LayerList
from kagezou.ui.panels.layer_model import Role
from kagezou.ui.panels.look_clipboard import LookClipboard
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.system.clipboard import SystemClipboard
from kagezou.ui.system.menu_words import plain
from kagezou.ui.widgets.key_button import KeyState
from kagezou.ui.widgets.scrub_field import MIXED, ScrubField
from tests.ui.viewing import OwnClipboard

pytestmark = pytest.mark.qt_log_ignore("This plugin does not support propagateSizeHints")

NO_MODIFIER = Qt.KeyboardModifier.NoModifier
OPACITY, COLOR = properties.OPACITY, properties.COLOR


@pytest.fixture
def trio(filled: OpenProject) -> OpenProject:
    """Three characters with opacities of 0.6, 0.3 and 0.9, the uppermost worked on."""
    session = filled.bridge.session
    path = session.document.layers[0].cels.drawings[0].path
    for name in ("Second", "Third"):
        filled.bring((CharacterSource(name, path),)).at_once()
    document = session.document
    for layer, opacity in zip(document.layers, (0.6, 0.3, 0.9), strict=True):
        document = edits.set_constant(document, Address(OPACITY, layer.id), opacity)
    session.edit("Opacities", document)
    return filled


@pytest.fixture
def inspector(trio: OpenProject, inspector: Inspector) -> Inspector:  # noqa: ARG001 - of three characters
    return inspector


def opacities(open_project: OpenProject) -> list[float]:
    document = open_project.bridge.document
    values = [value_of(document, Address(OPACITY, layer.id), open_project.bridge.frame) for layer in document.layers]
    return [round(float(str(value)), 6) for value in values]


def choose_all(open_project: OpenProject) -> None:
    first, *others = [layer.id for layer in reversed(open_project.bridge.document.layers)]
    open_project.bridge.session.select(first, others=frozenset(others))


def field_of(inspector: Inspector, name: str) -> ScrubField:
    return inspector.row(name).editor.findChildren(ScrubField)[0]


def act(menu: QMenu, start: str) -> QAction:
    return next(action for action in menu.actions() if plain(action.text()).startswith(start))


def row_menu(inspector: Inspector, name: str) -> QMenu:
    menu = QMenu(inspector)
    inspector.menus.fill(inspector.row(name).edited, inspector.row(name).mates, menu)
    return menu


def test_layers_are_chosen_together_in_the_list(qtbot: QtBot, layers: LayerList, trio: OpenProject) -> None:
    def click(row: int, modifier: Qt.KeyboardModifier) -> None:
        place = layers.view.visualRect(layers.model.index(row)).center() + QPoint(60, 0)
        qtbot.mouseClick(layers.view.viewport(), Qt.MouseButton.LeftButton, modifier, place)

    names = {layer.id: layer.name for layer in trio.bridge.document.layers}
    click(0, NO_MODIFIER)
    click(2, Qt.KeyboardModifier.ControlModifier)
    assert [names[each] for each in trio.bridge.layer_ids] == ["Third", "Walker"]
    click(1, Qt.KeyboardModifier.ShiftModifier)
    click(1, NO_MODIFIER)
    assert [names[each] for each in trio.bridge.layer_ids] == ["Second"]
    choose_all(trio)
    assert len(layers.view.selectionModel().selectedIndexes()) == 3
    layers.remove_current()
    assert not trio.bridge.document.layers
    trio.bridge.session.undo()
    assert len(trio.bridge.layer_ids) == 3, "undo shows what was chosen"


def test_the_eye_stands_for_all_that_are_chosen_and_lets_none_go(
    qtbot: QtBot, layers: LayerList, trio: OpenProject
) -> None:
    ids = [layer.id for layer in trio.bridge.document.layers]
    trio.bridge.session.select(ids[2], others=frozenset({ids[1]}))

    def click(row: int) -> list[bool]:
        place = layers.view.visualRect(layers.model.index(row))
        at = QPoint(place.left() + 12, place.center().y())
        qtbot.mouseClick(layers.view.viewport(), Qt.MouseButton.LeftButton, NO_MODIFIER, at)
        values = [Address(properties.VISIBLE, each) for each in ids]
        return [bool(value_of(trio.bridge.document, each, 1)) for each in values]

    assert click(0) == [True, False, False]
    assert trio.bridge.layer_ids == (ids[2], ids[1])
    assert click(2) == [False, False, False], "one that is not chosen alone"
    assert trio.bridge.layer_ids == (ids[2], ids[1])


def test_rows_dragged_together_keep_their_order(layers: LayerList, trio: OpenProject) -> None:
    model = layers.model
    carried = model.mimeData([model.index(1), model.index(0)])
    model.dropMimeData(carried, Qt.DropAction.MoveAction, 3, 0, model.index(-1))
    assert [layer.name for layer in reversed(trio.bridge.document.layers)] == ["Walker", "Third", "Second"]
    trio.bridge.session.undo()
    assert [layer.name for layer in reversed(trio.bridge.document.layers)] == ["Third", "Second", "Walker"]


def test_values_that_differ_are_a_dash_and_typing_sets_all(
    qtbot: QtBot, inspector: Inspector, trio: OpenProject
) -> None:
    assert not inspector.chosen.isVisibleTo(inspector)
    choose_all(trio)
    assert inspector.chosen.text() == "3 layers together: Third, Walker, Second"
    field = field_of(inspector, OPACITY.name)
    assert field.text() == MIXED
    assert field_of(inspector, "shadow.fade_curve").text() == "1"
    qtbot.mouseClick(field, Qt.MouseButton.LeftButton)
    assert field.text() == ""
    qtbot.keyClicks(field, "50")
    qtbot.keyClick(field, Qt.Key.Key_Return)
    assert opacities(trio) == [0.5, 0.5, 0.5]
    assert field.text() == "50%"
    trio.bridge.session.undo()
    assert opacities(trio) == [0.6, 0.3, 0.9]
    assert field.text() == MIXED


def test_a_drag_moves_all_by_the_difference_as_one_step(inspector: Inspector, trio: OpenProject) -> None:
    choose_all(trio)
    field = field_of(inspector, OPACITY.name)
    before = trio.bridge.document
    field.begin_drag(QPointF(0, 0))
    field.drag_to(QPointF(10, 0), NO_MODIFIER)
    field.drag_to(QPointF(50, 0), NO_MODIFIER)
    assert field.text() == "+20"
    assert opacities(trio) == [0.8, 0.5, 1.0], "kept to the range one by one"
    field.drag_to(QPointF(30, 0), NO_MODIFIER)
    assert opacities(trio) == [0.7, 0.4, 1.0]
    field.drag_to(QPointF(-10, 0), NO_MODIFIER)
    assert opacities(trio) == [0.5, 0.2, 0.8], "what met the end of the range comes back with the others"
    field.end_drag()
    trio.bridge.session.undo()
    assert trio.bridge.document is before


def test_a_typed_change_and_the_arrows_change_each_by_itself(
    qtbot: QtBot, inspector: Inspector, trio: OpenProject
) -> None:
    choose_all(trio)
    field = field_of(inspector, OPACITY.name)
    qtbot.mouseClick(field, Qt.MouseButton.LeftButton)
    qtbot.keyClicks(field, "/3")
    qtbot.keyClick(field, Qt.Key.Key_Return)
    assert opacities(trio) == [0.2, 0.1, 0.3]
    qtbot.keyClick(field, Qt.Key.Key_Down, Qt.KeyboardModifier.ShiftModifier)
    assert opacities(trio) == [0.15, 0.05, 0.25]


def test_switches_choices_and_colours_together(inspector: Inspector, trio: OpenProject) -> None:
    layer_ids = [layer.id for layer in trio.bridge.document.layers]
    document = trio.bridge.document
    document = edits.set_constant(document, Address(properties.WAVES_ON, layer_ids[0]), False)
    document = edits.set_constant(document, Address(properties.BLEND, layer_ids[0]), "normal")
    document = edits.set_constant(document, Address(COLOR, layer_ids[0]), "#FF0000")
    trio.bridge.session.edit("Differ", document)
    choose_all(trio)
    switch = inspector.row("shadow.waves_on").editor.findChildren(QCheckBox)[0]
    assert switch.checkState() is Qt.CheckState.PartiallyChecked
    switch.click()
    assert [value_of(trio.bridge.document, Address(properties.WAVES_ON, each), 1) for each in layer_ids] == [True] * 3
    assert switch.checkState() is Qt.CheckState.Checked
    combo = inspector.row("shadow.blend").editor.findChildren(QComboBox)[0]
    assert (combo.currentIndex(), combo.placeholderText()) == (-1, MIXED)
    code = inspector.row("shadow.color").editor.findChildren(QLineEdit)[0]
    assert code.text() == MIXED
    code.setText("#20203A")
    code.editingFinished.emit()
    assert [value_of(trio.bridge.document, Address(COLOR, each), 1) for each in layer_ids] == ["#20203A"] * 3
    assert code.text() == "#20203A"


def test_keys_and_reset_of_several_layers(qtbot: QtBot, inspector: Inspector, trio: OpenProject) -> None:
    choose_all(trio)
    row, session = inspector.row(OPACITY.name), trio.bridge.session
    session.edit("Key", edits.set_key(session.document, row.address, 1, 0.9))
    states = [row.key.state]
    row.edited.toggle_key()
    states.append(row.key.state)
    assert states == [KeyState.KEYED, KeyState.HERE], "on one of three, then on all"
    assert opacities(trio) == [0.6, 0.3, 0.9]
    qtbot.mouseDClick(row.label, Qt.MouseButton.LeftButton)
    assert opacities(trio) == [OPACITY.default] * 3
    assert row.key.state is KeyState.NONE


def test_a_link_is_made_shown_obeyed_and_undone(qtbot: QtBot, inspector: Inspector, trio: OpenProject) -> None:
    row, session = inspector.row(OPACITY.name), trio.bridge.session
    assert row.link.isVisibleTo(inspector)
    assert not inspector.row("grounding").link.isVisibleTo(inspector)
    assert not inspector.row("ground.roll").link.isVisibleTo(inspector)
    qtbot.mouseClick(row.link, Qt.MouseButton.LeftButton)
    assert row.link.is_linked
    assert opacities(trio) == [0.9, 0.9, 0.9]
    row.edited.toggle_key()
    row.enter(0.4)
    assert all(track_of(session.document, Address(OPACITY, each.id)).is_keyed for each in session.document.layers)
    choose_all(trio)
    field = field_of(inspector, OPACITY.name)
    field.begin_drag(QPointF(0, 0))
    field.drag_to(QPointF(10, 0), NO_MODIFIER)
    field.drag_to(QPointF(30, 0), NO_MODIFIER)
    field.end_drag()
    assert opacities(trio) == [0.5, 0.5, 0.5], "once, not once a layer"
    check(session.document)
    session.undo()
    session.undo()
    session.undo()
    assert session.undo_name == "Link Opacity"
    session.undo()
    assert opacities(trio) == [0.6, 0.3, 0.9]
    assert not inspector.row(OPACITY.name).link.is_linked


def test_a_value_goes_through_the_clipboard_as_scripts_write_it(
    inspector: Inspector, trio: OpenProject, clipboard: OwnClipboard
) -> None:
    act(row_menu(inspector, OPACITY.name), "Copy Value").trigger()
    assert clipboard.text() == "0.9"
    choose_all(trio)
    act(row_menu(inspector, "shadow.fade_curve"), "Paste Value").trigger()
    assert field_of(inspector, "shadow.fade_curve").text() == "0.9"
    act(row_menu(inspector, OPACITY.name), "Paste Value").trigger()
    assert opacities(trio) == [0.9, 0.9, 0.9]
    assert not act(row_menu(inspector, "shadow.color"), "Paste Value").isEnabled(), "0.9 is no colour"
    for nothing in ("", "hello", "[1,2", "NaN", "1e999"):
        clipboard.put(nothing)
        assert not act(row_menu(inspector, OPACITY.name), "Paste Value").isEnabled()
    act(row_menu(inspector, OPACITY.name), "Copy Name").trigger()
    assert clipboard.text() == "layers.Third.shadow.opacity"


def test_what_is_copied_goes_over_the_clipboard_of_the_screen(
    qtbot: QtBot,
    request: pytest.FixtureRequest,
    trio: OpenProject,
    present: Callable[[], None],
) -> None:
    """Whole, from copying to pasting, again until no other program takes the clipboard in between."""
    board = QGuiApplication.clipboard()
    inspector, looks = Inspector(trio.bridge, SystemClipboard()), LookClipboard(trio.bridge, SystemClipboard())
    qtbot.addWidget(inspector)
    choose_all(trio)

    def values_are_pasted() -> bool:
        present()
        act(row_menu(inspector, OPACITY.name), "Copy Value").trigger()
        copied = board.text() == "0.9"
        paste = act(row_menu(inspector, OPACITY.name), "Paste Value")
        return copied and paste.isEnabled()

    def looks_are_pasted() -> bool:
        present()
        looks.copy()
        return loads_style(board.text()) is not None and looks.can_paste

    with request.getfixturevalue("qtlog").disabled():
        qtbot.waitUntil(values_are_pasted)
        qtbot.waitUntil(looks_are_pasted)


def test_a_section_is_copied_pasted_and_reset_as_one_step(inspector: Inspector, trio: OpenProject) -> None:
    session = trio.bridge.session
    inspector.row("shadow.simplify").enter(33.0)
    inspector.row("shadow.grow").enter(4.0)
    rows = inspector.row("shadow.grow").mates
    menu = QMenu(inspector)
    inspector.menus.fill_section(rows, menu)
    act(menu, "Copy All").trigger()
    session.select(session.document.layers[0].id)
    act(row_menu(inspector, "shadow.fade"), "Paste 9 Values").trigger()
    assert field_of(inspector, "shadow.simplify").value == 33.0
    assert opacities(trio) == [0.6, 0.3, 0.9], "other sections stay"
    assert session.undo_name == "Paste values"
    menu = QMenu(inspector)
    inspector.menus.fill_section(inspector.row("shadow.grow").mates, menu)
    act(menu, "Reset All").trigger()
    assert (field_of(inspector, "shadow.simplify").value, field_of(inspector, "shadow.grow").value) == (0.0, 0.0)
    session.undo()
    assert field_of(inspector, "shadow.grow").value == 4.0


def test_a_look_is_pasted_on_all_chosen_layers(
    layers: LayerList, inspector: Inspector, trio: OpenProject, clipboard: OwnClipboard
) -> None:
    session = trio.bridge.session
    inspector.row("shadow.color").enter("#334455")
    layers.looks.copy()
    style = loads_style(clipboard.text())
    assert style is not None
    assert style.name.en == "Third"
    lower = [layer.id for layer in session.document.layers[:2]]
    session.select(lower[0], others=frozenset(lower[1:]))
    noted: list[str] = []
    layers.looks.noted.connect(noted.append)
    layers.looks.paste()
    assert noted == ["Third: 4 properties changed"]
    assert opacities(trio) == [0.9, 0.9, 0.9]
    assert {value_of(session.document, Address(COLOR, each), 1) for each in lower} == {"#334455"}
    session.undo()
    assert opacities(trio) == [0.6, 0.3, 0.9]
    said: list[str] = []
    layers.looks.refused.connect(said.append)
    clipboard.put("no look")
    layers.looks.paste()
    assert len(said) == 1
    assert not layers.looks.can_paste


def test_a_changed_row_says_so_in_words_too(inspector: Inspector) -> None:
    row = inspector.row("shadow.fade")
    assert "default" not in row.label.toolTip()
    row.enter(120.0)
    assert "layers.Third.shadow.fade<br>Changed; double-click for the default, 0.0</p>" in row.label.toolTip()
    row.enter(1e9)
    assert "1000000000.0 is not a number from 0 to 10000 px" in row.label.toolTip()
    row.edited.reset()
    assert "layers.Third.shadow.fade</p>" in row.label.toolTip(), "beside a picture of what it does"


def test_folded_sections_stay_folded_on_the_next_layer(qtbot: QtBot, inspector: Inspector, trio: OpenProject) -> None:
    header = inspector.sections[Group.SHAPE].findChild(QToolButton, "section_header")
    qtbot.mouseClick(header, Qt.MouseButton.LeftButton)
    before = {group: each.is_open for group, each in inspector.sections.items()}
    assert not before[Group.SHAPE]
    trio.bridge.session.select(trio.bridge.document.layers[0].id)
    assert {group: each.is_open for group, each in inspector.sections.items()} == before


def test_the_row_of_the_list_that_is_worked_on_stays_current(layers: LayerList, trio: OpenProject) -> None:
    flag = QItemSelectionModel.SelectionFlag
    layers.view.selectionModel().select(layers.model.index(1), flag.Select)
    third = trio.bridge.document.layers[-1]
    assert trio.bridge.layer_id == third.id
    assert len(trio.bridge.layer_ids) == 2


def test_a_layer_dropped_on_another_is_a_part_of_its_figure(layers: LayerList, trio: OpenProject) -> None:
    session, model = trio.bridge.session, layers.model
    below, middle, top = session.document.layers
    carried = model.mimeData([model.index(0)])
    assert not model.dropMimeData(carried, Qt.DropAction.MoveAction, -1, -1, model.index(1))
    assert [layer.joins for layer in session.document.layers] == [None, None, middle.id]
    assert session.undo_name == "Join figure"
    assert model.index(0).data(Role.IS_PART)
    assert str(model.index(0).data(Role.SUMMARY)).endswith(f"part of {middle.name}")
    # The figure itself goes with its parts.
    model.dropMimeData(model.mimeData([model.index(1)]), Qt.DropAction.MoveAction, -1, -1, model.index(2))
    assert [layer.joins for layer in session.document.layers] == [None, below.id, below.id]
    session.undo()
    model.join((top.id,), None)
    assert [layer.joins for layer in session.document.layers] == [None, None, None]
    before = session.document
    model.dropMimeData(model.mimeData([model.index(0)]), Qt.DropAction.MoveAction, -1, -1, model.index(0))
    assert session.document is before


def test_a_part_of_a_figure_shows_what_is_its_own(inspector: Inspector, trio: OpenProject) -> None:
    session = trio.bridge.session
    below, _, top = session.document.layers
    session.select(top.id)
    session.edit("Join", edits.join_layer(session.document, top.id, below.id))
    for section in inspector.sections.values():
        section.open(opened=True)
        section.more.setChecked(True)
    shown = [
        row.address.property.name
        for row in inspector.rows
        if row.address.layer_id and row.editor.isVisibleTo(inspector)
    ]
    assert shown == ["visible", "receives", "position", "anchor", "scale", "rotation"]
    assert below.name in inspector.chosen.text()
    session.select(below.id)
    assert inspector.row("shadow.opacity").editor.isVisibleTo(inspector)
    assert not inspector.chosen.isVisibleTo(inspector)
