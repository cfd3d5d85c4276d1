"""Sets that take minutes a frame are said, once; of very many parts some are left out while someone works."""

from dataclasses import replace
from pathlib import Path

import pytest

from kagezou.document.set_pieces import add_piece
from kagezou.geometry.sets.measures import PieceKind
from kagezou.scene import heavy_sets
from kagezou.scene.evaluate import evaluate
from kagezou.scene.heavy_sets import beyond, heavy_notes, heavy_words, parts_of, too_many_at_hand
from kagezou.scene.pieces import PieceScene
from tests.scene.test_pieces import a_room
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


def stairs(*counts: int) -> tuple[PieceScene, ...]:
    document = a_room("wall")
    document = replace(document, pieces=())
    for number, count in enumerate(counts):
        document = add_piece(document, f"S{number}", PieceKind.STEPS, {"count": count})
    return evaluate(document, 1).pieces


def test_every_step_is_a_part() -> None:
    assert parts_of(stairs(3, 5)) == 8


def test_what_is_left_out_leaves_at_most_so_many_parts() -> None:
    pieces = stairs(3, 5, 4)
    assert [piece.name for piece in beyond(pieces, 8)] == ["S2"]
    assert [piece.name for piece in beyond(pieces, 7)] == ["S1", "S2"]
    assert beyond(pieces, 12) == ()


def test_what_is_left_out_is_named() -> None:
    pieces = stairs(9, 9, 9, 9, 9)
    words = str(too_many_at_hand(pieces, beyond(pieces, 9)))
    assert words.startswith("the set is made of 45 parts, more than the 250 that are drawn while you work")
    assert words.endswith("S1, S2, S3, …")
