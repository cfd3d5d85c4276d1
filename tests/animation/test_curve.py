"""Curves as they are drawn: on the values of the track, with handles that lead back to their eases."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.animation.curve import (
    EaseHandle,
    component_count,
    ease_toward,
    handles_of,
    largest_steps,
    speed_line,
    speeds_at,
    value_line,
)
from kagezou.animation.ease import Ease
from kagezou.animation.track import Interpolation, Key, Track

HOLD, LINEAR, BEZIER = Interpolation.HOLD, Interpolation.LINEAR, Interpolation.BEZIER

eases = st.builds(Ease, st.floats(-20, 20), st.floats(0.01, 1))


@st.composite
def tracks(draw: st.DrawFn) -> Track:
    frames = sorted(draw(st.sets(st.integers(1, 60), min_size=1, max_size=5)))
    return Track(
        0.0,
        tuple(
            Key(frame, draw(st.floats(-100, 100)), draw(st.sampled_from(Interpolation)), (draw(eases),), (draw(eases),))
            for frame in frames
        ),
    )


@given(tracks())
def test_every_point_of_the_line_lies_on_the_track(track: Track) -> None:
    line = value_line(track, 0, 1, 60)
    assert line.frames[0] <= 1 or line.frames[0] == track.keys[0].frame
    assert (np.diff(line.frames) >= -1e-9).all()
    held = {key.frame for key in track.keys}
    for frame, value in zip(line.frames, line.values, strict=True):
        # Where a hold ends the line goes straight up, and has both values.
        if not any(abs(frame - each) < 1e-6 for each in held):
            assert value == pytest.approx(track.value_at(float(frame)), abs=1e-3)


@given(tracks())
def test_speeds_are_the_slopes_of_the_line(track: Track) -> None:
    values, speeds = value_line(track, 0, 1, 60), speed_line(track, 0, 1, 60)
    assert len(speeds.frames) <= len(values.frames)
    for index in range(len(track.keys)):
        before, after = speeds_at(track, index, 0)
        key = track.keys[index]
        if index == 0:
            assert before == 0
        if index + 1 == len(track.keys) or key.interpolation is HOLD:
            assert after == 0
        elif key.interpolation is BEZIER and key.ease_out[0].influence < 0.9:
            assert after == pytest.approx(key.ease_out[0].speed, rel=1e-3, abs=1e-3)


@given(tracks(), st.data())
def test_the_handle_of_an_ease_leads_back_to_it(track: Track, data: st.DataObject) -> None:
    index = data.draw(st.integers(0, len(track.keys) - 1))
    left, right = handles_of(track, index, 0)
    for handle, wanted in ((left, track.keys[index].ease_in), (right, track.keys[index].ease_out)):
        if handle is not None:
            found = ease_toward(track, index, 0, handle)
            assert found.influence == pytest.approx(wanted[0].influence, abs=1e-6)
            assert found.speed == pytest.approx(wanted[0].speed, abs=1e-3)


def test_no_handle_where_there_is_no_bezier() -> None:
    track = Track(0.0, (Key(1, 0.0, LINEAR), Key(5, 4.0, BEZIER), Key(9, 0.0, HOLD), Key(12, 1.0, BEZIER)))
    assert handles_of(track, 0, 0) == (None, None)
    assert handles_of(track, 1, 0)[0] is None
    assert handles_of(track, 1, 0)[1] == EaseHandle(5 + 4 / 3, 4.0)
    assert handles_of(track, 2, 0) == (EaseHandle(9 - 4 / 3, 0.0), None)
    assert handles_of(track, 3, 0) == (None, None)


def test_a_handle_stays_between_its_key_and_the_next() -> None:
    track = Track(0.0, (Key(1, 0.0, BEZIER), Key(5, 4.0, BEZIER), Key(9, 0.0)))
    assert ease_toward(track, 1, 0, EaseHandle(40.0, 4.0)) == Ease(0.0, 1.0)
    assert ease_toward(track, 1, 0, EaseHandle(5.0, 8.0)).influence == 0.001
    assert ease_toward(track, 1, 0, EaseHandle(3.0, 2.0)) == Ease(1.0, 0.5)


def test_each_kind_of_key_goes_on_to_the_next_in_its_own_way() -> None:
    track = Track(0.0, (Key(1, 0.0, LINEAR), Key(5, 4.0, HOLD), Key(9, 0.0, BEZIER), Key(12, 6.0, BEZIER)))
    values, speeds = value_line(track, 0, 0, 12), speed_line(track, 0, 0, 12)
    ways = [(0, 0), (1, 0), (1, 0), (5, 4), (5, 4), (9, 4), (9, 0)]
    assert list(zip(values.frames[: len(ways)], values.values, strict=False)) == ways
    steps = [(0, 0), (1, 0), (1, 1), (5, 1), (5, 0), (9, 0)]
    assert list(zip(speeds.frames[: len(steps)], speeds.values, strict=False)) == steps
    assert (values.frames[-1], values.values[-1]) == (12, 6)
    # Eases at rest: it leaves and arrives standing still, and is steepest half-way.
    eased = speeds.values[speeds.frames > 9]
    assert eased[-1] == pytest.approx(0.0, abs=1e-9)
    assert eased.max() == pytest.approx(eased[np.argmin(np.abs(speeds.frames[speeds.frames > 9] - 10.5))], abs=1e-9)
    assert [speeds_at(track, index, 0) for index in range(3)] == [(0.0, 1.0), (1.0, 0.0), (0.0, 0.0)]


def test_a_constant_is_a_level_line() -> None:
    line = value_line(Track((3.0, 7.0)), 1, 1, 24)
    assert (line.frames.tolist(), line.values.tolist()) == ([1, 24], [7, 7])
    assert speed_line(Track(3.0), 0, 1, 24).values.tolist() == [0, 0]


def test_components_are_counted_where_all_values_have_as_many() -> None:
    assert component_count(Track(1.0)) == 1
    assert component_count(Track((1.0, 2.0, 3.0), (Key(1, (0.0, 0.0, 0.0)),))) == 3
    points = ((1.0, 2.0),)
    assert component_count(Track(points, (Key(1, points), Key(2, (*points, (3.0, 4.0)))))) == 0
    assert component_count(Track("sun")) == 0


def test_the_way_from_frame_to_frame() -> None:
    track = Track((0.0, 0.0), (Key(1, (0.0, 0.0), HOLD), Key(3, (3.0, 4.0))))
    assert largest_steps(track, 1, 4) == ((2, 0.0), (3, 5.0), (4, 0.0))
    assert largest_steps(Track("a", (Key(1, "a", HOLD), Key(2, "b", HOLD))), 1, 2) == ((2, 0.0),)
    growing = Track((), (Key(1, (), HOLD), Key(2, ((1.0, 1.0),), HOLD)))
    assert largest_steps(growing, 1, 3) == ((3, 0.0),)
