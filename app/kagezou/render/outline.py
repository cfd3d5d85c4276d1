"""Which tiles of the canvas the outline of a simplified shadow may cross, and which lie wholly within it."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.bands import FINEST_SIGMA_PX, Blur
from kagezou.geometry.box import Box
from kagezou.geometry.vectors import Matrix
from kagezou.render.atlas import Strip
from kagezou.render.occupancy import count_in, summed
from kagezou.render.tiles import TILE_PX, Boxes, runs_of, tile_corners

EMPTY, FULL, OUTLINE = 0, 1, 2

_SPLINE_TEXELS = 2


@dataclass(frozen=True, slots=True)
class Reach:
    """Where a place of the canvas may take its shadow from, and which values decide.

    Parameters
    ----------
    empty, full
        Values up to ``empty`` are no shadow, values over ``full`` are nothing else.
    moved_px
        How far waves may move a place, in u and v.
    """

    empty: float
    full: float
    moved_px: tuple[float, float] = (0.0, 0.0)


def outline_tiles(
    strips: Iterable[tuple[Strip, NDArray[np.float32]]], reach: Reach, blur: Blur, plane_from_canvas: Matrix, box: Box
) -> tuple[Boxes, Boxes]:
    """Return the boxes of a canvas box that are wholly in shadow, and those that have to be looked at.

    A spline lies between the smallest and the largest of the texels around it, so where all of them are on one side of
    the level there is no outline.
    """
    columns = np.arange(box.left // TILE_PX, -(-box.right // TILE_PX))
    rows = np.arange(box.top // TILE_PX, -(-box.bottom // TILE_PX))
    seen = np.matmul(plane_from_canvas, tile_corners(columns, rows))
    bounded = seen[:, 2].min(axis=0) > 1e-12 * np.abs(plane_from_canvas[2]).max()
    plane = seen[:, :2] / np.where(seen[:, 2] > 0, seen[:, 2], 1.0)[:, np.newaxis]
    moved = np.array(reach.moved_px)[:, np.newaxis]
    low, high = plane.min(axis=0) - moved, plane.max(axis=0) + moved
    codes = np.full(low.shape[1], OUTLINE)
    for strip, values in strips:
        sides = (values > reach.empty, values > reach.full)
        _decide(codes, strip, sides, (low, high), bounded & (blur.is_even | _within(strip, low, high)))
    if not blur.is_even:
        nearest = np.where(low[1] * high[1] <= 0, 0.0, np.minimum(np.abs(low[1]), np.abs(high[1])))
        codes[nearest < blur.distance_of(FINEST_SIGMA_PX)] = OUTLINE
    boxes, kinds = runs_of(codes.reshape(len(rows), len(columns)), (int(columns[0]), int(rows[0])), box)
    return boxes[kinds == FULL], boxes[kinds == OUTLINE]


def _within(strip: Strip, low: Matrix, high: Matrix) -> NDArray[np.bool_]:
    """Tell which tiles lie within the rows that are shown from a strip."""
    core = strip.band.core
    return np.asarray((low[1] >= core.low) & (high[1] <= core.high))


def _decide(
    codes: NDArray[np.int64],
    strip: Strip,
    sides: tuple[NDArray[np.bool_], NDArray[np.bool_]],
    reach: tuple[Matrix, Matrix],
    inside: NDArray[np.bool_],
) -> None:
    """Mark the tiles among ``inside`` in which one strip has no shadow, or nothing else."""
    texel = strip.band.texel_px
    low, high = reach
    some, full = sides
    corner = (strip.plane_from_atlas @ np.array([strip.shown.left, strip.shown.top, 1.0]))[:2, np.newaxis]
    limit = np.array([some.shape[1], some.shape[0]])
    first = np.floor((low[:, inside] - corner) / texel).T - _SPLINE_TEXELS
    last = np.floor((high[:, inside] - corner) / texel).T + _SPLINE_TEXELS + 1
    leaves = ((first < 0) | (last > limit)).any(axis=1)
    start = np.clip(first, 0, limit).astype(np.intp)
    stop = np.maximum(np.clip(last, 0, limit).astype(np.intp), start)
    texels = (stop - start).prod(axis=1)
    is_full = ~leaves & (count_in(summed(full), start, stop) == texels)
    is_empty = count_in(summed(some), start, stop) == 0
    codes[inside] = np.where(is_empty, EMPTY, np.where(is_full, FULL, OUTLINE))
