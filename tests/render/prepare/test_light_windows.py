"""Windows of a light's view: all that is asked about lies in one, and little else."""

from itertools import pairwise

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.vectors import Matrix
from kagezou.render.prepare.light_windows import FACES, LightCone, LightWindow, LightWindows

SEEDS = st.integers(0, 2**32)
SUN, LAMP = np.array([0.3, -0.8, 0.5, 0.0]), np.array([150.0, -900.0, 400.0, 1.0])


def boxes(seed: int, count: int, reach_px: float) -> Matrix:
    """Hulls (8, 3, N) of small boxes around the origin."""
    rng = np.random.default_rng(seed)
    middles, halves = rng.uniform(-reach_px, reach_px, (3, count)), rng.uniform(1, 20, (3, count))
    signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    return np.asarray(middles + signs[:, :, np.newaxis] * halves)


def clipped_places(window: LightWindow, hulls: Matrix) -> Matrix:
    """The corners (8, N, 4) of hulls in the window's clip space."""
    rows, _ = window.clip_rows()
    places = np.concatenate([hulls, np.ones((len(hulls), 1, hulls.shape[2]))], axis=1)
    return np.asarray(np.einsum("ij,kjn->kni", rows, places))


@given(SEEDS, st.booleans())
def test_all_that_stands_before_what_is_lit_is_in_the_window(seed: int, is_lamp: bool) -> None:  # noqa: FBT001 - drawn
    light = LAMP if is_lamp else SUN
    receivers, casters = boxes(seed, 30, 200.0), boxes(seed + 1, 30, 200.0)
    cone = LightCone.around(light, receivers)
    assert cone is not None
    assert cone.holds(receivers)
    window = LightWindow.fitted(cone, receivers, casters)
    assert window is not None
    bounds, (low, high) = cone.axes.bounds(casters), (window.centre - window.half, window.centre + window.half)
    inside = (low <= bounds.low.T).all(axis=1) & (high >= bounds.high.T).all(axis=1)
    assert window.may_hold(casters)[inside].all()
    seen = clipped_places(window, casters)[:, inside]
    assert (np.abs(seen[..., :3]) <= seen[..., 3:] * (1 + 1e-6)).all()


@given(SEEDS)
def test_a_window_within_a_cone_is_no_larger_than_it(seed: int) -> None:
    asked = LightCone.around(LAMP, boxes(seed, 1, 60.0))
    assert asked is not None
    window = LightWindow.fitted(asked, None, boxes(seed + 1, 200, 400.0))
    if window is not None:
        assert (window.half * 2 <= (asked.high - asked.low) * 1.003).all()
        assert max(window.size_texels(512, 1024)) <= 1024


def test_a_margin_lets_things_turn() -> None:
    hulls = boxes(5, 4, 100.0)
    cone, wider = LightCone.around(LAMP, hulls), LightCone.around(LAMP, hulls, 0.1)
    assert cone is not None
    assert wider is not None
    assert wider.holds(hulls * 1.05)
    assert not cone.holds(hulls * 1.05)


def test_nothing_is_thrown_on_what_lies_elsewhere() -> None:
    receivers, casters = boxes(1, 10, 50.0), boxes(2, 10, 50.0)
    cone = LightCone.around(LAMP, receivers)
    assert cone is not None
    assert LightWindow.fitted(cone, receivers, casters + np.array([2000.0, 0.0, 0.0])[:, np.newaxis]) is None


def test_a_lamp_among_what_it_lights_has_no_one_cone() -> None:
    assert LightCone.around(np.array([0.0, 0.0, 0.0, 1.0]), boxes(1, 50, 300.0)) is None
    assert LightCone.around(LAMP, np.zeros((8, 3, 0))) is None


# ---- a lamp among what it lights

AMONG = np.array([0.0, 0.0, 0.0, 1.0])


def directions(seed: int, count: int) -> Matrix:
    """Points (1, 3, N) all around, a part of them near where two faces of a cube meet."""
    points = np.random.default_rng(seed).normal(size=(3, count))
    points[1, ::3] = points[0, ::3] * (1 + np.random.default_rng(seed + 1).normal(size=points[0, ::3].shape) * 1e-4)
    return np.asarray(points / np.linalg.norm(points, axis=0) * 300.0)[np.newaxis]


@given(SEEDS)
def test_every_direction_is_in_a_window_of_the_cube(seed: int) -> None:
    shell = directions(seed, 4000)
    windows = LightWindows.of(AMONG, None, shell, shell * 0.5)
    assert windows is not None
    assert len(windows.faces) == FACES
    assert windows.may_hold(shell).all()
    for number, face in enumerate(windows.faces):
        assert face is not None
        away = face.axes.rows[2]
        assert np.allclose(np.abs(windows.axes.rows @ away), np.eye(3)[(2, 0, 1)[number // 2]])
        assert (np.abs(face.centre) + face.half < 1.01).all()


def test_only_faces_on_which_something_is_thrown_have_a_window() -> None:
    shell = directions(3, 4000)
    casters = boxes(1, 10, 20.0) + np.array([150.0, 0.0, 0.0])[:, np.newaxis]
    windows = LightWindows.of(AMONG, None, None, np.concatenate([casters, -casters], axis=2))
    assert windows is not None
    assert sum(face is not None for face in windows.faces) == 2
    near = LightWindows.of(AMONG, None, shell, casters)
    assert near is not None
    assert len(near.faces) == 1, "all that takes the light stands on one side"


def test_faces_lie_beside_each_other_in_a_map() -> None:
    shell = directions(3, 4000) * 20.0
    windows = LightWindows.of(AMONG, None, shell, shell * 0.5)
    assert windows is not None
    laid = windows.boxes(2048, are_fine=True)
    assert len(laid) == FACES
    assert all(left.right == right.left for left, right in pairwise(laid))
    assert 3_000_000 < sum(each.width * each.height for each in laid) < 5_000_000
    assert max(max(each.width, each.height) for each in windows.boxes(512, are_fine=True)) <= 512
