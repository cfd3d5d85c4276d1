"""The card: the surface on which a drawing's silhouette stands (spec 2; paper 3.3, 3.5)."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import atan, degrees, hypot, inf, isfinite, radians, tan

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import Plane, place_on
from kagezou.geometry.polygon import box_polygon, clipped
from kagezou.geometry.vectors import Matrix, Point2, Vector3, Vector4, height_over, plane_through

MIN_SPACING_OF_FIGURE = 0.02
"""Grounding points closer in x than this part of the figure's height count as one."""

MAX_SLOPE_DEG = 75.0
"""A card turned further than this away from the screen is not followed."""


@dataclass(frozen=True, slots=True)
class CardPiece:
    """One flat piece of a card, and which convex part of the drawing lies on it.

    Parameters
    ----------
    place
        A point of its plane, world px.
    normal
        The plane's normal, of any length; z > 0, toward the viewer.
    limits
        Forms (a, b, c) over canvas px, ax + by + c >= 0 on the piece's side of each straight edge; none for a piece
        without end.
    """

    place: Vector3
    normal: Vector3
    limits: tuple[Vector3, ...] = ()

    @property
    def plane(self) -> Vector4:
        """The plane (n, d) of the piece."""
        return plane_through(self.place, self.normal)

    def holds(self, point: Point2) -> bool:
        """Return whether a canvas point of the drawing lies on the piece or its edge."""
        return all(a * point[0] + b * point[1] + c >= 0 for a, b, c in self.limits)

    def part_of(self, box: Box) -> Matrix:
        """Return the convex polygon (N, 2) of a canvas box that lies on the piece; N may be 0."""
        polygon = box_polygon(box)
        for limit in self.limits:
            polygon = clipped(polygon, np.array(limit))
        return polygon

    def adjoins(self, other: "CardPiece") -> bool:
        """Return whether the piece goes on beyond an edge as the other one."""
        return any((-a, -b, -c) in other.limits for a, b, c in self.limits)


def vertical_piece(place: tuple[float, float], slope: float, left: float = -inf, right: float = inf) -> CardPiece:
    """Return the piece z = z0 + slope·(x − x0), seen between two canvas columns.

    Parameters
    ----------
    place
        (x0, z0), world px.
    slope
        dz/dx; the vertical direction (0, 1, 0) lies in the piece.
    left, right
        Canvas x between which the drawing lies on it; ±inf for no end.
    """
    x0, z0 = place
    limits = ((1.0, 0.0, -left), (-1.0, 0.0, right))
    return CardPiece((x0, 0.0, z0), (-slope, 0.0, 1.0), tuple(each for each in limits if isfinite(each[2])))


@dataclass(frozen=True, slots=True)
class Card:
    """A card of flat pieces and what is known of how it stands.

    Parameters
    ----------
    pieces
        Side by side on the canvas, none over another; never empty.
    contacts
        Where the figure touches the ground, world px; empty without grounding points.
    tilt_deg
        The angle φ the card has been turned by: given without or with one point, measured with two, 0 otherwise.
    merged
        Whether grounding points stood too close or too steep and were taken as their midpoint.
    """

    pieces: tuple[CardPiece, ...]
    contacts: tuple[Vector3, ...] = ()
    tilt_deg: float = 0.0
    merged: bool = False


def receiver_of(camera: Camera, piece: CardPiece) -> Plane:
    """Return a piece as a surface that shadows fall on: u horizontal, its lit side toward the eye."""
    nx, ny, nz = piece.normal
    level, length = hypot(nz, nx), hypot(nz, nx, ny)
    side = -1.0 if height_over(piece.plane, camera.eye) < 0 else 1.0
    return Plane(
        origin=piece.place,
        u=(nz / level, 0.0, -nx / level),
        v=(-nx / level * (ny / length), level / length, -nz / level * (ny / length)),
        normal=(side * nx / length, side * ny / length, side * nz / length),
    )


def card_for(
    camera: Camera,
    ground: Plane,
    grounding: Sequence[Point2],
    tilt_deg: float,
    figure_height_px: float,
) -> Card:
    """Return the card of a drawing.

    Without grounding points it stands on the ground line, turned by φ about the vertical through
    ``ground.position``; with one it passes through that point's place on the ground; with two or more it is folded
    through all their places and φ is measured. Points above the horizon have no place and are left out.

    Parameters
    ----------
    camera, ground
        What the points are seen with and stand on.
    grounding
        Canvas points, px.
    tilt_deg
        φ, used with fewer than two points.
    figure_height_px
        Height of the figure, which decides when two points are too close.
    """
    kept, merged = _settled(camera, ground, grounding, figure_height_px)
    places = [place for _, place in kept]
    if not kept:
        origin = ground.origin
        return Card((_turned(origin, tilt_deg),), tilt_deg=tilt_deg)
    if len(kept) == 1:
        phi = 0.0 if merged else tilt_deg
        return Card((_turned(places[0], phi),), tuple(places), phi, merged)
    pieces = _folded(kept)
    phi = degrees(atan(-pieces[0].normal[0])) if len(pieces) == 1 else 0.0
    return Card(pieces, tuple(places), phi, merged)


_Contact = tuple[Point2, Vector3]


def _turned(place: Vector3, tilt_deg: float) -> CardPiece:
    slope = tan(radians(min(max(tilt_deg, -MAX_SLOPE_DEG), MAX_SLOPE_DEG)))
    return vertical_piece((place[0], place[2]), slope)


def _folded(contacts: list[_Contact]) -> tuple[CardPiece, ...]:
    """Return the pieces between neighbours; the outer ones go on outward."""
    pairs = list(pairwise(contacts))
    last = len(pairs) - 1
    return tuple(
        vertical_piece(
            (a[0], a[2]),
            (b[2] - a[2]) / (b[0] - a[0]),
            -inf if index == 0 else seen_a[0],
            inf if index == last else seen_b[0],
        )
        for index, ((seen_a, a), (seen_b, b)) in enumerate(pairs)
    )


def _settled(
    camera: Camera, ground: Plane, grounding: Sequence[Point2], figure_height_px: float
) -> tuple[list[_Contact], bool]:
    """Return the contacts from left to right, unusable neighbours merged, and whether any were."""
    contacts = _placed(camera, ground, sorted(grounding))
    merged = False
    while (worst := _unusable_pair(contacts, MIN_SPACING_OF_FIGURE * figure_height_px)) is not None:
        (ax, ay), (bx, by) = contacts[worst][0], contacts[worst + 1][0]
        middle = _placed(camera, ground, [((ax + bx) / 2, (ay + by) / 2)])
        contacts[worst : worst + 2] = middle
        merged = True
    return contacts, merged


def _placed(camera: Camera, ground: Plane, points: Sequence[Point2]) -> list[_Contact]:
    placed = ((point, place_on(camera, ground, point)) for point in points)
    return [(point, place) for point, place in placed if place is not None]


def _unusable_pair(contacts: list[_Contact], min_spacing_px: float) -> int | None:
    """Return the index of the first of two neighbours too close in x or too steep, or None."""
    for index, ((seen_a, a), (seen_b, b)) in enumerate(pairwise(contacts)):
        run = b[0] - a[0]
        if seen_b[0] - seen_a[0] < max(min_spacing_px, 1e-9) or run <= 0:
            return index
        if abs(b[2] - a[2]) > tan(radians(MAX_SLOPE_DEG)) * run:
            return index
    return None
