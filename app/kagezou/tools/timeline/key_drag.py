"""Keys dragged along time: moved, or stretched about the farthest of them."""

from collections.abc import Generator
from dataclasses import dataclass
from typing import TypeAlias

from kagezou.document.address import track_of
from kagezou.document.key_edits import Refs, move_keys, stretch_keys
from kagezou.document.model import Document
from kagezou.message import Message
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
        Where the key under the hand is.
    caught_by
        The frame that caught it, if one did.
    note
        Why it is not where the hand is, or what else happened.
    """

    document: Document
    refs: Refs
    frame: int
    caught_by: int | None = None
    note: Message | None = None


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
        wanted, caught_by = snapped(grip.frame + pointer.frames_since(press), catching, pointer.cell_px)
        frame = _possible(grip, wanted)
        document, refs = _dragged(start, grip, frame)
        stopped = _stopped(grip) if frame != wanted else None
        gone = _key_count(start, grip) - _key_count(document, grip)
        replaced = Message("replaced keys: {count}", count=gone) if gone > 0 else None
        shown = DraggedKeys(document, refs, frame, None if stopped else caught_by, stopped or replaced)


def _possible(grip: KeyGrip, frame: int) -> int:
    """Return the frame nearest to the one wanted where the key can be: no key lies before the first frame."""
    first, about = min(ref.frame for ref in grip.refs), grip.stretches_about
    if about is None:
        return max(frame, grip.frame - first + 1)
    if grip.frame > about:
        return max(frame, about + 1)
    return min(max(frame, 1), about - 1)


def _stopped(grip: KeyGrip) -> Message:
    if grip.stretches_about is None:
        return Message("no key goes before the first frame")
    if grip.frame < grip.stretches_about:
        return Message("no key goes before the first frame, nor past the key that stays")
    return Message("it cannot go past the key that stays")


def _key_count(document: Document, grip: KeyGrip) -> int:
    return sum(len(track_of(document, address).keys) for address in {ref.address for ref in grip.refs})


def _dragged(start: Document, grip: KeyGrip, frame: int) -> tuple[Document, Refs]:
    about = grip.stretches_about
    if about is None:
        return move_keys(start, grip.refs, frame - grip.frame)
    return stretch_keys(start, grip.refs, about, (frame - about) / (grip.frame - about))
