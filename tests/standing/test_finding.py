"""Feet in drawn figures."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kagezou.standing.finding import Footless, found_feet
from kagezou.standing.minima import minima_of
from kagezou.standing.outline import Outline
from tests.standing.figures import FAR, GROUND, Pose, drawn, figure, jump, outline, run, walk

STANDS = ((170.0, GROUND), (235.0, FAR))


def _places(pose: Pose, size: float = 1.0) -> list[tuple[float, float]]:
    (found,) = found_feet(drawn([pose], size))
    return [foot.place for foot in found.feet]


def test_a_foot_is_below_its_lowest_row_at_the_middle_of_its_sole() -> None:
    assert _places(Pose(STANDS, (True, True))) == [(170.0, 360.0), (235.0, 352.0)]


@settings(max_examples=15)
@given(st.floats(0.3, 2.5))
def test_size_of_the_drawing_does_not_matter(size: float) -> None:
    places = _places(Pose(STANDS, (True, True)), size)
    assert np.array(places) == pytest.approx(np.array(STANDS) * size, abs=1.0)


def test_a_leg_that_hides_the_other_is_one_foot() -> None:
    assert _places(Pose(((200.0, GROUND), (206.0, FAR)), (True, True))) == [(200.0, 360.0)]


def test_a_walk_has_two_tracks_that_never_leap() -> None:
    found = found_feet(drawn(walk(48)))
    assert {foot.track for each in found for foot in each.feet} == {0, 1}
    for before, after in pairwise(found):
        places = {foot.track: foot.place for foot in after.feet}
        for foot in before.feet:
            if foot.track in places:
                assert np.hypot(*np.subtract(places[foot.track], foot.place)) < 40


def test_lifted_feet_have_a_place() -> None:
    poses = walk(32)
    for pose, found in zip(poses, found_feet(drawn(poses)), strict=True):
        if abs(pose.feet[0][0] - pose.feet[1][0]) > 40:
            assert sorted(foot.place for foot in found.feet) == pytest.approx(np.array(sorted(pose.feet)), abs=1.0)


def test_feet_keep_their_tracks_through_a_jump_and_a_run() -> None:
    for poses in (jump([0, 0, 20, 45, 60, 60, 45, 20, 0]), run(4)):
        found = found_feet(drawn(poses))
        assert max(foot.track for each in found for foot in each.feet) <= 3
        assert all(1 <= len(each.feet) <= 2 for each in found)


def test_hands_that_hang_are_no_feet() -> None:
    alpha = figure(STANDS)
    alpha[160:300, 90:110] = 255
    alpha[160:175, 90:200] = 255
    assert len(minima_of(outline(alpha) or pytest.fail("nothing solid"))) == 3
    (found,) = found_feet([outline(alpha)])
    assert [foot.place for foot in found.feet] == [(170.0, 360.0), (235.0, 352.0)]


def test_wheels_are_feet() -> None:
    y, x = np.mgrid[0:400, 0:500]
    alpha = np.zeros((400, 500), np.uint8)
    for middle in (150, 350):
        alpha[np.hypot(x - middle, y - 320) < 60] = 255
    alpha[60:300, 200:300] = 255
    alpha[280:320, 150:350] = 255
    (found,) = found_feet([outline(alpha)])
    assert [foot.place[0] for foot in found.feet] == pytest.approx([150, 350], abs=2)


def _hem() -> np.ndarray:
    alpha = figure([])
    for row in range(160, 360):
        half = 30 + (row - 160) * 50 // 200
        alpha[row, 200 - half : 200 + half] = 255
    return alpha


def test_a_hem_has_no_feet_and_says_so() -> None:
    (found,) = found_feet([outline(_hem())])
    assert (found.feet, found.footless) == ((), Footless.BROAD)


@pytest.mark.parametrize("sits", [False, True])
def test_one_that_lies_or_sits_has_no_feet(*, sits: bool) -> None:
    y, x = np.mgrid[0:400, 0:400]
    alpha = np.where((abs(y - 330) < 30) & (x > 80) & (x < 280), 255, 0).astype(np.uint8)
    alpha[300:360, 280:300] = 255
    alpha[np.hypot(x - 60, y - 330) < 28] = 255
    if sits:
        alpha[120:330, 80:150] = 255
    (found,) = found_feet([outline(alpha)])
    assert (found.feet, found.footless) == ((), Footless.BROAD)


def test_a_single_broad_drawing_among_others_keeps_its_feet() -> None:
    found = found_feet([*drawn(walk(4)), outline(_hem())])
    assert [each.footless for each in found] == [None] * 5
    assert found[4].feet


def test_few_feet_among_broad_drawings_are_none() -> None:
    found = found_feet([*drawn(walk(1)), outline(_hem()), outline(_hem())])
    assert [each.footless for each in found] == [Footless.BROAD] * 3


def test_a_body_that_runs_out_of_the_picture_has_no_feet() -> None:
    cut = figure(STANDS)[:200]
    (found,) = found_feet([outline(cut)])
    assert (found.feet, found.footless) == ((), Footless.CUT_OFF)


def test_soles_on_the_lower_edge_of_the_picture_are_feet() -> None:
    (found,) = found_feet([outline(figure(STANDS)[:360])])
    assert len(found.feet) == 2


def test_empty_drawings_have_no_feet_and_break_no_track() -> None:
    poses = walk(4)
    first, second, third, last = drawn(poses)
    found = found_feet([first, None, second, third, last])
    assert found[1].footless is Footless.EMPTY
    assert [foot.track for foot in found[2].feet] == [foot.track for foot in found[0].feet] == [0, 1]
    assert found_feet([None])[0].footless is Footless.EMPTY
    assert found_feet([]) == ()


def test_a_figure_of_one_column_has_a_foot() -> None:
    alpha = np.zeros((50, 9), np.uint8)
    alpha[10:40, 4] = 255
    (found,) = found_feet([outline(alpha)])
    assert [foot.place for foot in found.feet] == [(4.5, 40.0)]


def test_the_same_drawings_give_the_same_feet() -> None:
    poses = drawn(run(3))
    assert found_feet(poses) == found_feet(poses)


_STANDS = [0.0] * 4
"""How high a foot is over the ground, as part of the figure's height."""


def _lifting(rises: Sequence[float], aside_px: float = 0.0) -> list[Pose]:
    """Return one who stands on the far foot and lifts the near one so high, going so far aside in each drawing."""
    return [
        Pose(((160.0 - aside_px * (rise > 0), GROUND - 300 * rise), (235.0, FAR)), (rise == 0, True)) for rise in rises
    ]


@pytest.mark.parametrize("lifted", [[0.17], [0.17] * 3, [0.2, 0.1, 0.2], [0.12, 0.24, 0.12], [0.15, 0.3, 0.15]])
def test_a_foot_that_is_lifted_fast_keeps_its_track(lifted: list[float]) -> None:
    poses = _lifting([*_STANDS, *lifted, *_STANDS])
    for pose, found in zip(poses, found_feet(drawn(poses)), strict=True):
        assert [foot.track for foot in found.feet] == [0, 1]
        assert found.feet[0].place == pytest.approx(pose.feet[0], abs=1.0)


@pytest.mark.parametrize(("rises", "aside_px"), [([*_STANDS, 0.17, 0.17], 0.0), ([*_STANDS, 0.17, *_STANDS], 40.0)])
def test_what_is_not_set_down_again_or_is_elsewhere_may_be_a_hand(rises: list[float], aside_px: float) -> None:
    poses = _lifting(rises, aside_px)
    for pose, found in zip(poses, found_feet(drawn(poses)), strict=True):
        assert len(found.feet) == sum(pose.carry)


def test_a_hand_over_a_foot_that_was_there_before_stays_a_hand() -> None:
    def with_hand(pose: Pose) -> Outline:
        alpha = figure(pose.feet)
        alpha[160:172, 130:200] = 255
        alpha[160:300, 130:142] = 255
        return outline(alpha) or pytest.fail("nothing solid")

    poses = _lifting([*_STANDS, 0.6, 0.6, *_STANDS])
    assert [len(minima_of(with_hand(pose))) for pose in poses] == [3] * 4 + [2] * 2 + [3] * 4
    assert [len(each.feet) for each in found_feet([with_hand(pose) for pose in poses])] == [2] * 4 + [1] * 2 + [2] * 4
