"""Keys dragged along time: moved, or stretched about the farthest of them."""

from collections.abc import Generator
from dataclasses import dataclass
from typing import TypeAlias

from kagezou.document.key_edits import Refs, move_keys, stretch_keys
from kagezou.document.model import Document
from kagezou.tools.timeline.lane_pointer import LanePointer
from kagezou.tools.timeline.snapping import snapped


@dataclass(frozen=True, slots=True)
class KeyGrip:
    """What the hand has taken hold of: keys by one of them, with what they may catch on.

    Parameters
    ----------
    refs
        The keys.
    frame
        Of the key under the hand.
    catching
        The frames that catch, in order.
    stretches_about
        The frame that stays where it is; None where the keys move.
    """

    refs: Refs
    frame: int
    catching: tuple[int, ...]
    stretches_about: int | None = None


@dataclass(frozen=True, slots=True)
class DraggedKeys:
    """What a drag of keys shows.

    Parameters
    ----------
    document, refs
        The document, and the dragged keys in it.
    frame
        Where the key under the hand is wanted.
    caught_by
        The frame that caught it, if one did.
    """

    document: Document
    refs: Refs
    frame: int
    caught_by: int | None = None


KeyDrag: TypeAlias = Generator[DraggedKeys, LanePointer, None]
"""The first pointer sent is the press; each answer is what to show; ``close()`` cancels."""


def dragging_keys(start: Document, grip: KeyGrip) -> KeyDrag:
    """Return a drag that is ready for the press; every document is made of the one it began with."""
    drag = _drag(start, grip)
    next(drag)
    return drag


def _drag(start: Document, grip: KeyGrip) -> KeyDrag:
    shown = DraggedKeys(start, grip.refs, grip.frame)
    press = yield shown
    while True:
        pointer = yield shown
        catching = grip.catching if pointer.catches else ()
        frame, caught_by = snapped(grip.frame + pointer.frames_since(press), catching, pointer.cell_px)
        document, refs = _dragged(start, grip, frame)
        shown = DraggedKeys(document, refs, frame, caught_by)


def _dragged(start: Document, grip: KeyGrip, frame: int) -> tuple[Document, Refs]:
    about = grip.stretches_about
    if about is None:
        return move_keys(start, grip.refs, frame - grip.frame)
    return stretch_keys(start, grip.refs, about, (frame - about) / (grip.frame - about))
