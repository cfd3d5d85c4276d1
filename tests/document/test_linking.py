"""Linked properties: one track for all layers, whoever edits it, and each its own again afterwards."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.animation.track import Key, Track
from kagezou.document import edits, invariants, key_edits, linking
from kagezou.document.address import Address, addresses, track_of
from kagezou.document.key_edits import KeyRef
from kagezou.document.model import Canvas, Cels, Document
from kagezou.document.properties import GROUNDING, OPACITY, SIMPLIFY
from kagezou.errors import UsageProblem
from kagezou.geometry.box import Box
from tests.documents import documents

A, B = Address(OPACITY, "layer-1"), Address(OPACITY, "layer-2")


@pytest.fixture
def document() -> Document:
    two = Document(Canvas(100, 100, length_frames=48))
    for name in "AB":
        two = edits.add_layer(two, name, Cels(), Box(0, 0, 9, 9))
    two = edits.set_track(two, A, Track(0.6, (Key(5, 0.2), Key(9, 0.8))))
    return edits.set_constant(two, B, 0.3)


def test_all_layers_get_what_the_linked_one_has(document: Document) -> None:
    linked = linking.link(document, A)
    invariants.check(linked)
    assert track_of(linked, B) == track_of(document, A)
    assert linking.link(linked, B) is linked
    assert list(linking.twins(linked, B)) == [B, A]
    assert list(linking.twins(document, B)) == [B]


def test_every_edit_of_one_is_an_edit_of_all_until_it_is_unlinked(document: Document) -> None:
    linked = edits.set_value(linking.link(document, A), B, 0.5, 7)
    assert [key.frame for key in track_of(linked, A).keys] == [5, 7, 9]
    apart = edits.set_constant(linking.unlink(linked, OPACITY.name), B, 0.1)
    invariants.check(apart)
    assert track_of(apart, A).is_keyed
    assert track_of(apart, B) == Track(0.1)
    assert linking.unlink(apart, OPACITY.name) is apart


def test_keys_chosen_on_several_layers_move_once(document: Document) -> None:
    linked = linking.link(document, A)
    moved, refs = key_edits.move_keys(linked, frozenset({KeyRef(A, 5), KeyRef(B, 9)}), 4, {A: (0.1,), B: (0.1,)})
    assert [(key.frame, round(float(str(key.value)), 6)) for key in track_of(moved, B).keys] == [(9, 0.3), (13, 0.9)]
    assert refs == {KeyRef(each, frame) for each in (A, B) for frame in (9, 13)}


def test_a_new_layer_joins_the_link(document: Document) -> None:
    own = {OPACITY.name: Track(0.9), SIMPLIFY.name: Track(7.0)}
    more = edits.add_layer(linking.link(document, A), "C", Cels(), Box(0, 0, 9, 9), own)
    invariants.check(more)
    assert track_of(more, Address(OPACITY, "layer-3")) == track_of(document, A)
    assert track_of(more, Address(SIMPLIFY, "layer-3")) == Track(7.0)


def test_grounding_points_are_each_characters_own(document: Document) -> None:
    with pytest.raises(UsageProblem, match="grounding"):
        linking.link(document, Address(GROUNDING, "layer-1"))


@given(documents(), st.data())
def test_links_stay_whole_under_any_edit(document: Document, data: st.DataObject) -> None:
    of_layers = [each for each in addresses(document) if each.layer_id is not None]
    if not of_layers:
        return
    address = data.draw(st.sampled_from([each for each in of_layers if each.property.name in linking.LINKABLE]))
    linked = linking.link(document, address)
    invariants.check(linked)
    refs = frozenset().union(*(key_edits.all_keys(linked, each) for each in of_layers))
    chosen = frozenset(data.draw(st.sets(st.sampled_from(sorted(refs, key=str))))) if refs else refs
    for changed in (
        key_edits.move_keys(linked, chosen, data.draw(st.integers(-20, 20)))[0],
        key_edits.stretch_keys(linked, chosen, 10, data.draw(st.floats(0.1, 3)))[0],
        key_edits.remove_keys(linked, chosen),
        edits.set_value(linked, address, address.property.default, 3),
    ):
        invariants.check(changed)
