"""Sets of very many parts, of which some are left out while someone works."""

from dataclasses import replace

from kagezou.document.set_pieces import add_piece
from kagezou.geometry.sets.measures import PieceKind
from kagezou.scene.evaluate import evaluate
from kagezou.scene.pieces import PieceScene
from kagezou.scene.set_extent import beyond, parts_of, too_many_at_hand
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


def test_what_is_left_out_is_named() -> None:
    pieces = stairs(9, 9, 9, 9, 9)
    words = str(too_many_at_hand(pieces, beyond(pieces, 9)))
    assert words.startswith("the set is made of 45 parts, more than the 250 that are drawn while you work")
    assert words.endswith("S1, S2, S3, …")
