"""What a light looks at: a right-angled frame of its own that holds all it is given, and little more."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.errors import GraphicsProblem
from kagezou.geometry.vectors import Vector4
from kagezou.render.prepare.light_view import LightView

SEEDS = st.integers(0, 2**32)
AWAY = st.tuples(*[st.floats(-1.0, 1.0)] * 3).filter(lambda each: np.linalg.norm(each) > 0.1)


def corners(seed: int) -> np.ndarray:
    """Points of a card within 500 px of the origin."""
    return np.random.default_rng(seed).uniform(-280, 280, (8, 3))


def light_from(toward: tuple[float, float, float], *, is_lamp: bool) -> Vector4:
    x, y, z = (each / float(np.linalg.norm(toward)) * (1500.0 if is_lamp else 1.0) for each in toward)
    return (x, y, z, 1.0 if is_lamp else 0.0)


def in_window(view: LightView, points: np.ndarray) -> np.ndarray:
    """Where points (N, 3) are seen, the window from -1 to 1 each way."""
    seen = view.seen(points)
    flat = seen[:, :2] / seen[:, 2:] if view.light[3] else seen[:, :2]
    return np.asarray((flat - view.centre) / view.half)


@given(toward=AWAY, seed=SEEDS, is_lamp=st.booleans())
def test_all_points_lie_in_the_window_and_touch_its_sides(
    toward: tuple[float, float, float], seed: int, *, is_lamp: bool
) -> None:
    points = corners(seed)
    view = LightView.around(light_from(toward, is_lamp=is_lamp), points)
    placed = in_window(view, points)
    assert np.abs(placed).max(axis=0) == pytest.approx([1, 1], abs=0.002)
    assert np.abs(placed).max() < 1
    assert placed.min(axis=0) == pytest.approx(-placed.max(axis=0), abs=0.002)
    depths = view.seen(points)[:, 2]
    assert view.near < depths.min() <= depths.max() < view.far
    assert view.far - view.near < 1.1 * np.ptp(depths) + 1


@given(toward=AWAY, seed=SEEDS, is_lamp=st.booleans())
def test_the_axes_are_a_right_handed_frame_that_looks_away_from_the_light(
    toward: tuple[float, float, float], seed: int, *, is_lamp: bool
) -> None:
    light, points = light_from(toward, is_lamp=is_lamp), corners(seed)
    view = LightView.around(light, points)
    assert view.axes @ view.axes.T == pytest.approx(np.eye(3), abs=1e-9)
    assert np.linalg.det(view.axes) == pytest.approx(1.0)
    away = points.mean(axis=0) - np.array(light[:3]) if is_lamp else -np.array(light[:3])
    assert view.axes[2] @ away == pytest.approx(np.linalg.norm(away))


@given(toward=AWAY, seed=SEEDS, is_lamp=st.booleans())
def test_the_matrix_does_what_seeing_does(toward: tuple[float, float, float], seed: int, *, is_lamp: bool) -> None:
    points = corners(seed)
    view = LightView.around(light_from(toward, is_lamp=is_lamp), points)
    homogeneous = np.column_stack([points, np.ones(len(points))])
    assert homogeneous @ view.light_from_world().T == pytest.approx(view.seen(points), abs=1e-6)


def test_a_lamp_among_the_points_has_no_one_view() -> None:
    with pytest.raises(GraphicsProblem, match="the lamp stands within the card"):
        LightView.around((0.0, 0.0, 0.0, 1.0), np.array([[10.0, 0, 0], [-5.0, 1, 0], [0, 8.0, 0]]))


@pytest.mark.parametrize("is_lamp", [True, False])
def test_shaders_are_told_the_window_and_the_range(*, is_lamp: bool) -> None:
    view = LightView.around(light_from((0.3, -0.8, 0.4), is_lamp=is_lamp), corners(3))
    uniforms = view.uniforms()
    assert uniforms["u_window"] == (*view.centre, *view.half)
    assert uniforms["u_range"] == (view.near, view.far)
    assert uniforms["u_is_lamp"] is is_lamp
