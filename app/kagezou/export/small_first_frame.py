"""The first frame of a project, small: drawn at a part of its resolution, so that no project costs much memory."""

from collections.abc import Iterator
from math import ceil
from pathlib import Path
from typing import Final

from kagezou.document.model import Canvas, Document
from kagezou.document.roomier import roomier
from kagezou.document.scaling import scaled
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.reading import Steps, probe
from kagezou.io.images.smaller_cels import SmallerCels
from kagezou.picture_source import PictureSource
from kagezou.render.coverage_cache import Budgets
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate

LONGEST_PX: Final = 1024
"""So long is the longer side of what is drawn at most, but for a margin smaller than what becomes one pixel."""
MOST_BYTES: Final = 96 << 20
"""A drawing of more bytes, once decoded, is not read only to be shown small."""
_MOST_MESH_BYTES: Final = 32 << 20
_CACHE_BYTES: Final = 128 << 20
_ONE_PICTURE: Final = Budgets(shadows=16 << 20, mattes=64 << 20)
"""Nothing is drawn a second time."""


def first_frame(document: Document) -> Steps | None:
    """Return the first frame on white, (H, W, 4), with the context that is current; None where it costs too much.

    Raises
    ------
    InputProblem
        A drawing or set cannot be read.
    GraphicsProblem
        The driver fails.
    """
    if any(_is_large(source) for source in _pictures(document)) or any(map(_is_large_file, _sets(document))):
        return None
    divisor, across, down = fineness(document.canvas)
    larger = roomier(document, across, down)
    cels = SmallerCels(CelCache(_CACHE_BYTES), larger.canvas.box, divisor)
    source = CelCache(_CACHE_BYTES) if divisor == 1 else cels
    renderer = Renderer(source, divisor=divisor, budgets=_ONE_PICTURE)
    try:
        renderer.draw_picture(evaluate(scaled(larger, divisor), 1), Backdrop.WHITE)
        return renderer.read_picture()
    finally:
        renderer.close()


def fineness(canvas: Canvas) -> tuple[int, int, int]:
    """Return how many px become one, and the margins across and down, px, with which that goes up."""
    least = ceil(max(canvas.width_px, canvas.height_px) / LONGEST_PX)
    # Of two that follow each other one is odd, and with an odd one some margin always goes up.
    for divisor in (least, least + 1):
        across, down = (_margin(side, divisor) for side in (canvas.width_px, canvas.height_px))
        if across is not None and down is not None:
            return divisor, across, down
    raise AssertionError(canvas)


def _margin(side_px: int, divisor: int) -> int | None:
    return next((margin for margin in range(divisor) if (side_px + 2 * margin) % divisor == 0), None)


def _pictures(document: Document) -> Iterator[PictureSource]:
    """Yield the pictures that the first frame shows."""
    for cels in (document.behind, *(layer.cels for layer in document.layers)):
        drawing = cels.drawing_at(1)
        if drawing is not None:
            yield drawing.source


def _sets(document: Document) -> Iterator[Path]:
    return (piece.source for piece in document.pieces if piece.source is not None)


def _is_large(source: PictureSource) -> bool:
    info = probe(source)
    return info.width_px * info.height_px * 4 * max(info.bit_depth // 8, 1) > MOST_BYTES


def _is_large_file(path: Path) -> bool:
    return path.is_file() and path.stat().st_size > _MOST_MESH_BYTES
