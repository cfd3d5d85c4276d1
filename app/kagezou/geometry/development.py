"""A set laid flat: faces turned about the seams at which they meet, until all lie in the ground's plane.

On the ground and on the faces together a shadow is one figure on folded paper. Unfolded, it can be blurred as on flat
ground: round on every face, wider with the distance along the receivers, and the same on both sides of a seam.

Paper with cycles, like the corner of a box, does not unfold without a cut, and what is laid flat covers ground that is
seen behind it. So faces that would cover each other lie on charts of their own, and where two receivers that meet are
not neighbours on one chart they are joined: near the seam they pass over into a value that both have at it.
"""

import heapq
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from kagezou.geometry.ground import Plane
from kagezou.geometry.polygon import clipped
from kagezou.geometry.vectors import Matrix

GROUND = -1
"""Stands for the ground where a sheet is counted."""

_TOUCHING_PX = 1e-3
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
        if float(np.abs(heights).max()) > _TOUCHING_PX:
            return False
        lines = lines_of(self.local(self.corners))
        return bool((self.local(points) @ lines[:, :2].T + lines[:, 2]).min() > -_TOUCHING_PX)


@dataclass(frozen=True, slots=True, eq=False)
class Sheet:
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
    guest: Sheet | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Outline:
    """A part of a chart: the polygon (N, 2) in which a sheet's plane is seen, and those that lie over it."""

    sheet: int
    corners: Matrix
    over: list[Matrix]


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

    sheets: tuple[Sheet, ...]
    charts: tuple[tuple[int, ...], ...]
    joins: tuple[Join, ...]
    crowded: frozenset[int] = frozenset()

    def outlines(self, chart: int, beyond_px: float) -> list["Outline"]:
        """Return what of the sheets of a chart is to be seen, flat.

        Beyond edges without a hinge a face's plane goes on for a while, so that the set's own edges blur no shadow; but
        not over other faces, nor where there is no room for it.
        """
        beyond_px = 0.0 if chart in self.crowded else beyond_px
        laid = self.charts[chart]
        own = {each: self.sheets[each].corners for each in laid}
        wide = {each: _widened(own[each], self._hinges(each, laid), beyond_px) for each in laid}
        found: list[Outline] = []
        for each in laid:
            upper = [other for other in laid if self._is_over(other, each)]
            standing = [own[other] for other in upper if _covers(own[other], own[each])]
            beside = [own[other] for other in laid if _covers(own[other], wide[each])]
            beside += [wide[other] for other in upper if _covers(wide[other], wide[each])]
            found += [Outline(each, own[each], standing), Outline(each, wide[each], beside)]
        return found

    def _is_over(self, number: int, other: int) -> bool:
        """Whether one sheet of a chart lies over another: what stands on it does, and all do over guests."""
        guests = self.sheets[number].is_guest, self.sheets[other].is_guest
        if guests[0] != guests[1]:
            return guests[1]
        return number < other if guests[0] else number > other

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


def unfolded(contact: Plane, faces: Sequence[FlatFace], most_charts: int, apart_px: float) -> Development:
    """Lay faces flat, from the ground outward, those nearest to the contact line first.

    Parameters
    ----------
    contact
        The ground, its u axis along the contact line.
    faces
        Those that are lit; faces that meet neither the ground nor another one that does are left out.
    most_charts
        With the ground's own; faces that have no place on them are left out.
    apart_px
        How far apart faces that do not hang together lie on one chart, as long as there is room on others.
    """
    sheets: list[Sheet] = []
    seams = [(ends, GROUND, index) for index, face in enumerate(faces) for ends in _on_ground(contact, face)]
    waiting: list[tuple[bool, float, int, Matrix, int, int]] = []
    number_of: dict[int, int] = {}

    def offer(found: Sequence[tuple[Matrix, int, int]]) -> None:
        for ends, parent, child in found:
            if child not in number_of:
                flat = _flat_ends(contact, sheets, parent, ends)
                folds = parent == GROUND or not _is_coplanar(sheets[parent].face, faces[child])
                away = float(np.abs(flat[:, 1].mean()))
                heapq.heappush(waiting, (folds, away, len(waiting) + 1000 * len(sheets), ends, parent, child))

    offer(seams)
    while waiting:
        *_, ends, parent, child = heapq.heappop(waiting)
        if child in number_of:
            continue
        flat = _flat_ends(contact, sheets, parent, ends)
        number_of[child] = len(sheets)
        sheets.append(Sheet(faces[child], _hinge(faces[child].local(ends), flat), parent, flat))
        own = faces[child]
        offer([(at, number_of[child], index) for index, each in enumerate(faces) for at in _seams(own, each)])
    return _charted(sheets, most_charts, apart_px)


def _is_coplanar(first: FlatFace, second: FlatFace) -> bool:
    return float(np.dot(first.plane.normal, second.plane.normal)) > 1 - 1e-9


def _on_ground(contact: Plane, face: FlatFace) -> list[Matrix]:
    """Return the edges (2, 3) of a face that lie on the ground."""
    heights = np.abs(face.corners @ np.array(contact.normal) + contact.equation[3])
    touches = heights < _TOUCHING_PX
    following = np.roll(np.arange(len(touches)), -1)
    return [face.corners[[i, j]] for i, j in enumerate(following) if touches[i] and touches[j]]


@lru_cache(maxsize=4096)
def _seams(first: FlatFace, second: FlatFace) -> list[Matrix]:
    """Return the edges (2, 3) of the second face that lie on the first, or of the first on the second."""
    if first is second:
        return []
    for own, other in ((first, second), (second, first)):
        for i in range(len(other.corners)):
            ends = other.corners[[i, (i + 1) % len(other.corners)]]
            if own.holds(ends):
                return [ends]
    return []


def _flat_ends(contact: Plane, sheets: Sequence[Sheet], parent: int, ends: Matrix) -> Matrix:
    if parent == GROUND:
        return np.asarray((ends - np.array(contact.origin)) @ np.array([contact.u, contact.v]).T)
    sheet = sheets[parent]
    return moved(sheet.flat_from_plane, sheet.face.local(ends))


def _hinge(own: Matrix, flat: Matrix) -> Matrix:
    """Return the turn and shift (3, 3) that takes two points (2, 2) to two others as far apart."""
    before, after = own[1] - own[0], flat[1] - flat[0]
    angle = np.arctan2(after[1], after[0]) - np.arctan2(before[1], before[0])
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    result = np.eye(3)
    result[:2, :2] = turn
    result[:2, 2] = flat.mean(axis=0) - turn @ own.mean(axis=0)
    return result


def _charted(sheets: Sequence[Sheet], most_charts: int, apart_px: float) -> Development:
    """Give every sheet a chart on which it neither lies over others nor is felt by them, while there is room."""
    charts: list[list[int]] = [[]]
    crowded: set[int] = set()
    placed: list[Sheet] = []
    for number, sheet in enumerate(sheets):
        line = _line(sheets, sheet.parent)
        home = placed[sheet.parent].chart if sheet.parent != GROUND else 0
        order = sorted(range(1, len(charts)), key=lambda index: index != home)
        mine = [sheet.corners, *(placed[each].corners for each in line)]
        chart = _free_chart(order, charts, line, placed, mine, apart_px)
        if chart == 0 and len(charts) < most_charts:
            chart = len(charts)
            charts.append([])
        if chart == 0:
            chart = _free_chart(order, charts, line, placed, mine, 0.0)
            crowded.add(chart)
        if chart:
            charts[chart] = sorted({*charts[chart], *line, number})
        placed.append(Sheet(sheet.face, sheet.flat_from_plane, sheet.parent, sheet.seam, chart))
    joins = tuple(_joins(placed))
    for join in joins:
        if join.guest is not None and join.chart not in crowded:
            charts[join.chart].append(len(placed))
            placed.append(join.guest)
    return Development(tuple(placed), tuple(tuple(each) for each in charts), joins, frozenset(crowded))


def _line(sheets: Sequence[Sheet], number: int) -> list[int]:
    """Return a sheet and what it hangs on."""
    found: list[int] = []
    while number != GROUND:
        found.append(number)
        number = sheets[number].parent
    return found


def _free_chart(
    order: Sequence[int],
    charts: Sequence[Sequence[int]],
    line: Sequence[int],
    placed: Sequence[Sheet],
    mine: Sequence[Matrix],
    apart_px: float,
) -> int:
    """Return the first chart with nothing but the line of a sheet nearer to it than ``apart_px``; 0 for none."""
    grown = [_widened(corners, (), apart_px) for corners in mine]
    for chart in order:
        others = [placed[each].corners for each in charts[chart] if each not in line]
        if not any(_covers(other, one) for other in others for one in grown):
            return chart
    return 0


def _covers(first: Matrix, second: Matrix) -> bool:
    return _common_area(first, second) > _COVERING_PX2


def _widened(corners: Matrix, hinges: Sequence[Matrix], by_px: float) -> Matrix:
    """Return a convex polygon (N, 2) whose sides, but for those that lie on hinges, are moved outward."""
    lines = lines_of(corners)
    for line in lines:
        on_hinge = any(float(np.abs(hinge @ line[:2] + line[2]).max()) < _TOUCHING_PX for hinge in hinges)
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


def _joins(sheets: Sequence[Sheet]) -> list[Join]:
    joins: list[Join] = []
    for number, sheet in enumerate(sheets):
        above = 0 if sheet.parent == GROUND else sheets[sheet.parent].chart
        if sheet.chart and above != sheet.chart:
            seam = _beside(sheet.seam, sheet.corners.mean(axis=0), is_left=False)
            joins.append(Join(sheet.parent, seam, sheet.chart, np.eye(3), 1.0))
        for other_number in range(number):
            other = sheets[other_number]
            is_hinge = number == other.parent or other_number == sheet.parent
            if is_hinge or not sheet.chart or not other.chart:
                continue
            for ends in _seams(sheet.face, other.face):
                joins += [_cut(sheets, number, other_number, ends), _cut(sheets, other_number, number, ends)]
    return joins


def _cut(sheets: Sequence[Sheet], number: int, neighbour: int, ends: Matrix) -> Join:
    """Return the join of a sheet at an edge where the flat paper is cut."""
    own, other = sheets[number], sheets[neighbour]
    here = moved(own.flat_from_plane, own.face.local(ends))
    there = moved(other.flat_from_plane, other.face.local(ends))
    seam = _beside(here, own.corners.mean(axis=0), is_left=True)
    hinge = _hinge(here, there)
    guest = Sheet(own.face, hinge @ own.flat_from_plane, neighbour, there, other.chart, is_guest=True)
    return Join(number, seam, other.chart, hinge, 0.5, guest)


def _beside(seam: Matrix, point: Matrix, *, is_left: bool) -> Matrix:
    """Return the ends of a seam in the order in which a point lies to their left, or right."""
    run, away = seam[1] - seam[0], point - seam[0]
    left = float(run[0] * away[1] - run[1] * away[0]) > 0
    return seam if left == is_left else seam[::-1]
