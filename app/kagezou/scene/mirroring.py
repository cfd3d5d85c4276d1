"""The figure mirrored in the ground, as its layer asks for it."""

from dataclasses import replace
from typing import Final

from kagezou.document.companion_properties import (
    REFLECTION_COLOR,
    REFLECTION_FADE,
    REFLECTION_OPACITY,
    REFLECTION_TONE,
    REFLECTION_UPRIGHT,
)
from kagezou.document.figure_properties import EDGES
from kagezou.document.model import Layer
from kagezou.document.values import rgb_at, value_at
from kagezou.scene.figure_card import Moment, card_of
from kagezou.scene.filters import Water
from kagezou.scene.scene import Fade, PlacedDrawing, Reflection

_LEAST_OPACITY: Final = 1 / 512


def reflection_at(
    on: Moment, figure: Layer, since: int, cels: tuple[PlacedDrawing, ...], water: Water | None
) -> Reflection | None:
    """Return what is mirrored of a figure, None where that is not asked for or nothing of it is seen.

    Parameters
    ----------
    on, figure
        The frame, and the layer with the figure.
    since
        The frame whose grounding points, tilt and the like count.
    cels
        What is seen of it, from the bottom.
    water
        The waves that its shadow lies on; gaps are those of the shadow alone.
    """
    tracks, frame = figure.tracks, on.frame
    opacity = value_at(tracks, REFLECTION_OPACITY, frame)
    if opacity < _LEAST_OPACITY or not cels:
        return None
    fade = value_at(tracks, REFLECTION_FADE, frame)
    return Reflection(
        cels,
        on.camera,
        on.ground,
        card_of(on, figure, since, value_at(tracks, REFLECTION_UPRIGHT, frame)),
        opacity,
        rgb_at(tracks, REFLECTION_COLOR, frame),
        value_at(tracks, REFLECTION_TONE, frame),
        Fade(fade, 1.0) if fade > 0 else None,
        water and replace(water, slits=None),
        is_hard=value_at(tracks, EDGES, frame) == "hard",
    )
