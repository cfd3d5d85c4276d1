"""The pass that gives a shadow its shape: the united one is blurred on its receiver and brought back to its area.

Simplification (paper 3.6.1), waves (3.6.2) and wide or moved edges all read this one blurred shadow.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import groupby
from math import ceil

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box, around
from kagezou.geometry.contact import contact_plane
from kagezou.geometry.ground import canvas_from_plane
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.gl import GL
from kagezou.render.gpu.mattes import PlacedMatte
from kagezou.render.gpu.program import Variants
from kagezou.render.gpu.targets import Format, Target
from kagezou.render.passes.cast import CastPass, Window
from kagezou.render.passes.plane_cast import PlaneCast
from kagezou.render.prepare.area_level import Counted, area_preserving_level
from kagezou.render.prepare.area_level import Floats as Texels
from kagezou.render.prepare.band_atlas import Strip
from kagezou.render.prepare.blur_kernel import elongated
from kagezou.render.prepare.blur_tiles import blur_tiles
from kagezou.render.prepare.filter_boxes import box_near_contact, box_seen, sure_values
from kagezou.render.prepare.filter_charts import Receivers, charted, counted_texels
from kagezou.render.prepare.filter_job import (
    BlurView,
    FilterJob,
    blur_of,
    extent_of,
    stretched,
)
from kagezou.render.prepare.filter_uniforms import shape_uniforms, slit_uniforms, strength, width_uniforms
from kagezou.render.prepare.held_shape import slide_of
from kagezou.render.prepare.outline_tiles import SeenChart, outline_tiles
from kagezou.render.prepare.shadow_tiles import Boxes as TileBoxes
from kagezou.render.prepare.shadow_tiles import around_boxes
from kagezou.scene.scene import ShadowCast

_MARGIN_TEXELS = 2
_LEAST_SIGMA_TEXELS = 0.3

_REACHES = (5, 7, 10, 14, 20, 28, 40, 56, 80, 112, 160, 224, 320, 448, 640, 896, 1280, 2048)
"""Over how many texels either way a blur may be summed up; each is a program of its own."""

_ALONG_V, _ALONG_U = frozenset({"ALONG_V"}), frozenset({"ALONG_U"})


@dataclass(frozen=True, slots=True, eq=False)
class Blurred:
    """A job that is done: the level of its shape, and what each of its strips holds."""

    job: FilterJob
    matte: PlacedMatte
    level: float
    values: tuple[Texels, ...]

    def pairs(self, chart: int) -> list[tuple[Strip, Texels]]:
        """Return the strips of a chart, and what they hold."""
        first, last = self.job.bands_of(chart)
        return list(zip(self.job.strips[first:last], self.values[first:last], strict=True))


class ShapePass:
    """Draws filtered shadows, of shadows that another pass casts for it."""

    def __init__(self, boxes: Boxes, caster: CastPass) -> None:
        self._boxes = boxes
        self._caster = caster
        self._blur = Variants("common/box.vert", "passes/blur.frag")
        self._show = Variants("common/box.vert", "passes/shape.frag")
        self._fill = Variants("common/box.vert", "common/full.frag")
        self._plane = PlaneCast(boxes, caster)
        self._atlases: tuple[Target, Target, Target] | None = None
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

    def blurred(self, cast: ShadowCast, matte: PlacedMatte, receivers: Receivers) -> "Blurred | None":
        """Blur a cast on one receiver, and on the faces beside it; None where its shadow falls nowhere.

        What is returned holds until the next one is made.
        """
        flat = self._job(cast, matte)
        if flat is None:
            return None
        job = charted(flat, receivers)
        shadow, half, blurred = self._atlases_for(job.strips)
        used = Box(0, 0, max((s.box.right for s in job.strips), default=0), sum(s.box.height for s in job.strips))
        for target in (shadow, half, blurred):
            self._clear_strips(target, job.strips)
        for chart in job.charts:
            self._plane.fill(job, matte, chart, shadow)
        # All strips are read at once: each reading waits for everything drawn before it.
        before = shadow.read_floats(used)
        blurred_tiles = [blur_tiles(strip, before, _reach_of(strip)) for strip in job.strips]
        self._blur_strips(job, (shadow, half), _ALONG_V, [across for across, _ in blurred_tiles])
        self._blur_strips(job, (half, blurred), _ALONG_U, [along for _, along in blurred_tiles])
        after = blurred.read_floats(used)
        counted = [
            _counted(strip, before, after, counted_texels(job, receivers, chart, strip, _MARGIN_TEXELS))
            for chart in job.charts
            for strip in chart.strips
        ]
        level, alone = area_preserving_level(counted), job.charts[0].strips
        job = replace(job, slide=slide_of(job, alone, counted[: len(alone)], level))
        return Blurred(job, matte, level, tuple(each.blurred for each in counted))

    def show(self, blurred: "Blurred", view: BlurView, target: Target, sharp: Target | None = None) -> Box | None:
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
        self._plane.close()
        for target in (*(self._atlases or ()), self._sharp):
            if target is not None:
                target.close()

    def _job(self, cast: ShadowCast, matte: PlacedMatte) -> FilterJob | None:
        """Return what is to be done for a cast on one receiver, None where its shadow falls nowhere."""
        plane = contact_plane(cast.card, cast.receivers[0])
        on_canvas = canvas_from_plane(cast.camera, plane)
        stretch = np.eye(2)
        if cast.simplify is not None and cast.simplify.elongation > 0:
            stretch = elongated(self._plane.outlined(cast, matte, on_canvas), cast.simplify.elongation)
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

    @staticmethod
    def _clear_strips(target: Target, strips: Sequence[Strip]) -> None:
        """Clear the strips of an atlas; beside the narrow ones there may be anything."""
        for width, beside in groupby(strips, key=lambda strip: strip.box.right):
            rows = [strip.box for strip in beside]
            target.clear(Box(0, rows[0].top, width, rows[-1].bottom))

    def _blur_strips(
        self, job: FilterJob, way: tuple[Target, Target], direction: frozenset[str], blurred_tiles: Sequence[TileBoxes]
    ) -> None:
        """Blur every strip from one atlas into the other: first across the contact line, then along it."""
        source, goal = way
        for strip, tiles in zip(job.strips, blurred_tiles, strict=True):
            program = self._blur[direction | {f"REACH {_reach_of(strip)}"}]
            known = strip.box if direction == _ALONG_V else strip.shown
            goal.bind(strip.shown)
            source.texture.bind(0)
            program.use(
                {
                    "u_target_size_px": goal.size_px,
                    "u_source": 0,
                    "u_band": (float(known.left), float(known.top), float(known.right - 1), float(known.bottom - 1)),
                    "u_first_v_px": strip.band.needed.low,
                    "u_first_row": float(strip.box.top),
                    "u_texel_px": strip.band.texel_px,
                    "u_least_sigma": _LEAST_SIGMA_TEXELS,
                    **width_uniforms(job),
                }
            )
            self._boxes.draw(tiles)

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
            self._atlases_for(view.job.strips)[2].texture.bind(0)
            sharp.texture.bind(1)
            wanted, uniforms = shape_uniforms(view, box, level)
            self._show[switches | slit_switch | wanted].use(common | slits | uniforms)
            self._boxes.draw(outline)

    def _atlases_for(self, strips: tuple[Strip, ...]) -> tuple[Target, Target, Target]:
        """Return targets of at least the strips' size: for the shadow, and for it blurred one way and both ways."""
        width = max((strip.box.right for strip in strips), default=1)
        height = max((strip.box.bottom for strip in strips), default=1)
        return self._atlases_of(width, height)

    def _atlases_of(self, width: int, height: int) -> tuple[Target, Target, Target]:
        """Return targets of at least a size.

        A wide blur of a small shadow leaves values so small that only floating point keeps them apart.
        """
        old = self._atlases
        if old is None or old[0].box.width < width or old[0].box.height < height:
            for target in old or ():
                width, height = max(width, target.box.width), max(height, target.box.height)
                target.close()
            self._atlases = None
            forms = (Format.ALPHA16, Format.FLOAT, Format.FLOAT)
            shadow, half, blurred = (Target(width, height, form) for form in forms)
            self._atlases = (shadow, half, blurred)
        assert self._atlases is not None
        return self._atlases


def _reach_of(strip: Strip) -> int:
    """Return over how many texels either way a strip's blur is summed up."""
    return next(each for each in _REACHES if each >= min(ceil(strip.band.reach_texels), _REACHES[-1]))


def _counted(strip: Strip, before: Texels, after: Texels, counts: NDArray[np.bool_] | None) -> Counted:
    shown = strip.shown
    part = (slice(shown.top, shown.bottom), slice(shown.left, shown.right))
    return Counted(before[part], after[part], strip.row_areas(_MARGIN_TEXELS), _MARGIN_TEXELS, counts)
