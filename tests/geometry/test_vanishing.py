"""Cameras found again from the lines that they see."""

from math import cos, radians, sin

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from kagezou.geometry.camera import Camera, project
from kagezou.geometry.ground import ground_plane
from kagezou.geometry.vanishing import (
    CameraMatch,
    Line,
    Mismatch,
    VanishingLines,
    azimuth_of,
    declination_below,
    first_lines,
    horizon_of,
    laid,
    matched,
    vanishing_point,
)

SIZE = (1600.0, 900.0)


def seen_lines(camera: Camera, roll: float, declination: float, azimuth: float) -> VanishingLines:
    """Return edges of tiles on a floor as a camera sees them, worked out point by point."""
    ground = ground_plane((800.0, 700.0), roll, declination)
    angle = radians(azimuth)
    along, across = (cos(angle), sin(angle)), (-sin(angle), cos(angle))

    def line(start: tuple[float, float], way: tuple[float, float]) -> Line:
        ends = (start, (start[0] + 120 * way[0], start[1] + 120 * way[1]))
        a, b = (project(camera.canvas_from_world(), (*ground.point(*end), 1.0)) for end in ends)
        return (a, b)

    return VanishingLines(
        (line((-150.0, 20.0), along), line((90.0, -60.0), along)),
        (line((-150.0, 20.0), across), line((90.0, -60.0), across)),
    )


@given(
    fov=st.floats(12, 100),
    roll=st.floats(-30, 30),
    declination=st.floats(25, 85),
    azimuth=st.floats(20, 70),
)
def test_a_camera_is_found_from_the_lines_it_sees(fov: float, roll: float, declination: float, azimuth: float) -> None:
    camera = Camera(1600, 900, fov)
    lines = seen_lines(camera, roll, declination, azimuth)
    points = [vanishing_point(pair, SIZE) for pair in (lines.first, lines.second)]
    assume(all(point is not None for point in points))
    match = matched(lines, SIZE, 0.0)
    assert isinstance(match, CameraMatch)
    assert match.fov_deg == pytest.approx(fov, abs=1e-4)
    assert match.roll_deg == pytest.approx(roll, abs=1e-4)
    assert match.declination_deg == pytest.approx(declination, abs=1e-4)
    found = azimuth_of(lines.first, camera, ground_plane((0.0, 0.0), roll, declination))
    assert found == pytest.approx(azimuth, abs=1e-4)


@given(
    fov=st.floats(12, 100),
    roll=st.floats(-30, 30),
    declination=st.floats(25, 88),
    azimuth=st.floats(0, 180, exclude_max=True),
)
def test_laid_lines_meet_where_their_direction_vanishes(
    fov: float, roll: float, declination: float, azimuth: float
) -> None:
    camera, ground = Camera(1600, 900, fov), ground_plane((800.0, 700.0), roll, declination)
    before = first_lines(SIZE)
    lines = laid(before, camera, ground, azimuth)
    for old, new in zip(before.all, lines.all, strict=True):
        assert np.mean(new, axis=0) == pytest.approx(np.mean(old, axis=0))
        assert np.hypot(*np.subtract(*new)) == pytest.approx(np.hypot(*np.subtract(*old)))
    horizon = horizon_of(camera, roll, declination)
    assert horizon is not None
    up = (sin(radians(roll)), -cos(radians(roll)))
    for pair in (lines.first, lines.second):
        point = vanishing_point(pair, SIZE)
        if point is not None:
            height = up[0] * (point[0] - 800) + up[1] * (point[1] - 450)
            assert height == pytest.approx(horizon.height_px, rel=1e-6, abs=1e-2)


def test_the_horizon_and_the_declination_tell_each_other() -> None:
    camera = Camera(1600, 900, 53.13010235415598)  # an eye 900 px away
    horizon = horizon_of(camera, 0.0, 45.0)
    assert horizon is not None
    assert horizon.height_px == pytest.approx(900.0)
    assert declination_below(camera, 900.0) == pytest.approx(45.0)
    assert declination_below(camera, -50.0) == 90.0
    assert horizon_of(Camera(1600, 900), 0.0, 45.0) is None


def test_one_direction_parallel_to_the_picture_keeps_the_field_of_view() -> None:
    lines = seen_lines(Camera(1600, 900, 50.0), 0.0, 70.0, 90.0)
    match = matched(lines, SIZE, 50.0)
    assert isinstance(match, CameraMatch)
    assert (match.fov_deg, match.roll_deg, match.declination_deg) == pytest.approx((50.0, 0.0, 70.0), abs=1e-6)
    without = matched(lines, SIZE, 0.0)
    assert isinstance(without, CameraMatch)
    assert without.fov_deg == pytest.approx(40.0)


@pytest.mark.parametrize(
    ("lines", "reason"),
    [
        (VanishingLines((((0, 0), (9, 0)), ((20, 0), (40, 0))), (((0, 0), (5, 9)), ((50, 0), (40, 9)))), "same-line"),
        (VanishingLines((((0, 0), (0, 0)), ((20, 5), (40, 9))), (((0, 0), (5, 9)), ((50, 0), (40, 9)))), "same-line"),
        (VanishingLines((((0, 0), (9, 0)), ((0, 9), (9, 9))), (((0, 0), (5, 9)), ((50, 0), (55, 9)))), "all-parallel"),
        (
            VanishingLines(
                (((100, 800), (300, 500)), ((500, 800), (350, 500))),
                (((600, 800), (500, 500)), ((900, 800), (550, 500))),
            ),
            "not-square",
        ),
    ],
)
def test_lines_that_tell_nothing_say_why(lines: VanishingLines, reason: str) -> None:
    assert matched(lines, SIZE, 40.0) is Mismatch(reason)


def test_two_ways_to_one_point_are_no_horizon() -> None:
    pair = (((0.0, 0.0), (800.0, 100.0)), ((1600.0, 0.0), (800.0, 100.0)))
    assert matched(VanishingLines(pair, pair), SIZE, 40.0) is Mismatch.SAME_LINE


def test_lines_of_a_direction_without_a_point_have_no_azimuth() -> None:
    lines = first_lines(SIZE)
    ground = ground_plane((0.0, 0.0), 0.0, 60.0)
    assert azimuth_of(lines.first, Camera(1600, 900), ground) is None
    same = (lines.first[0], lines.first[0])
    assert azimuth_of(same, Camera(1600, 900, 40.0), ground) is None
    assert vanishing_point(same, SIZE) is None


def test_lines_without_perspective_are_laid_along_the_seen_direction() -> None:
    ground = ground_plane((0.0, 0.0), 0.0, 60.0)
    lines = laid(first_lines(SIZE), Camera(1600, 900), ground, 0.0)
    assert all(start[1] == pytest.approx(end[1]) for start, end in lines.first)
    assert all(start[0] == pytest.approx(end[0]) for start, end in lines.second)


def test_a_line_whose_middle_is_the_point_itself_stays() -> None:
    camera, ground = Camera(1600, 900, 40.0), ground_plane((800.0, 700.0), 0.0, 60.0)
    lines = laid(first_lines(SIZE), camera, ground, 40.0)
    point = vanishing_point(lines.first, SIZE)
    assert point is not None
    around: Line = ((point[0] - 10.0, point[1]), (point[0] + 10.0, point[1]))
    kept = laid(lines.with_line(0, around), camera, ground, 40.0)
    assert np.array(kept.first[0]) == pytest.approx(np.array(around), abs=20.0)
