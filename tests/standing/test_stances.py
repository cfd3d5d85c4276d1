"""Which foot carries over time, the ground below each, and the height."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kagezou.standing.finding import found_feet
from kagezou.standing.foot import Verdict
from kagezou.standing.seen import Seen, SeenFoot, Stance
from kagezou.standing.stances import stances
from tests.effort import tries
from tests.standing.figures import GROUND, Pose, drawn, jump, run, seen, walk, walk_speed


def _right(poses: Sequence[Pose], result: Sequence[Stance], speed_px: float = 0.0) -> list[bool]:
    """Return for each drawing whether every foot that carries is planted, and no other is."""
    right = []
    for index, (pose, stance) in enumerate(zip(poses, result, strict=True)):
        carry = [foot[0] + index * speed_px for foot, carries in zip(pose.feet, pose.carry, strict=True) if carries]
        planted = [foot.place[0] for foot in stance.feet if foot.is_planted]
        near = np.abs(np.subtract.outer(carry, planted)) < 20
        right.append(bool(near.any(axis=1).all() and near.any(axis=0).all()))
    return right


@pytest.mark.parametrize("speed_px", [0.0, walk_speed(), -2 * walk_speed()])
def test_a_walk_on_the_spot_or_slid_across(speed_px: float) -> None:
    poses = walk(48)
    result = stances(seen(found_feet(drawn(poses)), speed_px=speed_px))
    assert sum(_right(poses, result, speed_px)) >= 46
    assert all(stance.lift_px == 0 for stance in result)
    assert sum(stance.doubt for stance in result) <= 7


def test_a_walk_on_twos_and_threes() -> None:
    for exposure, cycle in ((2, 12), (3, 8)):
        poses = walk(4 * cycle, cycle)
        result = stances(seen(found_feet(drawn(poses)), exposure=exposure))
        wrong = [stance for stance, right in zip(result, _right(poses, result), strict=True) if not right]
        assert len(wrong) <= len(poses) // 8
        assert all(stance.lift_px == 0 for stance in result)


@pytest.mark.parametrize("exposure", [1, 2, 3])
def test_a_walk_slid_on_ones_whatever_its_drawings_are_on(exposure: int) -> None:
    cycle = 24 // exposure
    poses, speed_px = walk(2 * cycle, cycle), walk_speed(cycle) / exposure
    found = found_feet(drawn(poses))
    moved = tuple(
        Seen(
            frame,
            300.0,
            tuple(
                SeenFoot(foot.track, (foot.place[0] + frame * speed_px, foot.place[1]))
                for foot in found[frame // exposure].feet
            ),
            frame // exposure,
        )
        for frame in range(len(poses) * exposure)
    )
    result = stances(moved)
    right = _right([poses[frame // exposure] for frame in range(len(moved))], result, speed_px)
    assert sum(right) >= 0.9 * len(right)
    assert all(stance.lift_px == 0 for stance in result)


RISES_PX = (0, 0, 0, 0, 12, 34, 52, 62, 64, 62, 52, 34, 12, 0, 0, 0)


@pytest.mark.parametrize(("exposure", "fps"), [(1, 24.0), (1, 12.0), (2, 24.0), (3, 60.0)])
def test_a_jump_is_in_the_air_exactly_while_it_is(exposure: int, fps: float) -> None:
    poses = jump(RISES_PX)
    result = stances(seen(found_feet(drawn(poses)), exposure=exposure), fps)
    assert all(_right(poses, result))
    assert [stance.lift_px for stance in result] == pytest.approx(RISES_PX, abs=1)
    assert all(foot.ground_row == pytest.approx(GROUND) for stance in result for foot in stance.feet)


@pytest.mark.parametrize("drawings", [1, 4])
def test_a_jump_of_drawings_that_are_moved(drawings: int) -> None:
    sequence = [
        Seen(frame, 300.0, (SeenFoot(0, (200.0 + 3 * frame, 350.0 - up)),), frame * drawings // len(RISES_PX))
        for frame, up in enumerate(RISES_PX)
    ]
    lifts = [stance.lift_px for stance in stances(sequence)]
    assert [bool(lift) for lift in lifts] == [up > 0 for up in RISES_PX]


def test_a_run_is_in_the_air_between_its_steps() -> None:
    poses = run(6)
    result = stances(seen(found_feet(drawn(poses))))
    assert all(_right(poses, result)[:-1])  # the last drawing is in the air, and nothing tells what comes
    flights = [index for index, stance in enumerate(result) if stance.lift_px > 0]
    assert flights == [index for index in range(35) if index % 6 >= 4]


def _sequence(places: Sequence[Sequence[tuple[int, float, float]]], height_px: float = 300.0) -> tuple[Seen, ...]:
    """Return a sequence on ones of (track, x, y) for each drawing."""
    return tuple(
        Seen(frame, height_px if feet else 0.0, tuple(SeenFoot(track, (x, y)) for track, x, y in feet))
        for frame, feet in enumerate(places)
    )


def _step(lifted: Sequence[float], low: float = 350.0) -> list[list[tuple[int, float, float]]]:
    """Return one foot that stands at x = 200, and another that goes from 170 to 260 on the rows ``lifted``."""
    xs = np.linspace(170, 260, len(lifted)).tolist()
    rest = [(0, 170.0, 350.0), (1, 200.0, low)]
    moving = [[(0, x, y), (1, 200.0, low)] for x, y in zip(xs, lifted, strict=True)]
    return [rest, rest, *moving, [(0, 260.0, 344.0), (1, 200.0, low)], [(0, 260.0, 344.0), (1, 200.0, low)]]


def test_ground_below_a_lifted_foot_goes_from_contact_to_contact() -> None:
    result = stances(_sequence(_step([335.0, 325.0, 322.0, 330.0])))
    rows = [next(foot for foot in stance.feet if foot.track == 0) for stance in result]
    assert [foot.is_planted for foot in rows] == [True, True, False, False, False, False, True, True]
    assert [foot.ground_row for foot in rows] == pytest.approx([350, 350, 348.8, 347.6, 346.4, 345.2, 344, 344])
    assert [stance.lift_px for stance in result] == [0.0] * 8


def test_ground_below_a_lifted_foot_goes_by_frames() -> None:
    sequence = _sequence(_step([335.0, 325.0, 322.0, 330.0]))
    late = tuple(
        Seen(each.frame + 2 * (each.frame > 2), each.height_px, each.feet) for each in sequence
    )  # the first lifted drawing is held for three frames
    rows = [stance.feet[0].ground_row for stance in stances(late)]
    assert rows[2] == pytest.approx(350 - 6 / 7)
    assert rows[3] == pytest.approx(350 - 6 * 4 / 7)


def test_before_the_first_contact_and_after_the_last_the_nearest_counts() -> None:
    places = [[(0, 100.0 + 12 * step, 300.0 + 10 * step), (1, 200.0, 352.0)] for step in range(5)]
    places += [[(0, 148.0, 346.0), (1, 200.0, 352.0)]] * 3
    places += [[(0, 148.0 - 12 * step, 346.0 - 10 * step), (1, 200.0, 352.0)] for step in range(1, 4)]
    rows = [stance.feet[0].ground_row for stance in stances(_sequence(places))]
    assert rows == pytest.approx([346.0] * 11, abs=7)
    assert rows[0] == rows[1]
    assert rows[-1] == rows[-2]


def test_a_foot_that_never_lands_has_the_ground_of_the_one_that_carries() -> None:
    places = [[(0, 100.0 + 5 * step, 280.0), (1, 200.0, 350.0 + step / 2)] for step in range(6)]
    for step, stance in enumerate(stances(_sequence(places))):
        assert [foot.is_planted for foot in stance.feet] == [False, True]
        assert stance.feet[0].ground_row == stance.feet[1].ground_row == 350 + step / 2


def test_ground_that_wanders_slowly_is_followed() -> None:
    rows = 350 + 20 * np.sin(np.arange(60) / 8)
    result = stances(_sequence([[(0, 200.0, row)] for row in rows.tolist()]))
    assert all(stance.feet[0].is_planted and stance.lift_px == 0 for stance in result)


def test_empty_cels_have_no_feet_and_ground_goes_on_in_time() -> None:
    places = _step([335.0, 325.0, 322.0, 330.0])
    whole = stances(_sequence(places))
    places[4] = []
    result = stances(_sequence(places))
    assert result[4] == Stance((), 0.0, doubt=False)
    assert [result[row].feet[0].ground_row for row in (2, 3, 5)] == [whole[row].feet[0].ground_row for row in (2, 3, 5)]


def test_only_empty_cels() -> None:
    assert stances(_sequence([[], [], []])) == (Stance((), 0.0, doubt=False),) * 3
    assert stances(()) == ()


def test_a_jump_onto_a_box_and_down_again_changes_the_ground() -> None:
    up = [(0, 200.0, 350.0)], [(0, 210.0, 320.0)], [(0, 225.0, 290.0)], [(0, 230.0, 280.0)]
    places = [*[up[0]] * 6, *up[1:], *[[(0, 230.0, 280.0)]] * 20, [(0, 245.0, 305.0)], *[[(0, 250.0, 350.0)]] * 6]
    result = stances(_sequence(places))
    in_air = [index for index, stance in enumerate(result) if not stance.feet[0].is_planted]
    assert in_air == [6, 7, 29]


def test_a_flight_at_the_end_or_the_beginning() -> None:
    rises = [(0, 200.0, 350.0)] * 4 + [(0, 200.0, 350.0 - up) for up in (15, 40, 60, 70)]
    falls = rises[::-1]
    for places, in_air in ((rises, range(4, 8)), (falls, range(4))):
        result = stances(_sequence([[foot] for foot in places]))
        assert [index for index, each in enumerate(result) if each.lift_px > 0] == list(in_air)
        assert [each.lift_px for each in result] == pytest.approx([350 - foot[2] for foot in places])


def test_the_lowest_foot_does_not_carry_while_it_slides_and_another_stays() -> None:
    result = stances(_sequence(_dips()))
    assert all([foot.is_planted for foot in stance.feet] == [False, True] for stance in result[1:-1])
    assert [stance.doubt for stance in result] == [False] * 8 + [True] * 4 + [False] * 8


def _dips() -> list[list[tuple[int, float, float]]]:
    """Return a far foot that stays on row 340, and a near one that swings by and is lower in four drawings."""
    rows = [310.0] * 8 + [345.0, 348.0, 348.0, 345.0] + [310.0] * 8
    return [[(0, 120.0 + 8 * step, row), (1, 220.0, 340.0)] for step, row in enumerate(rows)]


def test_a_held_drawing_stands_on_both_feet_that_are_level() -> None:
    sequence = [
        Seen(0, 300.0, (SeenFoot(0, (150.0, 350.0)), SeenFoot(1, (200.0, 320.0)))),
        Seen(2, 300.0, (SeenFoot(0, (152.0, 350.0)), SeenFoot(1, (260.0, 344.0)))),
        Seen(24, 300.0, (SeenFoot(0, (153.0, 350.0)), SeenFoot(1, (300.0, 310.0)))),
        Seen(26, 300.0, (SeenFoot(0, (153.0, 350.0)), SeenFoot(1, (330.0, 290.0)))),
    ]
    assert [sum(foot.is_planted for foot in each.feet) for each in stances(sequence)] == [1, 2, 1, 1]


def test_one_drawing_alone() -> None:
    feet = (SeenFoot(0, (150.0, 350.0)), SeenFoot(1, (200.0, 345.0)), SeenFoot(2, (260.0, 320.0)))
    (stance,) = stances([Seen(7, 300.0, feet)])
    assert [foot.is_planted for foot in stance.feet] == [True, True, False]
    assert [foot.ground_row for foot in stance.feet] == [350.0, 345.0, 350.0]


@pytest.mark.parametrize(("up_px", "carries"), [(5.0, True), (20.0, True), (29.0, True), (33.0, False)])
def test_a_far_foot_that_rests_with_the_near_one_carries(up_px: float, *, carries: bool) -> None:
    rest = [(0, 150.0, 350.0), (1, 200.0, 350.0 - up_px)]
    step = [(0, 150.0, 350.0), (1, 240.0, 320.0)], [(0, 150.0, 350.0), (1, 270.0, 300.0)]
    result = stances(_sequence([*[rest] * 40, *step]))
    assert [[foot.is_planted for foot in each.feet] for each in result[:40]] == [[True, carries]] * 40
    assert not any(each.doubt for each in result[:40])


def test_a_far_foot_must_rest_for_a_second() -> None:
    def planted(drawings: int) -> tuple[list[bool], list[bool]]:
        rest = [(0, 150.0, 350.0), (1, 200.0, 330.0)]
        moves = [[(0, 150.0, 350.0), (1, 200.0 + 9 * step, 330.0 - 9 * step)] for step in range(1, 5)]
        result = stances(_sequence([*moves[::-1], *[rest] * drawings, *moves]))[4 : 4 + drawings]
        return [each.feet[1].is_planted for each in result], [each.doubt for each in result]

    assert planted(10) == ([False] * 10, [False] * 10)
    assert planted(20) == ([False] * 20, [True] * 20)
    assert planted(30) == ([True] * 30, [True] * 30)
    assert planted(50) == ([True] * 50, [False] * 50)


def test_a_foot_that_is_held_up_uneasily_does_not_carry() -> None:
    places = [[(0, 150.0, 350.0), (1, 200.0 + 2 * (step % 2), 330.0)] for step in range(50)]
    assert not any(stance.feet[1].is_planted for stance in stances(_sequence(places)))


@pytest.mark.parametrize(("up_px", "doubt"), [(5.0, False), (20.0, True), (40.0, False)])
def test_one_drawing_alone_with_a_higher_foot_is_to_be_looked_at(up_px: float, *, doubt: bool) -> None:
    (stance,) = stances(_sequence([[(0, 150.0, 350.0), (1, 200.0, 350.0 - up_px)]]))
    assert stance.doubt == doubt


def _with(sequence: Sequence[Seen], row: int, verdicts: dict[int, Verdict]) -> tuple[Seen, ...]:
    feet = tuple(SeenFoot(foot.track, foot.place, verdicts.get(foot.track)) for foot in sequence[row].feet)
    return tuple(
        Seen(each.frame, each.height_px, feet) if index == row else each for index, each in enumerate(sequence)
    )


def test_a_person_wins_over_what_was_found() -> None:
    sequence = _sequence(_step([335.0, 325.0, 322.0, 330.0]))
    planted = stances(_with(sequence, 4, {0: Verdict.PLANTED}))
    assert [foot.is_planted for foot in planted[4].feet] == [True, True]
    assert planted[4].feet[0].ground_row == 322
    assert planted[3].feet[0].ground_row == pytest.approx(350 - 28 * 2 / 3)
    lifted = stances(_with(sequence, 4, {1: Verdict.LIFTED}))
    assert [foot.is_planted for foot in lifted[4].feet] == [False, False]
    assert lifted[4].lift_px == 0  # its own row is that of the ground
    none = stances(_with(sequence, 4, {1: Verdict.NONE}))
    assert [foot.track for foot in none[4].feet] == [0]


def test_another_foot_carries_where_a_person_lifted_the_lowest() -> None:
    sequence = _sequence([[(0, 170.0, 350.0), (1, 220.0, 340.0)]] * 3)
    (_, stance, _) = stances(_with(sequence, 1, {0: Verdict.LIFTED}))
    assert [foot.is_planted for foot in stance.feet] == [False, True]


def test_a_person_lifts_the_figure_and_brings_it_down() -> None:
    still = _sequence([[(0, 200.0, row)] for row in (350.0, 349.0, 347.0, 349.0, 350.0)])
    result = stances(_with(still, 2, {0: Verdict.LIFTED}))
    assert [stance.lift_px for stance in result] == [0, 0, 2, 0, 0]
    poses = jump(RISES_PX)
    sequence = seen(found_feet(drawn(poses)))
    low = stances(_with(sequence, 8, dict.fromkeys((0, 1), Verdict.PLANTED)))
    assert low[8].lift_px == 0
    assert low[7].lift_px < 20


def test_nobody_needs_to_look_where_a_person_has_decided() -> None:
    result = stances(_with(_sequence(_dips()), 9, {0: Verdict.LIFTED}))
    assert [index for index, stance in enumerate(result) if stance.doubt] == [8, 10, 11]


def test_everything_lifted_by_a_person_has_no_ground_to_tell_and_no_height() -> None:
    (stance,) = stances(_with(_sequence([[(0, 200.0, 350.0)]]), 0, {0: Verdict.LIFTED}))
    assert [(foot.ground_row, foot.is_planted) for foot in stance.feet] == [(350.0, False)]
    assert stance.lift_px == 0


def test_no_ground_row_leaps_where_no_foot_does() -> None:
    for poses in (walk(40), run(6), jump(RISES_PX)):
        for before, after in pairwise(stances(seen(found_feet(drawn(poses))))):
            rows = {foot.track: foot for foot in after.feet}
            for foot in before.feet:
                if foot.track in rows and (foot.is_planted or rows[foot.track].is_planted):
                    moved = np.hypot(*np.subtract(rows[foot.track].place, foot.place))
                    assert abs(rows[foot.track].ground_row - foot.ground_row) <= moved + 1


@settings(max_examples=20)
@given(st.floats(0.2, 5), st.floats(-500, 500), st.floats(-500, 500))
def test_size_and_place_on_the_canvas_do_not_matter(size: float, dx: float, dy: float) -> None:
    sequence = _sequence(_step([335.0, 325.0, 322.0, 330.0], low=343.0))
    moved = tuple(
        Seen(
            each.frame,
            each.height_px * size,
            tuple(SeenFoot(foot.track, (foot.place[0] * size + dx, foot.place[1] * size + dy)) for foot in each.feet),
        )
        for each in sequence
    )
    for stance, other in zip(stances(sequence), stances(moved), strict=True):
        assert stance.doubt == other.doubt
        for foot, same in zip(stance.feet, other.feet, strict=True):
            assert foot.is_planted == same.is_planted
            assert same.ground_row == pytest.approx(foot.ground_row * size + dy, abs=1e-6)


_Places = dict[int, tuple[float, float, Verdict | None]]


@settings(max_examples=tries(20, 60))
@given(
    st.lists(
        st.dictionaries(
            st.integers(0, 3),
            st.tuples(st.floats(0, 500), st.floats(200, 400), st.sampled_from([None, *Verdict])),
            max_size=3,
        ),
        max_size=12,
    )
)
def test_whatever_is_seen_every_foot_has_a_ground(drawings: list[_Places]) -> None:
    sequence = [
        Seen(2 * index, 300.0, tuple(SeenFoot(track, (x, y), said) for track, (x, y, said) in sorted(feet.items())))
        for index, feet in enumerate(drawings)
    ]
    result = stances(sequence)
    assert result == stances(sequence)
    for each, stance in zip(sequence, result, strict=True):
        feet = {foot.track: foot for foot in each.feet}
        assert [foot.track for foot in stance.feet] == [
            foot.track for foot in each.feet if foot.verdict is not Verdict.NONE
        ]
        assert stance.lift_px >= 0
        assert stance.lift_px == 0 or not any(foot.is_planted for foot in stance.feet)
        for foot in stance.feet:
            assert not foot.is_planted or foot.ground_row == foot.place[1]
            if feet[foot.track].verdict is not None:
                assert foot.is_planted == (feet[foot.track].verdict is Verdict.PLANTED)
