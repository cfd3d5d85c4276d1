"""Sets that take minutes a frame are said, once."""

from pathlib import Path

import pytest

from kagezou.document.set_pieces import add_piece
from kagezou.scene import heavy_sets
from kagezou.scene.heavy_sets import heavy_notes, heavy_words
from tests.tools.tool_scenes import document_with


def test_many_faces_are_said_and_few_are_not(monkeypatch: pytest.MonkeyPatch) -> None:
    few = add_piece(document_with(), "stairs", "steps", {"count": 3})
    many = few
    for number in range(12):
        many = add_piece(many, f"stairs {number}", "steps", {"count": 40})
    assert heavy_words(few) is None
    assert heavy_words(many) is None, "half a second"
    monkeypatch.setattr(heavy_sets, "MAX_PAIRS", 100_000)
    assert heavy_words(few) is None
    words = heavy_words(many)
    assert str(words).startswith("the set pieces have 2898 flat faces: drawing a frame may take minutes")
    assert heavy_notes(few, many) == (words,)
    assert heavy_notes(many, many) == ()
    assert heavy_notes(many, add_piece(many, "one more", "box", {})) == ()
    assert heavy_notes(many, few) == ()


def test_imported_sets_have_no_faces_of_their_own(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(heavy_sets, "MAX_PAIRS", 0)
    assert heavy_words(add_piece(document_with(), "street", "mesh", {}, Path("street.glb"))) is None
    assert heavy_words(document_with()) is None
    assert heavy_words(add_piece(document_with(), "crate", "box", {})) is not None
