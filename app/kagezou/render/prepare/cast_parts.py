"""How fine a job's shadow is cast, and where: fine near the contact line, where the blur is narrow, else coarser."""

from dataclasses import dataclass
from math import ceil, floor, log2

from kagezou.geometry.bands import Extent
from kagezou.render.prepare.band_atlas import Strip
from kagezou.render.prepare.filter_job import Chart, FilterJob
from kagezou.render.prepare.shadow_levels import ShadowLevels

_COARSEST_CAST = 1
"""Means of a finer cast cost less than one whose every texel is split into many cells."""

_LEAST_COARSEST = 4
"""At least down to this level a coarse cast is made coarser, so that a wider blur finds it there."""

_MOST_TEXELS = 4096
"""Along a side of the finest picture of a shadow, unless a strip of it has to be finer."""

_STEP_PX = 64.0


@dataclass(frozen=True, slots=True)
class CastPart:
    """One picture of the shadow, for the strips that are cast as fine.

    Parameters
    ----------
    finest, coarsest
        Its levels.
    least
        No level is cast finer: a shadow may be too long for that.
    low, high
        From which v to which it is needed, px of the blur.
    """

    finest: int
    coarsest: int
    least: int
    low: float
    high: float

    def is_for(self, strip: Strip) -> bool:
        """Whether a strip is made of it."""
        return _finest_for(strip.band.level, self.least) == self.finest

    def levels(self, chart: Chart) -> ShadowLevels:
        """Return the picture's levels for a chart."""
        whole = chart.extent
        low, high = max(whole.low, self.low), min(whole.high, self.high)
        return ShadowLevels.of(Extent(whole.left, low, whole.right, max(high, low + 1.0)), self.finest, self.coarsest)


def cast_parts(job: FilterJob) -> tuple[CastPart, ...]:
    """Return the pictures that a job's strips are made of, the finest first."""
    least = least_level(job)
    groups: dict[int, list[Strip]] = {}
    for strip in job.strips:
        groups.setdefault(_finest_for(strip.band.level, least), []).append(strip)
    parts: list[CastPart] = []
    for finest, strips in sorted(groups.items()):
        coarsest = max(strip.band.level for strip in strips)
        coarsest = max(coarsest, _LEAST_COARSEST) if finest >= _COARSEST_CAST else coarsest
        low, high = min(strip.band.needed.low for strip in strips), max(strip.band.needed.high for strip in strips)
        # In steps, so that it is the same for a little more of the filter.
        parts.append(
            CastPart(finest, coarsest, least, floor(low / _STEP_PX) * _STEP_PX, ceil(high / _STEP_PX) * _STEP_PX)
        )
    return tuple(parts)


def least_level(job: FilterJob) -> int:
    """Return the level below which the longest shadow of a job is not cast, but for strips that are finer."""
    longest = max(max(c.extent.right - c.extent.left, c.extent.high - c.extent.low) for c in job.charts)
    return max(ceil(log2(longest / _MOST_TEXELS)), 0)


def steps_to(strip: Strip, least: int) -> int:
    """Return how often a cast is halved for a strip."""
    return strip.band.level - _finest_for(strip.band.level, least)


def _finest_for(level: int, least: int) -> int:
    """Return how fine the shadow is cast for strips of a level: finer than they are, where that is not below a px."""
    return min(max(min(level - 1, _COARSEST_CAST), least, 0), level)
