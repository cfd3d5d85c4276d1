"""A mesh out of any triangles."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.mesh_making import mesh_of

SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], np.float64)


def lines_of(points: object, corners: object) -> set[tuple[tuple[float, ...], ...]]:
    mesh = mesh_of(np.array(points, np.float64), np.array(corners))
    return {tuple(sorted(tuple(map(float, end)) for end in ends)) for ends in mesh.vertices[mesh.lines]}


def test_equal_points_are_one_whatever_their_sign_of_zero() -> None:
    points = np.concatenate([SQUARE, SQUARE * np.array([1, 1, -1])])
    mesh = mesh_of(points, np.array([[0, 1, 2], [4, 6, 7]]))
    assert len(mesh.vertices) == 4
    # The diagonal is inside of a flat face.
    assert len(mesh.lines) == 4


def test_points_that_nothing_uses_and_triangles_without_an_area_go() -> None:
    points = np.array([*SQUARE, [np.nan, 0, 0], [2, 0, 0]])
    mesh = mesh_of(points, np.array([[0, 1, 2], [0, 0, 2], [0, 1, 5]]))
    assert len(mesh.triangles) == 1
    assert len(mesh.vertices) == 3
    assert np.isfinite(mesh.vertices).all()


def test_of_nothing_with_an_area_nothing_is_left() -> None:
    mesh = mesh_of(SQUARE, np.array([[0, 0, 1], [2, 2, 2]]))
    assert (len(mesh.vertices), len(mesh.triangles), len(mesh.lines)) == (0, 0, 0)


@pytest.mark.parametrize(("angle_deg", "is_crease"), [(29.0, False), (31.0, True), (179.0, True)])
@pytest.mark.parametrize("is_inside_out", [False, True])
def test_a_fold_is_a_line_from_thirty_degrees_on(angle_deg: float, *, is_crease: bool, is_inside_out: bool) -> None:
    turn = np.radians(angle_deg)
    points = [[0, 0, 0], [0, 1, 0], [-1, 0, 0], [np.cos(turn), 0, np.sin(turn)]]
    corners = [[0, 1, 2], [0, 1, 3] if is_inside_out else [1, 0, 3]]
    fold = ((0.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    assert (fold in lines_of(points, corners)) == is_crease


def test_where_three_faces_meet_there_is_a_line() -> None:
    points = [[0, 0, 0], [0, 1, 0], [-1, 0, 0], [1, 0, 0], [0, 0, 1]]
    assert ((0.0, 0.0, 0.0), (0.0, 1.0, 0.0)) in lines_of(points, [[0, 1, 2], [1, 0, 3], [0, 1, 4]])


@given(st.lists(st.tuples(*[st.integers(-2, 2)] * 3), min_size=3, max_size=30), st.integers(0, 2**31))
def test_every_triangle_keeps_its_place_and_turn(points: list[tuple[int, int, int]], seed: int) -> None:
    count = len(points)
    pick = np.random.default_rng(seed).integers(0, count, (12, 3))
    places = np.array(points, np.float64)
    mesh = mesh_of(places, pick)
    a, b, c = places[pick].transpose(1, 0, 2)
    has_area = np.linalg.norm(np.cross(b - a, c - a), axis=1) > 0
    assert np.array_equal(mesh.vertices[mesh.triangles], places[pick][has_area])
    assert len({tuple(each) for each in mesh.vertices}) == len(mesh.vertices)
