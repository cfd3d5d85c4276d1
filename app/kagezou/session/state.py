"""What is seen and selected of a document, as one value, kept to what the document has."""

from dataclasses import dataclass

from kagezou.document.address import Address
from kagezou.document.key_edits import Refs, present_keys
from kagezou.document.model import Document


@dataclass(frozen=True, slots=True)
class State:
    """What is seen and selected.

    Parameters
    ----------
    document
        The document now.
    frame
        The frame looked at, from 1.
    layer_id
        The layer worked on; None while a set piece is.
    selection
        Selected properties.
    keys
        Selected keys; every one of them is there.
    piece_id
        The set piece worked on.
    others
        The layers that are chosen beside ``layer_id`` and edited with it.
    """

    document: Document
    frame: int = 1
    layer_id: str | None = None
    selection: tuple[Address, ...] = ()
    keys: Refs = frozenset()
    piece_id: str | None = None
    others: frozenset[str] = frozenset()


def same(a: State, b: State) -> bool:
    """Whether two states look alike; documents are compared by identity, which an edit always changes."""
    return a.document is b.document and _looked_at(a) == _looked_at(b)


def _looked_at(state: State) -> tuple[object, ...]:
    return state.frame, state.layer_id, state.selection, state.keys, state.piece_id, state.others


def within(state: State, before: State) -> State:
    """Return the state with its frame and selection kept to what the document has, as the one before it was."""
    document = state.document
    ids, pieces = {layer.id for layer in document.layers}, {piece.id for piece in document.pieces}
    piece_id = state.piece_id if state.piece_id in pieces else None
    layer_id = state.layer_id if state.layer_id in ids else None
    if piece_id is None and layer_id is None and document.layers:
        layer_id = document.layers[-1].id
    selection = tuple(
        address
        for address in state.selection
        if address.layer_id in (None, *ids) and address.piece_id in (None, *pieces)
    )
    frame = min(max(state.frame, 1), document.canvas.length_frames)
    others = frozenset() if layer_id is None else state.others & (ids - {layer_id})
    # Of very many selected keys each look takes long, and only another document or selection can lack some.
    are_there = document is before.document and state.keys is before.keys
    keys = state.keys if are_there else present_keys(document, state.keys)
    return State(document, frame, layer_id, selection, keys, piece_id, others)
