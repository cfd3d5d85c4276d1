"""Discs on the ground: the ellipse they are seen as, and what casts them."""

from math import cos, radians, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.camera import Camera, project
from kagezou.geometry.card import Card
from kagezou.geometry.contact import contact_plane
from kagezou.geometry.disc import Ellipse, GroundDisc, ellipse_of_circle, floating_discs, light_over
from kagezou.geometry.ground import Plane, ground_plane
from kagezou.geometry.light import is_over
from kagezou.geometry.shadow import cast_card
from kagezou.geometry.vectors import Matrix, Vector3, height_over

FOVS = (0.0, 35.0, 80.0)


def below(camera: Camera, ground: Plane, card: Card, ellipse: Ellipse) -> Matrix:
    """Return where on the ground the rim of an ellipse casts to, (N, 2) in u and v."""
    (cast,) = cast_card(camera, ground, card, light_over(ground))
    turn, (a, b) = radians(ellipse.rotation_deg), ellipse.half_axes
    steps = np.linspace(0, 2 * np.pi, 24)
    along, across = a * np.cos(steps), b * np.sin(steps)
    x = ellipse.middle[0] + cos(turn) * along - sin(turn) * across
    y = ellipse.middle[1] + sin(turn) * along + cos(turn) * across
    canvas = np.linalg.inv(cast.art_from_canvas) @ np.vstack([x, y, np.ones_like(x)])
    u, v, w = cast.receiver_from_canvas @ canvas
    return np.asarray(np.column_stack([u / w, v / w]))


def of_plane(ground: Plane, place: Vector3) -> Matrix:
    return np.array([ground.u, ground.v]) @ np.subtract(place, ground.origin)


@given(
    fov=st.sampled_from(FOVS),
    declination=st.floats(5.0, 85.0),
    roll=st.floats(-30.0, 30.0),
    at=st.tuples(st.floats(-300.0, 300.0), st.floats(-200.0, 60.0)),
    height=st.floats(1.0, 2000.0),
)
def test_it_casts_the_disc_below_it(
    fov: float, declination: float, roll: float, at: tuple[float, float], height: float
) -> None:
    camera, ground = Camera(1000, 800, fov), ground_plane((480.0, 700.0), roll, declination)
    middle = ground.point(*at)
    found = floating_discs(camera, ground, [GroundDisc(middle, 90.0)], height)
    assert found is not None
    card, (ellipse,) = found
    rim = below(camera, ground, card, ellipse) - of_plane(ground, middle)
    assert np.hypot(*rim.T) == pytest.approx(90.0, rel=1e-4)
    assert height_over(ground.equation, (*card.pieces[0].place, 1.0)) <= height * (1 + 1e-9)
    assert is_over(ground, light_over(ground))


def test_straight_on_the_roundness_is_the_ground_s_declination() -> None:
    camera, ground = Camera(1000, 800), ground_plane((500.0, 700.0), 0.0, 70.0)
    found = floating_discs(camera, ground, [GroundDisc(ground.origin, 100.0)], 300.0)
    assert found is not None
    card, (ellipse,) = found
    assert ellipse.half_axes == pytest.approx((100.0, 100.0 * cos(radians(70.0))))
    assert ellipse.middle == pytest.approx((500.0, 700.0 - 300.0 * sin(radians(70.0))))
    assert abs(ellipse.rotation_deg) % 180 == 0
    assert card.contacts == (ground.origin,)
    line = contact_plane(card, ground)
    assert (line.origin, line.u) == (ground.origin, ground.u)


def test_it_turns_with_the_ground() -> None:
    camera, ground = Camera(1000, 800), ground_plane((500.0, 700.0), 20.0, 70.0)
    found = floating_discs(camera, ground, [GroundDisc(ground.origin, 100.0)], 300.0)
    assert found is not None
    assert found[1][0].rotation_deg % 180 == pytest.approx(20.0)


def test_edge_on_there_is_nothing_to_be_seen() -> None:
    ground = ground_plane((500.0, 700.0), 0.0, 90.0)
    assert floating_discs(Camera(1000, 800), ground, [GroundDisc(ground.origin, 100.0)], 300.0) is None
    assert floating_discs(Camera(1000, 800, 40.0), ground, [GroundDisc(ground.origin, 100.0)], 300.0) is not None


def test_what_would_reach_behind_the_eye_is_smaller() -> None:
    camera = Camera(1000, 800, 60.0)
    ground = ground_plane((500.0, 700.0), 0.0, 80.0)
    near = ground.point(0.0, 500.0)
    found = floating_discs(camera, ground, [GroundDisc(near, 5000.0)], 300.0)
    assert found is not None
    card, (ellipse,) = found
    rim = below(camera, ground, card, ellipse) - of_plane(ground, near)
    radius = np.hypot(*rim.T)
    assert radius == pytest.approx(radius[0], rel=1e-3)
    depth = camera.eye[2] - near[2]
    assert radius[0] * ground.v[2] == pytest.approx(0.9 * depth, rel=1e-3)


def test_from_below_the_ground_the_eye_does_not_lower_it() -> None:
    camera = Camera(1000, 800, 40.0)
    ground = ground_plane((500.0, 100.0), 0.0, 85.0)
    assert height_over(ground.equation, camera.eye) < 0
    found = floating_discs(camera, ground, [GroundDisc(ground.point(0.0, -100.0), 50.0)], 20.0)
    assert found is not None
    assert height_over(ground.equation, (*found[0].pieces[0].place, 1.0)) == pytest.approx(20.0)


def test_the_ellipse_of_a_homography_goes_through_the_rim() -> None:
    way = np.array([[120.0, 30.0, 400.0], [-10.0, 60.0, 300.0], [0.0002, 0.0003, 1.0]])
    ellipse = ellipse_of_circle(way)
    turn = radians(ellipse.rotation_deg)
    for step in np.linspace(0, 2 * np.pi, 13):
        x, y = project(way, (float(np.cos(step)), float(np.sin(step))))
        dx, dy = x - ellipse.middle[0], y - ellipse.middle[1]
        along, across = cos(turn) * dx + sin(turn) * dy, cos(turn) * dy - sin(turn) * dx
        a, b = ellipse.half_axes
        assert (along / a) ** 2 + (across / b) ** 2 == pytest.approx(1.0, abs=1e-6)
