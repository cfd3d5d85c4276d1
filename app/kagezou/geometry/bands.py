"""Which part of a receiver is blurred how finely: bands along the contact line, each as coarse as its blur allows.

A Gaussian of some texels' width looks the same on coarse texels as on fine ones. Where the width grows with the
distance from the contact line, the receiver is cut into bands along that line, each twice as far away as the one before
and with texels as large as its narrowest blur allows. The work then hardly depends on the width at all.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from math import ceil, floor, hypot, inf, log2, pi, sqrt

FINEST_SIGMA_PX = 1.25
"""The smallest blur, in px of the receiver."""

TEXELS_A_SIGMA = 1.25
"""The narrowest blur of a band, in its texels."""

TEXELS_A_DISTANCE = 16.0
"""How many texels a band is away from the contact line, as a width that grows fast bends the blur over as little."""

TEXELS_A_GROWTH = 64.0
"""How many texels that is for each px by which the width grows with a px of distance."""

LARGEST_TEXEL_PX = 8.0
"""No coarser, so that the tiles in which an outline may lie stay few, unless the blur is as wide as ..."""

MOST_TEXELS_A_SIGMA = 25.0
"""... this many of them; twice as large where the blur is the same everywhere."""

TEXELS_A_SHAPE = 24.0
"""How many texels the radius of a shape has at least."""

FIRST_PX = 16.0
"""The first band ends here, every other one at twice the distance of the one before."""

SHARP_SIGMA_PX = 0.7
"""Below this blur the shadow is left as it was cast; up to FINEST_SIGMA_PX it passes over into the blurred one."""

REACH_SIGMAS = 3.2
"""How many standard deviations of a Gaussian are summed up."""

MOST_TEXELS = 2048
"""A shadow that is longer than this many texels, under a low light, is blurred on coarser ones."""

_TRIES = 12
"""How often a bound is made narrower by what follows from it."""

BICUBIC_TEXELS = 2
"""How far a cubic spline reaches."""


@dataclass(frozen=True, slots=True)
class Blur:
    """The width of the blur over the distance |v| from the contact line: √((s·min(|v|/d, 1))² + (base + slope·|v|)²).

    Parameters
    ----------
    amount_px, distance_px
        s and d of the simplification; d = 0 for s everywhere.
    base_px, slope
        What the edge needs besides: as wide at the contact line, and so much wider with each px away from it.
    """

    amount_px: float
    distance_px: float
    base_px: float = 0.0
    slope: float = 0.0

    @property
    def is_even(self) -> bool:
        """Whether the width is the same everywhere."""
        return self.slope <= 0 and (self.distance_px <= 0 or self.amount_px <= 0)

    def sigma_at(self, distance_px: float) -> float:
        """Return the standard deviation, px."""
        away = abs(distance_px)
        part = 1.0 if self.distance_px <= 0 else min(away / self.distance_px, 1.0)
        return hypot(self.amount_px * part, self.edge_at(away))

    def texels_a_distance(self, distance_px: float) -> float:
        """Return how many texels a place is at least away from the contact line: the more, the faster the blur grows.

        For a while beyond where it stops growing, too: there it is read across that kink.
        """
        is_growing = distance_px < 2 * self.distance_px
        growth = self.slope + (self.amount_px / self.distance_px if is_growing else 0.0)
        return max(TEXELS_A_DISTANCE, TEXELS_A_GROWTH * growth)

    def edge_at(self, distance_px: float) -> float:
        """Return what the edge alone needs, px."""
        return self.base_px + self.slope * abs(distance_px)

    def distance_of(self, sigma_px: float) -> float:
        """Return the distance from which on the blur is at least this wide; inf if it never is."""
        if sigma_px <= self.sigma_at(0.0):
            return 0.0
        if self.distance_px > 0 and sigma_px <= self.sigma_at(self.distance_px):
            return self._distance_within(sigma_px)
        if self.slope <= 0:
            return inf
        return (sqrt(sigma_px**2 - self.amount_px**2) - self.base_px) / self.slope

    def _distance_within(self, sigma_px: float) -> float:
        """Solve for the distance where the width still grows by the amount, as a part of that distance."""
        widening = self.slope * self.distance_px
        steep, half = hypot(self.amount_px, widening), self.base_px * widening
        part = (sqrt(half**2 + steep**2 * (sigma_px**2 - self.base_px**2)) - half) / steep**2
        return part * self.distance_px


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
    reach_texels
        How far its widest blur reaches.
    core
        The part that is shown from this band.
    shown
        ``core`` with what a spline needs around it: where the blur has to be known.
    needed
        ``shown`` with all that is blurred into it: where the shadow has to be known.
    """

    level: int
    reach_texels: float
    core: Extent
    shown: Extent
    needed: Extent

    @property
    def texel_px(self) -> float:
        """The width of a texel, px of the receiver."""
        return float(1 << self.level)


def bands_of(blur: Blur, shadow: Extent, seen: tuple[float, float] | None = None) -> tuple[Band, ...]:
    """Return the bands that a blurred shadow may touch, from the contact line outward, on both its sides.

    With ``seen``, from which v to which it is looked at, the shadow is a part of a picture, which the shape does not
    grow beyond.
    """
    if not blur.is_even:
        return tuple(band for side in (-1, 1) for band in _side(blur, shadow, side, seen))
    sigma = blur.sigma_at(0.0)
    if sigma <= SHARP_SIGMA_PX:
        return ()
    grown = 0.0 if seen else _growth(blur, shadow, sigma)
    # Nothing bends an even blur over: where it is wide, still larger texels will do.
    largest = min(max(LARGEST_TEXEL_PX, sigma / 4), 2 * LARGEST_TEXEL_PX)
    core = seen or (shadow.low - grown, shadow.high + grown)
    return (_band(shadow, core, sigma, grown, _level(shadow, _texel(shadow, sigma, largest))),)


def felt_by(blur: Blur, shown: Extent) -> Extent:
    """Return the part of a receiver that is blurred into a shown one: far where the blur is wide, near where it is not.

    The width is convex in the distance between the places named here, so what reaches farthest is at one of them.
    """
    bends = (0.0, blur.distance_px, -blur.distance_px)
    places = [shown.low, shown.high, *(v for v in bends if shown.low < v < shown.high)]
    reaches = {v: REACH_SIGMAS * blur.sigma_at(v) for v in places}
    along = max(reaches.values())
    low, high = min(v - reach for v, reach in reaches.items()), max(v + reach for v, reach in reaches.items())
    return Extent(shown.left - along, low, shown.right + along, high)


def _texel(shadow: Extent, sigma_px: float, largest_px: float = LARGEST_TEXEL_PX) -> float:
    """Return how large texels may be for a blur and all wider ones."""
    largest = max(largest_px, sigma_px / MOST_TEXELS_A_SIGMA)
    return min(sigma_px / TEXELS_A_SIGMA, largest, _disc(shadow) / TEXELS_A_SHAPE)


def _growth(blur: Blur, shadow: Extent, sigma_px: float) -> float:
    """Return how far a shape may grow beyond its rectangle.

    No further than its blur, nor than a disc of its area and what its edge takes up besides.
    """
    disc = _disc(shadow)
    farthest = max(abs(shadow.low), abs(shadow.high)) + disc
    return min(REACH_SIGMAS * sigma_px, disc + REACH_SIGMAS * blur.edge_at(farthest))


def _disc(shadow: Extent) -> float:
    return 1.1 * sqrt((shadow.right - shadow.left) * (shadow.high - shadow.low) / pi) + 2.0


def _side(blur: Blur, shadow: Extent, side: int, seen: tuple[float, float] | None) -> Iterator[Band]:
    """Yield the bands on one side of the contact line, the distance doubling in each."""
    low_v, high_v = seen or (shadow.low, shadow.high)
    inner, outer = (low_v, high_v) if side > 0 else (-high_v, -low_v)
    grown = 0.0 if seen else _growth(blur, shadow, blur.sigma_at(max(outer, 0.0) + _disc(shadow)))
    farthest = _farthest(blur, outer, grown)
    if farthest <= 0 or blur.sigma_at(farthest) <= SHARP_SIGMA_PX:
        return
    first = max(blur.distance_of(SHARP_SIGMA_PX), inner - grown)
    for low, high, level in _cores(blur, shadow, first, farthest):
        core = (low, high) if side > 0 else (-high, -low)
        widest = blur.sigma_at(high)
        yield _band(shadow, core, widest, 0.0 if seen else _growth(blur, shadow, widest), level)


def _cores(blur: Blur, shadow: Extent, first: float, farthest: float) -> Iterator[tuple[float, float, int]]:
    """Yield from which distance to which, and the level there; one after the other of the same level are one.

    ``first`` is nearer than ``farthest``.
    """
    low, start, level = first, first, -1
    while low < farthest:
        high = min(max(2 * low, FIRST_PX), farthest)
        # The width stops growing all at once.
        high = blur.distance_px if low < blur.distance_px < high else high
        own = _level(shadow, min(_texel(shadow, blur.sigma_at(low)), low / blur.texels_a_distance(low)))
        if level >= 0 and (level != own or low == blur.distance_px):
            yield start, low, level
            start = low
        low, level = high, own
    yield start, low, level


def _farthest(blur: Blur, outer: float, grown: float) -> float:
    """Return the distance beyond which no blur reaches a shadow that ends at ``outer``."""
    farthest = outer + grown
    for _ in range(_TRIES):
        farthest = min(farthest, outer + REACH_SIGMAS * blur.sigma_at(max(farthest, 0.0)))
    return farthest


def _level(shadow: Extent, largest_texel_px: float) -> int:
    """Return the level of the largest texels up to a size, px.

    A shadow that runs very far, under a low light, is blurred on coarser texels all the same.
    """
    size = max(shadow.right - shadow.left, shadow.high - shadow.low, 1.0)
    return max(floor(log2(max(largest_texel_px, 1.0))), ceil(log2(size / MOST_TEXELS)))


def _band(shadow: Extent, core: tuple[float, float], widest: float, grown: float, level: int) -> Band:
    low, high = core
    # Nothing is summed up from beyond the shadow, however wide the blur.
    across, along = shadow.high - shadow.low, shadow.right - shadow.left
    reach = min(REACH_SIGMAS * widest, max(across, along) + grown)
    texel = 2.0**level
    margin = (BICUBIC_TEXELS + 1) * texel
    seen = Extent(shadow.left - grown, low, shadow.right + grown, high)
    shown = Extent(seen.left - margin, low - margin, seen.right + margin, high + margin)
    needed = Extent(
        # On whole texels, so that those of a coarse band are made of whole ones of a finer.
        floor(shown.left / texel) * texel,
        floor(max(shown.low - reach - margin, min(shown.low, shadow.low - margin)) / texel) * texel,
        shown.right,
        min(shown.high + reach + margin, max(shown.high, shadow.high + margin)),
    )
    return Band(level, reach / texel, seen, shown, needed)
