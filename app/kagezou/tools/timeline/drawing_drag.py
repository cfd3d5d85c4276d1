"""Drawings dragged along time: held longer or shorter by their ends, or moved by their middle."""

from collections.abc import Generator
from dataclasses import dataclass
from enum import StrEnum
from typing import TypeAlias

from kagezou.document.edits import set_exposures
from kagezou.document.exposure_edits import (
    Exposures,
    end_at,
    move_boundary,
    move_run,
    ripple,
    room_of_boundary,
    room_of_run,
)
from kagezou.document.model import Document
from kagezou.message import Message
from kagezou.tools.timeline.lane_pointer import LanePointer
from kagezou.tools.timeline.snapping import snap_frames, snapped


class BarPart(StrEnum):
    """What of an exposure can be taken hold of."""

    START = "start"
    MIDDLE = "middle"
    END = "end"


@dataclass(frozen=True, slots=True)
class DrawingGrip:
    """What the hand has taken hold of, with the exposures as they were and the frames that catch.

    Parameters
    ----------
    layer_id
        Whose exposures they are.
    part
        What of the first one.
    index, last
        The first and the last one that are moved.
    exposures
        All of the layer.
    length_frames
        Of the cut.
    catching
        The frames that catch, in order.
    """

    layer_id: str
    part: BarPart
    index: int
    last: int
    exposures: Exposures
    length_frames: int
    catching: tuple[int, ...] = ()

    @property
    def frame(self) -> int:
        """Where what is dragged lay."""
        if self.part is BarPart.END and self.index + 1 < len(self.exposures):
            return self.exposures[self.index + 1].frame
        return max(self.exposures[self.index].frame, 1)

    @property
    def edge(self) -> int:
        """The same, for the end of the last exposure behind the cut."""
        last_of_cut = self.part is BarPart.END and self.index + 1 == len(self.exposures)
        return self.length_frames + 1 if last_of_cut else self.frame


@dataclass(frozen=True, slots=True)
class DraggedDrawings:
    """What a drag of drawings shows.

    Parameters
    ----------
    document
        With the exposures in it; the cut is as long as it was.
    exposures
        To be put into the document with :func:`with_exposures` when the hand lets go: then the cut grows too, which
        before that would move the frames under the hand.
    frame
        Where the dragged edge is.
    caught_by
        The frame that caught it, if one did.
    note
        Why the edge is not where the hand is.
    """

    document: Document
    exposures: Exposures
    frame: int
    caught_by: int | None = None
    note: Message | None = None


DrawingDrag: TypeAlias = Generator[DraggedDrawings, LanePointer, None]
"""The first pointer sent is the press; each answer is what to show; ``close()`` cancels."""


def grip_on(document: Document, playhead: int, layer_id: str, part: BarPart, run: tuple[int, int]) -> DrawingGrip:
    """Return the grip on a run of exposures (first, last) by a part of the first one; what it drags catches nothing."""
    exposures, length = document.layer(layer_id).cels.exposures, document.canvas.length_frames
    first, last = run
    bare = DrawingGrip(layer_id, part, first, last, exposures, length)
    own = {exposures[each].frame for each in range(first, last + 1)} | {bare.frame}
    frames = (*snap_frames(document, playhead), length + 1)
    catching = tuple(sorted(frame for frame in frames if frame not in own))
    return DrawingGrip(layer_id, part, first, last, exposures, length, catching)


def dragging_drawings(start: Document, grip: DrawingGrip) -> DrawingDrag:
    """Return a drag that is ready for the press; every document is made of the one it began with."""
    drag = _drag(start, grip)
    next(drag)
    return drag


def _drag(start: Document, grip: DrawingGrip) -> DrawingDrag:
    shown = DraggedDrawings(start, grip.exposures, grip.edge)
    press = yield shown
    while True:
        pointer = yield shown
        catching = grip.catching if pointer.catches else ()
        wanted, caught_by = snapped(grip.edge + pointer.frames_since(press), catching, pointer.cell_px)
        frame = wanted if pointer.ripples or pointer.goes_over else _within_room(grip, wanted)
        exposures = _dragged(grip, frame, ripples=pointer.ripples)
        caught_by = caught_by if frame == wanted else None
        document = set_exposures(start, grip.layer_id, exposures)
        shown = DraggedDrawings(document, exposures, frame, caught_by, _stopped(grip) if frame != wanted else None)


def _within_room(grip: DrawingGrip, frame: int) -> int:
    """Return the frame nearest to the one wanted at which every neighbour is still seen."""
    exposures, length = grip.exposures, grip.length_frames
    if grip.part is BarPart.MIDDLE:
        least, most = room_of_run(exposures, grip.index, grip.last, length)
        return max(frame, least) if most is None else min(max(frame, least), most)
    boundary = grip.index + 1 if grip.part is BarPart.END else grip.index
    if boundary == len(exposures):
        return min(max(frame, max(exposures[-1].frame, 1) + 1), length + 1)
    least, most = room_of_boundary(exposures, boundary, length)
    return min(max(frame, least), most)


def _stopped(grip: DrawingGrip) -> Message:
    if grip.part is BarPart.END and grip.index + 1 == len(grip.exposures):
        return Message("the cut ends here")
    return Message("stops at its neighbour; Alt or A goes over it")


def _dragged(grip: DrawingGrip, frame: int, *, ripples: bool) -> Exposures:
    match grip.part:
        case BarPart.MIDDLE if not ripples:
            return move_run(grip.exposures, grip.index, grip.last, frame)
        case BarPart.END:
            if grip.index + 1 == len(grip.exposures) and frame > grip.length_frames:
                return grip.exposures
            return end_at(grip.exposures, grip.index, frame, ripples=ripples)
        case _:
            return (ripple if ripples else move_boundary)(grip.exposures, grip.index, frame)
