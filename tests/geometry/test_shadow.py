"""The closed form of the cast: golden values, the feet, and a walk along single rays."""

from math import atan, cos, degrees, inf, isfinite, radians, sin

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera, project
from kagezou.geometry.card import Card, CardPiece, card_for, receiver_of, vertical_piece
from kagezou.geometry.ground import Plane, ground_plane, place_on
from kagezou.geometry.light import is_over, lamp, sun
from kagezou.geometry.polygon import bounding_box
from kagezou.geometry.relief import Foothold, relief_card
from kagezou.geometry.shadow import Cast, cast_card, cast_in_space, cast_on
from kagezou.geometry.vectors import Matrix, Point2, Vector4, height_over
from tests.geometry.single_rays import Wall, World, shading_points, walls_through

FIGURE_HEIGHT = 300.0


def shadow_of(cast: Cast, point: Point2) -> Point2:
    """Where the shadow of a point of the drawing is seen."""
    return project(np.asarray(np.linalg.inv(cast.art_from_canvas), dtype=np.float64), point)


def inside(cast: Cast, point: Point2) -> float:
    """The least distance of a canvas point to the ends of the region that can hold shadow; positive within."""
    ends = (cast.side, cast.horizon, *cast.limits)
    return min(float(end @ np.array([*point, 1.0])) for end in ends)


def depth(cast: Cast, point: Point2) -> float:
    """How far before the eye the shading place of the card lies; not positive where no drawing can be seen."""
    return float(cast.art_from_canvas[2] @ np.array([*point, 1.0]))


# ---- golden values, published for y up and the angle from the other side: y = HEIGHT − y_up, θ = 180° − θ_spec.

HEIGHT = 600
GOLDEN_GROUND = ground_plane((0.0, HEIGHT - 100.0), 0.0, 60.0)
GOLDEN_POINTS = ((200.0, 100.0), (200.0, 350.0), (260.0, 220.0))
GOLDEN_LAMP = lamp((300.0, HEIGHT - 900.0, -300.0))
FROM_BEHIND = (0.3, -0.6, -0.5, 0.0)
FROM_FRONT = (0.3, -0.8, 0.5, 0.0)
FLAT = Camera(500, HEIGHT)
PINHOLE = Camera(500, HEIGHT, 2 * degrees(atan(300 / 900)))


@pytest.mark.parametrize(
    ("camera", "light", "shadows"),
    [
        (FLAT, GOLDEN_LAMP, ((200.0, 100.0), (133.6509, -14.92), (250.5287, 58.9881))),
        (FLAT, FROM_BEHIND, ((200.0, 100.0), (-40.9059, -131.8118), (144.3652, -11.2697))),
        (FLAT, FROM_FRONT, ((200.0, 100.0), (131.1089, 166.2905), (226.9323, 131.8194))),
        (PINHOLE, GOLDEN_LAMP, ((200.0, 100.0), (100.6116, -104.3468), (250.574, 38.3356))),
    ],
    ids=["lamp", "light from behind", "light from the front", "lamp in perspective"],
)
def test_golden_values(camera: Camera, light: Vector4, shadows: tuple[Point2, ...]) -> None:
    (piece,) = card_for(camera, GOLDEN_GROUND, [], 0.0, FIGURE_HEIGHT).pieces
    cast = cast_on(camera, GOLDEN_GROUND, piece, light)
    assert cast is not None
    for (x, y), (sx, sy) in zip(GOLDEN_POINTS, shadows, strict=True):
        assert shadow_of(cast, (x, HEIGHT - y)) == pytest.approx((sx, HEIGHT - sy), abs=1e-3)


def test_golden_tilt() -> None:
    feet = ((180.0, HEIGHT - 100.0), (240.0, HEIGHT - 112.0))
    card = card_for(FLAT, GOLDEN_GROUND, feet, 0.0, FIGURE_HEIGHT)
    assert card.tilt_deg == pytest.approx(-19.106605350869103, abs=1e-9)
    (cast,) = cast_card(FLAT, GOLDEN_GROUND, card, GOLDEN_LAMP)
    for foot in feet:
        assert shadow_of(cast, foot) == pytest.approx(foot, abs=1e-9)
    assert shadow_of(cast, (200.0, HEIGHT - 350.0)) == pytest.approx((135.3983, HEIGHT + 5.3094), abs=1e-3)


def test_golden_height_of_the_lamp() -> None:
    assert height_over(GOLDEN_GROUND.equation, GOLDEN_LAMP) == pytest.approx(542.8203230275509, abs=1e-9)


def test_light_from_the_front_throws_the_shadow_behind() -> None:
    (piece,) = card_for(FLAT, GOLDEN_GROUND, [], 0.0, FIGURE_HEIGHT).pieces
    for light, is_behind in ((FROM_FRONT, True), (FROM_BEHIND, False)):
        cast = cast_on(FLAT, GOLDEN_GROUND, piece, light)
        assert cast is not None
        assert (shadow_of(cast, (200.0, 250.0))[1] < 500.0) is is_behind


# ---- random scenes

declinations = st.floats(12, 85)
rolls = st.floats(-40, 40)
fovs = st.one_of(st.just(0.0), st.floats(5, 70))
heads = st.floats(0, 1)


@st.composite
def scenes(draw: st.DrawFn) -> tuple[Camera, Plane]:
    """Return a camera and a ground around the middle of a 1000 × 1000 canvas."""
    camera = Camera(1000, 1000, draw(fovs))
    ground = ground_plane((draw(st.floats(300, 700)), draw(st.floats(500, 950))), draw(rolls), draw(declinations))
    return camera, ground


@st.composite
def lights(draw: st.DrawFn, ground: Plane) -> Vector4:
    """Return a lamp or sun well over the ground, on any side."""
    azimuth = draw(st.floats(-180, 180))
    if draw(st.booleans()):
        return sun(ground, azimuth, draw(st.floats(8, 80)))
    away, high = draw(st.floats(50, 2000)), draw(st.floats(150, 3000))
    u, v = away * sin(radians(azimuth)), away * cos(radians(azimuth))
    foot = ground.point(u, v)
    x, y, z = (f + high * n for f, n in zip(foot, ground.normal, strict=True))
    return lamp((x, y, z))


@given(st.data(), scenes(), st.integers(1, 3))
def test_the_shadow_of_a_grounding_point_is_the_point(
    data: st.DataObject, scene: tuple[Camera, Plane], count: int
) -> None:
    camera, ground = scene
    light = data.draw(lights(ground))
    xs = data.draw(st.lists(st.floats(200, 800), min_size=count, max_size=count, unique_by=lambda x: round(x / 40)))
    feet = [(x, data.draw(st.floats(520, 900))) for x in xs]
    card = card_for(camera, ground, feet, data.draw(st.floats(-70, 70)) if count == 1 else 0.0, FIGURE_HEIGHT)
    assume(len(card.contacts) == count)
    for foot in feet:
        own = [piece for piece in card.pieces if piece.holds(foot)]
        assert own
        for piece in own:
            assume(not _is_edge_on(camera, piece, light, foot))
            cast = cast_on(camera, ground, piece, light)
            assert cast is not None
            assert shadow_of(cast, foot) == pytest.approx(foot, abs=1e-6)
            assert project(cast.art_from_canvas, foot) == pytest.approx(foot, abs=1e-6)
            assert inside(cast, foot) >= -1e-6


def _is_edge_on(camera: Camera, piece: CardPiece, light: Vector4, foot: Point2) -> bool:
    """Whether light or eye nearly lies in the piece's plane, where float64 itself gives way."""
    plane = np.asarray(piece.plane) / np.linalg.norm(piece.plane[:3])
    place = np.array([foot[0], foot[1], 0.0])
    to_light = np.asarray(light[:3]) - light[3] * place
    to_eye = np.asarray(camera.eye[:3]) - camera.eye[3] * place
    return any(abs(plane[:3] @ way) < 0.02 * np.linalg.norm(way) for way in (to_light, to_eye)) or (
        abs(float(plane @ np.asarray(light))) < (5.0 if light[3] else 0.02)
    )


@given(st.data(), scenes(), st.integers(0, 3))
def test_the_closed_form_is_what_single_rays_find(data: st.DataObject, scene: tuple[Camera, Plane], count: int) -> None:
    camera, ground = scene
    light = data.draw(lights(ground))
    xs = data.draw(st.lists(st.floats(200, 800), min_size=count, max_size=count, unique_by=lambda x: round(x / 40)))
    feet = sorted((x, data.draw(st.floats(560, 700))) for x in xs)
    tilt = data.draw(st.floats(-60, 60))
    card = card_for(camera, ground, feet, tilt, FIGURE_HEIGHT)
    assume(len(card.contacts) == count)
    world, walls = _walked(camera, ground, card, feet, tilt)
    casts = cast_card(camera, ground, card, light)
    for _ in range(5):
        at = (data.draw(st.floats(0, 1000)), data.draw(st.floats(0, 1000)))
        nearness = [inside(cast, at) for cast in casts]
        if any(abs(near) < 0.01 for near in nearness):
            continue  # on the very end of a region either answer is right
        hit = [cast for cast, near in zip(casts, nearness, strict=True) if near > 0 and depth(cast, at) > 0]
        found = [project(cast.art_from_canvas, at) for cast in hit]
        found = [point for point in found if _is_plain(point)]
        expected = [point for point in shading_points(world, walls, light, at) if _is_plain(point)]
        assert len(found) == len(expected)
        for one, other in zip(sorted(found), sorted(expected), strict=True):
            assert one == pytest.approx(other, rel=1e-6, abs=1e-5)


def _is_plain(point: Point2) -> bool:
    """Whether a point of the drawing is near enough to be compared without the noise of a vanishing line."""
    return all(isfinite(part) and abs(part) < 1e5 for part in point)


def _walked(camera: Camera, ground: Plane, card: Card, feet: list[Point2], tilt: float) -> tuple[World, list[Wall]]:
    """Return the world and card by the definitions, from roll and declination read off the plane."""
    roll = degrees(atan(ground.u[1] / ground.u[0]))
    declination = degrees(atan(ground.v[2] * ground.u[0] / ground.v[1]))
    world = World(camera.width_px, camera.height_px, camera.fov_deg, ground.origin[:2], roll, declination)
    assume(not card.merged)
    if len(feet) < 2:
        place = world.on_ground(feet[0]) if feet else ground.origin
        assert place is not None
        return world, [Wall(place[0], place[2], sin(radians(tilt)) / cos(radians(tilt)))]
    places = [world.on_ground(foot) for foot in feet]
    return world, walls_through([place for place in places if place is not None])


@given(st.data(), scenes())
def test_the_region_holds_every_shadow_on_the_canvas(data: st.DataObject, scene: tuple[Camera, Plane]) -> None:
    camera, ground = scene
    light = data.draw(lights(ground))
    feet = [(300.0, 700.0), (500.0, 720.0), (700.0, 690.0)][: data.draw(st.integers(0, 3))]
    card = card_for(camera, ground, feet, 0.0, FIGURE_HEIGHT)
    art, canvas = Box(350, 300, 650, 700), Box(0, 0, 1000, 1000)
    casts = cast_card(camera, ground, card, light)
    points = data.draw(st.lists(st.tuples(st.floats(0, 1000), st.floats(0, 1000)), min_size=20, max_size=20))
    for cast in casts:
        region = cast.region(canvas, art)
        for at in points:
            x, y = project(cast.art_from_canvas, at) if depth(cast, at) > 1e-12 else (inf, inf)
            if inside(cast, at) > 0.02 and art.left <= x < art.right and art.top <= y < art.bottom:
                assert _contains(region, at)


def _contains(polygon: Matrix, point: Point2) -> bool:
    if len(polygon) == 0:
        return False
    edges = np.roll(polygon, -1, axis=0) - polygon
    toward = np.asarray(point) - polygon
    turns = edges[:, 0] * toward[:, 1] - edges[:, 1] * toward[:, 0]
    return bool((turns >= -1e-6).all() or (turns <= 1e-6).all())


# ---- where nothing is cast


def piece_at(ground: Plane) -> CardPiece:
    return vertical_piece((ground.origin[0], ground.origin[2]), 0.0)


def test_nothing_is_cast_from_below_the_ground() -> None:
    below = lamp((500.0, 1200.0, -400.0))
    ground = ground_plane((500.0, 800.0), 0.0, 60.0)
    assert not is_over(ground, below)
    assert cast_on(FLAT, ground, piece_at(ground), below) is None
    assert cast_card(FLAT, ground, Card((piece_at(ground),)), below) == ()


def test_nothing_is_cast_by_light_within_the_card() -> None:
    ground = ground_plane((500.0, 800.0), 0.0, 60.0)
    assert cast_on(FLAT, ground, piece_at(ground), lamp((500.0, 100.0, 0.0))) is None
    assert cast_on(FLAT, ground, piece_at(ground), (0.6, -0.8, 0.0, 0.0)) is None


def test_nothing_is_seen_of_a_ground_edge_on() -> None:
    ground = ground_plane((500.0, 800.0), 0.0, 90.0)
    assert cast_on(FLAT, ground, piece_at(ground), lamp((500.0, 100.0, 500.0))) is None


def test_the_ground_behind_the_eye_holds_no_shadow() -> None:
    camera = Camera(1000, 1000, 60.0)
    ground = ground_plane((500.0, 800.0), 0.0, 80.0)
    cast = cast_on(camera, ground, piece_at(ground), lamp((500.0, -500.0, 600.0)))
    assert cast is not None
    region = cast.region(Box(0, 0, 1000, 1000), Box(0, -100000, 1000, 800))
    box = bounding_box(region)
    assert box is not None
    assert place_on(camera, ground, (500.0, box.top + 1.0)) is not None
    assert place_on(camera, ground, (500.0, box.top - 50.0)) is None


def test_a_point_below_the_ground_casts_nothing() -> None:
    ground = ground_plane((500.0, 800.0), 0.0, 60.0)
    cast = cast_on(FLAT, ground, piece_at(ground), lamp((300.0, 100.0, 500.0)))
    assert cast is not None
    assert inside(cast, shadow_of(cast, (500.0, 700.0))) > 0
    assert inside(cast, shadow_of(cast, (500.0, 900.0))) < 0


def test_ground_coordinates_of_a_canvas_point() -> None:
    camera, ground = Camera(1000, 1000, 30.0), ground_plane((500.0, 800.0), 10.0, 60.0)
    cast = cast_on(camera, ground, piece_at(ground), lamp((300.0, 100.0, 500.0)))
    assert cast is not None
    seen = project(camera.canvas_from_world(), (*ground.point(120.0, -80.0), 1.0))
    assert project(cast.receiver_from_canvas, seen) == pytest.approx((120.0, -80.0), abs=1e-8)


def test_neighbouring_pieces_join_where_their_shadows_go_on() -> None:
    camera, ground = Camera(1000, 1000), ground_plane((500.0, 800.0), 0.0, 60.0)
    card = card_for(camera, ground, [(300.0, 800.0), (500.0, 830.0), (700.0, 800.0)], 0.0, 400.0)
    light = lamp((500.0, 0.0, 900.0))
    assert [cast.sheet for cast in cast_card(camera, ground, card, light)] == [0, 0]
    first, second = cast_card(camera, ground, card, light)
    up = (500.0, 600.0)
    assert shadow_of(first, up) == pytest.approx(shadow_of(second, up), abs=1e-6)


def test_a_fold_with_the_light_on_different_sides_of_its_pieces_overlaps() -> None:
    camera, ground = Camera(1000, 1000), ground_plane((500.0, 800.0), 0.0, 45.0)
    card = card_for(camera, ground, [(300.0, 800.0), (500.0, 950.0), (700.0, 800.0)], 0.0, 400.0)
    light = lamp((1000.0, 200.0, 200.0))
    assert [cast.sheet for cast in cast_card(camera, ground, card, light)] == [0, 1]


def test_pieces_that_are_turned_alike_are_of_one_sheet_though_others_lie_between() -> None:
    """A light from the side turns what lies between two feet, one far behind the other, inside out."""
    camera, ground = Camera(1000, 1000), ground_plane((500.0, 900.0), 0.0, 65.0)
    feet = [Foothold((x, y), y, is_planted=True) for x, y in ((440.0, 899.0), (565.0, 800.0))]
    card = relief_card(camera, ground, feet, 702.0)
    casts = cast_card(camera, ground, card, lamp((-500.0, 350.0, 500.0)))
    turned = [np.linalg.det(cast.art_from_canvas) > 0 for cast in casts]
    assert {True, False} == set(turned)
    for one, is_turned in zip(casts, turned, strict=True):
        for other, other_is in zip(casts, turned, strict=True):
            if card.pieces[one.number].adjoins(card.pieces[other.number]):
                assert (one.sheet == other.sheet) == (is_turned == other_is)


def test_nothing_is_cast_in_space_by_a_light_within_the_piece() -> None:
    assert cast_in_space(Camera(1000, 1000), vertical_piece((500.0, 0.0), 0.0), lamp((300.0, -100.0, 0.0))) is None


def test_a_cast_in_space_is_bounded_by_the_side_of_its_card_and_its_limits() -> None:
    camera = Camera(1000, 1000, 35.0)
    piece = vertical_piece((400.0, 30.0), 0.4, 300.0, 450.0)
    space = cast_in_space(camera, piece, lamp((100.0, -300.0, 900.0)))
    assert space is not None
    assert space.forms.tolist() == [space.side.tolist(), *space.limits.tolist()]
    behind = np.array([400.0, 500.0, -20.0, 1.0])
    x, _, w = space.art_from_world @ behind
    assert space.forms @ behind == pytest.approx([abs(piece.plane @ behind), x - 300.0 * w, 450.0 * w - x])


def test_a_card_casts_nothing_on_itself() -> None:
    camera = Camera(1000, 1000, 35.0)
    piece = vertical_piece((400.0, 30.0), 0.4)
    assert cast_on(camera, receiver_of(camera, piece), piece, lamp((100.0, -300.0, 900.0))) is None
    before = vertical_piece((400.0, 90.0), 0.4)
    assert cast_on(camera, receiver_of(camera, piece), before, lamp((100.0, -300.0, 900.0))) is not None
