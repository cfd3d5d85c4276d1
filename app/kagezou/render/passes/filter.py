"""The pass that gives a shadow its shape: the united one is blurred on its receiver and brought back to its area.

Simplification (paper 3.6.1), waves (3.6.2) and wide or moved edges all read this one blurred shadow.
"""

from dataclasses import dataclass, replace

from kagezou.geometry.box import Box, around
from kagezou.geometry.contact import contact_plane
from kagezou.geometry.ground import canvas_from_plane
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.gl import GL
from kagezou.render.gpu.mattes import PlacedMatte
from kagezou.render.gpu.program import Variants
from kagezou.render.gpu.targets import Format, Target
from kagezou.render.passes.blur import BlurPass, Blurred
from kagezou.render.passes.cast import CastPass, Window
from kagezou.render.prepare.filter_boxes import box_near_contact, box_seen, sure_values
from kagezou.render.prepare.filter_charts import Receivers, charted
from kagezou.render.prepare.filter_job import (
    BlurView,
    FilterJob,
    blur_of,
    extent_of,
    stretched,
)
from kagezou.render.prepare.filter_uniforms import JOINED, shape_uniforms, slit_uniforms, strength
from kagezou.render.prepare.outline_tiles import SeenChart, ShownTiles, outline_tiles
from kagezou.render.prepare.shadow_tiles import around_boxes
from kagezou.scene.scene import ShadowCast

_AROUND_SHARP_PX = 16
"""As much more of a shadow is cast as it is, so that it need not be cast again for a little more distance."""


@dataclass(frozen=True, slots=True, eq=False)
class _SharpKept:
    """The shadow as it is, cast last: on one receiver and unfiltered, in which part of which target."""

    target_box: Box
    cast: ShadowCast
    matte: PlacedMatte
    box: Box
    drawn: Box | None

    def holds(self, cast: ShadowCast, matte: PlacedMatte, box: Box) -> bool:
        """Return whether it shows a cast in a box."""
        return self.box.union(box) == self.box and self.matte == matte and self.cast == cast


class ShapePass:
    """Draws filtered shadows, of shadows that another pass casts for it."""

    def __init__(self, boxes: Boxes, caster: CastPass) -> None:
        self._boxes = boxes
        self._caster = caster
        self._show = Variants("common/box.vert", "passes/shape.frag")
        self._fill = Variants("common/box.vert", "common/full.frag")
        self._blur = BlurPass(boxes, caster)
        self._sharp: Target | None = None
        self._sharp_kept: _SharpKept | None = None

    def draw(self, cast: ShadowCast, matte: PlacedMatte | None, target: Target, old: Box | None) -> Box | None:
        """Draw into ``target``, clearing ``old``; return the box that may hold shadow, None for none."""
        if old is not None:
            target.clear(old)
        if matte is None or not cast.is_filtered:
            return None
        drawn: Box | None = None
        for receiver in cast.receivers:
            blurred = self.blurred(replace(cast, receivers=(receiver,)), matte, Receivers({}))
            box = None if blurred is None else self.show(blurred, BlurView.of_ground(blurred.job, target.box), target)
            drawn = around(drawn, box)
        return drawn

    def blurred(self, cast: ShadowCast, matte: PlacedMatte, receivers: Receivers) -> Blurred | None:
        """Blur a cast on one receiver, and on the faces beside it; None where its shadow falls nowhere.

        What is returned holds until the next one is made.
        """
        flat = self._job(cast, matte)
        return None if flat is None else self._blur.blurred(charted(flat, receivers), matte, receivers)

    def show(self, blurred: Blurred, view: BlurView, target: Target, sharp: Target | None = None) -> Box | None:
        """Draw what a receiver shows of a blurred shadow; return the box that may hold it.

        ``sharp`` is the shadow as it would be unfiltered, as large as the target; without it, it is cast.
        """
        sharp_box = self._cast_sharp(view, blurred.matte, target) if sharp is None else box_near_contact(view)
        box = box_seen(view, sharp_box)
        if box is not None:
            looks = [SeenChart(blurred.pairs(view.chart), view.blurred_from_canvas)]
            for join in view.joins:
                there = view.there_from_here(join) @ view.blurred_from_canvas
                looks.append(SeenChart(blurred.pairs(join.chart), there, view.seam_of(join), view.reach_of(join)))
            reach = sure_values(view.job, blurred.level)
            tiles = outline_tiles(looks, reach, view.job.blur, box, blurred.tables)
            unfiltered = sharp or self._sharp
            assert unfiltered is not None
            self._show_tiles(view, (target, unfiltered), box, tiles, blurred.level)
            box = around_boxes(tiles.all)
        return box

    def close(self) -> None:
        """Give the memory back."""
        self._blur.close()
        self._show.close()
        self._fill.close()
        if self._sharp is not None:
            self._sharp.close()

    def _job(self, cast: ShadowCast, matte: PlacedMatte) -> FilterJob | None:
        """Return what is to be done for a cast on one receiver, None where its shadow falls nowhere."""
        plane = contact_plane(cast.card, cast.receivers[0])
        on_canvas = canvas_from_plane(cast.camera, plane)
        stretch = self._blur.stretch(cast, matte, on_canvas)
        extent = extent_of(cast, matte, stretched(on_canvas, stretch))
        if extent is None:
            return None
        return FilterJob(cast, matte, plane, stretch, extent, blur_of(cast, float(stretch[1, 1])))

    def _cast_sharp(self, view: BlurView, matte: PlacedMatte, like: Target) -> Box | None:
        """Cast the shadow as it is, for where it stays so, unless that is there; return its box."""
        wanted = box_near_contact(view)
        if wanted is None:
            if self._sharp is None:
                self._sharp_like(like, None)
            return None
        cast = replace(view.job.cast, receivers=(view.receiver,), simplify=None, edge=None, water=None)
        kept = self._sharp_kept
        if kept is not None and kept.target_box == like.box and kept.holds(cast, matte, wanted):
            return kept.drawn
        box = wanted.grown(_AROUND_SHARP_PX).intersection(like.box) or wanted
        sharp = self._sharp_like(like, kept)
        # A failure half-way leaves no one knows what.
        self._sharp_kept = None
        drawn = self._caster.unite(cast, matte, sharp, Window(box, is_shape_only=True))
        self._sharp_kept = _SharpKept(like.box, cast, matte, box, drawn)
        return drawn

    def _sharp_like(self, like: Target, kept: "_SharpKept | None") -> Target:
        """Return an empty target for the shadow as it is."""
        sharp = self._sharp
        if sharp is not None and sharp.box == like.box and kept is not None:
            sharp.clear(kept.box)
            return sharp
        if sharp is None or sharp.box != like.box:
            if sharp is not None:
                sharp.close()
            sharp = self._sharp = Target(like.box.width, like.box.height, Format.ALPHA16)
        sharp.clear()
        return sharp

    def _show_tiles(
        self, view: BlurView, targets: tuple[Target, Target], box: Box, tiles: ShownTiles, level: float
    ) -> None:
        """Draw the tiles within the shape, and those its outline crosses, as strong as the light makes them.

        ``targets`` are the one drawn into, and the shadow as it would be unfiltered.
        """
        target, sharp = targets
        switches, common = strength(view, box)
        common["u_target_size_px"] = target.size_px
        slit_switch, slits = slit_uniforms(view, box)
        target.bind()
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendEquation(GL.GL_MAX)
        if len(tiles.full):
            self._fill[switches | slit_switch].use(common | slits)
            self._boxes.draw(tiles.full)
        if not len(tiles.outline) and not len(tiles.joined):
            return
        self._blur.texture.bind(0)
        sharp.texture.bind(1)
        wanted, uniforms = shape_uniforms(view, box, level)
        for boxes, left_out in ((tiles.outline, JOINED), (tiles.joined, frozenset())):
            if len(boxes):
                self._show[(switches | slit_switch | wanted) - left_out].use(common | slits | uniforms)
                self._boxes.draw(boxes)
