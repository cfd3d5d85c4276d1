"""Which shadows unite before opacity."""

from dataclasses import replace

from kagezou.scene.scene import LayerScene, Scene, ShadowLook


def shadow_groups(scene: Scene) -> tuple[tuple[LayerScene, ...], ...]:
    """Return the visible layers that cast, by what is laid on the picture at once; never an empty group.

    Layers of one group have equal looks: each colour of a pixel takes the most that one of their shadows takes from it,
    so that where they meet it is never darker than under one of them alone. Groups are in the order of their lowest
    layers, the layers of each from the bottom.
    """
    casting = [layer for layer in scene.layers if layer.cast is not None]
    if not scene.shadows_unite:
        return tuple((layer,) for layer in casting)
    by_look: dict[ShadowLook, tuple[LayerScene, ...]] = {}
    for layer in casting:
        by_look[layer.look] = (*by_look.get(layer.look, ()), layer)
    return tuple(by_look.values())


def united_look(look: ShadowLook) -> ShadowLook:
    """Return how a united shadow is laid: how far each fades is within it already."""
    return replace(look, fade=None)
