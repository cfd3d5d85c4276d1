"""Places as the camera sees them: true before the eye, finite beside and behind it."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.camera import Camera, project
from kagezou.geometry.sight import MIN_DEPTH, depth_of, seen

CAMERA = Camera(1000, 800, 40.0)
DISTANCE = CAMERA.eye[2]

coordinates = st.floats(-3000, 3000)


@given(coordinates, coordinates, st.floats(-5000, 900), st.sampled_from([0.0, 40.0]))
def test_before_the_eye_it_is_the_projection(x: float, y: float, z: float, fov: float) -> None:
    camera = Camera(1000, 800, fov)
    matrix = camera.canvas_from_world()
    assert seen(camera, (x, y, z)) == pytest.approx(project(matrix, (x, y, z, 1.0)), abs=1e-6)
    assert depth_of(camera, (x, y, z)) == pytest.approx(float(matrix[2] @ (x, y, z, 1.0)))


def test_behind_the_eye_a_place_is_seen_as_from_the_least_depth() -> None:
    assert depth_of(CAMERA, (0.0, 0.0, 2 * DISTANCE)) == pytest.approx(-1.0)
    assert seen(CAMERA, (510.0, 400.0, 2 * DISTANCE)) == pytest.approx((500.0 + 10.0 / MIN_DEPTH, 400.0))
    least = (1 - MIN_DEPTH) * DISTANCE
    assert seen(CAMERA, (510.0, 400.0, least)) == pytest.approx(seen(CAMERA, (510.0, 400.0, 2 * DISTANCE)))
