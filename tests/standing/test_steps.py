"""Feet that are half hidden by another, in drawn figures; and what looks like one and is none."""

from collections.abc import Sequence

import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.geometry.vectors import Point2
from kagezou.standing.finding import found_feet
from kagezou.standing.outline import Outline
from kagezou.standing.stances import stances
from kagezou.standing.steps import steps_of
from tests.standing.figures import figure, outline, seen

HEEL: Point2 = (180.0, 360.0)
"""The heel of the near boot of a figure about 300 px high that is seen from the side and looks to the right."""

Shape = NDArray[np.bool_]


def _grid() -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    y, x = np.mgrid[0:400, 0:400] + 0.5
    return x, y


def _boot(heel: Point2, degrees: float = 0.0) -> Shape:
    """Return a boot of 46 px with a round toe and the leg over it; turned about its toe, toe down."""
    x, y = _grid()
    left, sole = heel
    turn = np.radians(degrees)
    leg = (x > left) & (x < left + 22) & (y > 200) & (y < sole - 8 - 46 * np.sin(turn))
    dx, dy = x - left - 46, y - sole
    along, up = dx * np.cos(turn) + dy * np.sin(turn), dx * np.sin(turn) - dy * np.cos(turn)
    shoe = (up > 0) & (up < 16) & (along > -46) & (along < -8)
    toe = np.hypot(along + 8, up - 8) < 8
    solid: Shape = leg | shoe | toe
    return solid


def _standing(*parts: Shape) -> Outline:
    alpha = figure([], hip=(191.0, 220.0))
    for part in parts:
        alpha[part] = 255
    return outline(alpha) or pytest.fail("nothing solid")


def _pair(ahead: float, up: float, degrees: float = 0.0) -> Outline:
    """Return one who stands with the far boot so far ahead of the near one, and so much higher in the picture."""
    return _standing(_boot(HEEL), _boot((HEEL[0] + ahead, HEEL[1] - up), degrees))


def _planted(outlines: Sequence[Outline]) -> list[list[Point2]]:
    result = stances(seen(found_feet(outlines)))
    return [[foot.place for foot in stance.feet if foot.is_planted] for stance in result]


@pytest.mark.parametrize("ahead", [18.0, -18.0, 26.0, -26.0, -34.0])
@pytest.mark.parametrize("up", [14.0, 20.0, 28.0])
def test_both_boots_of_one_who_stands_carry(ahead: float, up: float) -> None:
    for places in _planted([_pair(ahead, up)] * 30):
        near, far = sorted(places, key=lambda place: -place[1])
        assert near[1] == HEEL[1]
        assert far[1] == HEEL[1] - up
        assert HEEL[0] + ahead - 1 <= far[0] <= HEEL[0] + ahead + 47


@pytest.mark.parametrize("up", [2.0, 40.0])
def test_what_is_too_low_or_too_high_is_no_step(up: float) -> None:
    assert steps_of(_pair(26.0, up)) == ()


@pytest.mark.parametrize("degrees", [25.0, 45.0])
@pytest.mark.parametrize("ahead", [18.0, 26.0, -26.0])
def test_a_lifted_foot_that_hangs_is_no_step(ahead: float, degrees: float) -> None:
    assert steps_of(_pair(ahead, 20.0, degrees)) == ()


def _robe(left: float, right: float, row: float = 345.0) -> Shape:
    x, y = _grid()
    robe: Shape = (x > left) & (x < right) & (y > 180) & (y < row)
    return robe


@pytest.mark.parametrize(("left", "right"), [(165, 215), (150, 240), (150, 226), (180, 300)])
def test_a_hem_over_shoes_is_no_foot(left: float, right: float) -> None:
    x, y = _grid()
    shoe: Shape = (x > 180) & (x < 204) & (y > 340) & (y < 360)
    assert steps_of(_standing(_robe(left, right), shoe)) == ()


def test_a_shin_that_lies_behind_the_one_who_kneels_is_no_step() -> None:
    x, y = _grid()
    shin: Shape = (x > 90) & (x < 180) & (abs(y - 330 - (180 - x) / 8) < 9)
    assert steps_of(_standing(_boot(HEEL), shin)) == ()


def test_a_bent_leg_is_no_step() -> None:
    x, y = _grid()
    thigh: Shape = np.hypot(x - 225, y - 250) < 16
    shin: Shape = (y > 250) & (y - x / 2 < 342 - 90) & (abs(x - 225 + (y - 250) / 2) < 12)
    assert steps_of(_standing(_boot(HEEL), thigh, shin)) == ()


def test_heel_and_waist_of_a_shoe_are_one_foot() -> None:
    x, y = _grid()
    leg: Shape = (x > 180) & (x < 202) & (y > 200) & (y < 346)
    upper: Shape = (x > 180) & (x < 238) & (y > 334) & (y < 348)
    heel: Shape = (x > 180) & (x < 192) & (y > 334) & (y < 360)
    toe: Shape = (x > 208) & (x < 238) & (y > 340) & (y < 358)
    for ball in (toe, toe & (x < 232)):
        assert steps_of(_standing(leg, upper, heel, ball)) == ()
        (found,) = found_feet([_standing(leg, upper, heel, ball)])
        assert 1 <= len(found.feet) <= 2


def test_a_tail_that_comes_down_beside_a_boot_is_no_foot() -> None:
    x, y = _grid()
    tail: Shape = (x > 80) & (x < 190) & (abs(y - 340 + (190 - x) * 0.4) < 6)
    assert steps_of(_standing(_boot(HEEL), tail)) == ()


def test_a_step_that_moves_is_no_foot() -> None:
    found = found_feet([_pair(18.0 + 8 * step, 20.0) for step in range(4)])
    assert [len(each.feet) for each in found] == [1] * 4


def test_a_foot_that_comes_to_stand_half_hidden_goes_on_as_a_step() -> None:
    outlines = [_pair(ahead, 20.0) for ahead in (60.0, 52.0, 44.0, 40.0, 40.0, 40.0)]
    found = found_feet(outlines)
    assert [len(steps_of(each)) for each in outlines] == [0, 0, 1, 1, 1, 1]
    assert [[foot.track for foot in each.feet] for each in found[3:]] == [[0, 1]] * 3


@pytest.mark.parametrize("way", [1, -1])
def test_a_mirrored_figure_has_the_same_steps(way: int) -> None:
    alpha = np.zeros((400, 400), np.uint8)
    alpha[60:340, 190:220] = 255
    alpha[320:340, 220:240] = 255
    alpha[60:360, 180:204] = 255
    (step,) = steps_of(outline(alpha[:, ::way]) or pytest.fail("nothing solid"))
    assert (step.place, step.width_px, step.is_step) == ((222.0 if way > 0 else 178.0, 340.0), 36, True)
