"""Edits of the set: what comes, goes and is renamed, and what a document refuses."""

from dataclasses import replace
from pathlib import Path
from types import MappingProxyType

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.animation.track import Interpolation, Track
from kagezou.document.address import Address, path_of, resolve, track_of, value_of
from kagezou.document.edits import remove_key, set_constant, set_key
from kagezou.document.invariants import check
from kagezou.document.model import Canvas, Document, Piece
from kagezou.document.piece_kinds import kind_of
from kagezou.document.properties import GROUND_POSITION, OF_PIECE
from kagezou.document.set_pieces import MAX_PIECES, add_piece, copy_piece, remove_piece, rename_piece
from kagezou.document.set_properties import GROUND_RECEIVES
from kagezou.errors import ProjectProblem, UsageProblem
from kagezou.geometry.sets.measures import PieceKind
from tests.documents import documents

EMPTY = set_constant(Document(Canvas(1000, 800)), Address(GROUND_POSITION), [500, 700])


@given(documents(), st.sampled_from(PieceKind), st.text(st.characters(codec="utf-8"), max_size=20))
def test_pieces_come_and_go(document: Document, kind: str, name: str) -> None:
    try:
        added = add_piece(document, name, kind)
    except UsageProblem:
        assert not name.strip() or not name.isprintable() or name == "shadow"
        return
    check(added)
    piece = added.pieces[-1]
    assert kind_of(piece) == kind
    assert piece.id not in {each.id for each in document.pieces}
    assert remove_piece(added, piece.id) == document
    twin = copy_piece(added, piece.id)
    check(twin)
    assert twin.pieces[-1].tracks == piece.tracks
    assert twin.pieces[-1].name != piece.name


def test_a_new_piece_stays_where_a_piece_may_be_however_far_away_the_ground_is() -> None:
    far = set_constant(EMPTY, Address(GROUND_POSITION), [0.0, -999_999.0])
    (piece,) = add_piece(far, "wall", PieceKind.WALL).pieces
    assert piece.tracks["position"].constant == (0.0, -1_000_000.0)


def test_a_new_piece_stands_behind_the_ground_line_in_a_natural_size() -> None:
    document = add_piece(EMPTY, "crate", "box", {"angle": 30, "casts": True})
    shown = {name: value_of(document, resolve(document, f"set.crate.{name}"), 1) for name in OF_PIECE}
    assert shown["position"] == (500.0, 652.0)
    assert shown["width"] == 200.0
    assert (shown["angle"], shown["casts"], shown["receives"]) == (30.0, True, True)
    again = add_piece(document, "crate", "wall")
    assert [piece.name for piece in again.pieces] == ["crate", "crate 2"]
    assert document.piece(document.pieces[0].id) is document.pieces[0]
    with pytest.raises(KeyError):
        document.piece("piece-9")


def test_names_are_checked() -> None:
    document = add_piece(add_piece(EMPTY, "a.b", "wall"), "b", "ramp")
    first = document.pieces[0].id
    assert rename_piece(document, first, "a.b") is document
    assert rename_piece(document, first, "塀").pieces[0].name == "塀"
    with pytest.raises(UsageProblem, match="already a set piece named 'b'"):
        rename_piece(document, first, "b")
    with pytest.raises(UsageProblem, match=r"set\.shadow is the shadow of the whole set"):
        rename_piece(document, first, "shadow")
    with pytest.raises(UsageProblem, match="1 to 200 printable characters"):
        add_piece(document, "\n", "wall")


def test_unknown_kinds_and_properties_are_refused() -> None:
    with pytest.raises(UsageProblem, match="cone"):
        add_piece(EMPTY, "x", "cone")
    with pytest.raises(UsageProblem, match="no property 'hight'"):
        add_piece(EMPTY, "x", "box", {"hight": 3})
    with pytest.raises(UsageProblem, match="width"):
        add_piece(EMPTY, "x", "box", {"width": -3})


def test_a_set_has_an_end() -> None:
    pieces = tuple(Piece(f"p{n}", f"p{n}") for n in range(MAX_PIECES))
    full = replace(EMPTY, pieces=pieces)
    for grow in (lambda: add_piece(full, "x", "box"), lambda: copy_piece(full, "p0")):
        with pytest.raises(UsageProblem, match="at most 200 pieces"):
            grow()


def test_properties_of_pieces_are_keyed_like_any() -> None:
    document = add_piece(EMPTY, "a.b", "wall")
    address = resolve(document, "set.a.b.angle")
    assert path_of(document, address) == "set.a.b.angle"
    moved = set_key(set_key(document, address, 1, 0), address, 11, 90, Interpolation.LINEAR)
    assert value_of(moved, address, 6) == pytest.approx(45.0)
    assert remove_key(remove_key(moved, address, 1), address, 11).pieces[0].tracks["angle"] == Track(90.0)
    assert set_constant(document, address, 0) is document
    with pytest.raises(UsageProblem, match="can only be held"):
        set_key(document, resolve(document, "set.a.b.casts"), 2, raw=True, interpolation=Interpolation.LINEAR)
    with pytest.raises(UsageProblem, match=r"did you mean set\.a\.b\.angle"):
        resolve(document, "set.a.b.angel")
    assert track_of(document, address) == Track(0.0)


def test_unsound_sets_are_told() -> None:
    one, other = Piece("p", "a"), Piece("p", "b")
    with pytest.raises(ProjectProblem, match="two pieces have the same id"):
        check(replace(EMPTY, pieces=(one, other)))
    with pytest.raises(ProjectProblem, match="two pieces have the same name"):
        check(replace(EMPTY, pieces=(one, replace(one, id="q"))))
    wrong = Piece("p", "a", MappingProxyType({"width": Track(-5.0)}))
    with pytest.raises(ProjectProblem, match=r"set\.a\.width: constant"):
        check(replace(EMPTY, pieces=(wrong,)))


def test_with_the_last_set_from_a_file_the_flat_ground_comes_back() -> None:
    document = Document(Canvas(640, 360))
    for name, source in (("a", Path("/a.glb")), ("b", Path("/b.glb")), ("wall", None)):
        document = add_piece(document, name, "mesh" if source else "wall", source=source)
    document = set_constant(document, Address(GROUND_RECEIVES), raw=False)
    first, second, wall = (piece.id for piece in document.pieces)
    assert value_of(remove_piece(document, wall), Address(GROUND_RECEIVES), 1) is False
    document = remove_piece(document, first)
    assert value_of(document, Address(GROUND_RECEIVES), 1) is False
    assert value_of(remove_piece(document, second), Address(GROUND_RECEIVES), 1) is True
