"""The set as lines on the canvas: what shows where its pieces are, and by which they are chosen."""

from dataclasses import dataclass
from functools import lru_cache
from itertools import groupby, pairwise
from typing import Final

import numpy as np

from kagezou.document.model import Document
from kagezou.geometry.camera import Camera
from kagezou.geometry.sets.wires import wires_of
from kagezou.geometry.sight import seen
from kagezou.geometry.vectors import Matrix, Point2, Vector3, height_over
from kagezou.scene.evaluate import camera_at, ground_at
from kagezou.scene.piece_frames import PieceFrame, piece_frame

Line = tuple[Point2, ...]

_ON_GROUND_PX: Final = 1e-3
"""What is less high than this, world px, lies on the ground."""


@dataclass(frozen=True, slots=True, eq=False)
class PieceOutline:
    """The edges of one piece, canvas px.

    Parameters
    ----------
    piece_id
        Whose they are.
    seen, hidden
        Polylines: what the eye sees of it, and what the piece itself hides.
    floor
        The parts of what is seen that lie on the ground.
    ends
        The segments (N, 2, 2) of what is seen.
    """

    piece_id: str
    seen: tuple[Line, ...]
    hidden: tuple[Line, ...]
    floor: tuple[Line, ...]
    ends: Matrix


@dataclass(frozen=True, slots=True)
class SetLines:
    """The outlines of a whole set as lines to be drawn, canvas px: every edge seen, and the floor lines among them."""

    edges: tuple[Line, ...]
    floor: tuple[Line, ...]


def set_lines(document: Document, frame: int) -> SetLines:
    """Return the lines of all pieces that are in the set at a frame; an imported set has none."""
    outlines = outlines_of(document, frame)
    return SetLines(
        tuple(line for each in outlines for line in each.seen), tuple(line for each in outlines for line in each.floor)
    )


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
    shown = tuple(_on_canvas(camera, wire.points) for wire in wires if not wire.is_hidden)
    floor = (run for wire in wires if not wire.is_hidden for run in _on_ground(piece, wire.points))
    segments = [pair for line in shown for pair in pairwise(line)]
    return PieceOutline(
        piece.id, shown,
        tuple(_on_canvas(camera, wire.points) for wire in wires if wire.is_hidden),
        tuple(_on_canvas(camera, run) for run in floor),
        np.array(segments, np.float64).reshape(-1, 2, 2),
    )  # fmt: skip


def _on_ground(piece: PieceFrame, points: tuple[Vector3, ...]) -> list[tuple[Vector3, ...]]:
    """Return the runs of a polyline that lie on the ground the piece stands on."""
    equation = piece.stand.equation
    flags = ((abs(height_over(equation, (*point, 1.0))) < _ON_GROUND_PX, point) for point in points)
    runs = (tuple(point for _, point in run) for lies, run in groupby(flags, lambda each: each[0]) if lies)
    return [run for run in runs if len(run) > 1]


def _on_canvas(camera: Camera, points: tuple[Vector3, ...]) -> Line:
    return tuple(seen(camera, point) for point in points)
