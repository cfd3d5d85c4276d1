"""Figures stand up as the set does, but for those of which somebody said how they stand."""

from pathlib import Path

from kagezou.document.address import resolve, value_of
from kagezou.document.edits import add_layer, join_layer, set_constant
from kagezou.document.invariants import check
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.document.set_pieces import stood_up, stood_up_notes
from kagezou.geometry.box import Box


def of_three() -> Document:
    """Return two figures, A and B, and an arm of A."""
    document = Document(Canvas(400, 300))
    for name in ("A", "B", "arm"):
        cels = Cels((Drawing("1", Path(f"{name}.png")),), (Exposure(1, 0),))
        document = add_layer(document, name, cels, Box(100, 50, 150, 250))
    return join_layer(document, "layer-3", "layer-1")


def upright(document: Document, name: str) -> object:
    return value_of(document, resolve(document, f"layers.{name}.upright"), 1)


def test_figures_without_a_word_of_their_own_stand_up_and_it_is_said_once() -> None:
    document = of_three()
    after = stood_up(document)
    check(after)
    assert [upright(after, name) for name in ("A", "B", "arm")] == [1, 1, 0]
    assert [str(note) for note in stood_up_notes(document, after)] == ["A, B: standing upright now, as the set does"]
    assert stood_up(after) is after
    assert stood_up_notes(after, after) == ()


def test_what_was_said_stays() -> None:
    document = of_three()
    # 0 is the default: said is what was set to anything before.
    said = set_constant(document, resolve(document, "layers.B.upright"), 0.5)
    said = set_constant(said, resolve(document, "layers.B.upright"), 0.0)
    assert [upright(stood_up(said), name) for name in ("A", "B")] == [1, 0]
    assert [upright(stood_up(document, {"layer-2"}), name) for name in ("A", "B")] == [0, 1]
