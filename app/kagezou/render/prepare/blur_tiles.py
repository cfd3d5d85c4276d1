"""Which tiles of a large strip a blur has to be summed up in: those within reach of both shadow and none."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.render.prepare.band_atlas import Strip
from kagezou.render.prepare.shadow_tiles import TILE_PX, Boxes, runs_of

MANY_TEXELS = 1 << 13
"""Below this many, finding tiles costs more than it saves."""

Mask = NDArray[np.bool_]

_FULL, _EDGE = 1, 2


@dataclass(frozen=True, slots=True, eq=False)
class BlurTiles:
    """Boxes of the atlas: those that are wholly shadow after one direction, and those that have to be summed up.

    Parameters
    ----------
    full, summed
        (N, 4).
    corners
        (N, 2): x and y of the first texel of every tile within ``summed``, in the atlas.
    """

    full: Boxes
    summed: Boxes
    corners: NDArray[np.intp]


def blur_tiles(strip: Strip, texels: NDArray[np.float32]) -> tuple[BlurTiles, BlurTiles]:
    """Return the tiles of a strip's blur across the contact line, and then along it; elsewhere there is no shadow.

    Parameters
    ----------
    strip
        Where the blur is to be known.
    texels
        (h, w): what it holds before the blur.
    """
    some, gaps = _occupied(texels > 0, beyond=False), _occupied(texels < 1, beyond=True)
    reach = -(-int(np.ceil(strip.band.reach_texels)) // TILE_PX)
    some, gaps = _widened(some, reach, 0), ~_eroded(~gaps, reach, 0)
    across = _tiles(some, gaps, strip)
    return across, _tiles(_widened(some, reach, 1), ~_eroded(~gaps, reach, 1), strip)


def _occupied(filled: Mask, *, beyond: bool) -> Mask:
    """Return which tiles hold any filled texel; ``beyond`` says whether those behind the last ones count as filled."""
    height, width = (-(-side // TILE_PX) * TILE_PX for side in filled.shape)
    padded = np.full((height, width), beyond, np.bool_)
    padded[: filled.shape[0], : filled.shape[1]] = filled
    # Eight texels of a row are asked about as one number.
    eights = padded.view(np.uint64) if TILE_PX == 8 else padded.reshape(height, -1, TILE_PX).any(axis=2)
    return np.asarray(eights.reshape(height // TILE_PX, TILE_PX, -1).any(axis=1))


def _near(mask: Mask, reach: int, axis: int) -> NDArray[np.int32]:
    """Return how many tiles within ``reach`` of each along an axis are in a mask; none lies beyond it."""
    rows = mask if axis == 0 else mask.T
    count = len(rows)
    sums = np.zeros((count + 2 * reach + 1, rows.shape[1]), np.int32)
    np.cumsum(rows, axis=0, out=sums[reach + 1 : reach + 1 + count])
    sums[reach + 1 + count :] = sums[reach + count]
    near = sums[2 * reach + 1 :] - sums[:count]
    return np.asarray(near if axis == 0 else near.T)


def _widened(mask: Mask, reach: int, axis: int) -> Mask:
    """Return the mask with everything within ``reach`` tiles along an axis."""
    return np.asarray(_near(mask, reach, axis) > 0)


def _eroded(mask: Mask, reach: int, axis: int) -> Mask:
    """Return what has nothing but the mask within ``reach`` tiles along an axis."""
    return np.asarray(_near(mask, reach, axis) == 2 * reach + 1)


def _tiles(some: Mask, gaps: Mask, strip: Strip) -> BlurTiles:
    box, shown = strip.box, strip.shown
    codes = np.where(some, np.where(gaps, _EDGE, _FULL), 0)
    boxes, kinds = runs_of(codes, (0, 0), Box(0, 0, box.width, box.height))
    low, high = [shown.left, shown.top] * 2, [shown.right, shown.bottom] * 2
    boxes = np.clip(boxes + np.array([box.left, box.top] * 2), low, high)
    holds = (boxes[:, 2] > boxes[:, 0]) & (boxes[:, 3] > boxes[:, 1])
    rows, columns = np.nonzero(codes == _EDGE)
    corners = np.stack([box.left + columns * TILE_PX, box.top + rows * TILE_PX], axis=1)
    return BlurTiles(boxes[holds & (kinds == _FULL)], boxes[holds & (kinds == _EDGE)], corners)
