"""The card: how a drawing stands with no, one, two and more grounding points."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.card import MAX_SLOPE_DEG, CardPiece, card_for, receiver_of, vertical_piece
from kagezou.geometry.ground import ground_plane, place_on
from kagezou.geometry.relief import Foothold, relief_card
from kagezou.geometry.vectors import Point2, coinciding, dot, height_over

CAMERA = Camera(1000, 1000)
GROUND = ground_plane((500.0, 800.0), 0.0, 60.0)
SLANT = 3**0.5
"""Depth for each pixel up the screen on this ground: tan 60°."""


def slope_of(piece: CardPiece) -> float:
    """Return dz/dx of a vertical piece."""
    nx, ny, nz = piece.normal
    assert (ny, nz) == (0.0, 1.0)
    return -nx


def test_without_points_the_card_stands_on_the_ground_line() -> None:
    card = card_for(CAMERA, GROUND, [], 0.0, 300.0)
    (piece,) = card.pieces
    assert (piece.place[2], piece.normal, piece.limits) == (0.0, (0.0, 0.0, 1.0), ())
    assert card.contacts == ()
    turned = card_for(CAMERA, GROUND, [], 45.0, 300.0)
    assert slope_of(turned.pieces[0]) == pytest.approx(1.0)
    assert (turned.pieces[0].place[0], turned.tilt_deg) == (500.0, 45.0)


def test_with_one_point_it_passes_through_that_place() -> None:
    card = card_for(CAMERA, GROUND, [(400.0, 780.0)], 0.0, 300.0)
    (piece,) = card.pieces
    assert piece.place == pytest.approx((400.0, 0.0, -20.0 * SLANT))
    assert piece.normal == (0.0, 0.0, 1.0)
    turned = card_for(CAMERA, GROUND, [(400.0, 780.0)], -30.0, 300.0)
    assert slope_of(turned.pieces[0]) == pytest.approx(-(3**-0.5))
    assert turned.tilt_deg == -30.0


def test_with_two_points_the_tilt_is_measured() -> None:
    card = card_for(CAMERA, GROUND, [(600.0, 800.0), (400.0, 780.0)], 33.0, 300.0)
    (piece,) = card.pieces
    assert slope_of(piece) == pytest.approx(20 * SLANT / 200)
    assert card.tilt_deg == pytest.approx(9.826, abs=1e-3)
    assert [place[0] for place in card.contacts] == [400.0, 600.0]


def test_with_three_points_it_is_folded_at_the_middle_one() -> None:
    card = card_for(CAMERA, GROUND, [(300.0, 800.0), (500.0, 850.0), (700.0, 790.0)], 20.0, 300.0)
    left, right = card.pieces
    assert (left.limits, right.limits) == (((-1.0, 0.0, 500.0),), ((1.0, 0.0, -500.0),))
    assert left.adjoins(right)
    assert not left.adjoins(left)
    assert slope_of(left) > 0 > slope_of(right)
    assert card.tilt_deg == 0.0
    assert not card.merged


def test_stood_up_it_goes_through_its_points_and_rises_along_the_ground_s_normal() -> None:
    points = [(300.0, 800.0), (500.0, 850.0), (700.0, 790.0)]
    card = card_for(CAMERA, GROUND, points, 20.0, 300.0, 1.0)
    left, right = card.pieces
    assert (card.upright, card.contacts) == (1.0, card_for(CAMERA, GROUND, points, 20.0, 300.0).contacts)
    assert left.adjoins(right)
    for piece, feet in ((left, card.contacts[:2]), (right, card.contacts[1:])):
        assert dot(piece.normal, GROUND.normal) == pytest.approx(0.0, abs=1e-9)
        assert [height_over(piece.plane, (*foot, 1.0)) for foot in feet] == pytest.approx([0.0, 0.0], abs=1e-6)


@pytest.mark.parametrize(
    "points",
    [
        [(500.0, 780.0), (505.0, 790.0)],
        [(500.0, 780.0), (500.0, 780.0)],
        [(500.0, 700.0), (510.0, 790.0)],
    ],
    ids=["closer than 2 % of the height", "the same place", "steeper than 75°"],
)
def test_points_too_close_or_too_steep_count_as_their_middle(points: list[Point2]) -> None:
    card = card_for(CAMERA, GROUND, points, 40.0, 300.0)
    (piece,) = card.pieces
    assert card.merged
    assert (piece.normal, card.tilt_deg) == ((0.0, 0.0, 1.0), 0.0)
    (place,) = card.contacts
    middle = ((points[0][0] + points[1][0]) / 2, (points[0][1] + points[1][1]) / 2)
    assert place == pytest.approx(place_on(CAMERA, GROUND, middle))


def test_neighbours_that_change_sides_in_the_world_count_as_one() -> None:
    camera, ground = Camera(1000, 1000, 100.0), ground_plane((500.0, 600.0), 0.0, 80.0)
    seen = [(300.0, 990.0), (320.0, 600.0)]
    near, far = (place_on(camera, ground, point) for point in seen)
    assert near is not None
    assert far is not None
    assert near[0] > far[0]
    card = card_for(camera, ground, seen, 0.0, 300.0)
    assert card.merged
    assert len(card.pieces) == len(card.contacts) == 1


def test_a_point_in_the_sky_is_left_out() -> None:
    camera, ground = Camera(1000, 1000, 60.0), ground_plane((500.0, 800.0), 0.0, 80.0)
    assert card_for(camera, ground, [(500.0, -900.0)], 0.0, 300.0).contacts == ()
    assert len(card_for(camera, ground, [(500.0, -900.0), (400.0, 820.0)], 0.0, 300.0).contacts) == 1


@given(st.lists(st.tuples(st.floats(0, 1000), st.floats(500, 1000)), max_size=8), st.floats(-90, 90))
def test_any_points_make_a_card_that_stands_on_the_ground(points: list[Point2], tilt: float) -> None:
    card = card_for(CAMERA, GROUND, points, tilt, 300.0)
    for x in (-1e6, 317.3, 1e6):
        assert sum(piece.holds((x, 0.0)) for piece in card.pieces) == 1
    for place in card.contacts:
        assert height_over(GROUND.equation, (*place, 1.0)) == pytest.approx(0.0, abs=1e-6)
        assert any(abs(height_over(piece.plane, (*place, 1.0))) < 1e-6 for piece in card.pieces)
    limit = 3.7320508075688776 + 1e-9
    assert MAX_SLOPE_DEG == 75.0
    assert all(abs(slope_of(piece)) <= limit for piece in card.pieces)


def test_a_piece_cuts_its_part_out_of_a_box() -> None:
    piece = vertical_piece((0.0, 0.0), 0.0, 20.0, 50.5)
    part = piece.part_of(Box(0, 10, 40, 30))
    assert sorted(map(tuple, part.tolist())) == [(20.0, 10.0), (20.0, 30.0), (40.0, 10.0), (40.0, 30.0)]
    assert len(piece.part_of(Box(60, 0, 70, 10))) == 0


@given(
    st.tuples(st.floats(-3.7, 3.7), st.floats(-2.0, 2.0)),
    st.tuples(st.floats(-500, 1500), st.floats(-500, 1500), st.floats(-400, 400)),
    st.sampled_from([0.0, 30.0, 110.0]),
)
def test_a_piece_receives_on_the_side_that_is_seen(
    slopes: tuple[float, float], place: tuple[float, float, float], fov: float
) -> None:
    camera, piece = Camera(1000, 1000, fov), CardPiece(place, (-slopes[0], -slopes[1], 1.0))
    plane = receiver_of(camera, piece)
    assert coinciding(plane.equation, [piece.plane]).all()
    assert height_over(plane.equation, camera.eye) >= 0
    assert abs(height_over(piece.plane, (*plane.point(120.0, -70.0), 1.0))) < 1e-6
    for axis in (plane.u, plane.v, plane.normal):
        assert dot(axis, axis) == pytest.approx(1.0)
    for one, other in ((plane.u, plane.normal), (plane.v, plane.normal), (plane.u, plane.v)):
        assert dot(one, other) == pytest.approx(0.0, abs=1e-12)
    assert abs(np.linalg.det([plane.u, plane.v, plane.normal])) == pytest.approx(1.0)


def test_a_piece_seen_from_behind_is_lit_from_behind() -> None:
    """Steep enough, a card at the left turns its back on an eye close by."""
    camera = Camera(1000, 1000, 110.0)
    assert receiver_of(camera, vertical_piece((0.0, 0.0), 3.5)).normal[2] < 0
    assert receiver_of(camera, vertical_piece((0.0, 0.0), 0.0)).normal[2] > 0


def test_planes_coincide_whichever_way_they_face() -> None:
    plane = (0.6, 0.0, 0.8, -120.0)
    others = [(-1.2, 0.0, -1.6, 240.0), (0.6, 0.0, 0.8, -120.001), (0.6, 0.0, -0.8, -120.0)]
    assert coinciding(plane, others).tolist() == [True, False, False]


def test_a_tilt_is_measured_by_points_and_turns_about_the_one_there_is() -> None:
    camera, ground = Camera(1000, 1000), ground_plane((500.0, 900.0), 0.0, 60.0)
    none, one, two, near = (
        card_for(camera, ground, points, 20.0, 700.0)
        for points in ((), ((450.0, 880.0),), ((450.0, 900.0), (550.0, 880.0)), ((450.0, 900.0), (451.0, 900.0)))
    )
    assert [card.is_tilt_measured for card in (none, one, two, near)] == [False, False, True, True]
    assert [card.axis is None for card in (none, one, two, near)] == [True, False, True, False]
    assert one.axis == one.contacts[0]
    feet = (Foothold((420.0, 900.0), 900.0, is_planted=True), Foothold((560.0, 860.0), 860.0, is_planted=True))
    on_feet = relief_card(camera, ground, feet, 700.0, 20.0)
    assert not on_feet.is_tilt_measured
    assert on_feet.axis == pytest.approx(np.mean(on_feet.contacts, axis=0))


def test_the_piece_at_a_point_is_the_one_that_holds_it() -> None:
    camera, ground = Camera(1000, 1000), ground_plane((500.0, 900.0), 0.0, 60.0)
    card = card_for(camera, ground, ((400.0, 900.0), (500.0, 880.0), (600.0, 890.0)), 0.0, 700.0)
    for x in (-1e6, 400.0, 499.0, 500.0, 501.0, 1e6):
        assert card.piece_at((x, 300.0)).holds((x, 300.0))
