"""Frames with keys."""

from pathlib import Path

from kagezou.document import edits
from kagezou.document.address import resolve
from kagezou.document.keyed_frames import key_frames, next_key, previous_key
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.document.set_pieces import add_piece
from kagezou.geometry.box import Box


def keyed(document: Document, path: str, *frames: int) -> Document:
    for frame in frames:
        document = edits.set_key(document, resolve(document, path), frame, 1.0)
    return document


def test_frames_with_keys_are_those_of_the_scene_and_of_what_is_worked_on() -> None:
    cels = Cels((Drawing("1", Path("/c/1.png")),), (Exposure(1, 0),))
    document = Document(Canvas(100, 100, length_frames=48))
    for name in "AB":
        document = edits.add_layer(document, name, cels, Box(0, 0, 9, 9))
    document = add_piece(document, "wall", "wall", {})
    document = keyed(document, "ground.roll", 9, 3)
    document = keyed(document, "layers.A.tilt", 9, 12)
    document = keyed(document, "layers.A.shadow.opacity", 5)
    document = keyed(document, "layers.B.tilt", 20)
    document = keyed(document, "set.wall.width", 30)
    first, second = (layer.id for layer in document.layers)
    (wall,) = document.pieces
    assert key_frames(document, None) == (3, 9)
    assert key_frames(document, first) == (3, 5, 9, 12)
    assert key_frames(document, second) == (3, 9, 20)
    assert key_frames(document, None, wall.id) == (3, 9, 30)


def test_previous_and_next_key() -> None:
    assert previous_key((3, 9), 9) == 3
    assert previous_key((3, 9), 3) is None
    assert next_key((3, 9), 3) == 9
    assert next_key((3, 9), 9) is None
