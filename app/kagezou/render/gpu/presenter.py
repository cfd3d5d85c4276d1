"""Placing the finished picture in a window: scaled and shifted, nothing else."""

from dataclasses import dataclass

from kagezou.geometry.box import Box
from kagezou.io.images.reading import Steps
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.gl import GL, check
from kagezou.render.gpu.program import Program
from kagezou.render.gpu.targets import Format, Target, Texture

BLOCKY_FROM_ZOOM = 2.0
"""From this magnification on single pixels are shown as squares."""


@dataclass(frozen=True, slots=True)
class WindowView:
    """How a window looks at the canvas.

    Parameters
    ----------
    framebuffer
        The window's own; None for a window that is painted otherwise.
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

    framebuffer: int | None
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
        self._copy: Target | None = None

    def draw(self, picture: Texture, view: WindowView) -> Steps | None:
        """Fill the window with the picture and its surround.

        Without a framebuffer return what would fill it, (H, W, 4) 8 bit: blue, green, red, opaque; the top row first.
        """
        if view.framebuffer is not None:
            self._draw(picture, view, view.framebuffer, (float(view.height_px), -1.0))
            check("showing the picture")
            return None
        size = (view.width_px, view.height_px)
        if self._copy is None or self._copy.size_px != size:
            if self._copy is not None:
                self._copy.close()
            self._copy = Target(*size, Format.RGBA8)
        self._draw(picture, view, self._copy.id, (0.0, 1.0))
        pixels = self._copy.read_for_screen()
        check("showing the picture")
        return pixels

    def _draw(self, picture: Texture, view: WindowView, framebuffer: int, rows: tuple[float, float]) -> None:
        GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, framebuffer)
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
                "u_rows": rows,
                "u_canvas_from_window": (scale, -view.origin_px[0] * scale, -view.origin_px[1] * scale),
                "u_canvas_size_px": (float(picture.width_px), float(picture.height_px)),
                "u_surround": view.surround,
            }
        )
        self._boxes.draw_one(Box(0, 0, view.width_px, view.height_px))

    def close(self) -> None:
        """Give the memory back."""
        self._program.close()
        if self._copy is not None:
            self._copy.close()
