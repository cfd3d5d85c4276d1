"""Veils as they lie on one flat receiver, in canvas px: convex regions bounded by lines and a conic."""

from dataclasses import dataclass, replace
from typing import TypeAlias

import numpy as np

from kagezou.geometry.pieces import Ball, Body, Solid
from kagezou.geometry.polygon import distance_form, shifted
from kagezou.geometry.vectors import Matrix, Vector4, dot, height_over
from kagezou.geometry.veils import Cone, Veil

TOUCHING_PX = 1e-4
"""What is no farther from a receiver than this lies on it."""

_ASIDE_PX = 4.0


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
    """

    lift: Matrix
    equation: Vector4

    def group(self, body: Body, veil: Veil, *, keeps_footprint: bool) -> Taken | None:
        """Return what a veil takes from the receiver, and the seams at which its body stands there.

        Parameters
        ----------
        body, veil
            The body must not be the one whose face the receiver is.
        keeps_footprint
            Whether a round end that lies on the receiver counts: for what is seen, not for what is lit, as no one
            sees under it.

        None where it takes nothing.
        """
        low, high = heights_over(self.equation, body)
        if high <= TOUCHING_PX:
            return None
        regions: list[Region] = []
        seams: list[Seam] = []
        for cone in veil.cones:
            self._take(cone, regions, seams, keeps_footprint=keeps_footprint)
        if veil.inside is not None and low < -TOUCHING_PX:
            regions.append(self._region(veil.inside.planes, veil.inside.quadric))
        return (Group(tuple(regions), veil.overlaps), tuple(seams)) if regions else None

    def outline(self, cone: Cone) -> Region:
        """Return where the receiver itself is seen, given the camera's cone over it."""
        return self._region(cone.planes[:-1], cone.quadric)

    def _take(self, cone: Cone, regions: list[Region], seams: list[Seam], *, keeps_footprint: bool) -> None:
        own_plane = cone.planes[-1]
        if self._is_in_plane(own_plane):
            if cone.edges is None and keeps_footprint:
                regions.append(self._region(cone.planes[:-1], cone.quadric))
            return
        touching = [] if cone.edges is None else np.nonzero(self._touches(cone.edges))[0].tolist()
        # Where an edge lies on the receiver, the line in which the thing's plane meets it is that edge.
        region = self._region(cone.planes[:-1] if touching else cone.planes, cone.quadric)
        regions.append(region)
        if cone.edges is not None:
            seams += [Seam(cone.edges[index], len(regions) - 1, index) for index in touching]

    def _region(self, planes: Matrix, quadric: Matrix | None) -> Region:
        forms = planes @ self.lift
        lines = np.array([distance_form(form) for form in forms]).reshape(-1, 3)
        if quadric is None:
            return Region(lines)
        conic = self.lift.T @ quadric @ self.lift
        return Region(lines, conic / np.abs(conic).max())

    def _is_in_plane(self, plane: Matrix) -> bool:
        normal = np.array(self.equation[:3])
        across = np.cross(normal, plane[:3])
        gap = self.equation[3] - float(plane[3]) * float(np.sign(plane[:3] @ normal))
        return float(np.abs(across).max()) < 1e-9 and abs(gap) < TOUCHING_PX

    def _touches(self, edges: Matrix) -> Matrix:
        heights = edges @ np.array(self.equation[:3]) + self.equation[3]
        return np.asarray((np.abs(heights) < TOUCHING_PX).all(axis=1))


def heights_over(plane: Vector4, body: Body) -> tuple[float, float]:
    """Return between which heights over a plane of unit normal a body lies, px."""
    normal = (plane[0], plane[1], plane[2])
    if isinstance(body, Solid):
        heights = [height_over(plane, (*corner, 1.0)) for facet in body.facets for corner in facet.corners]
        return min(heights), max(heights)
    if isinstance(body, Ball):
        centre = height_over(plane, (*body.centre, 1.0))
        return centre - body.radius_px, centre + body.radius_px
    wide = body.radius_px * max(1.0 - dot(normal, body.axis) ** 2, 0.0) ** 0.5
    ends = [height_over(plane, (*end, 1.0)) for end in (body.foot, body.head)]
    return min(ends) - wide, max(ends) + wide


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


def _same_ends(first: Matrix, second: Matrix) -> bool:
    return any(float(np.abs(first - other).max()) < TOUCHING_PX for other in (second, second[::-1]))
