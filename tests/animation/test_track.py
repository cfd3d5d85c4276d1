"""Tracks: values between, before and after keys."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.animation.ease import Ease
from kagezou.animation.track import Interpolation, Key, Track, Value, components_of, ordered

HOLD, LINEAR, BEZIER = Interpolation.HOLD, Interpolation.LINEAR, Interpolation.BEZIER


def between(first: Key, second: Key, frame: float) -> Value:
    return Track(first.value, (first, second)).value_at(frame)


def test_a_constant_is_the_same_everywhere() -> None:
    track = Track(0.5)
    assert not track.is_keyed
    assert track.value_at(1) == track.value_at(99) == 0.5
    assert track.key_at(1) is None


def test_values_are_held_before_the_first_and_after_the_last_key() -> None:
    track = Track(9.0, (Key(5, 1.0), Key(10, 2.0)))
    assert track.is_keyed
    assert (track.value_at(1), track.value_at(5), track.value_at(10), track.value_at(99)) == (1.0, 1.0, 2.0, 2.0)


def test_hold_linear_and_bezier() -> None:
    end = Key(5, 10.0)
    assert between(Key(1, 0.0, HOLD), end, 4.9) == 0.0
    assert between(Key(1, 0.0, LINEAR), end, 2) == 2.5
    assert between(Key(1, 0.0, BEZIER), end, 3) == pytest.approx(5.0)
    assert between(Key(1, 0.0, BEZIER), end, 2) == pytest.approx(1.5625)
    assert between(Key(1, 0.0, BEZIER, ease_out=(Ease(2.5),)), Key(5, 10.0, ease_in=(Ease(2.5),)), 2) == pytest.approx(
        2.5
    )


def test_only_the_first_key_decides_how_a_value_goes_on() -> None:
    assert between(Key(1, 0.0, LINEAR), Key(5, 10.0, HOLD), 3) == 5.0


def test_points_move_by_component() -> None:
    assert between(Key(1, (0.0, 10.0)), Key(3, (4.0, 30.0)), 2) == (2.0, 20.0)
    start, end = Key(1, ((0.0, 0.0), (10.0, 0.0))), Key(3, ((2.0, 2.0), (20.0, 4.0)))
    assert between(start, end, 2) == ((1.0, 1.0), (15.0, 2.0))
    eased = Key(1, (0.0, 0.0), BEZIER, ease_out=(Ease(5.0), Ease(0.0)))
    value = between(eased, Key(5, (10.0, 10.0)), 2)
    assert isinstance(value, tuple)
    x, y = value
    assert isinstance(x, float)
    assert isinstance(y, float)
    assert x > y


def test_colours_move_through_srgb() -> None:
    assert between(Key(1, "#000000"), Key(3, "#FF8001"), 2) == "#804000"
    overshooting = Key(1, "#F0F0F0", BEZIER, ease_out=(Ease(200.0),) * 3)
    assert between(overshooting, Key(5, "#FFFFFF"), 2) == "#FFFFFF"


@pytest.mark.parametrize(
    ("start", "end"),
    [
        (True, False),
        ("multiply", "normal"),
        ("#12345", "#123456"),
        ((), ((1.0, 2.0),)),
        (((1.0, 2.0),), ((1.0, 2.0), (3.0, 4.0))),
    ],
)
def test_what_cannot_move_is_held(start: Value, end: Value) -> None:
    assert between(Key(1, start), Key(5, end), 4) == start


def test_components() -> None:
    assert components_of(value=True) is None
    assert components_of(1.5) == (1.5,)
    assert components_of("#0A10FF") == (10.0, 16.0, 255.0)
    assert components_of("normal") is None
    assert components_of(()) == ()
    assert components_of(((1.0, 2.0), (3.0, 4.0))) == (1.0, 2.0, 3.0, 4.0)


def test_an_empty_list_of_points_stays_one() -> None:
    assert between(Key(1, ()), Key(5, ()), 3) == ()


def test_adding_and_taking_keys() -> None:
    track = Track(0.5).with_key(Key(5, 1.0)).with_key(Key(2, 0.0)).with_key(Key(5, 3.0))
    assert [(key.frame, key.value) for key in track.keys] == [(2, 0.0), (5, 3.0)]
    assert track.key_at(5) == Key(5, 3.0)
    assert track.without_key(2) == Track(0.5, (Key(5, 3.0),))
    assert track.without_key(2).without_key(5) == Track(3.0)
    assert track.without_key(99) == track
    assert Track(0.5).without_key(1) == Track(0.5)


def test_many_keys_at_once_come_as_one_after_the_other_do() -> None:
    keys = (Key(5, 1.0), Key(2, 0.0), Key(5, 3.0), Key(9, 2.0))
    track = Track(0.5, (Key(2, 7.0), Key(7, 7.0)))
    one_by_one = track
    for key in keys:
        one_by_one = one_by_one.with_key(key)
    assert track.with_keys(keys) == one_by_one
    assert track.with_keys(()) == track


floats = st.floats(-1e3, 1e3)
key_lists = st.dictionaries(st.integers(1, 100), st.tuples(floats, st.sampled_from(Interpolation)), min_size=1).map(
    lambda table: [Key(frame, value, kind) for frame, (value, kind) in table.items()]
)


@given(key_lists, st.floats(0, 101))
def test_easy_curves_stay_within_their_keys(keys: list[Key], frame: float) -> None:
    track = Track(0.0, ordered(keys))
    numbers = [key.value for key in keys if isinstance(key.value, float)]
    value = track.value_at(frame)
    assert isinstance(value, float)
    assert min(numbers) - 1e-6 <= value <= max(numbers) + 1e-6


@given(key_lists)
def test_keys_stay_in_order_however_they_come(keys: list[Key]) -> None:
    track = Track(0.0)
    for key in keys:
        track = track.with_key(key)
        frames = [each.frame for each in track.keys]
        assert frames == sorted(set(frames))
    assert track.keys == ordered(keys)
    for key in keys:
        assert track.value_at(key.frame) == key.value
        track = track.without_key(key.frame)
    assert not track.is_keyed
