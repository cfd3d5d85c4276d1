"""What a body hides from a point, or keeps the light of a lamp from: regions of space, in closed form.

Seen from one point K, every body is a few flat things: a solid its facets that face K, a ball the disc whose rim is its
outline, a drum the two ends and the rectangle between its two outlines. A segment from X to K crosses such a thing
exactly where X lies beyond its plane and within the cone from K over its rim, and the cone over a polygon is bounded by
planes, that over a disc by a quadric. On a flat receiver planes become lines and quadrics conics, so that no edge of a
shadow or an outline is ever sampled.
"""

from dataclasses import dataclass

import numpy as np

from kagezou.geometry.ground import Plane
from kagezou.geometry.sets.bodies import Ball, Body, Drum, Facet, Solid
from kagezou.geometry.vectors import Matrix, Vector4, plane_through

EDGE_ON = 1e-9
"""The sine of the angle below which a flat thing is seen edge-on and hides nothing."""


@dataclass(frozen=True, slots=True, eq=False)
class Cone:
    """The points X beyond one flat thing, as seen from K.

    Parameters
    ----------
    planes
        (N, 4): all n·X + d are >= 0; one for each edge, then the thing's own plane.
    quadric
        (4, 4) with XᵀQX >= 0 inside, or None.
    edges
        (N - 1, 2, 3): the ends of the edges of a polygon, world px; None for a disc.
    """

    planes: Matrix
    quadric: Matrix | None = None
    edges: Matrix | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Occlusion:
    """All points that a body hides from K.

    Parameters
    ----------
    cones
        What it is made of.
    inside
        (N, 4) and (4, 4): where X lies within a round body itself, by planes and a quadric >= 0; None for a solid,
        whose cones hold its inside as well.
    overlaps
        Whether the cones overlap; else they meet at edges and add up.
    """

    cones: tuple[Cone, ...]
    inside: Cone | None
    overlaps: bool


def occlusion_of(body: Body, source: Vector4) -> Occlusion:
    """Return what a body hides from a homogeneous point ``source``; nothing where that lies within the body."""
    if isinstance(body, Solid):
        cones = [_over_facet(facet, source) for facet in body.facets if body.is_sheet or _faces(facet, source)]
        return Occlusion(tuple(cone for cone in cones if cone is not None), None, overlaps=False)
    if _is_within(body, source):
        return Occlusion((), None, overlaps=True)
    if isinstance(body, Ball):
        return Occlusion((_over_disc(*_outline_disc(body, source), source),), _inside(body, []), overlaps=True)
    ends = tuple(_over_end(body, source, upper=upper) for upper in (False, True))
    found = [*ends, _over_sides(body, source)]
    return Occlusion(tuple(cone for cone in found if cone is not None), _inside(body, list(body.ends)), overlaps=True)


def end_cone(drum: Drum, source: Vector4) -> tuple[Plane, Cone] | None:
    """Return the end of a drum that faces ``source`` and the cone over it, None where neither does."""
    for upper in (True, False):
        cone = _over_end(drum, source, upper=upper) if float(np.dot(drum.ends[upper], source)) > 0 else None
        if cone is not None:
            return drum.end_plane(upper=upper), cone
    return None


def facet_cone(facet: Facet, source: Vector4) -> Cone | None:
    """Return the cone over a facet, whichever of its sides is seen; None where it is seen edge-on."""
    return _over_facet(facet, source)


def _faces(facet: Facet, source: Vector4) -> bool:
    return float(np.dot(facet.equation, source)) > 0


def _over_facet(facet: Facet, source: Vector4) -> Cone | None:
    corners = np.array(facet.corners)
    return _over_polygon(corners, np.array(facet.equation), source)


def _over_polygon(corners: Matrix, plane: Matrix, source: Vector4) -> Cone | None:
    facing = _facing(plane, source)
    if facing is None:
        return None
    edges = np.stack([corners, np.concatenate([corners[1:], corners[:1]])], axis=1)
    lamp = np.asarray(source)
    toward = lamp[:3] - lamp[3] * edges[:, 0]
    normals = np.cross(edges[:, 1] - edges[:, 0], toward)
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    normals = normals / lengths
    planes = np.column_stack([normals, -np.einsum("ij,ij->i", normals, edges[:, 0])])
    middle = np.append(corners.mean(axis=0), 1.0)
    planes *= np.where(planes @ middle >= 0, 1.0, -1.0)[:, np.newaxis]
    return Cone(np.vstack([planes, -facing]), None, edges)


def _facing(plane: Matrix, source: Vector4) -> Matrix | None:
    """Return a plane turned toward ``source``, None where it is seen edge-on."""
    value = float(plane @ np.asarray(source))
    if abs(value) <= EDGE_ON * max(1.0, float(np.linalg.norm(source[:3]))):
        return None
    return plane if value > 0 else -plane


def _over_end(drum: Drum, source: Vector4, *, upper: bool) -> Cone | None:
    centre = np.array(drum.head if upper else drum.foot)
    plane = _facing(np.array(drum.ends[upper]), source)
    return None if plane is None else _over_disc(centre, drum.radius_px, plane, source)


def _over_disc(centre: Matrix, radius_px: float, plane: Matrix, source: Vector4) -> Cone:
    """Return the cone over a disc whose plane is turned toward ``source``."""
    lamp = np.asarray(source)
    # X goes to the point of the disc's plane on its way to K; its weight is positive beyond the plane.
    onto = float(plane @ lamp) * np.eye(4) - np.outer(lamp, plane)
    onto /= np.abs(onto).max()
    away = np.column_stack([np.eye(3), -centre]) @ onto
    weight = onto[3]
    quadric = np.outer(weight, weight) - away.T @ away / radius_px**2
    return Cone(-plane[np.newaxis], quadric)


def _outline_disc(ball: Ball, source: Vector4) -> tuple[Matrix, float, Matrix]:
    """Return centre, radius and plane of the circle along which lines from ``source`` touch a ball."""
    lamp, centre = np.asarray(source), np.array(ball.centre)
    toward = lamp[:3] - lamp[3] * centre
    distance = float(np.linalg.norm(toward))
    toward = toward / distance
    part = lamp[3] * ball.radius_px / distance
    middle = centre + toward * ball.radius_px * part
    plane = np.array(plane_through((middle[0], middle[1], middle[2]), (toward[0], toward[1], toward[2])))
    return middle, ball.radius_px * float(np.sqrt(1 - part**2)), plane


def _over_sides(drum: Drum, source: Vector4) -> Cone | None:
    """Return the cone over the rectangle between the two lines along which a drum's side is touched."""
    lamp, axis, foot = np.asarray(source), np.array(drum.axis), np.array(drum.foot)
    toward = lamp[:3] - lamp[3] * foot
    toward = toward - axis * (axis @ toward)
    distance = float(np.linalg.norm(toward))
    part = float(lamp[3]) * drum.radius_px
    if distance <= max(part, 1e-9):
        # From straight above or below the ends hide all that there is.
        return None
    toward, part = toward / distance, part / distance
    beside = np.cross(axis, toward) * drum.radius_px * np.sqrt(1 - part**2)
    middle = foot + toward * drum.radius_px * part
    up = axis * drum.height_px
    corners = np.array([middle - beside, middle + beside, middle + beside + up, middle - beside + up])
    plane = np.append(toward, -toward @ middle)
    return _over_polygon(corners, plane, source)


def _is_within(body: Ball | Drum, source: Vector4) -> bool:
    lamp = np.asarray(source)
    if lamp[3] == 0 or float(lamp @ body.quadric @ lamp) > 0:
        return False
    return isinstance(body, Ball) or all(float(np.dot(end, lamp)) <= 0 for end in body.ends)


def _inside(body: Ball | Drum, ends: list[Vector4]) -> Cone:
    planes = -np.array(ends, dtype=np.float64).reshape(-1, 4)
    return Cone(planes, -body.quadric / body.radius_px**2)
