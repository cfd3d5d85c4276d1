"""The tiles in which the shadows of a card's pieces may lie, many pieces at once."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.geometry.polygon import bounding_box
from kagezou.geometry.shadow import Cast
from kagezou.geometry.vectors import Matrix
from kagezou.render.prepare.occupancy import Flags
from kagezou.render.prepare.shadow_tiles import MARGIN_PX, TILE_PX, Codes

MOST_LIMITS = 4
"""Edges of a piece."""

ENDS = 1 + MOST_LIMITS
"""Ends of a piece's shadow: its side and the edges."""

SEVERAL = ENDS + 1
"""Through a tile runs no end (0), the one of a number less 1, or several."""

_NO_LIMIT = (0.0, 0.0, 1e6)
_RIM_PX = 1

Numbers = NDArray[np.int64]

_Number = TypeVar("_Number", np.int64, np.float64)


@dataclass(frozen=True, eq=False)
class PieceTiles:
    """Columns, rows and pieces (N,) of square tiles, piece by piece and row by row.

    Parameters
    ----------
    is_end
        Which stand after a row of a piece, only to end it.
    casts
        The shadows of the pieces.
    """

    columns: Codes
    rows: Codes
    pieces: Numbers
    is_end: Flags
    casts: Sequence[Cast]

    def of(self, kept: Codes) -> "PieceTiles":
        """Return some of the tiles, given by their numbers."""
        columns, rows, pieces = (each[kept] for each in (self.columns, self.rows, self.pieces))
        return PieceTiles(columns, rows, pieces, self.is_end[kept], self.casts)

    def each(self, of_pieces: NDArray[_Number]) -> NDArray[_Number]:
        """Return numbers (..., N) for each tile of numbers (..., P) for each piece."""
        return np.repeat(of_pieces, np.bincount(self.pieces, minlength=of_pieces.shape[-1]), axis=-1)

    @cached_property
    def art_rows(self) -> Matrix:
        """The homographies to the drawing, (3, 3, N)."""
        return self.each(np.array([cast.art_from_canvas for cast in self.casts]).transpose(1, 2, 0))

    def seen(self) -> tuple[Matrix, Matrix, Flags]:
        """Return where on the drawing tiles' corners are seen (4, 2, N), with which w (4, N), and if bounded (N,).

        A tile across the horizon or the eye has no bounded picture on the drawing: it may be anything.
        """
        rows, side = self.art_rows, TILE_PX + 2 * MARGIN_PX
        left, top = self.columns * TILE_PX - MARGIN_PX, self.rows * TILE_PX - MARGIN_PX
        near = rows[:, 0] * left + rows[:, 1] * top + rows[:, 2]
        across, down = rows[:, 0] * side, rows[:, 1] * side
        corners = np.array([near, near + across, near + across + down, near + down])
        w = corners[:, 2]
        is_bounded = w.min(axis=0) > 1e-9 * np.abs(rows[2]).max(axis=0)
        return corners[:, :2] / np.where(w > 0, w, 1.0)[:, np.newaxis], w, is_bounded

    def ends(self) -> tuple[Flags, Codes]:
        """Return which tiles lie wholly beyond an end of their shadow, and which ends run through them, to SEVERAL."""
        horizons = np.array([[cast.horizon] for cast in self.casts])
        forms = np.concatenate([limits_of(self.casts), horizons], axis=1)
        # The farthest corner of a tile is as far from each line through its middle as the line's slopes say.
        reaches = np.abs(forms[..., :2]).sum(axis=2, keepdims=True) * (TILE_PX / 2 + MARGIN_PX)
        a, b, c, reach = self.each(np.concatenate([forms, reaches], axis=2).T)
        away = a * ((self.columns + 0.5) * TILE_PX) + b * ((self.rows + 0.5) * TILE_PX) + c
        is_crossed = away < reach
        only = np.minimum(is_crossed.argmax(axis=0) + 1, SEVERAL)
        counts = is_crossed.sum(axis=0)
        return (away < -reach).any(axis=0), np.where(counts < 2, only * counts, SEVERAL)


def tiles_of(casts: Sequence[Cast], regions: Sequence[Box]) -> PieceTiles:
    """Return the tiles of regions of the canvas, one a cast."""
    edges = np.array([(region.left, region.top, region.right, region.bottom) for region in regions])
    left, top = edges[:, 0] // TILE_PX, edges[:, 1] // TILE_PX
    across, down = -(-edges[:, 2] // TILE_PX) - left + 1, -(-edges[:, 3] // TILE_PX) - top
    counts = across * down
    pieces = np.repeat(np.arange(len(regions)), counts)
    place = np.arange(len(pieces)) - np.repeat(np.cumsum(counts) - counts, counts)
    width = across[pieces]
    row = place // width
    column = place - row * width
    return PieceTiles(left[pieces] + column, top[pieces] + row, pieces, column == width - 1, casts)


def regions_of(casts: Sequence[Cast], parts: Sequence[Matrix], art: Box, canvas: Box) -> list[Box | None]:
    """Return the boxes of ``canvas`` that can hold the shadows of parts of a drawing.

    Parameters
    ----------
    casts
        The shadows of card pieces.
    parts
        For each the convex polygon (N, 2), N > 2, of the drawing that lies on its piece.
    art
        The drawing's box.
    """
    starts = np.cumsum([0, *(len(part) for part in parts[:-1])])
    pieces = np.repeat(np.arange(len(parts)), [len(part) for part in parts])
    corners = np.column_stack([np.concatenate(parts), np.ones(len(pieces))])
    homographies = np.array([cast.art_from_canvas for cast in casts])
    seen = np.einsum("nij,nj->ni", np.linalg.inv(homographies)[pieces], corners)
    w = seen[:, 2]
    is_near = w > 1e-9 * np.abs(seen).max(axis=1)
    places = seen[:, :2] / np.where(is_near, w, 1.0)[:, np.newaxis]
    horizons = np.array([cast.horizon for cast in casts])[pieces]
    is_near &= (horizons[:, :2] * places).sum(axis=1) + horizons[:, 2] > _RIM_PX
    is_bounded = np.logical_and.reduceat(is_near, starts)
    first, last = np.array([canvas.left, canvas.top]), np.array([canvas.right, canvas.bottom])
    low = np.clip(np.floor(np.minimum.reduceat(places, starts)) - _RIM_PX, first, last)
    high = np.clip(np.ceil(np.maximum.reduceat(places, starts)) + _RIM_PX, first, last)
    found = [Box(*corners) for corners in np.hstack([low, high]).astype(int).tolist()]
    # What is as high as the lamp, or seen beyond the horizon, has to be cut.
    return [
        (None if box.is_empty else box) if is_whole else bounding_box(cast.region(canvas, art))
        for box, is_whole, cast in zip(found, is_bounded.tolist(), casts, strict=True)
    ]


def limits_of(casts: Sequence[Cast]) -> Matrix:
    """Return the sides and the limits of P casts, (P, ENDS, 3), of each as many forms as any has."""
    forms = np.empty((len(casts), ENDS, 3))
    forms[:] = _NO_LIMIT
    for own, cast in zip(forms, casts, strict=True):
        own[0] = cast.side
        own[1 : 1 + len(cast.limits)] = cast.limits
    return forms
