"""What of a frame is looked at: the finished picture, or the shadow by itself in one of three ways."""

from dataclasses import replace
from enum import StrEnum

from kagezou.render.prepare.backdrop import Backdrop
from kagezou.scene.scene import LayerScene, Scene, ShadowLook

_WHITE = (255, 255, 255)


class PictureView(StrEnum):
    """The ways to look at a frame."""

    COMPOSITE = "composite"
    SHADOW = "shadow"
    """The shadows in their colours, without characters and background picture."""
    OUTLINE = "outline"
    """The characters, and the shadows as lines where half is covered."""
    MATTE = "matte"
    """What the exported layers hold as alpha, as grey: white is opaque."""


def seen(scene: Scene, view: PictureView) -> Scene:
    """Return what of a frame is drawn for a view."""
    match view:
        case PictureView.SHADOW:
            return replace(scene, background=None, layers=tuple(_alone(layer, layer.look) for layer in scene.layers))
        case PictureView.MATTE:
            layers = tuple(_alone(layer, _as_alpha(layer.look)) for layer in scene.layers)
            return replace(scene, background=None, layers=layers)
        case _:
            return scene


def behind(view: PictureView, backdrop: Backdrop, *, has_background: bool) -> Backdrop:
    """Return what shows where nothing is drawn."""
    if view is PictureView.MATTE:
        return Backdrop.BLACK
    if backdrop is Backdrop.BACKGROUND and (not has_background or view is PictureView.SHADOW):
        # Paper: on any other tone the colour of a shadow could not be judged.
        return Backdrop.WHITE
    return backdrop


def line_px(view: PictureView, zoom: float) -> int:
    """Return half the width of the outline's line in canvas px, so that it is seen at any zoom; 0 for none."""
    return max(1, round(1 / zoom)) if view is PictureView.OUTLINE else 0


def _alone(layer: LayerScene, look: ShadowLook) -> LayerScene:
    # The cast has its own drawing: without the layer's the shadow falls as before.
    received = layer.received
    if received is not None and look is not layer.look:
        shades = tuple(replace(shade, look=_as_alpha(shade.look)) for shade in received.shades)
        received = replace(received, shades=shades)
    return replace(layer, drawing=None, look=look, received=received)


def _as_alpha(look: ShadowLook) -> ShadowLook:
    return replace(look, color=_WHITE, multiply=False, tip=None)
