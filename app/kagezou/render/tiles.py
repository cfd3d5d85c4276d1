"""Which tiles of the canvas a shadow covers wholly, which hold its edge, and which it does not touch."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.geometry.shadow import Cast
from kagezou.geometry.vectors import Matrix
from kagezou.render.occupancy import Flags, Occupancy

TILE_PX = 8

Boxes = NDArray[np.float64]
"""(N, 4): left, top, right, bottom in canvas px."""


@dataclass(frozen=True, slots=True)
class Tiling:
    """The parts of a shadow, and the box around them all.

    Parameters
    ----------
    full
        Wholly covered.
    edge
        Holding an edge of the drawing, and nothing else.
    edge_at_limit
        Holding an edge where the card's contact line or a fold may run through as well.
    """

    full: Boxes
    edge: Boxes
    edge_at_limit: Boxes
    box: Box | None


def tiled(cast: Cast, region: Box, matte: tuple[Occupancy, Box], canvas: Box) -> Tiling:
    """Sort the tiles of a region by what the shadow does in them.

    Parameters
    ----------
    cast
        The shadow of one card piece.
    region
        Canvas box that can hold shadow.
    matte
        Occupancy of the drawing and the canvas box its texels cover.
    canvas
        Boxes are cut to it.
    """
    columns = np.arange(region.left // TILE_PX, -(-region.right // TILE_PX))
    rows = np.arange(region.top // TILE_PX, -(-region.bottom // TILE_PX))
    left, top = (axis.ravel() * float(TILE_PX) for axis in np.meshgrid(columns, rows))
    # One px of margin: a pixel's own area and everything its sampling may touch lies within its tile's corners.
    corners = np.array(
        [
            (left - 1, top - 1, np.ones_like(left)),
            (left + TILE_PX + 1, top - 1, np.ones_like(left)),
            (left + TILE_PX + 1, top + TILE_PX + 1, np.ones_like(left)),
            (left - 1, top + TILE_PX + 1, np.ones_like(left)),
        ]
    )
    outside, inside = _limits(cast, corners)
    empty, full = _occupied(cast, corners, matte)
    shape = (len(rows), len(columns))
    shape = (len(rows), len(columns))
    origin = (region.left // TILE_PX, region.top // TILE_PX)
    is_full = full & inside
    is_edge = ~(empty | outside | is_full)
    parts = (is_full, is_edge & inside, is_edge & ~inside)
    full_boxes, edge_boxes, limit_boxes = (_runs(part.reshape(shape), origin, canvas) for part in parts)
    around = _around((is_full | is_edge).reshape(shape), origin, canvas)
    return Tiling(full_boxes, edge_boxes, limit_boxes, around)


def _limits(cast: Cast, corners: Matrix) -> tuple[Flags, Flags]:
    """Return which tiles lie wholly beyond a limit of the cast, and which wholly within all of them."""
    outside = np.zeros(corners.shape[2], dtype=np.bool_)
    inside = np.ones(corners.shape[2], dtype=np.bool_)
    for form in (cast.side, cast.horizon, cast.left_fold, cast.right_fold):
        distance = np.einsum("k,ckn->cn", form, corners)
        outside |= distance.max(axis=0) < 0
        inside &= distance.min(axis=0) >= 0
    return outside, inside


def _occupied(cast: Cast, corners: Matrix, matte: tuple[Occupancy, Box]) -> tuple[Flags, Flags]:
    """Return which tiles see nothing of the drawing, and which only its inside."""
    occupancy, box = matte
    seen = np.einsum("ik,ckn->cin", cast.art_from_canvas, corners)
    w = seen[:, 2]
    # A tile across the horizon or the eye has no bounded picture on the drawing: it may be anything.
    unbounded = w.min(axis=0) <= 1e-9 * np.abs(cast.art_from_canvas[2]).max()
    texels = seen[:, :2] / np.where(unbounded, 1.0, w)[:, np.newaxis]
    texels -= np.array([box.left, box.top])[np.newaxis, :, np.newaxis]
    empty, full = occupancy.states(texels.min(axis=0).T, texels.max(axis=0).T)
    return empty & ~unbounded, full & ~unbounded


def _runs(flags: Flags, origin: tuple[int, int], canvas: Box) -> Boxes:
    """Return the boxes of neighbouring tiles in a row that are set, cut to the canvas."""
    steps = np.diff(np.pad(flags.astype(np.int8), ((0, 0), (1, 1))), axis=1)
    row, start = np.nonzero(steps == 1)
    _, stop = np.nonzero(steps == -1)
    boxes = np.stack([start + origin[0], row + origin[1], stop + origin[0], row + origin[1] + 1], axis=1) * TILE_PX
    low = np.array([canvas.left, canvas.top] * 2)
    high = np.array([canvas.right, canvas.bottom] * 2)
    return np.clip(boxes, low, high).astype(np.float64)


def _around(flags: Flags, origin: tuple[int, int], canvas: Box) -> Box | None:
    rows, columns = np.nonzero(flags.any(axis=1))[0], np.nonzero(flags.any(axis=0))[0]
    if len(rows) == 0:
        return None
    box = Box(
        int(columns[0] + origin[0]) * TILE_PX,
        int(rows[0] + origin[1]) * TILE_PX,
        int(columns[-1] + origin[0] + 1) * TILE_PX,
        int(rows[-1] + origin[1] + 1) * TILE_PX,
    )
    return box.intersection(canvas)
