"""Where a property lives in a document, and the paths people write for it (spec 6)."""

from collections.abc import Iterator
from dataclasses import dataclass

from kagezou.animation.track import Track, Value
from kagezou.document.model import Document, Tracks, drawing_offset
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER, OF_PIECE
from kagezou.document.property import AnyProperty, Usual
from kagezou.errors import UsageProblem
from kagezou.message import Message, nearest


@dataclass(frozen=True, slots=True)
class Address:
    """One property of the document, or of the layer or the set piece with an id."""

    property: AnyProperty
    layer_id: str | None = None
    piece_id: str | None = None


def resolve(document: Document, path: str) -> Address:
    """Return the address a path such as ``layers.A.shadow.opacity`` names; layer names may hold dots.

    Raises
    ------
    UsageProblem
        If there is no such layer or property, with the nearest path there is.
    """
    if path in OF_DOCUMENT:
        return Address(OF_DOCUMENT[path])
    for layer in document.layers:
        prefix = f"layers.{layer.name}."
        if path.startswith(prefix) and path.removeprefix(prefix) in OF_LAYER:
            return Address(OF_LAYER[path.removeprefix(prefix)], layer.id)
    for piece in document.pieces:
        prefix = f"set.{piece.name}."
        if path.startswith(prefix) and path.removeprefix(prefix) in OF_PIECE:
            return Address(OF_PIECE[path.removeprefix(prefix)], piece_id=piece.id)
    near = nearest(path, (path_of(document, address) for address in addresses(document)))
    if near is not None:
        raise UsageProblem(
            Message("there is no property {path!r} in this project; did you mean {near}?", path=path, near=near)
        )
    raise UsageProblem(Message("there is no property {path!r} in this project", path=path))


def path_of(document: Document, address: Address) -> str:
    """Return the path people write for an address."""
    if address.piece_id is not None:
        return f"set.{document.piece(address.piece_id).name}.{address.property.name}"
    if address.layer_id is None:
        return address.property.name
    return f"layers.{document.layer(address.layer_id).name}.{address.property.name}"


def addresses(document: Document) -> Iterator[Address]:
    """Yield every property of the document in table order, then those of its layers and set pieces."""
    for prop in OF_DOCUMENT.values():
        yield Address(prop)
    for layer in document.layers:
        for prop in OF_LAYER.values():
            yield Address(prop, layer.id)
    for piece in document.pieces:
        for prop in OF_PIECE.values():
            yield Address(prop, piece_id=piece.id)


def tracks_of(document: Document, address: Address) -> Tracks:
    """Return all tracks of the owner of an address."""
    if address.piece_id is not None:
        return document.piece(address.piece_id).tracks
    return document.tracks if address.layer_id is None else document.layer(address.layer_id).tracks


def track_of(document: Document, address: Address) -> Track:
    """Return the track at an address; a property that was never set has its usual value as its constant."""
    return tracks_of(document, address).get(address.property.name) or Track(usual_value(document, address))


def usual_value(document: Document, address: Address) -> Value:
    """Return what a property is while nobody has set it."""
    if address.property.usual is Usual.DEFAULT:
        return address.property.default
    middle = document.canvas.box.middle
    if address.property.usual is Usual.CANVAS_MIDDLE or address.layer_id is None:
        return middle
    left, top = drawing_offset(document.canvas, document.layer(address.layer_id))
    return (middle[0] - left, middle[1] - top)


def value_of(document: Document, address: Address, frame: float) -> Value:
    """Return the value at a frame."""
    return track_of(document, address).value_at(frame)
