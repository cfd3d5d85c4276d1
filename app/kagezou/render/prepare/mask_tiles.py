"""Which tiles of a receiver are wholly seen and lit, which hold an edge of that, and which show nothing."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.sets.regions import Group, Region
from kagezou.geometry.vectors import Matrix
from kagezou.render.prepare.shadow_tiles import TILE_PX

Flags = NDArray[np.bool_]

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

    @property
    def groups(self) -> tuple[Group, ...]:
        """All of them, the outline first."""
        return (*(() if self.outline is None else (self.outline,)), *self.hidden, *self.unlit)


@dataclass(frozen=True, slots=True, eq=False)
class States:
    """For tiles (…, N) whether something holds all of each, and whether it holds any of it."""

    full: Flags
    some: Flags


@dataclass(frozen=True, slots=True, eq=False)
class MaskStates:
    """What a mask leaves of tiles.

    Parameters
    ----------
    mask
        The mask without what is far from all of the tiles.
    whole, edge
        (N,): of which tiles the whole receiver counts, and of which parts of pixels do.
    regions
        What each region of the mask, in the order of its groups, holds of the tiles.
    """

    mask: Mask
    whole: Flags
    edge: Flags
    regions: States

    def needed(self, tiles: Flags) -> Mask:
        """Return the mask with nothing but the regions that hold a part of some of its tiles (N,)."""
        held = np.logical_and(self.regions.some, tiles)
        some: list[bool] = held.max(axis=1, initial=False).tolist()
        outline = self.mask.outline
        first = 0 if outline is None else len(outline.regions)
        if outline is not None:
            is_within = np.logical_or.reduce(self.regions.full[:first, tiles])
            outline = None if bool(np.all(is_within)) else outline
        second = first + sum(len(group.regions) for group in self.mask.hidden)
        return Mask(outline, _chosen(self.mask.hidden, some[first:second]), _chosen(self.mask.unlit, some[second:]))


def mask_states(mask: Mask, corners: Matrix, *, own_shadow: bool) -> MaskStates:
    """Sort tiles, given by their corners (4, 3, N), N > 0, by what a mask leaves of them.

    Parameters
    ----------
    mask, corners
        Of what, and where.
    own_shadow
        Whether what is taken from the light is asked for, else what is lit.
    """
    mask = _near(mask, corners)
    regions = [region for group in mask.groups for region in group.regions]
    states = region_states(regions, corners)
    every, none = np.ones(corners.shape[2], bool), np.zeros(corners.shape[2], bool)
    at = 0
    merged: list[States] = []
    for group in mask.groups:
        rows = slice(at, at := at + len(group.regions))
        merged.append(States(np.logical_or.reduce(states.full[rows]), np.logical_or.reduce(states.some[rows])))
    outline = States(every, every) if mask.outline is None else merged.pop(0)
    seen = _left_over(outline, merged[: len(mask.hidden)])
    unlit = merged[len(mask.hidden) :]
    if own_shadow:
        asked = States(
            np.logical_or.reduce([none, *(group.full for group in unlit)]),
            np.logical_or.reduce([none, *(group.some for group in unlit)]),
        )
    else:
        asked = _left_over(States(every, every), unlit)
    whole = seen.full & asked.full
    return MaskStates(mask, whole, seen.some & asked.some & ~whole, states)


def region_states(regions: Sequence[Region], corners: Matrix) -> States:
    """Return what regions hold of tiles, given by their corners (4, 3, N): flags (regions, N)."""
    full, some = np.ones((len(regions), corners.shape[2]), bool), np.ones((len(regions), corners.shape[2]), bool)
    lined = [index for index, region in enumerate(regions) if len(region.lines)]
    if lined:
        starts = np.cumsum([0, *(len(regions[index].lines) for index in lined[:-1])])
        lines = np.concatenate([regions[index].lines for index in lined])
        # Tiles are squares of one size: from its middle to its corners a line's distance changes alike in all of them.
        distances = lines @ ((corners[0] + corners[2]) / 2)
        reach = (np.abs(lines[:, :2]) @ (corners[2, :2, :1] - corners[0, :2, :1])) / 2
        full[lined] = np.minimum.reduceat(distances - reach, starts, axis=0) >= 0
        some[lined] = np.minimum.reduceat(distances + reach, starts, axis=0) > 0
    for index, region in enumerate(regions):
        if region.conic is not None:
            low, high = _conic_bounds(region.conic, corners)
            full[index] &= low >= 0
            some[index] &= high > 0
    return States(full, some)


def _conic_bounds(conic: Matrix, corners: Matrix) -> tuple[Matrix, Matrix]:
    """Return between which values a conic stays in tiles: by its slope in the middle, and by its curvature."""
    middle = corners.mean(axis=0)
    slopes = 2 * (conic @ middle)
    values = np.einsum("in,in->n", middle, slopes) / 2
    bend = float(np.abs(np.linalg.eigvalsh(conic[:2, :2])).max())
    reach = np.hypot(slopes[0], slopes[1]) * _HALF_DIAGONAL_PX + bend * _HALF_DIAGONAL_PX**2
    return values - reach, values + reach


def _near(mask: Mask, corners: Matrix) -> Mask:
    """Return a mask without the regions that lie wholly beyond one of their lines from the box around some tiles."""
    left, top = corners[0, :2].min(axis=1)
    right, bottom = corners[2, :2].max(axis=1)
    around = np.array([[left, right, right, left], [top, top, bottom, bottom], [1.0, 1.0, 1.0, 1.0]])
    regions = [region for group in (*mask.hidden, *mask.unlit) for region in group.regions]
    if not regions:
        return mask
    inside = iter((np.concatenate([region.lines for region in regions]) @ around).max(axis=1).tolist())
    kept = [min([next(inside) for _ in region.lines], default=1.0) > 0 for region in regions]
    count = sum(len(group.regions) for group in mask.hidden)
    return Mask(mask.outline, _chosen(mask.hidden, kept[:count]), _chosen(mask.unlit, kept[count:]))


def _chosen(groups: Sequence[Group], kept: Sequence[bool]) -> tuple[Group, ...]:
    """Return groups with some of their regions, given one flag a region."""
    found: list[Group] = []
    at = 0
    for group in groups:
        flags = kept[at : at + len(group.regions)]
        regions = tuple(region for region, keep in zip(group.regions, flags, strict=True) if keep)
        at += len(group.regions)
        if regions:
            found.append(Group(regions, group.overlaps))
    return tuple(found)


def _left_over(start: States, taken: Sequence[States]) -> States:
    """Return what is left of tiles when groups take their parts."""
    some, full = start.some.copy(), start.full.copy()
    for group in taken:
        some &= ~group.full
        full &= ~group.some
    return States(full, some)
