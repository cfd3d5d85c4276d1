"""Simplified shadows held at the feet: where the slide comes from, and that it comes and goes without a jump."""

from itertools import pairwise

import numpy as np
import pytest

from kagezou.geometry.hold import Patches, slide_to_feet

STEP = 4.0


def patches(inside: np.ndarray[tuple[int, int], np.dtype[np.float64]], left: float, low: float) -> Patches:
    """Return a shape of squares 4 px wide, by how much of each it holds; the corner at (left, low)."""
    rows, columns = np.nonzero(inside > 0)
    along, away = (np.asarray(STEP * (each + 0.5), np.float64) for each in (columns, rows))
    return Patches(left + along, low + away, STEP**2 * inside[rows, columns])


def ellipse(middle: tuple[float, float], half: tuple[float, float], turned_deg: float = 0.0) -> Patches:
    y, x = np.mgrid[0:200, 0:200] * STEP + STEP / 2 - 400.0
    turn = np.radians(turned_deg)
    along, away = x * np.cos(turn) + y * np.sin(turn), y * np.cos(turn) - x * np.sin(turn)
    distance = np.hypot(along / half[0], away / half[1])
    inside = np.clip(0.5 + (1 - distance) * min(half) / STEP, 0, 1)
    return patches(inside, middle[0] - 400.0, middle[1] - 400.0)


def legs(at: tuple[float, ...] = (-20.0, 20.0), length: float = 120.0, side: int = 1) -> Patches:
    """Return a body on legs; they begin on the contact line."""
    ones = np.ones((int(length / STEP), 3))
    parts = [patches(ones, x - 6.0, 0.0) for x in at]
    body = ellipse((sum(at) / len(at), 200.0), (90.0, 100.0))
    whole = Patches.of([*parts, body])
    return Patches(whole.along, side * whole.away, whole.area)


def nothing() -> Patches:
    return Patches(*(np.zeros(0) for _ in range(3)))


@pytest.mark.parametrize("side", [-1, 1])
def test_a_disc_is_slid_until_it_begins_under_the_feet(side: int) -> None:
    disc = ellipse((0.0, side * 260.0), (110.0, 110.0))
    along, away = slide_to_feet(legs(side=side), disc, nothing(), 1.0)
    assert along == pytest.approx(0.0, abs=0.5)
    # Its edge was 150 px from the line, and goes on 0.12 half lengths beyond.
    assert side * away == pytest.approx(150.0 + 0.12 * 110.0, abs=1.5)


def test_an_oblique_ellipse_goes_along_the_line_from_the_feet_to_its_middle() -> None:
    sharp, shape = legs(at=(-200.0,)), ellipse((0.0, 300.0), (80.0, 200.0), -33.69)
    along, away = slide_to_feet(sharp, shape, nothing(), 1.0)
    assert along / away == pytest.approx(200.0 / 300.0, rel=0.01)
    # The tip of its long axis lay on that line, 160.6 px from the feet.
    assert np.hypot(along, away) == pytest.approx(np.hypot(200.0, 300.0) - 200.0 + 0.12 * 200.0, abs=3.0)


def test_half_of_the_hold_is_half_of_the_way() -> None:
    disc = ellipse((30.0, 260.0), (110.0, 110.0))
    whole, half = (np.array(slide_to_feet(legs(), disc, nothing(), hold)) for hold in (1.0, 0.5))
    assert half == pytest.approx(whole / 2)


def test_a_shape_that_stands_on_the_feet_stays() -> None:
    assert slide_to_feet(legs(), ellipse((0.0, 80.0), (110.0, 110.0)), nothing(), 1.0) == (0.0, 0.0)
    assert slide_to_feet(legs(), legs(), legs(), 1.0) == (0.0, 0.0)


def test_the_feet_are_what_is_nearest_wherever_that_is() -> None:
    """One leg raised: the other one carries the shape."""
    raised = Patches(np.array([-100.0]), np.array([90.0]), np.array([400.0]))
    sharp = Patches.of([legs(at=(100.0,)), raised])
    along, away = slide_to_feet(sharp, ellipse((100.0, 260.0), (110.0, 110.0)), nothing(), 1.0)
    assert along == pytest.approx(0.0, abs=2.0)
    assert away > 100.0


def test_what_is_left_of_the_feet_holds_the_shape_back() -> None:
    sharp, disc = legs(), ellipse((0.0, 260.0), (110.0, 110.0))
    ways = []
    for part in np.linspace(0.0, 1.0, 41):
        left = Patches(sharp.along, sharp.away, part * sharp.area)
        ways.append(slide_to_feet(sharp, disc, left, 1.0)[1])
    assert ways == sorted(ways, reverse=True)
    assert ways[-1] == ways[24] == 0.0
    assert max(abs(b - a) for a, b in pairwise(ways)) < 0.1 * ways[0]


def test_an_island_that_melts_away_lets_the_shape_go_without_a_jump() -> None:
    sharp, disc = legs(), ellipse((0.0, 260.0), (110.0, 110.0))
    ways = []
    for part in np.linspace(0.0, 1.0, 101):
        island = Patches(np.array([0.0]), np.array([20.0]), np.array([900.0 * part]))
        ways.append(slide_to_feet(sharp, Patches.of([disc, island]), nothing(), 1.0)[1])
    assert ways == sorted(ways, reverse=True)
    assert max(abs(b - a) for a, b in pairwise(ways)) < 0.08 * ways[0]


def test_without_hold_shadow_or_direction_there_is_no_slide() -> None:
    disc = ellipse((0.0, 260.0), (110.0, 110.0))
    assert slide_to_feet(legs(), disc, nothing(), 0.0) == (0.0, 0.0)
    assert slide_to_feet(nothing(), disc, nothing(), 1.0) == (0.0, 0.0)
    assert slide_to_feet(legs(), nothing(), nothing(), 1.0) == (0.0, 0.0)
    dot = Patches(np.array([0.0]), np.array([0.0]), np.array([16.0]))
    assert slide_to_feet(dot, dot, nothing(), 1.0) == (0.0, 0.0)


def test_a_shape_of_one_part_is_slid_by_its_distance() -> None:
    sharp, dot = (Patches(np.array([0.0]), np.array([away]), np.array([16.0])) for away in (2.0, 50.0))
    assert slide_to_feet(sharp, dot, nothing(), 1.0) == (0.0, 50.0)
