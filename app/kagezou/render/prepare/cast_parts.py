"""How fine a chart's shadow is cast, and where: fine near the contact line, where the blur is narrow, else coarser."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil, floor, log2

from kagezou.geometry.bands import Extent
from kagezou.render.prepare.band_atlas import Strip
from kagezou.render.prepare.filter_job import GROUND_CHART, Chart
from kagezou.render.prepare.shadow_levels import ShadowLevels

_COARSEST_CAST = 1
"""Means of a finer cast cost less than one whose every texel is split into many cells."""

_LEAST_COARSEST = 4
"""Down to this level there is room at least for what a coarse cast is halved to: a wider blur wants no new one."""

_MOST_TEXELS = 4096
"""Along a side of the finest picture of a shadow, unless a strip of it has to be finer."""

_SMALL_TEXELS = 400_000
"""A chart with sheets that is no larger is cast once, as fine as any of its strips wants it: casting costs more."""

_STEP_PX = 64.0


@dataclass(frozen=True, slots=True)
class CastPart:
    """One picture of the shadow, for the strips that are cast as fine.

    Parameters
    ----------
    finest, coarsest
        Its levels.
    served
        The levels of its strips.
    low, high
        From which v to which it is needed, px of the blur.
    """

    finest: int
    coarsest: int
    served: tuple[int, ...]
    low: float
    high: float

    def is_for(self, strip: Strip) -> bool:
        """Whether a strip is made of it."""
        return strip.band.level in self.served

    def levels(self, chart: Chart) -> ShadowLevels:
        """Return the picture's levels for its chart."""
        whole = chart.extent
        low, high = max(whole.low, self.low), min(whole.high, self.high)
        return ShadowLevels.of(Extent(whole.left, low, whole.right, max(high, low + 1.0)), self.finest, self.coarsest)


def cast_parts(chart: Chart) -> tuple[CastPart, ...]:
    """Return the pictures that a chart's strips are made of, the finest first."""
    least = _least_level(chart.extent)
    wanted = {strip: _finest_for(strip.band.level, least) for strip in chart.strips}
    if chart.number != GROUND_CHART and wanted:
        # To cast on sheets costs more than what it saves to have some strips made of a finer cast.
        if min(strip.band.level for strip in wanted) >= _COARSEST_CAST:
            wanted = {strip: max(own, _COARSEST_CAST) for strip, own in wanted.items()}
        finest = min(wanted.values())
        if _texels(chart.extent, finest) <= _SMALL_TEXELS:
            wanted = dict.fromkeys(wanted, finest)
    return tuple(
        _part(each, [strip for strip, own in wanted.items() if own == each]) for each in sorted(set(wanted.values()))
    )


def steps_to(chart: Chart) -> dict[Strip, int]:
    """Return how often a cast is halved for each strip of a chart."""
    parts = cast_parts(chart)
    return {strip: strip.band.level - part.finest for strip in chart.strips for part in parts if part.is_for(strip)}


def _part(finest: int, strips: Sequence[Strip]) -> CastPart:
    served = sorted({strip.band.level for strip in strips})
    coarsest = max(served[-1], _LEAST_COARSEST) if finest >= _COARSEST_CAST else served[-1]
    low, high = min(strip.band.needed.low for strip in strips), max(strip.band.needed.high for strip in strips)
    # In steps, so that it is the same for a little more of the filter.
    return CastPart(finest, coarsest, tuple(served), floor(low / _STEP_PX) * _STEP_PX, ceil(high / _STEP_PX) * _STEP_PX)


def _texels(extent: Extent, level: int) -> float:
    return (extent.right - extent.left) * (extent.high - extent.low) / 4.0**level


def _least_level(extent: Extent) -> int:
    """Return the level below which a shadow is not cast, but for strips that are finer."""
    longest = max(extent.right - extent.left, extent.high - extent.low)
    return max(ceil(log2(longest / _MOST_TEXELS)), 0)


def _finest_for(level: int, least: int) -> int:
    """Return how fine the shadow is cast for strips of a level: finer than they are, where that is not below a px."""
    return min(max(min(level - 1, _COARSEST_CAST), least, 0), level)
