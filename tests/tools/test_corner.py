"""A corner drawn on the picture is seen where it was drawn, under every camera."""

from math import atan2, cos, degrees, hypot, radians, sin

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from kagezou.document import properties as p
from kagezou.document import set_properties as s
from kagezou.document.address import Address, value_of
from kagezou.document.edits import set_key
from kagezou.document.invariants import check
from kagezou.document.model import Canvas, Document
from kagezou.geometry.ground import place_on
from kagezou.geometry.sight import seen
from kagezou.geometry.vectors import Point2, dot
from kagezou.scene.evaluate import camera_at, ground_at
from kagezou.scene.piece_frames import piece_frame
from kagezou.tools.corner import Lay, drawing, ground_line, is_on_ground, wall_line
from kagezou.tools.pointer import Modifiers, Pointer
from kagezou.tools.sight import moved
from tests.tools.tool_scenes import FREE, LAYER, PIECE, document_with, number, place

grounds = st.builds(
    lambda position, roll, declination, fov: document_with(
        (p.GROUND_POSITION, position), (p.GROUND_ROLL, roll), (p.GROUND_DECLINATION, declination), (p.FOV, fov)
    ),
    st.tuples(st.floats(200, 800), st.floats(600, 950)),
    st.floats(-40, 40),
    st.floats(10, 85),
    st.one_of(st.just(0.0), st.floats(10, 90)),
)
points = st.tuples(st.floats(0, 1000), st.floats(500, 1000))


def drawn(document: Document, lay: Lay, start: Point2, end: Point2, modifiers: Modifiers = FREE) -> Document:
    """Draw a line through a place between, unzoomed."""
    drag = drawing(document, lay)
    middle = ((start[0] + end[0]) / 2 + 30, (start[1] + end[1]) / 2)
    for at in (start, middle, end):
        document = drag.send(Pointer(at, at, modifiers))
    drag.close()
    check(document)
    return document


def distance_from_line(point: Point2, start: Point2, end: Point2) -> float:
    (x, y), (dx, dy) = (point[0] - start[0], point[1] - start[1]), (end[0] - start[0], end[1] - start[1])
    return abs(x * dy - y * dx) / hypot(dx, dy)


@given(grounds, points, points)
def test_the_ground_line_runs_where_it_was_drawn(document: Document, start: Point2, end: Point2) -> None:
    assume(hypot(end[0] - start[0], end[1] - start[1]) > 20)
    after = drawn(document, ground_line(document, 1), start, end)
    ground = ground_at(after, 1)
    for distance in (-500.0, 0.0, 500.0):
        at = moved(ground.origin, (distance, ground.u))
        assert distance_from_line(at[:2], start, end) < 1e-3
    assert -90 <= number(after, p.GROUND_ROLL) <= 90
    if abs(number(after, p.GROUND_ROLL)) < 59:
        assert ground.origin[0] == pytest.approx(place(document, p.GROUND_POSITION)[0], abs=1e-6)
    backward = drawn(document, ground_line(document, 1), end, start)
    assert abs(number(backward, p.GROUND_ROLL)) == pytest.approx(abs(number(after, p.GROUND_ROLL)))


@given(grounds, points, points)
def test_the_foot_of_the_wall_runs_where_it_was_drawn_and_its_front_is_seen(
    document: Document, start: Point2, end: Point2
) -> None:
    camera, ground = camera_at(document, 1), ground_at(document, 1)
    ends = [place_on(camera, ground, point) for point in (start, end)]
    assume(all(each is not None and max(map(abs, each)) < 2e4 for each in ends))
    assume(hypot(end[0] - start[0], end[1] - start[1]) > 20)
    after = drawn(document, wall_line(document, 1, LAYER, "Wall"), start, end)
    assert len(after.pieces) == 1
    wall = piece_frame(after.pieces[0], 1, camera, ground)
    assert wall is not None
    half = wall.measures.width_px / 2
    feet = [seen(camera, moved(wall.stand.origin, (side * half, wall.stand.u))) for side in (-1, 1)]
    for wanted in (start, end):
        assert min(hypot(foot[0] - wanted[0], foot[1] - wanted[1]) for foot in feet) < 0.05
    assert dot(wall.stand.v, camera.toward_eye((*wall.stand.origin, 1.0))) >= -1e-6


@given(st.floats(40, 80), st.one_of(st.just(0.0), st.floats(10, 60)), st.floats(-20, 20), st.floats(760, 900))
def test_the_wall_is_seen_over_the_figure(declination: float, fov: float, roll: float, y: float) -> None:
    document = document_with((p.GROUND_DECLINATION, declination), (p.FOV, fov), (p.GROUND_ROLL, roll))
    camera, ground = camera_at(document, 1), ground_at(document, 1)
    assume(is_on_ground(document, 1, (200.0, y)) and is_on_ground(document, 1, (800.0, y)))
    after = drawn(document, wall_line(document, 1, None, "Wall"), (200.0, y), (800.0, y))
    wall = piece_frame(after.pieces[0], 1, camera, ground)
    assert wall is not None
    top = seen(camera, moved(wall.stand.origin, (wall.measures.height_px, ground.normal)))
    height = number(after, s.PIECE_HEIGHT)
    over = (200 - top[1]) * cos(radians(roll)) + (top[0] - 500) * sin(radians(roll))
    assert over > 0 or height == pytest.approx(3000)
    assert height >= 0.6 * 700


def test_a_far_wall_is_no_lower_than_a_part_of_the_figure_and_without_one_there_is_a_wall_too() -> None:
    document = document_with((p.GROUND_DECLINATION, 20.0))
    far = drawn(document, wall_line(document, 1, LAYER, "Wall"), (100.0, 100.0), (800.0, 100.0))
    assert number(far, s.PIECE_HEIGHT) == pytest.approx(0.6 * 700)
    bare = Document(Canvas(800, 600))
    after = drawn(bare, wall_line(bare, 1, None, "Wall"), (100.0, 500.0), (700.0, 500.0))
    assert number(after, s.PIECE_WIDTH) == pytest.approx(600)


def test_a_wall_ends_before_the_horizon_and_does_not_begin_beyond_it() -> None:
    document = document_with((p.FOV, 50.0), (p.GROUND_DECLINATION, 80.0))
    assert not is_on_ground(document, 1, (500.0, -2000.0))
    after = drawn(document, wall_line(document, 1, LAYER, "Wall"), (500.0, 900.0), (500.0, -2000.0))
    assert piece_frame(after.pieces[0], 1, camera_at(after, 1), ground_at(after, 1)) is not None
    assert drawn(document, wall_line(document, 1, LAYER, "Wall"), (500.0, -2000.0), (500.0, 900.0)) is document
    edge_on = document_with((p.GROUND_DECLINATION, 90.0))
    assert drawn(edge_on, wall_line(edge_on, 1, LAYER, "Wall"), (100.0, 900.0), (500.0, 900.0)) is edge_on


def test_a_twitch_draws_nothing_and_going_back_gives_the_start() -> None:
    document = document_with()
    drag = drawing(document, ground_line(document, 1))
    shown = [drag.send(Pointer((x, 500.0), (x, 500.0), FREE)) for x in (100.0, 105.0, 300.0, 101.0)]
    assert [each is document for each in shown] == [True, True, False, True]


def test_constrained_lines_run_in_steps() -> None:
    document = document_with()
    constrained = Modifiers(constrain=True)
    after = drawn(document, ground_line(document, 1), (100.0, 900.0), (600.0, 925.0), constrained)
    assert number(after, p.GROUND_ROLL) == 0
    assert place(after, p.GROUND_POSITION) == pytest.approx((500, 900))
    after = drawn(document, ground_line(document, 1), (100.0, 900.0), (600.0, 1010.0), constrained)
    assert number(after, p.GROUND_ROLL) == pytest.approx(15)


def test_a_keyed_ground_gets_a_key_at_the_frame() -> None:
    document = set_key(document_with(), Address(p.GROUND_ROLL), 1, 0.0)
    lay = ground_line(document, 9)
    after = drawn(document, lay, (100.0, 900.0), (600.0, 950.0))
    assert value_of(after, Address(p.GROUND_ROLL), 1) == 0
    assert value_of(after, Address(p.GROUND_ROLL), 9) == pytest.approx(degrees(atan2(50, 500)))


def test_walls_after_the_first_have_names_of_their_own() -> None:
    document = document_with()
    for _ in range(2):
        document = drawn(document, wall_line(document, 1, LAYER, "Wall"), (100.0, 850.0), (800.0, 850.0))
    assert [piece.name for piece in document.pieces] == ["Wall", "Wall 2"]
    assert document.pieces[0].id == PIECE
