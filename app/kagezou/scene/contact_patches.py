"""The dark patches under the feet of a figure: where it touches the ground hardly any light comes."""

from collections.abc import Iterator
from typing import Final

from kagezou.document.companion_properties import CONTACT_SIZE, CONTACT_SOFTNESS, CONTACT_STRENGTH
from kagezou.document.figure_properties import EDGES
from kagezou.document.figures import height_of
from kagezou.document.model import Layer
from kagezou.document.properties import BLEND, COLOR
from kagezou.document.values import rgb_at, value_at
from kagezou.geometry.camera import project
from kagezou.geometry.card import Card
from kagezou.geometry.disc import GroundDisc
from kagezou.geometry.ground import place_on
from kagezou.geometry.vectors import Vector3
from kagezou.scene.figure_card import Moment, feet_at
from kagezou.scene.filters import Edge
from kagezou.scene.placing import figure_box
from kagezou.scene.round_shadow import below_box, cast_by_discs
from kagezou.scene.scene import Contact, ShadowCast, ShadowLook
from kagezou.scene.stances import stances_of

_RADIUS_OF_FIGURE: Final = 0.05
"""The radius of the patch under a foot on the ground where ``contact.size`` is 1, as a part of the height."""

GONE_OF_FIGURE: Final = 0.12
"""A foot so high over the ground, as a part of the height, has no patch any more."""

_LEAST_STRENGTH: Final = 1 / 512

_HARDLY_ANY: Final = 0.05
"""A patch of less than this part of its size is left out: it would be a speck."""


def contact_at(on: Moment, figure: Layer, since: int, card: Card) -> Contact | None:
    """Return the patches under the feet of a figure; None where they are not asked for or no foot is near the ground.

    Parameters
    ----------
    on, figure
        The frame, and the layer with the figure.
    since
        The frame whose look and way to stand count.
    card
        What the figure stands on; without feet it says where.
    """
    strength, size, softness = (
        value_at(figure.tracks, prop, since) for prop in (CONTACT_STRENGTH, CONTACT_SIZE, CONTACT_SOFTNESS)
    )
    if strength < _LEAST_STRENGTH:
        return None
    found = stances_of(on.document, figure.id)
    tall = height_of(figure, since) if found is None else found.height_px
    radius = _RADIUS_OF_FIGURE * size * tall
    discs = [
        GroundDisc(place, radius * near)
        for place, near in _touching(on, figure, since, card, tall)
        if near > _HARDLY_ANY
    ]
    if not discs:
        return None
    plain = ShadowCast(
        figure=(),
        translucent=False,
        camera=on.camera,
        receivers=(on.ground,),
        card=card,
        lights=(),
        edge=_edge(2 * softness * radius),
        is_hard=value_at(figure.tracks, EDGES, since) == "hard",
    )
    patches = cast_by_discs(on, discs, max(tall / 4, 1.0), plain)
    if patches is None:
        return None
    is_multiplied = value_at(figure.tracks, BLEND, since) == "multiply"
    return Contact(patches, ShadowLook(rgb_at(figure.tracks, COLOR, since), strength, is_multiplied))


def _edge(softness_px: float) -> Edge | None:
    return Edge(0.0, softness_px, 0.0) if softness_px >= 1 else None


def _touching(on: Moment, figure: Layer, since: int, card: Card, tall: float) -> Iterator[tuple[Vector3, float]]:
    """Yield where a figure touches the ground, world px, and how near it is there, from 0 to 1 on the ground."""
    standing = feet_at(on.document, figure, on.frame, since)
    if standing is not None:
        for foot in standing[0]:
            place = place_on(on.camera, on.ground, (foot.place[0], foot.ground_row))
            if place is not None:
                yield place, _nearness(foot.ground_row - foot.place[1], tall)
    elif card.contacts:
        yield from ((place, 1.0) for place in card.contacts)
    else:
        place = below_box(on, figure, card)
        _, row = project(on.camera.canvas_from_world(), (*place, 1.0))
        yield place, _nearness(row - figure_box(on.document, figure.id, on.frame).bottom, tall)


def _nearness(gap_px: float, tall: float) -> float:
    """Return how much of its patch a foot has that is so far over the ground."""
    return min(max(1 - gap_px / (GONE_OF_FIGURE * tall), 0.0), 1.0)
