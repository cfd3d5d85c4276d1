"""The small picture of a project is drawn small: what it costs does not grow with the canvas."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from kagezou.document.model import Canvas, Document
from kagezou.document.set_pieces import add_piece
from kagezou.export import small_first_frame as module
from kagezou.export.small_first_frame import LONGEST_PX, fineness, first_frame
from kagezou.geometry.sets.measures import PieceKind
from kagezou.io.images.smaller_cels import SmallerCels
from kagezou.render.gpu import targets
from kagezou.render.gpu.context import open_headless_context
from kagezou.ui.project.open_project import OpenProject


@pytest.fixture
def context() -> Iterator[None]:
    with open_headless_context():
        yield


@pytest.fixture
def sizes(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """The pixels of every texture that is made."""
    made: list[int] = []
    real = targets.Texture.__init__

    def noting(self: targets.Texture, width: int, height: int, form: targets.Format) -> None:
        made.append(width * height)
        real(self, width, height, form)

    monkeypatch.setattr(targets.Texture, "__init__", noting)
    return made


@pytest.mark.parametrize("side", [1, 2, 1023, 1024, 1025, 1080, 1920, 4095, 4096, 9973, 16383, 16384])
@pytest.mark.parametrize("other", [1, 720, 1081, 16384])
def test_every_canvas_can_be_made_small(side: int, other: int) -> None:
    divisor, across, down = fineness(Canvas(side, other))
    sides = (side + 2 * across, other + 2 * down)
    assert all(each % divisor == 0 for each in sides)
    assert max(sides) // divisor <= LONGEST_PX + 2
    assert (divisor, across, down) == (1, 0, 0) or max(side, other) > LONGEST_PX


@pytest.mark.usefixtures("context")
def test_the_largest_canvas_is_drawn_as_a_small_one(filled: OpenProject, sizes: list[int]) -> None:
    document = replace(filled.bridge.document, canvas=Canvas(16384, 16384, length_frames=6))
    picture = first_frame(document)
    assert picture is not None
    assert picture.shape == (1024, 1024, 4)
    assert max(sizes) <= 1024 * 1024
    figure = np.flatnonzero((picture[..., :3] < 250).any(axis=(1, 2)))
    assert figure.size, "the figure is seen"


@pytest.mark.usefixtures("context")
def test_a_usual_canvas_is_drawn_as_it_is(filled: OpenProject) -> None:
    picture = first_frame(filled.bridge.document)
    canvas = filled.bridge.document.canvas
    assert picture is not None
    assert picture.shape == (canvas.height_px, canvas.width_px, 4)


def test_what_is_large_once_decoded_is_not_read(filled: OpenProject, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "MOST_BYTES", 240 * 200 * 4 - 1)
    monkeypatch.setattr(SmallerCels, "cel", lambda *_: pytest.fail("it was read"))
    assert first_frame(filled.bridge.document) is None


def test_a_large_set_is_not_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "set.obj"
    file.write_text("# nothing")
    document = add_piece(Document(Canvas(64, 48)), "Box", PieceKind.BOX)
    document = replace(document, pieces=(replace(document.pieces[0], source=file),))
    monkeypatch.setattr(module, "_MOST_MESH_BYTES", 3)
    assert first_frame(document) is None
