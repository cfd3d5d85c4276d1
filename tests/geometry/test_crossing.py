"""Two flat polygons that go through each other, stand apart, touch, or are parallel."""

import numpy as np
import pytest

from kagezou.geometry.crossing import crossing_px
from kagezou.geometry.vectors import Matrix

WALL = np.array([(0.0, 0.0, 0.0), (100.0, 0.0, 0.0), (100.0, 60.0, 0.0), (0.0, 60.0, 0.0)])


def upright(x: float, y: tuple[float, float], z: tuple[float, float]) -> Matrix:
    """Return a rectangle square to the wall, at a column of it."""
    return np.array([(x, y[0], z[0]), (x, y[1], z[0]), (x, y[1], z[1]), (x, y[0], z[1])])


@pytest.mark.parametrize(
    ("x", "y", "z", "length"),
    [
        (50, (10, 40), (-20, 30), 30.0),
        (50, (10, 90), (-20, 30), 50.0),
        (50, (-10, 40), (-2, 300), 40.0),
        (150, (10, 40), (-20, 30), 0.0),  # beside it
        (50, (70, 90), (-20, 30), 0.0),  # over it
        (50, (10, 40), (1, 30), 0.0),  # before it
        (50, (10, 40), (0, 30), 0.0),  # touching it
        (50, (10, 40), (-30, 0.5), 0.0),  # hardly through it
        (100, (10, 40), (-30, 30), 0.0),  # along its edge
    ],
)
def test_what_goes_through_a_wall_is_as_long_as_their_common_line(
    x: float, y: tuple[float, float], z: tuple[float, float], length: float
) -> None:
    for other in (upright(x, y, z), upright(x, y, z)[::-1]):
        assert crossing_px(WALL, other, 1.0) == pytest.approx(length)
        assert crossing_px(other, WALL, 1.0) == pytest.approx(length)
        moved = np.array([3e4, -2e4, 5e3])
        assert crossing_px(WALL + moved, other + moved, 1.0) == pytest.approx(length)


def test_parallel_polygons_do_not_cross() -> None:
    assert crossing_px(WALL, WALL + np.array([0.0, 0.0, 5.0]), 1.0) == 0.0
    assert crossing_px(WALL, WALL, 1.0) == 0.0
