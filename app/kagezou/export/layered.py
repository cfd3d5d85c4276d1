"""A frame as layers: background and sets, the set's shadow, what each character casts, its companions, and itself.

What falls on a character lies over it.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from typing import Final

import numpy as np

from kagezou.export.contents import CompositeContent, Content
from kagezou.export.layers_of_frame import CLAY_NAMES, LayerOfFrame, all_unlike, groups_of, two_names
from kagezou.export.mixed_contents import TogetherContent
from kagezou.export.painter import Painter
from kagezou.export.part_groups import as_group
from kagezou.export.pictures import LayeredPicture, Picture
from kagezou.export.sources import Sources
from kagezou.geometry.box import Box, centred_offset
from kagezou.io.images.reading import Cel, Steps
from kagezou.io.images.stored_pixels import box_of
from kagezou.io.images.writing import ShadowImage
from kagezou.io.pixels.layers import LayeredImage, LayerPart
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.scene.companions import contact_layer, without_companions
from kagezou.scene.scene import LayerScene, PlacedDrawing, Scene, SetShadow, ShadowLook

_BACKGROUND: Final = "background"
_SET_SHADOW: Final = "set_shadow"
_NOTHING: Final = Box(0, 0, 0, 0)
_NO_LOOK: Final = ShadowLook((0, 0, 0), 1.0, multiply=True)
"""That of a group while nothing is in it."""


@dataclass(frozen=True, slots=True)
class LayeredContent(Content):
    """All that decides a frame of layers but its size and format.

    Parameters
    ----------
    picture
        What its layers show.
    layers
        The characters, from the bottom.
    has_set
        Whether the set casts a shadow at any time.
    clay
        Where sets are drawn as clay at any time: True for under the background picture, False for over it.
    """

    picture: CompositeContent
    layers: tuple[LayerOfFrame, ...]
    has_set: bool
    clay: tuple[bool, ...] = ()

    def draw(self, painter: Painter) -> Picture:
        """Draw every layer; with their opacity beside them, and merged too, where the files keep that."""
        canvas = self.scene.canvas
        merged: Steps | None = None
        if painter.keeps_opacity:
            painter.renderer.draw_picture(self.scene, Backdrop.BACKGROUND, painter.depth)
            merged = painter.renderer.read_picture()
        parts = zip(self.part_names, _Parts(painter, self).all(), strict=True)
        named = tuple(replace(part, name=name) for name, part in parts)
        return LayeredPicture(LayeredImage(canvas.width, canvas.height, named, merged, painter.depth))

    @property
    def sources(self) -> Sources:
        """What the finished picture is made of."""
        return self.picture.sources

    @property
    def is_filled(self) -> bool:
        """Never: hidden layers are empty."""
        return False

    @property
    def part_names(self) -> tuple[str, ...]:
        """What the layers of the file are called, from the bottom; no two are alike.

        A character may be called as another's shadow is; the later one of the two gets a ``_`` more.
        """
        names = self._names_below
        for group in groups_of(self.layers):
            whole, ways = group[0].group, group[0].together
            names += two_names(whole, ways) if ways else [f"{layer.name}_shadow" for layer in group]
        names += [f"{layer.name}_contact" for layer in self.layers if layer.has_contact]
        names += [f"{layer.name}_reflection" for layer in self.layers if layer.is_mirrored]
        for layer in self.layers:
            names += [layer.name, *two_names(f"{layer.name}_received", layer.received)]
        return all_unlike(names)

    @property
    def group_names(self) -> tuple[str, ...]:
        """What the groups are called in which the layers of the file are, from the bottom; empty for none."""
        groups: list[str] = []
        for group in groups_of(self.layers):
            ways = group[0].together
            groups += [""] * len(ways) if ways else [group[0].group] * len(group)
        below, above = len(self._names_below), len(self.part_names)
        return (*[""] * below, *groups, *[""] * (above - below - len(groups)))

    @property
    def _names_below(self) -> list[str]:
        under, over = ([CLAY_NAMES[where]] * (where in self.clay) for where in (True, False))
        background = [_BACKGROUND] * (self.picture.background is not None)
        return under + background + over + [_SET_SHADOW] * self.has_set


@dataclass(frozen=True, slots=True)
class _Parts:
    """The layers of one frame, being drawn."""

    painter: Painter
    content: LayeredContent

    def all(self) -> Iterator[LayerPart]:
        """Yield the parts in the order of their names, without these."""
        scene, characters = self.content.scene, self.content.layers
        seen = {layer.id: layer for layer in scene.layers}
        yield from self._clay_parts(is_under=True)
        if scene.background is not None:
            yield self._background_part(scene.background)
        yield from self._clay_parts(is_under=False)
        if self.content.has_set:
            yield self._set_part()
        for group in groups_of(characters):
            if group[0].together:
                yield from self._together_parts(group)
            else:
                yield from self._shadow_parts([seen.get(each.id) for each in group], group[0].group)
        for character in (each for each in characters if each.has_contact):
            yield self._contact_part(seen.get(character.id))
        for character in (each for each in characters if each.is_mirrored):
            yield self._reflection_part(seen.get(character.id))
        for character in characters:
            layer = seen.get(character.id)
            yield self._character_part(layer)
            yield from (self._received_part(layer, multiply=way) for way in character.received)

    def _background_part(self, behind: PlacedDrawing) -> LayerPart:
        if behind.placement is None:
            return _cel_part(self.painter.background(behind.source), self.content.scene.canvas)
        return self._as_seen(replace(self.content.scene, layers=(), pieces=(), set_shadow=None), Backdrop.BACKGROUND)

    def _clay_parts(self, *, is_under: bool) -> Iterator[LayerPart]:
        if is_under in self.content.clay:
            yield self._cut_part(self.painter.renderer.clay(self.content.scene, self.painter.depth, is_under=is_under))

    def _set_part(self) -> LayerPart:
        shadow = self.content.scene.set_shadow
        return self._empty_part() if shadow is None else self._laid(partial(self._draw_set, shadow), shadow.look)

    def _shadow_parts(self, layers: list[LayerScene | None], group: str) -> list[LayerPart]:
        """Return the shadows of layers, as those of a group where it has a name."""
        parts = [self._shadow_part(layer) for layer in layers]
        if not group:
            return parts
        looks = [layer.look for layer in layers if layer is not None and layer.cast is not None]
        look = looks[0] if looks else _NO_LOOK
        return as_group(group, parts, look, keeps_opacity=self.painter.keeps_opacity)

    def _shadow_part(self, layer: LayerScene | None) -> LayerPart:
        return self._empty_part() if layer is None else self._laid(partial(self._draw_shadow, layer), layer.look)

    def _contact_part(self, layer: LayerScene | None) -> LayerPart:
        return self._shadow_part(None if layer is None else contact_layer(layer))

    def _reflection_part(self, layer: LayerScene | None) -> LayerPart:
        """Return a reflection, at full opacity where that is kept beside it."""
        mirrored = None if layer is None else layer.reflection
        if layer is None or mirrored is None:
            return self._empty_part()
        opacity = mirrored.opacity if self.painter.keeps_opacity else 1.0
        whole = replace(layer, reflection=replace(mirrored, opacity=mirrored.opacity / opacity))
        seen = self.painter.renderer.reflection(self.content.scene, whole, self.painter.depth)
        return replace(self._cut_part(seen), opacity=opacity)

    def _character_part(self, layer: LayerScene | None) -> LayerPart:
        if layer is None or layer.drawing is None:
            return self._empty_part()
        if layer.drawing.placement is not None:
            return self._moved_part(layer)
        return _cel_part(self.painter.cels.cel(layer.drawing.source), self.content.scene.canvas)

    def _moved_part(self, layer: LayerScene) -> LayerPart:
        """Return a drawing that its layer moves, as the picture shows it."""
        scene = self.content.scene
        alone = without_companions(layer)
        bare = replace(scene, background=None, layers=(alone,), pieces=(), set_shadow=None)
        return self._as_seen(bare, Backdrop.TRANSPARENT)

    def _as_seen(self, scene: Scene, backdrop: Backdrop) -> LayerPart:
        """Return a whole picture as a layer, cut to what is seen of it."""
        self.painter.renderer.draw_picture(scene, backdrop, self.painter.depth)
        return self._cut_part(self.painter.renderer.read_picture())

    def _cut_part(self, seen: Steps) -> LayerPart:
        """Return a whole canvas as a layer, cut to what is seen of it."""
        box = box_of(seen[..., 3])
        return (
            self._empty_part() if box is None else LayerPart("", seen[box.top : box.bottom, box.left : box.right], box)
        )

    def _received_part(self, layer: LayerScene | None, *, multiply: bool) -> LayerPart:
        """Return what others cast on a layer, at the opacity of those who cast."""
        if layer is None:
            return replace(self._empty_part(), multiply=multiply)
        drawn = self.painter.renderer.received(self.content.scene, layer, self.painter.depth, multiply=multiply)
        return _part_of(drawn, 1.0, multiply=multiply)

    def _together_parts(self, group: tuple[LayerOfFrame, ...]) -> Iterator[LayerPart]:
        """Yield the shadows of a group as one picture, or as one of those that multiply and one of the others."""
        scene, ids = self.content.scene, {each.id for each in group}
        layers = tuple(layer for layer in scene.layers if layer.id in ids and layer.cast is not None)
        for multiply in group[0].together:
            if not layers:
                yield replace(self._empty_part(), multiply=multiply)
                continue
            drawn = TogetherContent.of(scene, layers, multiply=multiply).image(self.painter)
            yield _part_of(drawn, 1.0, multiply=multiply)

    def _laid(self, draw: Callable[[ShadowLook], ShadowImage], look: ShadowLook) -> LayerPart:
        """Return a shadow; drawn in full where its opacity is kept beside it."""
        if self.painter.keeps_opacity:
            return _part_of(draw(replace(look, opacity=1.0)), look.opacity, multiply=look.multiply)
        return _part_of(draw(look), 1.0, multiply=look.multiply)

    def _draw_set(self, shadow: SetShadow, look: ShadowLook) -> ShadowImage:
        scene, depth = self.content.scene, self.painter.depth
        return self.painter.renderer.set_shadow(scene, replace(shadow, look=look), depth)

    def _draw_shadow(self, layer: LayerScene, look: ShadowLook) -> ShadowImage:
        scene, depth = self.content.scene, self.painter.depth
        return self.painter.renderer.shadow(scene, replace(layer, look=look), depth)

    def _empty_part(self) -> LayerPart:
        return LayerPart("", np.zeros((0, 0, 4), np.uint8 if self.painter.depth == 8 else np.uint16), _NOTHING)


def _part_of(drawn: ShadowImage, opacity: float, *, multiply: bool) -> LayerPart:
    """Return a shadow as a layer, cut to its box."""
    if drawn.box.is_empty:
        return LayerPart("", np.zeros((0, 0, 4), drawn.alpha.dtype), _NOTHING, opacity, multiply)
    box = drawn.box.moved(-drawn.box.left, -drawn.box.top)
    pixels = replace(drawn, width_px=box.width, height_px=box.height, box=box).rgba()
    return LayerPart("", pixels, drawn.box, opacity, multiply)


def _cel_part(cel: Cel, canvas: Box) -> LayerPart:
    """Return a drawing as it lies on the canvas, cut to its figure and to the canvas."""
    height, width = cel.rgba.shape[:2]
    left, top = centred_offset(canvas, width, height)
    box = cel.matte.box and cel.matte.box.moved(left, top).intersection(canvas)
    if box is None:
        return LayerPart("", cel.rgba[:0, :0], _NOTHING)
    return LayerPart("", cel.rgba[box.top - top : box.bottom - top, box.left - left : box.right - left], box)
