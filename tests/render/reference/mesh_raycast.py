"""The float64 reference for meshes: every ray is met with every triangle in the world."""

from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import Plane
from kagezou.geometry.light import GRAZING_DARK_DEG, GRAZING_FULL_DEG
from kagezou.geometry.vectors import Vector4
from kagezou.scene.scene import ShadowCast
from tests.render.reference import raycast, set_raycast

Array: TypeAlias = NDArray[np.float64]

_CHUNK = 4000


def all_met(corners: Array, start: Array, along: Array, least: float) -> Array:
    """Return how far along rays (N, 3) each triangle is met, (N, M), ∞ where it is not or not beyond ``least``."""
    corner, first, second = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    beside = np.cross(along[:, np.newaxis], second[np.newaxis])
    turned = (beside * first).sum(-1)
    turned = np.where(np.abs(turned) < 1e-30, 1e-30, turned)
    away = start[:, np.newaxis] - corner[np.newaxis]
    beyond = np.cross(away, first[np.newaxis])
    a = (away * beside).sum(-1) / turned
    b = (beyond * along[:, np.newaxis]).sum(-1) / turned
    t = (beyond * second).sum(-1) / turned
    inside = (a >= 0) & (b >= 0) & (a + b <= 1) & (t > least)
    return np.where(inside, t, np.inf)


@dataclass(frozen=True)
class MeshWorld:
    """Meshes of one kind as the reference knows them: triangles (M, 3, 3) of the world, px, and the ground if any."""

    camera: Camera
    corners: Array
    ground: Plane | None

    @property
    def normals(self) -> Array:
        cross = np.cross(self.corners[:, 1] - self.corners[:, 0], self.corners[:, 2] - self.corners[:, 0])
        return np.asarray(cross / np.linalg.norm(cross, axis=1, keepdims=True))

    def look(self, x: Array, y: Array) -> set_raycast.Seen:
        """Return what is seen at canvas points (N,): a mesh as body 0, the ground, or nothing."""
        eye = np.array(self.camera.eye)
        picture = np.stack([x, y, np.zeros_like(x)], axis=-1)
        along = np.broadcast_to(-eye[:3], picture.shape) if eye[3] == 0 else picture - eye[:3]
        lengths, which = np.full(len(x), np.inf), np.full(len(x), -1)
        for first in range(0, len(x), _CHUNK):
            part = slice(first, first + _CHUNK)
            met = all_met(self.corners, picture[part], along[part], -np.inf if eye[3] == 0 else -0.99)
            which[part], lengths[part] = met.argmin(axis=1), met.min(axis=1)
        found = np.where(np.isfinite(lengths), 0, set_raycast.NOTHING)
        normal = self.normals[which]
        if self.ground is not None:
            floor = np.array(self.ground.equation)
            with np.errstate(divide="ignore", invalid="ignore"):
                below = -(picture @ floor[:3] + floor[3]) / (along @ floor[:3])
            below = np.where(np.isfinite(below) & ((below > -1) | (eye[3] == 0)), below, np.inf)
            nearer = below < lengths
            lengths, found = np.where(nearer, below, lengths), np.where(nearer, set_raycast.GROUND, found)
            normal = np.where(nearer[:, np.newaxis], floor[:3], normal)
        point = picture + np.where(np.isfinite(lengths), lengths, 0.0)[:, np.newaxis] * along
        normal = normal * np.where((normal * along).sum(1) > 0, -1.0, 1.0)[:, np.newaxis]
        return set_raycast.Seen(point, normal, found)

    def is_kept_dark(self, seen: set_raycast.Seen, light: Vector4) -> NDArray[np.bool_]:
        """Whether a triangle stands between seen points and the light."""
        lamp = np.array(light)
        toward = np.broadcast_to(lamp[:3], seen.point.shape) if lamp[3] == 0 else lamp[:3] - seen.point
        dark = np.zeros(len(seen.point), bool)
        for first in range(0, len(dark), _CHUNK):
            part = slice(first, first + _CHUNK)
            least = 1e-4 / np.linalg.norm(toward[part], axis=1, keepdims=True)
            met = all_met(self.corners, seen.point[part], toward[part], -np.inf)
            dark[part] = ((met > least) & (np.isfinite(met) if lamp[3] == 0 else met < 1)).any(axis=1)
        return dark

    def strength(self, seen: set_raycast.Seen, light: Vector4) -> Array:
        """How much a light counts by its height over the surface."""
        lamp = np.array(light)
        toward = np.broadcast_to(lamp[:3], seen.point.shape) if lamp[3] == 0 else lamp[:3] - seen.point
        sine = (toward * seen.normal).sum(1) / np.linalg.norm(toward, axis=1)
        low, high = np.sin(np.radians([GRAZING_DARK_DEG, GRAZING_FULL_DEG]))
        t = np.clip((sine - low) / (high - low), 0, 1)
        return np.asarray(t * t * (3 - 2 * t))


def shade(cast: ShadowCast, world: MeshWorld, art: raycast.Art, x: Array, y: Array, *, blocks: bool = True) -> Array:
    """Return how much of a character's shadow each canvas point (N,) shows, 0 to 1."""
    seen = world.look(x, y)
    total = np.zeros(len(x))
    for light in cast.lights:
        amount = raycast.shade_from(cast, art, light, seen.point) * world.strength(seen, light)
        if blocks:
            some = amount > 0
            part = set_raycast.Seen(seen.point[some], seen.normal[some], seen.body[some])
            amount[some] *= ~world.is_kept_dark(part, light)
        total = np.maximum(total, amount)
    return np.where(seen.body == set_raycast.NOTHING, 0.0, total)


def own_shade(world: MeshWorld, lights: tuple[Vector4, ...], x: Array, y: Array) -> Array:
    """Return how much of the meshes' own shadow each canvas point (N,) shows, 0 to 1."""
    seen = world.look(x, y)
    total = np.zeros(len(x))
    for light in lights:
        dark = world.is_kept_dark(seen, light)
        strength = world.strength(seen, light)
        amount = np.where(seen.body == 0, np.where(dark, 1.0, 1.0 - strength), np.where(dark, strength, 0.0))
        total = np.maximum(total, amount)
    return np.where(seen.body == set_raycast.NOTHING, 0.0, total)
