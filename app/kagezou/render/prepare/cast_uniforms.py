"""The numbers of a cast as the shaders want them: float32, around an origin of their own so that they stay exact."""

from dataclasses import dataclass
from functools import cached_property
from math import radians, sin

import numpy as np

from kagezou.geometry.card import CardPiece
from kagezou.geometry.ground import Plane
from kagezou.geometry.light import GRAZING_DARK_DEG, GRAZING_FULL_DEG, foot_of, grazing_strength
from kagezou.geometry.polygon import distance_forms
from kagezou.geometry.shadow import Cast, SpaceCast
from kagezou.geometry.vectors import Matrix, Point2, Vector4, dot, height_over
from kagezou.render.prepare.matte_on_canvas import MatteOnCanvas
from kagezou.render.prepare.piece_tiles import limits_of
from kagezou.render.prepare.uniforms import LAST_LEVEL, Uniform

NO_SWITCHES: frozenset[str] = frozenset()
LAMP_IS_LOW = frozenset({"LAMP_IS_LOW"})
TRANSLUCENT = frozenset({"TRANSLUCENT"})


@dataclass(frozen=True, eq=False)
class Frame:
    """The convex part (N, 2) of the canvas a cast may touch, and the canvas px around which its numbers are given."""

    region: Matrix

    @cached_property
    def origin(self) -> Matrix:
        """A pixel centre in the middle of the region, (2,)."""
        return np.asarray(np.floor(self.region.mean(axis=0)) + 0.5)

    @cached_property
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

    def switches(self, receiver_from_canvas: Matrix, frame: Frame) -> frozenset[str]:
        """Return the switches of ``common/grazing.glsl``."""
        return LAMP_IS_LOW if self.is_lamp and self._is_low_over(receiver_from_canvas, frame.region) else NO_SWITCHES

    def uniforms(self, receiver_from_canvas: Matrix, frame: Frame) -> dict[str, Uniform]:
        """Return what ``common/grazing.glsl`` wants."""
        return {
            "u_strength": 1.0 if self.is_lamp else grazing_strength(self.height),
            "u_receiver_from_pixel": _balanced(receiver_from_canvas @ frame.canvas_from_pixel),
            "u_lamp_on_receiver": (*self.foot_uv, self.height),
            "u_grazing_sine": (sin(radians(GRAZING_DARK_DEG)), sin(radians(GRAZING_FULL_DEG))),
        }

    def _is_low_over(self, receiver_from_canvas: Matrix, region: Matrix) -> bool:
        """Whether the lamp fades anywhere in a convex region: it does at a corner if it does at all."""
        u, v, w = receiver_from_canvas @ np.column_stack([region, np.ones(len(region))]).T
        away = np.hypot(u / w - self.foot_uv[0], v / w - self.foot_uv[1])
        return bool((self.height < np.hypot(away, self.height) * sin(radians(GRAZING_FULL_DEG))).any())


FULL_STRENGTH = Grazing(is_lamp=False, height=1.0, foot_uv=(0.0, 0.0))
"""A light that stands high enough everywhere."""


@dataclass(frozen=True, slots=True, eq=False)
class Edges:
    """What ``passes/cast.frag`` wants to know of a cast and a matte."""

    cast: Cast
    matte: MatteOnCanvas
    frame: Frame

    @property
    def _texel_from_pixel(self) -> Matrix:
        box = self.matte.box
        texel_from_canvas = np.array([[1.0, 0.0, -box.left], [0.0, 1.0, -box.top], [0.0, 0.0, 1.0]])
        return _balanced(texel_from_canvas @ self.cast.art_from_canvas @ self.frame.canvas_from_pixel)

    def uniforms(self) -> dict[str, Uniform]:
        """Return the uniforms that every variant has, for a matte on unit 0."""
        return {
            "u_matte": 0,
            "u_means": 1,
            "u_texel_from_pixel": self._texel_from_pixel,
            "u_last_level": LAST_LEVEL,
        }

    def limits(self) -> dict[str, Uniform]:
        """Return the uniforms of the variants at a limit."""
        canvas_from_pixel = self.frame.canvas_from_pixel
        found: dict[str, Uniform] = {
            "u_side": self.cast.side @ canvas_from_pixel,
            "u_horizon": self.cast.horizon @ canvas_from_pixel,
        }
        if len(self.cast.limits):
            found["u_limits"] = np.pad([form @ canvas_from_pixel for form in self.cast.limits], ((0, 0), (0, 1)))
        return found

    def limit_switches(self) -> frozenset[str]:
        """Return the switches of the variants at a limit."""
        return frozenset({f"LIMITS {len(self.cast.limits)}"})


@dataclass(frozen=True, slots=True, eq=False)
class JoinedEdges:
    """What ``passes/cast.frag`` wants to know of several casts on one receiver, and a matte."""

    casts: tuple[Cast, ...]
    matte: MatteOnCanvas
    frame: Frame

    def uniforms(self) -> dict[str, Uniform]:
        """Return the uniforms that every variant has, for a matte on unit 0."""
        texel_from_canvas = np.array(
            [[1.0, 0.0, -self.matte.box.left], [0.0, 1.0, -self.matte.box.top], [0.0, 0.0, 1.0]]
        )
        homographies = np.array([cast.art_from_canvas for cast in self.casts])
        texels = texel_from_canvas @ homographies @ self.frame.canvas_from_pixel
        least = 1e-12 * np.abs(texels).max(axis=(1, 2))
        balanced = texels / np.maximum(np.abs(texels[:, 2, 2]), least)[:, np.newaxis, np.newaxis]
        return {
            "u_matte": 0,
            "u_means": 1,
            "u_texels_from_pixel": balanced.astype(np.float32),
            "u_last_level": LAST_LEVEL,
        }

    def limits(self) -> dict[str, Uniform]:
        """Return the uniforms of the variants at a limit."""
        canvas_from_pixel = self.frame.canvas_from_pixel
        forms = limits_of(self.casts).reshape(-1, 3) @ canvas_from_pixel
        return {
            "u_all_limits": np.pad(forms, ((0, 0), (0, 1))).astype(np.float32),
            "u_horizon": self.casts[0].horizon @ canvas_from_pixel,
        }


def piece_limits(piece: CardPiece, corner: Point2 = (0.0, 0.0)) -> tuple[frozenset[str], dict[str, Uniform]]:
    """Return the switches and uniforms of a shader that asks what of a drawing lies on a card piece.

    ``corner`` is the canvas px at which the target begins.
    """
    forms = [(a, b, a * corner[0] + b * corner[1] + c) for a, b, c in piece.limits]
    uniforms: dict[str, Uniform] = {}
    if forms:
        uniforms["u_limits"] = np.pad(distance_forms(np.array(forms)), ((0, 0), (0, 1)))
    return frozenset({f"LIMITS {len(forms)}"}), uniforms


def card_uniforms(cast: SpaceCast, matte: MatteOnCanvas, world_from_local: Matrix) -> dict[str, Uniform]:
    """Return what ``common/card_in_space.glsl`` wants of a card piece, for a matte on unit 0 and a (4, 4) shift."""
    corner = np.array([[1.0, 0.0, -matte.box.left], [0.0, 1.0, -matte.box.top], [0.0, 0.0, 1.0]])
    rows = corner @ cast.art_from_world @ world_from_local
    limits = [form @ world_from_local for form in cast.forms]
    return {"u_matte": 0, "u_texel_rows": rows / np.abs(rows[2]).max(), "u_limits": np.array(limits)}


def card_switches(cast: SpaceCast, *, translucent: bool) -> frozenset[str]:
    """Return the switches of ``common/card_in_space.glsl``."""
    return frozenset({f"LIMITS {len(cast.forms)}"}) | (TRANSLUCENT if translucent else NO_SWITCHES)


def _balanced(matrix: Matrix) -> Matrix:
    """Scale a homography so that w = ±1 at its origin, which keeps its float32 copy precise there."""
    largest = float(np.abs(matrix).max())
    return np.asarray(matrix / max(abs(float(matrix[2, 2])), 1e-12 * largest))
