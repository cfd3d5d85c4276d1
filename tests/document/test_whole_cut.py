"""What is said of a layer once for the whole cut."""

from pathlib import Path

import pytest

from kagezou.document import edits
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.document.whole_cut import SaidOf, saying_at, sayings
from kagezou.errors import UsageProblem
from kagezou.geometry.box import Box

CELS = Cels((Drawing("1", Path("/c/1.png")),), (Exposure(1, 0),))


@pytest.fixture
def document() -> Document:
    document = Document(Canvas(40, 30))
    for name in ("A.1", "arm", "B"):
        document = edits.add_layer(document, name, CELS, Box(1, 1, 20, 20))
    return document


def said(document: Document, path: str) -> SaidOf:
    found = saying_at(document, path)
    assert found is not None
    return found


def test_every_layer_says_what_it_joins_and_its_paper(document: Document) -> None:
    assert [each.path for each in sayings(document)] == [
        f"layers.{name}.{word}"
        for name in ("A.1", "arm", "B")
        for word in ("joins", "paper", "locked", "solo", "label")
    ]
    assert saying_at(document, "layers.A.paper") is None
    assert saying_at(document, "layers.A.1.tilt") is None


def test_a_layer_may_join_every_figure_but_its_own(document: Document) -> None:
    assert said(document, "layers.arm.joins").choices == ("", "A.1", "B")
    joined = said(document, "layers.arm.joins").changed("A.1")
    assert said(joined, "layers.arm.joins").value == "A.1"
    assert said(joined, "layers.B.joins").choices == ("", "A.1")
    assert said(joined, "layers.arm.joins").changed("") == document
    for each in sayings(document):
        for word in each.choices:
            assert said(each.changed(word), each.path).value == word


def test_switches_are_taken_as_words_and_as_json(document: Document) -> None:
    for word in ("true", True):
        assert said(said(document, "layers.B.solo").changed(word), "layers.B.solo").value == "true"
    assert said(document, "layers.B.locked").changed("false") is document


def test_what_cannot_be_said_is_refused(document: Document) -> None:
    with pytest.raises(UsageProblem, match="no layer 'Nobody'"):
        said(document, "layers.arm.joins").changed("Nobody")
    with pytest.raises(UsageProblem, match="no layer 7"):
        said(document, "layers.arm.joins").changed(7)
    with pytest.raises(UsageProblem, match="paper is one of white, border, not 'grey'"):
        said(document, "layers.B.paper").changed("grey")
    with pytest.raises(UsageProblem, match="locked is true or false, not 'maybe'"):
        said(document, "layers.B.locked").changed("maybe")
    with pytest.raises(UsageProblem, match="no colour of a label"):
        said(document, "layers.B.label").changed(7)
    for each in sayings(document):
        with pytest.raises(UsageProblem, match="no keys"):
            each.changed(each.value, 3)
