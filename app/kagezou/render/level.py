"""The level at which a blurred shadow has the area it had before (spec 3)."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

SMALL_TEXELS = 40_000
"""A band of fewer texels than this is counted on a finer grid, so that its outline is not counted in whole texels."""

FINER = 4
_STEPS = 65536

Values = NDArray[np.uint16]


@dataclass(frozen=True, slots=True, eq=False)
class Counted:
    """The shown part of one band.

    Parameters
    ----------
    sharp, blurred
        (h, w) of 65535, before and after the blur, with ``margin`` texels around the part that counts.
    weights
        (h - 2·margin,): the area of a texel of each row that counts, px².
    margin
        Texels.
    """

    sharp: Values
    blurred: Values
    weights: NDArray[np.float64]
    margin: int


def area_preserving_level(bands: Sequence[Counted]) -> float:
    """Return the level, 0 to 1, over which the blurred shadow has the area of the sharp one.

    A half where there is no shadow at all.
    """
    histogram = np.zeros(_STEPS)
    area = 0.0
    for band in bands:
        m = band.margin
        inner = band.sharp[m : band.sharp.shape[0] - m, m : band.sharp.shape[1] - m]
        area += float(inner.sum(axis=1, dtype=np.float64) @ band.weights) / (_STEPS - 1)
        values, weights = _counted(band)
        histogram += np.bincount(values, weights, _STEPS)
    if area <= 0:
        return 0.5
    # Area over each level, from the highest down; the level lies where it first reaches the wanted one.
    over = np.cumsum(histogram[::-1])
    index = int(np.searchsorted(over, area))
    if index >= _STEPS:
        return 0.0
    before = over[index - 1] if index else 0.0
    part = (area - before) / max(over[index] - before, 1e-12)
    return float((_STEPS - index - part) / (_STEPS - 1))


def _counted(band: Counted) -> tuple[NDArray[np.intp], NDArray[np.float64]]:
    """Return the values of a band and the area that each stands for."""
    blurred, m = band.blurred.astype(np.float64), band.margin
    height, width = blurred.shape
    finer = FINER if blurred.size < SMALL_TEXELS else 1
    if finer == 1:
        rows = (blurred[m - 1 : -m - 1] + 4 * blurred[m:-m] + blurred[m + 1 : height - m + 1]) / 6
        values = (rows[:, m - 1 : -m - 1] + 4 * rows[:, m:-m] + rows[:, m + 1 : width - m + 1]) / 6
    else:
        values = _spline(height, m, finer) @ blurred @ _spline(width, m, finer).T
    weights = np.repeat(band.weights / finer**2, finer)
    steps = np.clip(np.rint(values), 0, _STEPS - 1).astype(np.intp)
    return steps.ravel(), np.repeat(weights, steps.shape[1])


def _spline(texels: int, margin: int, finer: int) -> NDArray[np.float64]:
    """Return the matrix ((texels - 2·margin)·finer, texels) that evaluates the cubic spline the shader draws."""
    count = (texels - 2 * margin) * finer
    place = margin + (np.arange(count) + 0.5) / finer - 0.5
    cell = np.floor(place).astype(np.intp)
    f = place - cell
    g = 1 - f
    weights = (g**3 / 6, (4 - 6 * f**2 + 3 * f**3) / 6, (4 - 6 * g**2 + 3 * g**3) / 6, f**3 / 6)
    matrix = np.zeros((count, texels))
    for offset, weight in zip(range(-1, 3), weights, strict=True):
        matrix[np.arange(count), np.clip(cell + offset, 0, texels - 1)] += weight
    return matrix
