"""The tiles of several pieces of a card whose shadows continue one another, sorted all at once.

A card of many pieces has hardly more tiles than a flat one; what would cost is to sort and draw each piece by itself.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.shadow import Cast
from kagezou.geometry.vectors import Matrix
from kagezou.render.prepare.matte_on_canvas import MatteOnCanvas
from kagezou.render.prepare.piece_tiles import ENDS, SEVERAL, Numbers, PieceTiles, tiles_of
from kagezou.render.prepare.shadow_tiles import (
    FIRST_EDGE,
    FULL,
    TILE_PX,
    UNTOUCHED,
    Boxes,
    Codes,
    EdgeKind,
    Fineness,
    around_boxes,
    edge_codes,
    kind_of,
)

_COST_OF_A_CALL = 8000.0
"""Cells that are drawn in the time that one call more takes, about, with a software rasteriser."""

_CELLS_AT_SEVERAL = 2.0
"""Of a full drawing's pixel, each way, through which several ends run."""

_WAYS = SEVERAL + 1


@dataclass(frozen=True, slots=True)
class JoinedTiling:
    """The parts of shadows: what is wholly covered, the edges by their kind, and all their box.

    Each edge has the number of its piece times ENDS, plus that of the end that runs through it where there is one.
    """

    full: Boxes
    edges: Mapping["JoinedKind", tuple[Boxes, Numbers]]
    box: Box | None


@dataclass(frozen=True, slots=True)
class JoinedKind:
    """How the pixels of some tiles are to be drawn, and whether only one end at most may run through each of them."""

    edge: EdgeKind
    is_at_one: bool

    @property
    def switches(self) -> frozenset[str]:
        """The switches of ``passes/cast.frag``."""
        return self.edge.switches | (frozenset({"ONE_LIMIT"}) if self.is_at_one else frozenset())

    @property
    def cost(self) -> float:
        """How much work a pixel is, in cells without an end."""
        ends = 1.0 if not self.edge.is_at_limit else 1.15 if self.is_at_one else 1.9
        return self.edge.cells_x * self.edge.cells_y * ends

    def serves(self, other: "JoinedKind") -> bool:
        """Return whether tiles of another kind may be drawn as this one."""
        own, its = self.edge, other.edge
        is_fine = own.cells_x >= its.cells_x and own.cells_y >= its.cells_y and own.is_squeezed == its.is_squeezed
        return (
            is_fine
            and own.is_at_limit >= its.is_at_limit
            and (not self.is_at_one or other.is_at_one or not its.is_at_limit)
        )


def joined_tiling(
    casts: Sequence[Cast], regions: Sequence[Box], matte: MatteOnCanvas, fineness: Fineness, canvas: Box
) -> JoinedTiling:
    """Sort the tiles of regions, one a cast, by what the shadow does in them.

    Parameters
    ----------
    casts, regions
        The shadows of card pieces, and the canvas boxes that can hold them.
    matte
        The drawing.
    fineness
        How many cells there are to be.
    canvas
        The boxes are cut to it.
    """
    tiles = tiles_of(casts, regions)
    outside, ends = tiles.ends()
    may_hold = np.nonzero(~(outside | tiles.is_end))[0]
    ends = ends[may_hold]
    codes = _codes(tiles.of(may_hold), ends, matte, fineness)
    found = np.full(len(tiles.columns), UNTOUCHED)
    found[may_hold] = codes * _WAYS + np.where(codes >= FIRST_EDGE, ends, 0)
    return _runs(tiles, found, canvas)


def _codes(tiles: PieceTiles, ends: Codes, matte: MatteOnCanvas, fineness: Fineness) -> Codes:
    """Return what is to be drawn in tiles through which ends run, or none."""
    art, w, is_bounded = tiles.seen()
    corner = np.array([[matte.box.left], [matte.box.top]], np.float64)
    empty, full = matte.occupancy.states(art.min(axis=0) - corner, art.max(axis=0) - corner)
    codes, full = np.full(len(tiles.columns), UNTOUCHED), full & is_bounded
    is_full = full & (ends == 0)
    codes[is_full] = FULL
    is_edge = np.nonzero(~((empty & is_bounded) | is_full))[0]
    cells = _stretch(tiles.art_rows[..., is_edge], art[..., is_edge], w[:, is_edge]) * fineness.cells_a_texel
    cells[:, ~is_bounded[is_edge]] = np.inf
    # Where the drawing is full the part within a straight end is known exactly.
    cells[:, full[is_edge]] = np.where(ends[is_edge][full[is_edge]] < SEVERAL, 1.0, _CELLS_AT_SEVERAL)
    codes[is_edge] = edge_codes(cells, ends[is_edge] > 0, fineness.max_cells)
    return codes


def _stretch(rows: Matrix, art: Matrix, w: Matrix) -> Matrix:
    """Return how many texels one canvas px covers at most in each tile, (2, N): along x and along y."""
    safe = np.where(w > 0, w, 1.0)
    squares = [
        ((rows[0, k] - art[:, 0] * rows[2, k]) ** 2 + (rows[1, k] - art[:, 1] * rows[2, k]) ** 2) / (safe * safe)
        for k in (0, 1)
    ]
    return np.sqrt([each.max(axis=0) for each in squares])


def _runs(tiles: PieceTiles, codes: Codes, canvas: Box) -> JoinedTiling:
    """Return the boxes of neighbouring tiles in a row that have one code, cut to the canvas."""
    begins = np.nonzero(codes != np.concatenate([[UNTOUCHED], codes[:-1]]))[0]
    # Each run ends where the next one begins; the end of every row is untouched and begins one.
    ends, kinds = np.append(begins[1:], begins[-1:]), codes[begins]
    touched = kinds != UNTOUCHED
    begins, ends, kinds = begins[touched], ends[touched], kinds[touched]
    left, top = tiles.columns[begins], tiles.rows[begins]
    boxes = np.stack([left, top, left + ends - begins, top + 1], axis=1) * TILE_PX
    low, high = [canvas.left, canvas.top] * 2, [canvas.right, canvas.bottom] * 2
    boxes = np.clip(boxes, low, high).astype(np.float64)
    kinds, ways = np.divmod(kinds, _WAYS)
    edges = _gathered(kinds, ways, (boxes, tiles.pieces[begins] * ENDS))
    return JoinedTiling(boxes[kinds == FULL], edges, around_boxes(boxes))


def _gathered(kinds: Codes, ways: Codes, found: tuple[Boxes, Numbers]) -> dict[JoinedKind, tuple[Boxes, Numbers]]:
    """Return boxes and numbers by their kinds; few of one are drawn as another that does all they need."""
    boxes, numbers = found
    manners = kinds * 2 + ((ways > 0) & (ways < SEVERAL))
    areas = np.bincount(manners, (boxes[:, 2] - boxes[:, 0]) * (boxes[:, 3] - boxes[:, 1]))
    wanted = {code: _manner(code) for code in np.nonzero(areas)[0].tolist() if code >= 2 * FIRST_EDGE}
    drawn_as = np.arange(len(areas))
    for code in sorted(wanted, key=lambda each: float(areas[each])):
        others = [
            each for each in wanted if each != code and drawn_as[each] == each and wanted[each].serves(wanted[code])
        ]
        best = min(others, key=lambda each: wanted[each].cost, default=code)
        if best != code and areas[code] * (wanted[best].cost - wanted[code].cost) < _COST_OF_A_CALL:
            drawn_as[drawn_as == code] = best
            areas[best] += areas[code]
    manners = drawn_as[manners]
    edges: dict[JoinedKind, tuple[Boxes, Numbers]] = {}
    for code, kind in wanted.items():
        if drawn_as[code] == code:
            chosen = np.nonzero(manners == code)[0]
            ends = np.maximum(ways[chosen] - 1, 0) if kind.is_at_one else 0
            edges[kind] = boxes[chosen], numbers[chosen] + ends
    return edges


def _manner(code: int) -> JoinedKind:
    kind, at_one = divmod(code, 2)
    return JoinedKind(kind_of(kind), bool(at_one))
