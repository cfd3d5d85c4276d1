"""Convex polygons and half-planes."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.box import Box
from kagezou.geometry.polygon import bounding_box, box_polygon, clipped, distance_form, shifted

SQUARE = box_polygon(Box(0, 0, 10, 10))


def test_a_distance_form_measures_pixels() -> None:
    form = distance_form(np.array([3.0, 4.0, -50.0]))
    assert form @ np.array([10.0, 5.0, 1.0]) == pytest.approx(0.0)
    assert form @ np.array([13.0, 9.0, 1.0]) == pytest.approx(5.0)
    assert shifted(form, 2.0) @ np.array([10.0, 5.0, 1.0]) == pytest.approx(2.0)


@pytest.mark.parametrize(("constant", "value"), [(5.0, 1e6), (-5.0, -1e6), (0.0, -1e6)])
def test_a_form_without_an_edge_is_everywhere_or_nowhere(constant: float, value: float) -> None:
    assert distance_form(np.array([0.0, 0.0, constant])).tolist() == [0.0, 0.0, value]


def test_clipping() -> None:
    half = clipped(SQUARE, np.array([-1.0, 0.0, 4.0]))
    assert bounding_box(half) == Box(0, 0, 4, 10)
    assert clipped(SQUARE, np.array([-1.0, 0.0, 40.0])) is SQUARE
    assert len(clipped(SQUARE, np.array([-1.0, 0.0, -1.0]))) == 0
    assert len(clipped(np.empty((0, 2)), np.array([1.0, 0.0, 0.0]))) == 0


def test_touching_at_a_point_leaves_nothing() -> None:
    corner = clipped(SQUARE, np.array([1.0, 1.0, -20.0]))
    assert bounding_box(corner) in (None, Box(10, 10, 10, 10))


def test_no_box_around_nothing() -> None:
    assert bounding_box(np.empty((0, 2))) is None
    assert bounding_box(np.array([[0.2, 1.5], [3.1, 1.5], [1.0, 4.0]])) == Box(0, 1, 4, 4)


@given(st.floats(-1, 1), st.floats(-1, 1), st.floats(-15, 15))
def test_what_is_left_lies_within_both(a: float, b: float, c: float) -> None:
    form = np.array([a, b, c])
    left = clipped(SQUARE, form)
    assert (left >= -1e-9).all()
    assert (left <= 10 + 1e-9).all()
    assert (left @ form[:2] + c >= -1e-9).all()
