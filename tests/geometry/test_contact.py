"""The line in which a card meets the ground, and looking at a cast through another picture of its receiver."""

import numpy as np
import pytest

from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.card import Card, card_for, vertical_piece
from kagezou.geometry.contact import contact_plane
from kagezou.geometry.ground import canvas_from_plane, ground_plane, place_on
from kagezou.geometry.polygon import seen_rectangle
from kagezou.geometry.shadow import cast_on
from kagezou.geometry.vectors import Vector3

CAMERA = Camera(1000, 1000, 30.0)
GROUND = ground_plane((500.0, 800.0), 4.0, 62.0)


def v_of(point: Vector3, card: Card) -> float:
    plane = contact_plane(card, GROUND)
    return float((np.array(point) - np.array(plane.origin)) @ np.array(plane.v))


def test_an_upright_card_meets_the_ground_where_its_plane_does() -> None:
    card = card_for(CAMERA, GROUND, [], 0.0, 500.0)
    plane = contact_plane(card, GROUND)
    assert plane.normal == GROUND.normal
    assert plane.origin == GROUND.origin
    assert np.array(plane.u)[2] == pytest.approx(0.0, abs=1e-12)
    assert np.cross(plane.normal, plane.u) == pytest.approx(np.array(plane.v))


@pytest.mark.parametrize("tilt", [-40.0, 25.0])
def test_a_turned_card_turns_its_line(tilt: float) -> None:
    card = card_for(CAMERA, GROUND, [(450.0, 790.0)], tilt, 500.0)
    plane = contact_plane(card, GROUND)
    along = np.array(plane.origin) + 100 * np.array(plane.u)
    assert np.array(card.pieces[0].plane[:3]) @ along + card.pieces[0].plane[3] == pytest.approx(0.0, abs=1e-9)


def test_the_contacts_of_two_points_lie_on_the_line() -> None:
    points = [(420.0, 790.0), (580.0, 805.0)]
    card = card_for(CAMERA, GROUND, points, 0.0, 500.0)
    for point in points:
        place = place_on(CAMERA, GROUND, point)
        assert place is not None
        assert v_of(place, card) == pytest.approx(0.0, abs=1e-9)


def test_a_folded_card_has_the_line_through_its_outermost_contacts() -> None:
    card = card_for(CAMERA, GROUND, [(400.0, 790.0), (500.0, 770.0), (600.0, 800.0)], 0.0, 500.0)
    first, middle, last = card.contacts
    assert v_of(first, card) == pytest.approx(0.0, abs=1e-9)
    assert v_of(last, card) == pytest.approx(0.0, abs=1e-9)
    assert abs(v_of(middle, card)) > 5


def test_a_card_in_the_ground_takes_the_grounds_own_line() -> None:
    flat = ground_plane((0.0, 0.0), 0.0, 0.0)
    assert contact_plane(Card((vertical_piece((0.0, 0.0), 0.0),)), flat).u == flat.u


def test_the_line_always_runs_the_grounds_way() -> None:
    for tilt in (-70.0, 0.0, 70.0):
        plane = contact_plane(card_for(CAMERA, GROUND, [], tilt, 500.0), GROUND)
        assert np.array(plane.u) @ np.array(GROUND.u) > 0


def test_a_cast_seen_from_above_is_the_same_shadow() -> None:
    card = card_for(CAMERA, GROUND, [], 20.0, 500.0)
    plane = contact_plane(card, GROUND)
    cast = cast_on(CAMERA, GROUND, card.pieces[0], (300.0, -300.0, 900.0, 1.0))
    assert cast is not None
    forward = canvas_from_plane(CAMERA, plane)
    above = cast.seen_through(forward)
    for u, v in ((-100.0, -150.0), (40.0, -300.0)):
        canvas = forward @ np.array([u, v, 1.0])
        art = [form @ point for form, point in ((cast.art_from_canvas, canvas), (above.art_from_canvas, [u, v, 1.0]))]
        assert art[0][:2] / art[0][2] == pytest.approx(art[1][:2] / art[1][2])
        assert above.horizon @ np.array([u, v, 1.0]) > 0
        assert (above.side @ np.array([u, v, 1.0]) > 0) == (cast.side @ canvas > 0)


def test_a_rectangle_of_the_ground_is_seen_where_its_points_are() -> None:
    back = np.asarray(np.linalg.inv(canvas_from_plane(CAMERA, GROUND)), np.float64)
    polygon = seen_rectangle(Box(0, 0, 1000, 1000), back, (-100.0, -200.0), (150.0, -50.0))
    corners = (
        canvas_from_plane(CAMERA, GROUND) @ np.array([[-100, -200, 1], [150, -200, 1], [150, -50, 1], [-100, -50, 1]]).T
    )
    seen = (corners[:2] / corners[2]).T
    assert polygon.min(axis=0) == pytest.approx(seen.min(axis=0), abs=3.0)
    assert polygon.max(axis=0) == pytest.approx(seen.max(axis=0), abs=3.0)
    assert len(seen_rectangle(Box(0, 0, 10, 10), back, (-100.0, -200.0), (150.0, -50.0))) == 0
