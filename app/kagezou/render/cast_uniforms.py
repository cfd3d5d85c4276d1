"""The numbers of a cast as the shaders want them: float32, around an origin of their own so that they stay exact."""

from dataclasses import dataclass
from math import radians, sin

import numpy as np

from kagezou.geometry.ground import Plane
from kagezou.geometry.light import GRAZING_DARK_DEG, GRAZING_FULL_DEG, foot_of, grazing_strength
from kagezou.geometry.shadow import Cast
from kagezou.geometry.vectors import Matrix, Vector4, dot, height_over
from kagezou.render.mattes import PlacedMatte
from kagezou.render.program import Uniform
from kagezou.render.targets import LAST_LEVEL

MAX_CELLS = 32
"""A pixel is split into at most this many cells each way; a matte squeezed further is read from its mipmaps."""


@dataclass(frozen=True, slots=True, eq=False)
class Frame:
    """The convex part (N, 2) of the canvas a cast may touch, and the canvas px around which its numbers are given."""

    region: Matrix

    @property
    def origin(self) -> Matrix:
        """A pixel centre in the middle of the region, (2,)."""
        return np.asarray(np.floor(self.region.mean(axis=0)) + 0.5)

    @property
    def canvas_from_pixel(self) -> Matrix:
        """The (3, 3) shift from px around the origin to canvas px."""
        x, y = self.origin
        return np.array([[1.0, 0.0, x], [0.0, 1.0, y], [0.0, 0.0, 1.0]])


@dataclass(frozen=True, slots=True)
class Grazing:
    """How high a light stands over a receiver: for the sun everywhere, for a lamp seen from each point."""

    is_lamp: bool
    height: float
    foot_uv: tuple[float, float]

    @staticmethod
    def of(receiver: Plane, light: Vector4) -> "Grazing":
        """Return how a light stands over a receiver."""
        height = height_over(receiver.equation, light)
        if light[3] == 0:
            return Grazing(is_lamp=False, height=height, foot_uv=(0.0, 0.0))
        x, y, z = foot_of(receiver, light[:3])
        away = (x - receiver.origin[0], y - receiver.origin[1], z - receiver.origin[2])
        return Grazing(is_lamp=True, height=height, foot_uv=(dot(away, receiver.u), dot(away, receiver.v)))

    def uniforms(self, cast: Cast, frame: Frame) -> dict[str, Uniform]:
        """Return what ``grazing.glsl`` wants."""
        return {
            "u_fades": self.is_lamp and self._is_low_over(cast, frame.region),
            "u_strength": 1.0 if self.is_lamp else grazing_strength(self.height),
            "u_receiver_from_pixel": _balanced(cast.receiver_from_canvas @ frame.canvas_from_pixel),
            "u_lamp_on_receiver": (*self.foot_uv, self.height),
            "u_grazing_sine": (sin(radians(GRAZING_DARK_DEG)), sin(radians(GRAZING_FULL_DEG))),
        }

    def _is_low_over(self, cast: Cast, region: Matrix) -> bool:
        """Whether the lamp fades anywhere in a convex region: it does at a corner if it does at all."""
        u, v, w = cast.receiver_from_canvas @ np.column_stack([region, np.ones(len(region))]).T
        away = np.hypot(u / w - self.foot_uv[0], v / w - self.foot_uv[1])
        return bool((self.height < np.hypot(away, self.height) * sin(radians(GRAZING_FULL_DEG))).any())


def edge_uniforms(cast: Cast, matte: PlacedMatte, frame: Frame) -> dict[str, Uniform]:
    """Return what ``cast.frag`` wants, with the matte bound to unit 0."""
    canvas_from_pixel = frame.canvas_from_pixel
    texel_from_canvas = np.array([[1.0, 0.0, -matte.box.left], [0.0, 1.0, -matte.box.top], [0.0, 0.0, 1.0]])
    texel = _balanced(texel_from_canvas @ cast.art_from_canvas @ canvas_from_pixel)
    if _may_need_mipmaps(texel, frame.region - frame.origin):
        matte.texture.make_mipmaps()
    matte.texture.bind(0)
    return {
        "u_matte": 0,
        "u_texel_from_pixel": texel,
        "u_side": cast.side @ canvas_from_pixel,
        "u_left_fold": cast.left_fold @ canvas_from_pixel,
        "u_right_fold": cast.right_fold @ canvas_from_pixel,
        "u_max_cells": MAX_CELLS,
        "u_last_level": LAST_LEVEL,
    }


def _balanced(matrix: Matrix) -> Matrix:
    """Scale a homography so that w = ±1 at its origin, which keeps its float32 copy precise there."""
    return np.asarray(matrix / max(abs(float(matrix[2, 2])), 1e-12 * float(np.abs(matrix).max())))


def _may_need_mipmaps(texel_from_pixel: Matrix, corners: Matrix) -> bool:
    """Whether the drawing may be squeezed by more than MAX_CELLS texels a pixel somewhere in the region."""
    points = np.column_stack([corners, np.ones(len(corners))]) @ texel_from_pixel.T
    w = np.maximum(points[:, 2:], 1e-12)
    texels = points[:, :2] / w
    for axis in (0, 1):
        steps = (texel_from_pixel[:2, axis] - texels * texel_from_pixel[2, axis]) / w
        if float(np.hypot(steps[:, 0], steps[:, 1]).max()) > MAX_CELLS:
            return True
    return False
