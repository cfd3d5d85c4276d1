"""Which tiles of the canvas a shadow covers wholly, which hold its edge and how finely, and which it does not touch."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.geometry.shadow import Cast
from kagezou.geometry.vectors import Matrix
from kagezou.render.prepare.matte_on_canvas import MatteOnCanvas
from kagezou.render.prepare.occupancy import Flags

TILE_PX = 8

MARGIN_PX = 0.25
"""How far beyond a tile its pixels look: squares of texels that stand for a cell are wider than it, but no more than
twice, and there are only such where a px has 16 cells or more each way."""

CELLS = (1, 2, 3, 4, 6, 8, 12, 16, 24, 32)
"""The numbers of cells, each way, that a pixel may be split into."""

UNTOUCHED, FULL, FIRST_EDGE = 0, 1, 2
_SECOND = 1 << 16

Boxes = NDArray[np.float64]
"""(N, 4): left, top, right, bottom in canvas px."""

Codes = NDArray[np.int64]


@dataclass(frozen=True, slots=True)
class EdgeKind:
    """How the pixels of some tiles are to be drawn.

    Parameters
    ----------
    cells_x, cells_y
        Into how many cells a pixel is split.
    is_at_limit
        Whether the card's contact line or a fold may run through.
    is_squeezed
        Whether more texels fall on a pixel than cells can hold.
    """

    cells_x: int
    cells_y: int
    is_at_limit: bool
    is_squeezed: bool

    @property
    def switches(self) -> frozenset[str]:
        """The switches of ``passes/cast.frag``."""
        flags = (("AT_A_LIMIT", self.is_at_limit), ("SQUEEZED", self.is_squeezed))
        return frozenset(
            {f"CELLS_X {self.cells_x}", f"CELLS_Y {self.cells_y}", *(name for name, is_set in flags if is_set)}
        )


@dataclass(frozen=True, slots=True)
class Fineness:
    """Into how many cells a pixel is split: so many a texel, but no more than ``max_cells`` (one of CELLS) each way."""

    cells_a_texel: float
    max_cells: int = CELLS[-1]


@dataclass(frozen=True, slots=True)
class Tiling:
    """The parts of a shadow: what is wholly covered, the edges by their kind, and the box around it all."""

    full: Boxes
    edges: Mapping[EdgeKind, Boxes]
    box: Box | None

    @property
    def boxes(self) -> Boxes:
        """All of them."""
        return np.concatenate([self.full, *self.edges.values()])


@dataclass(frozen=True, slots=True, eq=False)
class TileGrid:
    """Tiles and what a shadow does in each.

    Parameters
    ----------
    codes
        (rows, columns): what is to be drawn.
    columns, rows
        Which tiles of the canvas they are.
    """

    codes: Codes
    columns: Codes
    rows: Codes

    @property
    def touched(self) -> Flags:
        """Which tiles, row by row, hold any shadow."""
        return np.asarray(self.codes.ravel() != UNTOUCHED)

    def corners(self) -> Matrix:
        """Return the corners of all tiles (4, 3, N), row by row."""
        return tile_corners(self.columns, self.rows)

    def tilings(self, canvas: Box, first: Flags, second: Flags) -> tuple[Tiling, Tiling]:
        """Return the boxes of two sets of tiles that have none in common, as :meth:`tiling` does those of one."""
        either = (first | second).reshape(self.codes.shape)
        codes = np.where(either, self.codes + np.where(second, _SECOND, 0).reshape(self.codes.shape), UNTOUCHED)
        boxes, kinds = runs_of(codes, (int(self.columns[0]), int(self.rows[0])), canvas)
        is_second = kinds >= _SECOND
        return _tiling(boxes[~is_second], kinds[~is_second]), _tiling(boxes[is_second], kinds[is_second] - _SECOND)

    def tiling(self, canvas: Box, kept: Flags | None = None) -> Tiling:
        """Return the boxes of the tiles, or of those kept (one flag a tile, row by row), cut to the canvas."""
        codes = self.codes if kept is None else np.where(kept.reshape(self.codes.shape), self.codes, UNTOUCHED)
        return _tiling(*runs_of(codes, (int(self.columns[0]), int(self.rows[0])), canvas))


def _tiling(boxes: Boxes, kinds: Codes) -> Tiling:
    edges = {kind_of(code): boxes[kinds == code] for code in sorted(set(kinds.tolist())) if code >= FIRST_EDGE}
    return Tiling(boxes[kinds == FULL], edges, around_boxes(boxes))


def tile_grid(cast: Cast, region: Box, matte: MatteOnCanvas, fineness: Fineness) -> TileGrid:
    """Sort the tiles of a region by what the shadow does in them.

    Parameters
    ----------
    cast
        The shadow of one card piece.
    region
        Canvas box that can hold shadow.
    matte
        The drawing.
    fineness
        How many cells there are to be.
    """
    columns = np.arange(region.left // TILE_PX, -(-region.right // TILE_PX))
    rows = np.arange(region.top // TILE_PX, -(-region.bottom // TILE_PX))
    corners = tile_corners(columns, rows, MARGIN_PX)
    outside, inside = _limits(cast, columns, rows)
    texels, w = _seen(cast, corners, matte.box)
    empty, full = matte.occupancy.states(texels.min(axis=0), texels.max(axis=0))
    # A tile across the horizon or the eye has no bounded picture on the drawing: it may be anything.
    bounded = w.min(axis=0) > 1e-9 * np.abs(cast.art_from_canvas[2]).max()
    codes = np.full(len(outside), UNTOUCHED)
    is_full = full & inside & bounded
    codes[is_full] = FULL
    is_edge = ~((empty & bounded) | outside | is_full)
    stretch = _stretch(cast, texels[..., is_edge] + _corner_of(matte.box), w[:, is_edge]) * fineness.cells_a_texel
    stretch[:, ~bounded[is_edge]] = np.inf
    codes[is_edge] = edge_codes(stretch, ~inside[is_edge], fineness.max_cells)
    return TileGrid(codes.reshape(len(rows), len(columns)), columns, rows)


def tile_corners(columns: Codes, rows: Codes, margin_px: float = 1.0) -> Matrix:
    """Return the corners (4, 3, N) of tiles with a margin as homogeneous canvas points, row by row.

    With one px, a pixel's own area and all that any sampling may touch lies within its tile's corners.
    """
    near, far = -margin_px, TILE_PX + margin_px
    corners = np.ones((4, 3, len(rows), len(columns)))
    corners[:, 0] = (columns * TILE_PX + np.array([[near], [far], [far], [near]]))[:, np.newaxis]
    corners[:, 1] = (rows * TILE_PX + np.array([[near], [near], [far], [far]]))[:, :, np.newaxis]
    return corners.reshape(4, 3, -1)


def _corner_of(box: Box) -> Matrix:
    return np.array([box.left, box.top], dtype=np.float64)[np.newaxis, :, np.newaxis]


def _limits(cast: Cast, columns: Codes, rows: Codes) -> tuple[Flags, Flags]:
    """Return which tiles, row by row, lie wholly beyond a limit of the cast, and which wholly within all of them."""
    forms = np.array([cast.side, cast.horizon, *cast.limits])
    middles = (columns + 0.5) * TILE_PX, (rows + 0.5) * TILE_PX
    across, down = (forms[:, axis, np.newaxis] * middles[axis] for axis in (0, 1))
    # The farthest corner of a tile is as far from each line through its middle as the line's slopes say.
    reach = np.abs(forms[:, :2]).sum(axis=1) * (TILE_PX / 2 + MARGIN_PX)
    distances = across[:, np.newaxis] + (down + forms[:, 2:])[..., np.newaxis]
    is_beyond = (distances < -reach[:, np.newaxis, np.newaxis]).any(axis=0)
    is_within = (distances >= reach[:, np.newaxis, np.newaxis]).all(axis=0)
    return is_beyond.ravel(), is_within.ravel()


def _seen(cast: Cast, corners: Matrix, box: Box) -> tuple[Matrix, Matrix]:
    """Return which texels (4, 2, N) of the drawing tiles' corners see, and the w (4, N) of the projection."""
    seen = np.matmul(cast.art_from_canvas, corners)
    w = seen[:, 2]
    safe = np.where(w > 0, w, 1.0)[:, np.newaxis]
    return seen[:, :2] / safe - _corner_of(box), w


def _stretch(cast: Cast, art: Matrix, w: Matrix) -> Matrix:
    """Return how many texels one canvas px covers at most in each tile, (2, N): along x and along y."""
    safe = np.where(w > 0, w, 1.0)
    x_row, y_row, w_row = cast.art_from_canvas
    squares = [
        ((x_row[k] - art[:, 0] * w_row[k]) ** 2 + (y_row[k] - art[:, 1] * w_row[k]) ** 2) / (safe * safe)
        for k in (0, 1)
    ]
    return np.sqrt([each.max(axis=0) for each in squares])


def edge_codes(cells: Matrix, at_limit: Flags, most: int) -> Codes:
    """Return a number for each tile's kind of edge, from FIRST_EDGE on; :func:`kind_of` is its inverse."""
    steps = np.searchsorted(CELLS, np.minimum(cells, most))
    squeezed = (cells > most).any(axis=0)
    return np.asarray(FIRST_EDGE + ((steps[0] * len(CELLS) + steps[1]) * 2 + at_limit) * 2 + squeezed)


def kind_of(code: int) -> EdgeKind:
    """Return the kind of edge that a tile's number stands for."""
    rest, squeezed = divmod(code - FIRST_EDGE, 2)
    rest, at_limit = divmod(rest, 2)
    across, down = divmod(rest, len(CELLS))
    return EdgeKind(CELLS[across], CELLS[down], bool(at_limit), bool(squeezed))


def runs_of(codes: Codes, origin: tuple[int, int], canvas: Box) -> tuple[Boxes, Codes]:
    """Return the boxes of neighbouring tiles in a row that have one code, cut to the canvas, and their codes."""
    framed = np.full((codes.shape[0], codes.shape[1] + 2), UNTOUCHED)
    framed[:, 1:-1] = codes
    row, start = np.nonzero(framed[:, 1:] != framed[:, :-1])
    # Each change begins a run that ends at the next; the one that begins a row's empty end is dropped as untouched.
    kinds = framed[row, start + 1]
    stop = np.roll(start, -1)
    touched = kinds != UNTOUCHED
    row, start, stop = row[touched], start[touched], stop[touched]
    tiles = np.stack([start + origin[0], row + origin[1], stop + origin[0], row + origin[1] + 1], axis=1) * TILE_PX
    low, high = [canvas.left, canvas.top] * 2, [canvas.right, canvas.bottom] * 2
    return np.clip(tiles, low, high).astype(np.float64), kinds[touched]


def whole_grid(box: Box) -> TileGrid:
    """Return the tiles of a box as if a shadow held all of each."""
    columns = np.arange(box.left // TILE_PX, -(-box.right // TILE_PX))
    rows = np.arange(box.top // TILE_PX, -(-box.bottom // TILE_PX))
    return TileGrid(np.full((len(rows), len(columns)), FULL), columns, rows)


def around_boxes(boxes: Boxes) -> Box | None:
    """Return the box around boxes, None around none."""
    if len(boxes) == 0:
        return None
    left, top = boxes[:, :2].min(axis=0)
    right, bottom = boxes[:, 2:].max(axis=0)
    return Box(int(left), int(top), int(right), int(bottom))
