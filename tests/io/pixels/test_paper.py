"""The white that reaches the border of a picture, against a flood fill step by step."""

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis.extra.numpy import arrays

from kagezou.io.pixels.paper import Mask, reaching_border


def flooded(white: Mask) -> Mask:
    """Grow from the border by one pixel a step until nothing more is reached."""
    reached = white.copy()
    reached[1:-1, 1:-1] = False
    while True:
        wider = reached.copy()
        wider[1:] |= reached[:-1]
        wider[:-1] |= reached[1:]
        wider[:, 1:] |= reached[:, :-1]
        wider[:, :-1] |= reached[:, 1:]
        wider &= white
        if (wider == reached).all():
            return reached
        reached = wider


@given(st.tuples(st.integers(1, 24), st.integers(1, 24)).flatmap(lambda size: arrays(np.bool_, size)))
@settings(deadline=None)
def test_it_is_what_a_flood_from_the_border_reaches(white: Mask) -> None:
    assert np.array_equal(reaching_border(white), flooded(white))


@pytest.mark.parametrize("density", [0.4, 0.55, 0.6, 0.65, 0.8])
def test_noise_is_flooded_as_far_as_it_is_connected(density: float) -> None:
    white = np.random.default_rng(7).random((90, 120)) < density
    assert np.array_equal(reaching_border(white), flooded(white))


def test_a_long_winding_way_is_followed_to_its_end() -> None:
    white = np.ones((41, 40), np.bool_)
    white[::2] = False
    for row in range(2, 40, 2):
        white[row, -2 if row % 4 else 1] = True
    white[:, [0, -1]] = False
    white[0, 5] = True
    assert white[39, 1:39].all()
    assert np.array_equal(reaching_border(white), white)
    white[20] = False
    assert not reaching_border(white)[21:].any()


def test_a_line_of_one_pixel_that_goes_aslant_holds() -> None:
    white = np.ones((9, 9), np.bool_)
    for step in range(4):
        for row, column in ((4 - step, step), (4 - step, 8 - step), (4 + step, step), (4 + step, 8 - step)):
            white[row, column] = False
    white[0, 4] = white[8, 4] = False
    reached = reaching_border(white)
    assert not reached[4, 1:8].any()
    assert reached[0, 0]


def test_no_white_and_nothing_but_white() -> None:
    for white in (np.zeros((3, 5), np.bool_), np.ones((3, 5), np.bool_), np.zeros((0, 4), np.bool_)):
        assert np.array_equal(reaching_border(white), white)
