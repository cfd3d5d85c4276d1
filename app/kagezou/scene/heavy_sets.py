"""Sets with so many faces that a frame of them takes minutes."""

from typing import Final

from kagezou.animation.frames import spread_frames
from kagezou.document.model import Document
from kagezou.geometry.sets.bodies import Solid
from kagezou.message import Message
from kagezou.scene.evaluate import camera_at, ground_at
from kagezou.scene.pieces import pieces_at

MAX_PAIRS: Final = 10_000_000
"""What each body takes of each face is asked for; so often takes about half a minute."""

_MOST_FRAMES: Final = 4


def heavy_words(document: Document) -> Message | None:
    """Return that drawing the set pieces of a document takes minutes a frame; None where it does not."""
    faces, bodies = max(_sizes(document, frame) for frame in spread_frames(document.canvas.length_frames, _MOST_FRAMES))
    if faces * bodies <= MAX_PAIRS:
        return None
    return Message(
        "the set pieces have {faces} flat faces: drawing a frame may take minutes; fewer steps or an imported set "
        "take less",
        faces=faces,
    )


def heavy_notes(before: Document, after: Document) -> tuple[Message, ...]:
    """Return the same of a document that was changed, nothing where it was so before."""
    words = None if after.pieces is before.pieces else heavy_words(after)
    return () if words is None or heavy_words(before) is not None else (words,)


def _sizes(document: Document, frame: int) -> tuple[int, int]:
    """Return how many flat faces and how many bodies there are on a frame."""
    pieces = pieces_at(document, frame, camera_at(document, frame), ground_at(document, frame))
    bodies = [body for piece in pieces for body in piece.bodies]
    return sum(len(body.facets) for body in bodies if isinstance(body, Solid)), len(bodies)
