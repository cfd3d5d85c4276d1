"""The pass that casts: a drawing's alpha through the light onto the receivers, as covered parts of canvas pixels."""

from itertools import product
from math import radians, sin

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.ground import Plane
from kagezou.geometry.light import GRAZING_DARK_DEG, GRAZING_FULL_DEG, foot_of, grazing_strength
from kagezou.geometry.polygon import bounding_box
from kagezou.geometry.shadow import Cast, cast_on
from kagezou.geometry.vectors import Matrix, Vector4, dot, height_over
from kagezou.render.gl import GL
from kagezou.render.mattes import PlacedMatte
from kagezou.render.polygons import Polygons
from kagezou.render.program import Program, Uniform
from kagezou.render.targets import Target
from kagezou.scene.scene import ShadowCast

MAX_CELLS = 8
"""A pixel is split into at most this many cells each way; a matte squeezed further is read from its mipmaps."""


_NOWHERE: Matrix = np.empty((0, 2))


class CastPass:
    """Draws the shadows of all pieces, lights and receivers of a cast, united by maximum."""

    def __init__(self, polygons: Polygons) -> None:
        self._polygons = polygons
        self._program = Program("polygon.vert", "cast.frag")

    def draw(self, cast: ShadowCast, matte: PlacedMatte | None, target: Target, old: Box | None) -> Box | None:
        """Draw into ``target``, clearing ``old``; return the box that may hold shadow, None for none."""
        if old is not None:
            target.clear(old)
        if matte is None:
            return None
        drawn: Box | None = None
        for receiver, light, piece in product(cast.receivers, cast.lights, cast.card.pieces):
            each = cast_on(cast.camera, receiver, piece, light)
            region = _NOWHERE if each is None else each.region(target.box, matte.box)
            box = bounding_box(region)
            if each is not None and box is not None:
                self._draw_one(each, region, matte, target, _light_uniforms(cast, receiver, light))
                drawn = box if drawn is None else drawn.union(box)
        return drawn.intersection(target.box) if drawn is not None else None

    def close(self) -> None:
        """Give the memory back."""
        self._program.close()

    def _draw_one(
        self, cast: Cast, region: Matrix, matte: PlacedMatte, target: Target, light: dict[str, Uniform]
    ) -> None:
        origin = np.floor(region.mean(axis=0)) + 0.5
        from_origin = np.array([[1.0, 0.0, origin[0]], [0.0, 1.0, origin[1]], [0.0, 0.0, 1.0]])
        texel_from_canvas = np.array([[1.0, 0.0, -matte.box.left], [0.0, 1.0, -matte.box.top], [0.0, 0.0, 1.0]])
        texel = _balanced(texel_from_canvas @ cast.art_from_canvas @ from_origin)
        if _may_need_mipmaps(texel, region - origin):
            matte.texture.make_mipmaps()
        target.bind()
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendEquation(GL.GL_MAX)
        matte.texture.bind(0)
        self._program.use(
            {
                "u_target_size_px": (float(target.texture.width_px), float(target.texture.height_px)),
                "u_matte": 0,
                "u_origin_px": origin,
                "u_texel_from_pixel": texel,
                "u_receiver_from_pixel": _balanced(cast.receiver_from_canvas @ from_origin),
                "u_side": cast.side @ from_origin,
                "u_left_fold": cast.left_fold @ from_origin,
                "u_right_fold": cast.right_fold @ from_origin,
                "u_max_cells": MAX_CELLS,
                **light,
            }
        )
        self._polygons.draw(region)
        GL.glDisable(GL.GL_BLEND)
        GL.glBlendEquation(GL.GL_FUNC_ADD)


def _light_uniforms(cast: ShadowCast, receiver: Plane, light: Vector4) -> dict[str, Uniform]:
    height = height_over(receiver.equation, light)
    grazing = (sin(radians(GRAZING_DARK_DEG)), sin(radians(GRAZING_FULL_DEG)))
    is_lamp = light[3] != 0
    foot = (0.0, 0.0)
    if is_lamp:
        under = foot_of(receiver, light[:3])
        away = (under[0] - receiver.origin[0], under[1] - receiver.origin[1], under[2] - receiver.origin[2])
        foot = (dot(away, receiver.u), dot(away, receiver.v))
    return {
        "u_translucent": cast.translucent,
        "u_is_lamp": is_lamp,
        "u_strength": 1.0 if is_lamp else grazing_strength(height),
        "u_lamp_on_receiver": (*foot, height),
        "u_grazing_sine": grazing,
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
