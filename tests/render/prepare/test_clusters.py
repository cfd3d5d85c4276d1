"""Clusters of triangles: every triangle is in one, and none that is seen is left out."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from kagezou.render.prepare.clusters import Clusters, near_together

SEEDS = st.integers(0, 2**32)


def triangles(seed: int, count: int = 5000) -> np.ndarray:
    """Small triangles (N, 3, 3) all over a flat box."""
    rng = np.random.default_rng(seed)
    middles = rng.uniform(-1, 1, (count, 1, 3)) * [500.0, 80.0, 300.0]
    return np.asarray(middles + rng.uniform(-6, 6, (count, 3, 3)))


def drawn(runs: list[tuple[int, int]], count: int) -> np.ndarray:
    flags = np.zeros(count, int)
    for first, many in runs:
        flags[first : first + many] += 1
    return flags


@given(SEEDS)
def test_no_triangle_that_may_be_seen_is_left_out(seed: int) -> None:
    corners = triangles(seed)
    corners = corners[near_together(corners)]
    rows = np.random.default_rng(seed + 1).normal(size=(4, 4)) * [0.01, 0.01, 0.01, 1.0]
    x, y, z, w = rows @ np.concatenate([corners, np.ones((len(corners), 3, 1))], axis=2).reshape(-1, 4).T
    forms = np.array([w - x, w + x, w - y, w + y, w - z, w + z]).reshape(6, -1, 3)
    may_be_seen = (forms.max(axis=2) >= 0).all(axis=0)
    flags = drawn(Clusters.of(corners).runs(rows), len(corners))
    assert flags.max() <= 1
    assert flags[may_be_seen].all()


def test_most_of_what_is_not_seen_is_left_out() -> None:
    corners = triangles(3, 60_000)
    corners = corners[near_together(corners)]
    clusters = Clusters.of(corners)
    # A tenth of the width.
    rows = np.diag([1 / 50.0, 1 / 1000.0, 1 / 1000.0, 1.0])
    assert drawn(clusters.runs(rows), len(corners)).sum() < len(corners) / 4
    assert clusters.runs(np.diag([1.0, 1.0, 1.0, -1e9])) == []


def test_the_order_keeps_every_triangle_and_the_hulls_hold_them() -> None:
    corners = triangles(7)
    order = near_together(corners)
    assert (np.sort(order) == np.arange(len(corners))).all()
    clusters = Clusters.of(corners[order])
    assert clusters.firsts[-1] == len(corners)
    hulls = clusters.hulls()
    owners = np.repeat(np.arange(hulls.shape[2]), np.diff(clusters.firsts))
    assert (corners[order].min(axis=1) >= hulls.min(axis=0).T[owners]).all()
    assert (corners[order].max(axis=1) <= hulls.max(axis=0).T[owners]).all()


def test_a_mesh_without_triangles_has_no_clusters() -> None:
    nothing = np.zeros((0, 3, 3))
    assert len(near_together(nothing)) == 0
    assert Clusters.of(nothing).hulls().shape == (8, 3, 0)
    assert Clusters.of(nothing).runs(np.eye(4)) == []
