"""Where a card meets the ground: the line from which the distance of a shadow is measured (spec 3)."""

import numpy as np

from kagezou.geometry.card import Card
from kagezou.geometry.ground import Plane
from kagezou.geometry.vectors import Matrix, Vector3


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


def _vector(numbers: Matrix) -> Vector3:
    x, y, z = (float(number) for number in numbers)
    return (x, y, z)
