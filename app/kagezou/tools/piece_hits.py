"""Which piece of the set the hand means: its outline is what it is chosen by."""

from collections.abc import Iterable

import numpy as np

from kagezou.geometry.vectors import Matrix, Point2
from kagezou.scene.set_outlines import PieceOutline
from kagezou.tools.view import CanvasView


def piece_at(outlines: Iterable[PieceOutline], view: CanvasView, view_px: Point2, reach: float) -> str | None:
    """Return the piece whose outline passes nearest within ``reach`` view px, the later of equally near ones."""
    at, nearest, found = np.array(view.canvas_from_view(view_px)), view.canvas_length(reach), None
    for each in outlines:
        distance = _distance(each.ends, at)
        if distance <= nearest:
            nearest, found = distance, each.piece_id
    return found


def _distance(ends: Matrix, at: Matrix) -> float:
    """Return how far a point (2,) lies from the nearest of segments (N, 2, 2)."""
    start, way = ends[:, 0], ends[:, 1] - ends[:, 0]
    lengths = np.maximum((way * way).sum(axis=1), 1e-12)
    part = np.clip(((at - start) * way).sum(axis=1) / lengths, 0.0, 1.0)
    away = start + part[:, None] * way - at
    return float(np.sqrt((away * away).sum(axis=1).min(initial=np.inf)))
