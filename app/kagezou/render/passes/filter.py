"""The pass that gives a shadow its shape: the united one is blurred on its receiver and brought back to its area.

Simplification (paper 3.6.1), waves (3.6.2) and wide or moved edges all read this one blurred shadow.
"""

from dataclasses import replace

import numpy as np

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
from kagezou.render.prepare.filter_uniforms import shape_uniforms, slit_uniforms, strength
from kagezou.render.prepare.outline_tiles import SeenChart, outline_tiles
from kagezou.render.prepare.shadow_tiles import Boxes as TileBoxes
from kagezou.render.prepare.shadow_tiles import around_boxes
from kagezou.scene.scene import ShadowCast


class ShapePass:
    """Draws filtered shadows, of shadows that another pass casts for it."""

    def __init__(self, boxes: Boxes, caster: CastPass) -> None:
        self._boxes = boxes
        self._caster = caster
        self._show = Variants("common/box.vert", "passes/shape.frag")
        self._fill = Variants("common/box.vert", "common/full.frag")
        self._blur = BlurPass(boxes, caster)
        self._sharp: Target | None = None
        self._sharp_box: Box | None = None

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
            tiles = outline_tiles(looks, sure_values(view.job, blurred.level), view.job.blur, box)
            unfiltered = sharp or self._sharp
            assert unfiltered is not None
            self._show_tiles(view, (target, unfiltered), box, tiles, blurred.level)
            box = around_boxes(np.concatenate(tiles))
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
        """Cast the shadow as it is, for where it stays so; return its box."""
        if self._sharp is not None and self._sharp.box != like.box:
            self._sharp.close()
            self._sharp = None
            self._sharp_box = None
        if self._sharp is None:
            self._sharp = Target(like.box.width, like.box.height, Format.ALPHA16)
            self._sharp.clear()
        if self._sharp_box is not None:
            self._sharp.clear(self._sharp_box)
        self._sharp_box = box_near_contact(view)
        if self._sharp_box is None:
            return None
        cast = replace(view.job.cast, receivers=(view.receiver,))
        return self._caster.unite(cast, matte, self._sharp, Window(self._sharp_box, is_shape_only=True))

    def _show_tiles(
        self, view: BlurView, targets: tuple[Target, Target], box: Box, tiles: tuple[TileBoxes, TileBoxes], level: float
    ) -> None:
        """Draw the tiles within the shape, and those its outline crosses, as strong as the light makes them.

        ``targets`` are the one drawn into, and the shadow as it would be unfiltered.
        """
        target, sharp = targets
        full, outline = tiles
        switches, common = strength(view, box)
        common["u_target_size_px"] = target.size_px
        slit_switch, slits = slit_uniforms(view, box)
        target.bind()
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendEquation(GL.GL_MAX)
        if len(full):
            self._fill[switches | slit_switch].use(common | slits)
            self._boxes.draw(full)
        if len(outline):
            self._blur.texture.bind(0)
            sharp.texture.bind(1)
            wanted, uniforms = shape_uniforms(view, box, level)
            self._show[switches | slit_switch | wanted].use(common | slits | uniforms)
            self._boxes.draw(outline)
