"""A figure where its layer lays it: its solid pixels on the canvas after move, turn and scale."""

import numpy as np

from kagezou.geometry.placement import Placement, around_placed
from kagezou.importing.figures import Figure

_MOST_PX = 1 << 24
"""A figure that a scale makes larger is measured no finer."""


def placed_figure(figure: Figure, placement: Placement | None) -> Figure:
    """Return a figure as a placement lays it on the canvas; as it is where none does or nothing would be seen."""
    if placement is None or not placement.is_seen:
        return figure
    box = around_placed(figure.box, placement.canvas_from_centred())
    if box.width * box.height > _MOST_PX:
        return figure
    rows, columns = np.indices((box.height, box.width))
    centres = np.column_stack([columns.ravel() + box.left, rows.ravel() + box.top]) + 0.5
    back = placement.centred_from_canvas()
    drawn = centres @ back[:2, :2].T + back[:2, 2]
    solid = figure.covers(drawn).reshape(box.height, box.width)
    return Figure(solid, (box.left, box.top)) if solid.any() else figure
