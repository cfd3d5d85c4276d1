"""Which tracks an edit changed, and whether it changed anything else."""

from dataclasses import replace
from pathlib import Path

import pytest

from kagezou.document import properties
from kagezou.document.address import Address, addresses, track_of
from kagezou.document.changes import tracks_changed
from kagezou.document.edits import add_layer, set_canvas, set_constant, set_key
from kagezou.document.linking import link
from kagezou.document.model import Document
from kagezou.document.properties import OF_PIECE
from kagezou.document.set_pieces import add_piece
from kagezou.geometry.sets.measures import PieceKind
from tests.render.reference.figures import standing


@pytest.fixture
def document() -> Document:
    """Two characters and a wall."""
    one = standing(Path("figure.png"))
    two = add_layer(one, "B", one.layers[0].cels, one.layers[0].figure)
    return add_piece(two, "wall", PieceKind.WALL, {})


def test_what_stays_has_changed_nothing(document: Document) -> None:
    assert tracks_changed(document, document) == frozenset()
    assert tracks_changed(document, replace(document, tracks=document.tracks)) == frozenset()


def test_every_property_is_told_by_its_address(document: Document) -> None:
    for address in addresses(document):
        value = track_of(document, address).value_at(1)
        edited = set_constant(document, address, value)
        keyed = set_key(edited, address, 3, value)
        assert tracks_changed(edited, keyed) == frozenset({address})
        assert tracks_changed(keyed, edited) == frozenset({address})


def test_several_owners_at_once(document: Document) -> None:
    wanted = {
        Address(properties.OPACITY, document.layers[0].id): 0.25,
        Address(properties.OPACITY, document.layers[1].id): 0.75,
        Address(properties.LIGHT_ELEVATION): 33.0,
        Address(OF_PIECE["angle"], piece_id=document.pieces[0].id): 12.0,
    }
    edited = document
    for address, value in wanted.items():
        edited = set_constant(edited, address, value)
    assert tracks_changed(document, edited) == frozenset(wanted)


def test_what_is_no_track_is_no_answer(document: Document) -> None:
    first = document.layers[0]
    others = (
        set_canvas(document, replace(document.canvas, length_frames=7)),
        replace(document, layers=(first,)),
        replace(document, pieces=()),
        replace(document, layers=(replace(first, name="other"), document.layers[1])),
        replace(document, work_area=(1, 2)),
        link(document, Address(properties.OPACITY, first.id)),
    )
    for other in others:
        assert tracks_changed(document, other) is None
