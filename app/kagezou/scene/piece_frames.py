"""Where a set piece stands at a frame and how large it is in the world: what hands and outlines are placed by."""

from dataclasses import dataclass

from kagezou.document import set_properties as lines
from kagezou.document.model import Piece
from kagezou.document.piece_kinds import kind_of
from kagezou.document.values import value_at
from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import Plane, place_on, world_from_canvas_on
from kagezou.geometry.sets.measures import Measures
from kagezou.geometry.sets.shapes import SHAPES, stand_on
from kagezou.geometry.vectors import Vector3


@dataclass(frozen=True, slots=True)
class PieceFrame:
    """A set piece of one frame by its measures.

    Parameters
    ----------
    id
        Which piece.
    stand
        Its own frame on the ground: u along its width, v out of its front.
    measures
        What it is made from.
    scale
        World px for one canvas px at the depth where it stands.
    angle_deg
        Its turn against the ground line.
    """

    id: str
    stand: Plane
    measures: Measures
    scale: float
    angle_deg: float


def measures_at(piece: Piece, frame: float) -> Measures:
    """Return what a piece is made from as its properties tell it: canvas px at the depth where it stands."""
    return Measures(
        kind=kind_of(piece, frame),
        width_px=value_at(piece.tracks, lines.PIECE_WIDTH, frame),
        height_px=value_at(piece.tracks, lines.PIECE_HEIGHT, frame),
        depth_px=value_at(piece.tracks, lines.PIECE_DEPTH, frame),
        lean_deg=value_at(piece.tracks, lines.PIECE_LEAN, frame),
        count=round(value_at(piece.tracks, lines.PIECE_COUNT, frame)),
    )


def place_of(piece: Piece, frame: float, camera: Camera, ground: Plane) -> Vector3 | None:
    """Return where a piece stands, world px; None at and above the horizon.

    An imported set is seen by level cameras as well, which see the ground as a line: it stands in the plane of the
    drawings then.
    """
    position = value_at(piece.tracks, lines.PIECE_POSITION, frame)
    if SHAPES[kind_of(piece, frame)] is None and world_from_canvas_on(camera, ground) is None:
        return (*position, 0.0)
    return place_on(camera, ground, position)


def piece_frame(piece: Piece, frame: float, camera: Camera, ground: Plane) -> PieceFrame | None:
    """Return a piece's frame; None where it is switched off, or placed at or above the horizon."""
    if not value_at(piece.tracks, lines.PIECE_PRESENT, frame):
        return None
    place = place_of(piece, frame, camera, ground)
    if place is None:
        return None
    scale = float(camera.canvas_from_world()[2] @ (*place, 1.0))
    angle = value_at(piece.tracks, lines.PIECE_ANGLE, frame)
    measures = measures_at(piece, frame).scaled(scale)
    return PieceFrame(piece.id, stand_on(ground, place, angle), measures, scale, angle)
