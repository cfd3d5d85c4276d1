"""Small pictures of a cut: frames spread over it, and those on which its feet are doubtful."""

from collections.abc import Sequence
from contextlib import suppress
from typing import Final

from kagezou.animation.frames import spread_frames
from kagezou.batch.record import Thumbnail
from kagezou.document.model import Document
from kagezou.document.scaling import scaled, usable_divisor
from kagezou.errors import InputProblem
from kagezou.export.request import Progress
from kagezou.export.shrinking import shrunk
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.pillow_guard import encode_jpeg
from kagezou.io.images.smaller_cels import SmallerCels
from kagezou.render.gpu.context import OpenContext
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from kagezou.scene.stances import stances_of

_SPREAD: Final = 6
_MOST_DOUBTFUL: Final = 6
_SIDE_PX: Final = 320
_DRAWN_PX: Final = 640
"""About so large they are drawn, and then made small: lines stay fine."""

_QUALITY: Final = 82


def doubtful_frames(document: Document) -> tuple[tuple[str, tuple[int, ...]], ...]:
    """Return for each figure on which frames which foot carries is doubtful; figures without such frames are left."""
    found = ((layer.name, stances_of(document, layer.id)) for layer in document.layers if layer.joins is None)
    return tuple((name, stances.doubtful) for name, stances in found if stances is not None and stances.doubtful)


def thumbnails(
    document: Document,
    doubtful: Sequence[tuple[str, tuple[int, ...]]],
    open_context: OpenContext,
    progress: Progress,
) -> tuple[Thumbnail, ...]:
    """Return small pictures of a cut in the order of its frames; those with a drawing that cannot be read are left.

    Raises
    ------
    GraphicsProblem
        There is no OpenGL, or it failed.
    """
    doubts = sorted({frame for _, frames in doubtful for frame in frames})[:_MOST_DOUBTFUL]
    frames = sorted({*spread_frames(document.canvas.length_frames, _SPREAD), *doubts})
    divisor = usable_divisor(
        document.canvas, max(max(document.canvas.box.width, document.canvas.box.height) // _DRAWN_PX, 1)
    )
    cels = CelCache() if divisor == 1 else SmallerCels(CelCache(), document.canvas.box, divisor)
    with open_context():
        renderer = Renderer(cels, divisor=divisor)
        try:
            smaller = scaled(document, divisor)
            made = []
            for done, frame in enumerate(frames, 1):
                with suppress(InputProblem):  # the export has said so
                    made.append(_drawn(renderer, smaller, frame, is_doubtful=frame in doubts))
                progress(done, len(frames))
            return tuple(made)
        finally:
            renderer.close()


def _drawn(renderer: Renderer, document: Document, frame: int, *, is_doubtful: bool) -> Thumbnail:
    backdrop = Backdrop.BACKGROUND if document.background else Backdrop.WHITE
    renderer.draw_picture(evaluate(document, frame), backdrop)
    small = shrunk(renderer.read_picture()[..., :3], _SIDE_PX)
    return Thumbnail(frame, encode_jpeg(small, _QUALITY), is_doubtful)
