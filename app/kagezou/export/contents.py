"""What the pictures of an export show, which files each is made of, and how it is drawn.

Contents are compared to find pictures that are the same: equal ones have equal pixels. What they are drawn from, the
first scene that shows them, does not count for that.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Self, TypeAlias

import numpy as np

from kagezou.export.painter import Painter
from kagezou.export.pictures import FlatPicture, Picture, ShadowPicture
from kagezou.export.sources import Sources
from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.io.images.writing import ShadowImage
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.scene.pieces import PieceScene, SetCast
from kagezou.scene.scene import (
    Contact,
    LayerScene,
    PlacedDrawing,
    Received,
    Reflection,
    Scene,
    SetShadow,
    ShadowCast,
    ShadowLook,
)

if TYPE_CHECKING:
    from kagezou.scene.guide_lines import GuideLines


@dataclass(frozen=True, slots=True)
class Content(ABC):
    """All that decides a picture but its size and format.

    Parameters
    ----------
    scene
        What to draw it from: the first frame that shows it. Not compared.
    """

    scene: Scene = field(compare=False, repr=False)

    @abstractmethod
    def draw(self, painter: Painter) -> Picture:
        """Draw it.

        Raises
        ------
        InputProblem
            A drawing cannot be read.
        GraphicsProblem
            OpenGL failed.
        """

    @property
    @abstractmethod
    def sources(self) -> Sources:
        """What it is made of."""

    @property
    @abstractmethod
    def is_filled(self) -> bool:
        """Whether it may show something everywhere and so packs badly; a shadow is clear nearly everywhere."""


@dataclass(frozen=True, slots=True)
class ShadowLike(Content):
    """A picture that is clear but for a shadow or a matte."""

    @property
    def is_filled(self) -> bool:
        """Never."""
        return False


@dataclass(frozen=True, slots=True)
class BlankContent(ShadowLike):
    """A shadow where there is none: its colour, 8 bit sRGB, clear everywhere."""

    color: tuple[int, int, int]

    def draw(self, painter: Painter) -> Picture:
        """Return it; there is nothing to draw."""
        canvas = self.scene.canvas
        alpha = np.zeros((0, 0), np.uint8 if painter.depth == 8 else np.uint16)
        return ShadowPicture(ShadowImage(canvas.width, canvas.height, self.color, alpha, Box(0, 0, 0, 0)))

    @property
    def sources(self) -> Sources:
        """Nothing."""
        return Sources()


@dataclass(frozen=True, slots=True)
class ShadowContent(ShadowLike):
    """A character's shadow; ``layer`` is what to draw it from and not compared."""

    layer: LayerScene = field(compare=False, repr=False)
    cast: ShadowCast
    look: ShadowLook

    @classmethod
    def of(cls, scene: Scene, layer: LayerScene, cast: ShadowCast) -> Self:
        """Return the content of a layer's shadow."""
        # How it is laid on what is under it does not change the layer itself.
        return cls(scene, layer, cast, replace(layer.look, multiply=True))

    def draw(self, painter: Painter) -> Picture:
        """Draw the shadow."""
        return ShadowPicture(painter.renderer.shadow(self.scene, self.layer, painter.depth))

    @property
    def sources(self) -> Sources:
        """The alpha of its drawing, in colour where a painted shadow is to be found there, and the sets it falls on."""
        sources, sets = self.cast.sources, sets_in(self.scene)
        return Sources(cels=sources, sets=sets) if self.cast.without_painted else Sources(mattes=sources, sets=sets)


@dataclass(frozen=True, slots=True)
class UnitedContent(ShadowLike):
    """The shadows of several characters as one; ``layers`` is what to draw it from and not compared."""

    layers: tuple[LayerScene, ...] = field(compare=False, repr=False)
    casts: tuple[ShadowCast, ...]
    look: ShadowLook

    @classmethod
    def of(cls, scene: Scene, layers: tuple[LayerScene, ...]) -> Self:
        """Return the content of layers of one look, at least one; those without a shadow add nothing."""
        casts = tuple(layer.cast for layer in layers if layer.cast is not None)
        # As for a character's alone.
        return cls(scene, layers, casts, replace(layers[0].look, multiply=True))

    def draw(self, painter: Painter) -> Picture:
        """Draw the united shadow."""
        return ShadowPicture(painter.renderer.united_shadow(self.scene, self.layers, painter.depth))

    @property
    def sources(self) -> Sources:
        """The alphas of the drawings, and the sets they fall on."""
        return Sources(mattes=tuple(source for cast in self.casts for source in cast.sources), sets=sets_in(self.scene))


@dataclass(frozen=True, slots=True)
class SetShadowContent(ShadowLike):
    """The shadow of the set itself."""

    shadow: SetShadow

    @classmethod
    def of(cls, scene: Scene, shadow: SetShadow) -> Self:
        """Return the content of a scene's set shadow."""
        # As for a character's.
        return cls(scene, replace(shadow, look=replace(shadow.look, multiply=True)))

    def draw(self, painter: Painter) -> Picture:
        """Draw the shadow."""
        return ShadowPicture(painter.renderer.set_shadow(self.scene, self.shadow, painter.depth))

    @property
    def sources(self) -> Sources:
        """The sets."""
        return Sources(sets=sets_in(self.scene))


@dataclass(frozen=True, slots=True)
class ReflectionContent(Content):
    """A character mirrored in the ground; ``layer`` is what to draw it from and not compared."""

    layer: LayerScene = field(compare=False, repr=False)
    reflection: Reflection

    def draw(self, painter: Painter) -> Picture:
        """Draw the reflection."""
        return FlatPicture(painter.renderer.reflection(self.scene, self.layer, painter.depth))

    @property
    def sources(self) -> Sources:
        """Its drawings in colour, and the sets that hide ground."""
        return Sources(cels=self.reflection.sources, sets=sets_in(self.scene))

    @property
    def is_filled(self) -> bool:
        """Never: most of the ground mirrors nothing."""
        return False


@dataclass(frozen=True, slots=True)
class ReceiverContent(ShadowLike):
    """The matte of a receiver.

    Parameters
    ----------
    cast
        Without lights. The piece that casts is the receiver; where none does, the ground is.
    """

    cast: SetCast

    def draw(self, painter: Painter) -> Picture:
        """Draw where it is seen."""
        return ShadowPicture(painter.renderer.receiver_matte(self.scene.canvas, self.cast, painter.depth))

    @property
    def sources(self) -> Sources:
        """The sets."""
        return Sources(sets=sets_in(self.scene))


_Shown: TypeAlias = tuple[
    PlacedDrawing | None, ShadowCast | None, ShadowLook, Received | None, Contact | None, Reflection | None
]


@dataclass(frozen=True, slots=True)
class CompositeContent(Content):
    """The finished picture: the background and each layer, from the bottom.

    ``clay`` is what imported sets are seen with, and they themselves, as each hides others; None where none is drawn as
    clay. ``guides`` are lines drawn over everything, None for none.
    """

    background: PlacedDrawing | None
    layers: tuple[_Shown, ...]
    set_shadow: SetShadow | None = None
    clay: tuple[Camera, tuple[PieceScene, ...]] | None = None
    shadows_unite: bool = True
    guides: "GuideLines | None" = None

    @classmethod
    def of(cls, scene: Scene, guides: "GuideLines | None" = None) -> Self:
        """Return the content of a whole scene."""
        layers = tuple(
            (each.drawing, each.cast, each.look, each.received, each.contact, each.reflection) for each in scene.layers
        )
        return cls(scene, scene.background, layers, scene.set_shadow, clay_in(scene), scene.shadows_unite, guides)

    def draw(self, painter: Painter) -> Picture:
        """Draw it over the background."""
        painter.renderer.draw_picture(self.scene, Backdrop.BACKGROUND, painter.depth)
        pixels = painter.renderer.read_picture()
        if self.guides is None:
            return FlatPicture(pixels)
        from kagezou.export.guides import with_guides

        return FlatPicture(with_guides(pixels, self.guides))

    @property
    def sources(self) -> Sources:
        """The drawings in colour, which serve their alphas too, the background and the sets."""
        shown = tuple(drawing.source for drawing, *_ in self.layers if drawing is not None)
        mirrored = tuple(source for *_, each in self.layers if each is not None for source in each.sources)
        cels = tuple(dict.fromkeys((*shown, *mirrored)))
        behind = None if self.background is None else self.background.source
        return Sources(cels=cels, background=behind, sets=sets_in(self.scene))

    @property
    def is_filled(self) -> bool:
        """Always."""
        return True


def sets_in(scene: Scene) -> tuple[Path, ...]:
    """Return the files of the sets of a scene."""
    return tuple(dict.fromkeys(piece.mesh.path for piece in scene.pieces if piece.mesh is not None))


def clay_in(scene: Scene) -> tuple[Camera, tuple[PieceScene, ...]] | None:
    """Return what decides how sets are seen as clay; None where none is."""
    meshes = tuple(piece for piece in scene.pieces if piece.mesh is not None)
    return (scene.camera, meshes) if any(piece.display == "clay" for piece in meshes) else None
