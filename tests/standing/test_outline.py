"""What is kept of a drawing."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from kagezou.geometry.box import Box
from kagezou.standing.outline import longest_run, outline_of


def test_lower_edge_of_each_column() -> None:
    alpha = np.zeros((6, 5), np.uint8)
    alpha[1:3, 1] = 255
    alpha[2:5, 3] = 128
    alpha[5, 4] = 127  # less than half: not solid
    outline = outline_of(alpha, 10, 20, 40)
    assert outline is not None
    assert outline.box == Box(11, 21, 14, 25)
    assert outline.lower.tolist() == [23, 21, 25]
    assert (outline.height_px, outline.cut_px) == (4, 0)


@pytest.mark.parametrize("alpha", [np.zeros((0, 0), np.uint8), np.full((4, 3), 32767, np.uint16)])
def test_nothing_solid(alpha: np.ndarray) -> None:
    assert outline_of(alpha, 0, 0, 4) is None


def test_longest_row_that_touches_the_edge_of_the_drawing() -> None:
    alpha = np.zeros((4, 9), np.uint8)
    alpha[:, [0, 1, 3, 4, 5]] = 255
    whole, higher = outline_of(alpha, 0, 0, 4), outline_of(alpha, 0, 0, 5)
    assert whole is not None
    assert higher is not None
    assert (whole.cut_px, higher.cut_px) == (3, 0)


@given(arrays(np.bool_, st.integers(0, 12)))
def test_longest_run_is_that_of_a_plain_search(flags: np.ndarray) -> None:
    runs = "".join("x" if flag else " " for flag in flags).split()
    assert longest_run(flags) == max(map(len, runs), default=0)


@given(arrays(np.uint16, st.tuples(st.integers(1, 9), st.integers(1, 9)), elements=st.sampled_from([0, 32767, 32768])))
def test_edge_is_that_of_a_plain_search(alpha: np.ndarray) -> None:
    rows, columns = np.nonzero(alpha == 32768)
    outline = outline_of(alpha, 3, 5, 100)
    if not rows.size:
        assert outline is None
        return
    assert outline is not None
    box = Box(3 + columns.min(), 5 + rows.min(), 4 + columns.max(), 6 + rows.max())
    assert outline.box == box
    expected = [5 + max(rows[columns == column - 3], default=box.top - 6) + 1 for column in range(box.left, box.right)]
    assert outline.lower.tolist() == expected


def test_tall_pictures_do_not_overflow() -> None:
    alpha = np.full((70000, 1), 255, np.uint8)
    outline = outline_of(alpha, 0, 0, 70000)
    assert outline is not None
    assert outline.lower.tolist() == [70000]
