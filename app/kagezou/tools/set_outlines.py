"""The set as lines on the canvas: what shows where its pieces are, and by which they are chosen."""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

import numpy as np

from kagezou.document.model import Document
from kagezou.geometry.camera import Camera
from kagezou.geometry.sets.wires import wires_of
from kagezou.geometry.vectors import Matrix, Point2
from kagezou.scene.evaluate import camera_at, ground_at
from kagezou.scene.piece_frames import PieceFrame, piece_frame
from kagezou.tools.sight import seen
from kagezou.tools.view import CanvasView

Line = tuple[Point2, ...]


@dataclass(frozen=True, slots=True, eq=False)
class PieceOutline:
    """The edges of one piece, canvas px.

    Parameters
    ----------
    piece_id
        Whose they are.
    seen, hidden
        Polylines: what the eye sees of it, and what the piece itself hides.
    ends
        The segments (N, 2, 2) of what is seen.
    """

    piece_id: str
    seen: tuple[Line, ...]
    hidden: tuple[Line, ...]
    ends: Matrix


def outlines_of(document: Document, frame: int) -> tuple[PieceOutline, ...]:
    """Return the outlines of all pieces that are in the set at a frame."""
    if not document.pieces:
        return ()
    camera, ground = camera_at(document, frame), ground_at(document, frame)
    frames = (piece_frame(piece, frame, camera, ground) for piece in document.pieces)
    return tuple(outline(each, camera) for each in frames if each is not None)


@lru_cache(maxsize=512)
def outline(piece: PieceFrame, camera: Camera) -> PieceOutline:
    """Return the outline of a piece."""
    wires = wires_of(piece.stand, piece.measures, camera.eye)
    lines = [(tuple(seen(camera, point) for point in wire.points), wire.is_hidden) for wire in wires]
    shown = tuple(line for line, is_hidden in lines if not is_hidden)
    segments = [pair for line in shown for pair in pairwise(line)]
    return PieceOutline(
        piece.id, shown, tuple(line for line, is_hidden in lines if is_hidden),
        np.array(segments, np.float64).reshape(-1, 2, 2),
    )  # fmt: skip


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
