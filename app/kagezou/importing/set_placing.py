"""What the edits of imported sets share: where one stands, its properties, and keys from values."""

from collections.abc import Iterable

import numpy as np

from kagezou.animation.track import Interpolation, Key, Track, Value
from kagezou.document.address import Address
from kagezou.document.model import Document
from kagezou.document.properties import OF_PIECE
from kagezou.document.property import AnyProperty
from kagezou.geometry.vectors import Matrix
from kagezou.scene.evaluate import camera_at, ground_at
from kagezou.scene.set_at_frame import pieces_at


def placement(document: Document, piece_id: str, frame: int) -> Matrix | None:
    """Return where an imported set stands on a frame, (4, 4) from its file's units to the world; None for nowhere."""
    for piece in pieces_at(document, frame, camera_at(document, frame), ground_at(document, frame)):
        if piece.id == piece_id and piece.mesh is not None:
            return np.array(piece.mesh.world_from_mesh)
    return None


def track_through(prop: AnyProperty, values: Iterable[tuple[int, Value]]) -> Track:
    """Return a track with a linear key for each frame and value, or a constant where all are the same."""
    keys = tuple(Key(frame, prop.canonical(value), Interpolation.LINEAR) for frame, value in values)
    if all(key.value == keys[0].value for key in keys):
        return Track(keys[0].value)
    return Track(keys[0].value, keys)


def of_piece(prop: AnyProperty, piece_id: str) -> Address:
    """Return where a property of a piece lives."""
    return Address(OF_PIECE[prop.name], piece_id=piece_id)
