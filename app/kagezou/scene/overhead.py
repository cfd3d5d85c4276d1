"""A lamp straight above a figure: what should be known of its shadow (paper 3.7)."""

from math import sqrt
from typing import Final

from kagezou.document.figure_properties import SHAPE
from kagezou.document.model import Layer
from kagezou.document.properties import OVERHEAD_RADIUS, OVERHEAD_SIMPLIFY, SIMPLIFY, SIMPLIFY_ON
from kagezou.document.values import value_at
from kagezou.geometry.card import Card
from kagezou.geometry.light import horizontal_distance, is_over, overhead_share
from kagezou.geometry.vectors import Vector4, dot, height_over
from kagezou.message import Message
from kagezou.scene.evaluate import contact_of, light_at
from kagezou.scene.figure_card import Moment, card_of
from kagezou.scene.placing import figure_box

RADIUS_OF_FIGURE: Final = 0.5
"""A usual radius within which a lamp is overhead, as a part of the figure's height."""

_BESIDE: Final = 1.5
"""A radius that is to hold a lamp is so many times its distance, so that the lamp is well within."""

_IN_PLANE_OF_FIGURE: Final = 0.03
"""A lamp that is nearer to the plane of a drawing than this part of the figure's height casts a line."""

_OVERHEAD: Final = 0.25
"""From this share on a lamp is well overhead, and what that changes is worth a word."""


def dark_words(on: Moment, layer: Layer) -> Message | None:
    """Return what to say of a lamp above a figure in the plane of its drawing, where a card has no shadow, or None."""
    light, card = light_at(on.document, on.frame, on.ground), card_of(on, layer, on.frame)
    # Of points whose card the light sees edge-on more is said elsewhere.
    if light[3] == 0 or not is_over(on.ground, light) or _is_disc(on, layer) or card.is_tilt_measured:
        return None
    contact, box = contact_of(card, on.ground), figure_box(on.document, layer.id, on.frame)
    radius = value_at(on.document.tracks, OVERHEAD_RADIUS, on.frame)
    if overhead_share(light, contact, radius) > 0:
        return None
    head = (box.middle[0], float(box.top))
    if _distance_from_plane(card, head, light) >= _IN_PLANE_OF_FIGURE * box.height:
        return None
    beside = horizontal_distance(light, contact)
    if beside > box.height:
        return None
    return Message(
        "the lamp is in the plane of {figure}'s drawing on frame {frame}, so there is next to no shadow: "
        "light.overhead_radius = {radius} makes four of it, and another z brings it out of that plane",
        figure=layer.name,
        frame=on.frame,
        radius=round(max(RADIUS_OF_FIGURE * box.height, _BESIDE * beside)),
    )


def joined_words(on: Moment, layer: Layer) -> Message | None:
    """Return what to say of a shadow that is simplified by more than is set because the lamp is overhead."""
    light, card = light_at(on.document, on.frame, on.ground), card_of(on, layer, on.frame)
    if not is_over(on.ground, light) or _is_disc(on, layer) or not value_at(layer.tracks, SIMPLIFY_ON, on.frame):
        return None
    radius, at_least = (value_at(on.document.tracks, prop, on.frame) for prop in (OVERHEAD_RADIUS, OVERHEAD_SIMPLIFY))
    share = overhead_share(light, contact_of(card, on.ground), radius)
    if share < _OVERHEAD or at_least <= value_at(layer.tracks, SIMPLIFY, on.frame):
        return None
    return Message(
        "the lamp is straight above {figure} on frame {frame}: it is four lamps there, whose shadows are simplified to "
        "one (light.overhead_radius, light.overhead_simplify)",
        figure=layer.name,
        frame=on.frame,
    )


def _is_disc(on: Moment, layer: Layer) -> bool:
    return value_at(layer.tracks, SHAPE, on.frame) == "disc"


def _distance_from_plane(card: Card, head: tuple[float, float], light: Vector4) -> float:
    """Return how far a lamp is from the plane of the piece with the head, world px."""
    piece = next((each for each in card.pieces if each.holds(head)), card.pieces[0])
    return abs(height_over(piece.plane, light)) / sqrt(dot(piece.normal, piece.normal))
