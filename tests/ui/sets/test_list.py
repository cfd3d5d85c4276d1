"""The set in the window: its list, its commands, and the inspector of a piece."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QLineEdit, QWidget
from pytestqt.qtbot import QtBot

from kagezou.document import set_properties as s
from kagezou.document.address import Address, track_of, value_of
from kagezou.document.edits import set_key
from kagezou.document.piece_kinds import BUILT_KINDS
from kagezou.document.set_pieces import add_piece
from kagezou.tools.curves.curve_list import curves_of, same_in
from kagezou.ui.sets.list_model import PieceRole
from kagezou.ui.window.main_window import MainWindow


@pytest.fixture
def standing(walking: MainWindow) -> MainWindow:
    """The window with a character and a wall that is worked on."""
    walking.parts.actions["add_wall"].trigger()
    return walking


def names(window: MainWindow) -> list[str]:
    model = window.parts.sets.pieces.model
    return [str(model.index(row).data()) for row in range(model.rowCount())]


def steps(window: MainWindow) -> str | None:
    return window.parts.open_project.bridge.session.undo_name


class TestCommands:
    def test_each_kind_is_added_as_a_step_with_its_name_and_worked_on(self, walking: MainWindow) -> None:
        bridge = walking.parts.open_project.bridge
        for kind in BUILT_KINDS:
            walking.parts.actions[f"add_{kind}"].trigger()
            assert steps(walking) == f"Add {kind}"
            assert bridge.piece_id == bridge.document.pieces[-1].id
            assert bridge.layer_id is None
        assert names(walking) == ["Wall", "Box", "Steps", "Ramp", "Cylinder", "Sphere"]

    def test_undo_and_redo_bring_back_what_was_worked_on(self, standing: MainWindow) -> None:
        bridge = standing.parts.open_project.bridge
        bridge.session.undo()
        assert (bridge.piece_id, bridge.layer_id) == (None, "layer-1")
        assert names(standing) == []
        bridge.session.redo()
        assert (bridge.piece_id, bridge.layer_id) == ("piece-1", None)

    def test_a_copy_stands_aside_but_what_is_keyed_keeps_its_way(self, standing: MainWindow) -> None:
        bridge = standing.parts.open_project.bridge
        where = Address(s.PIECE_POSITION, piece_id="piece-1")
        standing.parts.actions["duplicate_piece"].trigger()
        assert steps(standing) == "Duplicate set piece"
        assert bridge.piece_id == "piece-2"
        first, second = (value_of(bridge.document, Address(s.PIECE_POSITION, piece_id=f"piece-{n}"), 1) for n in (1, 2))
        assert first != second
        bridge.session.edit("Key", set_key(bridge.document, where, 1, first))
        bridge.session.select_piece("piece-1")
        standing.parts.actions["duplicate_piece"].trigger()
        keyed = track_of(bridge.document, Address(s.PIECE_POSITION, piece_id="piece-3"))
        assert keyed == track_of(bridge.document, where)

    def test_a_piece_is_removed_and_the_layer_is_worked_on_again(self, standing: MainWindow) -> None:
        standing.parts.actions["remove_piece"].trigger()
        assert steps(standing) == "Remove set piece"
        assert standing.parts.open_project.bridge.layer_id == "layer-1"
        assert not standing.parts.actions["remove_piece"].isEnabled()

    def test_a_full_set_says_so(self, standing: MainWindow) -> None:
        bridge = standing.parts.open_project.bridge
        document = bridge.document
        for _ in range(199):
            document = add_piece(document, "Post", "cylinder", {"present": False})
        bridge.session.edit("Many", document)
        for name in ("add_box", "duplicate_piece"):
            standing.parts.actions[name].trigger()
            assert "at most 200" in standing.parts.bar.text
        assert bridge.document is document


class TestList:
    def test_a_click_works_on_a_piece_and_a_layer_lets_it_go(self, qtbot: QtBot, standing: MainWindow) -> None:
        view, layers, bridge = (
            standing.parts.sets.pieces.view,
            standing.parts.panels.layers.view,
            standing.parts.open_project.bridge,
        )
        standing.parts.actions["add_box"].trigger()
        at = view.visualRect(view.model().index(0, 0)).center()
        qtbot.mouseClick(view.viewport(), Qt.MouseButton.LeftButton, pos=at)
        assert bridge.piece_id == "piece-1"
        assert not layers.selectionModel().selectedIndexes()
        at = layers.visualRect(layers.model().index(0, 0)).center()
        qtbot.mouseClick(layers.viewport(), Qt.MouseButton.LeftButton, pos=at)
        assert bridge.session.state.piece_id is None
        assert bridge.session.state.layer_id == "layer-1"
        assert not view.selectionModel().selectedIndexes()

    def test_the_eye_takes_a_piece_out_and_puts_it_back(self, qtbot: QtBot, standing: MainWindow) -> None:
        view, bridge = standing.parts.sets.pieces.view, standing.parts.open_project.bridge
        row = view.visualRect(view.model().index(0, 0))
        eye = QPoint(row.left() + 12, row.center().y())
        present = Address(s.PIECE_PRESENT, piece_id="piece-1")
        qtbot.mouseClick(view.viewport(), Qt.MouseButton.LeftButton, pos=eye)
        assert steps(standing) == "Hide set piece"
        assert value_of(bridge.document, present, 1) is False
        qtbot.mouseClick(view.viewport(), Qt.MouseButton.LeftButton, pos=eye)
        assert value_of(bridge.document, present, 1) is True

    def test_f2_renames_and_a_name_that_is_taken_is_refused_with_a_sentence(
        self, qtbot: QtBot, standing: MainWindow
    ) -> None:
        standing.parts.actions["add_box"].trigger()
        for name, typed, expected in (
            ("rename_layer", "Desk", ["Wall", "Desk"]),
            ("rename_piece", "Wall", ["Wall", "Desk"]),
        ):
            standing.parts.actions[name].trigger()
            editor = standing.parts.sets.pieces.view.findChild(QLineEdit)
            assert editor is not None
            editor.setText(typed)
            qtbot.keyClick(editor, Qt.Key.Key_Return)
            qtbot.waitUntil(lambda: standing.parts.sets.pieces.view.findChild(QLineEdit) is None)
            assert names(standing) == expected
        assert "already a set piece named 'Wall'" in standing.parts.bar.text

    def test_the_list_grows_with_its_pieces_and_leaves_room_for_the_layers(self, standing: MainWindow) -> None:
        heights = [standing.parts.sets.pieces.view.maximumHeight()]
        for _ in range(7):
            standing.parts.actions["add_box"].trigger()
            heights.append(standing.parts.sets.pieces.view.maximumHeight())
        assert heights[4] == 5 * heights[0] == heights[-1]
        assert standing.parts.panels.layers.view.minimumHeight() > 40

    def test_the_kind_is_told_to_the_painter(self, standing: MainWindow) -> None:
        index = standing.parts.sets.pieces.model.index(0)
        assert (index.data(PieceRole.KIND), index.data(PieceRole.IS_PRESENT)) == ("wall", True)


def test_no_style_is_offered_while_there_is_no_character_to_put_it_on(standing: MainWindow) -> None:
    states = [standing.parts.panels.styles.isEnabled()]
    standing.parts.open_project.bridge.session.select("layer-1")
    states.append(standing.parts.panels.styles.isEnabled())
    standing.parts.open_project.clear()
    assert [*states, standing.parts.panels.styles.isEnabled()] == [False, True, False]


class TestInspector:
    def shown(self, window: MainWindow) -> list[str]:
        rows = [row for row in window.parts.panels.inspector.rows if row.address.piece_id is not None]
        return [row.address.property.name for row in rows if row.editor.isVisibleTo(window.parts.panels.inspector)]

    def test_it_says_whose_properties_they_are_and_shows_those_of_the_kind(self, standing: MainWindow) -> None:
        owner = standing.parts.panels.inspector.owner
        assert owner is not None
        assert (owner.name.text(), owner.kind.text()) == ("Wall", "Set piece: Wall")
        assert self.shown(standing) == [
            "kind", "position", "angle", "lean", "width", "height", "present", "receives", "blocks", "casts",
        ]  # fmt: skip
        standing.parts.panels.inspector.row("kind").enter("steps")
        assert owner.kind.text() == "Set piece: Steps"
        assert {"depth", "count"} <= set(self.shown(standing))
        assert "lean" not in self.shown(standing)
        standing.parts.panels.inspector.row("kind").enter("sphere")
        assert not {"height", "depth", "angle", "count"} & set(self.shown(standing))

    def test_values_and_keys_are_set_on_the_piece(self, standing: MainWindow) -> None:
        row, bridge = standing.parts.panels.inspector.row("width"), standing.parts.open_project.bridge
        row.enter(321.0)
        assert steps(standing) == "Change Width"
        row.edited.toggle_key()
        track = track_of(bridge.document, Address(s.PIECE_WIDTH, piece_id="piece-1"))
        assert [(key.frame, key.value) for key in track.keys] == [(1, 321.0)]

    def test_the_shadow_of_the_set_stands_right_below_the_piece(self, qtbot: QtBot, standing: MainWindow) -> None:
        def top(widget: QWidget) -> int:
            return widget.mapTo(standing.parts.panels.inspector, QPoint()).y()

        color, fov = (standing.parts.panels.inspector.row(name).editor for name in ("set.shadow.color", "camera.fov"))
        qtbot.waitUntil(lambda: top(standing.parts.panels.inspector.row("casts").editor) < top(color) < top(fov))
        standing.parts.open_project.bridge.session.select("layer-1")
        assert standing.parts.panels.inspector.owner is None
        assert self.shown(standing) == []

    def test_a_piece_that_goes_takes_its_rows_with_it(self, standing: MainWindow) -> None:
        standing.parts.open_project.bridge.session.undo()
        assert self.shown(standing) == []
        assert standing.parts.panels.inspector.row("shadow.opacity").address.layer_id == "layer-1"


def test_the_timeline_works_on_the_piece_whose_row_is_clicked(standing: MainWindow) -> None:
    bridge = standing.parts.open_project.bridge
    bridge.session.edit("Key", set_key(bridge.document, Address(s.PIECE_WIDTH, piece_id="piece-1"), 3, 200.0))
    bridge.session.select("layer-1")
    row = next(row for row in standing.parts.time.timeline.rows.rows if row.piece_id is not None)
    standing.parts.time.timeline.names._choose(row)
    assert (bridge.piece_id, bridge.layer_id) == ("piece-1", None)
    assert row.is_about(bridge.layer_ids, bridge.piece_id)
    standing.parts.actions["key_next"].trigger()
    assert bridge.frame == 3
    curves = curves_of(bridge.document, bridge.layer_id, bridge.piece_id)
    assert [(curve.address.property, curve.address.piece_id) for curve in curves] == [(s.PIECE_WIDTH, "piece-1")]
    renamed = replace(bridge.document, pieces=(replace(bridge.document.pieces[0], id="piece-7"),))
    assert same_in(renamed, curves[0], bridge.document) == track_of(bridge.document, curves[0].address)
