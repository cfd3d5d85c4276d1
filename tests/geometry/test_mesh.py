"""Meshes, rays that meet them, and the cameras of their files."""

from math import hypot

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.mesh import Mesh
from kagezou.geometry.mesh_ray import first_hit
from kagezou.geometry.set_camera import SetCamera

POSE = np.array([[1.0, 0, 0, 2], [0, 1, 0, 3], [0, 0, 1, 10], [0, 0, 0, 1]])


def terrain(side: int = 12) -> Mesh:
    """A hilly square from -1 to 1, z = sin 3x · cos 2y / 4."""
    x, y = np.meshgrid(np.linspace(-1, 1, side), np.linspace(-1, 1, side))
    vertices = np.stack([x, y, np.sin(3 * x) * np.cos(2 * y) / 4], axis=-1).reshape(-1, 3)
    corner = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).ravel()
    first = np.stack([corner, corner + 1, corner + side], axis=1)
    second = np.stack([corner + 1, corner + side + 1, corner + side], axis=1)
    return Mesh(vertices, np.concatenate([first, second]).astype(np.int32), np.zeros((0, 2), np.int32))


def test_a_mesh_cannot_be_changed() -> None:
    mesh = terrain(3)
    with pytest.raises(ValueError, match="read-only"):
        mesh.vertices[0] = 1.0
    low, high = mesh.corners
    assert (low[0], high[1]) == (-1.0, 1.0)
    assert mesh.nbytes == 9 * 24 + 8 * 12


@given(st.floats(-0.95, 0.95), st.floats(-0.95, 0.95), st.floats(-0.2, 0.2), st.floats(-0.2, 0.2))
def test_a_ray_from_above_meets_the_terrain_where_it_is(x: float, y: float, dx: float, dy: float) -> None:
    mesh = terrain()
    hit = first_hit(mesh, np.array([x - 5 * dx, y - 5 * dy, 5.0]), np.array([dx, dy, -1.0]))
    if hit is None:
        # The slanted ray may leave the square before it comes down.
        assert hypot(dx, dy) > 0.01
        return
    part = 5.0 - hit[2]
    assert (hit[0], hit[1]) == pytest.approx((x - 5 * dx + part * dx, y - 5 * dy + part * dy))
    assert hit[2] == pytest.approx(np.sin(3 * hit[0]) * np.cos(2 * hit[1]) / 4, abs=0.02)


def test_the_nearest_of_several_counts_and_nothing_behind_does() -> None:
    far, near = terrain().vertices, terrain().vertices + np.array([0, 0, 1.0])
    triangles = terrain().triangles
    both = Mesh(np.concatenate([far, near]), np.concatenate([triangles, triangles + len(far)]), triangles[:0, :2])
    down = first_hit(both, np.array([0.1, 0.2, 5.0]), np.array([0.0, 0.0, -1.0]))
    up = first_hit(both, np.array([0.1, 0.2, -5.0]), np.array([0.0, 0.0, 1.0]))
    assert down is not None
    assert up is not None
    assert down[2] - up[2] == pytest.approx(1.0)
    assert first_hit(both, np.array([0.1, 0.2, 5.0]), np.array([0.0, 0.0, 1.0])) is None
    assert first_hit(both, np.array([3.0, 0.2, 5.0]), np.array([0.0, 0.0, -1.0])) is None


def test_what_a_camera_sees_in_perspective_and_without() -> None:
    wide = SetCamera("a", is_perspective=True, height=90.0, aspect=1.0, poses=POSE[None])
    assert wide.sees((2.0, 3.0, 0.0), 1, (200.0, 100.0)) == (100.0, 50.0)
    assert wide.sees((2.0, 8.0, 0.0), 1, (200.0, 100.0)) == pytest.approx((100.0, 25.0))
    flat = SetCamera("b", is_perspective=False, height=4.0, aspect=1.0, poses=POSE[None])
    assert flat.sees((3.0, 3.0, -7.0), 1, (200.0, 100.0)) == pytest.approx((125.0, 50.0))


def test_a_moving_camera_stands_still_before_and_after() -> None:
    poses = np.stack([POSE, POSE + np.eye(4)[:, :1] @ [[0, 0, 0, 1.0]]])
    camera = SetCamera("c", is_perspective=True, height=40.0, aspect=0.0, poses=poses)
    assert camera.is_animated
    assert [camera.pose(frame)[0, 3] for frame in (0, 1, 2, 9)] == [2.0, 2.0, 3.0, 3.0]
    assert not SetCamera("d", is_perspective=True, height=40.0, aspect=0.0, poses=POSE[None]).is_animated
