"""Where a matte is empty or full, asked for boxes at once: never wrong, and exact to a block of texels."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from kagezou.render.prepare.occupancy import BLOCK_TEXELS, Occupancy, count_in, summed

ALPHAS = arrays.arrays(
    st.sampled_from([np.uint8, np.uint16]),
    st.tuples(st.integers(1, 21), st.integers(1, 21)),
    elements=st.sampled_from([0, 0, 0, 1, 255]),
    fill=st.just(0),
)


def states(alpha: np.ndarray, low: tuple[float, float], high: tuple[float, float], reach: int = 0) -> tuple[bool, bool]:
    empty, full = Occupancy(alpha, reach).states(np.array([low]).T, np.array([high]).T)
    return bool(empty[0]), bool(full[0])


def test_a_box_over_nothing_is_empty_and_over_everything_full() -> None:
    alpha = np.zeros((40, 40), np.uint8)
    alpha[16:, 16:] = 255
    assert states(alpha, (2.0, 2.0), (10.0, 10.0)) == (True, False)
    assert states(alpha, (22.0, 22.0), (30.0, 30.0)) == (False, True)
    assert states(alpha, (10.0, 10.0), (30.0, 30.0)) == (False, False)


def test_a_texel_that_is_not_quite_full_is_a_gap() -> None:
    alpha = np.full((40, 40), 65535, np.uint16)
    assert states(alpha, (8.0, 8.0), (30.0, 30.0)) == (False, True)
    alpha[20, 20] = 65534
    assert states(alpha, (8.0, 8.0), (30.0, 30.0)) == (False, False)


def test_what_leaves_the_matte_is_never_full_and_beyond_it_all_is_empty() -> None:
    alpha = np.full((16, 16), 255, np.uint8)
    assert states(alpha, (4.0, 4.0), (10.0, 10.0)) == (False, True)
    assert states(alpha, (-1.0, 4.0), (10.0, 10.0)) == (False, False)
    assert states(alpha, (4.0, 4.0), (10.0, 17.0)) == (False, False)
    assert states(alpha, (40.0, 40.0), (50.0, 50.0)) == (True, False)
    assert states(alpha, (-50.0, -50.0), (-40.0, -40.0)) == (True, False)


def test_smoothing_carries_alpha_as_far_as_it_reaches() -> None:
    alpha = np.zeros((64, 64), np.uint8)
    alpha[32:36, 32:36] = 255
    assert states(alpha, (20.0, 32.0), (27.0, 35.0), reach=0) == (True, False)
    assert states(alpha, (20.0, 32.0), (27.0, 35.0), reach=8) == (False, False)


@given(ALPHAS, st.integers(0, 3), st.data())
def test_no_box_is_called_empty_or_full_that_is_not(alpha: np.ndarray, reach: int, data: st.DataObject) -> None:
    height, width = alpha.shape
    left, right = sorted(data.draw(st.tuples(st.floats(-4, width + 4), st.floats(-4, width + 4))))
    top, bottom = sorted(data.draw(st.tuples(st.floats(-4, height + 4), st.floats(-4, height + 4))))
    is_empty, is_full = states(alpha, (left, top), (right, bottom), reach)
    # Bilinear sampling of a place reads the texels around it, and smoothing has carried them so much farther.
    padded = np.pad(alpha, 16)
    columns = slice(int(np.floor(left - reach - 0.5)) + 16, int(np.ceil(right + reach + 0.5)) + 16)
    rows = slice(int(np.floor(top - reach - 0.5)) + 16, int(np.ceil(bottom + reach + 0.5)) + 16)
    read = padded[rows, columns]
    assert not (is_empty and read.any())
    assert not (is_full and (read != np.iinfo(alpha.dtype).max).any())


@given(ALPHAS)
def test_a_matte_is_asked_block_by_block(alpha: np.ndarray) -> None:
    blocks = [(x, y) for x in range(0, alpha.shape[1], BLOCK_TEXELS) for y in range(0, alpha.shape[0], BLOCK_TEXELS)]
    low = np.array(blocks, float).T + BLOCK_TEXELS / 2
    empty, _ = Occupancy(alpha, 0).states(low - 0.4, low + 0.4)
    held = [alpha[y : y + BLOCK_TEXELS, x : x + BLOCK_TEXELS].any() for x, y in blocks]
    assert empty.tolist() == [not each for each in held]


@pytest.mark.parametrize(("start", "stop", "count"), [((0, 0), (3, 2), 21), ((1, 0), (2, 2), 7), ((2, 1), (2, 2), 0)])
def test_a_summed_table_counts_any_box(start: tuple[int, int], stop: tuple[int, int], count: int) -> None:
    table = summed(np.array([[1, 2, 3], [4, 5, 6]]))
    assert count_in(table, np.array([start]).T, np.array([stop]).T).tolist() == [count]
