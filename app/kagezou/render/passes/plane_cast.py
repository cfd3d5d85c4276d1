"""The united shadow on its receiver, cast once: for the strips it is blurred in, and for its own moments."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import groupby, pairwise
from math import ceil, log2

import numpy as np

from kagezou.geometry.box import Box, around
from kagezou.geometry.polygon import bounding_box
from kagezou.geometry.sets.laid_flat import lines_of, moved
from kagezou.geometry.vectors import Matrix
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.mattes import PlacedMatte
from kagezou.render.gpu.program import Program, Variants
from kagezou.render.gpu.scratches import Scratches
from kagezou.render.gpu.targets import Format, Target
from kagezou.render.passes.cast import CastPass, Window
from kagezou.render.passes.halving import HalvingPass
from kagezou.render.prepare.area_level import Floats as Texels
from kagezou.render.prepare.filter_job import BlurView, Chart, FilterJob, beyond_of, extent_of
from kagezou.render.prepare.polygon_tiles import polygon_tiles
from kagezou.render.prepare.shadow_levels import ShadowLevels
from kagezou.render.prepare.shadow_tiles import CELLS
from kagezou.render.prepare.strip_uniforms import STRIPS, box_array, crop_uniforms, numbered
from kagezou.render.prepare.uniforms import LAST_LEVEL, Uniform
from kagezou.scene.scene import ShadowCast

_MOST_POLYGONS, _MOST_SIDES = 24, 120

_TABLES = frozenset({f"MAX_POLYGONS {_MOST_POLYGONS}", f"MAX_SIDES {_MOST_SIDES}"})

_OUTLINED_TEXELS = 64

_LEAST_COARSEST = 4
"""At least down to this level a cast is made coarser, so that a wider blur finds it there."""

_COARSEST_CAST = 1
"""Means of a finer cast cost less than one whose every texel is split into many cells."""

_MOST_TEXELS = 4096
"""Along a side of the finest picture of a shadow, unless a strip of it has to be finer."""


@dataclass(frozen=True, slots=True, eq=False)
class _Kept:
    """What was cast on the ground last; while only the filter changes it need not be cast again."""

    cast: ShadowCast
    matte: PlacedMatte
    ground_from_blurred: Matrix
    levels: ShadowLevels

    def holds(self, job: FilterJob, matte: PlacedMatte, levels: ShadowLevels) -> bool:
        """Return whether it is what a job wants."""
        return (
            self.levels == levels
            and self.matte == matte
            and np.array_equal(self.ground_from_blurred, job.ground_from_blurred)
            and self.cast == _unfiltered(job.cast)
        )


def _unfiltered(cast: ShadowCast) -> ShadowCast:
    return replace(cast, simplify=None, edge=None, water=None)


class PlaneCast:
    """Draws whole shadows on their receivers, seen by the canvas or not."""

    def __init__(self, boxes: Boxes, caster: CastPass) -> None:
        self._boxes = boxes
        self._caster = caster
        self._halving = HalvingPass(boxes)
        self._crop = Variants("passes/strips.vert", "passes/crop.frag")
        self._paste = Variants("common/box.vert", "passes/paste.frag")
        self._copy = Program("common/box.vert", "passes/shifted.frag")
        self._wholes: list[Target | None] = [None, None]
        self._ground_first = (0, 0)
        self._ground_held: Box | None = None
        self._kept: _Kept | None = None
        self._scratches = Scratches()

    def close(self) -> None:
        """Give the memory back."""
        self._halving.close()
        self._crop.close()
        self._paste.close()
        self._copy.close()
        self._scratches.close()
        for target in self._wholes:
            if target is not None:
                target.close()

    def fill(self, job: FilterJob, matte: PlacedMatte, chart: Chart, shadow: Target) -> None:
        """Cast the shadow once, at least as fine as any strip wants it, and fill a chart's strips with it.

        The first chart of a job, that of the ground alone, is asked for before the others, which have it under theirs.
        """
        finest = cast_level(job)
        coarsest = max((strip.band.level for strip in chart.strips), default=finest)
        levels = ShadowLevels.of(chart.extent, finest, max(coarsest, _LEAST_COARSEST))
        is_first = not job.development.charts[chart.number]
        whole = self._whole_of(levels.box.width, levels.box.height, of_ground=is_first)
        if not is_first:
            self._cast_levels(job, matte, chart, (whole, levels))
        elif self._kept is None or not self._kept.holds(job, matte, levels):
            # A failure half-way leaves no one knows what.
            self._kept = None
            self._cast_levels(job, matte, chart, (whole, levels))
            self._kept = _Kept(_unfiltered(job.cast), matte, job.ground_from_blurred, levels)
        self._fill_strips(chart, levels, whole, shadow)

    def _cast_levels(self, job: FilterJob, matte: PlacedMatte, chart: Chart, goal: tuple[Target, ShadowLevels]) -> None:
        """Cast the shadow of a chart, and fill its coarser levels."""
        whole, levels = goal
        whole.clear(levels.box)
        box = levels.box_of(levels.finest)
        # The shape alone is filtered; its strength under a low light is applied where it is shown.
        window = Window(box, levels.plane_from_target, _cells_at(levels.finest), is_shape_only=True)
        if not job.development.charts[chart.number]:
            held = self._cast(BlurView.of_ground(job, box), matte, whole, window)
            self._ground_first, self._ground_held = levels.corner, held
        else:
            held = self._lay_ground(whole, box, levels.corner)
            held = self._cast_sheets((job, matte, chart), (whole, held), window)
        if held is not None:
            self._halving.fill(whole, levels, held)

    def _fill_strips(self, chart: Chart, levels: ShadowLevels, whole: Target, shadow: Target) -> None:
        """Fill a chart's strips from the pictures of the shadow that are as fine."""
        if not chart.strips:
            return
        shadow.bind()
        whole.texture.bind(0)
        uniforms: dict[str, Uniform] = {"u_target_size_px": shadow.size_px, "u_source": 0}
        self._crop[STRIPS].use(uniforms | crop_uniforms(levels, chart.strips))
        self._boxes.load_numbered(*numbered([box_array(strip.box) for strip in chart.strips]))
        self._boxes.draw_loaded(0, len(chart.strips))

    def _cast(self, view: BlurView, matte: PlacedMatte, target: Target, window: Window) -> Box | None:
        """Cast the shadow on one receiver into a picture of the blur's plane."""
        assert window.canvas_from_target is not None
        cast = replace(view.job.cast, receivers=(view.receiver,))
        on_canvas = replace(window, canvas_from_target=view.canvas_from_blurred @ window.canvas_from_target)
        return self._caster.unite(cast, matte, target, on_canvas)

    def _cast_sheets(
        self, asked: tuple[FilterJob, PlacedMatte, Chart], goal: tuple[Target, Box | None], window: Window
    ) -> Box | None:
        """Cast the shadow on each sheet of a chart, and lay what is uppermost over the ground.

        ``goal`` is where the ground is, and the box that may hold any of its shadow; returned is that of all.
        """
        assert window.canvas_from_target is not None
        (job, matte, chart), (whole, held) = asked, goal
        alone = self._scratches.like("alone", whole)
        flat_from_target = np.eye(3)
        flat_from_target[:2, :2] = job.ground_from_blurred
        target_from_flat: Matrix = np.asarray(np.linalg.inv(flat_from_target @ window.canvas_from_target), np.float64)
        outlines = job.development.outlines(chart.number, beyond_of(job, chart))
        for number, group in groupby(outlines, key=lambda outline: outline.sheet):
            parts = [[moved(target_from_flat, each) for each in (outline.corners, *outline.over)] for outline in group]
            boxes = [bounding_box(polygons[0]) for polygons in parts]
            part = around(*(each and each.grown(1).intersection(window.box) for each in boxes))
            if part is None:
                continue
            box = self._cast(BlurView.of_sheet(job, number, window.box), matte, alone, replace(window, box=part))
            # Where neither has any shadow there is nothing to be laid.
            held = around(held, box)
            shown = held and part.intersection(held)
            if shown is not None:
                for polygons in parts:
                    self._lay(alone, polygons, shown, whole)
            if box is not None:
                alone.clear(box)
        return held

    def _lay_ground(self, whole: Target, box: Box, first: tuple[int, int]) -> Box | None:
        """Copy the shadow on the ground alone into a picture of another part of it; return where it may hold any."""
        ground = self._wholes[0]
        assert ground is not None
        shift = [own - other for own, other in zip(self._ground_first, first, strict=True)]
        part = self._ground_held and self._ground_held.moved(*shift).intersection(box)
        if part is not None:
            whole.bind(part)
            ground.texture.bind(0)
            uniforms: dict[str, Uniform] = {"u_target_size_px": whole.size_px, "u_source": 0}
            self._copy.use(uniforms | {"u_shift": (float(shift[0]), float(shift[1]))})
            self._boxes.draw_one(part)
        return part

    def _lay(self, alone: Target, polygons: Sequence[Matrix], box: Box, whole: Target) -> None:
        """Lay what is within the first polygon, and within none of the others, into the picture of them all."""
        sides = [lines_of(polygon) for polygon in polygons[:_MOST_POLYGONS] if len(polygon)]
        inside, edge = polygon_tiles(sides, box)
        whole.bind(box)
        alone.texture.bind(0)
        uniforms: dict[str, Uniform] = {"u_target_size_px": whole.size_px, "u_source": 0}
        if len(inside):
            self._copy.use(uniforms | {"u_shift": (0.0, 0.0)})
            self._boxes.draw(inside)
        if len(edge):
            ends = np.cumsum([0, *(len(each) for each in sides)])
            uniforms["u_polygon_count"] = len(sides)
            uniforms["u_sides"] = np.pad(np.concatenate(sides), ((0, 0), (0, 1)))[:_MOST_SIDES]
            uniforms["u_polygons"] = np.array([(first, last, 0, 0) for first, last in pairwise(ends)], np.float64)
            self._paste[_TABLES].use(uniforms)
            self._boxes.draw(edge)

    def outlined(self, cast: ShadowCast, matte: PlacedMatte, canvas_from_plane: Matrix) -> Texels:
        """Return the whole shadow on its receiver in few texels, to see how long it is."""
        extent = extent_of(cast, matte, canvas_from_plane)
        if extent is None:
            return np.zeros((0, 0), np.float32)
        texel = max(extent.right - extent.left, extent.high - extent.low) / _OUTLINED_TEXELS
        box = Box(0, 0, *(ceil(side / texel) for side in (extent.right - extent.left, extent.high - extent.low)))
        shadow = self._whole_of(box.width, box.height, of_ground=True)
        self._kept = None
        shadow.clear(box)
        plane_from_texel = np.array([[texel, 0.0, extent.left], [0.0, texel, extent.low], [0.0, 0.0, 1.0]])
        cells = _cells_at(max(ceil(log2(texel)), 0))
        self._caster.unite(
            cast, matte, shadow, Window(box, canvas_from_plane @ plane_from_texel, cells, is_shape_only=True)
        )
        return shadow.read_floats(box)

    def _whole_of(self, width: int, height: int, *, of_ground: bool) -> Target:
        """Return a target of at least a size for the shadow before it is blurred."""
        index = 0 if of_ground else 1
        old = self._wholes[index]
        if old is None or old.box.width < width or old.box.height < height:
            if old is not None:
                width, height = max(width, old.box.width), max(height, old.box.height)
                old.close()
            if of_ground:
                self._kept = None
            old = self._wholes[index] = Target(width, height, Format.ALPHA16)
        return old


def cast_level(job: FilterJob) -> int:
    """Return how fine a job's shadow is cast: finer than any strip, but where that would be below a px or too large."""
    finest = min((strip.band.level for strip in job.strips), default=0)
    longest = max(max(c.extent.right - c.extent.left, c.extent.high - c.extent.low) for c in job.charts)
    return min(max(min(finest - 1, _COARSEST_CAST), ceil(log2(longest / _MOST_TEXELS)), 0), finest)


def _cells_at(level: int) -> int:
    """Return into how many cells a texel of a level may be split.

    Coarse texels, to be blurred anyway, are means of few cells; where squares of the matte's coarsest mipmap no longer
    fill a cell there have to be more of them again.
    """
    return CELLS[-1] if level < 2 else min(max(16, 1 << max(level - LAST_LEVEL + 3, 0)), CELLS[-1])
