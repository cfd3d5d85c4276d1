"""Shadow mapping to the letter (paper 3.4): what the light sees is stored, then every receiver point looks itself up.

Kept as a cross-check of the closed form, never used for a picture: its edges are only as fine as its texels.
"""

from ctypes import c_void_p
from itertools import product

import numpy as np

from kagezou.errors import GraphicsProblem
from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.card import CardPiece
from kagezou.geometry.ground import Plane, world_from_canvas_on
from kagezou.geometry.placement import around_placed, canvas_from_centred, centred_from_canvas
from kagezou.geometry.vectors import Matrix
from kagezou.io.images.reading import Steps
from kagezou.message import Message
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.gl import GL, check, deleted, made
from kagezou.render.gpu.mattes import PlacedMatte
from kagezou.render.gpu.program import Program
from kagezou.render.gpu.targets import DepthTarget, Format, Target
from kagezou.render.prepare.light_view import LightView
from kagezou.render.prepare.moved import moved_by
from kagezou.scene.scene import ShadowCast


def mapped_coverage(
    boxes: Boxes, canvas: Box, what: tuple[ShadowCast | None, PlacedMatte | None], map_px: int
) -> Steps:
    """Return the covered parts of a canvas, (H, W) 16 bit; nothing where there is no cast or no drawing."""
    cast, matte = what
    target = Target(canvas.width, canvas.height, Format.ALPHA16)
    target.clear()
    if cast is not None and matte is not None:
        depth_map = DepthMapPass(boxes, map_px)
        depth_map.draw(cast, matte, target)
        depth_map.close()
    coverage = target.read(target.box)
    target.close()
    check("drawing a depth map")
    return coverage


class DepthMapPass:
    """Draws a cast by way of a square depth map of ``map_px`` texels a side, for each light."""

    def __init__(self, boxes: Boxes, map_px: int) -> None:
        self._boxes = boxes
        self._map = DepthTarget(map_px)
        self._store = Program("passes/depth_card.vert", "passes/depth_card.frag")
        self._receive = Program("common/box.vert", "passes/depth_receive.frag")
        self._array = made(GL.glGenVertexArrays)
        self._buffer = made(GL.glGenBuffers)

    def draw(self, cast: ShadowCast, matte: PlacedMatte, target: Target) -> None:
        """Draw into ``target``: 1 in shadow, 0 elsewhere, no anti-aliasing; the whole target is drawn anew."""
        target.clear()
        seen = around_placed(matte.box, canvas_from_centred(cast.placement))
        found = [_corners(cast.camera, piece, seen) for piece in cast.card.pieces]
        corners = [each for each in found if len(each)]
        for receiver, light in product(cast.receivers, cast.lights):
            view = LightView.around(light, np.concatenate(corners))
            self._store_card(cast, corners, view, matte)
            self._look_up(cast.camera, receiver, view, target)

    def close(self) -> None:
        """Give the memory back."""
        self._map.close()
        self._store.close()
        self._receive.close()
        deleted(GL.glDeleteBuffers, self._buffer)
        deleted(GL.glDeleteVertexArrays, self._array)

    def _store_card(self, cast: ShadowCast, corners: list[Matrix], view: LightView, matte: PlacedMatte) -> None:
        self._map.begin()
        matte.texture.set_linear(magnified=True, minified=True)
        matte.texture.bind(0)
        ex, ey, distance, w = cast.camera.eye
        self._store.use(
            {
                "u_matte": 0,
                "u_texel_from_canvas": moved_by(-matte.box.left, -matte.box.top) @ centred_from_canvas(cast.placement),
                "u_eye": (ex, ey, w / distance),
                **view.uniforms(),
            }
        )
        for polygon in corners:
            self._draw_polygon(view, polygon)
        matte.texture.set_linear(magnified=False, minified=False)

    def _draw_polygon(self, view: LightView, corners: Matrix) -> None:
        """Draw world points (N, 3) as a fan, each given in light space and in the world."""
        points = np.ascontiguousarray(np.hstack([view.seen(corners), corners]), dtype=np.float32)
        GL.glBindVertexArray(self._array)
        GL.glBindBuffer(GL.GL_ARRAY_BUFFER, self._buffer)
        GL.glBufferData(GL.GL_ARRAY_BUFFER, points.nbytes, c_void_p(points.ctypes.data), GL.GL_STREAM_DRAW)
        for place, offset in ((0, 0), (1, 12)):
            GL.glEnableVertexAttribArray(place)
            GL.glVertexAttribPointer(place, 3, GL.GL_FLOAT, False, 24, c_void_p(offset))  # noqa: FBT003 - GL's order
        GL.glDrawArrays(GL.GL_TRIANGLE_FAN, 0, len(points))

    def _look_up(self, camera: Camera, receiver: Plane, view: LightView, target: Target) -> None:
        lift = world_from_canvas_on(camera, receiver)
        if lift is None:
            return
        target.bind()
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendEquation(GL.GL_MAX)
        self._map.bind_texture(0)
        self._receive.use(
            {
                "u_target_size_px": target.size_px,
                "u_map": 0,
                "u_light_from_canvas": view.light_from_world() @ lift,
                "u_receiver_w": lift[3],
                **view.uniforms(),
            }
        )
        self._boxes.draw_one(target.box)


def _corners(camera: Camera, piece: CardPiece, art: Box) -> Matrix:
    """Return the world points (N, 3) of the part of a card piece that a drawing's box lies on; N may be 0."""
    return np.array([_on_piece(camera, piece, x, y) for x, y in piece.part_of(art)]).reshape(-1, 3)


def _on_piece(camera: Camera, piece: CardPiece, x: float, y: float) -> Matrix:
    """Return the world point where the view ray through a canvas point meets a piece's plane."""
    eye, plane = np.array(camera.eye), np.array(piece.plane)
    start = np.array([x, y, 0.0, 1.0])
    lifted = (plane @ eye) * start - (plane @ start) * eye
    if abs(lifted[3]) < 1e-12:
        raise GraphicsProblem(Message("the card is seen edge-on and has no picture for the depth map"))
    return np.asarray(lifted[:3] / lifted[3])
