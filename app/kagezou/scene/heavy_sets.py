"""Sets of very many parts: said where a frame takes minutes, and left out in part while someone works."""

from collections.abc import Iterable
from typing import Final

from kagezou.animation.frames import spread_frames
from kagezou.document.model import Document
from kagezou.errors import UsageProblem
from kagezou.message import Message, first_names
from kagezou.scene.evaluate import camera_at, ground_at
from kagezou.scene.pieces import PieceScene

MAX_PAIRS: Final = 10_000_000
"""What each body takes of each face is asked for; so often takes about half a minute."""

MOST_AT_HAND: Final = 250
"""So many parts are drawn while someone works; each hides and darkens every other, so twice as many take four times."""

_MOST_FRAMES: Final = 4


def heavy_words(document: Document) -> Message | None:
    """Return that drawing the set pieces of a document takes minutes a frame; None where it does not."""
    if not document.pieces:
        return None
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
    from kagezou.geometry.sets.bodies import Solid  # loaded with the first set
    from kagezou.scene.set_at_frame import pieces_at

    pieces = pieces_at(document, frame, camera_at(document, frame), ground_at(document, frame))
    bodies = [body for piece in pieces for body in piece.bodies]
    return sum(len(body.facets) for body in bodies if isinstance(body, Solid)), len(bodies)


def parts_of(pieces: Iterable[PieceScene]) -> int:
    """Return how many steps, walls, boxes and the like pieces are made of; a mesh counts as none."""
    return sum(len(piece.bodies) for piece in pieces)


def beyond(pieces: Iterable[PieceScene], most: int) -> tuple[PieceScene, ...]:
    """Return the pieces that have to be left out, the last first of all, so that at most so many parts are left."""
    count = 0
    left: list[PieceScene] = []
    for piece in pieces:
        count += len(piece.bodies)
        if count > most and piece.bodies:
            left.append(piece)
    return tuple(left)


def too_many_at_hand(pieces: Iterable[PieceScene], left_out: Iterable[PieceScene]) -> UsageProblem:
    """Return what is said where pieces are left out of the picture that someone works on."""
    return UsageProblem(
        Message(
            "the set is made of {count} parts, more than the {most} that are drawn while you work: "
            "left out here, but not of what is exported: {names}",
            count=parts_of(pieces),
            most=MOST_AT_HAND,
            names=first_names(piece.name for piece in left_out),
        )
    )
