"""The united shadow on its receiver, cast once: for the strips it is blurred in, and for its own moments."""

from collections.abc import Sequence
from dataclasses import replace
from functools import reduce
from itertools import groupby, pairwise
from math import ceil, floor, log2

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.polygon import bounding_box
from kagezou.geometry.sets.laid_flat import lines_of, moved
from kagezou.geometry.vectors import Matrix
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.mattes import PlacedMatte
from kagezou.render.gpu.program import Program, Variants
from kagezou.render.gpu.scratches import Scratches
from kagezou.render.gpu.targets import Format, Target
from kagezou.render.passes.cast import CastPass, Window
from kagezou.render.prepare.area_level import Floats as Texels
from kagezou.render.prepare.filter_job import BlurView, Chart, FilterJob, beyond_of, extent_of
from kagezou.render.prepare.shadow_tiles import CELLS
from kagezou.render.prepare.uniforms import LAST_LEVEL, Uniform
from kagezou.scene.scene import ShadowCast

_MOST_POLYGONS, _MOST_SIDES = 24, 120

_TABLES = frozenset({f"MAX_POLYGONS {_MOST_POLYGONS}", f"MAX_SIDES {_MOST_SIDES}"})

_OUTLINED_TEXELS = 64

_COARSEST_CAST = 1
"""Means of a finer cast cost less than one whose every texel is split into many cells."""


class PlaneCast:
    """Draws whole shadows on their receivers, seen by the canvas or not."""

    def __init__(self, boxes: Boxes, caster: CastPass) -> None:
        self._boxes = boxes
        self._caster = caster
        self._reduce = Variants("common/box.vert", "passes/reduce.frag")
        self._paste = Variants("common/box.vert", "passes/paste.frag")
        self._copy = Program("common/box.vert", "passes/shifted.frag")
        self._wholes: list[Target | None] = [None, None]
        self._ground_first: tuple[int, ...] = (0, 0)
        self._ground_box = Box(0, 0, 0, 0)
        self._scratches = Scratches()

    def close(self) -> None:
        """Give the memory back."""
        self._reduce.close()
        self._paste.close()
        self._copy.close()
        self._scratches.close()
        for target in self._wholes:
            if target is not None:
                target.close()

    def fill(self, job: FilterJob, matte: PlacedMatte, chart: Chart, shadow: Target) -> None:
        """Cast the shadow once, at least as fine as any strip wants it, and fill a chart's strips with means of it.

        The first chart of a job, that of the ground alone, is asked for before the others, which have it under theirs.
        """
        level = min((_COARSEST_CAST, *(strip.band.level for strip in job.strips)))
        texel = 2.0**level
        low, high = (chart.extent.left, chart.extent.low), (chart.extent.right, chart.extent.high)
        first = tuple(floor(each / texel) - 1 for each in low)
        width, height = (ceil(end / texel) + 1 - start for end, start in zip(high, first, strict=True))
        box = Box(0, 0, width, height)
        is_first = not job.development.charts[chart.number]
        if is_first:
            self._ground_first = first
        whole = self._whole_of(width, height, of_ground=is_first)
        whole.clear(box)
        plane_from_whole = np.array([[texel, 0.0, first[0] * texel], [0.0, texel, first[1] * texel], [0.0, 0.0, 1.0]])
        # The shape alone is filtered; its strength under a low light is applied where it is shown.
        window = Window(box, plane_from_whole, _cells_at(level), is_shape_only=True)
        if is_first:
            held = self._cast(BlurView.of_ground(job, box), matte, whole, window)
            self._ground_box = box
        else:
            self._lay_ground(whole, box, first)
            self._cast_sheets(job, matte, chart, whole, window)
            held = box
        if held is None:
            return
        for strip in chart.strips:
            corner = (round(strip.band.needed.left / texel) - first[0], round(strip.band.needed.low / texel) - first[1])
            side = 1 << (strip.band.level - level)
            part = _reduced(held.moved(-corner[0], -corner[1]), side).moved(strip.box.left, strip.box.top)
            self._reduce_to(part.intersection(strip.box), side, (whole, box), (shadow, strip.box), corner)

    def _reduce_to(
        self,
        part: Box | None,
        side: int,
        source: tuple[Target, Box],
        goal: tuple[Target, Box],
        corner: tuple[int, int],
    ) -> None:
        """Fill a part of a strip with means of squares of a side; what is around it holds nothing.

        ``source`` is the shadow and its box, ``goal`` the atlas and the strip's box, ``corner`` where in the source the
        strip begins.
        """
        if part is None:
            return
        (whole, known), (shadow, strip) = source, goal
        shadow.bind(part)
        whole.texture.bind(0)
        self._reduce[frozenset({f"SIDE {side}"})].use(
            {
                "u_target_size_px": shadow.size_px,
                "u_source": 0,
                "u_corner": (float(corner[0]), float(corner[1])),
                "u_first": (float(strip.left), float(strip.top)),
                "u_known": (0.0, 0.0, float(known.right - 1), float(known.bottom - 1)),
            }
        )
        self._boxes.draw_one(part)

    def _cast(self, view: BlurView, matte: PlacedMatte, target: Target, window: Window) -> Box | None:
        """Cast the shadow on one receiver into a picture of the blur's plane."""
        assert window.canvas_from_target is not None
        cast = replace(view.job.cast, receivers=(view.receiver,))
        on_canvas = replace(window, canvas_from_target=view.canvas_from_blurred @ window.canvas_from_target)
        return self._caster.unite(cast, matte, target, on_canvas)

    def _cast_sheets(self, job: FilterJob, matte: PlacedMatte, chart: Chart, whole: Target, window: Window) -> None:
        """Cast the shadow on each sheet of a chart, and lay what is uppermost over the ground."""
        assert window.canvas_from_target is not None
        alone = self._scratches.like("alone", whole)
        flat_from_target = np.eye(3)
        flat_from_target[:2, :2] = job.ground_from_blurred
        target_from_flat: Matrix = np.asarray(np.linalg.inv(flat_from_target @ window.canvas_from_target), np.float64)
        outlines = job.development.outlines(chart.number, beyond_of(job, chart))
        for number, group in groupby(outlines, key=lambda outline: outline.sheet):
            parts = [[moved(target_from_flat, each) for each in (outline.corners, *outline.over)] for outline in group]
            boxes = [bounding_box(polygons[0]) for polygons in parts]
            around = [box for box in (each and each.grown(1).intersection(window.box) for each in boxes) if box]
            if not around:
                continue
            part = reduce(Box.union, around)
            box = self._cast(BlurView.of_sheet(job, number, window.box), matte, alone, replace(window, box=part))
            for polygons in parts:
                self._lay(alone, polygons, part, whole)
            if box is not None:
                alone.clear(box)

    def _lay_ground(self, whole: Target, box: Box, first: tuple[int, ...]) -> None:
        """Copy the shadow on the ground alone into a picture of another part of it."""
        ground = self._wholes[0]
        assert ground is not None
        shift = [own - other for own, other in zip(self._ground_first, first, strict=True)]
        part = self._ground_box.moved(*shift).intersection(box)
        if part is not None:
            whole.bind(part)
            ground.texture.bind(0)
            uniforms: dict[str, Uniform] = {"u_target_size_px": whole.size_px, "u_source": 0}
            self._copy.use(uniforms | {"u_shift": (float(shift[0]), float(shift[1]))})
            self._boxes.draw_one(part)

    def _lay(self, alone: Target, polygons: Sequence[Matrix], box: Box, whole: Target) -> None:
        """Lay what is within the first polygon, and within none of the others, into the picture of them all."""
        sides = [lines_of(polygon) for polygon in polygons[:_MOST_POLYGONS] if len(polygon)]
        ends = np.cumsum([0, *(len(each) for each in sides)])
        whole.bind(box)
        alone.texture.bind(0)
        uniforms: dict[str, Uniform] = {"u_target_size_px": whole.size_px, "u_source": 0, "u_polygon_count": len(sides)}
        uniforms["u_sides"] = np.pad(np.concatenate(sides), ((0, 0), (0, 1)))[:_MOST_SIDES]
        uniforms["u_polygons"] = np.array([(first, last, 0, 0) for first, last in pairwise(ends)], np.float64)
        self._paste[_TABLES].use(uniforms)
        self._boxes.draw_one(box)

    def outlined(self, cast: ShadowCast, matte: PlacedMatte, canvas_from_plane: Matrix) -> Texels:
        """Return the whole shadow on its receiver in few texels, to see how long it is."""
        extent = extent_of(cast, matte, canvas_from_plane)
        if extent is None:
            return np.zeros((0, 0), np.float32)
        texel = max(extent.right - extent.left, extent.high - extent.low) / _OUTLINED_TEXELS
        box = Box(0, 0, *(ceil(side / texel) for side in (extent.right - extent.left, extent.high - extent.low)))
        shadow = self._whole_of(box.width, box.height, of_ground=True)
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
            old = self._wholes[index] = Target(width, height, Format.ALPHA16)
        return old


def _reduced(box: Box, side: int) -> Box:
    """Return the box of squares of a side that hold any of a box."""
    return Box(box.left // side, box.top // side, -(-box.right // side), -(-box.bottom // side))


def _cells_at(level: int) -> int:
    """Return into how many cells a texel of a level may be split.

    Coarse texels, to be blurred anyway, are means of few cells; where squares of the matte's coarsest mipmap no longer
    fill a cell there have to be more of them again.
    """
    return CELLS[-1] if level < 2 else min(max(16, 1 << max(level - LAST_LEVEL + 3, 0)), CELLS[-1])
