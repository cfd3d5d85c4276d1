"""The edges of set pieces against sight lines walked step by step."""

from math import dist, pi

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import ground_plane
from kagezou.geometry.sets import shapes as shapes
from kagezou.geometry.sets.bodies import Body, Drum, Solid
from kagezou.geometry.sets.measures import Measures, PieceKind
from kagezou.geometry.sets.shapes import bodies_of, stand_on
from kagezou.geometry.sets.wires import RIM_PARTS, Wire, wires_of
from kagezou.geometry.vectors import Matrix, Vector4
from tests.effort import tries

STEPS_WALKED = 500


def is_inside(body: Body, points: Matrix) -> NDArray[np.bool_]:
    homogeneous = np.column_stack([points, np.ones(len(points))])
    planes = [facet.equation for facet in body.facets] if isinstance(body, Solid) else []
    if isinstance(body, Drum):
        planes = list(body.ends)
    inside: NDArray[np.bool_] = np.ones(len(points), np.bool_)
    for plane in planes:
        inside &= homogeneous @ np.array(plane) < -1e-6
    if not isinstance(body, Solid):
        inside &= np.einsum("ij,jk,ik->i", homogeneous, body.quadric, homogeneous) < -1e-3
    return np.asarray(inside, np.bool_)


def walked_within(
    bodies: tuple[Body, ...], start: Matrix, eye: Vector4, size: float, steps: int = STEPS_WALKED
) -> float:
    """Return how far the way from a point to the eye is within bodies, px, as far as it was walked."""
    way = np.array(eye[:3]) - eye[3] * start
    way = way / np.linalg.norm(way)
    points = start + np.linspace(0, 3 * size, steps)[:, None] * way
    inside = np.logical_or.reduce([is_inside(body, points) for body in bodies])
    return float(inside.sum()) * 3 * size / steps


def middle_of(wire: Wire) -> Matrix:
    """Return a point truly on a wire: the corner nearest to its middle, or the middle of a straight one."""
    points = np.array(wire.points)
    return np.asarray(points[len(points) // 2] if len(points) > 2 else points.mean(axis=0), np.float64)


def is_one_part_of_a_rim(wire: Wire, measures: Measures) -> bool:
    """Whether a wire is but one chord of a circle: its ends may be seen or not, and its middle is within the piece."""
    chord = 2 * pi * (measures.width_px / 2) / RIM_PARTS
    return measures.kind in {"cylinder", "sphere"} and len(wire.points) == 2 and dist(*wire.points) < 1.01 * chord


@pytest.mark.parametrize("kind", [kind for kind in PieceKind if kind not in (PieceKind.WALL, PieceKind.MESH)])
@settings(max_examples=tries(4, 15))
@given(
    # A face that is seen edge-on may be either.
    st.builds(lambda turns, angle: 90.0 * turns + angle, st.integers(0, 3), st.floats(7, 83)),
    st.floats(15, 80),
    st.one_of(st.just(0.0), st.floats(10, 60)),
)
def test_what_is_hidden_is_what_a_sight_line_cannot_reach(
    kind: PieceKind, angle: float, theta: float, fov: float
) -> None:
    stand = stand_on(ground_plane((500, 800), 10.0, theta), (450.0, 700.0, -100.0), angle)
    measures = Measures(kind, 200.0, 150.0, 180.0, count=3)
    made: dict[str, tuple[Body, ...]] = {
        "steps": shapes.steps(stand, 200, 180, 150, 3),
        "ramp": shapes.ramp(stand, 200, 180, 150),
        "cylinder": shapes.drum(stand, 200, 150),
        "sphere": shapes.ball(stand, 200),
    }
    bodies = made.get(kind, shapes.box(stand, 200, 180, 150))
    eye = Camera(1000, 1000, fov).eye
    for wire in wires_of(stand, measures, eye):
        if is_one_part_of_a_rim(wire, measures):
            continue
        # An end of a run may lie between the places that were looked at; its middle is sure.
        middle = middle_of(wire)
        within = walked_within(bodies, middle, eye, 400)
        if within >= 12:
            assert wire.is_hidden, (kind, within)
        elif within < 0.5 and wire.is_hidden:
            # Coarse steps may have missed a corner that the way only brushes.
            assert walked_within(bodies, middle, eye, 400, steps=50_000) > 0, kind


@given(st.floats(5, 85), st.one_of(st.just(0.0), st.floats(5, 90)))
def test_the_outline_of_a_sphere_is_where_sight_lines_touch_it(theta: float, fov: float) -> None:
    stand = stand_on(ground_plane((500, 800), 0.0, theta), (700.0, 600.0, -200.0), 0.0)
    ball, eye = shapes.ball(stand, 160)[0], Camera(1000, 1000, fov).eye
    contour = wires_of(stand, Measures(PieceKind.SPHERE, 160.0, 1.0, 1.0), eye)[0]
    for point in contour.points[::7]:
        way = np.array(eye[:3]) - eye[3] * np.array(point)
        away = np.cross(np.array(ball.centre) - np.array(point), way / np.linalg.norm(way))
        assert np.linalg.norm(away) == pytest.approx(80, abs=1e-6)


def test_a_wall_is_its_four_sides_and_a_box_its_twelve() -> None:
    stand = stand_on(ground_plane((500, 800), 0.0, 60.0), (500.0, 700.0, 0.0), 30.0)
    eye = Camera(1000, 1000).eye
    (wall,) = wires_of(stand, Measures(PieceKind.WALL, 200.0, 100.0, 1.0, lean_deg=20.0), eye)
    lengths = [dist(a, b) for a, b in zip(wall.points, wall.points[1:], strict=False)]
    assert lengths == pytest.approx([200, 100, 200, 100])
    box = wires_of(stand, Measures(PieceKind.BOX, 200.0, 100.0, 50.0), eye)
    assert sorted(round(dist(*wire.points)) for wire in box) == [50] * 4 + [100] * 4 + [200] * 4
    assert sum(wire.is_hidden for wire in box) == 3


def test_what_is_not_made_of_measures_has_no_edges() -> None:
    stand = stand_on(ground_plane((500, 800), 0.0, 60.0), (500.0, 700.0, 0.0), 0.0)
    assert wires_of(stand, Measures(PieceKind.MESH, 100.0, 100.0, 100.0), Camera(1000, 1000).eye) == ()


def test_from_right_above_a_drum_has_no_sides() -> None:
    stand = stand_on(ground_plane((500, 800), 0.0, 0.0), (500.0, 700.0, 0.0), 0.0)
    wires = wires_of(stand, Measures(PieceKind.CYLINDER, 100.0, 300.0, 1.0), Camera(1000, 1000).eye)
    assert all(len(wire.points) > 2 for wire in wires)


@pytest.mark.parametrize("fov_deg", [0.0, 50.0])
def test_the_sides_of_a_drum_are_where_sight_lines_touch_it(fov_deg: float) -> None:
    stand = stand_on(ground_plane((500, 800), 0.0, 60.0), (620.0, 700.0, -150.0), 0.0)
    measures = Measures(PieceKind.CYLINDER, 100.0, 300.0, 1.0)
    (drum,), eye = bodies_of(stand, measures), Camera(1000, 1000, fov_deg).eye
    assert isinstance(drum, Drum)
    axis, foot = np.array(drum.axis), np.array(drum.foot)
    straight = [np.array(wire.points) for wire in wires_of(stand, measures, eye) if len(wire.points) == 2]
    sides = [each for each in straight if np.linalg.norm(np.cross(each[1] - each[0], axis)) < 1e-6]
    assert sides
    for point in np.concatenate(sides):
        normal = np.cross(axis, np.array(eye[:3]) - eye[3] * point)
        assert abs((point - foot) @ normal) / np.linalg.norm(normal) == pytest.approx(50, abs=1e-6)
