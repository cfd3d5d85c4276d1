"""The layers of the composition that show drawings: the background and the characters' cels."""

from kagezou.animation.track import Track
from kagezou.document import properties
from kagezou.document.address import Address, track_of
from kagezou.document.model import Cels, Document, Layer
from kagezou.export.after_effects import comp as ae
from kagezou.export.after_effects.channels import seconds
from kagezou.export.after_effects.drawings import CelFootage
from kagezou.export.after_effects.transforms import background_transform, transform_of

_FULL = ae.Channel(100.0)
_ALWAYS = Track(True)  # noqa: FBT003 - the value of a track
_Held = tuple[tuple[float, int | None], ...]


def background_layer(document: Document, footage: CelFootage) -> ae.CompLayer:
    """Return the layer of the background; one picture that is always seen is held by nothing."""
    held = _held(document, document.behind, footage, _ALWAYS)
    return ae.CompLayer(
        tag="background",
        name="Background",
        footage="background",
        blend="NORMAL",
        opacity=_FULL,
        remap=() if held == ((0.0, 0),) and footage.count == 1 else held,
        transform=background_transform(document, footage.size_px),
    )


def cel_layer(
    document: Document, layer: Layer, footage: CelFootage, markers: tuple[ae.CompMarker, ...] = ()
) -> ae.CompLayer:
    """Return the layer of a character's drawings."""
    return ae.CompLayer(
        tag=f"cels:{layer.id}",
        name=layer.name,
        footage=f"cels:{layer.id}",
        blend="NORMAL",
        opacity=_FULL,
        remap=_held(document, layer.cels, footage, track_of(document, Address(properties.VISIBLE, layer.id))),
        markers=markers,
        transform=transform_of(document, layer, footage.size_px),
    )


def _held(document: Document, cels: Cels, footage: CelFootage, visible: Track) -> _Held:
    """Return when another picture of the footage begins to be held."""
    held: list[tuple[float, int | None]] = []
    for frame in range(1, document.canvas.length_frames + 1):
        index = cels.index_at(frame) if visible.value_at(frame) else None
        picture = None if index is None else footage.places[index]
        if not held or held[-1][1] != picture:
            held.append((seconds(frame, document.canvas.frame_rate), picture))
    return tuple(held)
