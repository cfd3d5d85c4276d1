"""The pass that blurs a shadow on its receiver: in bands, each as coarse as its blur allows, all of them at once."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.geometry.vectors import Matrix
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.mattes import PlacedMatte
from kagezou.render.gpu.program import Variants
from kagezou.render.gpu.scratches import GrowingTarget
from kagezou.render.gpu.targets import Format, Target, Texture
from kagezou.render.passes.cast import CastPass
from kagezou.render.passes.plane_cast import PlaneCast
from kagezou.render.prepare.area_level import Counted, area_preserving_level
from kagezou.render.prepare.area_level import Floats as Texels
from kagezou.render.prepare.band_atlas import Strip
from kagezou.render.prepare.blur_kernel import elongated
from kagezou.render.prepare.blur_tiles import MANY_TEXELS, BlurTiles, blur_tiles
from kagezou.render.prepare.filter_charts import Receivers, counted_texels
from kagezou.render.prepare.filter_job import FilterJob
from kagezou.render.prepare.filter_uniforms import Uniforms
from kagezou.render.prepare.held_shape import slide_of
from kagezou.render.prepare.outline_tiles import Tables
from kagezou.render.prepare.strip_uniforms import STRIPS, blur_uniforms, box_array, held_box, numbered
from kagezou.scene.scene import ShadowCast

_MARGIN_TEXELS = 2

_Part = tuple[Strip, Box | BlurTiles]
"""What of a strip is summed up."""

_ALONG_V, _ALONG_U = frozenset({"ALONG_V"}), frozenset({"ALONG_U"})


@dataclass(frozen=True, slots=True, eq=False)
class Blurred:
    """A job that is done: the level of its shape, and what each of its strips holds; with tables of that."""

    job: FilterJob
    matte: PlacedMatte
    level: float
    values: tuple[Texels, ...]
    tables: Tables = field(default_factory=Tables)

    def pairs(self, chart: int) -> list[tuple[Strip, Texels]]:
        """Return the strips of a chart, and what they hold."""
        first, last = self.job.bands_of(chart)
        return list(zip(self.job.strips[first:last], self.values[first:last], strict=True))


class BlurPass:
    """Blurs shadows that another pass casts for it, in an atlas of its own."""

    def __init__(self, boxes: Boxes, caster: CastPass) -> None:
        self._boxes = boxes
        self._blur = Variants("passes/strips.vert", "passes/blur.frag")
        self._full = Variants("common/box.vert", "common/full.frag")
        self._plane = PlaneCast(boxes, caster)
        # For the shadow, for it blurred one way, and both ways. A wide blur of a small shadow leaves values so small
        # that only floating point keeps them apart.
        self._shadow, self._half, self._blurred = map(GrowingTarget, (Format.ALPHA16, Format.FLOAT, Format.FLOAT))

    @property
    def texture(self) -> Texture:
        """What was blurred last."""
        return self._blurred.target.texture

    def stretch(self, cast: ShadowCast, matte: PlacedMatte, canvas_from_plane: Matrix) -> Matrix:
        """Return the ``ground_from_blurred`` (2, 2) of a cast's kernel: as long as the shadow, where that is asked."""
        if cast.simplify is None or cast.simplify.elongation <= 0:
            return np.eye(2)
        return elongated(self._plane.outlined(cast, matte, canvas_from_plane), cast.simplify.elongation)

    def blurred(self, job: FilterJob, matte: PlacedMatte, receivers: Receivers) -> Blurred:
        """Blur a job; what is returned holds until the next one is made."""
        width = max((strip.box.right for strip in job.strips), default=1)
        height = max((strip.box.bottom for strip in job.strips), default=1)
        atlases = (self._shadow, self._half, self._blurred)
        shadow, half, blurred = (each.at_least(width, height) for each in atlases)
        for chart in job.charts:
            self._plane.fill(job, matte, chart, shadow)
        # What lies beside the narrow strips is not read.
        before = [shadow.read_floats(strip.box) for strip in job.strips]
        tiles = {s: blur_tiles(s, texels) for s, texels in zip(job.strips, before, strict=True) if _is_large(s)}
        uniforms = blur_uniforms(job)
        held = [(strip, held_box(chart, strip)) for chart in job.charts for strip in chart.strips]
        self._sum((shadow, half), _ALONG_V, [(s, tiles[s][0] if s in tiles else box) for s, box in held], uniforms)
        shown = [(strip, tiles[strip][1] if strip in tiles else strip.shown) for strip in job.strips]
        self._sum((half, blurred), _ALONG_U, shown, uniforms)
        after = [blurred.read_floats(strip.shown) for strip in job.strips]
        counts = [
            counted_texels(job, receivers, chart, strip, _MARGIN_TEXELS)
            for chart in job.charts
            for strip in chart.strips
        ]
        counted = [
            _counted(strip, texels, count, tiles[strip][1] if strip in tiles else None)
            for strip, count, *texels in zip(job.strips, counts, before, after, strict=True)
        ]
        level, alone = area_preserving_level(counted), job.charts[0].strips
        job = replace(job, slide=slide_of(job, alone, counted[: len(alone)], level))
        return Blurred(job, matte, level, tuple(each.blurred for each in counted))

    def close(self) -> None:
        """Give the memory back."""
        self._blur.close()
        self._full.close()
        self._plane.close()
        for atlas in (self._shadow, self._half, self._blurred):
            atlas.close()

    def _sum(
        self, way: tuple[Target, Target], direction: frozenset[str], parts: Sequence[_Part], uniforms: Uniforms
    ) -> None:
        """Blur strips from one atlas into the other: first across the contact line, then along it."""
        source, goal = way
        if not parts:
            return
        goal.bind()
        size: Uniforms = {"u_target_size_px": goal.size_px}
        tiled = [(strip.shown, part.full) for strip, part in parts if isinstance(part, BlurTiles)]
        if tiled:
            self._full[frozenset()].use(size | {"u_strength": 0.0})
            self._boxes.draw(np.concatenate([box_array(shown) for shown, _ in tiled]))
            self._full[frozenset()].use(size | {"u_strength": 1.0})
            self._boxes.draw(np.concatenate([full for _, full in tiled]))
        source.texture.bind(0)
        self._blur[STRIPS | direction].use(size | uniforms)
        summed = [part.summed if isinstance(part, BlurTiles) else box_array(part) for _, part in parts]
        boxes, numbers = numbered(summed)
        self._boxes.load_numbered(boxes, numbers)
        self._boxes.draw_loaded(0, len(boxes))


def _is_large(strip: Strip) -> bool:
    return strip.shown.width * strip.shown.height > MANY_TEXELS


def _counted(
    strip: Strip, texels: Sequence[Texels], counts: NDArray[np.bool_] | None, tiles: BlurTiles | None
) -> Counted:
    """Return the shown part of a strip; ``texels`` are all of it before the blur, and that part after it."""
    shown, (before, after) = strip.shown, texels
    sharp = before[shown.top - strip.box.top : shown.bottom - strip.box.top]
    corners = None if tiles is None else tiles.corners - (shown.left, shown.top)
    return Counted(sharp, after, strip.row_areas(_MARGIN_TEXELS), _MARGIN_TEXELS, counts, corners)
