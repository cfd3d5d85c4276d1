"""Lights: the sun's directions, a lamp's foot, and the four lamps of an overhead light without a pop."""

from math import hypot, radians, sin

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.ground import ground_plane
from kagezou.geometry.light import (
    foot_of,
    grazing_strength,
    is_over,
    joined,
    lamp,
    overhead_share,
    sun,
    sun_angles,
    virtual_lights,
)
from kagezou.geometry.vectors import Vector3, dot, height_over

GROUND = ground_plane((500.0, 800.0), 20.0, 60.0)
CONTACT: Vector3 = (500.0, 800.0, 0.0)


def test_the_sun_stands_over_the_ground_by_its_elevation() -> None:
    for azimuth, along in ((0.0, GROUND.v), (90.0, GROUND.u)):
        x, y, z, w = sun(GROUND, azimuth, 30.0)
        assert w == 0.0
        assert dot((x, y, z), GROUND.normal) == pytest.approx(0.5)
        assert dot((x, y, z), along) == pytest.approx(3**0.5 / 2)
        assert dot((x, y, z), (x, y, z)) == pytest.approx(1.0)


@given(st.floats(-179.0, 179.0), st.floats(-89.0, 89.0), st.floats(0.01, 1000.0))
def test_the_angles_of_a_sun_are_found_again(azimuth: float, elevation: float, length: float) -> None:
    x, y, z, _ = sun(GROUND, azimuth, elevation)
    found, up = sun_angles(GROUND, (length * x, length * y, length * z))
    assert found == pytest.approx(azimuth, abs=1e-6)
    assert up == pytest.approx(elevation, abs=1e-6)


def test_straight_above_every_azimuth_is_the_same() -> None:
    azimuth, elevation = sun_angles(GROUND, GROUND.normal)
    assert azimuth is None
    assert elevation == pytest.approx(90.0)


def test_over_and_under_the_ground() -> None:
    assert is_over(GROUND, sun(GROUND, 10.0, 1.0))
    assert not is_over(GROUND, sun(GROUND, 10.0, -1.0))
    assert is_over(GROUND, lamp((500.0, 0.0, 0.0)))
    assert not is_over(GROUND, lamp((500.0, 900.0, 0.0)))


def test_the_foot_lies_straight_under_the_lamp() -> None:
    position: Vector3 = (300.0, 100.0, 400.0)
    foot = foot_of(GROUND, position)
    assert height_over(GROUND.equation, (*foot, 1.0)) == pytest.approx(0.0, abs=1e-9)
    rise = (position[0] - foot[0], position[1] - foot[1], position[2] - foot[2])
    assert dot(rise, GROUND.u) == pytest.approx(0.0, abs=1e-9)
    assert dot(rise, GROUND.v) == pytest.approx(0.0, abs=1e-9)


def test_a_lamp_overhead_is_spread_along_the_diagonals() -> None:
    light = lamp((500.0, 100.0, 0.0))
    spread = virtual_lights(light, CONTACT, 100.0)
    step = 100 / 2**0.5
    assert {(x > 500.0, z > 0.0) for x, _, z, _ in spread} == {(a, b) for a in (True, False) for b in (True, False)}
    for x, y, z, w in spread:
        assert hypot(x - 500.0, z) == pytest.approx(100.0)
        assert abs(x - 500.0) == pytest.approx(step)
        assert (y, w) == (100.0, 1.0)


def test_sun_and_far_lamps_stay_one() -> None:
    light = sun(GROUND, 0.0, 90.0)
    assert virtual_lights(light, CONTACT, 100.0) == (light,)
    far = lamp((620.0, 100.0, 0.0))
    assert virtual_lights(far, CONTACT, 100.0) == (far,)
    assert virtual_lights(lamp(CONTACT), CONTACT, 0.0) == (lamp(CONTACT),)


@given(st.floats(-200, 200), st.floats(-200, 200), st.floats(-1, 1), st.floats(-1, 1), st.floats(0, 150))
def test_virtual_lights_move_no_further_than_the_lamp_allows(
    dx: float, dz: float, mx: float, mz: float, radius: float
) -> None:
    one = virtual_lights(lamp((500 + dx, 100.0, dz)), CONTACT, radius)
    other = virtual_lights(lamp((500 + dx + mx, 100.0, dz + mz)), CONTACT, radius)
    moved = hypot(mx, mz)
    for a, b in zip(one if len(one) == 4 else one * 4, other if len(other) == 4 else other * 4, strict=True):
        assert hypot(a[0] - b[0], a[2] - b[2]) <= 2 * moved + 1e-9


def test_a_lamp_is_overhead_by_the_part_of_the_radius_it_is_within() -> None:
    assert overhead_share(lamp((500.0, 100.0, 0.0)), CONTACT, 100.0) == 1.0
    assert overhead_share(lamp((530.0, 100.0, 40.0)), CONTACT, 100.0) == pytest.approx(0.5)
    assert overhead_share(lamp((600.0, 100.0, 0.0)), CONTACT, 100.0) == 0.0
    assert overhead_share(lamp((900.0, 100.0, 0.0)), CONTACT, 100.0) == 0.0
    assert overhead_share(lamp((500.0, 100.0, 0.0)), CONTACT, 0.0) == 0.0
    assert overhead_share(sun(GROUND, 0.0, 90.0), CONTACT, 100.0) == 0.0


def test_straight_overhead_the_four_shadows_are_joined_everywhere() -> None:
    assert joined(0.0, 250.0, 150.0, 1.0) == (150.0, 0.0)
    assert joined(20.0, 250.0, 150.0, 1.0) == (150.0, 0.0)
    assert joined(200.0, 250.0, 150.0, 1.0) == (200.0, 62.5)


def test_without_an_overhead_light_or_an_amount_nothing_is_joined() -> None:
    assert joined(20.0, 250.0, 150.0, 0.0) == (20.0, 250.0)
    assert joined(20.0, 250.0, 0.0, 1.0) == (20.0, 250.0)


@given(st.floats(1, 300), st.floats(1, 300), st.floats(0, 1), st.floats(0, 0.01), st.floats(0, 0.1))
def test_joining_comes_without_a_pop(amount: float, at_least: float, share: float, more: float, px: float) -> None:
    one = joined(amount, 200.0, at_least, share)
    other = joined(amount + px, 200.0, at_least, min(share + more, 1.0))
    assert one[0] == pytest.approx(other[0], abs=px + 300.0 * more + 1e-9)
    assert one[1] == pytest.approx(other[1], abs=200.0 * more + 200.0 * px / amount + 1e-9)
    assert one[0] >= amount


def test_grazing_light_fades_to_nothing() -> None:
    assert grazing_strength(0.0) == 0.0
    assert grazing_strength(-1.0) == 0.0
    assert grazing_strength(sin(radians(1.0))) == 0.0
    assert grazing_strength(sin(radians(3.0))) == 1.0
    assert grazing_strength(1.0) == 1.0
    middle = (sin(radians(1.0)) + sin(radians(3.0))) / 2
    assert grazing_strength(middle) == pytest.approx(0.5)


@given(st.floats(-1, 1), st.floats(0, 0.1))
def test_grazing_strength_never_falls(sine: float, more: float) -> None:
    assert grazing_strength(sine) <= grazing_strength(sine + more)
