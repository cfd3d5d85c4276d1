"""Which shadows fall on which characters."""

from collections.abc import Set
from dataclasses import replace

from kagezou.picture_source import PictureSource
from kagezou.scene.scene import LayerScene, Received, Shade, ShadowCast, ShadowLook


def with_received(layers: tuple[LayerScene, ...], receiving: Set[str]) -> tuple[LayerScene, ...]:
    """Return the visible layers with what the others cast on those of them whose ids are in ``receiving``.

    On a character shadows fall as they are: simplification, waves, edges, fading and a second colour are measured on
    the ground, from the feet of the one who casts.
    """
    return tuple(_receiving(layer, layers) if layer.id in receiving else layer for layer in layers)


def without_drawings(layer: LayerScene, lost: Set[PictureSource]) -> LayerScene:
    """Return a layer without what falls on it from drawings that cannot be read."""
    if layer.received is None or not lost:
        return layer
    kept = (
        replace(shade, casts=tuple(cast for cast in shade.casts if cast.drawing.source not in lost))
        for shade in layer.received.shades
    )
    return replace(layer, received=replace(layer.received, shades=tuple(shade for shade in kept if shade.casts)))


def _receiving(layer: LayerScene, layers: tuple[LayerScene, ...]) -> LayerScene:
    if layer.drawing is None or layer.cast is None:
        return layer
    by_look: dict[ShadowLook, tuple[ShadowCast, ...]] = {}
    for other in layers:
        if other.id != layer.id and other.cast is not None and other.cast.lights:
            look = replace(other.look, fade=None, tip=None)
            cast = replace(other.cast, receivers=(), simplify=None, edge=None, water=None, pieces=())
            by_look[look] = (*by_look.get(look, ()), cast)
    shades = tuple(Shade(casts, look) for look, casts in by_look.items())
    return replace(layer, received=Received(layer.drawing, layer.cast.card, shades))
