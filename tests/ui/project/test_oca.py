"""Documents of Open Cel Animation in the window: opened and dropped."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from kagezou.export.exchange.oca import OCA
from kagezou.ui.project.dropped_files import dropped_files_of
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.system.settings import Settings
from kagezou.ui.window.main_window import MainWindow
from tests.export.exchange.cuts import made, rich_cut
from tests.export.small_cuts import with_values
from tests.ui.viewing import OwnClipboard


@pytest.fixture
def plain(qtbot: QtBot, settings: Settings) -> Iterator[MainWindow]:  # noqa: ARG001 - makes the application
    window = MainWindow(OpenProject(), settings, OwnClipboard())
    yield window
    window.close_unasked()
    window.deleteLater()
    QApplication.processEvents()


@pytest.fixture
def oca(tmp_path: Path) -> Path:
    document = with_values(rich_cut(tmp_path / "in"), **{"layers.相棒.shadow.blend": "multiply"})
    written = made(document, tmp_path / "cut.oca", OCA).scene
    assert written is not None
    return written


@pytest.mark.parametrize("is_folder", [False, True])
def test_a_document_opens_the_window_with_it(plain: MainWindow, oca: Path, *, is_folder: bool) -> None:
    assert plain.parts.project.open_path(oca.parent if is_folder else oca)
    document = plain.parts.open_project.bridge.document
    assert [layer.name for layer in document.layers] == ["主役 #1", "相棒"]
    assert (document.canvas.length_frames, round(float(document.canvas.frame_rate), 3)) == (8, 23.976)
    assert plain.parts.open_project.path is None


def test_dropped_it_comes_as_layers_in_one_step(plain: MainWindow, cels: Path, oca: Path) -> None:
    assert [source.path for source in dropped_files_of([oca]).characters] == [oca]
    plain.parts.project.bring([cels])
    before = plain.parts.open_project.bridge.document
    plain.parts.project.bring([oca])
    document = plain.parts.open_project.bridge.document
    assert document.layers[0] is before.layers[0]
    assert [layer.name for layer in document.layers[1:]] == ["主役 #1", "相棒"]
    assert document.canvas.frame_rate == before.canvas.frame_rate, "what is open keeps its rate"
    assert document.canvas.box == before.canvas.box
    plain.parts.actions["undo"].trigger()
    assert plain.parts.open_project.bridge.document == before
