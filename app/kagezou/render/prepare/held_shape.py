"""The shape that was found, in patches, and how far it is slid so that it begins at the feet."""

from collections.abc import Sequence
from typing import Final

import numpy as np

from kagezou.geometry.hold import Patches, slide_to_feet
from kagezou.geometry.vectors import Matrix
from kagezou.render.prepare.area_level import FINER, Counted, covered_areas, places_of
from kagezou.render.prepare.band_atlas import Strip
from kagezou.render.prepare.filter_job import FilterJob

_PLACE_PX: Final = 4.0
"""Shapes are told in places no wider, or a quarter of a texel: an outline of few texels is not straight within one."""


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
    told = [_told(strip, each, level) for strip, each in zip(strips, counted, strict=True)]
    sharp, shape, left = (Patches.of(each) for each in zip(*told, strict=True))
    return slide_to_feet(sharp, shape, left, simplify.hold)


def _told(strip: Strip, band: Counted, level: float) -> tuple[Patches, Patches, Patches]:
    """Return what a strip of the receiver alone holds: of the sharp shadow, of its shape, and of both."""
    texel = strip.band.texel_px
    finer = min(max(round(texel / _PLACE_PX), 1), FINER)
    middle_rows, middle_columns = (slice(band.margin, side - band.margin) for side in band.sharp.shape)
    texels = band.sharp[middle_rows, middle_columns] * (band.weights[:, np.newaxis] / finer**2)
    sharp = np.repeat(np.repeat(texels, finer, axis=0), finer, axis=1)
    shape = covered_areas(band, level, finer)
    corner = strip.plane_from_atlas @ np.array([strip.shown.left, strip.shown.top, 1.0])
    rows, columns = (places_of(side, band.margin, finer)[1:-1] + 0.5 for side in band.sharp.shape)
    away, along = corner[1] + texel * rows, corner[0] + texel * columns
    first, second, third = (_patches(along, away, areas) for areas in (sharp, shape, np.minimum(sharp, shape)))
    return first, second, third


def _patches(along: Matrix, away: Matrix, areas: Matrix) -> Patches:
    """Return the places (h, w) that hold anything."""
    row, column = np.nonzero(areas > 0)
    return Patches(along[column], away[row], areas[row, column])
