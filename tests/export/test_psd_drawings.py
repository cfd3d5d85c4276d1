"""Drawings within PSD files, exported: the same bytes as of pictures of their own."""

from pathlib import Path

import numpy as np
import pytest

from kagezou.document.model import Document
from kagezou.errors import InputProblem
from kagezou.export.after_effects.export import HandOffRequest, export_to_after_effects
from kagezou.export.farm import FarmRequest, write_bundle
from kagezou.export.request import ExportRequest
from kagezou.importing.staging import CharacterSource, new_document
from kagezou.io.images.reading import read_cel
from kagezou.io.images.writing import write_rgba
from kagezou.render.gpu.context import open_headless_context
from tests.export.small_cuts import export
from tests.psd_files import SIZE, Folder, Leaf, block, figure, on_canvas, write_psd

CELS = [Leaf(str(number), figure(number), (14 + 3 * number, 8), is_visible=number == 2) for number in (1, 2, 3)]
BACK = Leaf("BG", block(*SIZE, (90, 140, 200, 255)))


@pytest.fixture
def layered(tmp_path: Path) -> Document:
    path = write_psd(tmp_path / "cut.psd", [BACK, Folder("A", CELS)])
    return new_document([CharacterSource(None, path)]).document


@pytest.fixture
def single(tmp_path: Path) -> Document:
    (tmp_path / "A").mkdir()
    for leaf in CELS:
        write_rgba(tmp_path / "A" / f"{int(leaf.name):04d}.png", on_canvas(leaf))
    write_rgba(tmp_path / "bg.png", on_canvas(BACK))
    return new_document([CharacterSource("A", tmp_path / "A")], background=tmp_path / "bg.png").document


def test_frames_are_the_same_as_of_single_pictures(tmp_path: Path, layered: Document, single: Document) -> None:
    for name, document in (("layered", layered), ("single", single)):
        assert export(document, tmp_path / name, composite=True, workers=3).written == 6
    for path in sorted((tmp_path / "single").rglob("*.png")):
        other = tmp_path / "layered" / path.relative_to(tmp_path / "single")
        assert other.read_bytes() == path.read_bytes(), path.name


def test_an_edited_file_is_drawn_again_and_an_unchanged_one_is_not(tmp_path: Path, layered: Document) -> None:
    export(layered, tmp_path / "out")
    assert export(layered, tmp_path / "out", skip_existing=True).drawn == 0
    moved = [Leaf(leaf.name, leaf.pixels, (20, 9)) for leaf in CELS]
    write_psd(tmp_path / "cut.psd", [BACK, Folder("A", moved)])
    assert export(layered, tmp_path / "out", skip_existing=True).drawn == 3


def test_a_layer_that_is_gone_is_a_sentence(tmp_path: Path, layered: Document) -> None:
    write_psd(tmp_path / "cut.psd", [BACK, Folder("A", CELS[:2])])
    with pytest.raises(InputProblem, match=r"cut.psd \(A/3\): the drawing is missing"):
        export(layered, tmp_path / "out")
    assert not (tmp_path / "out").exists()
    write_psd(tmp_path / "cut.psd", [BACK, Folder("A", CELS[:1])])
    with pytest.raises(InputProblem, match=r"2 drawings are missing: .*cut.psd \(A/2\), .*cut.psd \(A/3\)"):
        export(layered, tmp_path / "out")
    assert export(layered, tmp_path / "out", keep_going=True).written == 1
    (tmp_path / "cut.psd").unlink()
    with pytest.raises(InputProblem, match="the drawing is missing"):
        export(layered, tmp_path / "out")


@pytest.mark.parametrize("copies", [True, False])
def test_after_effects_gets_the_cels_as_a_sequence(tmp_path: Path, layered: Document, *, copies: bool) -> None:
    request = HandOffRequest(folder=tmp_path / "ae", name="cut", copies=copies)
    export_to_after_effects(layered, request, open_headless_context, lambda _done, _all: None, lambda: False)
    for number, leaf in enumerate(CELS, start=1):
        cel = read_cel(tmp_path / "ae" / "characters" / "A" / f"A_{number:04d}.png")
        assert np.array_equal(cel.rgba, on_canvas(leaf))
    back = read_cel(tmp_path / "ae" / "background" / "background.png", white_is_clear=False)
    assert np.array_equal(back.rgba, on_canvas(BACK))
    assert "background/background.png" in (tmp_path / "ae" / "cut.jsx").read_text(encoding="utf-8")


def test_a_farm_is_told_the_file_once(tmp_path: Path, layered: Document) -> None:
    request = FarmRequest(project=tmp_path / "p.kage", export=ExportRequest(tmp_path / "out"))
    write_bundle(layered, request, tmp_path / "job")
    assert (tmp_path / "job" / "asset_references.json").read_text().count("cut.psd") == 1
