"""The receivers of a set: the ground and every piece, whose mattes let shadows be treated apart there."""

from dataclasses import dataclass

from kagezou.document.model import Document
from kagezou.export.names import safe_names
from kagezou.export.subjects import GROUND, ReceiverSubject


@dataclass(frozen=True, slots=True)
class Receiver:
    """The ground or a set piece, and what its files are called after."""

    subject: ReceiverSubject
    name: str


def receivers_of(document: Document) -> tuple[Receiver, ...]:
    """Return the ground and every piece of a document."""
    names = safe_names((GROUND, *(piece.name for piece in document.pieces if piece.name != GROUND)))
    taken = set(names.values())
    of_piece = {piece.id: names[piece.name] for piece in document.pieces if piece.name != GROUND}
    for piece in document.pieces:
        if piece.name == GROUND:
            number = next(each for each in range(2, len(taken) + 3) if f"{GROUND}_{each}" not in taken)
            of_piece[piece.id] = f"{GROUND}_{number}"
    pieces = (Receiver(ReceiverSubject(piece.id), of_piece[piece.id]) for piece in document.pieces)
    return (Receiver(ReceiverSubject(None), names[GROUND]), *pieces)
