"""Which part of their boxes figures fill on a frame: coarse, for judging where shadows fall."""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from kagezou.document.model import Document
from kagezou.errors import InputProblem
from kagezou.geometry.box import Box, centred_offset
from kagezou.geometry.placement import centred_from_canvas
from kagezou.io.images.reading import Matte, read_matte
from kagezou.scene.placing import drawing_of, figure_box, shown_parts
from kagezou.scene.scene import PlacedDrawing

Flags = NDArray[np.bool_]

_CELLS: Final = 96
"""Into how many rows and columns a figure's box is cut."""


def silhouettes_of(document: Document, frame: int) -> dict[str, Flags]:
    """Return, by the ids of their layers, where figures are opaque in the boxes around them, (rows, columns).

    A figure is left out that shows nothing on the frame, or of which a drawing cannot be read.
    """
    found: dict[str, Flags] = {}
    for layer in document.layers:
        if layer.joins is not None:
            continue
        box = figure_box(document, layer.id, frame)
        shown = (drawing_of(document, part, frame) for part in shown_parts(document, layer.id, frame))
        placed = [drawing for drawing in shown if drawing is not None]
        try:
            parts = [_opaque(document.canvas.box, each, read_matte(each.source), box) for each in placed]
        except InputProblem:
            continue
        if parts and not box.is_empty:
            found[layer.id] = np.logical_or.reduce(parts)
    return found


def _opaque(canvas: Box, drawing: PlacedDrawing, matte: Matte, box: Box) -> Flags:
    """Return where a drawing is opaque at the middles of the cells of a box, canvas px."""
    opaque = np.zeros((_CELLS, _CELLS), np.bool_)
    if matte.box is None:
        return opaque
    middles = (np.arange(_CELLS) + 0.5) / _CELLS
    x, y = np.meshgrid(box.left + middles * box.width, box.top + middles * box.height)
    left, top = centred_offset(canvas, matte.width_px, matte.height_px)
    column, row, _ = centred_from_canvas(drawing.placement) @ np.stack([x.ravel(), y.ravel(), np.ones(x.size)])
    column, row = (
        np.floor(axis).astype(np.intp) for axis in (column - left - matte.box.left, row - top - matte.box.top)
    )
    inside = (column >= 0) & (column < matte.box.width) & (row >= 0) & (row < matte.box.height)
    half = int(np.iinfo(matte.alpha.dtype).max) // 2
    opaque.ravel()[inside] = matte.alpha[row[inside], column[inside]] > half
    return opaque
