"""A background of several pictures in the window; a folder that is dropped is a character."""

from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.system.settings import Settings
from kagezou.ui.window.main_window import MainWindow
from tests.importing.cel_files import write_cel
from tests.ui.viewing import OwnClipboard


@pytest.fixture
def plain(qtbot: QtBot, settings: Settings) -> MainWindow:
    made = MainWindow(OpenProject(), settings, OwnClipboard())
    qtbot.addWidget(made)
    return made


@pytest.fixture
def street(tmp_path: Path) -> Path:
    for number in (1, 2, 4):
        write_cel(tmp_path / "street" / f"street_{number:03}.png", (300, 200), (0, 0, 300, 200))
    return tmp_path / "street"


def test_a_folder_becomes_the_background_in_one_step(
    plain: MainWindow, street: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    project, bridge = plain.parts.project, plain.parts.open_project.bridge
    said: list[str] = []
    plain.parts.open_project.noted.connect(lambda note: said.append(str(note)))
    monkeypatch.setattr(project.dialogs, "folder_of_background", lambda: street)
    plain.parts.actions["background_pictures"].trigger()
    document = bridge.document
    assert [drawing.path.name for drawing in document.behind.drawings] == [
        "street_001.png", "street_002.png", "street_004.png"
    ]  # fmt: skip
    assert (document.canvas.width_px, document.canvas.height_px, document.canvas.length_frames) == (300, 200, 4)
    assert said == ["street: missing 3; the drawing before is held"]
    bridge.session.undo()
    assert bridge.document.is_blank
    plain.close_unasked()


def test_it_leaves_the_canvas_as_it_is_where_there_is_a_character(
    plain: MainWindow, cels: Path, street: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    project, bridge = plain.parts.project, plain.parts.open_project.bridge
    project.bring([cels])
    before = bridge.document.canvas
    monkeypatch.setattr(project.dialogs, "folder_of_background", lambda: street)
    plain.parts.actions["background_pictures"].trigger()
    canvas = bridge.document.canvas
    assert (canvas.width_px, canvas.height_px) == (before.width_px, before.height_px)
    assert canvas.length_frames == max(before.length_frames, 4)
    plain.close_unasked()


def test_a_folder_that_is_dropped_is_a_character(plain: MainWindow, street: Path) -> None:
    plain.parts.project.bring([street])
    document = plain.parts.open_project.bridge.document
    assert [layer.name for layer in document.layers] == ["street"]
    assert document.background is None
    plain.close_unasked()
