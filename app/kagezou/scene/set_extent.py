"""How many parts a set is made of, and how many can be drawn while someone works."""

from collections.abc import Iterable
from typing import Final

from kagezou.errors import UsageProblem
from kagezou.message import Message
from kagezou.scene.pieces import PieceScene

MOST_AT_HAND: Final = 250
"""So many parts are drawn while someone works; each hides and darkens every other, so twice as many take four times."""

_SHOWN: Final = 3


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
            names=_some([piece.name for piece in left_out]),
        )
    )


def _some(names: list[str]) -> str:
    return ", ".join(names[:_SHOWN]) + (", …" if len(names) > _SHOWN else "")
