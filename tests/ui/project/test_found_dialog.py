"""The dialog of what was found, and when it comes."""

from pathlib import Path
from typing import Any

import numpy as np
import OpenImageIO as oiio  # noqa: N813  # the name its own manual uses
import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from kagezou.importing.cels_of_files import held_by
from kagezou.importing.found_characters import FoundCharacters, found_characters
from kagezou.importing.new_cels import CharacterSource
from kagezou.io.images.writing import write_rgba
from kagezou.io.sheets.reading import read_sheets
from kagezou.io.sheets.timesheet import SheetTrack, Timesheet
from kagezou.io.sheets.xdts_writing import write_xdts
from kagezou.ui.project.dialogs import Dialogs
from kagezou.ui.project.found_dialog import FoundDialog
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.system.settings import Settings
from kagezou.ui.window.main_window import MainWindow
from tests.ui.conftest import figure_rgba
from tests.ui.viewing import OwnClipboard


@pytest.fixture
def mixed(tmp_path: Path) -> Path:
    """A folder with a body, an arm and a prop, a retake among them."""
    folder = tmp_path / "cut"
    folder.mkdir()
    for name in ("A0001", "A0002", "A0002_R1", "arm_1", "arm_2", "prop1"):
        write_rgba(folder / f"{name}.png", figure_rgba(1))
    return folder


@pytest.fixture
def found(mixed: Path) -> FoundCharacters:
    return found_characters([CharacterSource(None, mixed)])


@pytest.fixture
def dialog(qtbot: QtBot, found: FoundCharacters) -> FoundDialog:
    made = FoundDialog(found)
    qtbot.addWidget(made)
    made.show()
    return made


@pytest.fixture
def plain(qtbot: QtBot, settings: Settings) -> MainWindow:
    made = MainWindow(OpenProject(), settings, OwnClipboard())
    qtbot.addWidget(made)
    return made


def cell(dialog: FoundDialog, row: int, column: int) -> str:
    item = dialog.table.item(row, column)
    return item.text() if item else ""


def test_it_tells_what_was_understood(dialog: FoundDialog, found: FoundCharacters, qtbot: QtBot) -> None:
    assert [cell(dialog, row, 0) for row in range(3)] == ["A", "arm", "prop"]
    assert [cell(dialog, row, 1) for row in range(3)] == ["2\n1-2", "2\n1-2", "1\n1"]
    assert cell(dialog, 0, 2) == "A0001.png\n… A0002_R1.png"
    assert cell(dialog, 0, 4) == "The newest retake counts: A0002.png → A0002_R1.png"
    assert [source.name for source in dialog.sources()] == ["A", "arm", "prop"]
    drawings = [source.drawings for source in dialog.sources()]
    assert [each.files for each in drawings if each] == [
        each.source.drawings.files for each in found.characters if each.source.drawings
    ]
    qtbot.waitUntil(lambda: all(not name.icon().isNull() for name in dialog.names))


def test_rows_are_left_out_renamed_and_joined(dialog: FoundDialog) -> None:
    dialog.names[0].setText("Hero ")
    dialog.names[2].setCheckState(Qt.CheckState.Unchecked)
    dialog.figures[1].setCurrentIndex(1)
    assert [(source.name, source.joins) for source in dialog.sources()] == [("Hero", None), ("arm", "Hero")]
    assert not dialog.figures[0].isEnabled(), "there is no figure above the first row"
    dialog.names[0].setCheckState(Qt.CheckState.Unchecked)
    assert [(source.name, source.joins) for source in dialog.sources()] == [("arm", None)]
    dialog.names[1].setCheckState(Qt.CheckState.Unchecked)
    assert not dialog.take.isEnabled()
    dialog.names[1].setCheckState(Qt.CheckState.Checked)
    dialog.names[1].setText("  ")
    assert [source.name for source in dialog.sources()] == ["arm"]


def test_a_psd_file_names_its_characters_itself_unless_it_is_called_otherwise(qtbot: QtBot, tmp_path: Path) -> None:
    (tmp_path / "hero.psd").write_bytes(b"8BPS")
    psd = [CharacterSource(None, tmp_path / name) for name in ("hero.psd",)]
    dialog = FoundDialog(FoundCharacters(found_characters(psd).characters * 2))
    qtbot.addWidget(dialog)
    assert cell(dialog, 0, 1) == "PSD"
    dialog.names[1].setText("Other")
    assert [source.name for source in dialog.sources()] == [None, "Other"]


def test_enter_takes(dialog: FoundDialog, qtbot: QtBot) -> None:
    with qtbot.waitSignal(dialog.accepted):
        qtbot.keyClick(dialog, Qt.Key.Key_Return)


def test_one_clear_character_comes_unasked(plain: MainWindow, cels: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Dialogs, "characters", lambda _dialogs, _found: pytest.fail("nothing is to be asked"))
    plain.parts.project.bring([cels])
    assert [layer.name for layer in plain.parts.open_project.bridge.document.layers] == ["walker"]
    assert "walker: 6 drawings, 1-6, walk_0001.png … walk_0006.png" in plain.parts.bar.text
    plain.close_unasked()


def test_what_is_taken_comes_and_nothing_else(plain: MainWindow, mixed: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Dialogs, "characters", lambda _dialogs, _found: ())
    plain.parts.project.bring([mixed])
    assert plain.parts.open_project.is_blank
    monkeypatch.setattr(Dialogs, "characters", lambda _dialogs, found: found.sources[:2])
    plain.parts.project.bring([mixed])
    layers = plain.parts.open_project.bridge.document.layers
    assert [(layer.name, len(layer.cels.drawings)) for layer in layers] == [("A", 2), ("arm", 2)]
    plain.close_unasked()


def test_which_of_several_sheets_is_asked(plain: MainWindow, cels: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[list[str]] = []

    def second(_dialogs: Dialogs, names: list[str]) -> str:
        asked.append(names)
        return "#2"

    monkeypatch.setattr(Dialogs, "sheet", second)
    path = cels.parent / "c012.xdts"
    write_xdts(path, Timesheet("one", 12, (SheetTrack("walker", ((0, "1"),)),)))
    plain.parts.project.open_path(path)
    assert asked == []
    assert plain.parts.open_project.bridge.document.canvas.length_frames == 12
    text = path.read_text(encoding="utf-8")
    table = text[text.index('"timeTables": [') + 15 : text.index('],\n "version"')]
    other = table.replace('"one"', '"two"').replace("12", "30")
    path.write_text(text.replace(table, f"{table},{other}"), encoding="utf-8")
    assert len(read_sheets(path)) == 2
    plain.parts.project.time_by(path)
    assert asked == [["one", "two"]]
    assert plain.parts.open_project.bridge.document.canvas.length_frames == 30
    monkeypatch.setattr(Dialogs, "sheet", lambda _dialogs, _names: None)
    before = plain.parts.open_project.bridge.document
    plain.parts.project.time_by(path)
    assert plain.parts.open_project.bridge.document is before
    plain.close_unasked()


def passes(folder: Path) -> Path:
    """A sequence of two frames with a beauty and a line pass."""
    folder.mkdir()
    for number in (1, 2):
        spec = oiio.ImageSpec(8, 8, 8, oiio.HALF)
        spec.channelnames = tuple(f"{layer}.{channel}" for layer in ("line", "beauty") for channel in "RGBA")
        out: Any = oiio.ImageOutput.create(str(folder / f"a_{number}.exr"))
        assert out.open(str(folder / f"a_{number}.exr"), spec)
        assert out.write_image(np.full((8, 8, 8), 0.5, np.float32))
        out.close()
    return folder


def test_which_layer_of_exr_files_is_asked(qtbot: QtBot, tmp_path: Path) -> None:
    found = found_characters([CharacterSource(None, passes(tmp_path / "A"))])
    assert not found.is_clear
    dialog = FoundDialog(found)
    qtbot.addWidget(dialog)
    box = dialog.layers[0]
    assert [box.itemText(index) for index in range(box.count())] == ["beauty", "line"]
    assert dialog.sources()[0].layer is None
    box.setCurrentIndex(1)
    (source,) = dialog.sources()
    assert source.layer == "line"
    (layer,) = held_by(source).layers
    assert [drawing.part for drawing in layer.cels.drawings] == ["line", "line"]
