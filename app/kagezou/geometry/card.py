"""The card: the surface on which a drawing's silhouette stands (spec 2; paper 3.3, 3.5)."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import atan, degrees, hypot, inf, isfinite, radians, tan

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import Plane, place_on
from kagezou.geometry.lean import Lean
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
        return self.room_at(point) >= 0

    def room_at(self, point: Point2) -> float:
        """Return the least of the forms of the piece's edges at a canvas point: below 0 where it lies beside it."""
        return min((a * point[0] + b * point[1] + c for a, b, c in self.limits), default=inf)

    def part_of(self, box: Box) -> Matrix:
        """Return the convex polygon (N, 2) of a canvas box that lies on the piece; N may be 0."""
        return self.part_of_polygon(box_polygon(box))

    def part_of_polygon(self, polygon: Matrix) -> Matrix:
        """Return the same of a convex polygon (N, 2), canvas px."""
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
    upright
        How far the card is stood up along the ground's normal, 0 to 1: less than given where it would be edge-on.
    contact_line
        A place on the ground and a direction along which the card stands there; None for the line through contacts.
    """

    pieces: tuple[CardPiece, ...]
    contacts: tuple[Vector3, ...] = ()
    tilt_deg: float = 0.0
    merged: bool = False
    upright: float = 0.0
    contact_line: tuple[Vector3, Vector3] | None = None

    @property
    def is_tilt_measured(self) -> bool:
        """Whether grounding points tell the tilt, so that what is given does not count; feet never do."""
        return self.contact_line is None and (len(self.contacts) > 1 or self.merged)

    @property
    def axis(self) -> Vector3 | None:
        """A place, world px, on the vertical about which a given tilt turns the card; None without any contact."""
        if self.contact_line is not None:
            return self.contact_line[0]
        return self.contacts[0] if len(self.contacts) == 1 else None

    def piece_at(self, point: Point2) -> CardPiece:
        """Return the piece on which a canvas point of the drawing lies; on an edge, either."""
        return max(self.pieces, key=lambda piece: piece.room_at(point))


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
    upright: float = 0.0,
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
    upright
        0 parallel to the screen, 1 along the ground's normal; contacts stay where they are.
    """
    kept, merged = _settled(camera, ground, grounding, figure_height_px)
    places = [place for _, place in kept]
    if len(kept) < 2:
        phi = 0.0 if merged else tilt_deg
        place = places[0] if places else ground.origin
        feet = [point for point, _ in kept] or [(ground.origin[0], ground.origin[1])]
        lean = Lean.of(camera, ground, feet, slope_of(phi), upright)
        return Card((standing_piece(place, lean),), tuple(places), phi, merged, lean.upright)
    lean = Lean.of(camera, ground, [point for point, _ in kept], 0.0, upright)
    folded = _folded(kept)
    phi = degrees(atan(-folded[0].normal[0])) if len(folded) == 1 else 0.0
    pieces = _leaning(camera, kept, lean) if lean.upright else folded
    return Card(pieces, tuple(places), phi, merged, lean.upright)


_Contact = tuple[Point2, Vector3]


def slope_of(tilt_deg: float) -> float:
    """Return dz/dx of a card that is turned by φ."""
    return tan(radians(min(max(tilt_deg, -MAX_SLOPE_DEG), MAX_SLOPE_DEG)))


def standing_piece(place: Vector3, lean: Lean) -> CardPiece:
    """Return the piece without end through a place."""
    if lean.down == 0:
        return vertical_piece((place[0], place[2]), lean.across)
    return CardPiece(place, lean.normal)


def rising_piece(a: Vector3, b: Vector3, lean: Lean, limits: tuple[Vector3, ...] = ()) -> CardPiece:
    """Return the piece through two places that rises over them as the card leans."""
    return CardPiece(a, _facing(np.cross(np.subtract(b, a), lean.rising)), limits)


def piece_through(a: Vector3, b: Vector3, c: Vector3, limits: tuple[Vector3, ...]) -> CardPiece:
    """Return the piece through three places."""
    return CardPiece(a, _facing(np.cross(np.subtract(b, a), np.subtract(c, a))), limits)


def _facing(normal: Matrix) -> Vector3:
    """Return a normal of length 1 that points toward the viewer."""
    x, y, z = (float(each) for each in normal / np.linalg.norm(normal))
    return (x, y, z) if z >= 0 else (-x, -y, -z)


def _leaning(camera: Camera, contacts: list[_Contact], lean: Lean) -> tuple[CardPiece, ...]:
    """Return the pieces between neighbours as :func:`_folded` does, stood up."""
    columns = [lean.column(camera, seen, place) for seen, place in contacts]
    last = len(columns) - 2
    pieces: list[CardPiece] = []
    for index, ((_, a), (_, b)) in enumerate(pairwise(contacts)):
        right = () if index == last else (turned_form(columns[index + 1]),)
        left = () if index == 0 else (columns[index],)
        pieces.append(rising_piece(a, b, lean, (*left, *right)))
    return tuple(pieces)


def turned_form(form: Vector3) -> Vector3:
    """Return a form that is positive where another one is negative."""
    return (-form[0], -form[1], -form[2])


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
