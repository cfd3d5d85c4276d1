"""The shape that was found, in patches, and how far it is slid so that it begins at the feet."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from kagezou.geometry.hold import Patches, slide_to_feet
from kagezou.geometry.vectors import Matrix
from kagezou.render.prepare.area_level import FINER, Counted, covered_areas, places_of
from kagezou.render.prepare.band_atlas import Strip
from kagezou.render.prepare.filter_job import FilterJob

_COARSE_TEXEL_PX: Final = 4.0
"""Larger texels are told finer: the outline of a shape of few texels is not straight within one."""


@dataclass(frozen=True, slots=True, eq=False)
class _Told:
    """A strip of the receiver alone, what was counted of it, and the level of the shape."""

    strip: Strip
    counted: Counted
    level: float

    @property
    def sharp_areas(self) -> Matrix:
        """How much shadow each texel (h, w) had, px²."""
        band = self.counted
        rows, columns = (slice(band.margin, side - band.margin) for side in band.sharp.shape)
        return np.asarray(band.sharp[rows, columns] * band.weights[:, np.newaxis], np.float64)

    def spread(self, areas: Matrix) -> Matrix:
        """Return what texels (h, w) hold, evenly over the finer places within them."""
        return np.repeat(np.repeat(areas / FINER**2, FINER, axis=0), FINER, axis=1)

    def patches(self, finer: int, areas: Matrix) -> Patches:
        """Return the places (h, w), ``finer``² in each texel, that hold anything."""
        corner = self.strip.plane_from_atlas @ np.array([self.strip.shown.left, self.strip.shown.top, 1.0])
        texel, sides = self.strip.band.texel_px, self.counted.sharp.shape
        rows, columns = (places_of(side, self.counted.margin, finer)[1:-1] + 0.5 for side in sides)
        away, along = np.meshgrid(corner[1] + texel * rows, corner[0] + texel * columns, indexing="ij")
        held = areas > 0
        return Patches(along[held], away[held], areas[held])


def slide_of(job: FilterJob, strips: Sequence[Strip], counted: Sequence[Counted], level: float) -> tuple[float, float]:
    """Return how far away, in u and v of the blur, the shape on the receiver is to be read, px.

    Parameters
    ----------
    strips, counted
        Those of the receiver alone, as for its level.
    level
        Over which the blurred shadow is the shape.
    """
    simplify = job.cast.simplify
    if simplify is None or simplify.hold <= 0 or not strips:
        return (0.0, 0.0)
    told = [_Told(strip, each, level) for strip, each in zip(strips, counted, strict=True)]
    sharp, shape, left = (Patches.of([ask(each) for each in told]) for ask in (_sharp, _shape, _left))
    return slide_to_feet(sharp, shape, left, simplify.hold)


def _sharp(told: _Told) -> Patches:
    return told.patches(FINER, told.spread(told.sharp_areas))


def _shape(told: _Told) -> Patches:
    finer = FINER if told.strip.band.texel_px > _COARSE_TEXEL_PX else 1
    return told.patches(finer, covered_areas(told.counted, told.level, finer))


def _left(told: _Told) -> Patches:
    return told.patches(
        FINER, np.minimum(told.spread(told.sharp_areas), covered_areas(told.counted, told.level, FINER))
    )
