"""Which tiles of the canvas the outline of a simplified shadow may cross, and which lie wholly within it."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.bands import FINEST_SIGMA_PX, Blur
from kagezou.geometry.box import Box
from kagezou.geometry.vectors import Matrix
from kagezou.render.prepare.band_atlas import Strip
from kagezou.render.prepare.occupancy import Counts, Flags, count_in, summed
from kagezou.render.prepare.shadow_tiles import TILE_PX, Boxes, runs_of, tile_corners

EMPTY, FULL, OUTLINE, JOINED = 0, 1, 2, 3

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


@dataclass(frozen=True, slots=True, eq=False)
class SeenChart:
    """One way in which a receiver looks up the blurred shadow.

    Parameters
    ----------
    strips
        Those of the chart, and what they hold after the blur.
    plane_from_canvas
        (3, 3): from the canvas to (u, v) of the blur there.
    seam, reach_px
        The ends (2, 2) of the seam near which it counts, in u and v of the receiver's own look, and how near; None for
        everywhere.
    """

    strips: Sequence[tuple[Strip, NDArray[np.float32]]]
    plane_from_canvas: Matrix
    seam: Matrix | None = None
    reach_px: float = 0.0


class Tables:
    """Summed-area tables of what strips hold over a value; several faces look the same strips up."""

    def __init__(self) -> None:
        self._made: dict[tuple[int, float], tuple[NDArray[np.float32], Counts]] = {}

    def over(self, values: NDArray[np.float32], least: float) -> Counts:
        """Return the table of which values (H, W) are over another."""
        # The array is kept beside its table, so that its number does not pass to another.
        key = (id(values), least)
        if key not in self._made:
            self._made[key] = (values, summed(values > least))
        return self._made[key][1]


@dataclass(frozen=True, slots=True, eq=False)
class ShownTiles:
    """Boxes (N, 4) of the canvas: wholly in shadow, to be looked at, and to be looked at on other charts, too."""

    full: Boxes
    outline: Boxes
    joined: Boxes

    @property
    def all(self) -> Boxes:
        """All of them."""
        return np.concatenate([self.full, self.outline, self.joined])


def outline_tiles(
    looks: Sequence[SeenChart], reach: Reach, blur: Blur, box: Box, tables: Tables | None = None
) -> ShownTiles:
    """Return the boxes of a canvas box that are wholly in shadow, and those that have to be looked at.

    A spline lies between the smallest and the largest of the texels around it, so where all of them are on one side of
    the level there is no outline; nor is there between several looks that agree. The first look is the receiver's own.
    """
    columns = np.arange(box.left // TILE_PX, -(-box.right // TILE_PX))
    rows = np.arange(box.top // TILE_PX, -(-box.bottom // TILE_PX))
    corners, tables = tile_corners(columns, rows), tables or Tables()
    finder = _Finder(reach, blur, tables)
    codes, own, bounded = finder.codes(looks[0], corners)
    is_joined = np.zeros(codes.shape, np.bool_)
    for look in looks[1:]:
        near = ~bounded | _is_near(own, look)
        if near.any():
            is_joined |= near
            others, _, _ = finder.codes(look, corners[..., near])
            codes[near] = np.where(codes[near] == others, others, OUTLINE)
    codes[is_joined & (codes == OUTLINE)] = JOINED
    boxes, kinds = runs_of(codes.reshape(len(rows), len(columns)), (int(columns[0]), int(rows[0])), box)
    return ShownTiles(*(boxes[kinds == kind] for kind in (FULL, OUTLINE, JOINED)))


@dataclass(frozen=True, slots=True)
class _Finder:
    reach: Reach
    blur: Blur
    tables: Tables

    def codes(self, look: SeenChart, corners: Matrix) -> tuple[NDArray[np.int64], Matrix, Flags]:
        """Return the code of each tile (N,), where its corners (4, 2, N) lie, and whether they do."""
        reach, blur = self.reach, self.blur
        seen = np.matmul(look.plane_from_canvas, corners)
        bounded = seen[:, 2].min(axis=0) > 1e-12 * np.abs(look.plane_from_canvas[2]).max()
        plane = seen[:, :2] / np.where(seen[:, 2] > 0, seen[:, 2], 1.0)[:, np.newaxis]
        moved = np.array(reach.moved_px)[:, np.newaxis]
        low, high = plane.min(axis=0) - moved, plane.max(axis=0) + moved
        tiles = _Tiles(low[:, bounded], high[:, bounded])
        for strip, values in look.strips:
            tiles.look_at(strip, values, (reach, self.tables), is_whole=blur.is_even)
        codes = np.full(low.shape[1], OUTLINE)
        codes[bounded] = tiles.codes
        # Where the blur is narrow the shadow as it was cast is seen too, which the strips do not tell of.
        nearest = np.where(low[1] * high[1] <= 0, 0.0, np.minimum(np.abs(low[1]), np.abs(high[1])))
        codes[nearest < blur.distance_of(FINEST_SIGMA_PX)] = OUTLINE
        return codes, plane, bounded


def _is_near(plane: Matrix, look: SeenChart) -> Flags:
    """Return which tiles, by their corners (4, 2, N), may lie within reach of a look's seam."""
    assert look.seam is not None
    middle = plane.mean(axis=0)
    half = np.hypot(*(plane - middle).transpose(1, 0, 2)).max(axis=0)
    start, run = look.seam[0][:, np.newaxis], (look.seam[1] - look.seam[0])[:, np.newaxis]
    part = np.clip(((middle - start) * run).sum(axis=0) / max(float((run * run).sum()), 1e-12), 0.0, 1.0)
    return np.asarray(np.hypot(*(middle - start - part * run)) - half < look.reach_px)


class _Tiles:
    """What is known of tiles, by the strips looked at so far.

    Parameters
    ----------
    low, high
        (2, N): the least and the largest u and v from which each tile takes its shadow.
    """

    def __init__(self, low: Matrix, high: Matrix) -> None:
        self._low, self._high = low, high
        count = low.shape[1]
        self._is_empty = np.ones(count, np.bool_)
        self._is_full = np.ones(count, np.bool_)
        self._seen_px = np.zeros(count)

    @property
    def codes(self) -> NDArray[np.int64]:
        """The code of each tile; what no strip shows is empty."""
        whole = self._seen_px >= (self._high[1] - self._low[1]) * (1 - 1e-9)
        return np.where(self._is_empty, EMPTY, np.where(self._is_full & whole, FULL, OUTLINE))

    def look_at(
        self, strip: Strip, values: NDArray[np.float32], asked: tuple[Reach, Tables], *, is_whole: bool
    ) -> None:
        """Look at the tiles that a strip shows, or at all if it is the only one."""
        reach, tables = asked
        core, texel = strip.band.core, strip.band.texel_px
        near, far = np.maximum(self._low[1], core.low), np.minimum(self._high[1], core.high)
        at = np.nonzero((near < far) | is_whole)[0]
        if not len(at):
            return
        if is_whole:
            near, far = self._low[1], self._high[1]
        low, high = np.stack([self._low[0, at], near[at]]), np.stack([self._high[0, at], far[at]])
        corner = (strip.plane_from_atlas @ np.array([strip.shown.left, strip.shown.top, 1.0]))[:2, np.newaxis]
        limit = np.array([[values.shape[1]], [values.shape[0]]])
        first = np.floor((low - corner) / texel) - _SPLINE_TEXELS
        last = np.floor((high - corner) / texel) + _SPLINE_TEXELS + 1
        leaves = (first[0] < 0) | (last[0] > limit[0])
        start = np.clip(first, 0, limit).astype(np.intp)
        stop = np.maximum(np.clip(last, 0, limit).astype(np.intp), start)
        some = count_in(tables.over(values, reach.empty), start, stop)
        full = some if reach.full == reach.empty else count_in(tables.over(values, reach.full), start, stop)
        self._is_empty[at] &= some == 0
        self._is_full[at] &= ~leaves & (full == (stop - start).prod(axis=0))
        self._seen_px[at] += far[at] - near[at]
