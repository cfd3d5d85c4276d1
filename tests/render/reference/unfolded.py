"""The float64 reference of filters on a wall: ground and wall as one flat sheet of squares, blurred there."""

from dataclasses import dataclass
from math import ceil, floor

import numpy as np

from kagezou.geometry.ground import canvas_from_plane
from kagezou.geometry.sets.bodies import Solid
from kagezou.geometry.vectors import Matrix
from kagezou.scene.scene import ShadowCast
from tests.render.reference import raycast, set_raycast
from tests.render.reference.blurred import ContactLine, Squares, blurred, level_of
from tests.render.reference.raycast import Array, Art
from tests.render.reference.rims import span_around

SAMPLES_A_SIDE = 6


@dataclass(frozen=True)
class FoldedGround:
    """The ground up to the foot of a wall, and the wall turned down behind it.

    ``start`` and ``across`` are a point of the foot and the unit vector away from the character, flat; ``up`` is the
    wall's own upward direction in the world.
    """

    cast: ShadowCast
    line: ContactLine
    start: Array
    across: Array
    up: Array

    @staticmethod
    def of(cast: ShadowCast) -> "FoldedGround":
        (wall,) = cast.pieces[0].bodies
        assert isinstance(wall, Solid)
        corners = np.array(wall.facets[0].corners)
        line = ContactLine.of(cast)
        ends = _flat(cast, line, corners[:2])
        run = (ends[1] - ends[0]) / np.linalg.norm(ends[1] - ends[0])
        across = np.array([-run[1], run[0]])
        # The character stands at the contact line, before the middle of the wall.
        across *= np.sign(ends.mean(axis=0)[1] * across[1])
        up = corners[3] - corners[0]
        return FoldedGround(cast, line, ends[0], across, up / np.linalg.norm(up))

    def world(self, flat: Array) -> Array:
        """Return the world points (N, 3) of flat ones (N, 2)."""
        beyond = np.maximum((flat - self.start) @ self.across, 0.0)
        foot = flat - beyond[:, np.newaxis] * self.across
        u, v = self.line.to_ground(foot[:, 0], foot[:, 1])
        ground = np.stack([u, v, np.ones_like(u)], axis=-1) @ self.cast.receivers[0].world_from_plane()[:3].T
        return np.asarray(ground + beyond[:, np.newaxis] * self.up)

    def flat(self, points: Array, is_wall: Array) -> Array:
        """Return the flat places (N, 2) of world points (N, 3) on the ground or the wall."""
        foot = np.array(self.cast.pieces[0].bodies[0].facets[0].corners[0])  # type: ignore[union-attr]
        height = np.where(is_wall, (points - foot) @ self.up, 0.0)
        # The wall's foot is square to its upward direction.
        on_ground = points - height[:, np.newaxis] * self.up
        return _flat(self.cast, self.line, on_ground) + height[:, np.newaxis] * self.across

    def fallen(self, art: Art) -> Squares:
        """Return the whole shadow, one px a square, 4 rays each."""
        y, x = np.mgrid[-1400:1400:8, -1400:1400:8].reshape(2, -1).astype(np.float64)
        held = raycast.shade_of(self.cast, art, self.world(np.stack([x, y], axis=-1))) > 0
        low, high = (x[held].min() - 16, y[held].min() - 16), (x[held].max() + 16, y[held].max() + 16)
        columns, rows = (ceil(b) - floor(a) for a, b in zip(low, high, strict=True))
        y, x = np.mgrid[0:rows, 0:columns].reshape(2, -1)
        total = np.zeros(rows * columns)
        for dy in (1 / 4, 3 / 4):
            for dx in (1 / 4, 3 / 4):
                flat = np.stack([floor(low[0]) + x + dx, floor(low[1]) + y + dy], axis=-1)
                total += raycast.shade_of(self.cast, art, self.world(flat))
        return Squares(self.line, (floor(low[0]), floor(low[1])), 1.0, (total / 4).reshape(rows, columns))

    def coverage(self, field: Squares, level: float, box: tuple[int, int, int, int]) -> Array:
        """Return the covered part of each pixel of a canvas box where the field is over the level."""
        left, top, right, bottom = box
        y, x = np.mgrid[top:bottom, left:right].astype(np.float64)
        result = self._over(field, level, x.ravel() + 0.5, y.ravel() + 0.5).reshape(x.shape)
        near = span_around(result, 1) > 0
        part = np.zeros(int(near.sum()))
        for dx in (np.arange(SAMPLES_A_SIDE) + 0.5) / SAMPLES_A_SIDE:
            for dy in (np.arange(SAMPLES_A_SIDE) + 0.5) / SAMPLES_A_SIDE:
                part += self._over(field, level, x[near] + dx, y[near] + dy)
        result[near] = part / SAMPLES_A_SIDE**2
        return result

    def _over(self, field: Squares, level: float, x: Array, y: Array) -> Array:
        world = set_raycast.World(self.cast.camera, self.cast.receivers[0], self.cast.pieces)
        seen = world.look(x, y)
        place = self.flat(seen.point, seen.body == 0)
        u, v = self.line.to_ground(place[:, 0], place[:, 1])
        return (field.at(u, v) > level).astype(np.float64)


def _flat(cast: ShadowCast, line: ContactLine, points: Array) -> Array:
    ground = cast.receivers[0]
    u, v = ((points - np.array(ground.origin)) @ np.array([ground.u, ground.v]).T).T
    return np.stack(line.from_ground(u, v), axis=-1)


def simplified(shadow: Squares, amount_px: float, distance_px: float) -> tuple[Squares, float]:
    """Return the blurred shadow and its area-preserving level."""
    field = blurred(shadow, amount_px, distance_px)
    return field, level_of(field, shadow.area)


def px_areas(cast: ShadowCast, width: int, height: int) -> Array:
    """Return how many px² of the receiver a canvas pixel shows, (H, W)."""
    y, x = np.mgrid[0:height, 0:width].astype(np.float64) + 0.5
    world = set_raycast.World(cast.camera, cast.receivers[0], cast.pieces)
    seen = world.look(x.ravel(), y.ravel()).body.reshape(x.shape)
    result = _areas(canvas_from_plane(cast.camera, cast.receivers[0]), x, y)
    for index, body in enumerate(world.bodies):
        assert isinstance(body, Solid)
        for facet in body.facets:
            own = _areas(canvas_from_plane(cast.camera, facet.plane(is_turned=False)), x, y)
            result = np.where(seen == index, own, result)
    return result


def _areas(canvas_from_receiver: Matrix, x: Array, y: Array) -> Array:
    back = np.linalg.inv(canvas_from_receiver)
    w = back[2, 0] * x + back[2, 1] * y + back[2, 2]
    return np.asarray(abs(float(np.linalg.det(back))) / np.maximum(w, 1e-9) ** 3)
