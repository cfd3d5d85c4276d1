"""Bodies of a set and what they hide: cones, lines and conics against rays that meet the bodies themselves."""

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import Plane, ground_plane, place_on
from kagezou.geometry.light import lamp, sun
from kagezou.geometry.sets import shapes as shapes
from kagezou.geometry.sets.bodies import Ball, Body, Drum, Solid
from kagezou.geometry.sets.faces_seen import GROUND, Face, faces_of, region_box
from kagezou.geometry.sets.heights import BodyHeights
from kagezou.geometry.sets.occlusion_cones import Cone, Occlusion, end_cone, occlusion_of
from kagezou.geometry.sets.regions import Flat, Group, Region
from kagezou.geometry.sets.round_faces_seen import round_faces_of
from kagezou.geometry.vectors import Vector4, height_over
from tests.render.reference import set_raycast

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

CANVAS = Box(0, 0, 1000, 1000)
GROUND_PLANE = ground_plane((500.0, 900.0), 4.0, 58.0)
CAMERAS = (Camera(1000, 1000), Camera(1000, 1000, 35.0))
LIGHTS = (lamp((250.0, -100.0, 900.0)), lamp((900.0, 200.0, -300.0)), sun(GROUND_PLANE, 40.0, 35.0))
KINDS = ("wall", "leaning wall", "box", "steps", "ramp", "cylinder", "sphere")


def stand(x: float = 520.0, y: float = 820.0, angle: float = 20.0) -> Plane:
    place = place_on(CAMERAS[0], GROUND_PLANE, (x, y))
    assert place is not None
    return shapes.stand_on(GROUND_PLANE, place, angle)


def bodies_of(kind: str, where: Plane | None = None) -> tuple[Body, ...]:
    at = where or stand()
    match kind:
        case "wall":
            return shapes.wall(at, 300, 220, 0.0)
        case "leaning wall":
            return shapes.wall(at, 300, 220, 25.0)
        case "box":
            return shapes.box(at, 160, 120, 90)
        case "steps":
            return shapes.steps(at, 200, 160, 120, 3)
        case "ramp":
            return shapes.ramp(at, 160, 200, 100)
        case "cylinder":
            return shapes.drum(at, 120, 200)
        case _:
            return shapes.ball(at, 160)


def holds(cone: Cone, points: Array) -> Flags:
    """Whether homogeneous points (N, 4) lie in a cone."""
    inside = (points @ cone.planes.T >= 0).all(axis=1)
    if cone.quadric is not None:
        inside &= np.einsum("ni,ij,nj->n", points, cone.quadric, points) >= 0
    return np.asarray(inside)


def hides(occlusion: Occlusion, points: Array) -> Flags:
    cones = [*occlusion.cones, *([] if occlusion.inside is None else [occlusion.inside])]
    return np.asarray(np.any([holds(cone, points) for cone in cones], axis=0))


def stands_between(body: Body, points: Array, source: Vector4) -> Flags:
    target = np.array(source)
    toward = np.broadcast_to(target[:3], points.shape) if target[3] == 0 else target[:3] - points
    enter, leave = set_raycast.interval(body, points, toward)
    return np.asarray((enter <= leave) & (leave > 0) & ((enter < 1) | (target[3] == 0)))


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("source", [*LIGHTS, CAMERAS[0].eye, CAMERAS[1].eye], ids=str)
def test_an_occlusion_holds_what_its_body_hides(kind: str, source: Vector4) -> None:
    rng = np.random.default_rng(5)
    for body in bodies_of(kind):
        points = rng.uniform((300, 500, -400), (800, 1000, 300), (4000, 3))
        hidden = hides(occlusion_of(body, source), np.column_stack([points, np.ones(len(points))]))
        assert 20 < hidden.sum() < 3900
        assert (hidden == stands_between(body, points, source)).mean() > 0.9995


@given(st.floats(-400, 400), st.floats(20, 600), st.floats(-400, 400))
def test_the_occlusion_of_a_drum_holds_from_anywhere(a: float, h: float, b: float) -> None:
    """From beside it, from over it and from within, where it hides nothing."""
    # On its very surface a lamp has no outline to tell.
    assume(abs(np.hypot(a, b) - 60) > 0.5 and abs(h - 200) > 0.5)
    at = stand(angle=0.0)
    drum = shapes.drum(at, 120, 200)[0]
    place = np.array(at.origin) + a * np.array(at.u) + b * np.array(at.v) + h * np.array(at.normal)
    source = lamp((place[0], place[1], place[2]))
    occlusion = occlusion_of(drum, source)
    if np.hypot(a, b) < 60 and h < 200:
        assert occlusion.cones == ()
        return
    points = np.random.default_rng(7).uniform((350, 500, -300), (700, 1000, 200), (1500, 3))
    hidden = hides(occlusion, np.column_stack([points, np.ones(len(points))]))
    assert (hidden == stands_between(drum, points, source)).mean() > 0.998


def test_nothing_is_hidden_from_within_a_ball_or_edge_on() -> None:
    ball = shapes.ball(stand(), 160)[0]
    assert occlusion_of(ball, lamp(ball.centre)).cones == ()
    wall = shapes.wall(stand(angle=0.0), 300, 220, 0.0)[0]
    along = (*wall.facets[0].plane(is_turned=False).u, 0.0)
    assert occlusion_of(wall, along).cones == ()


def test_from_straight_above_a_drum_hides_by_its_ends() -> None:
    drum = shapes.drum(stand(), 120, 200)[0]
    assert len(occlusion_of(drum, (*drum.axis, 0.0)).cones) == 2
    up = end_cone(drum, (*drum.axis, 0.0))
    assert up is not None
    assert up[0].origin == drum.head
    beside = end_cone(drum, lamp((drum.foot[0] + 500, drum.foot[1] + drum.axis[1], drum.foot[2] + drum.axis[2])))
    assert beside is None or beside[0].origin == drum.foot
    middle = (np.array(drum.foot) + np.array(drum.head)) / 2 + 300 * np.cross(drum.axis, (1.0, 0.0, 0.0))
    assert end_cone(drum, lamp((middle[0], middle[1], middle[2]))) is None
    x, y, z = (float(each) for each in np.cross(drum.axis, (1.0, 0.0, 0.0)))
    assert len(occlusion_of(drum, (x, y, z, 0.0)).cones) == 1


@pytest.mark.parametrize("kind", KINDS)
def test_bodies_stand_on_the_ground_as_large_as_they_are_told(kind: str) -> None:
    bodies = bodies_of(kind)
    spans = BodyHeights(bodies).over(GROUND_PLANE.equation).tolist()
    height = {"leaning wall": 220 * np.cos(np.radians(25)), "wall": 220, "box": 90, "steps": 120, "ramp": 100}
    assert min(low for low, _ in spans) == pytest.approx(0, abs=1e-5)
    assert max(high for _, high in spans) == pytest.approx(height.get(kind, 200 if kind == "cylinder" else 160))
    for body in bodies:
        if isinstance(body, Solid) and not body.is_sheet:
            middle = np.mean([corner for facet in body.facets for corner in facet.corners], axis=0)
            assert all(height_over(facet.equation, (*middle, 1.0)) < 0 for facet in body.facets)


def test_heights_over_a_slanted_plane_hold_every_point_of_a_round_body() -> None:
    drum, ball = shapes.drum(stand(), 120, 200)[0], shapes.ball(stand(), 160)[0]
    plane = (0.6, 0.0, 0.8, -300.0)
    turns = np.linspace(0, 2 * np.pi, 400)
    side = np.cross(drum.axis, (1.0, 0.0, 0.0))
    side /= np.linalg.norm(side)
    other = np.cross(drum.axis, side)
    rim = 60 * (np.outer(np.cos(turns), side) + np.outer(np.sin(turns), other))
    heights = np.concatenate([np.array(end) + rim for end in (drum.foot, drum.head)]) @ plane[:3] + plane[3]
    (low, high), (bottom, top) = BodyHeights([drum, ball]).over(plane).tolist()
    assert (low, high) == pytest.approx((heights.min(), heights.max()), abs=0.01)
    assert top - bottom == pytest.approx(160)


# ---- what a camera sees


def region_holds(region: Region, x: Array, y: Array) -> Flags:
    points = np.column_stack([x, y, np.ones_like(x)])
    inside = (points @ region.lines.T >= 0).all(axis=1)
    if region.conic is not None:
        inside &= np.einsum("ni,ij,nj->n", points, region.conic, points) >= 0
    return np.asarray(inside)


def group_holds(group: Group, x: Array, y: Array) -> Flags:
    return np.asarray(np.any([region_holds(region, x, y) for region in group.regions], axis=0))


def seen(face: Face, x: Array, y: Array) -> Flags:
    shown = np.ones(len(x), bool) if face.outline is None else region_holds(face.outline, x, y)
    shown &= np.column_stack([x, y, np.ones_like(x)]) @ face.flat.lift[3] > 0
    for group, _ in face.hidden.values():
        shown &= np.logical_not(group_holds(group, x, y))
    return np.asarray(shown)


def a_set() -> tuple[Body, ...]:
    """A wall behind steps, a box that stands in the wall, a drum and a ball that touch nothing, and a ball in a box."""
    return (
        *bodies_of("wall", stand(500, 760, 10)),
        *bodies_of("steps", stand(380, 840, -15)),
        *bodies_of("box", stand(600, 765, 30)),
        *bodies_of("cylinder", stand(720, 850, 0)),
        *bodies_of("sphere", stand(250, 830, 0)),
        Ball(bodies_of("box", stand(600, 765, 30))[0].facets[1].corners[0], 30.0),  # type: ignore[union-attr]
    )


@pytest.mark.parametrize("camera", CAMERAS, ids=["orthographic", "perspective"])
def test_every_point_of_the_canvas_shows_the_face_that_a_ray_meets(camera: Camera) -> None:
    bodies = a_set()
    rng = np.random.default_rng(3)
    x, y = rng.uniform(0, 1000, (2, 20000))
    found = set_raycast.look(camera, GROUND_PLANE, bodies, x, y)
    faces = faces_of(camera, CANVAS, GROUND_PLANE, bodies)
    count = np.sum([seen(face, x, y) for face in faces], axis=0)
    rounds = round_faces_of(camera, CANVAS, bodies)
    assert {each.body for each in rounds} == {index for index, body in enumerate(bodies) if not isinstance(body, Solid)}
    on_end = np.abs(found.normal @ np.array(GROUND_PLANE.normal)) > 1 - 1e-12
    on_round = np.isin(found.body, [each.body for each in rounds])
    flat = (found.body >= GROUND) & ~on_round
    assert (count[flat] == 1).mean() > 0.999
    assert (count[found.body == set_raycast.NOTHING] == 0).all()
    for face in faces:
        right = found.body[seen(face, x, y)] == face.body
        assert right.all() or right.mean() > 0.99
        inside = seen(face, x, y)
        assert not inside.any() or (x[inside].min() >= face.box.left and y[inside].max() <= face.box.bottom)
    for each in rounds:
        mine = found.body == each.body
        assert group_holds(each.outline, x[mine], y[mine]).all()
        points = np.stack([x[mine], y[mine], np.ones(mine.sum())])
        assert np.abs(each.seen_at(camera, points)[:3].T - found.point[mine])[~on_end[mine]].max(initial=0) < 1e-6
        assert BodyHeights([bodies[each.body]]).over((0.0, 0.0, 1.0, -float(each.centre[2])))[0, 0] < 0


@pytest.mark.parametrize("light", LIGHTS, ids=str)
def test_what_is_taken_from_the_light_is_what_rays_to_it_meet(light: Vector4) -> None:
    camera, bodies = CAMERAS[1], a_set()
    rng = np.random.default_rng(4)
    x, y = rng.uniform(0, 1000, (2, 12000))
    occlusions = {index: occlusion_of(body, light) for index, body in enumerate(bodies)}
    for face in faces_of(camera, CANVAS, GROUND_PLANE, bodies):
        if height_over(face.plane.equation, light) <= 0:
            continue
        mine = seen(face, x, y)
        if not mine.any():
            continue
        points = np.column_stack([x[mine], y[mine], np.ones(mine.sum())]) @ face.flat.lift.T
        points = points[:, :3] / points[:, 3:]
        wanted = np.zeros(len(points), bool)
        for index, body in enumerate(bodies):
            if index != face.body:
                toward = np.broadcast_to(light[:3], points.shape) if light[3] == 0 else np.array(light[:3]) - points
                enter, leave = set_raycast.interval(body, points, toward)
                wanted |= (enter <= leave) & (leave > 1e-6) & ((enter < 1) | (light[3] == 0))
        groups = face.unlit(occlusions)
        got = np.any(
            [group_holds(group, x[mine], y[mine]) for group in groups] or [np.zeros(len(points), bool)], axis=0
        )
        # A line that a body stands on is moved out of sight by less than a pixel.
        assert (got == wanted).mean() > 0.995


def test_faces_that_show_nothing_are_left_out() -> None:
    beyond = bodies_of("box", stand(-4000, 850))
    below = (Drum((500.0, 880.0, 9000.0), (0.0, -1.0, 0.0), 20.0, 50.0),)
    faces = faces_of(CAMERAS[1], CANVAS, GROUND_PLANE, (*beyond, *below, *bodies_of("sphere", stand(-4000, 850))))
    assert [face.body for face in faces if face.body <= 0] == [GROUND]
    assert round_faces_of(CAMERAS[1], CANVAS, (*below, *bodies_of("sphere", stand(-4000, 850)))) == ()
    around_the_eye = Ball(tuple(CAMERAS[1].eye[:3]), 100.0)  # type: ignore[arg-type]
    assert round_faces_of(CAMERAS[1], CANVAS, (around_the_eye,)) == ()
    upright = Drum((500.0, 880.0, 0.0), (0.0, -1.0, 0.0), 20.0, 50.0)
    assert [face.body for face in faces_of(CAMERAS[0], CANVAS, GROUND_PLANE, (upright,))] == [GROUND]
    edge_on = ground_plane((500.0, 900.0), 0.0, 90.0)
    assert faces_of(CAMERAS[0], CANVAS, edge_on, ()) == ()


def test_boxes_of_regions() -> None:
    circle = np.diag([-1.0, -1.0, 0.0])
    circle[0, 2] = circle[2, 0] = 300.0
    circle[1, 2] = circle[2, 1] = 400.0
    circle[2, 2] = 50.5**2 - 300.0**2 - 400.0**2
    everything = np.zeros((0, 3))
    around = region_box(Region(everything, circle), CANVAS)
    assert around is not None
    assert (around.left, around.right) == (248, 352)
    assert (around.top, around.bottom) == (348, 452)
    hyperbola = np.diag([-1.0, 1.0, 10.0])
    assert region_box(Region(everything, hyperbola), CANVAS) == CANVAS
    assert region_box(Region(np.array([[1.0, 0.0, -2000.0]])), CANVAS) is None
    assert region_box(Region(np.array([[-1.0, 0.0, 100.0]]), circle), CANVAS) is None


def test_a_body_that_only_touches_a_receiver_is_not_sunk_into_it() -> None:
    (face,) = faces_of(Camera(1000, 1000), Box(0, 0, 1000, 1000), GROUND_PLANE, ())
    occlusion = occlusion_of(shapes.ball(stand(), 60.0)[0], lamp((300.0, -200.0, 900.0)))
    assert occlusion.inside is not None

    def regions(low: float) -> int:
        taken = face.flat.group((low, 100.0), occlusion, keeps_footprint=True)
        return 0 if taken is None else len(taken[0].regions)

    assert regions(-5e-5) == regions(0.0)
    assert regions(-1.0) == regions(0.0) + 1


def span_over(flat: Flat, body: Body) -> tuple[float, float]:
    low, high = BodyHeights([body]).over(flat.equation)[0].tolist()
    return low, high


def test_what_lies_in_a_receiver_s_plane_takes_nothing_but_a_round_footprint() -> None:
    """A box beside a wall of the same plane, and a drum on the ground."""
    at = stand(angle=0.0)
    wall = shapes.wall(at, 300, 220, 0.0)[0]
    lift = faces_of(CAMERAS[1], CANVAS, GROUND_PLANE, (wall,))[1].flat
    twin = shapes.wall(at, 100, 100, 0.0)[0]
    assert lift.group(span_over(lift, twin), occlusion_of(twin, CAMERAS[1].eye), keeps_footprint=True) is None
    ground = faces_of(CAMERAS[1], CANVAS, GROUND_PLANE, ())[0].flat
    drum = shapes.drum(at, 120, 200)[0]
    kept, bare = (
        ground.group(span_over(ground, drum), occlusion_of(drum, CAMERAS[1].eye), keeps_footprint=keeps)
        for keeps in (True, False)
    )
    assert kept is not None
    assert bare is not None
    assert len(kept[0].regions) == len(bare[0].regions) + 1
    sunk = Ball(at.origin, 50.0)
    held = ground.group(span_over(ground, sunk), occlusion_of(sunk, CAMERAS[1].eye), keeps_footprint=True)
    assert held is not None
    assert len(held[0].regions) == 2
    assert isinstance(ground, Flat)
