"""A layer with less or other things beside its drawing."""

from dataclasses import replace

from kagezou.scene.scene import LayerScene


def contact_layer(layer: LayerScene) -> LayerScene | None:
    """Return the patches under the feet of a figure as what a layer of their own casts; None where there are none."""
    if layer.contact is None:
        return None
    return replace(
        without_companions(layer), id=f"{layer.id}:contact", cast=layer.contact.cast, look=layer.contact.look
    )


def without_companions(layer: LayerScene) -> LayerScene:
    """Return a layer that casts nothing, on which nothing falls, and that nothing mirrors."""
    return replace(layer, cast=None, received=None, contact=None, reflection=None)
