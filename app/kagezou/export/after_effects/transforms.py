"""How footage lies in the composition where a layer or the background is moved: the document's tracks in its px."""

from kagezou.animation.track import Interpolation
from kagezou.document.address import Address, track_of
from kagezou.document.figure_properties import ANCHOR, BACKGROUND_POSITION, POSITION, ROTATION, SCALE
from kagezou.document.model import Document, Layer, drawing_offset
from kagezou.export.after_effects.channels import baked_pair, channel_of, pair_of
from kagezou.export.after_effects.comp import Channel, Pair, Transform
from kagezou.geometry.box import centred_offset
from kagezou.message import Message
from kagezou.scene.placing import background_at, placement_at

_STILL = Channel(0.0)
_AS_DRAWN = Pair((100.0, 100.0))


def is_moved(document: Document, layer: Layer) -> bool:
    """Return whether a layer moves its drawings on any frame of the cut."""
    return any(placement_at(document, layer, frame) is not None for frame in _frames(document))


def is_background_moved(document: Document) -> bool:
    """Return whether the background is moved on any frame of the cut."""
    shown = (background_at(document, frame) for frame in _frames(document))
    return any(each is not None and each.placement is not None for each in shown)


def transform_of(document: Document, layer: Layer, size_px: tuple[int, int]) -> Transform | None:
    """Return how the footage of a layer lies, None where it lies centred.

    Parameters
    ----------
    document, layer
        Whose it is.
    size_px
        Width and height of the footage; a drawing lies in it as it would lie on the canvas.
    """
    if not is_moved(document, layer):
        return None
    canvas, rate = document.canvas, document.canvas.frame_rate
    position, scale, rotation = (track_of(document, Address(each, layer.id)) for each in (POSITION, SCALE, ROTATION))
    left, top = centred_offset(canvas.box, *size_px)
    x, y = drawing_offset(canvas, layer)
    return Transform(
        anchor=_anchor(document, layer, (float(x - left), float(y - top))),
        x=channel_of(position, 0, rate),
        y=channel_of(position, 1, rate),
        scale=pair_of(scale, rate),
        rotation=channel_of(rotation, 0, rate),
    )


def background_transform(document: Document, size_px: tuple[int, int]) -> Transform | None:
    """Return how the footage of the background lies, None where it lies centred; ``size_px`` is its size."""
    if not is_background_moved(document):
        return None
    canvas, position = document.canvas, track_of(document, Address(BACKGROUND_POSITION))
    left, top = centred_offset(canvas.box, *size_px)
    x, y = canvas.box.middle
    return Transform(
        anchor=Pair((x - left, y - top)),
        x=channel_of(position, 0, canvas.frame_rate),
        y=channel_of(position, 1, canvas.frame_rate),
        scale=_AS_DRAWN,
        rotation=_STILL,
    )


def notes_on_transforms(document: Document) -> tuple[Message, ...]:
    """Return what After Effects cannot have as it is."""
    return tuple(
        Message(
            "the anchor of {layer!r} moves by eases for x and for y, which After Effects has not for anchors; it has "
            "keys on its frames instead",
            layer=layer.name,
        )
        for layer in document.layers
        if _is_eased(document, layer) and is_moved(document, layer)
    )


def _anchor(document: Document, layer: Layer, shift: tuple[float, float]) -> Pair:
    """Return the anchor; After Effects has one ease for both of its numbers, so where there are eases it is baked."""
    track, canvas = track_of(document, Address(ANCHOR, layer.id)), document.canvas
    if _is_eased(document, layer):
        return baked_pair(track, canvas.length_frames, canvas.frame_rate, shift)
    return pair_of(track, canvas.frame_rate, shift)


def _is_eased(document: Document, layer: Layer) -> bool:
    keys = track_of(document, Address(ANCHOR, layer.id)).keys
    return any(key.interpolation is Interpolation.BEZIER for key in keys[:-1])


def _frames(document: Document) -> range:
    return range(1, document.canvas.length_frames + 1)
