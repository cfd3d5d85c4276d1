"""The mirrored eye: mirrored rays start from it, and what they meet is found by the homographies of shadows."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera, project
from kagezou.geometry.card import Card, vertical_piece
from kagezou.geometry.ground import ground_plane
from kagezou.geometry.polygon import box_polygon
from kagezou.geometry.reflection import away_from_mirrored_eye, mirrored_region
from kagezou.geometry.shadow import cast_card

CANVAS = Box(0, 0, 1000, 800)


@given(
    fov=st.sampled_from([0.0, 35.0, 80.0]),
    declination=st.floats(5.0, 85.0),
    roll=st.floats(-30.0, 30.0),
    slope=st.floats(-1.0, 1.0),
    at=st.tuples(st.floats(100.0, 900.0), st.floats(80.0, 660.0)),
)
def test_a_point_of_the_card_is_mirrored_at_its_image_below_the_ground(
    fov: float, declination: float, roll: float, slope: float, at: tuple[float, float]
) -> None:
    """By construction: the eye sees a point's mirror image where the homography finds the point itself."""
    camera, ground = Camera(1000, 800, fov), ground_plane((480.0, 700.0), roll, declination)
    piece = vertical_piece((480.0, 0.0), slope)
    light = away_from_mirrored_eye(camera, ground)
    assert light is not None
    casts = cast_card(camera, ground, Card((piece,)), light)
    eye = np.array(camera.eye)
    start = np.array([*at, 0.0])
    along = np.array([0.0, 0.0, -1.0]) if fov == 0 else start - eye[:3]
    normal = np.array(piece.normal)
    way = ((np.array(piece.place) - start) @ normal) / (along @ normal)
    point = start + way * along
    image = point - 2 * float(np.array(ground.equation) @ [*point, 1.0]) * np.array(ground.normal)
    in_front = fov == 0 or (point[2] < 0.8 * eye[2] and image[2] < 0.8 * eye[2])
    above = float(np.array(ground.equation) @ [*point, 1.0])
    if not casts or above < 1.0 or not in_front:
        return
    seen = project(camera.canvas_from_world(), (float(image[0]), float(image[1]), float(image[2]), 1.0))
    x, y, w = casts[0].art_from_canvas @ (*seen, 1.0)
    assert w > 0
    assert (x / w, y / w) == pytest.approx(at, abs=1e-4)


def test_an_eye_that_does_not_look_down_on_the_ground_sees_nothing_in_it() -> None:
    assert away_from_mirrored_eye(Camera(1000, 800), ground_plane((500.0, 700.0), 0.0, 90.0)) is None
    below = ground_plane((500.0, 100.0), 0.0, 90.0)
    assert away_from_mirrored_eye(Camera(1000, 800, 40.0), below) is None


def test_rays_that_never_come_to_the_card_are_left_out() -> None:
    """Behind a card that leans over the eye the mirrored rays run away from it."""
    camera, ground = Camera(1000, 800, 80.0), ground_plane((500.0, 300.0), 0.0, 60.0)
    light = away_from_mirrored_eye(camera, ground)
    assert light is not None
    (cast,) = cast_card(camera, ground, Card((vertical_piece((500.0, 0.0), 3.0),)), light)
    region = mirrored_region(cast, box_polygon(CANVAS))
    assert len(region) > 0
    w = cast.art_from_canvas[2] @ np.column_stack([region, np.ones(len(region))]).T
    assert (w >= -1e-9).all()
    whole = cast.art_from_canvas[2] @ np.column_stack([box_polygon(CANVAS), np.ones(4)]).T
    assert (whole < 0).any()
