"""The receivers of a set as mattes: where the ground and every piece are seen, to treat shadows apart there."""

from dataclasses import dataclass, replace
from typing import Final

from kagezou.document.model import Document
from kagezou.document.set_properties import GROUND_RECEIVES
from kagezou.document.values import value_at
from kagezou.export.names import safe_names
from kagezou.scene.pieces import SetCast
from kagezou.scene.scene import Scene

GROUND: Final = "ground"


@dataclass(frozen=True, slots=True)
class ReceiverContent:
    """All that decides a matte of a receiver, but its size and format.

    Parameters
    ----------
    cast
        Without lights. The piece that casts is the receiver; where none does, the ground is.
    """

    cast: SetCast


@dataclass(frozen=True, slots=True)
class Receiver:
    """The ground, or a set piece by its id, and the name of its folder and files."""

    piece_id: str | None
    label: str


def receivers_of(document: Document) -> tuple[Receiver, ...]:
    """Return the ground and every piece of a document."""
    names = safe_names((GROUND, *(piece.name for piece in document.pieces if piece.name != GROUND)))
    taken = set(names.values())
    of_piece = {piece.id: names[piece.name] for piece in document.pieces if piece.name != GROUND}
    for piece in document.pieces:
        if piece.name == GROUND:
            number = next(each for each in range(2, len(taken) + 3) if f"{GROUND}_{each}" not in taken)
            of_piece[piece.id] = f"{GROUND}_{number}"
    pieces = (Receiver(piece.id, f"{of_piece[piece.id]}_matte") for piece in document.pieces)
    return (Receiver(None, f"{names[GROUND]}_matte"), *pieces)


def receiver_content(document: Document, scene: Scene, frame: int, receiver: Receiver) -> ReceiverContent | None:
    """Return what is to be drawn of a receiver on a frame; None where it is not there."""
    has_ground = value_at(document.tracks, GROUND_RECEIVES, frame)
    pieces = tuple(
        replace(piece, casts=piece.id == receiver.piece_id, blocks=False, receives=False) for piece in scene.pieces
    )
    there = has_ground if receiver.piece_id is None else any(piece.casts for piece in pieces)
    return ReceiverContent(SetCast(scene.camera, scene.ground, pieces, (), has_ground)) if there else None
