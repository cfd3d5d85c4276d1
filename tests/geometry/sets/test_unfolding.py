"""A set laid flat: lengths, hinges and charts."""

from math import cos, radians, sin

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kagezou.geometry.ground import ground_plane
from kagezou.geometry.sets import shapes as shapes
from kagezou.geometry.sets.bodies import Solid
from kagezou.geometry.sets.laid_flat import GROUND, FlatFace, FlatSheet, covers, moved
from kagezou.geometry.sets.unfolding import unfolded
from kagezou.geometry.vectors import Matrix, height_over

GROUND_PLANE = ground_plane((500.0, 900.0), 4.0, 60.0)


def lit_faces(bodies: tuple[Solid, ...], azimuth_deg: float, elevation_deg: float) -> tuple[FlatFace, ...]:
    u, v, up = (np.array(each) for each in (GROUND_PLANE.u, GROUND_PLANE.v, GROUND_PLANE.normal))
    azimuth, elevation = radians(azimuth_deg), radians(elevation_deg)
    toward = cos(elevation) * (sin(azimuth) * u + cos(azimuth) * v) + sin(elevation) * up
    light = (float(toward[0]), float(toward[1]), float(toward[2]), 0.0)
    found = []
    for index, body in enumerate(bodies):
        for facet in body.facets:
            plane = facet.plane(is_turned=False)
            if height_over(plane.equation, light) > 1e-6:
                found.append(FlatFace(index, plane, np.array(facet.corners)))
    return tuple(found)


def sides(points: Matrix) -> Matrix:
    return np.asarray(np.linalg.norm(points - np.roll(points, 1, axis=0), axis=1))


def back(sheet: FlatSheet) -> Matrix:
    """From flat places to those on the sheet's own plane."""
    return np.asarray(np.linalg.inv(sheet.flat_from_plane), np.float64)


def ends_in_space(sheet: FlatSheet) -> Matrix:
    """The hinge of a sheet in the world, by the sheet's own plane."""
    local = moved(back(sheet), sheet.seam)
    return np.column_stack([local, np.ones(2)]) @ sheet.face.plane.world_from_plane()[:3].T


@settings(max_examples=25, deadline=None)
@given(st.floats(-170, 170), st.floats(-60, 60), st.floats(20, 80), st.sampled_from(["box", "steps", "ramp"]))
def test_faces_keep_their_lengths_and_hang_at_their_hinges(
    angle: float, azimuth: float, elevation: float, kind: str
) -> None:
    stand = shapes.stand_on(GROUND_PLANE, GROUND_PLANE.point(40.0, -200.0), angle)
    bodies = {
        "box": shapes.box(stand, 120.0, 80.0, 60.0),
        "steps": shapes.steps(stand, 120.0, 80.0, 60.0, 3),
        "ramp": shapes.ramp(stand, 120.0, 80.0, 60.0),
    }[kind]
    faces = lit_faces(bodies, azimuth, elevation)
    development = unfolded(GROUND_PLANE, faces, 12, 0.0)
    own = [sheet for sheet in development.sheets if not sheet.is_guest]
    # Every lit face hangs together with the ground, and each is laid once.
    assert len(own) == len(faces)
    for sheet in own:
        assert np.allclose(sides(sheet.corners), sides(sheet.face.corners))
        if sheet.parent != GROUND:
            parent = development.sheets[sheet.parent]
            in_parent = moved(back(parent), sheet.seam)
            world = np.column_stack([in_parent, np.ones(2)]) @ parent.face.plane.world_from_plane()[:3].T
            assert np.allclose(world, ends_in_space(sheet), atol=1e-3)


@pytest.mark.parametrize("height", [90.0, 220.0])
def test_no_face_of_a_chart_lies_over_another_that_is_looked_up_there(height: float) -> None:
    stand = shapes.stand_on(GROUND_PLANE, GROUND_PLANE.point(40.0, -200.0), 30.0)
    faces = lit_faces(shapes.box(stand, 120.0, 100.0, height), 10.0, 40.0)
    development = unfolded(GROUND_PLANE, faces, 12, 0.0)
    for number in range(1, len(development.charts)):
        shown = [sheet for sheet in development.sheets if sheet.is_looked_up and sheet.chart == number]
        assert shown
        for index, first in enumerate(shown):
            assert not any(covers(first.corners, second.corners) for second in shown[index + 1 :])
    # The two sides that meet at an upright edge pass over into each other there, each a half.
    cuts = [join for join in development.joins if join.most == 0.5]
    assert len(cuts) % 2 == 0
    assert cuts
    assert all(join in development.joins_of(join.sheet) for join in cuts)


def two_boxes() -> tuple[FlatFace, ...]:
    """The lit faces of two boxes 180 px apart."""
    stands = (shapes.stand_on(GROUND_PLANE, GROUND_PLANE.point(x, -200.0), 30.0) for x in (40.0, 320.0))
    return lit_faces(tuple(body for stand in stands for body in shapes.box(stand, 100.0, 80.0, 40.0)), 10.0, 40.0)


def test_faces_share_a_chart_only_where_there_is_no_room_apart() -> None:
    faces = two_boxes()
    roomy = unfolded(GROUND_PLANE, faces, 12, 400.0)
    assert not roomy.crowded
    scant = unfolded(GROUND_PLANE, faces, 2, 400.0)
    assert scant.crowded == {1}
    assert {sheet.face.body for sheet in scant.sheets if sheet.chart == 1} == {0, 1}
    # What shares is not widened: it would lie over what stands beside it.
    for outline in scant.outlines(1, 30.0):
        assert np.allclose(np.ptp(outline.corners, axis=0), np.ptp(scant.sheets[outline.sheet].corners, axis=0))


def test_faces_without_a_place_crowd_nothing() -> None:
    stand = shapes.stand_on(GROUND_PLANE, GROUND_PLANE.point(40.0, -200.0), 30.0)
    faces = lit_faces(shapes.box(stand, 120.0, 100.0, 220.0), 10.0, 40.0)
    development = unfolded(GROUND_PLANE, faces, 2, 0.0)
    assert not development.crowded
    assert any(sheet.chart == 0 for sheet in development.sheets)


def test_what_stays_on_a_chart_is_laid_over_its_guests() -> None:
    stand = shapes.stand_on(GROUND_PLANE, GROUND_PLANE.point(40.0, -200.0), 30.0)
    development = unfolded(GROUND_PLANE, lit_faces(shapes.steps(stand, 120.0, 80.0, 60.0, 3), 10.0, 40.0), 12, 0.0)
    over = 0
    for chart, laid in list(enumerate(development.charts))[1:]:
        order = [outline.sheet for outline in development.outlines(chart, 0.0)]
        # First with what goes on beyond their edges, then without.
        assert order[: len(laid)] == order[len(laid) :]
        assert sorted(order[: len(laid)]) == sorted(laid)
        place = {sheet: order.index(sheet) for sheet in laid}
        guests = [number for number in laid if development.sheets[number].is_guest]
        own = [number for number in laid if number not in guests]
        assert all(place[guest] < place[number] for guest in guests for number in own)
        assert [place[number] for number in own] == sorted(place[number] for number in own)
        over += sum(
            covers(development.sheets[number].corners, development.sheets[guest].corners)
            for guest in guests
            for number in own
        )
    assert over
