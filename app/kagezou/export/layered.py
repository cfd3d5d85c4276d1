"""A frame as layers: background, the shadow of the set, each character's shadow, each character."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

import numpy as np

from kagezou.export.jobs import Job, LayeredContent
from kagezou.geometry.box import Box, centred_offset
from kagezou.io.cels import CelCache
from kagezou.io.encode import ShadowImage
from kagezou.io.images import Cel, Steps, read_cel
from kagezou.io.layered import LayeredImage, Part
from kagezou.render.backdrop import Backdrop
from kagezou.render.renderer import Renderer

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
    _background: tuple[Path, Cel] | None = None

    def draw(self, job: Job, content: LayeredContent, depth: int) -> LayeredImage:
        """Return a frame as layers; with their opacity beside them, and merged too, where it becomes a PSD."""
        canvas = job.scene.canvas
        is_document = job.targets[0].path.suffix == ".psd"
        merged: Steps | None = None
        if is_document:
            self.renderer.draw_picture(job.scene, Backdrop.BACKGROUND)
            merged = self.renderer.read_picture()
        parts = self._parts(job, content, depth, keeps_opacity=is_document)
        return LayeredImage(canvas.width, canvas.height, tuple(_unlike(parts)), merged)

    def _parts(self, job: Job, content: LayeredContent, depth: int, *, keeps_opacity: bool) -> Iterator[Part]:
        scene = job.scene
        seen = {layer.id: layer for layer in scene.layers}
        if scene.background is not None:
            yield _cel_part(_BACKGROUND, self._read_background(scene.background), scene.canvas)
        if content.has_set:
            shadow = scene.set_shadow
            if shadow is None:
                yield _empty_part(_SET_SHADOW, depth)
            else:
                # Drawn in full where the opacity is kept beside it.
                opacity = shadow.look.opacity if keeps_opacity else 1.0
                full = replace(shadow, look=replace(shadow.look, opacity=1.0)) if keeps_opacity else shadow
                drawn = self.renderer.set_shadow(scene, full, depth)
                yield _shadow_part(_SET_SHADOW, drawn, opacity, multiply=shadow.look.multiply)
        for layer_id, name in content.layers:
            layer = seen.get(layer_id)
            if layer is None:
                yield _empty_part(f"{name}_shadow", depth)
                continue
            opacity = layer.look.opacity if keeps_opacity else 1.0
            whole = replace(layer, look=replace(layer.look, opacity=1.0)) if keeps_opacity else layer
            drawn = self.renderer.shadow(scene, whole, depth)
            yield _shadow_part(f"{name}_shadow", drawn, opacity, multiply=layer.look.multiply)
        for layer_id, name in content.layers:
            layer = seen.get(layer_id)
            if layer is None or layer.drawing is None:
                yield _empty_part(name, depth)
            else:
                yield _cel_part(name, self.cels.cel(layer.drawing.path), scene.canvas)

    def _read_background(self, path: Path) -> Cel:
        if self._background is None or self._background[0] != path:
            self._background = (path, read_cel(path, white_is_clear=False))
        return self._background[1]


def _empty_part(name: str, depth: int) -> Part:
    return Part(name, np.zeros((0, 0, 4), np.uint8 if depth == 8 else np.uint16), _NOTHING)


def _shadow_part(name: str, drawn: ShadowImage, opacity: float, *, multiply: bool) -> Part:
    if drawn.box.is_empty:
        return Part(name, np.zeros((0, 0, 4), drawn.alpha.dtype), _NOTHING, opacity, multiply)
    box = drawn.box.moved(-drawn.box.left, -drawn.box.top)
    pixels = replace(drawn, width_px=box.width, height_px=box.height, box=box).rgba()
    return Part(name, pixels, drawn.box, opacity, multiply)


def _cel_part(name: str, cel: Cel, canvas: Box) -> Part:
    """Return a drawing as it lies on the canvas, cut to its figure and to the canvas."""
    height, width = cel.rgba.shape[:2]
    left, top = centred_offset(canvas, width, height)
    box = cel.matte.box and cel.matte.box.moved(left, top).intersection(canvas)
    if box is None:
        return Part(name, cel.rgba[:0, :0], _NOTHING)
    return Part(name, cel.rgba[box.top - top : box.bottom - top, box.left - left : box.right - left], box)


def _unlike(parts: Iterator[Part]) -> Iterator[Part]:
    """Yield the parts under names of which no two are alike: a layer may be called as another's shadow is."""
    taken: set[str] = set()
    for part in parts:
        name = part.name
        while name in taken:
            name += "_"
        taken.add(name)
        yield replace(part, name=name)
