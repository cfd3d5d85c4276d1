"""Keys pulled by a frame around them: whole frames, their order, their values and the speeds of their eases."""

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.animation.ease import Ease
from kagezou.animation.track import Interpolation, Key, Track
from kagezou.document import edits, invariants, key_edits
from kagezou.document.address import Address, addresses, track_of
from kagezou.document.key_edits import KeyRef, Refs
from kagezou.document.model import Canvas, Document
from kagezou.document.properties import COLOR, GROUND_ROLL, LIGHT_POSITION
from kagezou.document.scale_edits import Scaling, landed, scale_keys
from tests.documents import documents

ROLL, LIGHT = Address(GROUND_ROLL), Address(LIGHT_POSITION)


@pytest.fixture
def document() -> Document:
    eases = (Ease(2.0, 0.5),)
    keys = tuple(Key(frame, value, Interpolation.BEZIER, eases, eases) for frame, value in ((5, 10.0), (9, 30.0)))
    return edits.set_track(Document(Canvas(100, 100, length_frames=48)), ROLL, Track(0.0, keys))


def rolled(document: Document) -> list[tuple[int, object]]:
    return [(key.frame, key.value) for key in track_of(document, ROLL).keys]


def both() -> Refs:
    return frozenset({KeyRef(ROLL, 5), KeyRef(ROLL, 9)})


def test_time_is_scaled_about_an_edge_and_the_speeds_follow(document: Document) -> None:
    scaled, refs = scale_keys(document, both(), Scaling(5, 2.0))
    assert rolled(scaled) == [(5, 10.0), (13, 30.0)]
    assert {ref.frame for ref in refs} == {5, 13}
    assert track_of(scaled, ROLL).keys[0].ease_out == (Ease(1.0, 0.5),)
    assert scale_keys(document, both(), Scaling(7, 1.0))[0] is document


def test_values_are_scaled_turned_over_and_kept_to_the_range(document: Document) -> None:
    half, _ = scale_keys(document, both(), values={(ROLL, 0): Scaling(10, 0.5)})
    assert rolled(half) == [(5, 10.0), (9, 20.0)]
    assert track_of(half, ROLL).keys[0].ease_in == (Ease(1.0, 0.5),)
    turned, _ = scale_keys(document, both(), values={(ROLL, 0): Scaling(20, -1)})
    assert rolled(turned) == [(5, 30.0), (9, 10.0)]
    far, _ = scale_keys(document, both(), values={(ROLL, 0): Scaling(20, 50)})
    assert rolled(far) == [(5, -90.0), (9, 90.0)]


def test_one_component_of_a_place_and_of_a_colour() -> None:
    document = Document(Canvas(100, 100, length_frames=48))
    for frame, value in ((1, (0.0, 5.0, 7.0)), (9, (10.0, 15.0, 17.0))):
        document = edits.set_key(document, LIGHT, frame, value)
    refs = key_edits.all_keys(document, LIGHT)
    scaled, _ = scale_keys(document, refs, values={(LIGHT, 1): Scaling(5, 3)})
    assert [key.value for key in track_of(scaled, LIGHT).keys] == [(0.0, 5.0, 7.0), (10.0, 35.0, 17.0)]
    assert Address(COLOR).property.components == ("red", "green", "blue")


def test_pressed_together_keys_lie_side_by_side() -> None:
    assert landed([1, 5, 9], Scaling(1, 0.0)) == [1, 2, 3]
    assert landed([1, 5, 9], Scaling(9, -3.0)) == [7, 8, 9]
    assert landed([1, 5, 9], Scaling(5, 0.0)) == [4, 5, 6]
    assert landed([3, 5, 9], Scaling(9, 100.0)) == [1, 4, 9], "never before the first frame"
    assert landed([], Scaling(1, 2.0)) == []


ordered_frames = st.sets(st.integers(1, 300), min_size=1, max_size=12).map(sorted)


@given(ordered_frames, st.floats(1, 300), st.floats(-2, 20))
def test_frames_stay_in_order_and_apart(frames: list[int], about: float, factor: float) -> None:
    places = landed(frames, Scaling(about, factor))
    assert places[0] >= 1
    assert all(after > before for before, after in pairwise(places))
    assert landed(frames, Scaling(about, 1.0)) == frames


@given(documents(), st.floats(1, 100), st.floats(-2, 4), st.floats(-2, 4))
def test_any_document_stays_sound_and_no_key_is_lost(document: Document, about: float, along: float, up: float) -> None:
    refs = frozenset().union(*(key_edits.all_keys(document, address) for address in addresses(document)))
    values = {(address, part): Scaling(3.0, up) for address in addresses(document) for part in range(8)}
    scaled, left = scale_keys(document, refs, Scaling(about, along), values)
    invariants.check(scaled)
    assert len(left) == len(refs)
