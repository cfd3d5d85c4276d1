"""Which curves there are: one for each component of each keyed property of the scene and of what is worked on."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import partial

from kagezou.animation.curve import component_count
from kagezou.animation.track import Track
from kagezou.document.address import Address, track_of
from kagezou.document.linking import is_linked
from kagezou.document.model import Document, Layer, Piece
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER, OF_PIECE
from kagezou.document.property import Kind
from kagezou.document.remembered import Remembered

COLORS = ("#56b4e9", "#e69f00", "#009e73", "#cc79a7", "#d0d0d0", "#d55e00", "#8fb8ff", "#b9d46a")
"""Colours that are told apart with every kind of eyes; none of them is the yellow of what is selected."""

_PLACES = ("x", "y", "z")


@dataclass(frozen=True, slots=True)
class Curve:
    """One component of one property.

    Parameters
    ----------
    address, component
        What it shows.
    name
        The component's own name, empty where there is only one.
    number
        Its place among all curves, which chooses its colour and its dashes.
    """

    address: Address
    component: int
    name: str
    number: int

    @property
    def color(self) -> str:
        """Its colour."""
        return COLORS[self.number % len(COLORS)]


def curves_of(
    document: Document,
    layer_id: str | None,
    piece_id: str | None = None,
    others: tuple[str, ...] = (),
    counts: Remembered[int] | None = None,
) -> tuple[Curve, ...]:
    """Return the curves of the scene's keyed properties and of a layer's or a set piece's, in table order.

    Parameters
    ----------
    document, layer_id, piece_id
        What is worked on.
    others
        The layers that are chosen beside it; a property that is linked has its curves once.
    counts
        How many components tracks have, kept by whoever asks after each small edit: all keys have to be looked at.
    """
    counts = Remembered(1) if counts is None else counts
    curves: list[Curve] = []
    more = (address for other in others for address in _ever_set(document, other, None))
    apart = (address for address in more if not is_linked(document, address))
    own = () if layer_id is None and piece_id is None else _ever_set(document, layer_id, piece_id)
    for address in (*_ever_set(document, None, None), *own, *apart):
        track = track_of(document, address)
        if not track.is_keyed or address.property.holds_only:
            continue
        count = counts.of((track,), partial(component_count, track))
        curves += [
            Curve(address, component, _name(address, component, count), len(curves) + component)
            for component in range(count)
        ]
    return tuple(curves)


def same_in(document: Document, curve: Curve, own: Document) -> Track | None:
    """Return the track of a curve in another version of its document; None where that has no such property.

    A layer or a set piece is the same if it has the same id, else if it has the same name.
    """
    layer_id, piece_id = curve.address.layer_id, curve.address.piece_id
    if layer_id is not None:
        layer = _same(document.layers, layer_id, own.layer(layer_id).name)
        return None if layer is None else track_of(document, Address(curve.address.property, layer))
    if piece_id is not None:
        piece = _same(document.pieces, piece_id, own.piece(piece_id).name)
        return None if piece is None else track_of(document, Address(curve.address.property, piece_id=piece))
    return track_of(document, curve.address)


def _same(those: Iterable[Layer | Piece], known_id: str, name: str) -> str | None:
    """Return the id of the one with the same id, else with the same name."""
    ids = {each.id: each.name for each in those}
    return known_id if known_id in ids else next((each for each, called in ids.items() if called == name), None)


def _ever_set(document: Document, layer_id: str | None, piece_id: str | None) -> Iterator[Address]:
    """Yield the properties of the scene, a layer or a piece that have a track, in table order; others have no keys."""
    if piece_id is not None:
        table, tracks = OF_PIECE, document.piece(piece_id).tracks
    elif layer_id is not None:
        table, tracks = OF_LAYER, document.layer(layer_id).tracks
    else:
        table, tracks = OF_DOCUMENT, document.tracks
    for name, prop in table.items():
        if name in tracks:
            yield Address(prop, layer_id, piece_id)


def _name(address: Address, component: int, count: int) -> str:
    match address.property.kind:
        case Kind.COLOR:
            return "RGB"[component]
        case Kind.POINTS:
            return f"{component // 2 + 1}{_PLACES[component % 2]}"
        case _:
            return _PLACES[component] if count > 1 else ""
