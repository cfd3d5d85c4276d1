"""The united shadow on its receiver, cast once: for the strips it is blurred in, and for its own moments."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import ceil, log2
from typing import TYPE_CHECKING

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.vectors import Matrix
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.mattes import PlacedMatte
from kagezou.render.gpu.program import Variants
from kagezou.render.gpu.scratches import GrowingTarget
from kagezou.render.gpu.targets import Format, Target
from kagezou.render.passes.cast import CastPass, Window
from kagezou.render.passes.halving import HalvingPass
from kagezou.render.prepare.area_level import Floats as Texels
from kagezou.render.prepare.band_atlas import Strip
from kagezou.render.prepare.cast_parts import cast_parts
from kagezou.render.prepare.filter_job import GROUND_CHART, BlurView, Chart, FilterJob, extent_of
from kagezou.render.prepare.shadow_levels import ShadowLevels
from kagezou.render.prepare.shadow_tiles import CELLS
from kagezou.render.prepare.strip_uniforms import STRIPS, box_array, crop_uniforms, numbered
from kagezou.render.prepare.uniforms import LAST_LEVEL, Uniform
from kagezou.scene.scene import ShadowCast

if TYPE_CHECKING:  # what casts on the sheets of sets is loaded with the first one
    from kagezou.render.passes.sheets import SheetsPass

_OUTLINED_TEXELS = 64

_FOR_OUTLINES = -1
"""In the place of a level: the target in which the length of a shadow is seen."""


@dataclass(frozen=True, slots=True, eq=False)
class _Kept:
    """What was cast on the ground last; while only the filter changes it need not be cast again.

    Parameters
    ----------
    filled, held
        The coarsest level that is there, and where it may hold anything.
    """

    cast: ShadowCast
    matte: PlacedMatte
    ground_from_blurred: Matrix
    levels: ShadowLevels
    filled: int
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
        self._wholes: dict[tuple[int, bool], GrowingTarget] = {}
        self._kept: dict[int, _Kept] = {}
        self._made_sheets: SheetsPass | None = None

    @property
    def _sheets(self) -> "SheetsPass":
        if self._made_sheets is None:
            from kagezou.render.passes.sheets import SheetsPass

            self._made_sheets = SheetsPass(self._boxes, self._caster, self._crop)
        return self._made_sheets

    def close(self) -> None:
        """Give the memory back."""
        self._halving.close()
        self._crop.close()
        if self._made_sheets is not None:
            self._made_sheets.close()
        for growing in self._wholes.values():
            growing.close()

    def fill(self, job: FilterJob, matte: PlacedMatte, chart: Chart, shadow: Target) -> None:
        """Cast the shadow, at least as fine as any strip wants it, and fill a chart's strips with it."""
        of_ground = chart.number == GROUND_CHART
        for part in cast_parts(chart):
            levels = part.levels(chart)
            whole = self._whole_of(part.finest, levels.box, of_ground=of_ground)
            # A failure half-way leaves no one knows what.
            kept = self._kept.pop(part.finest, None) if of_ground else None
            if kept is None or not kept.holds(job, matte, levels):
                held = self._cast(job, matte, chart, (whole, levels))
                kept = _Kept(_unfiltered(job.cast), matte, job.ground_from_blurred, levels, part.finest, held)
            coarsest = max(part.served)
            if kept.filled < coarsest:
                held = self._halving.fill(whole, levels, (kept.filled, coarsest), kept.held)
                kept = replace(kept, filled=coarsest, held=held)
            if of_ground:
                self._kept[part.finest] = kept
            self._fill_strips([strip for strip in chart.strips if part.is_for(strip)], levels, whole, shadow)

    def _cast(self, job: FilterJob, matte: PlacedMatte, chart: Chart, goal: tuple[Target, ShadowLevels]) -> Box | None:
        """Cast the shadow of a chart as fine as it is to be; return the box that may hold it."""
        whole, levels = goal
        whole.clear(levels.box)
        box = levels.box_of(levels.finest)
        # The shape alone is filtered; its strength under a low light is applied where it is shown.
        window = Window(box, levels.plane_from_target, _cells_at(levels.finest), is_shape_only=True)
        view = BlurView.of_ground(job, box)
        held = self._caster.unite(view.cast, matte, whole, window.seen_through(view.canvas_from_blurred))
        if chart.number != GROUND_CHART:
            held = self._sheets.lay((job, matte, chart), (whole, held), window)
        return held

    def _fill_strips(self, strips: Sequence[Strip], levels: ShadowLevels, whole: Target, shadow: Target) -> None:
        """Fill strips from the pictures of the shadow that are as fine."""
        shadow.bind()
        whole.texture.bind(0)
        uniforms: dict[str, Uniform] = {"u_target_size_px": shadow.size_px, "u_source": 0}
        self._crop[STRIPS].use(uniforms | crop_uniforms(levels, strips))
        self._boxes.load_numbered(*numbered([box_array(strip.box) for strip in strips]))
        self._boxes.draw_loaded(0, len(strips))

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
        growing = self._wholes.setdefault((finest, of_ground), GrowingTarget(Format.ALPHA16))
        if of_ground and not growing.holds(box.width, box.height):
            self._kept.pop(finest, None)
        return growing.at_least(box.width, box.height)


def _cells_at(level: int) -> int:
    """Return into how many cells a texel of a level may be split.

    Coarse texels, to be blurred anyway, are means of few cells; where squares of the matte's coarsest mipmap no longer
    fill a cell there have to be more of them again.
    """
    return CELLS[-1] if level < 2 else min(max(16, 1 << max(level - LAST_LEVEL + 3, 0)), CELLS[-1])
