"""Sets of very many parts: left out while someone works, said before they are drawn, refused where they cannot be."""

from dataclasses import replace

import pytest

from kagezou.document.set_pieces import add_piece
from kagezou.errors import UsageProblem
from kagezou.geometry.sets.measures import PieceKind
from kagezou.scene.evaluate import evaluate
from kagezou.scene.pieces import PieceScene
from kagezou.scene.set_extent import MOST, MOST_AT_HAND, SLOW, beyond, check_extent, notes_on_extent, parts_of
from tests.scene.test_pieces import a_room


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


def test_a_set_that_takes_long_is_said_and_one_that_cannot_be_drawn_is_refused() -> None:
    (piece,) = stairs(40)
    few, many, endless = ((piece,) * (count // 40) for count in (SLOW, SLOW + 40, MOST + 40))
    assert notes_on_extent(few) == ()
    assert str(notes_on_extent(many)[0]) == f"the set is made of {SLOW + 40} parts: a picture may take minutes"
    check_extent(many)
    with pytest.raises(UsageProblem, match=f"the set is made of {MOST + 40} parts, more than the {MOST}"):
        check_extent(endless)
    assert parts_of(few) > MOST_AT_HAND
