"""The united shadow on its receiver, cast once: for the strips it is blurred in, and for its own moments."""

from math import ceil, floor, log2

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.vectors import Matrix
from kagezou.render.boxes import Boxes
from kagezou.render.cast_pass import CastPass, Window
from kagezou.render.level import Floats as Texels
from kagezou.render.mattes import PlacedMatte
from kagezou.render.program import Program
from kagezou.render.shape_job import Job, extent_of
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
        self._whole: Target | None = None

    def close(self) -> None:
        """Give the memory back."""
        self._reduce.close()
        if self._whole is not None:
            self._whole.close()

    def fill(self, job: Job, shadow: Target) -> None:
        """Cast the shadow once, at least as fine as any strip wants it, and fill the strips with means of it."""
        level = min((_COARSEST_CAST, *(strip.band.level for strip in job.strips)))
        texel = 2.0**level
        low, high = (job.extent.left, job.extent.low), (job.extent.right, job.extent.high)
        first = tuple(floor(each / texel) - 1 for each in low)
        width, height = (ceil(end / texel) + 1 - start for end, start in zip(high, first, strict=True))
        box = Box(0, 0, width, height)
        whole = self._whole_of(width, height)
        whole.clear(box)
        plane_from_whole = np.array([[texel, 0.0, first[0] * texel], [0.0, texel, first[1] * texel], [0.0, 0.0, 1.0]])
        # The shape alone is filtered; how strong it is under a low light is told where it is shown.
        window = Window(box, job.canvas_from_plane @ plane_from_whole, _cells_at(level), is_shape_only=True)
        self._caster.unite(job.cast, job.matte, whole, window)
        for strip in job.strips:
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
