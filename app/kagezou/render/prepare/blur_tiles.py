"""Which tiles of a strip a blur has to be summed up in: those that its Gaussian reaches from a shadow."""

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.render.prepare.band_atlas import Strip
from kagezou.render.prepare.shadow_tiles import TILE_PX, Boxes, runs_of

Mask = NDArray[np.bool_]


def blur_tiles(strip: Strip, shadow: NDArray[np.float32], reach_texels: int) -> tuple[Boxes, Boxes]:
    """Return the boxes of the atlas in which a strip's blur across the contact line, and then along it, is not zero.

    Parameters
    ----------
    strip
        Where the blur is to be known.
    shadow
        (H, W): the atlas before the blur.
    reach_texels
        How far the blur sums up on either side.
    """
    box = strip.box
    mask = _occupied(shadow[box.top : box.bottom, box.left : box.right] > 0)
    reach = -(-reach_texels // TILE_PX)
    across = _widened(mask, reach, 0)
    along = _widened(across, reach, 1)
    return _boxes(across, strip), _boxes(along, strip)


def _occupied(filled: Mask) -> Mask:
    """Return which tiles hold any filled texel."""
    height, width = (-(-side // TILE_PX) * TILE_PX for side in filled.shape)
    padded = np.zeros((height, width), np.bool_)
    padded[: filled.shape[0], : filled.shape[1]] = filled
    # Eight texels of a row are asked about as one number.
    eights = padded.view(np.uint64) if TILE_PX == 8 else padded.reshape(height, -1, TILE_PX).any(axis=2)
    return np.asarray(eights.reshape(height // TILE_PX, TILE_PX, -1).any(axis=1))


def _widened(mask: Mask, reach: int, axis: int) -> Mask:
    """Return the mask with everything within ``reach`` tiles along an axis."""
    rows = mask if axis == 0 else mask.T
    count = len(rows)
    # Nothing lies before the first tile, and no more behind the last.
    sums = np.zeros((count + 2 * reach + 1, rows.shape[1]), np.int32)
    np.cumsum(rows, axis=0, out=sums[reach + 1 : reach + 1 + count])
    sums[reach + 1 + count :] = sums[reach + count]
    widened = sums[2 * reach + 1 :] > sums[:count]
    return np.asarray(widened if axis == 0 else widened.T)


def _boxes(mask: Mask, strip: Strip) -> Boxes:
    box, shown = strip.box, strip.shown
    boxes, _ = runs_of(mask.astype(np.int64), (0, 0), Box(0, 0, box.width, box.height))
    low, high = [shown.left, shown.top] * 2, [shown.right, shown.bottom] * 2
    boxes = np.clip(boxes + np.array([box.left, box.top] * 2), low, high)
    return np.asarray(boxes[(boxes[:, 2] > boxes[:, 0]) & (boxes[:, 3] > boxes[:, 1])])
