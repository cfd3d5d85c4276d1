"""Taking light, looks, ground and set of another project, in the window."""

from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog
from pytestqt.qtbot import QtBot

from kagezou.document.address import Address, value_of
from kagezou.document.edits import rename_layer, set_constant
from kagezou.document.model import Document
from kagezou.document.properties import GROUND_DECLINATION, LIGHT_KIND, OPACITY
from kagezou.document.set_pieces import add_piece
from kagezou.document.taking import Part
from kagezou.geometry.sets.measures import PieceKind
from kagezou.io.project.file import save
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.project.taking_dialog import TakingDialog
from kagezou.ui.window.main_window import MainWindow

LEFT = Qt.MouseButton.LeftButton


def other(document: Document) -> Document:
    """Return a cut with another ground, another look, and the same light."""
    document = set_constant(document, Address(GROUND_DECLINATION), 33.0)
    return set_constant(document, Address(OPACITY, document.layers[0].id), 0.25)


def dialog_of(qtbot: QtBot, document: Document, source: Document) -> TakingDialog:
    made = TakingDialog(document, source, "master")
    qtbot.addWidget(made)
    made.show()
    return made


def agreed(qtbot: QtBot, dialog: TakingDialog) -> Document:
    with qtbot.waitSignal(dialog.chosen) as said:
        qtbot.mouseClick(dialog.take, LEFT)
    assert said.args is not None
    document = said.args[0]
    assert isinstance(document, Document)
    return document


def test_it_says_what_is_taken_what_is_the_same_and_what_stays(qtbot: QtBot, filled: OpenProject) -> None:
    document = filled.bridge.document
    dialog = dialog_of(qtbot, document, other(document))
    assert [part for part, box in dialog.parts.items() if box.isChecked()] == [Part.LIGHT, Part.LOOK, Part.GROUND]
    assert dialog.says.text().splitlines() == [
        "•  Taken from master: Looks, Ground",
        "•  The same already: Light",
        "•  Not taken: Set",
    ]
    dialog.parts[Part.LOOK].setChecked(False)
    done = agreed(qtbot, dialog)
    assert value_of(done, Address(GROUND_DECLINATION), 1) == 33
    assert done.layers == document.layers


def test_nothing_to_take_cannot_be_taken(qtbot: QtBot, filled: OpenProject) -> None:
    dialog = dialog_of(qtbot, filled.bridge.document, filled.bridge.document)
    assert not dialog.take.isEnabled()
    for box in dialog.parts.values():
        box.setChecked(False)
    assert dialog.says.text() == "•  Not taken: Light, Looks, Ground, Set"


def test_looks_go_to_ticked_characters_alone(qtbot: QtBot, filled: OpenProject) -> None:
    document = filled.bridge.document
    source = rename_layer(other(document), document.layers[0].id, "Somebody")
    dialog = dialog_of(qtbot, document, source)
    row = dialog.figures.topLevelItem(0)
    assert row is not None
    assert (row.text(0), row.text(1)) == ("Walker", "Somebody")
    row.setCheckState(0, Qt.CheckState.Unchecked)
    assert "The same already: Light, Looks" in dialog.says.text()
    row.setCheckState(0, Qt.CheckState.Checked)
    done = agreed(qtbot, dialog)
    assert value_of(done, Address(OPACITY, document.layers[0].id), 1) == pytest.approx(0.25)


def test_a_locked_character_gets_no_look(qtbot: QtBot, filled: OpenProject) -> None:
    document = filled.bridge.document
    first, *rest = document.layers
    locked = replace(document, layers=(replace(first, marks=replace(first.marks, is_locked=True)), *rest))
    dialog = dialog_of(qtbot, locked, other(document))
    row = dialog.figures.topLevelItem(0)
    assert row is not None
    assert row.isDisabled()
    assert agreed(qtbot, dialog).layers[0] == locked.layers[0]


def test_a_set_is_offered_where_there_is_one_and_looks_where_there_are_characters(
    qtbot: QtBot, filled: OpenProject
) -> None:
    document = filled.bridge.document
    with_wall = add_piece(replace(document, layers=()), "wall", PieceKind.WALL)
    dialog = dialog_of(qtbot, document, with_wall)
    assert dialog.parts[Part.SET].isChecked()
    assert not dialog.parts[Part.LOOK].isEnabled()
    assert not dialog.parts[Part.LOOK].isChecked()
    assert len(agreed(qtbot, dialog).pieces) == 1


def test_the_command_reads_a_project_and_takes_in_one_step(
    qtbot: QtBot, walking: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    bridge = walking.parts.bridge
    before = bridge.document
    save(set_constant(other(before), Address(LIGHT_KIND), "sun"), tmp_path / "master.kage")
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(tmp_path / "master.kage"), ""))
    walking.parts.actions["take_from"].trigger()

    def opened() -> list[TakingDialog]:
        return [each for each in walking.findChildren(TakingDialog) if each.isVisible()]

    qtbot.waitUntil(lambda: bool(opened()))
    qtbot.mouseClick(opened()[0].take, LEFT)
    qtbot.waitUntil(lambda: bridge.document is not before)
    assert value_of(bridge.document, Address(GROUND_DECLINATION), 1) == 33
    assert bridge.session.undo_name == "Take from project"
    assert "Taken from master: Light, Looks, Ground  ·  Not taken: Set" in walking.parts.bar.text
    bridge.session.undo()
    assert bridge.document is before


def test_a_file_that_is_no_project_is_said(
    qtbot: QtBot, walking: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "x.kage").write_text("none", encoding="utf-8")
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(tmp_path / "x.kage"), ""))
    walking.parts.actions["take_from"].trigger()
    qtbot.waitUntil(lambda: "x.kage" in walking.parts.bar.text)
    assert not walking.findChildren(TakingDialog)
