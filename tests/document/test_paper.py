"""Which white is clear in a layer's drawings."""

from dataclasses import replace
from pathlib import Path

import pytest

from kagezou.document import edits
from kagezou.document.invariants import check
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.document.paper import paper_of, set_paper, typed_paper
from kagezou.errors import ProjectProblem, UsageProblem
from kagezou.geometry.box import Box
from kagezou.picture_source import OutlinedPicture, Paper, PicturePart, file_of

CELS = Cels((Drawing("1", Path("/c/1.png")), Drawing("2", Path("/c/2.psd"), "figure")), (Exposure(1, 0),))


def cut() -> Document:
    return edits.add_layer(Document(Canvas(40, 30)), "A.1", CELS, Box(1, 1, 20, 20))


def test_all_drawings_of_a_layer_are_on_one_paper() -> None:
    document = set_paper(cut(), "layer-1", Paper.BORDER)
    check(document)
    assert paper_of(document.layers[0]) is Paper.BORDER
    sources = [drawing.source for drawing in document.layers[0].cels.drawings]
    assert sources == [OutlinedPicture(Path("/c/1.png")), PicturePart(Path("/c/2.psd"), "figure", Paper.BORDER)]
    assert [file_of(source) for source in sources] == [Path("/c/1.png"), Path("/c/2.psd")]
    assert set_paper(document, "layer-1", Paper.BORDER) is document
    assert set_paper(document, "layer-1", Paper.WHITE) == cut()
    assert cut().layers[0].cels.drawings[0].source == Path("/c/1.png")


def test_drawings_on_different_paper_are_refused() -> None:
    document = cut()
    first, second = document.layers[0].cels.drawings
    mixed = replace(CELS, drawings=(replace(first, paper=Paper.BORDER), second))
    with pytest.raises(ProjectProblem, match="different paper"):
        check(replace(document, layers=(replace(document.layers[0], cels=mixed),)))


def test_its_words() -> None:
    assert typed_paper("border") is Paper.BORDER
    with pytest.raises(UsageProblem, match="paper is one of white, border, not 7"):
        typed_paper(7)


def test_a_layer_without_drawings_is_on_usual_paper() -> None:
    assert paper_of(replace(cut().layers[0], cels=Cels())) is Paper.WHITE
