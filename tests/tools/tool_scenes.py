"""Documents and hands for the tests of tools; no file is touched."""

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from kagezou.document import properties
from kagezou.document.address import Address, value_of
from kagezou.document.edits import add_layer, set_constant
from kagezou.document.invariants import check
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.document.property import AnyProperty, Scope
from kagezou.document.set_pieces import add_piece
from kagezou.geometry.box import Box
from kagezou.geometry.vectors import Point2
from kagezou.tools.handle import Handle, HandleSet
from kagezou.tools.handles import drag_of, handles_of
from kagezou.tools.pointer import Modifiers, Pointer
from kagezou.tools.view import CanvasView

FIGURE = Box(400, 200, 600, 900)
LAYER = "layer-1"
PIECE = "piece-1"
"""Handles of a set piece are those of this one."""
FREE = Modifiers(snap=False)
UNZOOMED = CanvasView()


def document_with(*settings: tuple[AnyProperty, object]) -> Document:
    """Return one figure of 200x700 px standing on the ground at (500, 900), and any properties set."""
    cels = Cels((Drawing("1", Path("1.png")),), (Exposure(1, 0),))
    document = add_layer(Document(Canvas(1000, 1000, length_frames=24)), "A", cels, FIGURE)
    for prop, raw in ((properties.GROUND_POSITION, (500.0, 900.0)), *settings):
        document = set_constant(document, address(prop), raw)
    check(document)
    return document


def address(prop: AnyProperty) -> Address:
    if prop.scope is Scope.PIECE:
        return Address(prop, piece_id=PIECE)
    return Address(prop, LAYER if prop.scope is Scope.LAYER else None)


def with_piece(document: Document, kind: str, **values: object) -> Document:
    """Return the document with a set piece, the first one."""
    document = add_piece(document, "Piece", kind, values)
    check(document)
    return document


def handles(document: Document, view: CanvasView | None = None, frame: int = 1, *, of_piece: bool = False) -> HandleSet:
    """Return what is seen while the layer or the piece is worked on."""
    worked_on = (None, PIECE) if of_piece else (LAYER, None)
    return handles_of(document, frame, worked_on[0], view or CanvasView(), worked_on[1])


def value(document: Document, prop: AnyProperty, frame: int = 1) -> object:
    return value_of(document, address(prop), frame)


def number(document: Document, prop: AnyProperty, frame: int = 1) -> float:
    found = value(document, prop, frame)
    assert isinstance(found, float)
    return found


def place(document: Document, prop: AnyProperty = properties.LIGHT_POSITION) -> tuple[float, ...]:
    found = value(document, prop)
    assert isinstance(found, tuple)
    return tuple(part for part in found if isinstance(part, float))


def handle(document: Document, handle_id: str, view: CanvasView | None = None, frame: int = 1) -> Handle:
    found = handles(document, view, frame, of_piece=handle_id.startswith("piece.")).find(handle_id)
    assert found is not None, handle_id
    return found


@dataclass
class Hand:
    """A hand on one handle; every document it gets is checked."""

    document: Document
    handle_id: str
    view: CanvasView = UNZOOMED
    grab_offset: Point2 = (0.0, 0.0)
    frame: int = 1

    def __post_init__(self) -> None:
        self.handle = handle(self.document, self.handle_id, self.view, self.frame)
        self.drag = drag_of(self.handle, self.document, self.frame, self.view)
        assert self.drag.send(self._pointer((0.0, 0.0), FREE)) is self.document

    def to(self, dx: float, dy: float, modifiers: Modifiers = FREE) -> Document:
        """Move the hand to so many canvas px from where it pressed."""
        document = self.drag.send(self._pointer((dx, dy), modifiers))
        check(document)
        return document

    def through(self, offsets: Iterable[Point2], modifiers: Modifiers = FREE) -> Document:
        """Move the hand through several places."""
        document = self.document
        for dx, dy in offsets:
            document = self.to(dx, dy, modifiers)
        return document

    def _pointer(self, offset: Point2, modifiers: Modifiers) -> Pointer:
        x, y = (sum(parts) for parts in zip(self.handle.canvas_px, self.grab_offset, offset, strict=True))
        return Pointer(self.view.view_from_canvas((x, y)), (x, y), modifiers)
