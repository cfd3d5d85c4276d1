"""The frame around the selected keys dragged: inside it moves them, its edges and corners scale them."""

from collections.abc import Generator
from dataclasses import dataclass
from typing import TypeAlias

from kagezou.document.address import Address
from kagezou.document.key_edits import Refs, move_keys
from kagezou.document.model import Document
from kagezou.document.scale_edits import UNSCALED, Scaling, scale_keys
from kagezou.tools.curves.graph_pointer import GraphPointer
from kagezou.tools.curves.key_box import BoxGrip, KeyBox
from kagezou.tools.curves.picture import CurvePicture


@dataclass(frozen=True, slots=True)
class MovedBy:
    """How far keys were moved; ``amount`` is in their own unit, None where they have several."""

    frames: int
    amount: float | None


@dataclass(frozen=True, slots=True)
class ScaledBy:
    """How many times as far apart keys lie, in time and in value; None where they were not scaled that way."""

    time: float | None
    value: float | None


@dataclass(frozen=True, slots=True)
class DraggedBox:
    """What a drag of the frame shows: the document, the keys in it, and what was done to them."""

    document: Document
    refs: Refs
    change: MovedBy | ScaledBy


BoxDrag: TypeAlias = Generator[DraggedBox, GraphPointer, None]
"""The first pointer sent is the press; each answer is what to show; ``close()`` cancels."""


def dragging_box(start: Document, box: KeyBox, part: BoxGrip, pictures: tuple[CurvePicture, ...]) -> BoxDrag:
    """Return a drag that is ready for the press; every document is made of the one it began with.

    Parameters
    ----------
    start
        The document.
    box, part
        The frame as it is, and what was taken hold of.
    pictures
        The curves as they are.
    """
    chosen = tuple(picture for picture in pictures if any(mark.is_chosen for mark in picture.keys))
    drag = _drag(start, _Held(box, part, chosen))
    next(drag)
    return drag


@dataclass(frozen=True, slots=True)
class _Held:
    """The frame as it was, the part of it that is held, and the curves with selected keys."""

    box: KeyBox
    part: BoxGrip
    pictures: tuple[CurvePicture, ...]

    @property
    def refs(self) -> Refs:
        """The selected keys."""
        return frozenset(mark.ref for picture in self.pictures for mark in picture.keys if mark.is_chosen)


def _drag(start: Document, held: _Held) -> BoxDrag:
    shown = DraggedBox(start, held.refs, MovedBy(0, None))
    press = yield shown
    while True:
        pointer = yield shown
        away = pointer.since(press)
        shown = _moved(start, held, away, pointer) if held.part.is_inside else _scaled(start, held, away, pointer)


def _scaled(start: Document, held: _Held, away: tuple[float, float], pointer: GraphPointer) -> DraggedBox:
    part = held.part
    along, up = _scalings(held, away, about_centre=pointer.about_centre)
    if pointer.one_axis and part.across and part.up:
        factor = max(along.factor, up.factor, key=lambda each: abs(each - 1))
        along, up = Scaling(along.about, factor), Scaling(up.about, factor)
    document, refs = scale_keys(start, held.refs, along, _in_own_units(held, up))
    return DraggedBox(document, refs, ScaledBy(along.factor if part.across else None, up.factor if part.up else None))


def _scalings(held: _Held, away: tuple[float, float], *, about_centre: bool) -> tuple[Scaling, Scaling]:
    part = held.part
    edge = held.box.edge_of(part)
    fixed = held.box.edge_of(BoxGrip(0, 0) if about_centre else BoxGrip(-part.across, -part.up))
    scalings = []
    for side, at, about, more in zip((part.across, part.up), edge, fixed, away, strict=True):
        reach = at - about
        scalings.append(Scaling(about, (reach + more) / reach) if side and reach else UNSCALED)
    along, up = scalings
    return (Scaling(along.about, max(along.factor, 0.0)) if part.across else UNSCALED), up


def _in_own_units(held: _Held, up: Scaling) -> dict[tuple[Address, int], Scaling]:
    """Return the scaling of ordinates as scalings of each curve's own values."""
    if up is UNSCALED:
        return {}
    return {
        (picture.curve.address, picture.curve.component): Scaling(picture.fitting.from_graph(up.about), up.factor)
        for picture in held.pictures
    }


def _moved(start: Document, held: _Held, away: tuple[float, float], pointer: GraphPointer) -> DraggedBox:
    frames, ordinates = round(away[0]), away[1]
    if pointer.one_axis:
        across_px, up_px = abs(away[0] * held.box.frame_px), abs(away[1] * held.box.unit_px)
        frames, ordinates = (frames, 0.0) if across_px >= up_px else (0, ordinates)
    amounts: dict[Address, tuple[float, ...]] = {}
    for picture in held.pictures:
        before = amounts.get(picture.curve.address, ())
        padding = (0.0,) * (picture.curve.component - len(before))
        amounts[picture.curve.address] = (*before, *padding, ordinates / picture.fitting.factor)
    factors = {picture.fitting.factor for picture in held.pictures}
    change = MovedBy(frames, ordinates / next(iter(factors)) if len(factors) == 1 else None)
    return DraggedBox(*move_keys(start, held.refs, frames, amounts), change)
