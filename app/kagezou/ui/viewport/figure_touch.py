"""Whether the hand is on the figure worked on: on a painted pixel of one of its cels, not only within their box."""

from kagezou.document.model import Document, Layer, drawing_size
from kagezou.errors import Problem
from kagezou.geometry.box import centred_offset
from kagezou.geometry.placement import centred_from_canvas
from kagezou.geometry.vectors import Point2
from kagezou.io.images.cel_cache import CelSource
from kagezou.scene.placing import drawing_of, shown_parts


def is_on_figure(
    document: Document, figure_id: str, frame: int, canvas_px: Point2, reach_px: float, cels: CelSource
) -> bool:
    """Return whether any cel of a figure is painted within reach of a place.

    Parameters
    ----------
    canvas_px
        The place.
    reach_px
        So far beside a painted pixel still counts, canvas px: a foot's point lies at its very edge.
    cels
        Where the drawings come from; one that cannot be read is not there.
    """
    parts = shown_parts(document, figure_id, frame)
    return any(_is_painted(document, part, frame, canvas_px, reach_px, cels) for part in parts)


def _is_painted(
    document: Document, layer: Layer, frame: int, canvas_px: Point2, reach_px: float, cels: CelSource
) -> bool:
    drawing, shown = layer.cels.drawing_at(frame), drawing_of(document, layer, frame)
    if drawing is None or shown is None:
        return False
    try:
        matte = cels.matte(shown.source)
    except Problem:
        return False
    if matte.box is None:
        return False
    back = centred_from_canvas(shown.placement)
    left, top = centred_offset(document.canvas.box, *drawing_size(document.canvas, drawing))
    x, y, _ = back @ (*canvas_px, 1.0)
    # As wide as the placed drawing makes it: a cel shown small is reached from farther off in its own px.
    reach = reach_px * max(abs(float(back[0, 0])) + abs(float(back[0, 1])), 1e-6)
    across, down = float(x) - left - matte.box.left, float(y) - top - matte.box.top
    rows = slice(max(int(down - reach), 0), max(int(down + reach) + 1, 0))
    columns = slice(max(int(across - reach), 0), max(int(across + reach) + 1, 0))
    return bool(matte.alpha[rows, columns].any())
