"""Edits of the set: pieces come, go, change their names and their order."""

from collections.abc import Collection, Mapping
from dataclasses import replace
from itertools import count
from pathlib import Path

from kagezou.animation.track import Value
from kagezou.document.address import Address
from kagezou.document.edits import set_constant
from kagezou.document.figure_properties import UPRIGHT
from kagezou.document.model import Document, Piece
from kagezou.document.piece_kinds import TRAITS
from kagezou.document.properties import GROUND_POSITION, OF_PIECE
from kagezou.document.set_properties import (
    GROUND_RECEIVES,
    PIECE_DEPTH,
    PIECE_HEIGHT,
    PIECE_KIND,
    PIECE_POSITION,
    PIECE_WIDTH,
)
from kagezou.document.values import value_at
from kagezou.errors import UsageProblem
from kagezou.geometry.sets.measures import PieceKind
from kagezou.message import Message

MAX_PIECES = 200
TAKEN_NAME = "shadow"
"""``set.shadow`` is the shadow of the set itself."""

_BEHIND = 0.06
"""A new piece stands behind the ground line by this part of the canvas' height."""


def add_piece(
    document: Document,
    name: str,
    kind: str,
    values: Mapping[str, object] | None = None,
    source: Path | None = None,
) -> Document:
    """Put a piece into the set under a free name near ``name``, of a natural size behind the characters.

    Parameters
    ----------
    document, name
        Where and as what.
    kind
        One of the words of ``PieceKind``.
    values
        Constants that differ from that, by property name.
    source
        The file of an imported set.

    Raises
    ------
    UsageProblem
        If the name, the kind or a value is not valid, or there are too many pieces.
    """
    _check_name(name)
    if len(document.pieces) >= MAX_PIECES:
        raise UsageProblem(Message("a set has at most {most_pieces} pieces", most_pieces=MAX_PIECES))
    piece = Piece(_free_id(document), _free_name(document, name), source=source)
    document = replace(document, pieces=(*document.pieces, piece))
    first: dict[str, object] = {**_first_values(document, PieceKind(PIECE_KIND.canonical(kind))), **(values or {})}
    for each, raw in first.items():
        if each not in OF_PIECE:
            raise UsageProblem(Message("a set piece has no property {each!r}", each=each))
        document = set_constant(document, Address(OF_PIECE[each], piece_id=piece.id), raw)
    return document


def stood_up(document: Document, layer_ids: Collection[str] | None = None) -> Document:
    """Return the document whose figures stand up as its set does, but for those of which anybody said how they stand.

    A card parallel to the screen leans against what stands along the ground's normal: its head would lie behind a wall.

    Parameters
    ----------
    document
        With a set.
    layer_ids
        The layers of the figures; None for all.
    """
    for layer in document.layers:
        is_meant = layer_ids is None or layer.id in layer_ids
        if is_meant and layer.joins is None and UPRIGHT.name not in layer.tracks:
            document = set_constant(document, Address(UPRIGHT, layer.id), 1.0)
    return document


def stood_up_notes(before: Document, after: Document) -> tuple[Message, ...]:
    """Return what the user should know of figures that were stood up as the set is."""
    told = {layer.id for layer in before.layers if UPRIGHT.name in layer.tracks}
    names = [
        layer.name
        for layer in after.layers
        if layer.joins is None and layer.id not in told and UPRIGHT.name in layer.tracks
    ]
    if not names:
        return ()
    return (Message("{names}: standing upright now, as the set does", names=", ".join(names)),)


def remove_piece(document: Document, piece_id: str) -> Document:
    """Take a piece out of the set; with the last set from a file the flat ground comes back."""
    had_file = _has_file(document)
    document = replace(document, pieces=tuple(piece for piece in document.pieces if piece.id != piece_id))
    if had_file and not _has_file(document):
        return set_constant(document, Address(GROUND_RECEIVES), raw=True)
    return document


def rename_piece(document: Document, piece_id: str, name: str) -> Document:
    """Give a piece another name, which must be free and printable."""
    piece = document.piece(piece_id)
    if name == piece.name:
        return document
    _check_name(name)
    if any(other.name == name for other in document.pieces):
        raise UsageProblem(Message("there is already a set piece named {name!r}", name=name))
    changed = replace(piece, name=name)
    return replace(document, pieces=tuple(changed if each.id == piece_id else each for each in document.pieces))


def copy_piece(document: Document, piece_id: str) -> Document:
    """Put a second piece of the same properties into the set, under a free name."""
    piece = document.piece(piece_id)
    if len(document.pieces) >= MAX_PIECES:
        raise UsageProblem(Message("a set has at most {most_pieces} pieces", most_pieces=MAX_PIECES))
    twin = replace(piece, id=_free_id(document), name=_free_name(document, piece.name))
    return replace(document, pieces=(*document.pieces, twin))


def _first_values(document: Document, kind: PieceKind) -> dict[str, Value]:
    canvas = document.canvas
    side = min(canvas.width_px, canvas.height_px)
    x, y = value_at(document.tracks, GROUND_POSITION, 1)
    sizes = TRAITS[kind].first_sizes
    if sizes is None:
        return {PIECE_KIND.name: kind.value, PIECE_POSITION.name: (x, y)}
    width, height, depth = (max(part * side, 1.0) for part in sizes.of_canvas)
    return {
        PIECE_KIND.name: kind.value,
        PIECE_POSITION.name: (x, max(y - _BEHIND * canvas.height_px, PIECE_POSITION.low)),
        PIECE_WIDTH.name: width,
        PIECE_HEIGHT.name: height,
        PIECE_DEPTH.name: depth,
    }


def _has_file(document: Document) -> bool:
    return any(piece.source is not None for piece in document.pieces)


def _check_name(name: str) -> None:
    if not name.strip() or not name.isprintable() or len(name) > 200:
        raise UsageProblem(
            Message("a set piece cannot be named {name!r}: a name is 1 to 200 printable characters", name=name[:60])
        )
    if name == TAKEN_NAME:
        raise UsageProblem(
            Message("a set piece cannot be named {name!r}: set.{name} is the shadow of the whole set", name=name)
        )


def _free_name(document: Document, name: str) -> str:
    taken = {piece.name for piece in document.pieces}
    return next(each for each in (name, *(f"{name} {n}" for n in range(2, len(taken) + 3))) if each not in taken)


def _free_id(document: Document) -> str:
    taken = {piece.id for piece in document.pieces}
    return next(each for each in (f"piece-{n}" for n in count(1)) if each not in taken)
