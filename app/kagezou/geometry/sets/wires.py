"""The edges of set pieces as lines in space, and which parts of them the piece itself hides from the eye.

Everything with flat faces is a profile drawn out along the piece's width; what is round has its rims and the outline
that the eye sees of it.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import pi, sqrt
from typing import NamedTuple

import numpy as np

from kagezou.geometry.ground import Plane
from kagezou.geometry.sets.bodies import Ball, Body, Drum, vector
from kagezou.geometry.sets.measures import Measures
from kagezou.geometry.sets.shapes import SHAPES, DrawnOut, Profile, Sheet
from kagezou.geometry.sets.ways import way_within, ways_to
from kagezou.geometry.vectors import Matrix, Vector3, Vector4

RIM_PARTS = 48

_TOUCH = 1e-4
"""A sight line that crosses a body for less than this part of its size only touches it."""


class _Edge(NamedTuple):
    """A polyline (N + 1, 3), and a point (N, 3) that stands for each of its parts: on a round edge, truly on it."""

    points: Matrix
    middles: Matrix


@dataclass(frozen=True, slots=True)
class Wire:
    """A part of an edge: a polyline in world px, and whether the piece hides it from the eye."""

    points: tuple[Vector3, ...]
    is_hidden: bool


def wires_of(stand: Plane, measures: Measures, eye: Vector4) -> tuple[Wire, ...]:
    """Return the edges of a piece; none where its kind is not made of measures.

    Parameters
    ----------
    stand
        Its frame on the ground.
    measures
        What it is made from.
    eye
        The eye in world px, homogeneous; w = 0 for a direction.
    """
    w, h, d = measures.width_px, measures.height_px, measures.depth_px
    shape = SHAPES[measures.kind]
    if shape is None:
        return ()
    if isinstance(shape, DrawnOut):
        edges = _drawn_out(stand, w, shape.profile(measures))
        return _split(edges, shape.bodies(stand, measures), eye, w + h + d)
    if isinstance(shape, Sheet):
        rims = (sheet.facets[0].corners for sheet in shape.bodies(stand, measures))
        return tuple(Wire((*corners, corners[0]), is_hidden=False) for corners in rims)
    return tuple(wire for body in shape.bodies(stand, measures) for wire in _of_round(body, stand, eye))


def _of_round(body: Drum | Ball, stand: Plane, eye: Vector4) -> tuple[Wire, ...]:
    """Return the rims of a drum or the girth of a ball, and the outline that the eye sees of it."""
    width = 2 * body.radius_px
    if isinstance(body, Drum):
        rims = [_circle(middle, stand.u, stand.v, body.radius_px) for middle in (body.foot, body.head)]
        return _split([*rims, *_sides(body, eye)], (body,), eye, width + body.height_px)
    girth = _circle(body.centre, stand.u, stand.v, body.radius_px)
    rim = Wire(_points(_contour(body, eye).points), is_hidden=False)
    return (rim, *_split([girth], (body,), eye, width))


def _drawn_out(stand: Plane, width: float, profile: Profile) -> list[_Edge]:
    """Return the edges of a profile drawn out along the stand's u, around its middle."""
    axes = np.array([stand.u, stand.v, stand.normal])
    points, sides = profile.points, (-width / 2, width / 2)
    rims = [np.array(stand.origin) + np.array([(side, *at) for at in points]) @ axes for side in sides]
    ends = [(rim[i - 1], rim[i]) for rim in rims for i in range(len(points))]
    ends += [(rims[0][i], rims[1][i]) for i in range(len(points))]
    return [_straight(start, end, profile.parts) for start, end in ends]


def _straight(start: Matrix, end: Matrix, parts: int = 1) -> _Edge:
    along = np.linspace(0.0, 1.0, 2 * parts + 1)[:, None]
    points = start + along * (end - start)
    return _Edge(points[::2], points[1::2])


def _circle(middle: Vector3, u: Vector3, v: Vector3, radius: float) -> _Edge:
    """Return a circle around a middle as a closed polyline."""
    turns = np.linspace(0.0, 2 * pi, 2 * RIM_PARTS + 1)[:, None]
    points = np.array(middle) + radius * (np.cos(turns) * np.array(u) + np.sin(turns) * np.array(v))
    return _Edge(points[::2], points[1::2])


def _contour(ball: Ball, eye: Vector4) -> _Edge:
    """Return the circle on which sight lines touch a ball."""
    centre = np.array(ball.centre)
    way = np.array(eye[:3]) - eye[3] * centre
    distance = float(np.linalg.norm(way))
    axis = way / distance
    part = min(ball.radius_px / distance, 0.999) if eye[3] else 0.0
    middle = centre + ball.radius_px * part * axis
    across = np.eye(3)[int(np.argmin(np.abs(axis)))]
    u = np.cross(across, axis)
    u /= np.linalg.norm(u)
    return _circle(vector(middle), vector(u), vector(np.cross(axis, u)), ball.radius_px * sqrt(1 - part * part))


def _sides(drum: Drum, eye: Vector4) -> list[_Edge]:
    """Return the two straight lines on which sight lines touch a drum; none from above or within it."""
    axis, foot = np.array(drum.axis), np.array(drum.foot)
    way = np.array(eye[:3]) - eye[3] * foot
    flat = way - (way @ axis) * axis
    distance = float(np.linalg.norm(flat))
    if distance < 1e-9 or (eye[3] and distance <= drum.radius_px):
        return []
    toward = flat / distance
    near = drum.radius_px / distance if eye[3] else 0.0
    aside = np.cross(axis, toward)
    feet = [foot + drum.radius_px * (near * toward + side * sqrt(1 - near * near) * aside) for side in (-1.0, 1.0)]
    return [_straight(each, each + drum.height_px * axis) for each in feet]


def _split(edges: Sequence[_Edge], bodies: Sequence[Body], eye: Vector4, size: float) -> tuple[Wire, ...]:
    """Return the edges in runs of parts that are all seen or all hidden."""
    middles = np.concatenate([edge.middles for edge in edges])
    hidden = np.zeros(len(middles), bool)
    for body in bodies:
        hidden |= _crossed(body, middles, eye) > _TOUCH * size
    found: list[Wire] = []
    at = 0
    for edge in edges:
        flags = hidden[at : at + len(edge.middles)]
        at += len(flags)
        starts = [0, *(int(turn) + 1 for turn in np.flatnonzero(flags[1:] != flags[:-1])), len(flags)]
        found += [Wire(_points(edge.points[a : b + 1]), is_hidden=bool(flags[a])) for a, b in pairwise(starts)]
    return tuple(found)


def _crossed(body: Body, points: Matrix, eye: Vector4) -> Matrix:
    """Return for how many px the way from each point (N, 3) to the eye lies within a body."""
    ways, lengths = ways_to(eye, points)
    begin, end = way_within(body, points, ways, np.zeros(len(points)), lengths)
    return np.maximum(end - begin, 0.0)


def _points(line: Matrix) -> tuple[Vector3, ...]:
    return tuple((float(x), float(y), float(z)) for x, y, z in line)
