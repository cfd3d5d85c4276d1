"""The relief card: its surface by the formula, feet that stay on their shadows, and walks in which nothing jumps."""

from collections.abc import Sequence
from itertools import pairwise
from math import isfinite

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera, project
from kagezou.geometry.card import Card, CardPiece, card_for
from kagezou.geometry.contact import contact_plane
from kagezou.geometry.ground import Plane, ground_plane, place_on
from kagezou.geometry.light import lamp, sun
from kagezou.geometry.relief import FOOT, HIP, Foothold, relief_card
from kagezou.geometry.shadow import cast_on
from kagezou.geometry.vectors import Point2, Vector4, dot, height_over

HEIGHT = 500.0
FLAT = Camera(1000, 1000)
GROUND = ground_plane((500.0, 850.0), 0.0, 60.0)
TAN60 = 3**0.5
CANVAS = Box(0, 0, 1000, 1000)


def standing(x: float, y: float) -> Foothold:
    return Foothold((x, y), y, is_planted=True)


def lifted(x: float, y: float, ground_row: float) -> Foothold:
    return Foothold((x, y), ground_row, is_planted=False)


PAIR = (standing(420.0, 860.0), standing(570.0, 830.0))
TRIO = (standing(380.0, 852.0), lifted(480.0, 815.0, 840.0), standing(600.0, 858.0))


def seen_on(camera: Camera, piece: CardPiece, point: Point2) -> np.ndarray:
    """Return the world place of a piece's plane that is seen at a canvas point, by following the view ray."""
    start = np.array([*point, 0.0])
    ex, ey, ez, ew = camera.eye
    ahead = np.array([0.0, 0.0, -1.0]) if ew == 0 else start - (ex, ey, ez)
    normal = np.array(piece.normal)
    return np.asarray(start + ahead * (normal @ (np.array(piece.place) - start)) / (normal @ ahead))


def depth_at(camera: Camera, card: Card, point: Point2) -> float:
    return float(seen_on(camera, next(piece for piece in card.pieces if piece.holds(point)), point)[2])


def depths_at(camera: Camera, card: Card, points: np.ndarray) -> np.ndarray:
    """Return the same for many canvas points (N, 2) at once."""
    start = np.column_stack([points, np.zeros(len(points))])
    ex, ey, ez, ew = camera.eye
    ahead = np.array([[0.0, 0.0, -1.0]]) if ew == 0 else start - (ex, ey, ez)
    depths = np.full(len(points), np.nan)
    for piece in card.pieces:
        # Of pieces that meet at a point the first one counts.
        held = np.isnan(depths)
        for a, b, c in piece.limits:
            held &= a * points[:, 0] + b * points[:, 1] + c >= 0
        normal = np.array(piece.normal)
        seen = start + ahead * (((np.array(piece.place) - start) @ normal) / (ahead @ normal))[:, np.newaxis]
        depths[held] = seen[held, 2]
    assert not np.isnan(depths).any(), "the pieces leave nothing out"
    return depths


def depth_by_formula(feet: Sequence[tuple[float, float, float]], x: float, y: float) -> float:
    """Return z(x, y) of an orthographic card by its definition; between two feet a triangle goes from row to row."""
    middle = sum(z for *_, z in feet) / len(feet)
    xs, ys, zs = zip(*feet, strict=True)
    h = (float(np.interp(x, xs, ys)) - y) / HEIGHT
    if h <= FOOT:
        return float(np.interp(x, xs, zs))
    if h >= HIP:
        return middle
    part = (h - FOOT) / (HIP - FOOT)
    if not xs[0] < x < xs[-1]:
        return middle + (1 - part) * (float(np.interp(x, xs, zs)) - middle)
    (ax, _, az), (bx, _, bz) = next((a, b) for a, b in pairwise(feet) if a[0] <= x <= b[0])
    across = (x - ax) / (bx - ax)
    if part <= 1 - across:  # the triangle of both feet and the left hip
        return az * (1 - across - part) + bz * across + middle * part
    return middle * across + middle * (part - across) + (bz - middle) * (1 - part) + middle * (1 - part)


@given(st.floats(-200, 1200), st.floats(-200, 1200), st.sampled_from([PAIR, TRIO]))
def test_the_surface_is_what_its_definition_says(x: float, y: float, feet: tuple[Foothold, ...]) -> None:
    card = relief_card(FLAT, GROUND, feet, HEIGHT)
    # On this ground a row further up the screen lies tan 60° deeper.
    places = [(hold.place[0], hold.place[1], (hold.ground_row - 850.0) * TAN60) for hold in feet]
    assert depth_at(FLAT, card, (x, y)) == pytest.approx(depth_by_formula(places, x, y), abs=1e-6)


@st.composite
def figures(draw: st.DrawFn) -> tuple[Foothold, ...]:
    """Two or three feet apart from each other, some lifted."""
    count = draw(st.integers(2, 3))
    xs = draw(st.lists(st.floats(300, 700), min_size=count, max_size=count, unique_by=lambda x: round(x / 60)))
    assume(min(abs(a - b) for a, b in pairwise(sorted(xs))) > 55)
    rows = [draw(st.floats(780, 900)) for _ in xs]
    lifts = [draw(st.sampled_from([0.0, 0.0, 10.0, 40.0])) for _ in xs]
    return tuple(Foothold((x, y - up), y, is_planted=up == 0) for x, y, up in zip(xs, rows, lifts, strict=True))


@st.composite
def views(draw: st.DrawFn) -> tuple[Camera, Plane, float, float]:
    """A camera, a ground, a tilt and how upright the card is."""
    camera = Camera(1000, 1000, draw(st.sampled_from([0.0, 0.0, 20.0, 50.0])))
    ground = ground_plane((500.0, 850.0), draw(st.floats(-12, 12)), draw(st.floats(35, 78)))
    return camera, ground, draw(st.sampled_from([0.0, 15.0, -25.0])), draw(st.sampled_from([0.0, 0.5, 1.0]))


def card_of(view: tuple[Camera, Plane, float, float], feet: Sequence[Foothold]) -> Card:
    camera, ground, tilt, upright = view
    return relief_card(camera, ground, feet, HEIGHT, tilt, upright)


@given(views(), figures(), st.lists(st.tuples(st.floats(0, 1000), st.floats(0, 1000)), min_size=20, max_size=20))
def test_every_canvas_point_lies_on_one_piece(
    view: tuple[Camera, Plane, float, float], feet: tuple[Foothold, ...], points: list[Point2]
) -> None:
    pieces = card_of(view, feet).pieces
    for x, y in points:
        distances = [[a * x + b * y + c for a, b, c in piece.limits] for piece in pieces]
        if not any(abs(each) < 1e-6 for row in distances for each in row):
            assert sum(all(each > 0 for each in row) for row in distances) == 1
    areas = [_area(piece.part_of(CANVAS)) for piece in pieces]
    assert sum(areas) == pytest.approx(1e6, rel=1e-9)


def _area(corners: np.ndarray) -> float:
    x, y = corners.T if len(corners) else np.zeros((2, 1))
    return float(abs(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2)


@given(views(), figures())
def test_neighbours_meet_along_their_edges_without_a_gap(
    view: tuple[Camera, Plane, float, float], feet: tuple[Foothold, ...]
) -> None:
    camera, card = view[0], card_of(view, feet)
    for piece in card.pieces:
        corners = piece.part_of(CANVAS)
        for x, y in [*corners, *((corners + np.roll(corners, 1, axis=0)) / 2)]:
            others = [each for each in card.pieces if all(a * x + b * y + c > -1e-7 for a, b, c in each.limits)]
            for other in others:
                assert seen_on(camera, other, (x, y)) == pytest.approx(seen_on(camera, piece, (x, y)), abs=1e-3)


@st.composite
def lights(draw: st.DrawFn, ground: Plane) -> Vector4:
    if draw(st.booleans()):
        return sun(ground, draw(st.floats(-170, 170)), draw(st.floats(15, 80)))
    return lamp((draw(st.floats(-500, 1500)), draw(st.floats(-1500, -100)), draw(st.floats(-900, 1500))))


@given(st.data(), views(), figures())
def test_a_planted_foot_is_its_own_shadow(
    data: st.DataObject, view: tuple[Camera, Plane, float, float], feet: tuple[Foothold, ...]
) -> None:
    camera, ground = view[:2]
    light = data.draw(lights(ground))
    card = card_of(view, feet)
    for hold in feet:
        if not hold.is_planted:
            continue
        place = place_on(camera, ground, hold.place)
        assert place is not None
        assert any(np.allclose(place, contact, atol=1e-9) for contact in card.contacts)
        for piece in card.pieces:
            if not all(a * hold.place[0] + b * hold.place[1] + c > -1e-6 for a, b, c in piece.limits):
                continue
            assert seen_on(camera, piece, hold.place) == pytest.approx(place, abs=1e-3)
            plane = np.array(piece.plane)
            toward = np.array(light[:3]) - light[3] * np.array(place)
            if abs(plane[:3] @ toward) < 0.02 * np.linalg.norm(toward):
                continue  # a light within the piece's own plane draws a line
            cast = cast_on(camera, ground, piece, light)
            if cast is not None:
                shadow = project(np.asarray(np.linalg.inv(cast.art_from_canvas), np.float64), hold.place)
                assert shadow == pytest.approx(hold.place, abs=0.01)


@given(figures(), st.lists(st.tuples(st.floats(0, 1000), st.floats(0, 1000)), min_size=30, max_size=30))
def test_depths_stay_between_those_of_the_feet(feet: tuple[Foothold, ...], points: list[Point2]) -> None:
    for camera in (FLAT, Camera(1000, 1000, 45.0)):
        places = [place_on(camera, GROUND, (hold.place[0], hold.ground_row)) for hold in feet]
        depths = [place[2] for place in places if place is not None]
        card = relief_card(camera, GROUND, feet, HEIGHT)
        for point in points:
            assert min(depths) - 1e-6 <= depth_at(camera, card, point) <= max(depths) + 1e-6


def passing(part: float) -> tuple[Foothold, ...]:
    """Two feet of which the one behind swings past the one that stands, and at last stands, too."""
    up = 60.0 * 4 * part * (1 - part)
    row = 838.0 + 14.0 * part
    swinging = Foothold((400.0 + 200.0 * part, row - up), row, is_planted=part in (0.0, 1.0))
    return (standing(505.0, 860.0), swinging)


@pytest.mark.parametrize("upright", [0.0, 1.0])
@pytest.mark.parametrize("with_third", [False, True])
@pytest.mark.parametrize("camera", [FLAT, Camera(1000, 1000, 40.0)], ids=["orthographic", "perspective"])
def test_nothing_jumps_while_feet_pass_each_other(camera: Camera, upright: float, *, with_third: bool) -> None:
    points = np.array([(float(x), float(y)) for x in range(350, 700, 23) for y in range(380, 900, 31)])
    third = (standing(640.0, 845.0),) if with_third else ()
    steps = 400

    def depths(part: float) -> np.ndarray:
        card = relief_card(camera, GROUND, (*passing(part), *third), HEIGHT, 0.0, upright)
        return depths_at(camera, card, points)

    walk = [depths(number / steps) for number in range(steps + 1)]
    halfway = relief_card(camera, GROUND, (*passing(0.5), *third), HEIGHT, 0.0, upright)
    assert walk[steps // 2] == pytest.approx([depth_at(camera, halfway, (x, y)) for x, y in points.tolist()], abs=1e-9)
    changes = np.array([np.abs(b - a).max() for a, b in pairwise(walk)])
    assert np.ptp(walk, axis=0).max() > 5.0
    # Half a px of the swinging foot moves no place of the card by more than a px or two, wherever the feet are.
    assert changes.max() < 2.0


def test_planted_feet_that_come_close_meet_in_their_middle_without_a_jump() -> None:
    def depths(apart: float) -> np.ndarray:
        card = relief_card(FLAT, GROUND, (standing(500.0, 860.0), standing(500.0 + apart, 840.0)), HEIGHT)
        assert card.merged == (apart < 0.02 * HEIGHT)
        assert len(card.contacts) == 2
        return np.array([depth_at(FLAT, card, (x, y)) for x in (450.0, 560.0) for y in (500.0, 700.0, 855.0)])

    steps = [depths(apart) for apart in np.arange(14.0, -0.01, -0.05)]
    assert max(np.abs(b - a).max() for a, b in pairwise(steps)) < 0.6
    assert np.ptp(steps[-1]) == pytest.approx(0.0, abs=1e-6)
    assert steps[-1][0] == pytest.approx(0.0, abs=1e-6)
    assert np.ptp(steps[0]) > 20.0


def test_lifted_feet_that_pass_each_other_in_a_jump_meet_halfway() -> None:
    near, far = lifted(500.0, 700.0, 860.0), lifted(500.0, 690.0, 840.0)
    for first, second in ((near, far), (far, near)):
        moved = Foothold((second.place[0] + 1e-2, second.place[1]), second.ground_row, is_planted=False)
        card = relief_card(FLAT, GROUND, (first, moved), HEIGHT)
        assert [depth_at(FLAT, card, (x, 690.0)) for x in (400.0, 600.0)] == pytest.approx([0.0, 0.0], abs=1e-3)
        assert len(card.contacts) == 2


@pytest.mark.parametrize("upright", [0.0, 0.7])
def test_one_foot_gives_the_flat_card_through_its_place(upright: float) -> None:
    for hold in (standing(430.0, 880.0), lifted(430.0, 700.0, 880.0)):
        own = relief_card(FLAT, GROUND, (hold,), HEIGHT, 20.0, upright)
        assert own == card_for(FLAT, GROUND, [(430.0, 880.0)], 20.0, HEIGHT, upright)
    assert relief_card(FLAT, GROUND, (), HEIGHT, 20.0, upright) == card_for(FLAT, GROUND, [], 20.0, HEIGHT, upright)


def test_a_foot_over_the_sky_is_left_out() -> None:
    camera, ground = Camera(1000, 1000, 60.0), ground_plane((500.0, 800.0), 0.0, 80.0)
    feet = (standing(430.0, 880.0), standing(600.0, -900.0))
    assert relief_card(camera, ground, feet, HEIGHT) == card_for(camera, ground, [(430.0, 880.0)], 0.0, HEIGHT)


def test_feet_side_by_side_have_one_flat_piece_that_only_a_tilt_turns_away_from_them() -> None:
    feet = (standing(430.0, 880.0), standing(560.0, 880.0))
    card = relief_card(FLAT, GROUND, feet, HEIGHT)
    (piece,) = card.pieces
    assert piece.limits == ()
    assert seen_on(FLAT, piece, (700.0, 100.0))[2] == pytest.approx(30.0 * TAN60)
    turned = relief_card(FLAT, GROUND, feet, HEIGHT, 45.0)
    assert turned.tilt_deg == 45.0
    for x, over_hip, at_foot in ((430.0, -65.0, 0.0), (495.0, 0.0, 0.0), (560.0, 65.0, 0.0)):
        assert depth_at(FLAT, turned, (x, 300.0)) == pytest.approx(30.0 * TAN60 + over_hip)
        assert depth_at(FLAT, turned, (x, 880.0)) == pytest.approx(30.0 * TAN60 + at_foot)


def test_in_a_jump_the_card_stands_where_the_ground_is_below_the_feet() -> None:
    feet = (lifted(420.0, 600.0, 860.0), lifted(570.0, 640.0, 830.0))
    card = relief_card(FLAT, GROUND, feet, HEIGHT)
    assert [place[1] for place in card.contacts] == pytest.approx([860.0, 830.0])
    assert depth_at(FLAT, card, (420.0, 600.0)) == pytest.approx(10.0 * TAN60)
    assert depth_at(FLAT, card, (570.0, 640.0)) == pytest.approx(-20.0 * TAN60)


@given(figures(), st.floats(-12, 12), st.floats(35, 78), st.sampled_from([0.0, 30.0]))
def test_upright_the_body_stands_along_the_normal(
    feet: tuple[Foothold, ...], roll: float, declination: float, fov: float
) -> None:
    camera, ground = Camera(1000, 1000, fov), ground_plane((500.0, 850.0), roll, declination)
    card = relief_card(camera, ground, feet, HEIGHT, 0.0, 1.0)
    assume(card.upright == 1.0)
    body = next(piece for piece in card.pieces if piece.holds((500.0, 0.0)))
    for way in (ground.normal, ground.u):
        assert dot(body.normal, way) == pytest.approx(0.0, abs=1e-9)


def test_the_contact_line_runs_through_feet_side_by_side_and_never_jumps() -> None:
    card = relief_card(FLAT, GROUND, PAIR, HEIGHT)
    apart = relief_card(FLAT, GROUND, (standing(350.0, 860.0), standing(650.0, 850.0)), HEIGHT)
    for place in apart.contacts:
        away = np.array(place) - contact_plane(apart, GROUND).origin
        assert away @ np.array(contact_plane(apart, GROUND).v) == pytest.approx(0.0, abs=1e-6)
    # One behind the other it keeps the ground's own direction.
    steep = relief_card(FLAT, GROUND, (standing(450.0, 900.0), standing(550.0, 800.0)), HEIGHT)
    assert contact_plane(steep, GROUND).u == pytest.approx(GROUND.u)
    assert card.contact_line is not None
    planes = [contact_plane(relief_card(FLAT, GROUND, passing(n / 400), HEIGHT), GROUND) for n in range(401)]
    for a, b in pairwise(planes):
        assert np.linalg.norm(np.subtract(a.u, b.u)) < 0.02
        assert np.linalg.norm(np.subtract(a.origin, b.origin)) < 1.0
    turned = relief_card(FLAT, GROUND, (standing(480.0, 860.0), standing(500.0, 850.0)), HEIGHT, 20.0)
    body = next(piece for piece in turned.pieces if piece.holds((490.0, 0.0)))
    assert abs(dot(body.normal, contact_plane(turned, GROUND).u)) < 1e-9


@given(st.lists(st.tuples(st.floats(300, 700), st.floats(780, 900)), min_size=1, max_size=3), views())
def test_a_folded_card_that_is_stood_up_keeps_its_contacts(
    points: list[Point2], view: tuple[Camera, Plane, float, float]
) -> None:
    camera, ground, tilt, upright = view
    assume(upright > 0)
    card, plain = (
        card_for(camera, ground, points, tilt, HEIGHT, upright),
        card_for(camera, ground, points, tilt, HEIGHT),
    )
    assert card.contacts == plain.contacts
    assert (card.tilt_deg, len(card.pieces)) == (plain.tilt_deg, len(plain.pieces))
    for place in card.contacts:
        point = project(camera.canvas_from_world(), (*place, 1.0))
        near = [each for each in card.pieces if all(a * point[0] + b * point[1] + c > -1e-6 for a, b, c in each.limits)]
        assert near
        for piece in near:
            assert abs(height_over(piece.plane, (*place, 1.0))) < 1e-6 * np.linalg.norm(piece.normal) + 1e-6
    assert all(isfinite(each) for piece in card.pieces for each in piece.plane)
    areas = [_area(piece.part_of(CANVAS)) for piece in card.pieces]
    assert sum(areas) == pytest.approx(1e6, rel=1e-9)


def test_without_points_an_upright_card_stands_on_the_ground_line() -> None:
    ground = ground_plane((500.0, 850.0), 9.0, 60.0)
    (piece,) = card_for(FLAT, ground, [], 0.0, HEIGHT, 1.0).pieces
    for way in (ground.normal, ground.u):
        assert dot(piece.normal, way) == pytest.approx(0.0, abs=1e-12)
    assert piece.place == ground.origin


def test_a_card_is_not_stood_up_until_it_is_edge_on() -> None:
    low = ground_plane((500.0, 850.0), 0.0, 4.0)
    card = card_for(FLAT, low, [(500.0, 850.0)], 0.0, HEIGHT, 1.0)
    assert 0.2 < card.upright < 0.3
    assert card.pieces[0].normal[1] == pytest.approx(3.73)
    wide, steep = Camera(1000, 1000, 110.0), ground_plane((500.0, 850.0), 0.0, 25.0)
    near = relief_card(wide, steep, PAIR, HEIGHT, 0.0, 1.0)
    assert 0.0 < near.upright < 1.0
    assert card_for(FLAT, ground_plane((500.0, 850.0), 0.0, 0.0), [], 0.0, HEIGHT, 1.0).upright == 0.0


def test_a_card_is_made_once_while_nothing_that_it_is_made_of_changes() -> None:
    camera, ground = Camera(1000, 1000, 40.0), ground_plane((500.0, 800.0), 0.0, 60.0)
    feet = [standing(450.0, 820.0), standing(550.0, 790.0)]
    card = relief_card(camera, ground, feet, 500.0)
    assert relief_card(camera, ground, tuple(feet), 500.0) is card
    assert relief_card(camera, ground, feet, 500.0, 10.0) != card
    assert relief_card(camera, ground, [feet[0], lifted(550.0, 780.0, 790.0)], 500.0) != card
