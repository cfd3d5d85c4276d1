"""Which shadows fall on which characters."""

from collections.abc import Set
from dataclasses import replace

from kagezou.picture_source import PictureSource
from kagezou.scene.disc import Disc
from kagezou.scene.scene import LayerScene, Received, Reflection, Shade, ShadowCast, ShadowLook


def with_received(layers: tuple[LayerScene, ...], receiving: Set[str]) -> tuple[LayerScene, ...]:
    """Return the visible layers with what the others cast on those of them whose ids are in ``receiving``.

    On a character shadows fall as they are: simplification, waves, edges, fading and a second colour are measured on
    the ground, from the feet of the one who casts. Round shadows lie on the ground alone.
    """
    return tuple(_receiving(layer, layers) if layer.id in receiving else layer for layer in layers)


def without_drawings(layer: LayerScene, lost: Set[PictureSource]) -> LayerScene:
    """Return a layer without drawings that cannot be read, their part of the shadow, and what falls on it from them."""
    if not lost:
        return layer
    drawing = None if layer.drawing is None or layer.drawing.source in lost else layer.drawing
    cast = None if layer.cast is None else _without(layer.cast, lost)
    layer = replace(layer, reflection=_mirrored_without(layer.reflection, lost))
    if layer.received is None or drawing is None:
        return replace(layer, drawing=drawing, cast=cast, received=None)
    shades = []
    for shade in layer.received.shades:
        casts = (_without(cast, lost) for cast in shade.casts)
        shades.append(replace(shade, casts=tuple(cast for cast in casts if cast is not None)))
    received = replace(layer.received, shades=tuple(shade for shade in shades if shade.casts))
    return replace(layer, drawing=drawing, cast=cast, received=received)


def _without(cast: ShadowCast, lost: Set[PictureSource]) -> ShadowCast | None:
    figure = tuple(part for part in cast.figure if isinstance(part, Disc) or part.source not in lost)
    return replace(cast, figure=figure) if figure else None


def _mirrored_without(reflection: Reflection | None, lost: Set[PictureSource]) -> Reflection | None:
    if reflection is None:
        return None
    figure = tuple(cel for cel in reflection.figure if cel.source not in lost)
    return replace(reflection, figure=figure) if figure else None


def _receiving(layer: LayerScene, layers: tuple[LayerScene, ...]) -> LayerScene:
    if layer.drawing is None:
        return layer
    by_look: dict[ShadowLook, tuple[ShadowCast, ...]] = {}
    for other in layers:
        if other.id != layer.figure_id and other.cast is not None and other.cast.lights and not other.cast.is_round:
            look = replace(other.look, fade=None, tip=None)
            cast = replace(
                other.cast, receivers=(), simplify=None, edge=None, water=None, pieces=(), least_part_px2=0.0
            )
            by_look[look] = (*by_look.get(look, ()), cast)
    shades = tuple(Shade(casts, look) for look, casts in by_look.items())
    return replace(layer, received=Received(layer.drawing, layer.card, shades))
