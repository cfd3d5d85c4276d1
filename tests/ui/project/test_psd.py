"""PSD files in the window: opened, dropped, imported, and as a background."""

from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from kagezou.importing.found_characters import whole_of
from kagezou.picture_source import PicturePart
from kagezou.ui.project.dialogs import Answer
from kagezou.ui.project.dropped_files import dropped_files_of
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.system.settings import Settings
from kagezou.ui.window.main_window import MainWindow
from tests.psd_files import SIZE, Folder, Leaf, block, write_psd
from tests.ui.viewing import OwnClipboard


@pytest.fixture
def plain(qtbot: QtBot, settings: Settings) -> MainWindow:
    made = MainWindow(OpenProject(), settings, OwnClipboard())
    qtbot.addWidget(made)
    return made


@pytest.fixture
def psd(tmp_path: Path) -> Path:
    cels = [Leaf(str(number), block(12, 24), (18 + number, 10), is_visible=number == 1) for number in (1, 2, 3)]
    return write_psd(tmp_path / "hero_01.psd", [Leaf("BG", block(*SIZE)), Folder("Hero", cels)])


def test_a_psd_file_opens_the_window_with_it(plain: MainWindow, psd: Path) -> None:
    assert plain.parts.project.open_path(psd)
    document = plain.parts.open_project.bridge.document
    assert [layer.name for layer in document.layers] == ["Hero"]
    assert (document.canvas.width_px, document.canvas.length_frames) == (SIZE[0], 3)
    assert plain.parts.open_project.path is None
    assert not plain.parts.open_project.is_saved
    plain.close_unasked()


def test_opened_it_takes_the_place_of_the_project(
    plain: MainWindow, cels: Path, psd: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plain.parts.project.bring([cels])
    monkeypatch.setattr(plain.parts.project.dialogs, "unsaved", lambda _name: Answer.DISCARD)
    monkeypatch.setattr(plain.parts.project.dialogs, "project_to_open", lambda: psd)
    plain.parts.actions["open"].trigger()
    assert [layer.name for layer in plain.parts.open_project.bridge.document.layers] == ["Hero"]
    plain.close_unasked()


def test_dropped_on_a_project_it_comes_as_layers_in_one_step(plain: MainWindow, cels: Path, psd: Path) -> None:
    plain.parts.project.bring([cels])
    before = plain.parts.open_project.bridge.document
    plain.parts.project.bring([psd])
    document = plain.parts.open_project.bridge.document
    assert document.layers[0] is before.layers[0]
    assert document.layers[1].name == "Hero"
    assert document.background == PicturePart(psd, "BG")
    plain.parts.open_project.bridge.session.undo()
    assert plain.parts.open_project.bridge.document is before
    plain.close_unasked()


def test_a_picked_file_is_taken_whole_and_a_background_is_its_composite(
    plain: MainWindow, psd: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(plain.parts.project.dialogs, "pictures", lambda: [psd])
    plain.parts.project.import_pictures()
    assert [len(layer.cels.drawings) for layer in plain.parts.open_project.bridge.document.layers] == [3]
    monkeypatch.setattr(plain.parts.project.dialogs, "background", lambda: psd)
    plain.parts.actions["background"].trigger()
    assert plain.parts.open_project.bridge.document.background == psd
    plain.close_unasked()


def test_numbered_psd_files_are_no_sequence(psd: Path) -> None:
    other = psd.with_name("hero_02.psd")
    assert [source.path for source in whole_of(psd).sources] == [psd]
    assert [source.path for source in dropped_files_of([psd, other]).characters] == [psd, other]


def test_a_broken_file_is_one_sentence(plain: MainWindow, tmp_path: Path) -> None:
    (tmp_path / "a.psd").write_bytes(b"8BPS\0\1")
    assert not plain.parts.project.open_path(tmp_path / "a.psd")
    assert "the file is cut short" in plain.parts.bar.text
    assert plain.parts.open_project.is_blank
    plain.close_unasked()
