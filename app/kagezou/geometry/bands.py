"""Which part of a receiver is blurred how finely: bands along the contact line, each as coarse as its blur allows.

A Gaussian of some texels' width looks the same on coarse texels as on fine ones. The width grows with the distance from
the contact line, so the receiver is cut into bands along that line in which it doubles, and each has texels twice as
large as the one before. The work then hardly depends on the width at all.
"""

from dataclasses import dataclass
from math import ceil, floor, inf, log2

FINEST_SIGMA_PX = 1.25
"""The smallest blur, in texels of its band."""

LEVELS_A_BAND = 2
"""Where the width grows with the distance, a band holds blurs up to four times its smallest: fewer, wider bands."""

SHARP_SIGMA_PX = 0.7
"""Below this blur the shadow is left as it was cast; up to FINEST_SIGMA_PX it passes over into the blurred one."""

REACH_SIGMAS = 3.2
"""How many standard deviations of a Gaussian are summed up, and how far a shape may grow."""

MOST_TEXELS = 2048
"""A shadow that is longer than this many texels, under a low light, is blurred on coarser ones."""

BICUBIC_TEXELS = 2
"""How far a cubic spline reaches."""


@dataclass(frozen=True, slots=True)
class Blur:
    """The width of the blur over the distance from the contact line: s·min(|v|/d, 1)."""

    amount_px: float
    distance_px: float

    def sigma_at(self, distance_px: float) -> float:
        """Return the standard deviation, px."""
        if self.distance_px <= 0:
            return self.amount_px
        return self.amount_px * min(abs(distance_px) / self.distance_px, 1.0)

    def distance_of(self, sigma_px: float) -> float:
        """Return the distance from which on the blur is at least this wide; inf if it never is."""
        if sigma_px > self.amount_px:
            return inf
        return sigma_px / self.amount_px * self.distance_px

    @property
    def last_level(self) -> int:
        """The level of the widest blur; -1 where there is nothing to blur."""
        if self.amount_px <= SHARP_SIGMA_PX:
            return -1
        level = max(floor(log2(self.amount_px / FINEST_SIGMA_PX)), 0)
        return level if self.distance_px <= 0 else level - level % LEVELS_A_BAND


@dataclass(frozen=True, slots=True)
class Extent:
    """A rectangle of the receiver, px: u along the contact line, v away from it."""

    left: float
    low: float
    right: float
    high: float


@dataclass(frozen=True, slots=True)
class Band:
    """A strip of the receiver at one level of fineness.

    Parameters
    ----------
    level
        Its texels are 2^level px wide.
    core
        The part that is shown from this band.
    shown
        ``core`` with what a spline needs around it: where the blur has to be known.
    needed
        ``shown`` with all that is blurred into it: where the shadow has to be known.
    """

    level: int
    core: Extent
    shown: Extent
    needed: Extent

    @property
    def texel_px(self) -> float:
        """The width of a texel, px of the receiver."""
        return float(1 << self.level)


def bands_of(blur: Blur, shadow: Extent) -> tuple[Band, ...]:
    """Return the bands that a blurred shadow may touch, from the contact line outward, on both its sides."""
    if blur.distance_px <= 0:
        return (_whole(blur, shadow),) if blur.last_level >= 0 else ()
    bands = (
        _band(blur, shadow, level, side) for level in range(0, blur.last_level + 1, LEVELS_A_BAND) for side in (-1, 1)
    )
    return tuple(band for band in bands if band is not None)


def _whole(blur: Blur, shadow: Extent) -> Band:
    reach = REACH_SIGMAS * blur.amount_px
    return _surrounded(blur.last_level, reach, shadow, shadow.low - reach, shadow.high + reach)


def _band(blur: Blur, shadow: Extent, level: int, side: int) -> Band | None:
    first = blur.distance_of(SHARP_SIGMA_PX if level == 0 else FINEST_SIGMA_PX * 2**level)
    last = inf if level == blur.last_level else blur.distance_of(FINEST_SIGMA_PX * 2 ** (level + LEVELS_A_BAND))
    widest = min(FINEST_SIGMA_PX * 2 ** (level + LEVELS_A_BAND), blur.amount_px)
    reach = REACH_SIGMAS * widest
    inner, outer = (shadow.low, shadow.high) if side > 0 else (-shadow.high, -shadow.low)
    low, high = max(first, inner - reach), min(last, outer + reach)
    # Across the contact line a shadow is at least as many standard deviations away as d/s.
    unreached = outer <= first and blur.distance_px >= REACH_SIGMAS * blur.amount_px
    if low >= high or unreached:
        return None
    return _surrounded(level, reach, shadow, *((low, high) if side > 0 else (-high, -low)))


def _surrounded(level: int, reach: float, shadow: Extent, low: float, high: float) -> Band:
    longest = max(shadow.right - shadow.left, shadow.high - shadow.low, 1.0)
    level = max(level, ceil(log2(longest / MOST_TEXELS)))
    margin = (BICUBIC_TEXELS + 1) * 2.0**level
    core = Extent(shadow.left - reach, low, shadow.right + reach, high)
    shown = Extent(core.left - margin, low - margin, core.right + margin, high + margin)
    needed = Extent(shown.left, shown.low - reach - margin, shown.right, shown.high + reach + margin)
    return Band(level, core, shown, needed)
