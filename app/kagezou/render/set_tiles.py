"""Which tiles of a receiver are wholly seen and lit, which hold an edge of that, and which show nothing."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.geometry.polygon import box_polygon
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

    outline: Group | None
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
    """For tiles (…, N) whether something holds all of each, and whether it holds any of it."""

    full: Flags
    some: Flags


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
    around = np.column_stack([box_polygon(area.grown(2 * TILE_PX)), np.ones(4)]).T
    near = Mask(mask.outline, _touching(mask.hidden, around), _touching(mask.unlit, around))
    outline = _one(mask.outline, corners)
    hidden = [_group_states(group, corners) for group in near.hidden]
    unlit = [_group_states(group, corners) for group in near.unlit]
    seen = _left_over(outline, hidden)
    if own_shadow:
        every = np.zeros(corners.shape[2], bool)
        taken = _States(every.copy(), every.copy())
        for group, _ in unlit:
            np.logical_or(taken.full, group.full, out=taken.full)
            np.logical_or(taken.some, group.some, out=taken.some)
        asked = taken
    else:
        asked = _left_over(_one(None, corners), unlit)
    whole, possible = seen.full & asked.full, seen.some & asked.some
    codes = np.where(whole, _WHOLE, np.where(possible, _EDGE, _NOTHING))
    boxes, kinds = runs_of(codes.reshape(len(rows), len(columns)), (int(columns[0]), int(rows[0])), canvas)
    edge = codes == _EDGE
    is_rim = bool((outline.some & ~outline.full & edge).any())
    needed = Mask(
        near.outline if is_rim else None, _needed(near.hidden, hidden, edge), _needed(near.unlit, unlit, edge)
    )
    return MaskTiling(boxes[kinds == _WHOLE], boxes[kinds == _EDGE], needed)


def region_states(regions: Sequence[Region], corners: Matrix) -> _States:
    """Return what regions hold of tiles, given by their corners (4, 3, N): flags (regions, N)."""
    full, some = np.ones((len(regions), corners.shape[2]), bool), np.ones((len(regions), corners.shape[2]), bool)
    lined = [index for index, region in enumerate(regions) if len(region.lines)]
    if lined:
        starts = np.cumsum([0, *(len(regions[index].lines) for index in lined[:-1])])
        distances = np.matmul(np.concatenate([regions[index].lines for index in lined]), corners)
        full[lined] = np.logical_and.reduceat(distances.min(axis=0) >= 0, starts, axis=0)
        some[lined] = np.logical_and.reduceat(distances.max(axis=0) > 0, starts, axis=0)
    for index, region in enumerate(regions):
        if region.conic is not None:
            low, high = _conic_bounds(region.conic, corners)
            full[index] &= low >= 0
            some[index] &= high > 0
    return _States(full, some)


def _conic_bounds(conic: Matrix, corners: Matrix) -> tuple[Matrix, Matrix]:
    """Return between which values a conic stays in tiles: by its slope in the middle, and by its curvature."""
    middle = corners.mean(axis=0)
    slopes = 2 * (conic @ middle)
    values = np.einsum("in,in->n", middle, slopes) / 2
    bend = float(np.abs(np.linalg.eigvalsh(conic[:2, :2])).max())
    reach = np.hypot(slopes[0], slopes[1]) * _HALF_DIAGONAL_PX + bend * _HALF_DIAGONAL_PX**2
    return values - reach, values + reach


def _touching(groups: Sequence[Group], around: Matrix) -> tuple[Group, ...]:
    """Return the groups without the regions that lie wholly beyond one of their lines, given corners (3, 4)."""
    regions = [region for group in groups for region in group.regions]
    if not regions:
        return ()
    lines = [region.lines for region in regions]
    inside = iter((np.concatenate(lines) @ around).max(axis=1).tolist())
    kept = [min((next(inside) for _ in each), default=1.0) > 0 for each in lines]
    found: list[Group] = []
    at = 0
    for group in groups:
        left = tuple(region for region, keep in zip(group.regions, kept[at:], strict=False) if keep)
        at += len(group.regions)
        if left:
            found.append(Group(left, group.overlaps))
    return tuple(found)


def _one(group: Group | None, corners: Matrix) -> _States:
    if group is None:
        return _States(np.ones(corners.shape[2], bool), np.ones(corners.shape[2], bool))
    return _group_states(group, corners)[0]


def _group_states(group: Group, corners: Matrix) -> tuple[_States, _States]:
    """Return what a group holds of tiles, and what each of its regions does."""
    each = region_states(group.regions, corners)
    return _States(np.logical_or.reduce(each.full), np.logical_or.reduce(each.some)), each


def _left_over(start: _States, taken: Sequence[tuple[_States, _States]]) -> _States:
    """Return what is left of tiles when groups take their parts."""
    some, full = start.some.copy(), start.full.copy()
    for group, _ in taken:
        some &= ~group.full
        full &= ~group.some
    return _States(full, some)


def _needed(groups: Sequence[Group], states: Sequence[tuple[_States, _States]], edge: Flags) -> tuple[Group, ...]:
    """Return the groups with the regions that hold a part of an edge tile."""
    kept: list[Group] = []
    for group, (_, each) in zip(groups, states, strict=True):
        holds = np.logical_and(each.some, edge).max(axis=1).tolist()
        regions = tuple(region for region, is_held in zip(group.regions, holds, strict=True) if is_held)
        if regions:
            kept.append(Group(regions, group.overlaps))
    return tuple(kept)
