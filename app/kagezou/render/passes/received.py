"""Shadows on characters: each card is one more receiver, cut to the drawing that stands on it."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Final

from kagezou.geometry.box import Box, around, centred_offset
from kagezou.geometry.card import CardPiece, receiver_of
from kagezou.geometry.placement import Placement, around_placed
from kagezou.geometry.polygon import bounding_box
from kagezou.io.images.cel_cache import CelSource
from kagezou.io.images.reading import Matte
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.budget import Budget
from kagezou.render.gpu.gl import GL
from kagezou.render.gpu.made_of_cache import MadeOfCache
from kagezou.render.gpu.mattes import PlacedMatte
from kagezou.render.gpu.program import Variants
from kagezou.render.gpu.scratches import Scratches
from kagezou.render.gpu.targets import Format, Target, Texture
from kagezou.render.passes.cast import CastPass, Window
from kagezou.render.passes.figure_mattes import FigureMattes
from kagezou.render.passes.hardening import HardeningPass
from kagezou.render.prepare.cast_uniforms import piece_limits
from kagezou.render.prepare.moved import MOVED_ALPHA, moved_by, moved_uniforms
from kagezou.render.prepare.uniforms import Uniform
from kagezou.scene.scene import LayerScene, Received, Scene, Shade, ShadowCast, ShadowLook

_ALPHA_BUDGET_BYTES = 64 << 20
_BUDGET_BYTES = 256 << 20
NO_SWITCHES: Final[frozenset[str]] = frozenset()


@dataclass(slots=True)
class ReceivedCoverage:
    """A target (16 bit, canvas size) and the box within it that may hold shadow, and what it was drawn of."""

    target: Target
    look: ShadowLook
    box: Box | None = None
    of: tuple[object, ...] = ()

    @property
    def nbytes(self) -> int:
        """The memory it takes."""
        return self.target.texture.nbytes


@dataclass(slots=True)
class _OnCharacter:
    """What falls on one character, by the looks of those who cast."""

    coverages: list[ReceivedCoverage] = field(default_factory=list)

    @property
    def nbytes(self) -> int:
        """The memory it takes."""
        return sum(each.nbytes for each in self.coverages)

    def coverage(self, index: int, canvas: Box, look: ShadowLook) -> ReceivedCoverage:
        """Return the one of a look, counted from 0 without a gap; an empty one where the canvas has another size."""
        if index == len(self.coverages):
            self.coverages.append(ReceivedCoverage(_cleared(canvas), look))
        kept = self.coverages[index]
        if kept.target.box != canvas:
            kept.target.close()
            kept = self.coverages[index] = ReceivedCoverage(_cleared(canvas), look)
        return kept

    def close(self) -> None:
        """Give the memory back."""
        for each in self.coverages:
            each.target.close()
        self.coverages.clear()


@dataclass(frozen=True, slots=True)
class _Figure:
    """The drawing on which shadows fall: its alpha, where that lies centred on the canvas, and how it is moved."""

    alpha: Matte
    centred: Box
    placement: Placement | None

    @property
    def box(self) -> Box:
        """Around where it is seen, canvas px."""
        if self.placement is None:
            return self.centred
        return around_placed(self.centred.grown(1), self.placement.canvas_from_centred())

    @property
    def switches(self) -> frozenset[str]:
        """Those of ``passes/received.frag``."""
        return NO_SWITCHES if self.placement is None else MOVED_ALPHA

    @property
    def uniforms(self) -> dict[str, Uniform]:
        """Where a pixel finds its alpha."""
        corner = (float(self.centred.left), float(self.centred.top))
        if self.placement is None:
            return {"u_corner_px": corner}
        return moved_uniforms(self.placement.canvas_from_centred() @ moved_by(*corner))


class ReceivedLayers:
    """Draws what falls on a character unless the last one of the same shades is still there.

    Parameters
    ----------
    boxes, passes
        What draws, casts and makes edges hard.
    cels, figures
        Where drawings come from, and the silhouettes of those who cast.
    """

    def __init__(
        self, boxes: Boxes, passes: tuple[CastPass, HardeningPass], cels: CelSource, figures: FigureMattes
    ) -> None:
        self._boxes, self._cels, self._figures = boxes, cels, figures
        self._caster, self._hardening = passes
        self._cut = Variants("common/box.vert", "passes/received.frag")
        self._alphas: MadeOfCache[Texture] = MadeOfCache(_ALPHA_BUDGET_BYTES)
        self._scratches = Scratches()
        self._kept: Budget[str, _OnCharacter] = Budget(_BUDGET_BYTES)

    def coverages(self, scene: Scene, layer: LayerScene) -> tuple[ReceivedCoverage, ...]:
        """Return the covered parts of a character by the looks of those who cast; looks without any are left out."""
        if layer.received is None:
            return ()
        kept = self._kept.latest(layer.id, lambda known: known or _OnCharacter())
        found = [
            self._coverage(kept.coverage(index, scene.canvas, shade.look), layer.received, shade)
            for index, shade in enumerate(layer.received.shades)
        ]
        return tuple(each for each in found if each.box is not None)

    def forget_except(self, alive: set[str]) -> None:
        """Give back the memory of layers that are gone."""
        self._kept.forget(each for each in self._kept.names if each not in alive)

    def close(self) -> None:
        """Give the memory back."""
        self._kept.close()
        self._scratches.close()
        self._alphas.close()
        self._cut.close()

    def _coverage(self, kept: ReceivedCoverage, on: Received, shade: Shade) -> ReceivedCoverage:
        kept.look = shade.look
        alpha = self._cels.matte(on.drawing.source)
        # Mattes are equal only to themselves.
        of = (shade.casts, on, alpha, *(self._figures.mattes_of(cast) for cast in shade.casts))
        if kept.of != of:
            old, kept.box, kept.of = kept.box, kept.target.box, ()
            if old is not None:
                kept.target.clear(old)
            kept.box = self._draw(on, alpha, shade.casts, kept.target)
            kept.of = of
        return kept

    def _draw(self, on: Received, alpha: Matte, casts: Sequence[ShadowCast], target: Target) -> Box | None:
        """Draw all that falls on a character; return the box that may hold it."""
        if alpha.box is None:
            return None
        centred = alpha.box.moved(*centred_offset(target.box, alpha.width_px, alpha.height_px))
        figure = _Figure(alpha, centred, on.drawing.placement)
        drawn: Box | None = None
        for cast in casts:
            own = target if len(casts) == 1 else self._scratches.like("one", target)
            placed = self._figures.placed(cast, target.box)
            box = around(*[self._draw_piece((cast, placed), each, figure, own) for each in on.card.pieces])
            if box is not None and cast.is_hard and not cast.translucent:
                self._hardening.harden(own, box)
            if box is not None and own is not target:
                self._caster.merge(own, target, box)
            drawn = around(drawn, box)
        return drawn

    def _draw_piece(
        self,
        character: tuple[ShadowCast, PlacedMatte | None],
        piece: CardPiece,
        figure: _Figure,
        target: Target,
    ) -> Box | None:
        """Add what one character casts on a piece of another's card; return the box that may hold it."""
        cast, matte = character
        around_part = bounding_box(piece.part_of(figure.box))
        part = None if around_part is None else around_part.intersection(target.box)
        if part is None or matte is None:
            return None
        whole = self._scratches.like("whole", target)
        alone = replace(cast, receivers=(receiver_of(cast.camera, piece),))
        box = self._caster.unite(alone, matte, whole, Window(part))
        if box is None:
            return None
        texture = self._alphas.made_of(figure.alpha, partial(_uploaded, figure.alpha))
        target.bind(box)
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendFunc(GL.GL_ONE, GL.GL_ONE)
        whole.texture.bind(0)
        texture.bind(1)
        switches, limits = piece_limits(piece)
        self._cut[switches | figure.switches].use(
            {
                "u_target_size_px": target.size_px,
                "u_coverage": 0,
                "u_alpha": 1,
                **figure.uniforms,
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
