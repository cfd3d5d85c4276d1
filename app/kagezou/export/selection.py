"""What of a document a request asks for: its frames and layers, and what they ever do."""

from kagezou.document import properties
from kagezou.document.companion_properties import CONTACT_STRENGTH, REFLECTION_OPACITY
from kagezou.document.layer_named import no_layer
from kagezou.document.model import Document, Layer
from kagezou.document.piece_kinds import kind_of
from kagezou.document.property import Property
from kagezou.document.set_properties import PIECE_CASTS, PIECE_DISPLAY, PIECE_UNDER
from kagezou.document.values import value_at, values_ever
from kagezou.errors import UsageProblem
from kagezou.export.request import ExportRequest
from kagezou.geometry.sets.measures import PieceKind
from kagezou.message import Message


def chosen_frames(document: Document, request: ExportRequest) -> tuple[int, ...]:
    """Return the frames that are asked for, upward.

    Raises
    ------
    UsageProblem
        One of them is not in the cut.
    """
    length = document.canvas.length_frames
    if request.frames is None:
        return tuple(range(1, length + 1))
    beyond = [frame for frame in request.frames if not 1 <= frame <= length]
    if beyond:
        raise UsageProblem(
            Message("frame {frame} is not in the cut, which has frames 1-{length}", frame=beyond[0], length=length)
        )
    if not request.frames:
        raise UsageProblem(Message("frame none is not in the cut, which has frames 1-{length}", length=length))
    return tuple(sorted(set(request.frames)))


def chosen_layers(document: Document, request: ExportRequest) -> tuple[Layer, ...]:
    """Return the layers that are asked for, from the bottom; without names, those that are ever visible.

    Raises
    ------
    UsageProblem
        There is no layer of a name.
    """
    if request.layers is None:
        return tuple(layer for layer in document.layers if _is_ever_visible(layer))
    by_name = {layer.name: layer for layer in document.layers}
    for name in request.layers:
        if name not in by_name:
            raise UsageProblem(no_layer(name, tuple(by_name)))
    return tuple(layer for layer in document.layers if layer.name in request.layers)


def with_shadows(document: Document, request: ExportRequest) -> tuple[Layer, ...]:
    """Return those of the layers asked for that have a shadow: a part of a figure shares that of its figure.

    Raises
    ------
    UsageProblem
        There is no layer of a name, or only parts of figures are named.
    """
    layers = chosen_layers(document, request)
    figures = tuple(layer for layer in layers if layer.joins is None)
    if layers and not figures and request.layers is not None:
        part, figure = layers[0], document.layer(layers[0].joins or layers[0].id)
        raise UsageProblem(
            Message(
                "{part} is a part of {figure} and has no shadow of its own; please ask for {figure}",
                part=part.name,
                figure=figure.name,
            )
        )
    return figures


def ever_receives(layer: Layer) -> bool:
    """Return whether a layer receives the shadows of others at any time."""
    return any(values_ever(layer.tracks, properties.RECEIVES))


def received_ways(document: Document, layer: Layer) -> tuple[bool, ...]:
    """Return how what others cast on a layer is laid at any time, the lower first: True for by multiplying.

    Nothing for a layer that receives nothing.
    """
    if not ever_receives(layer):
        return ()
    figure = layer.joins or layer.id
    others = (each for each in document.layers if each.joins is None and each.id != figure)
    blends = {value == "multiply" for each in others for value in values_ever(each.tracks, properties.BLEND)}
    return tuple(each for each in (True, False) if each in blends) or (True,)


def ever_has_contact(layer: Layer) -> bool:
    """Return whether a figure has patches under its feet at any time; a part of another's has none."""
    return layer.joins is None and _is_ever_over_0(layer, CONTACT_STRENGTH)


def ever_is_mirrored(layer: Layer) -> bool:
    """Return whether a figure is mirrored in the ground at any time; a part of another's is with that."""
    return layer.joins is None and _is_ever_over_0(layer, REFLECTION_OPACITY)


def set_ever_casts(document: Document) -> bool:
    """Return whether any piece of the set casts a shadow at any time."""
    return any(value for piece in document.pieces for value in values_ever(piece.tracks, PIECE_CASTS))


def ever_clay(document: Document) -> tuple[bool, ...]:
    """Return where sets are drawn as clay at any time: True for under the background picture, then False for over."""
    seen = {
        value_at(piece.tracks, PIECE_UNDER, frame)
        for piece in document.pieces
        if piece.source is not None
        for frame in range(1, document.canvas.length_frames + 1)
        if kind_of(piece, frame) is PieceKind.MESH and value_at(piece.tracks, PIECE_DISPLAY, frame) == "clay"
    }
    return tuple(each for each in (True, False) if each in seen)


def _is_ever_visible(layer: Layer) -> bool:
    return any(values_ever(layer.tracks, properties.VISIBLE))


def _is_ever_over_0(layer: Layer, prop: Property[float]) -> bool:
    return any(isinstance(value, float) and value > 0 for value in values_ever(layer.tracks, prop))
