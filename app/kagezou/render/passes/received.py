"""Shadows on characters: each card is one more receiver, cut to the drawing that stands on it."""

from dataclasses import dataclass, replace
from functools import partial

from kagezou.geometry.box import Box, around, centred_offset
from kagezou.geometry.card import CardPiece, receiver_of
from kagezou.geometry.polygon import bounding_box
from kagezou.io.images.cel_cache import CelSource
from kagezou.io.images.reading import Matte
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.gl import GL
from kagezou.render.gpu.made_of_cache import MadeOfCache
from kagezou.render.gpu.mattes import Mattes, PlacedMatte
from kagezou.render.gpu.program import Variants
from kagezou.render.gpu.scratches import Scratches
from kagezou.render.gpu.targets import Format, Target, Texture
from kagezou.render.passes.cast import CastPass, Window
from kagezou.render.prepare.cast_uniforms import piece_limits
from kagezou.scene.scene import LayerScene, Received, Scene, Shade, ShadowCast, ShadowLook

_ALPHA_BUDGET_BYTES = 64 << 20


@dataclass(slots=True)
class ReceivedCoverage:
    """A target (16 bit, canvas size) and the box within it that may hold shadow, and what it was drawn of."""

    target: Target
    look: ShadowLook
    box: Box | None = None
    of: tuple[object, ...] = ()


class ReceivedLayers:
    """Draws what falls on a character unless the last one of the same shades is still there.

    Parameters
    ----------
    boxes, caster
        What draws.
    cels, mattes
        Where drawings come from, in memory and on the graphics card.
    """

    def __init__(self, boxes: Boxes, caster: CastPass, cels: CelSource, mattes: Mattes) -> None:
        self._boxes, self._caster, self._cels, self._mattes = boxes, caster, cels, mattes
        self._cut = Variants("common/box.vert", "passes/received.frag")
        self._alphas: MadeOfCache[Texture] = MadeOfCache(_ALPHA_BUDGET_BYTES)
        self._scratches = Scratches()
        self._kept: dict[tuple[str, int], ReceivedCoverage] = {}

    def coverages(self, scene: Scene, layer: LayerScene) -> tuple[ReceivedCoverage, ...]:
        """Return the covered parts of a character by the looks of those who cast; looks without any are left out."""
        if layer.received is None:
            return ()
        found = [
            self._coverage(scene, (layer.id, index), layer.received, shade)
            for index, shade in enumerate(layer.received.shades)
        ]
        return tuple(each for each in found if each.box is not None)

    def forget_except(self, alive: set[str]) -> None:
        """Give back the memory of layers that are gone."""
        for key in [key for key in self._kept if key[0] not in alive]:
            self._kept.pop(key).target.close()

    def close(self) -> None:
        """Give the memory back."""
        for kept in self._kept.values():
            kept.target.close()
        self._kept.clear()
        self._scratches.close()
        self._alphas.close()
        self._cut.close()

    def _coverage(self, scene: Scene, key: tuple[str, int], on: Received, shade: Shade) -> ReceivedCoverage:
        kept = self._kept.get(key)
        if kept is not None and kept.target.box != scene.canvas:
            kept.target.close()
            kept = None
        if kept is None:
            kept = self._kept[key] = ReceivedCoverage(_cleared(scene.canvas), shade.look)
        kept.look = shade.look
        alpha = self._cels.matte(on.drawing.source)
        casting = [(cast, self._cels.matte(cast.drawing.source)) for cast in shade.casts]
        of = (shade.casts, on.card, alpha, *(matte for _, matte in casting))  # mattes are equal only to themselves
        if kept.of != of:
            old, kept.box, kept.of = kept.box, scene.canvas, ()
            if old is not None:
                kept.target.clear(old)
            kept.box = self._draw(on, alpha, casting, kept.target)
            kept.of = of
        return kept

    def _draw(self, on: Received, alpha: Matte, casting: list[tuple[ShadowCast, Matte]], target: Target) -> Box | None:
        """Draw all that falls on a character; return the box that may hold it."""
        if alpha.box is None:
            return None
        figure = alpha.box.moved(*centred_offset(target.box, alpha.width_px, alpha.height_px))
        drawn: Box | None = None
        for cast, matte in casting:
            own = target if len(casting) == 1 else self._scratches.like("one", target)
            placed = self._mattes.placed(matte, target.box)
            box = around(*[self._draw_piece((cast, placed), each, (alpha, figure), own) for each in on.card.pieces])
            if box is not None and own is not target:
                self._caster.merge(own, target, box)
            drawn = around(drawn, box)
        return drawn

    def _draw_piece(
        self,
        character: tuple[ShadowCast, PlacedMatte | None],
        piece: CardPiece,
        figure: tuple[Matte, Box],
        target: Target,
    ) -> Box | None:
        """Add what one character casts on a piece of another's card; return the box that may hold it."""
        (cast, matte), (alpha, place) = character, figure
        around_part = bounding_box(piece.part_of(place))
        part = None if around_part is None else around_part.intersection(target.box)
        if part is None or matte is None:
            return None
        whole = self._scratches.like("whole", target)
        alone = replace(cast, receivers=(receiver_of(cast.camera, piece),))
        box = self._caster.unite(alone, matte, whole, Window(part))
        if box is None:
            return None
        texture = self._alphas.made_of(alpha, partial(_uploaded, alpha))
        target.bind(box)
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendFunc(GL.GL_ONE, GL.GL_ONE)
        whole.texture.bind(0)
        texture.bind(1)
        switches, limits = piece_limits(piece)
        self._cut[switches].use(
            {
                "u_target_size_px": target.size_px,
                "u_coverage": 0,
                "u_alpha": 1,
                "u_corner_px": (float(place.left), float(place.top)),
                **limits,
            }
        )
        self._boxes.draw_one(box)
        whole.clear(box)
        return box


def _cleared(canvas: Box) -> Target:
    target = Target(canvas.width, canvas.height, Format.ALPHA16)
    target.clear()
    return target


def _uploaded(matte: Matte) -> Texture:
    assert matte.box is not None
    form = Format.ALPHA8 if matte.alpha.dtype.itemsize == 1 else Format.ALPHA16
    texture = Texture(matte.box.width, matte.box.height, form)
    texture.upload(matte.alpha)
    return texture
