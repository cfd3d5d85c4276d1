"""A background of other sides offers its size, changes nothing by itself, and goes when it is answered."""

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from kagezou.ui.project.cut_settings_dialog import CutSettingsDialog
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.system.settings import Settings
from kagezou.ui.window.main_window import MainWindow
from tests.importing.cel_files import write_cel
from tests.ui.viewing import OwnClipboard

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def plain(qtbot: QtBot, settings: Settings, filled: OpenProject) -> MainWindow:
    """A window with a character on 240 × 200 px."""
    made = MainWindow(filled, settings, OwnClipboard())
    qtbot.addWidget(made, before_close_func=MainWindow.close_unasked)
    return made


def picture(tmp_path: Path, size: tuple[int, int], name: str = "street.png") -> Path:
    write_cel(tmp_path / name, size, (0, 0, *size))
    return tmp_path / name


def sides(window: MainWindow) -> tuple[int, int]:
    canvas = window.parts.bridge.document.canvas
    return (canvas.width_px, canvas.height_px)


def test_its_size_is_taken_by_a_button_and_the_drawings_stay_in_the_middle(
    qtbot: QtBot, plain: MainWindow, tmp_path: Path
) -> None:
    offer = plain.parts.files.canvas_offer
    assert offer.isHidden()
    plain.parts.project.put_background(picture(tmp_path, (480, 270)))
    assert not offer.isHidden()
    assert "480 × 270 px, the picture 240 × 200" in offer.words.text()
    assert sides(plain) == (240, 200), "nothing happens by itself"
    qtbot.mouseClick(offer.use, LEFT)
    assert sides(plain) == (480, 270)
    assert offer.isHidden()
    layer = plain.parts.bridge.document.layers[0]
    assert "position" not in layer.tracks
    plain.parts.bridge.session.undo()
    assert sides(plain) == (240, 200)


def test_the_settings_open_with_its_size(qtbot: QtBot, plain: MainWindow, tmp_path: Path) -> None:
    plain.parts.project.put_background(picture(tmp_path, (480, 400)))
    qtbot.mouseClick(plain.parts.files.canvas_offer.more, LEFT)
    (dialog,) = plain.findChildren(CutSettingsDialog)
    assert dialog.size_row.size_px == (480, 400)
    assert dialog.size_row.usual.currentText().startswith("The background")
    qtbot.mouseClick(dialog.refits.buttons()[2], LEFT)
    qtbot.mouseClick(dialog.agree, LEFT)
    assert sides(plain) == (480, 400)
    assert plain.parts.bridge.document.layers[0].tracks["scale"].constant == (200.0, 200.0)
    assert plain.parts.files.canvas_offer.isHidden()


def test_it_is_not_offered_where_there_is_nothing_to_choose(qtbot: QtBot, plain: MainWindow, tmp_path: Path) -> None:
    offer, project = plain.parts.files.canvas_offer, plain.parts.project
    project.put_background(picture(tmp_path, (240, 200)))
    assert offer.isHidden()
    project.put_background(picture(tmp_path, (300, 200), "other.png"))
    assert not offer.isHidden()
    qtbot.mouseClick(offer.close_button, LEFT)
    assert offer.isHidden()
    session = plain.parts.bridge.session
    session.go_to(3)
    plain.parts.actions["no_background"].trigger()
    assert offer.isHidden()
    project.put_background(tmp_path / "other.png")
    assert not offer.isHidden()
    session.undo()
    assert offer.isHidden(), "the background it was about is gone"


def test_the_first_picture_of_all_brings_its_size_without_a_question(
    qtbot: QtBot, settings: Settings, open_project: OpenProject, tmp_path: Path
) -> None:
    window = MainWindow(open_project, settings, OwnClipboard())
    qtbot.addWidget(window, before_close_func=MainWindow.close_unasked)
    window.parts.project.put_background(picture(tmp_path, (300, 170)))
    assert sides(window) == (300, 170)
    assert window.parts.files.canvas_offer.isHidden()
