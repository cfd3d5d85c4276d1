"""Lights: a lamp or the sun, and the four virtual lamps of an overhead light (spec 1, 2; paper 3.7)."""

from math import asin, atan2, cos, degrees, hypot, radians, sin, sqrt

from kagezou.geometry.ground import Plane
from kagezou.geometry.vectors import Vector3, Vector4, dot, height_over

GRAZING_DARK_DEG = 1.0
"""A light that stands this low over the receiver, or lower, casts nothing."""

GRAZING_FULL_DEG = 3.0
"""From this height over the receiver on, a shadow has its full strength; between the two it fades."""

_STRAIGHT_ABOVE = 1e-12


def lamp(position: Vector3) -> Vector4:
    """Return the homogeneous point light at a world position, px."""
    return (*position, 1.0)


def sun(ground: Plane, azimuth_deg: float, elevation_deg: float) -> Vector4:
    """Return the direction toward the sun, unit length, w = 0.

    Azimuth 0 stands on the viewer's side, so that shadows fall away from the viewer.
    """
    azimuth, elevation = radians(azimuth_deg), radians(elevation_deg)
    along_u = cos(elevation) * sin(azimuth)
    along_v = cos(elevation) * cos(azimuth)
    up = sin(elevation)
    x, y, z = (along_u * u + along_v * v + up * n for u, v, n in zip(ground.u, ground.v, ground.normal, strict=True))
    return (x, y, z, 0.0)


def sun_angles(ground: Plane, direction: Vector3) -> tuple[float | None, float]:
    """Return azimuth and elevation, degrees, of a sun in a direction of any length but 0; the way back of :func:`sun`.

    The azimuth is None straight above, where every one is the same.
    """
    length = sqrt(dot(direction, direction))
    right, nearer, up = (dot(direction, axis) / length for axis in (ground.u, ground.v, ground.normal))
    azimuth = None if abs(right) + abs(nearer) < _STRAIGHT_ABOVE else degrees(atan2(right, nearer))
    return azimuth, degrees(asin(min(max(up, -1.0), 1.0)))


def is_over(ground: Plane, light: Vector4) -> bool:
    """Whether the light stands on the lit side of the ground; one below it casts nothing."""
    return height_over(ground.equation, light) > 0


def foot_of(ground: Plane, position: Vector3) -> Vector3:
    """Return the point of the ground straight under a lamp, world px."""
    height = height_over(ground.equation, lamp(position))
    x, y, z = (p - height * n for p, n in zip(position, ground.normal, strict=True))
    return (x, y, z)


def virtual_lights(light: Vector4, contact: Vector3, overhead_radius_px: float) -> tuple[Vector4, ...]:
    """Return the lights that stand for ``light``: itself, or four around it while it is overhead.

    L + max(Rv − r, 0)·(±1, ±1)/√2 in (x, z), where r is the horizontal distance from the contact; at r ≥ Rv all
    four are the light itself, which is then returned once (paper 3.7, spec 2).
    """
    x, y, z, w = light
    reach = overhead_radius_px - horizontal_distance(light, contact)
    if w == 0 or reach <= 0:
        return (light,)
    step = reach / sqrt(2)
    return tuple((x + sx * step, y, z + sz * step, w) for sx in (-1, 1) for sz in (-1, 1))


def overhead_share(light: Vector4, contact: Vector3, overhead_radius_px: float) -> float:
    """Return how far a light is overhead: 1 straight above the contact, 0 for the sun and from the radius on."""
    if light[3] == 0 or overhead_radius_px <= 0:
        return 0.0
    return max(1.0 - horizontal_distance(light, contact) / overhead_radius_px, 0.0)


def horizontal_distance(light: Vector4, contact: Vector3) -> float:
    """Return how far a lamp is from straight above the contact, in (x, z), world px."""
    return hypot(light[0] - contact[0], light[2] - contact[2])


def joined(amount_px: float, distance_px: float, at_least_px: float, share: float) -> tuple[float, float]:
    """Return amount and distance of a simplification that joins the four shadows of an overhead light.

    The amount rises to ``at_least_px`` with the share, and the distance falls to 0, as far as that amount asks for it:
    at the feet the four part most. Continuous in all; with a share of 0, or nothing asked for, both are as before.

    Parameters
    ----------
    amount_px, distance_px
        As they are set.
    at_least_px
        The amount straight overhead.
    share
        How far the light is overhead, 0 to 1.
    """
    if share <= 0 or at_least_px <= 0:
        return amount_px, distance_px
    asked = min(at_least_px / max(amount_px, at_least_px), 1.0)
    return max(amount_px + share * (at_least_px - amount_px), amount_px), distance_px * (1.0 - share * asked)


def grazing_strength(sine_of_height: float) -> float:
    """Return how much of a shadow a light gives that stands at this sine of its angle over the receiver, 0 to 1.

    Low light stretches a shadow without bound; fading it between two low angles ends the shadow where it would
    otherwise cross the picture as a smear, and without a pop.
    """
    low, high = sin(radians(GRAZING_DARK_DEG)), sin(radians(GRAZING_FULL_DEG))
    t = min(max((sine_of_height - low) / (high - low), 0.0), 1.0)
    return t * t * (3 - 2 * t)
