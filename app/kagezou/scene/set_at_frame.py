"""The set of a document at a frame: where its pieces stand, and what they are made of there."""

from functools import lru_cache

import numpy as np

from kagezou.document import set_properties as lines
from kagezou.document.model import Document, Piece
from kagezou.document.piece_kinds import kind_of
from kagezou.document.values import value_at
from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import Plane, place_on
from kagezou.geometry.sets.bodies import Body
from kagezou.geometry.sets.measures import Measures
from kagezou.geometry.sets.shapes import SHAPES, bodies_of, stand_on
from kagezou.geometry.vectors import Point2
from kagezou.scene.piece_frames import measures_at, place_of
from kagezou.scene.pieces import MeshPlacement, PieceScene


def pieces_at(document: Document, frame: float, camera: Camera, ground: Plane) -> tuple[PieceScene, ...]:
    """Return the set of a frame; pieces that are switched off or placed above the horizon are left out."""
    scenes = (_piece_scene(piece, frame, camera, ground) for piece in document.pieces)
    return tuple(scene for scene in scenes if scene is not None)


def _piece_scene(piece: Piece, frame: float, camera: Camera, ground: Plane) -> PieceScene | None:
    if not value_at(piece.tracks, lines.PIECE_PRESENT, frame):
        return None
    position = value_at(piece.tracks, lines.PIECE_POSITION, frame)
    angle = value_at(piece.tracks, lines.PIECE_ANGLE, frame)
    bodies = _bodies(measures_at(piece, frame), position, angle, camera, ground)
    placement = _placement(piece, frame, camera, ground)
    if not bodies and placement is None:
        return None
    casts = value_at(piece.tracks, lines.PIECE_CASTS, frame)
    return PieceScene(
        piece.id,
        piece.name,
        bodies,
        receives=value_at(piece.tracks, lines.PIECE_RECEIVES, frame),
        blocks=casts or value_at(piece.tracks, lines.PIECE_BLOCKS, frame),
        casts=casts,
        mesh=placement,
        display=value_at(piece.tracks, lines.PIECE_DISPLAY, frame),
        is_under=value_at(piece.tracks, lines.PIECE_UNDER, frame),
    )


def _placement(piece: Piece, frame: float, camera: Camera, ground: Plane) -> MeshPlacement | None:
    """Return where an imported set stands; None for other kinds, without a file, or above the horizon."""
    if SHAPES[kind_of(piece, frame)] is not None or piece.source is None:
        return None
    anchor = value_at(piece.tracks, lines.PIECE_ANCHOR, frame)
    place = place_of(piece, frame, camera, ground)
    if place is None:
        return None
    scale = value_at(piece.tracks, lines.PIECE_SCALE, frame) * float(camera.canvas_from_world()[2] @ (*place, 1.0))
    stand = stand_on(ground, place, value_at(piece.tracks, lines.PIECE_ANGLE, frame))
    right, front, above = (scale * np.array(axis) for axis in (stand.u, stand.v, stand.normal))
    is_z_up = value_at(piece.tracks, lines.PIECE_UP, frame) == "z"
    linear = np.column_stack([right, -front, above] if is_z_up else [right, above, front])
    rows = np.column_stack([linear, np.array(place) - linear @ anchor])
    return MeshPlacement(piece.source, (*(tuple(map(float, row)) for row in rows), (0.0, 0.0, 0.0, 1.0)))


@lru_cache(maxsize=256)
def _bodies(measures: Measures, position: Point2, angle_deg: float, camera: Camera, ground: Plane) -> tuple[Body, ...]:
    """Return what a piece is made of; nothing above the horizon. Sizes are as they are seen where it stands."""
    place = place_on(camera, ground, position)
    if place is None:
        return ()
    # One px of the canvas is this many px of the world there.
    scale = float(camera.canvas_from_world()[2] @ (*place, 1.0))
    return bodies_of(stand_on(ground, place, angle_deg), measures.scaled(scale))
