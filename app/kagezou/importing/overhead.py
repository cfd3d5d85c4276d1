"""What becomes of a new project's lamp where it is brought to stand straight above a figure (paper 3.7)."""

from collections.abc import Iterable, Sequence
from math import inf
from typing import Final

from kagezou.document.address import Address
from kagezou.document.edits import set_constant
from kagezou.document.model import Document
from kagezou.document.properties import LIGHT_POSITION, OVERHEAD_RADIUS, OVERHEAD_SIMPLIFY
from kagezou.document.values import value_at
from kagezou.geometry.ground import place_on
from kagezou.geometry.light import horizontal_distance, lamp
from kagezou.importing.travel import Station
from kagezou.scene.evaluate import camera_at, ground_at
from kagezou.scene.overhead import RADIUS_OF_FIGURE

_OF_WAY: Final = 0.6
"""By no more than this part of its distance from a figure's nearest station a lamp is said to stand above it."""

_SIMPLIFY_OF_FIGURE: Final = 0.35
"""What joins four shadows to one round one, as a part of the figure's height."""


def ready_for_overhead(document: Document, tall_px: float, ways: Iterable[Sequence[Station]]) -> Document:
    """Return the document with a radius and a simplification for a lamp overhead, which the first lamp has no part in.

    Parameters
    ----------
    document
        With its ground and its first lamp.
    tall_px
        The height of its tallest figure.
    ways
        The stations of each figure over the cut.
    """
    camera, ground = camera_at(document, 1), ground_at(document, 1)
    light = lamp(value_at(document.tracks, LIGHT_POSITION, 1))
    places = (place_on(camera, ground, (each.x, each.ground_row)) for way in ways for each in way)
    nearest = min((horizontal_distance(light, place) for place in places if place is not None), default=inf)
    radius = float(round(min(RADIUS_OF_FIGURE * tall_px, _OF_WAY * nearest)))
    simplify = min(float(round(_SIMPLIFY_OF_FIGURE * tall_px)), OVERHEAD_SIMPLIFY.high)
    document = set_constant(document, Address(OVERHEAD_RADIUS), radius)
    return set_constant(document, Address(OVERHEAD_SIMPLIFY), simplify)
