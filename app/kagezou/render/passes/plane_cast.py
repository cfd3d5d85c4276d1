"""The united shadow on its receiver, cast once: for the strips it is blurred in, and for its own moments."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import groupby, pairwise
from math import ceil, log2

import numpy as np

from kagezou.geometry.box import Box, around
from kagezou.geometry.polygon import bounding_box
from kagezou.geometry.sets.laid_flat import FaceOutline, lines_of, moved
from kagezou.geometry.vectors import Matrix
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.mattes import PlacedMatte
from kagezou.render.gpu.program import Program, Variants
from kagezou.render.gpu.scratches import Scratches
from kagezou.render.gpu.targets import Format, Target
from kagezou.render.passes.cast import CastPass, Window
from kagezou.render.passes.halving import HalvingPass
from kagezou.render.prepare.area_level import Floats as Texels
from kagezou.render.prepare.band_atlas import Strip
from kagezou.render.prepare.cast_parts import cast_parts
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

_FOR_OUTLINES = -1
"""In the place of a level: the target in which the length of a shadow is seen."""


@dataclass(frozen=True, slots=True, eq=False)
class _Kept:
    """What was cast on the ground last; while only the filter changes it need not be cast again."""

    cast: ShadowCast
    matte: PlacedMatte
    ground_from_blurred: Matrix
    levels: ShadowLevels
    held: Box | None

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
        self._wholes: dict[tuple[int, bool], Target] = {}
        self._kept: dict[int, _Kept] = {}
        self._scratches = Scratches()

    def close(self) -> None:
        """Give the memory back."""
        self._halving.close()
        self._crop.close()
        self._paste.close()
        self._copy.close()
        self._scratches.close()
        for target in self._wholes.values():
            target.close()

    def fill(self, job: FilterJob, matte: PlacedMatte, chart: Chart, shadow: Target) -> None:
        """Cast the shadow, at least as fine as any strip wants it, and fill a chart's strips with it.

        The first chart of a job, that of the ground alone, is asked for before the others, which have it under theirs.
        """
        is_first = not job.development.charts[chart.number]
        for part in cast_parts(job):
            strips = [strip for strip in chart.strips if part.is_for(strip)]
            if not strips and not is_first:
                continue
            levels = part.levels(chart)
            whole = self._whole_of(part.finest, levels.box, of_ground=is_first)
            kept = self._kept.get(part.finest) if is_first else None
            if kept is None or not kept.holds(job, matte, levels):
                # A failure half-way leaves no one knows what.
                self._kept.pop(part.finest if is_first else -1, None)
                held = self._cast_levels(job, matte, chart, (whole, levels))
                if is_first:
                    cast = _unfiltered(job.cast)
                    self._kept[part.finest] = _Kept(cast, matte, job.ground_from_blurred, levels, held)
            self._fill_strips(strips, levels, whole, shadow)

    def _cast_levels(
        self, job: FilterJob, matte: PlacedMatte, chart: Chart, goal: tuple[Target, ShadowLevels]
    ) -> Box | None:
        """Cast the shadow of a chart, and fill its coarser levels; return where the finest may hold anything."""
        whole, levels = goal
        whole.clear(levels.box)
        box = levels.box_of(levels.finest)
        # The shape alone is filtered; its strength under a low light is applied where it is shown.
        window = Window(box, levels.plane_from_target, _cells_at(levels.finest), is_shape_only=True)
        if not job.development.charts[chart.number]:
            held = self._cast(BlurView.of_ground(job, box), matte, whole, window)
        else:
            held = self._lay_ground(whole, levels)
            held = self._cast_sheets((job, matte, chart), (whole, held), window)
        if held is not None:
            self._halving.fill(whole, levels, held)
        return held

    def _fill_strips(self, strips: Sequence[Strip], levels: ShadowLevels, whole: Target, shadow: Target) -> None:
        """Fill strips from the pictures of the shadow that are as fine."""
        if not strips:
            return
        shadow.bind()
        whole.texture.bind(0)
        uniforms: dict[str, Uniform] = {"u_target_size_px": shadow.size_px, "u_source": 0}
        self._crop[STRIPS].use(uniforms | crop_uniforms(levels, strips))
        self._boxes.load_numbered(*numbered([box_array(strip.box) for strip in strips]))
        self._boxes.draw_loaded(0, len(strips))

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
        stretch = np.eye(3)
        stretch[:2, :2] = job.ground_from_blurred
        flat_from_target: Matrix = np.asarray(stretch @ window.canvas_from_target, np.float64)
        target_from_flat: Matrix = np.asarray(np.linalg.inv(flat_from_target), np.float64)
        outlines = job.development.outlines(chart.number, beyond_of(job, chart))
        for number, group in groupby(outlines, key=lambda outline: outline.sheet):
            own = list(group)
            boxes = [bounding_box(moved(target_from_flat, outline.corners)) for outline in own]
            part = around(*(each and each.grown(1).intersection(window.box) for each in boxes))
            if part is None:
                continue
            box = self._cast(BlurView.of_sheet(job, number, window.box), matte, alone, replace(window, box=part))
            # Where neither has any shadow there is nothing to be laid.
            held = around(held, box)
            shown = held and part.intersection(held)
            if shown is not None:
                for outline in own:
                    self._lay(alone, [lines @ flat_from_target for lines in _lines_of(outline)], shown, whole)
            if box is not None:
                alone.clear(box)
        return held

    def _lay_ground(self, whole: Target, levels: ShadowLevels) -> Box | None:
        """Copy the shadow on the ground alone into a picture of another part of it; return where it may hold any."""
        kept, ground = self._kept[levels.finest], self._wholes[levels.finest, True]
        shift = [own - other for own, other in zip(kept.levels.corner, levels.corner, strict=True)]
        part = kept.held and kept.held.moved(*shift).intersection(levels.box_of(levels.finest))
        if part is not None:
            whole.bind(part)
            ground.texture.bind(0)
            uniforms: dict[str, Uniform] = {"u_target_size_px": whole.size_px, "u_source": 0}
            self._copy.use(uniforms | {"u_shift": (float(shift[0]), float(shift[1]))})
            self._boxes.draw_one(part)
        return part

    def _lay(self, alone: Target, sides: Sequence[Matrix], box: Box, whole: Target) -> None:
        """Lay what is within the first polygon, given by its sides, and within none of the others."""
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
        shadow = self._whole_of(_FOR_OUTLINES, box, of_ground=True)
        shadow.clear(box)
        plane_from_texel = np.array([[texel, 0.0, extent.left], [0.0, texel, extent.low], [0.0, 0.0, 1.0]])
        cells = _cells_at(max(ceil(log2(texel)), 0))
        self._caster.unite(
            cast, matte, shadow, Window(box, canvas_from_plane @ plane_from_texel, cells, is_shape_only=True)
        )
        return shadow.read_floats(box)

    def _whole_of(self, finest: int, box: Box, *, of_ground: bool) -> Target:
        """Return a target of at least a size for the shadow before it is blurred."""
        width, height = box.width, box.height
        old = self._wholes.get((finest, of_ground))
        if old is None or old.box.width < width or old.box.height < height:
            if old is not None:
                width, height = max(width, old.box.width), max(height, old.box.height)
                old.close()
                del self._wholes[finest, of_ground]
            if of_ground:
                self._kept.pop(finest, None)
            old = self._wholes[finest, of_ground] = Target(width, height, Format.ALPHA16)
        return old


@lru_cache(maxsize=1024)
def _lines_of(outline: FaceOutline) -> tuple[Matrix, ...]:
    """Return the sides of the polygons of an outline; kept, as they are flat and the light does not move them."""
    polygons = (outline.corners, *outline.over)[:_MOST_POLYGONS]
    return tuple(lines_of(each) for each in polygons if len(each))


def _cells_at(level: int) -> int:
    """Return into how many cells a texel of a level may be split.

    Coarse texels, to be blurred anyway, are means of few cells; where squares of the matte's coarsest mipmap no longer
    fill a cell there have to be more of them again.
    """
    return CELLS[-1] if level < 2 else min(max(16, 1 << max(level - LAST_LEVEL + 3, 0)), CELLS[-1])
