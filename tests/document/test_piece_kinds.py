"""Every kind of set piece has a whole row in the table of traits, and the table is what pieces follow."""

import pytest

from kagezou.document.choice_labels import CHOICE_LABELS
from kagezou.document.model import Canvas, Document
from kagezou.document.piece_kinds import BUILT_KINDS, MEASURES, TRAITS, kind_of, matters
from kagezou.document.properties import OF_PIECE
from kagezou.document.set_pieces import add_piece
from kagezou.document.set_properties import (
    PIECE_ANGLE,
    PIECE_COUNT,
    PIECE_DEPTH,
    PIECE_HEIGHT,
    PIECE_KIND,
    PIECE_LEAN,
    PIECE_POSITION,
    PIECE_WIDTH,
)
from kagezou.geometry.sets.measures import PieceKind
from kagezou.geometry.sets.shapes import SHAPES

kinds = pytest.mark.parametrize("kind", PieceKind)


@kinds
def test_a_row_is_whole(kind: PieceKind) -> None:
    traits = TRAITS[kind]
    assert PIECE_KIND.canonical(kind.value) == kind
    assert CHOICE_LABELS[kind] == traits.label
    assert str(traits.label)
    assert traits.measures <= set(OF_PIECE.values())
    # What is built from measures has a shape, sizes for a new one and a width; what is not has none of them.
    assert (traits.first_sizes is None) == (SHAPES[kind] is None) == (kind not in BUILT_KINDS)
    assert (traits.first_sizes is None) == (PIECE_WIDTH not in traits.measures)
    if traits.first_sizes is not None:
        assert all(size > 0 for sizes in (traits.first_sizes.of_canvas, traits.first_sizes.of_figure) for size in sizes)
    if traits.rises_to_back:
        assert {PIECE_HEIGHT, PIECE_DEPTH} <= traits.measures


@kinds
def test_a_piece_is_of_the_kind_it_was_added_as(kind: PieceKind) -> None:
    (piece,) = add_piece(Document(Canvas(320, 200)), "it", kind).pieces
    assert kind_of(piece) is kind
    sizes = (PIECE_WIDTH, PIECE_HEIGHT, PIECE_DEPTH)
    assert {prop.name in piece.tracks for prop in sizes} == {kind in BUILT_KINDS}


def test_what_matters_for_which_kind() -> None:
    lean = {kind for kind in PieceKind if matters(PIECE_LEAN, kind)}
    deep = {kind for kind in PieceKind if matters(PIECE_DEPTH, kind)}
    high = {kind for kind in PieceKind if matters(PIECE_HEIGHT, kind)}
    assert lean == {PieceKind.WALL}
    assert deep == {PieceKind.BOX, PieceKind.STEPS, PieceKind.RAMP}
    assert high == {PieceKind.WALL, *deep, PieceKind.CYLINDER}
    assert {kind for kind in PieceKind if matters(PIECE_COUNT, kind)} == {PieceKind.STEPS}
    assert not any(matters(PIECE_ANGLE, kind) for kind in (PieceKind.CYLINDER, PieceKind.SPHERE))
    assert {PIECE_KIND, PIECE_POSITION}.isdisjoint(MEASURES)
    assert all(matters(PIECE_POSITION, kind) for kind in PieceKind)
