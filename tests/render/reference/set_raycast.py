"""The float64 reference for sets: every ray is met with every body in the world, no cone, conic or homography used."""

from collections.abc import Callable
from dataclasses import dataclass
from math import radians, sin

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import Plane
from kagezou.geometry.light import GRAZING_DARK_DEG, GRAZING_FULL_DEG
from kagezou.geometry.sets.bodies import Ball, Body, Drum, Solid
from kagezou.geometry.vectors import Vector4
from kagezou.scene.pieces import PieceScene
from kagezou.scene.scene import ShadowCast
from tests.render.reference import raycast
from tests.render.reference.rims import span_around

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

NEAR_PX = 1e-5
"""A ray leaves the body it starts on within this."""

NOTHING, GROUND = -2, -1


def interval(body: Body, start: Array, along: Array) -> tuple[Array, Array]:
    """Return where rays (N, 3) enter and leave a body, in lengths of ``along``; enter > leave where they miss."""
    low, high = np.full(len(start), -np.inf), np.full(len(start), np.inf)
    if isinstance(body, Solid) and body.is_sheet:
        return _sheet_interval(body, start, along)
    if isinstance(body, Solid):
        for facet in body.facets:
            low, high = _cut(np.array(facet.equation), start, along, low, high)
        return low, high
    if isinstance(body, Ball):
        return _roots(start - np.array(body.centre), along, body.radius_px)
    axis = np.array(body.axis)
    away = start - np.array(body.foot)
    across, beside = away - np.outer(away @ axis, axis), along - np.outer(along @ axis, axis)
    low, high = _roots(across, beside, body.radius_px)
    for end in body.ends:
        low, high = _cut(np.array(end), start, along, low, high)
    return low, high


def _sheet_interval(body: Solid, start: Array, along: Array) -> tuple[Array, Array]:
    facet = body.facets[0]
    plane = np.array(facet.equation)
    with np.errstate(divide="ignore", invalid="ignore"):
        t = -(start @ plane[:3] + plane[3]) / (along @ plane[:3])
    hit = np.isfinite(t)
    t = np.where(hit, t, 0.0)
    point = start + t[:, np.newaxis] * along
    middle = np.mean(facet.corners, axis=0)
    for first, second in zip(facet.corners, (*facet.corners[1:], facet.corners[0]), strict=True):
        inward = np.cross(plane[:3], np.array(second) - np.array(first))
        inward *= np.sign(inward @ (middle - np.array(first)))
        hit &= (point - np.array(first)) @ inward >= 0
    return np.where(hit, t, np.inf), np.where(hit, t, -np.inf)


def _cut(plane: Array, start: Array, along: Array, low: Array, high: Array) -> tuple[Array, Array]:
    """Cut intervals to the side of a plane where it is <= 0."""
    value, rate = start @ plane[:3] + plane[3], along @ plane[:3]
    with np.errstate(divide="ignore", invalid="ignore"):
        t = -value / rate
    low = np.where(rate < 0, np.maximum(low, t), low)
    high = np.where(rate > 0, np.minimum(high, t), high)
    outside = (rate == 0) & (value > 0)
    return np.where(outside, np.inf, low), np.where(outside, -np.inf, high)


def _roots(away: Array, along: Array, radius: float) -> tuple[Array, Array]:
    a, b, c = (along * along).sum(1), (away * along).sum(1), (away * away).sum(1) - radius**2
    parted = b * b - a * c
    root = np.sqrt(np.maximum(parted, 0.0))
    with np.errstate(divide="ignore", invalid="ignore"):
        low, high = (-b - root) / a, (-b + root) / a
    return np.where(parted > 0, low, np.inf), np.where(parted > 0, high, -np.inf)


@dataclass(frozen=True)
class Seen:
    """What rays from the eye meet: points (N, 3), normals toward the eye (N, 3) and the number of the body."""

    point: Array
    normal: Array
    body: NDArray[np.int64]


def look(camera: Camera, ground: Plane, bodies: tuple[Body, ...], x: Array, y: Array) -> Seen:
    """Return what is seen at canvas points (N,)."""
    eye = np.array(camera.eye)
    picture = np.stack([x, y, np.zeros_like(x)], axis=-1)
    along = np.broadcast_to(-eye[:3], picture.shape) if eye[3] == 0 else picture - eye[:3]
    floor = np.array(ground.equation)
    with np.errstate(divide="ignore", invalid="ignore"):
        nearest = -(picture @ floor[:3] + floor[3]) / (along @ floor[:3])
    nearest = np.where(np.isfinite(nearest) & ((nearest > -1) | (eye[3] == 0)), nearest, np.inf)
    found = np.where(np.isfinite(nearest), GROUND, NOTHING)
    for index, body in enumerate(bodies):
        enter, leave = interval(body, picture, along)
        hit = (enter <= leave) & (enter < nearest) & ((enter > -1) | (eye[3] == 0))
        nearest, found = np.where(hit, enter, nearest), np.where(hit, index, found)
    point = picture + np.where(np.isfinite(nearest), nearest, 0.0)[:, np.newaxis] * along
    normal = np.broadcast_to(floor[:3], point.shape).copy()
    for index, body in enumerate(bodies):
        normal[found == index] = _normals(body, point[found == index])
    normal *= np.where((normal * along).sum(1) > 0, -1.0, 1.0)[:, np.newaxis]
    return Seen(point, normal, found)


def _normals(body: Body, point: Array) -> Array:
    if isinstance(body, Ball):
        return np.asarray((point - np.array(body.centre)) / body.radius_px)
    if isinstance(body, Drum):
        axis = np.array(body.axis)
        away = point - np.array(body.foot)
        height = away @ axis
        side = (away - np.outer(height, axis)) / body.radius_px
        on_end = (height > body.height_px - NEAR_PX) | (height < NEAR_PX)
        return np.where(on_end[:, np.newaxis], axis, side)
    planes = np.array([facet.equation for facet in body.facets])
    values = np.abs(point @ planes[:, :3].T + planes[:, 3])
    return np.asarray(planes[values.argmin(axis=1), :3])


@dataclass(frozen=True)
class World:
    """A set as the reference knows it."""

    camera: Camera
    ground: Plane
    pieces: tuple[PieceScene, ...]

    @property
    def bodies(self) -> tuple[Body, ...]:
        return tuple(body for piece in self.pieces for body in piece.bodies)

    @property
    def owners(self) -> tuple[PieceScene, ...]:
        return tuple(piece for piece in self.pieces for _ in piece.bodies)

    def look(self, x: Array, y: Array) -> Seen:
        return look(self.camera, self.ground, self.bodies, x, y)

    def is_kept_dark(self, seen: Seen, light: Vector4, blockers: Callable[[PieceScene], bool]) -> Flags:
        """Whether a body stands between seen points and the light."""
        lamp = np.array(light)
        toward = _toward(lamp, seen.point)
        least = NEAR_PX / np.linalg.norm(toward, axis=1)
        dark = np.zeros(len(seen.point), bool)
        for index, (body, owner) in enumerate(zip(self.bodies, self.owners, strict=True)):
            if not blockers(owner):
                continue
            enter, leave = interval(body, seen.point, toward)
            between = (enter <= leave) & (leave > least) & ((enter < 1) | (lamp[3] == 0))
            dark |= between & (seen.body != index)
        return dark

    def strength(self, seen: Seen, light: Vector4) -> Array:
        """How much a light counts by its height over the surface."""
        toward = _toward(np.array(light), seen.point)
        sine = (toward * seen.normal).sum(1) / np.linalg.norm(toward, axis=1)
        low, high = sin(radians(GRAZING_DARK_DEG)), sin(radians(GRAZING_FULL_DEG))
        t = np.clip((sine - low) / (high - low), 0, 1)
        return np.asarray(t * t * (3 - 2 * t))


def _toward(lamp: Array, point: Array) -> Array:
    return np.asarray(np.broadcast_to(lamp[:3], point.shape) if lamp[3] == 0 else lamp[:3] - point)


def shade(cast: ShadowCast, art: raycast.Art, x: Array, y: Array) -> Array:
    """Return how much of a character's shadow each canvas point (N,) shows, 0 to 1."""
    world = World(cast.camera, cast.receivers[0], cast.pieces)
    seen = world.look(x, y)
    receives = np.array([piece.receives for piece in world.owners] + [False, True])
    total = np.zeros(len(x))
    for light in cast.lights:
        amount = raycast.shade_from(cast, art, light, seen.point) * world.strength(seen, light)
        amount[world.is_kept_dark(seen, light, lambda piece: piece.blocks)] = 0.0
        total = np.maximum(total, amount)
    # The last two stand for -2, nothing, and -1, the ground.
    return np.where(receives[seen.body], total, 0.0)


def own_shade(world: World, lights: tuple[Vector4, ...], x: Array, y: Array) -> Array:
    """Return how much of the set's own shadow each canvas point (N,) shows, 0 to 1."""
    seen = world.look(x, y)
    casts = np.array([piece.casts for piece in world.owners] + [False, False])[seen.body]
    total = np.zeros(len(x))
    for light in lights:
        dark = world.is_kept_dark(seen, light, lambda piece: piece.casts)
        strength = world.strength(seen, light)
        amount = np.where(casts, np.where(dark, 1.0, 1.0 - strength), np.where(dark, strength, 0.0))
        total = np.maximum(total, amount)
    return np.where(seen.body == NOTHING, 0.0, total)


def coverage(
    shading: Callable[[Array, Array], Array], hint: Array, rays: int = 160, before: Array | None = None
) -> Array:
    """Return the covered part of every pixel, of the shape of ``hint`` (H, W), which is what is to be judged.

    One ray a pixel where the hint holds any, and one in every few beyond, find where there is shadow; pixels near an
    edge, and those where the hint says otherwise, get ``rays`` each. Of a reference of fewer rays, ``before``, only
    what is in doubt is cast anew.
    """
    if before is not None:
        return raycast.refined(shading, hint, rays, before)
    height, width = hint.shape
    rows, columns = np.nonzero(hint.any(axis=1))[0], np.nonzero(hint.any(axis=0))[0]
    top, bottom = max(rows[0] - 8, 0), min(rows[-1] + 9, height)
    left, right = max(columns[0] - 8, 0), min(columns[-1] + 9, width)
    y, x = np.mgrid[3:height:7, 3:width:7] + 0.5
    beyond = (y < top) | (y > bottom) | (x < left) | (x > right)
    assert not shading(x[beyond], y[beyond]).any(), "there is shadow far from where it was drawn"
    y, x = np.mgrid[top:bottom, left:right].astype(np.float64)
    coarse = shading(x.ravel() + 0.5, y.ravel() + 0.5).reshape(x.shape)
    fine = (span_around(coarse, 1) > 1e-6) | (np.abs(coarse - hint[top:bottom, left:right]) > 1e-3)
    px, py = x[fine], y[fine]
    coarse[fine] = sum(shading(px + dx, py + dy) for dx, dy in raycast.spread(rays)) / rays
    result = np.zeros_like(hint)
    result[top:bottom, left:right] = coarse
    return result
