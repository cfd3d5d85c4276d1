"""Keys, handles and speeds dragged on the graph."""

from collections.abc import Callable, Generator
from dataclasses import dataclass
from typing import TypeAlias

from kagezou.document.address import Address
from kagezou.document.key_edits import Refs, move_keys
from kagezou.document.model import Document
from kagezou.tools.curves.graph_edits import with_handle, with_speed
from kagezou.tools.curves.graph_pointer import GraphPointer
from kagezou.tools.curves.picture import CurvePicture, GraphKind, HandleMark, KeyMark


@dataclass(frozen=True, slots=True)
class CurveGrip:
    """What the hand has taken hold of: a mark of a curve, and the keys that go with it."""

    picture: CurvePicture
    mark: KeyMark | HandleMark
    refs: Refs


@dataclass(frozen=True, slots=True)
class DraggedCurves:
    """What a drag on the graph shows: the document, and the keys to be selected in it; None leaves them as they are."""

    document: Document
    refs: Refs | None = None


CurveDrag: TypeAlias = Generator[DraggedCurves, GraphPointer, None]
"""The first pointer sent is the press; each answer is what to show; ``close()`` cancels."""

_Move: TypeAlias = Callable[[Document, GraphPointer, GraphPointer], DraggedCurves]
"""Makes of the document at the press, the press and the pointer what to show."""


def dragging_curve(start: Document, grip: CurveGrip, kind: GraphKind) -> CurveDrag:
    """Return a drag that is ready for the press; every document is made of the one it began with."""
    drag = _drag(start, _move_of(grip, kind))
    next(drag)
    return drag


def _drag(start: Document, move: _Move) -> CurveDrag:
    shown = DraggedCurves(start)
    press = yield shown
    while True:
        pointer = yield shown
        shown = move(start, press, pointer)


def _move_of(grip: CurveGrip, kind: GraphKind) -> _Move:
    picture, mark = grip.picture, grip.mark

    def handle(start: Document, _press: GraphPointer, pointer: GraphPointer) -> DraggedCurves:
        assert isinstance(mark, HandleMark)
        return DraggedCurves(with_handle(start, picture, mark, pointer.place, joined=not pointer.alone))

    def speed(start: Document, _press: GraphPointer, pointer: GraphPointer) -> DraggedCurves:
        assert isinstance(mark, KeyMark)
        return DraggedCurves(with_speed(start, picture, mark, pointer.place[1]))

    def keys(start: Document, press: GraphPointer, pointer: GraphPointer) -> DraggedCurves:
        away = pointer.since(press)
        frames, ordinates = round(away[0]), away[1]
        if pointer.one_axis:
            across, down = (abs(now - then) for now, then in zip(pointer.view_px, press.view_px, strict=True))
            frames, ordinates = (frames, 0.0) if across >= down else (0, ordinates)
        return DraggedCurves(*move_keys(start, grip.refs, frames, _amounts(picture, ordinates)))

    if isinstance(mark, HandleMark):
        return handle
    return speed if kind is GraphKind.SPEED else keys


def _amounts(picture: CurvePicture, ordinates: float) -> dict[Address, tuple[float, ...]]:
    amount = ordinates / picture.fitting.factor
    return {picture.curve.address: (0.0,) * picture.curve.component + (amount,)}
