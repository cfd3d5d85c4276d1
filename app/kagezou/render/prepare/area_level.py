"""The level at which a blurred shadow has the area it had before (spec 3)."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kagezou.render.prepare.shadow_tiles import TILE_PX

SMALL_TEXELS = 6000
"""A blur of fewer texels than this is counted on a finer grid."""

FINER = 4

_HALVINGS = 20
"""Enough to find a level to a small part of the highest value."""

Floats = NDArray[np.float32]


@dataclass(frozen=True, slots=True, eq=False)
class Counted:
    """The shown part of one band.

    Parameters
    ----------
    sharp, blurred
        (h, w), 0 to 1, before and after the blur, with ``margin`` texels (2 at least) around the part that counts.
    weights
        (h - 2·margin,): the area of a texel of each row that counts, px².
    margin
        Texels.
    counts
        (h - 2·margin, w - 2·margin): which of the texels count; None for all.
    corners
        (N, 2): x and y of the first texels of those tiles in which the blur is neither nothing nor all; what is beside
        them has the same area before and after. None where that is not known.
    """

    sharp: Floats
    blurred: Floats
    weights: NDArray[np.float64]
    margin: int
    counts: NDArray[np.bool_] | None = None
    corners: NDArray[np.intp] | None = None

    @property
    def area(self) -> float:
        """The area of the shadow before, px²; where tiles are known, within them."""
        m = self.margin
        if self.corners is not None:
            return float((_in_tiles(self, self.sharp, self.corners, 0) * _areas_in_tiles(self, self.corners)).sum())
        inner = self.sharp[m : self.sharp.shape[0] - m, m : self.sharp.shape[1] - m]
        if self.counts is not None:
            inner = inner * self.counts
        return float(inner.sum(axis=1, dtype=np.float64) @ self.weights)


@dataclass(frozen=True, slots=True, eq=False)
class _Slopes:
    """Texels in order: what the drawn spline has in the middle, how steep it is, and what area they stand for."""

    values: Floats
    reach: Floats
    areas: Floats

    def area_over(self, level: float) -> float:
        """Return the area over a level; a texel that the outline crosses counts in part."""
        parts = np.clip((self.values - np.float32(level)) / self.reach + np.float32(0.5), 0, 1)
        return float((parts * self.areas).sum(dtype=np.float64))

    def between(self, low: float, high: float) -> "tuple[float, _Slopes]":
        """Return the area that is over every level from ``low`` to ``high``, and the texels that may be crossed."""
        half = self.reach / 2
        is_over = self.values - half >= high
        is_crossed = ~is_over & (self.values + half > low)
        rest = _Slopes(self.values[is_crossed], self.reach[is_crossed], self.areas[is_crossed])
        return float(self.areas[is_over].sum(dtype=np.float64)), rest


def area_preserving_level(bands: Sequence[Counted]) -> float:
    """Return the level, 0 to 1, over which the blurred shadow has the area of the sharp one.

    A half where there is no shadow at all.
    """
    area = sum(band.area for band in bands)
    if area <= 0:
        return 0.5
    # An outline of a few texels is not straight within one.
    finer = FINER if sum(band.blurred.size for band in bands) < SMALL_TEXELS else 1
    slopes = [_slopes(band, finer) for band in bands]
    joined = _Slopes(*(np.concatenate([getattr(each, name) for each in slopes]) for name in _Slopes.__slots__))
    low, high = 0.0, float(joined.values.max(initial=0.0))
    for number in range(_HALVINGS):
        middle = (low + high) / 2
        if joined.area_over(middle) > area:
            low = middle
        else:
            high = middle
        if number % 4 == 3:
            # What lies on one side of both bounds need not be asked about again.
            whole, joined = joined.between(low, high)
            area -= whole
    return (low + high) / 2


def covered_areas(band: Counted, level: float, finer: int) -> NDArray[np.float64]:
    """Return how much of each place of a band is over a level, px²: texels, or ``finer``² places in each of them."""
    middle, reach, areas = _told(band, finer)
    parts = np.clip((middle - np.float32(level)) / reach + np.float32(0.5), 0, 1)
    return np.asarray(parts * areas, np.float64)


def _slopes(band: Counted, finer: int) -> _Slopes:
    """Return the places of a band that hold anything: texels, of a small band finer ones."""
    if finer == 1 and band.corners is not None:
        return _slopes_in_tiles(band, band.corners)
    middle, reach, areas = _told(band, finer)
    held = middle > 0
    if band.counts is not None:
        held &= np.repeat(np.repeat(band.counts, finer, axis=0), finer, axis=1)
    return _Slopes(middle[held], reach[held], areas[held])


def _slopes_in_tiles(band: Counted, corners: NDArray[np.intp]) -> _Slopes:
    texels = _in_tiles(band, band.blurred, corners, 2)
    rows = (texels[:, :-2] + 4 * texels[:, 1:-1] + texels[:, 2:]) / np.float32(6)
    values = (rows[:, :, :-2] + 4 * rows[:, :, 1:-1] + rows[:, :, 2:]) / np.float32(6)
    areas = _areas_in_tiles(band, corners)
    middle, reach = _middle_and_reach(values)
    held = (middle > 0) & (areas > 0)
    return _Slopes(middle[held], reach[held], areas[held])


def _in_tiles(band: Counted, texels: Floats, corners: NDArray[np.intp], around: int) -> Floats:
    """Return the texels of tiles (N, h, w), with so many around them; beyond the band, those at its rim."""
    steps = np.arange(-around, TILE_PX + around)
    columns, rows = (
        np.clip(corners[:, axis, np.newaxis] + steps, 0, band.sharp.shape[1 - axis] - 1) for axis in range(2)
    )
    return np.asarray(texels[rows[:, :, np.newaxis], columns[:, np.newaxis, :]])


def _areas_in_tiles(band: Counted, corners: NDArray[np.intp]) -> Floats:
    """Return what area each texel of tiles stands for, (N, h, w)."""
    m, (height, width) = band.margin, band.sharp.shape
    areas = np.zeros((height, width), np.float32)
    areas[m : height - m, m : width - m] = band.weights[:, np.newaxis]
    if band.counts is not None:
        areas[m : height - m, m : width - m] *= band.counts
    columns, rows = (corners[:, axis, np.newaxis] + np.arange(TILE_PX) for axis in range(2))
    is_within = ((rows >= 0) & (rows < height))[:, :, np.newaxis] & ((columns >= 0) & (columns < width))[:, np.newaxis]
    return np.asarray(_in_tiles(band, areas, corners, 0) * is_within)


def _middle_and_reach(values: Floats) -> tuple[Floats, Floats]:
    """Return values (..., h, w) without those around them, and half of what they change by each way."""
    middle = values[..., 1:-1, 1:-1]
    across = np.abs(values[..., 1:-1, 2:] - values[..., 1:-1, :-2])
    reach = (across + np.abs(values[..., 2:, 1:-1] - values[..., :-2, 1:-1])) / 4
    return middle, np.maximum(reach, np.float32(1e-12))


def _told(band: Counted, finer: int) -> tuple[Floats, Floats, Floats]:
    """Return what the drawn spline has in the middle of each place, how steep it is, and what area that stands for."""
    if finer == 1:
        values = _at_texels(band.blurred, band.margin)
    else:
        rows, columns = (places_of(side, band.margin, finer) for side in band.blurred.shape)
        values = _spline(_spline(band.blurred, rows, 0), columns, 1)
    # One place more on each side, for the slopes; the outline crosses a place half a step either way.
    middle, reach = _middle_and_reach(values)
    areas = np.repeat(band.weights / finer**2, finer).astype(np.float32)
    return middle, reach, np.broadcast_to(areas[:, np.newaxis], middle.shape)


def _at_texels(texels: Floats, margin: int) -> Floats:
    """Return the spline in the middle of each texel that counts, and of one more on every side."""
    cut = margin - 2
    inner = texels[cut : texels.shape[0] - cut, cut : texels.shape[1] - cut]
    rows = (inner[:-2] + 4 * inner[1:-1] + inner[2:]) / np.float32(6)
    return np.asarray((rows[:, :-2] + 4 * rows[:, 1:-1] + rows[:, 2:]) / np.float32(6))


def places_of(texels: int, margin: int, finer: int) -> NDArray[np.float64]:
    """Return where along an axis the spline is looked at, texel middles at whole numbers.

    Evenly within the part that counts, and once beyond on either side.
    """
    count = (texels - 2 * margin) * finer
    return margin - 0.5 + (np.arange(-1, count + 1) + 0.5) / finer


def _spline(texels: Floats, places: NDArray[np.float64], axis: int) -> Floats:
    """Return the cubic spline that the shader draws, at places along one axis."""
    cell = np.floor(places).astype(np.intp)
    f = (places - cell).astype(np.float32)
    g = 1 - f
    weights = (g**3 / 6, (4 - 6 * f**2 + 3 * f**3) / 6, (4 - 6 * g**2 + 3 * g**3) / 6, f**3 / 6)
    shape = (-1, 1) if axis == 0 else (1, -1)
    last = texels.shape[axis] - 1
    parts = (
        np.take(texels, np.clip(cell + offset, 0, last), axis) * weight.reshape(shape)
        for offset, weight in zip(range(-1, 3), weights, strict=True)
    )
    return np.asarray(sum(parts), np.float32)
