"""The united shadow on its receiver, cast once: for the strips it is blurred in, and for its own moments."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import ceil, floor, log2

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.development import lines_of, moved
from kagezou.geometry.regions import Group, Region
from kagezou.geometry.vectors import Matrix
from kagezou.render.boxes import Boxes
from kagezou.render.cast_pass import CastPass, Window
from kagezou.render.level import Floats as Texels
from kagezou.render.mattes import PlacedMatte
from kagezou.render.program import Program
from kagezou.render.set_adding import Adding
from kagezou.render.set_tiles import Mask
from kagezou.render.shape_job import Chart, Job, View, extent_of
from kagezou.render.targets import LAST_LEVEL, Format, Target
from kagezou.render.tiles import CELLS
from kagezou.scene.scene import ShadowCast

_OUTLINED_TEXELS = 64

_COARSEST_CAST = 1
"""Means of a finer cast cost less than one whose every texel is split into many cells."""


class PlaneCast:
    """Draws whole shadows on their receivers, seen by the canvas or not."""

    def __init__(self, boxes: Boxes, caster: CastPass) -> None:
        self._boxes = boxes
        self._caster = caster
        self._reduce = Program("box.vert", "reduce.frag")
        self._adding = Adding(boxes, caster)
        self._whole: Target | None = None
        self._alone: Target | None = None

    def close(self) -> None:
        """Give the memory back."""
        self._reduce.close()
        self._adding.close()
        for target in (self._whole, self._alone):
            if target is not None:
                target.close()

    def fill(self, job: Job, chart: Chart, shadow: Target) -> None:
        """Cast the shadow once, at least as fine as any strip wants it, and fill a chart's strips with means of it."""
        level = min((_COARSEST_CAST, *(strip.band.level for strip in chart.strips)))
        texel = 2.0**level
        low, high = (chart.extent.left, chart.extent.low), (chart.extent.right, chart.extent.high)
        first = tuple(floor(each / texel) - 1 for each in low)
        width, height = (ceil(end / texel) + 1 - start for end, start in zip(high, first, strict=True))
        box = Box(0, 0, width, height)
        whole = self._whole_of(width, height)
        whole.clear(box)
        plane_from_whole = np.array([[texel, 0.0, first[0] * texel], [0.0, texel, first[1] * texel], [0.0, 0.0, 1.0]])
        # The shape alone is filtered; how strong it is under a low light is told where it is shown.
        window = Window(box, plane_from_whole, _cells_at(level), is_shape_only=True)
        if job.development.charts[chart.number]:
            self._cast_sheets(job, chart, whole, window)
        else:
            self._cast(View.of_ground(job, box), whole, window)
        for strip in chart.strips:
            corner = (round(strip.band.needed.left / texel) - first[0], round(strip.band.needed.low / texel) - first[1])
            shadow.bind(strip.box)
            whole.texture.bind(0)
            self._reduce.use(
                {
                    "u_target_size_px": shadow.size_px,
                    "u_source": 0,
                    "u_corner": (float(corner[0]), float(corner[1])),
                    "u_first": (float(strip.box.left), float(strip.box.top)),
                    "u_known": (0.0, 0.0, float(width - 1), float(height - 1)),
                    "u_side": 1 << (strip.band.level - level),
                }
            )
            self._boxes.draw_one(strip.box)

    def _cast(self, view: View, target: Target, window: Window) -> Box | None:
        """Cast the shadow on one receiver into a picture of the blur's plane."""
        assert window.canvas_from_target is not None
        cast = replace(view.job.cast, receivers=(view.receiver,))
        on_canvas = replace(window, canvas_from_target=view.canvas_from_blurred @ window.canvas_from_target)
        return self._caster.unite(cast, view.job.matte, target, on_canvas)

    def _cast_sheets(self, job: Job, chart: Chart, whole: Target, window: Window) -> None:
        """Cast the shadow on the ground and on each sheet of a chart, and add up what lies uppermost."""
        assert window.canvas_from_target is not None
        alone = self._alone_of(whole)
        laid = job.development.charts[chart.number]
        outlines = {number: _outline_on(job, number, window.canvas_from_target) for number in laid}
        parts = [(View.of_ground(job, window.box), Mask(None, _over(outlines, laid), ()))]
        for number in laid:
            over = job.development.covering(chart.number, number)
            mask = Mask(Group((outlines[number],), overlaps=False), _over(outlines, over), ())
            parts.append((View.of_sheet(job, number, window.box), mask))
        for view, mask in parts:
            box = self._cast(view, alone, window)
            if box is not None:
                self._adding.add(mask, alone, box, whole)
                alone.clear(box)

    def outlined(self, cast: ShadowCast, matte: PlacedMatte, canvas_from_plane: Matrix) -> Texels:
        """Return the whole shadow on its receiver in few texels, to see how long it is."""
        extent = extent_of(cast, matte, canvas_from_plane)
        if extent is None:
            return np.zeros((0, 0), np.float32)
        texel = max(extent.right - extent.left, extent.high - extent.low) / _OUTLINED_TEXELS
        box = Box(0, 0, *(ceil(side / texel) for side in (extent.right - extent.left, extent.high - extent.low)))
        shadow = self._whole_of(box.width, box.height)
        shadow.clear(box)
        plane_from_texel = np.array([[texel, 0.0, extent.left], [0.0, texel, extent.low], [0.0, 0.0, 1.0]])
        cells = _cells_at(max(ceil(log2(texel)), 0))
        self._caster.unite(
            cast, matte, shadow, Window(box, canvas_from_plane @ plane_from_texel, cells, is_shape_only=True)
        )
        return shadow.read_floats(box)

    def _alone_of(self, whole: Target) -> Target:
        """Return an empty target of the size of another one; whoever draws into it empties it again."""
        if self._alone is None or self._alone.box != whole.box:
            if self._alone is not None:
                self._alone.close()
            self._alone = Target(whole.box.width, whole.box.height, Format.ALPHA16)
            self._alone.clear()
        return self._alone

    def _whole_of(self, width: int, height: int) -> Target:
        """Return a target of at least a size for the shadow before it is blurred."""
        old = self._whole
        if old is None or old.box.width < width or old.box.height < height:
            if old is not None:
                width, height = max(width, old.box.width), max(height, old.box.height)
                old.close()
            self._whole = Target(width, height, Format.ALPHA16)
        assert self._whole is not None
        return self._whole


def _cells_at(level: int) -> int:
    """Return into how many cells a texel of a level may be split.

    Coarse texels, to be blurred anyway, are means of few cells; where squares of the matte's coarsest mipmap no longer
    fill a cell there have to be more of them again.
    """
    return CELLS[-1] if level < 2 else min(max(16, 1 << max(level - LAST_LEVEL + 3, 0)), CELLS[-1])


def _outline_on(job: Job, number: int, blurred_from_target: Matrix) -> Region:
    """Return where a sheet lies on a picture of the blur's plane."""
    flat_from_target = np.eye(3)
    flat_from_target[:2, :2] = job.ground_from_blurred
    target_from_flat = np.linalg.inv(flat_from_target @ blurred_from_target)
    return Region(lines_of(moved(target_from_flat, job.development.sheets[number].corners)))


def _over(outlines: Mapping[int, Region], numbers: Sequence[int]) -> tuple[Group, ...]:
    return (Group(tuple(outlines[number] for number in numbers), overlaps=False),) if numbers else ()
