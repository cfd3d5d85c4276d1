"""Which tiles of a receiver are wholly seen and lit, which hold an edge of that, and which show nothing."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.geometry.regions import Group, Region
from kagezou.geometry.vectors import Matrix
from kagezou.render.tiles import TILE_PX, Boxes, runs_of, tile_corners

Flags = NDArray[np.bool_]

_NOTHING, _WHOLE, _EDGE = 0, 1, 2

_HALF_DIAGONAL_PX = (TILE_PX / 2 + 1) * 2**0.5


@dataclass(frozen=True, slots=True, eq=False)
class Mask:
    """What decides how much of a receiver is seen, and how much of that is lit.

    Parameters
    ----------
    outline
        Where it would be seen alone; None for everywhere.
    hidden, unlit
        What bodies take of it, from the camera and from the light.
    """

    outline: Region | None
    hidden: tuple[Group, ...]
    unlit: tuple[Group, ...]


@dataclass(frozen=True, slots=True, eq=False)
class MaskTiling:
    """The tiles of a mask.

    Parameters
    ----------
    whole
        Boxes in which the whole receiver counts.
    edge
        Boxes in which parts of pixels do.
    mask
        The mask with nothing but the regions whose rims those boxes may hold.
    """

    whole: Boxes
    edge: Boxes
    mask: Mask

    @property
    def box(self) -> Box | None:
        """The box around all tiles."""
        both = np.concatenate([self.whole, self.edge])
        if len(both) == 0:
            return None
        left, top = both[:, :2].min(axis=0)
        right, bottom = both[:, 2:].max(axis=0)
        return Box(int(left), int(top), int(right), int(bottom))


@dataclass(frozen=True, slots=True, eq=False)
class _States:
    """For each tile whether something holds all of it, and whether it holds any."""

    full: Flags
    some: Flags

    @property
    def rim(self) -> Flags:
        return self.some & ~self.full


def mask_tiles(mask: Mask, area: Box, canvas: Box, *, own_shadow: bool) -> MaskTiling:
    """Sort the tiles of a part of the canvas.

    Parameters
    ----------
    mask, area
        Of what, and where.
    canvas
        Boxes are cut to it.
    own_shadow
        Whether what is taken from the light is asked for, else what is lit.
    """
    columns = np.arange(area.left // TILE_PX, -(-area.right // TILE_PX))
    rows = np.arange(area.top // TILE_PX, -(-area.bottom // TILE_PX))
    corners = tile_corners(columns, rows)
    count = corners.shape[2]
    outline = _States(np.ones(count, bool), np.ones(count, bool))
    if mask.outline is not None:
        outline = region_states(mask.outline, corners)
    hidden = [_group_states(group, corners) for group in mask.hidden]
    unlit = [_group_states(group, corners) for group in mask.unlit]
    seen, seen_whole = _left_over(outline, hidden)
    if own_shadow:
        taken = _any([each.full for each, _ in unlit], count)
        possible, whole = seen & _any([each.some for each, _ in unlit], count), seen_whole & taken
    else:
        lit, lit_whole = _left_over(_States(np.ones(count, bool), np.ones(count, bool)), unlit)
        possible, whole = seen & lit, seen_whole & lit_whole
    codes = np.where(whole, _WHOLE, np.where(possible, _EDGE, _NOTHING))
    grid = codes.reshape(len(rows), len(columns))
    boxes, kinds = runs_of(grid, (int(columns[0]), int(rows[0])), canvas)
    edge = codes == _EDGE
    needed = Mask(
        mask.outline if mask.outline is not None and bool((outline.rim & edge).any()) else None,
        _needed(mask.hidden, hidden, edge),
        _needed(mask.unlit, unlit, edge),
    )
    return MaskTiling(boxes[kinds == _WHOLE], boxes[kinds == _EDGE], needed)


def region_states(region: Region, corners: Matrix) -> _States:
    """Return what a region holds of tiles, given by their corners (4, 3, N)."""
    full, some = np.ones(corners.shape[2], bool), np.ones(corners.shape[2], bool)
    if len(region.lines):
        distances = np.matmul(region.lines, corners)
        full &= (distances.min(axis=0) >= 0).all(axis=0)
        some &= (distances.max(axis=0) > 0).all(axis=0)
    if region.conic is not None:
        middle = corners.mean(axis=0)
        slopes = 2 * (region.conic @ middle)
        values = np.einsum("in,in->n", middle, slopes) / 2
        # How far the form can be from its value in the middle of a tile: by its slope there, and by its curvature.
        bend = float(np.abs(np.linalg.eigvalsh(region.conic[:2, :2])).max())
        reach = np.hypot(slopes[0], slopes[1]) * _HALF_DIAGONAL_PX + bend * _HALF_DIAGONAL_PX**2
        full &= values >= reach
        some &= values > -reach
    return _States(full, some)


def _group_states(group: Group, corners: Matrix) -> tuple[_States, list[_States]]:
    each = [region_states(region, corners) for region in group.regions]
    count = corners.shape[2]
    return _States(_any([state.full for state in each], count), _any([state.some for state in each], count)), each


def _any(flags: Sequence[Flags], count: int) -> Flags:
    return np.logical_or.reduce(flags) if flags else np.zeros(count, bool)


def _left_over(start: _States, taken: Sequence[tuple[_States, list[_States]]]) -> tuple[Flags, Flags]:
    """Return which tiles may be left when groups take their parts, and which are left whole."""
    some, full = start.some, start.full
    for group, _ in taken:
        some = some & ~group.full
        full = full & ~group.some
    return some, full


def _needed(groups: Sequence[Group], states: Sequence[tuple[_States, list[_States]]], edge: Flags) -> tuple[Group, ...]:
    """Return the groups with the regions that hold a part of an edge tile."""
    kept: list[Group] = []
    for group, (_, each) in zip(groups, states, strict=True):
        regions = [region for region, state in zip(group.regions, each, strict=True) if bool((state.some & edge).any())]
        if regions:
            kept.append(Group(tuple(regions), group.overlaps))
    return tuple(kept)
