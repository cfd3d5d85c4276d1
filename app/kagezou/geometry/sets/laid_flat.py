"""A set laid flat: faces turned about the seams at which they meet, until all lie in the ground's plane.

On the ground and on the faces together a shadow is one figure on folded paper. Unfolded, it can be blurred as on flat
ground: round on every face, wider with the distance along the receivers, and the same on both sides of a seam.

Paper with cycles, like the corner of a box, does not unfold without a cut, and what is laid flat covers ground that is
seen behind it. So faces that would cover each other lie on charts of their own, and where two receivers that meet are
not neighbours on one chart they are joined: near the seam they pass over into a value that both have at it.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from kagezou.geometry.ground import Plane
from kagezou.geometry.polygon import clipped
from kagezou.geometry.vectors import Matrix

GROUND = -1
"""Stands for the ground where a sheet is counted."""

TOUCHING_PX = 1e-3
"""What is no farther from a face than this lies on it."""

_COVERING_PX2 = 1.0
"""Sheets that share less than this do not cover each other."""


@dataclass(frozen=True, slots=True, eq=False)
class FlatFace:
    """A flat convex receiver in space.

    Parameters
    ----------
    body
        Whose it is.
    plane
        Its plane, the normal toward the light.
    corners
        (N, 3) in order around it, world px.
    """

    body: int
    plane: Plane
    corners: Matrix

    def local(self, points: Matrix) -> Matrix:
        """Return the (u, v) of world points (N, 3) on the plane."""
        return np.asarray((points - np.array(self.plane.origin)) @ np.array([self.plane.u, self.plane.v]).T)

    def holds(self, points: Matrix) -> bool:
        """Whether world points (N, 3) lie on the face, its rim included."""
        heights = points @ np.array(self.plane.normal) + self.plane.equation[3]
        if float(np.abs(heights).max()) > TOUCHING_PX:
            return False
        lines = lines_of(self.local(self.corners))
        return bool((self.local(points) @ lines[:, :2].T + lines[:, 2]).min() > -TOUCHING_PX)


@dataclass(frozen=True, slots=True, eq=False)
class FlatSheet:
    """A face laid flat.

    Parameters
    ----------
    face
        Which it is.
    flat_from_plane
        (3, 3): from (u, v) of its plane to (u, v) of the ground along the contact line; keeps lengths.
    parent
        The sheet it is hinged to, or GROUND.
    seam
        (2, 2): the ends of the hinge, flat.
    chart
        On which chart it is looked up; the ground's own is 0.
    is_guest
        Whether it is looked up elsewhere, and lies here for the sake of its neighbour, under all others.
    """

    face: FlatFace
    flat_from_plane: Matrix
    parent: int
    seam: Matrix
    chart: int = 0
    is_guest: bool = False

    @property
    def is_looked_up(self) -> bool:
        """Whether its face is shown from here."""
        return self.chart > 0 and not self.is_guest

    @property
    def corners(self) -> Matrix:
        """Its corners (N, 2), flat."""
        return moved(self.flat_from_plane, self.face.local(self.face.corners))


@dataclass(frozen=True, slots=True, eq=False)
class Join:
    """A seam at which a receiver passes over into what another chart has.

    Parameters
    ----------
    sheet
        The receiver, or GROUND.
    seam
        (2, 2): the ends, flat on the receiver's chart; the receiver lies to their left (u to the right, v upward).
    chart
        The other chart.
    there_from_here
        (3, 3): from flat places of the receiver to those of the other chart.
    most
        How much of the value is the other chart's at the seam.
    guest
        The receiver as it is to be laid on the other chart, where it is not there yet.
    """

    sheet: int
    seam: Matrix
    chart: int
    there_from_here: Matrix
    most: float
    guest: FlatSheet | None = None


@dataclass(frozen=True, slots=True, eq=False)
class FlatOutline:
    """A convex polygon (N, 2) of a chart in which a sheet's plane is seen, but for what later ones lie over."""

    sheet: int
    corners: Matrix


@dataclass(frozen=True, slots=True, eq=False)
class Development:
    """Faces laid flat.

    Parameters
    ----------
    sheets
        Parents before their children.
    charts
        The sheets that lie on each chart, the first of which, the ground's own, has none.
    joins
        Where receivers that meet are looked up on different charts.
    crowded
        The charts whose sheets lie closer together than they should.
    """

    sheets: tuple[FlatSheet, ...]
    charts: tuple[tuple[int, ...], ...]
    joins: tuple[Join, ...]
    crowded: frozenset[int] = frozenset()

    @lru_cache(maxsize=128)  # noqa: B019 -- a development is kept as long as its set stays
    def outlines(self, chart: int, beyond_px: float) -> tuple["FlatOutline", ...]:
        """Return what of the sheets of a chart is to be seen, flat; later ones lie over those before.

        Beyond edges without a hinge a face's plane goes on for a while, so that the set's own edges blur no shadow; but
        not over other faces, nor where there is no room for it, nor farther than half of what there is of the face.
        """
        beyond_px = 0.0 if chart in self.crowded else beyond_px
        laid = self._upward(chart)
        own = {each: self.sheets[each].corners for each in laid}
        wide = {
            each: widened(own[each], self._hinges(each, laid), min(beyond_px, narrowest(own[each]) / 2))
            for each in laid
        }
        return tuple(FlatOutline(each, corners[each]) for corners in (wide, own) for each in laid)

    def _upward(self, chart: int) -> list[int]:
        """Return the sheets of a chart, each before those that lie over it: what stands on it, and all over guests."""
        guests = [each for each in self.charts[chart] if self.sheets[each].is_guest]
        return sorted(guests, reverse=True) + sorted(set(self.charts[chart]) - set(guests))

    def _hinges(self, number: int, laid: Sequence[int]) -> list[Matrix]:
        """Return the hinges of a sheet with what lies on the same chart."""
        return [self.sheets[number].seam, *(self.sheets[e].seam for e in laid if self.sheets[e].parent == number)]

    def joins_of(self, sheet: int) -> tuple[Join, ...]:
        """Return the joins of a receiver."""
        return tuple(join for join in self.joins if join.sheet == sheet)


FLAT = Development((), ((),), ())
"""The ground alone."""


def moved(matrix: Matrix, points: Matrix) -> Matrix:
    """Return points (N, 2) under an affine (3, 3) map."""
    return np.asarray(points @ matrix[:2, :2].T + matrix[:2, 2])


def lines_of(corners: Matrix) -> Matrix:
    """Return the sides of a convex polygon (N, 2) as distance forms (N, 3), >= 0 inside."""
    run = np.roll(corners, -1, axis=0) - corners
    normals = np.column_stack([-run[:, 1], run[:, 0]]) / np.maximum(np.linalg.norm(run, axis=1), 1e-12)[:, np.newaxis]
    lines = np.column_stack([normals, -(normals * corners).sum(axis=1)])
    middle = np.append(corners.mean(axis=0), 1.0)
    return np.asarray(lines * np.where(lines @ middle >= 0, 1.0, -1.0)[:, np.newaxis])


def narrowest(corners: Matrix) -> float:
    """Return the width of a convex polygon (N, 2) across its narrowest way."""
    lines = lines_of(corners)
    return float((corners @ lines[:, :2].T + lines[:, 2]).max(axis=0).min())


def covers(first: Matrix, second: Matrix) -> bool:
    """Whether two convex polygons (N, 2) share more than a rim."""
    return _common_area(first, second) > _COVERING_PX2


def widened(corners: Matrix, hinges: Sequence[Matrix], by_px: float) -> Matrix:
    """Return a convex polygon (N, 2) whose sides, but for those that lie on hinges, are moved outward."""
    lines = lines_of(corners)
    for line in lines:
        on_hinge = any(float(np.abs(hinge @ line[:2] + line[2]).max()) < TOUCHING_PX for hinge in hinges)
        line[2] += 0.0 if on_hinge else by_px
    low, high = corners.min(axis=0) - 2 * by_px, corners.max(axis=0) + 2 * by_px
    polygon = np.array([low, [high[0], low[1]], high, [low[0], high[1]]])
    for line in lines:
        polygon = clipped(polygon, line)
    return polygon


def _common_area(first: Matrix, second: Matrix) -> float:
    polygon = first
    for line in lines_of(second):
        polygon = clipped(polygon, line)
    if len(polygon) == 0:
        return 0.0
    x, y = polygon.T
    return abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1))) / 2
