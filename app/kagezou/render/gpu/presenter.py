"""Placing the finished picture in a window: scaled and shifted, nothing else."""

from dataclasses import dataclass

from kagezou.geometry.box import Box
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.gl import GL
from kagezou.render.gpu.program import Program
from kagezou.render.gpu.targets import Texture

BLOCKY_FROM_ZOOM = 2.0
"""From this magnification on single pixels are shown as squares."""


@dataclass(frozen=True, slots=True)
class WindowView:
    """How a window looks at the canvas.

    Parameters
    ----------
    framebuffer
        The window's own.
    width_px, height_px
        Its size in device pixels.
    zoom
        Device pixels a canvas px.
    origin_px
        Where the canvas' top left corner lies, device px, y down.
    surround
        The colour around the canvas, sRGB 0 to 1.
    divisor
        How many canvas px a pixel of the picture is wide: over 1 for a preview.
    """

    framebuffer: int
    width_px: int
    height_px: int
    zoom: float
    origin_px: tuple[float, float]
    surround: tuple[float, float, float]
    divisor: int = 1


class Presenter:
    """Draws a picture into a framebuffer that is not ours."""

    def __init__(self, boxes: Boxes) -> None:
        self._boxes = boxes
        self._program = Program("common/box.vert", "picture/present.frag")

    def draw(self, picture: Texture, view: WindowView) -> None:
        """Fill the window with the picture and its surround."""
        GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, view.framebuffer)
        GL.glViewport(0, 0, view.width_px, view.height_px)
        for state in (GL.GL_BLEND, GL.GL_DEPTH_TEST, GL.GL_CULL_FACE, GL.GL_STENCIL_TEST, GL.GL_SCISSOR_TEST):
            GL.glDisable(state)
        GL.glColorMask(True, True, True, True)  # noqa: FBT003 - the call's own order
        picture.set_linear(magnified=view.zoom < BLOCKY_FROM_ZOOM, minified=True)
        picture.bind(0)
        scale = 1.0 / (view.zoom * view.divisor)
        self._program.use(
            {
                "u_target_size_px": (float(view.width_px), float(view.height_px)),
                "u_picture": 0,
                "u_window_height_px": float(view.height_px),
                "u_canvas_from_window": (scale, -view.origin_px[0] * scale, -view.origin_px[1] * scale),
                "u_canvas_size_px": (float(picture.width_px), float(picture.height_px)),
                "u_surround": view.surround,
            }
        )
        self._boxes.draw_one(Box(0, 0, view.width_px, view.height_px))

    def close(self) -> None:
        """Give the memory back."""
        self._program.close()
