"""What is said to receive shadows while none can fall on it, and shadows that nothing receives."""

from collections.abc import Iterator

from kagezou.document.figure_properties import SHAPE
from kagezou.document.model import Document, Layer
from kagezou.document.properties import RECEIVES, VISIBLE
from kagezou.document.set_properties import GROUND_RECEIVES, PIECE_RECEIVES
from kagezou.document.values import values_ever
from kagezou.message import Message


def idle_receivers(document: Document) -> Iterator[tuple[str, Message]]:
    """Yield the id of a layer, and what is to be known of what falls on it or of where its shadow could fall."""
    casting = [layer for layer in document.layers if layer.joins is None and _ever_casts_on_others(layer)]
    for layer in document.layers:
        if not any(values_ever(layer.tracks, RECEIVES)):
            continue
        figure = layer.joins or layer.id
        if not any(other.id != figure for other in casting):
            yield (
                layer.id,
                Message(
                    "{layer}: receives is on, but there is no other character whose shadow could fall on it",
                    layer=layer.name,
                ),
            )
    if document.layers and not _anything_receives(document):
        yield (
            document.layers[0].id,
            Message("no shadow is seen: ground.receives is off, and no set piece receives"),
        )


def _ever_casts_on_others(layer: Layer) -> bool:
    """Whether a figure is ever seen with a shadow that follows the light; discs lie on the ground alone."""
    return (
        bool(layer.cels.exposures)
        and any(values_ever(layer.tracks, VISIBLE))
        and "cast" in values_ever(layer.tracks, SHAPE)
    )


def _anything_receives(document: Document) -> bool:
    return any(values_ever(document.tracks, GROUND_RECEIVES)) or any(
        any(values_ever(piece.tracks, PIECE_RECEIVES)) for piece in document.pieces
    )
