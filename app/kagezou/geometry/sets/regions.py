"""Occlusions as they lie on one flat receiver, in canvas px: convex regions bounded by lines and a conic."""

from dataclasses import dataclass, replace
from typing import TypeAlias

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.polygon import box_polygon, distance_forms, shifted
from kagezou.geometry.sets.occlusion_cones import Cone, Occlusion
from kagezou.geometry.vectors import Matrix, Vector4

TOUCHING_PX = 1e-4
"""What is no farther from a receiver than this lies on it."""

_ASIDE_PX = 0.75
"""Far enough that no half pixel on the one line reaches the other."""

_COINCIDENT_PX = 1e-3


@dataclass(frozen=True, slots=True, eq=False)
class Region:
    """A convex part of the canvas.

    Parameters
    ----------
    lines
        (N, 3) distance forms in canvas px, all >= 0 inside.
    conic
        (3, 3) with pᵀCp >= 0 inside for p = (x, y, 1), or None.
    """

    lines: Matrix
    conic: Matrix | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Group:
    """The parts of the canvas that one body takes from a receiver.

    Parameters
    ----------
    regions
        Their union.
    overlaps
        Whether they overlap; else they meet at edges, and what they cover of a pixel adds up.
    """

    regions: tuple[Region, ...]
    overlaps: bool


@dataclass(frozen=True, slots=True, eq=False)
class Seam:
    """A line on which a body stands on a receiver: its ends (2, 3) in the world, and where a group has it."""

    ends: Matrix
    region: int
    line: int


Taken: TypeAlias = tuple[Group, tuple[Seam, ...]]
"""What a body takes from a receiver, and the seams at which it stands there."""


@dataclass(frozen=True, slots=True, eq=False)
class Flat:
    """A flat receiver as a camera sees it.

    Parameters
    ----------
    lift
        (4, 3): from canvas px to its points, w > 0 where it is seen.
    equation
        Its plane, positive on the side that is seen.
    rim
        (4, N): points of the world within whose hull it lies, homogeneous; None for an endless one.
    """

    lift: Matrix
    equation: Vector4
    rim: Matrix | None = None

    def group(self, span: tuple[float, float], occlusion: Occlusion, *, keeps_footprint: bool) -> Taken | None:
        """Return what a occlusion takes from the receiver, and the seams at which its body stands there.

        Parameters
        ----------
        span, occlusion
            Between which heights over the receiver a body lies, and what it occludes; it must not be the one whose face
            the receiver is.
        keeps_footprint
            Whether a round end that lies on the receiver counts: for what is seen, not for what is lit, as no one
            sees under it.

        None where it takes nothing.
        """
        low, high = span
        if high <= TOUCHING_PX:
            return None
        regions: list[Region] = []
        seams: list[Seam] = []
        for cone in occlusion.cones:
            if self.rim is not None and float((cone.planes @ self.rim).max(axis=1).min()) < -TOUCHING_PX:
                # All of it lies beyond one of the cone's planes.
                continue
            self._take(cone, regions, seams, keeps_footprint=keeps_footprint)
        if occlusion.inside is not None and low < -TOUCHING_PX:
            regions.append(self._region(occlusion.inside.planes, occlusion.inside.quadric))
        return (Group(tuple(regions), occlusion.overlaps), tuple(seams)) if regions else None

    def outline(self, cone: Cone) -> Region:
        """Return where the receiver itself is seen, given the camera's cone over it."""
        return self._region(cone.planes[:-1], cone.quadric)

    def _take(self, cone: Cone, regions: list[Region], seams: list[Seam], *, keeps_footprint: bool) -> None:
        own_plane = cone.planes[-1]
        if self._is_in_plane(own_plane):
            if cone.edges is None and keeps_footprint:
                regions.append(self._region(cone.planes[:-1], cone.quadric))
            return
        touching = [] if cone.edges is None else self._touching(cone.edges)
        # Where an edge lies on the receiver, the line in which the thing's plane meets it is that edge.
        region = self._region(cone.planes[:-1] if touching else cone.planes, cone.quadric)
        regions.append(region)
        if cone.edges is not None:
            seams += [Seam(cone.edges[index], len(regions) - 1, index) for index in touching]

    def _region(self, planes: Matrix, quadric: Matrix | None) -> Region:
        lines = distance_forms(planes @ self.lift)
        if quadric is None:
            return Region(lines)
        conic = self.lift.T @ quadric @ self.lift
        return Region(lines, conic / np.abs(conic).max())

    def _is_in_plane(self, plane: Matrix) -> bool:
        x, y, z, d = plane.tolist()
        nx, ny, nz, nd = self.equation
        cosine = x * nx + y * ny + z * nz
        gap = nd - (d if cosine > 0 else -d)
        return bool(1.0 - abs(cosine) < 1e-12 and abs(gap) < TOUCHING_PX)

    def _touching(self, edges: Matrix) -> list[int]:
        """Return the numbers of the edges that lie on the receiver."""
        heights = np.abs(edges @ np.array(self.equation[:3]) + self.equation[3]).max(axis=1)
        return [index for index, height in enumerate(heights.tolist()) if height < TOUCHING_PX]


def apart(lit: Taken, seen: Taken) -> Group:
    """Return what a body takes of the light, its lines moved out of sight where they are also lines of what is seen.

    Both would cover a part of the same pixels, and two parts of a pixel tell nothing of where in it they lie. What is
    behind the line that the camera sees is hidden anyway, so there the light's line may as well lie farther in.

    Parameters
    ----------
    lit, seen
        What one body takes of one receiver, from the light and from the camera, with its seams.
    """
    group, seams = lit
    lines = [region.lines.copy() for region in group.regions]
    for seam in seams:
        for other in seen[1]:
            if _same_ends(seam.ends, other.ends):
                line = lines[seam.region][seam.line]
                is_alike = float(line[:2] @ seen[0].regions[other.region].lines[other.line][:2]) > 0
                lines[seam.region][seam.line] = shifted(line, -_ASIDE_PX if is_alike else _ASIDE_PX)
    regions = (replace(region, lines=each) for region, each in zip(group.regions, lines, strict=True))
    return replace(group, regions=tuple(regions))


def beyond(group: Group, outline: Region, box: Box) -> Group:
    """Return a group with those of its lines moved outward that are also lines of a receiver's outline.

    Beyond the outline nothing is seen; at it, as in :func:`apart`, two parts of a pixel would tell nothing of where.

    Parameters
    ----------
    group, outline
        What is taken of a receiver, and where that would be seen alone.
    box
        Where on the canvas.
    """
    corners = np.column_stack([box_polygon(box), np.ones(4)]).T
    own = outline.lines @ corners
    return replace(group, regions=tuple(_moved_beyond(region, own, corners) for region in group.regions))


def _moved_beyond(region: Region, own: Matrix, corners: Matrix) -> Region:
    if len(own) == 0 or len(region.lines) == 0:
        return region
    values = region.lines @ corners
    apart_by = [np.abs(values[:, np.newaxis] - sign * own[np.newaxis]).max(axis=2).min(axis=1) for sign in (1, -1)]
    # A line that has the outline's inside on its own is moved out; one that has its outside loses as much.
    shift = np.where(apart_by[0] < _COINCIDENT_PX, _ASIDE_PX, 0.0) - np.where(
        apart_by[1] < _COINCIDENT_PX, _ASIDE_PX, 0.0
    )
    if not shift.any():
        return region
    lines = region.lines.copy()
    lines[:, 2] += shift
    return replace(region, lines=lines)


def _same_ends(first: Matrix, second: Matrix) -> bool:
    return any(float(np.abs(first - other).max()) < TOUCHING_PX for other in (second, second[::-1]))
