"""Scenes without what cannot be shown."""

from collections.abc import Collection
from dataclasses import replace

from kagezou.scene.scene import LayerScene, Scene, ShadowCast


def without_pieces(scene: Scene, ids: Collection[str]) -> Scene:
    """Return a scene in which some set pieces are not there; where none is left shadows fall on the flat ground."""
    pieces = tuple(piece for piece in scene.pieces if piece.id not in ids)

    def without(cast: ShadowCast) -> ShadowCast:
        return replace(cast, pieces=pieces, ground_receives=cast.ground_receives or not pieces)

    def without_them(layer: LayerScene) -> LayerScene:
        contact, mirrored = layer.contact, layer.reflection
        return replace(
            layer,
            cast=layer.cast and without(layer.cast),
            contact=contact and replace(contact, cast=without(contact.cast)),
            reflection=mirrored
            and replace(mirrored, pieces=pieces, ground_receives=mirrored.ground_receives or not pieces),
        )

    layers = tuple(map(without_them, scene.layers))
    dark = scene.set_shadow
    if dark is not None:
        casts = any(piece.casts for piece in pieces)
        dark = replace(dark, cast=replace(dark.cast, pieces=pieces)) if casts else None
    return replace(scene, layers=layers, pieces=pieces, set_shadow=dark)
