"""A frame as layers: background, the set's shadow, each character's shadow, each character and what falls on it."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from typing import Final

import numpy as np

from kagezou.export.jobs import FrameJob, LayeredContent
from kagezou.geometry.box import Box, centred_offset
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.reading import Cel, Steps, read_cel
from kagezou.io.images.writing import ShadowImage
from kagezou.io.pixels.layers import LayeredImage, LayerPart
from kagezou.picture_source import PictureSource
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.render.renderer import Renderer
from kagezou.scene.scene import LayerScene, Scene, SetShadow, ShadowLook

_BACKGROUND: Final = "background"
_SET_SHADOW: Final = "set_shadow"
_NOTHING: Final = Box(0, 0, 0, 0)


@dataclass(slots=True)
class LayerPainter:
    """Draws layered frames; the background is read once.

    Parameters
    ----------
    renderer
        What draws.
    cels
        Where decoded drawings come from.
    """

    renderer: Renderer
    cels: CelCache
    _background: tuple[PictureSource, Cel] | None = None

    def draw(self, job: FrameJob, content: LayeredContent, depth: int) -> LayeredImage:
        """Return a frame as layers; with their opacity beside them, and merged too, where it becomes a PSD."""
        canvas = job.scene.canvas
        is_document = job.targets[0].path.suffix == ".psd"
        merged: Steps | None = None
        if is_document:
            self.renderer.draw_picture(job.scene, Backdrop.BACKGROUND, depth)
            merged = self.renderer.read_picture()
        parts = self._parts(job, content, depth, keeps_opacity=is_document)
        named = (replace(part, name=name) for name, part in zip(part_names(content), parts, strict=True))
        return LayeredImage(canvas.width, canvas.height, tuple(named), merged, depth)

    def _parts(self, job: FrameJob, content: LayeredContent, depth: int, *, keeps_opacity: bool) -> Iterator[LayerPart]:
        """Yield the parts in the order of `part_names`, without their names."""
        scene = job.scene
        seen = {layer.id: layer for layer in scene.layers}
        if scene.background is not None:
            yield _cel_part(self._read_background(scene.background), scene.canvas)
        if content.has_set and scene.set_shadow is None:
            yield _empty_part(depth)
        elif content.has_set and scene.set_shadow is not None:
            draw_set = partial(self._set_shadow, scene, scene.set_shadow, depth)
            yield _shadow_part(draw_set, scene.set_shadow.look, keeps_opacity=keeps_opacity)
        for layer_id, _ in content.layers:
            layer = seen.get(layer_id)
            if layer is None:
                yield _empty_part(depth)
            else:
                draw = partial(self._shadow, scene, layer, depth)
                yield _shadow_part(draw, layer.look, keeps_opacity=keeps_opacity)
        for layer_id, _ in content.layers:
            layer = seen.get(layer_id)
            if layer is None or layer.drawing is None:
                yield _empty_part(depth)
            else:
                yield _cel_part(self.cels.cel(layer.drawing.source), scene.canvas)
            if layer_id in content.receiving:
                yield _empty_part(depth) if layer is None else self._received_part(scene, layer, depth)

    def _received_part(self, scene: Scene, layer: LayerScene, depth: int) -> LayerPart:
        """Return what others cast on a layer, at the opacity of those who cast."""
        first = layer.received.shades[0].look if layer.received and layer.received.shades else layer.look
        return _shadow_part(lambda _look: self.renderer.received(scene, layer, depth), first, keeps_opacity=False)

    def _set_shadow(self, scene: Scene, shadow: SetShadow, depth: int, look: ShadowLook) -> ShadowImage:
        return self.renderer.set_shadow(scene, replace(shadow, look=look), depth)

    def _shadow(self, scene: Scene, layer: LayerScene, depth: int, look: ShadowLook) -> ShadowImage:
        return self.renderer.shadow(scene, replace(layer, look=look), depth)

    def _read_background(self, source: PictureSource) -> Cel:
        if self._background is None or self._background[0] != source:
            self._background = (source, read_cel(source, white_is_clear=False))
        return self._background[1]


def part_names(content: LayeredContent) -> tuple[str, ...]:
    """Return what the parts of a frame are called, from the bottom; no two are alike.

    A layer may be called as another's shadow is; the later one of the two gets a ``_`` more.
    """
    names = [_BACKGROUND] if content.picture.background is not None else []
    names += [_SET_SHADOW] if content.has_set else []
    names += [f"{name}_shadow" for _, name in content.layers]
    for layer_id, name in content.layers:
        names += [name, f"{name}_received"] if layer_id in content.receiving else [name]
    unlike: list[str] = []
    for name in names:
        free = name
        while free in unlike:
            free += "_"
        unlike.append(free)
    return tuple(unlike)


def _empty_part(depth: int) -> LayerPart:
    return LayerPart("", np.zeros((0, 0, 4), np.uint8 if depth == 8 else np.uint16), _NOTHING)


def _shadow_part(draw: Callable[[ShadowLook], ShadowImage], look: ShadowLook, *, keeps_opacity: bool) -> LayerPart:
    """Return a shadow; drawn in full where its opacity is kept beside it."""
    opacity = look.opacity if keeps_opacity else 1.0
    drawn = draw(replace(look, opacity=1.0) if keeps_opacity else look)
    if drawn.box.is_empty:
        return LayerPart("", np.zeros((0, 0, 4), drawn.alpha.dtype), _NOTHING, opacity, look.multiply)
    box = drawn.box.moved(-drawn.box.left, -drawn.box.top)
    pixels = replace(drawn, width_px=box.width, height_px=box.height, box=box).rgba()
    return LayerPart("", pixels, drawn.box, opacity, look.multiply)


def _cel_part(cel: Cel, canvas: Box) -> LayerPart:
    """Return a drawing as it lies on the canvas, cut to its figure and to the canvas."""
    height, width = cel.rgba.shape[:2]
    left, top = centred_offset(canvas, width, height)
    box = cel.matte.box and cel.matte.box.moved(left, top).intersection(canvas)
    if box is None:
        return LayerPart("", cel.rgba[:0, :0], _NOTHING)
    return LayerPart("", cel.rgba[box.top - top : box.bottom - top, box.left - left : box.right - left], box)
