"""A new set piece is seen, stands beside the figure or behind it, and never on another one."""

from math import radians, sin

from hypothesis import given, settings
from hypothesis import strategies as st

from kagezou.document import properties as p
from kagezou.document import set_properties as s
from kagezou.document.address import Address, value_of
from kagezou.document.invariants import check
from kagezou.document.model import Canvas, Document
from kagezou.document.piece_kinds import BUILT_KINDS
from kagezou.document.property import AnyProperty
from kagezou.geometry.sets.measures import PieceKind
from kagezou.scene.evaluate import evaluate
from kagezou.tools.placing import NewPiece, add_placed
from tests.effort import tries
from tests.tools.tool_scenes import LAYER, document_with


def value(document: Document, piece_id: str, prop: AnyProperty) -> object:
    return value_of(document, Address(prop, piece_id=piece_id), 1)


def point(document: Document, piece_id: str) -> tuple[float, float]:
    found = value(document, piece_id, s.PIECE_POSITION)
    assert isinstance(found, tuple)
    x, y = (part for part in found if isinstance(part, float))
    return (x, y)


@settings(max_examples=tries(20, 60))
@given(
    st.sampled_from(BUILT_KINDS),
    st.one_of(st.just(0.0), st.floats(10, 70)),
    st.floats(-25, 25),
    st.floats(20, 80),
    st.floats(300, 700),
)
def test_a_new_piece_stands_on_the_canvas(
    kind: PieceKind, fov: float, roll: float, declination: float, x: float
) -> None:
    document = document_with(
        (p.FOV, fov), (p.GROUND_ROLL, roll), (p.GROUND_DECLINATION, declination), (p.GROUND_POSITION, (x, 900.0))
    )
    document, piece_id = add_placed(document, 1, LAYER, NewPiece(kind, "New"))
    check(document)
    at_x, at_y = point(document, piece_id)
    assert 0 <= at_x <= 1000
    assert 0 <= at_y <= 1000
    assert len(evaluate(document, 1).pieces) == 1


def test_a_wall_spans_the_canvas_behind_the_figure_and_is_higher_than_it() -> None:
    document, piece_id = add_placed(document_with(), 1, LAYER, NewPiece(PieceKind.WALL, "Back"))
    width, height = (value(document, piece_id, prop) for prop in (s.PIECE_WIDTH, s.PIECE_HEIGHT))
    assert isinstance(width, float)
    assert isinstance(height, float)
    assert width >= 1000
    # Seen from 60 degrees above the ground, an upright is seen shorter.
    assert 700 < height * sin(radians(60)) < 1000
    x, y = point(document, piece_id)
    assert x == 500
    assert y < 900


def test_a_box_stands_where_the_shadow_falls_if_there_is_room() -> None:
    for lamp, side in (((-400.0, 100.0, 600.0), 1), ((1400.0, 100.0, 600.0), -1)):
        document, piece_id = add_placed(
            document_with((p.LIGHT_POSITION, lamp)), 1, LAYER, NewPiece(PieceKind.BOX, "Box")
        )
        assert (point(document, piece_id)[0] - 500) * side > 100


def test_pieces_do_not_stand_in_one_another() -> None:
    document, places = document_with(), []
    for _ in range(4):
        document, piece_id = add_placed(document, 1, LAYER, NewPiece(PieceKind.BOX, "Box"))
        places.append(point(document, piece_id))
    assert len(set(places)) == 4


def test_without_a_character_and_on_a_ground_seen_edge_on_there_is_a_piece_still() -> None:
    bare, _ = add_placed(Document(Canvas(800, 600)), 1, None, NewPiece(PieceKind.BOX, "Box"))
    edge_on, _ = add_placed(document_with((p.GROUND_DECLINATION, 90.0)), 1, None, NewPiece(PieceKind.WALL, "Wall"))
    for document in (bare, edge_on):
        check(document)
        assert len(document.pieces) == 1
