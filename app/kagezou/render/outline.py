"""Which tiles of the canvas the outline of a simplified shadow may cross, and which lie wholly within it."""

from collections.abc import Iterable

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


def outline_tiles(
    strips: Iterable[tuple[Strip, NDArray[np.float32]]], level: float, blur: Blur, plane_from_canvas: Matrix, box: Box
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
    low, high = plane.min(axis=0), plane.max(axis=0)
    codes = np.full(low.shape[1], OUTLINE)
    for strip, values in strips:
        _decide(codes, strip, values > level, (low, high), bounded, whole=blur.distance_px <= 0)
    if blur.distance_px > 0:
        nearest = np.where(low[1] * high[1] <= 0, 0.0, np.minimum(np.abs(low[1]), np.abs(high[1])))
        codes[nearest < blur.distance_of(min(FINEST_SIGMA_PX, blur.amount_px))] = OUTLINE
    boxes, kinds = runs_of(codes.reshape(len(rows), len(columns)), (int(columns[0]), int(rows[0])), box)
    return boxes[kinds == FULL], boxes[kinds == OUTLINE]


def _decide(
    codes: NDArray[np.int64],
    strip: Strip,
    over: NDArray[np.bool_],
    reach: tuple[Matrix, Matrix],
    bounded: NDArray[np.bool_],
    *,
    whole: bool,
) -> None:
    """Mark the tiles that lie within one strip's core and on one side of the level there."""
    core, texel = strip.band.core, strip.band.texel_px
    low, high = reach
    inside = bounded & ((low[1] >= core.low) & (high[1] <= core.high) | whole)
    corner = (strip.plane_from_atlas @ np.array([strip.shown.left, strip.shown.top, 1.0]))[:2, np.newaxis]
    limit = np.array([over.shape[1], over.shape[0]])
    first = np.floor((low[:, inside] - corner) / texel).T - _SPLINE_TEXELS
    last = np.floor((high[:, inside] - corner) / texel).T + _SPLINE_TEXELS + 1
    leaves = ((first < 0) | (last > limit)).any(axis=1)
    start = np.clip(first, 0, limit).astype(np.intp)
    stop = np.maximum(np.clip(last, 0, limit).astype(np.intp), start)
    count = count_in(summed(over), start, stop)
    texels = (stop - start).prod(axis=1)
    codes[inside] = np.where(count == 0, EMPTY, np.where(~leaves & (count == texels), FULL, OUTLINE))
