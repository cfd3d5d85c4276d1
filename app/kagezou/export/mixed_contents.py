"""Shadows of different looks as one picture: what others cast on a character, and what no layers make.

Where some multiply what is under them and others do not there are two pictures: the one of those that multiply, and
over it that of the others.
"""

from dataclasses import dataclass, field, replace
from typing import Self

from kagezou.export.contents import ShadowLike, sets_in
from kagezou.export.painter import Painter
from kagezou.export.pictures import Picture, ShadowPicture
from kagezou.export.sources import Sources
from kagezou.io.images.writing import ShadowImage
from kagezou.render.prepare.mixing import Laid, mixed
from kagezou.scene.scene import LayerScene, Received, Scene, ShadowCast, ShadowLook
from kagezou.scene.uniting import shadow_groups


@dataclass(frozen=True, slots=True)
class ReceivedContent(ShadowLike):
    """What others cast on a character; ``layer`` is what to draw it from and not compared.

    ``multiply`` says which of the shadows it is of.
    """

    layer: LayerScene = field(compare=False, repr=False)
    received: Received
    multiply: bool

    def draw(self, painter: Painter) -> Picture:
        """Draw what falls on the character."""
        return ShadowPicture(painter.renderer.received(self.scene, self.layer, painter.depth, multiply=self.multiply))

    @property
    def sources(self) -> Sources:
        """The alphas of its drawing and of those that cast on it."""
        casting = (source for shade in self.received.shades for cast in shade.casts for source in cast.sources)
        return Sources(mattes=tuple(dict.fromkeys((self.received.drawing.source, *casting))))


@dataclass(frozen=True, slots=True)
class TogetherContent(ShadowLike):
    """Shadows of several characters, those of like look united, at their opacities.

    Parameters
    ----------
    layers
        What to draw it from: those that cast, from the bottom, at least one. Not compared.
    casts, looks
        Theirs.
    unite
        Whether those of like look unite.
    multiply
        Which of the shadows it is of.
    """

    layers: tuple[LayerScene, ...] = field(compare=False, repr=False)
    casts: tuple[ShadowCast, ...]
    looks: tuple[ShadowLook, ...]
    unite: bool
    multiply: bool

    @classmethod
    def of(cls, scene: Scene, layers: tuple[LayerScene, ...], *, multiply: bool) -> Self:
        """Return the content of layers of which at least one casts."""
        casting = tuple(layer for layer in layers if layer.cast is not None)
        casts = tuple(layer.cast for layer in casting if layer.cast is not None)
        return cls(scene, casting, casts, tuple(layer.look for layer in casting), scene.shadows_unite, multiply)

    def draw(self, painter: Painter) -> Picture:
        """Draw them."""
        return ShadowPicture(self.image(painter))

    def image(self, painter: Painter) -> ShadowImage:
        """Return them as one image; each is drawn as fine as can be before."""
        laid = [
            Laid(painter.renderer.united_shadow(self.scene, group, 16), group[0].look.multiply)
            for group in shadow_groups(replace(self.scene, layers=self.layers))
        ]
        return mixed(laid, multiply=self.multiply, depth=painter.depth)

    @property
    def sources(self) -> Sources:
        """The alphas of the drawings, and the sets they fall on."""
        sources = tuple(dict.fromkeys(source for cast in self.casts for source in cast.sources))
        return Sources(mattes=sources, sets=sets_in(self.scene))
