"""Where a card meets the ground: the line from which the distance of a shadow is measured (spec 3)."""

from collections.abc import Sequence
from math import atan2, cos, degrees, sin
from typing import Final

import numpy as np

from kagezou.geometry.card import Card
from kagezou.geometry.ground import Plane
from kagezou.geometry.lean import Lean
from kagezou.geometry.vectors import Matrix, Vector3

_FAR_APART: Final = (0.1, 0.2)
_SLANTED_DEG: Final = (20.0, 40.0)
"""Over which part of the height between the outermost feet the contact line comes to run through them, and at which
slope on the ground it no longer does."""


def contact_plane(card: Card, ground: Plane) -> Plane:
    """Return the ground with its u axis laid along the contact line, so that |v| is the distance from it.

    The line is where a flat card's plane meets the ground; a folded card has the straight line through its outermost
    contacts, and others say which they have.
    """
    normal = np.array(ground.normal)
    if card.contact_line is not None:
        along = np.array(card.contact_line[1])
    elif len(card.contacts) > 1:
        along = np.array(card.contacts[-1]) - np.array(card.contacts[0])
    else:
        along = np.cross(normal, np.array(card.pieces[0].plane[:3]))
    length = float(np.linalg.norm(along))
    # A card that lies in the ground has no line; the ground's own serves as well as any.
    along = np.array(ground.u) if length < 1e-9 else along / length
    if along @ np.array(ground.u) < 0:
        along = -along
    origin = card.contacts[0] if card.contacts else ground.origin
    if card.contact_line is not None:
        origin = card.contact_line[0]
    return Plane(origin, _vector(along), _vector(np.cross(normal, along)), ground.normal)


def contact_line(ground: Plane, lean: Lean, places: Sequence[Vector3], spread: float) -> tuple[Vector3, Vector3]:
    """Return a point and the direction of the contact line of a figure on feet.

    It runs through the middle of all feet's places, lifted ones included, where the body's own plane would meet the
    ground, and turns to run through the outermost feet where those are far apart and stand side by side rather than
    one behind the other. All of that changes smoothly with the feet, planted or not, so that nothing jumps when a foot
    is set down.

    Parameters
    ----------
    places
        From left to right.
    spread
        How far apart the outermost feet are seen, as a part of the figure's height.
    """
    middle = np.mean(places, axis=0)
    own = _angle(ground, np.cross(ground.normal, lean.normal))
    through = _angle(ground, np.subtract(places[-1], places[0]))
    far = risen((spread - _FAR_APART[0]) / (_FAR_APART[1] - _FAR_APART[0]))
    slanted = risen((abs(degrees(through)) - _SLANTED_DEG[0]) / (_SLANTED_DEG[1] - _SLANTED_DEG[0]))
    angle = own + far * (1 - slanted) * (through - own)
    return _vector(middle), _vector(cos(angle) * np.array(ground.u) + sin(angle) * np.array(ground.v))


def _angle(ground: Plane, way: Matrix) -> float:
    """Return the angle on the ground, ±90°, between its u axis and the line along a way."""
    along, away = float(way @ np.array(ground.u)), float(way @ np.array(ground.v))
    return atan2(away, along) if along >= 0 else atan2(-away, -along)


def risen(part: float) -> float:
    """Return a smooth step from 0 at 0 to 1 at 1."""
    t = min(max(part, 0.0), 1.0)
    return t * t * (3 - 2 * t)


def _vector(numbers: Matrix) -> Vector3:
    x, y, z = (float(number) for number in numbers)
    return (x, y, z)
