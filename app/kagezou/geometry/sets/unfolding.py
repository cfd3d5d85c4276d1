"""Unfolding a set: which face hangs on which, on which chart it lies, and where charts have to be joined."""

import heapq
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TypeAlias

import numpy as np

from kagezou.geometry.ground import Plane
from kagezou.geometry.sets.laid_flat import (
    GROUND,
    TOUCHING_PX,
    Development,
    FlatFace,
    FlatSheet,
    Join,
    covers,
    moved,
    widened,
)
from kagezou.geometry.vectors import Matrix


@dataclass(frozen=True, slots=True, eq=False)
class _Seam:
    """The ends (2, 3) of a seam in space and (2, 2) flat, and the two that meet there."""

    ends: Matrix
    flat: Matrix
    parent: int
    child: int


_Waiting: TypeAlias = tuple[int, bool, float, int, int, _Seam]
"""A seam behind what decides when its turn is: first those that run farthest along the contact line, as shadows pass
over them, then coplanar faces, then those near to that line."""


@lru_cache(maxsize=32)
def unfolded(contact: Plane, faces: tuple[FlatFace, ...], most_charts: int, apart_px: float) -> Development:
    """Lay faces flat, from the ground outward, over the seams that a shadow is likely to pass first.

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
    sheets: list[FlatSheet] = []
    number_of: dict[int, int] = {}
    waiting: list[_Waiting] = []
    found = [(ends, GROUND, index) for index, face in enumerate(faces) for ends in _on_ground(contact, face)]
    while True:
        for ends, parent, child in found:
            if child not in number_of:
                flat = _flat_ends(contact, sheets, parent, ends)
                folds = parent == GROUND or not _is_coplanar(sheets[parent].face, faces[child])
                along = abs(float((ends[1] - ends[0]) @ np.array(contact.u)))
                order = (-round(along), folds, abs(float(flat[:, 1].mean())), len(sheets), len(waiting))
                heapq.heappush(waiting, (*order, _Seam(ends, flat, parent, child)))
        seam = _next(waiting, number_of)
        if seam is None:
            return _charted(sheets, most_charts, apart_px)
        number_of[seam.child] = len(sheets)
        face = faces[seam.child]
        sheets.append(FlatSheet(face, _hinge(face.local(seam.ends), seam.flat), seam.parent, seam.flat))
        number = number_of[seam.child]
        found = [(ends, number, index) for index, each in enumerate(faces) for ends in _seams(face, each)]


def _next(waiting: list[_Waiting], number_of: dict[int, int]) -> _Seam | None:
    """Take the first seam at which something hangs that is not laid yet."""
    while waiting:
        seam = heapq.heappop(waiting)[-1]
        if seam.child not in number_of:
            return seam
    return None


def _is_coplanar(first: FlatFace, second: FlatFace) -> bool:
    return float(np.dot(first.plane.normal, second.plane.normal)) > 1 - 1e-9


def _on_ground(contact: Plane, face: FlatFace) -> list[Matrix]:
    """Return the edges (2, 3) of a face that lie on the ground."""
    heights = np.abs(face.corners @ np.array(contact.normal) + contact.equation[3])
    touches = heights < TOUCHING_PX
    pairs = ((i, (i + 1) % len(touches)) for i in range(len(touches)))
    return [face.corners[[i, j]] for i, j in pairs if touches[i] and touches[j]]


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


def _flat_ends(contact: Plane, sheets: Sequence[FlatSheet], parent: int, ends: Matrix) -> Matrix:
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


def _charted(sheets: Sequence[FlatSheet], most_charts: int, apart_px: float) -> Development:
    """Give every sheet a chart on which it neither lies over others nor is felt by them, while there is room."""
    charts: list[list[int]] = [[]]
    crowded: set[int] = set()
    placed: list[FlatSheet] = []
    for number, sheet in enumerate(sheets):
        line = _line(sheets, sheet.parent)
        home = placed[sheet.parent].chart if sheet.parent != GROUND else 0
        order = range(1, len(charts))
        mine = [sheet.corners, *(placed[each].corners for each in line)]
        # Beside what it hangs on it may be felt by others: a chain of faces is to stay whole.
        chart = _free_chart([home], charts, line, placed, mine, 0.0) if home else 0
        chart = chart or _free_chart(order, charts, line, placed, mine, apart_px)
        if chart == 0 and len(charts) < most_charts:
            chart = len(charts)
            charts.append([])
        if chart == 0:
            chart = _free_chart(order, charts, line, placed, mine, 0.0)
            crowded |= {chart} - {0}
        if chart:
            charts[chart] = sorted({*charts[chart], *line, number})
        placed.append(FlatSheet(sheet.face, sheet.flat_from_plane, sheet.parent, sheet.seam, chart))
    joins = tuple(_joins(placed))
    for join in joins:
        if join.guest is not None and join.chart not in crowded:
            charts[join.chart].append(len(placed))
            placed.append(join.guest)
    return Development(tuple(placed), tuple(tuple(each) for each in charts), joins, frozenset(crowded))


def _line(sheets: Sequence[FlatSheet], number: int) -> list[int]:
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
    placed: Sequence[FlatSheet],
    mine: Sequence[Matrix],
    apart_px: float,
) -> int:
    """Return the first chart with nothing but the line of a sheet nearer to it than ``apart_px``; 0 for none."""
    grown = [widened(corners, (), apart_px) for corners in mine]
    for chart in order:
        others = [placed[each].corners for each in charts[chart] if each not in line]
        if not any(covers(other, one) for other in others for one in grown):
            return chart
    return 0


def _joins(sheets: Sequence[FlatSheet]) -> list[Join]:
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


def _cut(sheets: Sequence[FlatSheet], number: int, neighbour: int, ends: Matrix) -> Join:
    """Return the join of a sheet at an edge where the flat paper is cut."""
    own, other = sheets[number], sheets[neighbour]
    here = moved(own.flat_from_plane, own.face.local(ends))
    there = moved(other.flat_from_plane, other.face.local(ends))
    seam = _beside(here, own.corners.mean(axis=0), is_left=True)
    hinge = _hinge(here, there)
    guest = FlatSheet(own.face, hinge @ own.flat_from_plane, neighbour, there, other.chart, is_guest=True)
    return Join(number, seam, other.chart, hinge, 0.5, guest)


def _beside(seam: Matrix, point: Matrix, *, is_left: bool) -> Matrix:
    """Return the ends of a seam in the order in which a point lies to their left, or right."""
    run, away = seam[1] - seam[0], point - seam[0]
    left = float(run[0] * away[1] - run[1] * away[0]) > 0
    return seam if left == is_left else seam[::-1]
