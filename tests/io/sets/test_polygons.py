"""Polygons as triangles: what a polygon leaves open stays open, whatever its shape and wherever it lies."""

from collections.abc import Sequence

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from kagezou.io.sets import polygons
from kagezou.io.sets.polygons import triangulated
from kagezou.io.sets.triangles import Triangles

DOORWAY = [(-3, 0), (-1, 0), (-1, 3), (1, 3), (1, 0), (3, 0), (3, 4), (-3, 4)]
KEYHOLE = [(0, 0), (4, 0), (4, 4), (0, 4), (0, 0), (1, 1), (1, 3), (3, 3), (3, 1), (1, 1)]
STAR = [(r * np.cos(a), r * np.sin(a)) for a, r in zip(np.arange(10) * np.pi / 5, [2, 1] * 5, strict=True)]
COMB = [(0, 0), (9, 0), (9, 2), *((x, 2 - 1.9 * (x % 2)) for x in range(8, 0, -1)), (0, 2)]

Places = Sequence[tuple[float, float]]


def cut(flat: Places, turn: NDArray[np.float64] | None = None) -> Triangles:
    points = np.c_[np.array(flat, float), np.zeros(len(flat))]
    points = points if turn is None else points @ turn.T + [1e3, -20.0, 7.0]
    return triangulated(points, np.array([len(flat)]), np.arange(len(flat)))


def areas(found: Triangles) -> NDArray[np.float64]:
    a, b, c = (found.points[found.corners[:, corner]] for corner in range(3))
    return np.asarray(np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2)


def area_of(flat: Places) -> float:
    x, y = np.array(flat, float).T
    return abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1))) / 2


def turned(x: float, y: float) -> NDArray[np.float64]:
    one = np.array([[1, 0, 0], [0, np.cos(x), -np.sin(x)], [0, np.sin(x), np.cos(x)]])
    return np.asarray(one @ np.array([[np.cos(y), 0, np.sin(y)], [0, 1, 0], [-np.sin(y), 0, np.cos(y)]]))


@pytest.mark.parametrize("flat", [DOORWAY, KEYHOLE, STAR, COMB, [(0, 0), (2, 1), (0, 2), (1, 1)]])
@pytest.mark.parametrize("start", range(4))
@pytest.mark.parametrize("runs", [1, -1])
@pytest.mark.parametrize("turn", [(0.0, 0.0), (1.2, 0.4), (np.pi / 2, 0.0)])
def test_polygons_with_corners_inward(flat: Places, start: int, runs: int, turn: tuple[float, float]) -> None:
    flat = [*flat[start:], *flat[:start]][::runs]
    found = cut(flat, turned(*turn))
    assert areas(found).sum() == pytest.approx(area_of(flat), rel=1e-9)
    assert not found.notes


def test_a_doorway_is_open() -> None:
    found = cut(DOORWAY)
    middles = found.points[found.corners].mean(axis=1)
    assert len(middles) == 6
    assert not ((np.abs(middles[:, 0]) < 1) & (middles[:, 1] < 3)).any()


@pytest.mark.parametrize(
    "flat",
    [[(0, 0), (1, 0), (2, 0), (2, 2), (0, 2)], [(0, 0), (0, 0), (2, 0), (2, 2), (2, 2), (0, 2)],
     [(0, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)], [(0, 0), (2, 0), (2, 2), (0, 2), (0, 0)]],
)  # fmt: skip
def test_corners_on_lines_and_corners_twice(flat: Places) -> None:
    assert areas(cut(flat)).sum() == pytest.approx(4)


def test_bow_ties_are_both_of_their_loops() -> None:
    found = cut([(0, 0), (2, 2), (2, 0), (0, 2)])
    assert areas(found).sum() == pytest.approx(2)
    assert [str(note) for note in found.notes] == ["1 of its faces cross or touch themselves: every loop is filled"]
    crooked = cut([(0, 0), (4, 0), (4, 3), (1, -1), (0, 3)])
    assert areas(crooked).sum() == pytest.approx(3.375 + 1.125 + 0.5)
    assert crooked.notes


def test_rings_that_touch_themselves_at_a_corner_are_all_of_their_loops() -> None:
    assert areas(cut([(0, 0), (1, 0), (0, 1), (0, 0), (1, 0), (0, -2)])).sum() == pytest.approx(1.5)
    assert areas(cut([(0, 0), (2, 0), (1, 1), (2, 2), (0, 2), (1, 1)])).sum() == pytest.approx(2)


def test_bent_quadrangles_keep_their_four_corners() -> None:
    points = np.array([[0, 0, 0], [1, 0, 0.3], [1, 1, 0], [0, 1, 0.3]])
    found = triangulated(points, np.array([4]), np.arange(4))
    assert len(found.corners) == 2
    assert sorted(set(found.corners.ravel().tolist())) == [0, 1, 2, 3]


def test_what_has_no_area_is_nothing_and_what_has_few_corners_is_said() -> None:
    assert areas(cut([(0, 0), (1, 1), (2, 2), (3, 3)])).sum() == 0
    assert len(cut([(5, 5)] * 6).corners) == 0
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0.0]])
    found = triangulated(points, np.array([2, 3, 1]), np.array([0, 1, 0, 1, 2, 0]))
    assert found.corners.tolist() == [[0, 1, 2]]
    assert str(found.notes[0]) == "2 of its faces have fewer than three corners and are not used"


def test_many_polygons_of_many_sizes_keep_their_corners() -> None:
    shapes = [DOORWAY, [(0, 0), (1, 0), (0, 1)], STAR, [(0, 0), (1, 0), (1, 1), (0, 1)], DOORWAY]
    flat = np.concatenate([np.array(shape, float) + 20 * number for number, shape in enumerate(shapes)])
    counts = np.array([len(shape) for shape in shapes])
    found = triangulated(np.c_[flat, np.zeros(len(flat))], counts, np.arange(len(flat)))
    assert areas(found).sum() == pytest.approx(sum(map(area_of, shapes)))
    assert found.corners.max() == len(flat) - 1


def test_polygons_that_would_take_too_long_are_left_out_and_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(polygons, "MAX_CORNERS", 7)
    found = cut(DOORWAY)
    assert not len(found.corners)
    assert "left out" in str(found.notes[0])
    tangle = [(float(x), float(y)) for x, y in np.random.default_rng(1).random((301, 2))]
    monkeypatch.undo()
    assert "left out" in str(cut(tangle).notes[0])


@given(st.lists(st.tuples(st.integers(-9, 9), st.integers(-9, 9)), min_size=4, max_size=12))
def test_any_ring_is_cut_into_triangles_of_its_own_corners_or_crossings(ring: list[tuple[int, int]]) -> None:
    flat = [(float(x), float(y)) for x, y in ring]
    found = cut(flat)
    assert np.isfinite(found.points).all()
    if len(found.corners):
        assert 0 <= found.corners.min() <= found.corners.max() < len(found.points)
    if not found.notes:
        assert areas(found).sum() == pytest.approx(area_of(flat), abs=1e-5)
