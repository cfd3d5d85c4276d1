"""The camera that leaves the drawing alone, and the ground it looks at."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.camera import Camera, project
from kagezou.geometry.ground import ground_plane, place_on, world_from_canvas_on
from kagezou.geometry.vectors import dot, height_over

canvas_points = st.tuples(st.floats(-500, 1500), st.floats(-500, 1500))


@given(st.one_of(st.just(0.0), st.floats(1, 120)), canvas_points)
def test_the_drawing_is_never_changed_by_the_camera(fov: float, point: tuple[float, float]) -> None:
    matrix = Camera(1000, 800, fov).canvas_from_world()
    assert project(matrix, (*point, 0.0, 1.0)) == pytest.approx(point, abs=1e-9)


def test_an_orthographic_camera_looks_along_z() -> None:
    camera = Camera(1000, 800)
    assert camera.eye == (0.0, 0.0, 1.0, 0.0)
    assert project(camera.canvas_from_world(), (3.0, 4.0, 99.0, 1.0)) == (3.0, 4.0)
    assert camera.toward_eye((3.0, 4.0, 5.0, 1.0)) == (0.0, 0.0, 1.0)


def test_a_pinhole_stands_before_the_middle_of_the_canvas() -> None:
    camera = Camera(1000, 800, 90.0)
    assert camera.eye == pytest.approx((500.0, 400.0, 400.0, 1.0))
    assert camera.toward_eye((500.0, 400.0, 100.0, 1.0)) == pytest.approx((0.0, 0.0, 300.0))
    halfway = project(camera.canvas_from_world(), (600.0, 400.0, 200.0, 1.0))
    assert halfway == pytest.approx((700.0, 400.0))
    behind = camera.canvas_from_world() @ np.array([600.0, 400.0, 500.0, 1.0])
    assert behind[2] < 0


@given(st.floats(-90, 90), st.floats(1, 90))
def test_the_axes_of_the_ground_are_orthonormal_and_up_is_up(roll: float, declination: float) -> None:
    plane = ground_plane((10.0, 20.0), roll, declination)
    for axis in (plane.u, plane.v, plane.normal):
        assert dot(axis, axis) == pytest.approx(1.0)
    for a, b in ((plane.u, plane.v), (plane.v, plane.normal), (plane.normal, plane.u)):
        assert dot(a, b) == pytest.approx(0.0, abs=1e-12)
    assert height_over(plane.equation, (*plane.point(30.0, -40.0), 1.0)) == pytest.approx(0.0, abs=1e-9)
    above = tuple(place + axis for place, axis in zip(plane.origin, plane.normal, strict=True))
    assert height_over(plane.equation, (above[0], above[1], above[2], 1.0)) == pytest.approx(1.0)


def test_the_ground_by_the_definition() -> None:
    plane = ground_plane((100.0, 200.0), 0.0, 60.0)
    assert plane.v == pytest.approx((0.0, 0.5, 3**0.5 / 2))
    assert plane.normal == pytest.approx((0.0, -(3**0.5) / 2, 0.5))
    assert ground_plane((0.0, 0.0), 0.0, 90.0).normal == pytest.approx((0.0, -1.0, 0.0), abs=1e-15)


@given(st.one_of(st.just(0.0), st.floats(5, 90)), st.floats(-200, 200), st.floats(-200, 200))
def test_a_place_on_the_ground_is_found_where_it_is_seen(fov: float, u: float, v: float) -> None:
    camera, plane = Camera(1000, 800, fov), ground_plane((500.0, 600.0), 10.0, 70.0)
    place = plane.point(u, v)
    seen = project(camera.canvas_from_world(), (*place, 1.0))
    assert place_on(camera, plane, seen) == pytest.approx(place, abs=1e-6)


def test_there_is_no_ground_at_and_over_the_horizon() -> None:
    camera, plane = Camera(1000, 800, 60.0), ground_plane((500.0, 600.0), 0.0, 80.0)
    lift = world_from_canvas_on(camera, plane)
    assert lift is not None
    a, b, c = lift[3]
    assert a == pytest.approx(0.0, abs=1e-12)
    horizon = -c / b
    assert place_on(camera, plane, (500.0, horizon + 1)) is not None
    assert place_on(camera, plane, (500.0, horizon)) is None
    assert place_on(camera, plane, (500.0, horizon - 1)) is None


def test_a_ground_edge_on_has_no_places() -> None:
    camera, plane = Camera(1000, 800), ground_plane((500.0, 600.0), 0.0, 90.0)
    assert world_from_canvas_on(camera, plane) is None
    assert place_on(camera, plane, (500.0, 700.0)) is None


@pytest.mark.parametrize("fov_deg", [5e-324, 1e-300, 1e-9])
def test_a_view_too_narrow_to_tell_is_orthographic(fov_deg: float) -> None:
    assert Camera(200, 100, fov_deg).eye == Camera(200, 100).eye
