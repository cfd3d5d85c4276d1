"""Edits of many keys at once: what moves, what it meets, and that the rest stays as it was."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.animation.ease import EASY, Ease
from kagezou.animation.track import Interpolation, Key, Track
from kagezou.document import ease_edits, edits, invariants, key_edits
from kagezou.document.address import Address, addresses, track_of, value_of
from kagezou.document.key_edits import KeyRef, Refs
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.document.properties import COLOR, LIGHT_POSITION, OPACITY, VISIBLE
from kagezou.geometry.box import Box
from tests.documents import documents

LINEAR, HOLD, BEZIER = Interpolation.LINEAR, Interpolation.HOLD, Interpolation.BEZIER
LIGHT = Address(LIGHT_POSITION)


@pytest.fixture
def document() -> Document:
    cels = Cels((Drawing("1", Path("/c/1.png")),), (Exposure(1, 0),))
    two = Document(Canvas(100, 100, length_frames=48))
    for name in "AB":
        two = edits.add_layer(two, name, cels, Box(0, 0, 9, 9))
    opacity = Track(1.0, (Key(1, 0.2), Key(5, 0.4), Key(9, 0.8)))
    return edits.set_track(two, Address(OPACITY, "layer-1"), opacity)


@pytest.fixture
def opacity() -> Address:
    return Address(OPACITY, "layer-1")


def frames_of(document: Document, address: Address) -> list[int]:
    return [key.frame for key in track_of(document, address).keys]


def chosen(address: Address, *frames: int) -> Refs:
    return frozenset(KeyRef(address, frame) for frame in frames)


def every_key(document: Document) -> Refs:
    return frozenset().union(*(key_edits.all_keys(document, address) for address in addresses(document)))


def test_however_many_keys_are_pasted_each_property_is_written_once(
    document: Document, opacity: Address, monkeypatch: pytest.MonkeyPatch
) -> None:
    written: list[Address] = []

    def noting(document: Document, address: Address, track: Track) -> Document:
        written.append(address)
        return edits.set_track(document, address, track)

    monkeypatch.setattr(key_edits, "set_track", noting)
    other = Address(OPACITY, "layer-2")
    keys = [(address, Key(frame, 0.5)) for frame in range(1, 2001) for address in (opacity, other)]
    pasted, refs = key_edits.paste_keys(document, key_edits.KeyClip(1, tuple(keys)), 1)
    assert written == [opacity, other]
    assert len(track_of(pasted, other).keys) == 2000
    assert len(refs) == 4000


def test_moved_keys_push_away_what_they_land_on(document: Document, opacity: Address) -> None:
    moved, refs = key_edits.move_keys(document, chosen(opacity, 1), 4)
    assert frames_of(moved, opacity) == [5, 9]
    assert value_of(moved, opacity, 5) == 0.2
    assert refs == chosen(opacity, 5)


def test_keys_move_together_and_never_before_the_first_frame(document: Document, opacity: Address) -> None:
    moved, refs = key_edits.move_keys(document, chosen(opacity, 5, 9), -20)
    assert frames_of(moved, opacity) == [1, 5]
    assert refs == chosen(opacity, 1, 5)
    assert value_of(moved, opacity, 1) == 0.4


def test_moving_in_value_stays_within_the_range(document: Document, opacity: Address) -> None:
    moved, _ = key_edits.move_keys(document, chosen(opacity, 5, 9), 0, {opacity: (0.5,)})
    assert [key.value for key in track_of(moved, opacity).keys] == [0.2, 0.9, 1.0]
    color = Address(COLOR, "layer-1")
    keyed = edits.set_key(document, color, 3, "#F01000")
    redder, _ = key_edits.move_keys(keyed, chosen(color, 3), 0, {color: (32.0, -32.0)})
    assert value_of(redder, color, 3) == "#FF0000"


@given(documents(), st.integers(0, 500))
def test_there_and_back_is_where_it_was(document: Document, frames: int) -> None:
    refs = every_key(document)
    moved, there = key_edits.move_keys(document, refs, frames)
    invariants.check(moved)
    back, here = key_edits.move_keys(moved, there, -frames)
    assert (back, here) == (document, refs)


@given(documents(), st.integers(1, 1000), st.floats(0.1, 4))
def test_stretching_keeps_documents_sound(document: Document, about: int, factor: float) -> None:
    stretched, refs = key_edits.stretch_keys(document, every_key(document), about, factor)
    invariants.check(stretched)
    assert refs == every_key(stretched)


def test_stretching_spreads_about_its_frame_and_slows_the_eases(document: Document, opacity: Address) -> None:
    eased = ease_edits.set_ease(document, chosen(opacity, 9), (Ease(0.1),), None)
    stretched, refs = key_edits.stretch_keys(eased, chosen(opacity, 1, 5, 9), 1, 2.0)
    assert frames_of(stretched, opacity) == [1, 9, 17]
    assert refs == chosen(opacity, 1, 9, 17)
    assert track_of(stretched, opacity).keys[2].ease_in == (Ease(0.05),)
    for frame in range(1, 18):
        assert value_of(stretched, opacity, frame) == pytest.approx(value_of(eased, opacity, 1 + (frame - 1) / 2))


def test_of_two_keys_stretched_onto_one_frame_the_farther_stays(document: Document, opacity: Address) -> None:
    stretched, _ = key_edits.stretch_keys(document, chosen(opacity, 1, 5, 9), 1, 0.01)
    assert [(key.frame, key.value) for key in track_of(stretched, opacity).keys] == [(1, 0.8)]


def test_removing_the_last_keys_leaves_their_first_value(document: Document, opacity: Address) -> None:
    assert frames_of(key_edits.remove_keys(document, chosen(opacity, 5)), opacity) == [1, 9]
    assert track_of(key_edits.remove_keys(document, chosen(opacity, 1, 5, 9)), opacity) == Track(0.2)
    assert key_edits.remove_keys(document, chosen(opacity, 2)) is document


def test_pasted_keys_begin_at_the_frame_and_keep_their_distances(document: Document, opacity: Address) -> None:
    clip = key_edits.copy_keys(document, chosen(opacity, 5, 9))
    assert clip is not None
    pasted, refs = key_edits.paste_keys(document, clip, 20)
    assert frames_of(pasted, opacity) == [1, 5, 9, 20, 24]
    assert refs == chosen(opacity, 20, 24)
    same, _ = key_edits.paste_keys(document, clip, None)
    assert same is document


def test_keys_of_one_layer_can_be_pasted_onto_another(document: Document, opacity: Address) -> None:
    clip = key_edits.copy_keys(document, chosen(opacity, 1, 5))
    assert clip is not None
    pasted, refs = key_edits.paste_keys(document, clip, 3, onto="layer-2")
    other = Address(OPACITY, "layer-2")
    assert frames_of(pasted, other) == [3, 7]
    assert frames_of(pasted, opacity) == [1, 5, 9]
    assert refs == chosen(other, 3, 7)


def test_keys_of_a_layer_that_is_gone_are_not_pasted(document: Document, opacity: Address) -> None:
    keyed = edits.set_key(document, LIGHT, 2, (1.0, 2.0, 3.0))
    clip = key_edits.copy_keys(keyed, chosen(opacity, 1) | chosen(LIGHT, 2))
    assert clip is not None
    left = edits.remove_layer(keyed, "layer-1")
    pasted, refs = key_edits.paste_keys(left, clip, 10)
    assert refs == chosen(LIGHT, 11)
    assert frames_of(pasted, LIGHT) == [2, 11]


def test_nothing_is_copied_of_nothing(document: Document, opacity: Address) -> None:
    assert key_edits.copy_keys(document, chosen(opacity, 2)) is None


def test_interpolation_of_many_keys(document: Document, opacity: Address) -> None:
    visible = Address(VISIBLE, "layer-1")
    keyed = edits.set_key(document, visible, 1, raw=False)
    held = ease_edits.set_interpolation(keyed, chosen(opacity, 1, 5) | chosen(visible, 1), BEZIER)
    assert [key.interpolation for key in track_of(held, opacity).keys] == [BEZIER, BEZIER, LINEAR]
    assert track_of(held, opacity).keys[0].ease_out == (EASY,)
    assert track_of(held, visible) == track_of(keyed, visible)
    assert ease_edits.set_interpolation(held, chosen(opacity, 1), BEZIER) is held


def test_easing_one_side_leaves_the_other_end_of_the_segment_at_its_speed(document: Document, opacity: Address) -> None:
    eased = ease_edits.set_ease(document, chosen(opacity, 5), (EASY,), None)
    first, middle, last = track_of(eased, opacity).keys
    assert first.interpolation is BEZIER
    assert first.ease_out[0].speed == pytest.approx(0.05)
    assert middle.ease_in == (EASY,)
    assert middle.interpolation is LINEAR
    assert last == track_of(document, opacity).keys[2]
    leaving = ease_edits.set_ease(document, chosen(opacity, 5), None, (EASY,))
    first, middle, last = track_of(leaving, opacity).keys
    assert (first.interpolation, middle.interpolation) == (LINEAR, BEZIER)
    assert last.ease_in[0].speed == pytest.approx(0.1)


def test_turning_a_linear_segment_into_a_bezier_alone_does_not_bend_it(document: Document, opacity: Address) -> None:
    eased = ease_edits.set_ease(document, chosen(opacity, 5), (Ease(0.05),), (Ease(0.1),))
    for frame in range(1, 10):
        assert value_of(eased, opacity, frame) == pytest.approx(value_of(document, opacity, frame))


def test_an_ease_for_one_component_stands_for_all(document: Document) -> None:
    keyed = edits.set_key(document, LIGHT, 1, (0.0, 0.0, 10.0))
    keyed = edits.set_key(keyed, LIGHT, 11, (10.0, 20.0, 30.0))
    eased = ease_edits.set_ease(keyed, chosen(LIGHT, 1, 11), (EASY,), (EASY,))
    first, last = track_of(eased, LIGHT).keys
    assert first.ease_out == last.ease_in == (EASY,) * 3


def test_only_keys_that_are_there_are_present(document: Document, opacity: Address) -> None:
    refs = chosen(opacity, 1, 2, 5) | chosen(Address(OPACITY, "gone"), 1)
    assert key_edits.present_keys(document, refs) == chosen(opacity, 1, 5)
    whole = chosen(opacity, 1, 9)
    assert key_edits.present_keys(document, whole) is whole


def test_one_handle_of_one_component_alone_or_joined_with_its_other_side(document: Document) -> None:
    keyed = document
    for frame, x in ((1, 0.0), (11, 10.0), (21, 0.0)):
        keyed = edits.set_key(keyed, LIGHT, frame, (x, 0.0, 10.0), BEZIER)
    ref, ease = KeyRef(LIGHT, 11), Ease(2.0, 0.5)
    alone = ease_edits.set_handle(keyed, ref, 0, ease, before=True, joined=False)
    key = track_of(alone, LIGHT).keys[1]
    assert key.ease_in == (ease, EASY, EASY)
    assert key.ease_out == (EASY, EASY, EASY)
    joined = ease_edits.set_handle(keyed, ref, 0, ease, before=False, joined=True)
    key = track_of(joined, LIGHT).keys[1]
    assert key.ease_in == (Ease(2.0), EASY, EASY)
    assert key.ease_out == (ease, EASY, EASY)
    assert ease_edits.set_handle(keyed, KeyRef(LIGHT, 5), 0, ease, before=True, joined=False) is keyed


def test_linear_keys_are_linear_on_both_sides(document: Document, opacity: Address) -> None:
    eased = ease_edits.set_ease(document, chosen(opacity, 1, 5, 9), (EASY,), (EASY,))
    straight = ease_edits.set_interpolation(eased, chosen(opacity, 5), LINEAR)
    first, middle, last = track_of(straight, opacity).keys
    assert (first.interpolation, middle.interpolation) == (BEZIER, LINEAR)
    assert first.ease_out == (EASY,)
    speed = ease_edits.chord_speeds(first, middle)[0]
    assert middle.ease_in == (Ease(speed, 1 / 6),)
    assert last.ease_in == (EASY,)
    # The first key has nothing before it, and a held segment stays held.
    held = ease_edits.set_interpolation(eased, chosen(opacity, 1), HOLD)
    assert track_of(ease_edits.set_interpolation(held, chosen(opacity, 5), LINEAR), opacity).keys[1].ease_in == (EASY,)
