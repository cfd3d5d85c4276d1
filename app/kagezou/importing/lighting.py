"""The ground and the light of characters that were just brought in, and of those that were then made to travel."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Final

import numpy as np

from kagezou.animation.frames import spread_frames
from kagezou.document.address import Address
from kagezou.document.edits import set_constant
from kagezou.document.figures import parts_of
from kagezou.document.model import Document, Layer
from kagezou.document.properties import (
    GROUND_POSITION,
    LIGHT_AZIMUTH,
    LIGHT_ELEVATION,
    LIGHT_KIND,
    LIGHT_POSITION,
)
from kagezou.document.values import value_at
from kagezou.geometry.box import around
from kagezou.geometry.light import lamp
from kagezou.geometry.placement import canvas_from_centred
from kagezou.geometry.vectors import Matrix
from kagezou.importing.figures import Figure, MeasuredFigure, measured_figure
from kagezou.importing.first_light import MOST_TURN_DEG, FirstLight, first_light
from kagezou.importing.overhead import ready_for_overhead
from kagezou.importing.placed_figures import placed_figure
from kagezou.importing.travel import Station, stations, turn_of_shadows
from kagezou.message import Message
from kagezou.scene.evaluate import camera_at, ground_at, light_at
from kagezou.scene.placing import PLACING, figure_box, placement_at

_MOST_FRAMES: Final = 64
"""So many frames stand for all of a cut when it is asked how a figure travels."""


def with_ground_and_light(document: Document, figures_seen: Mapping[str, MeasuredFigure]) -> Document:
    """Return the document with the ground under its lowest figure, and a light that is good over the whole cut.

    Parameters
    ----------
    document
        With all layers of the figures.
    figures_seen
        By layer.
    """
    canvas_box = document.canvas.box
    figures = [look.figure for look in figures_seen.values() if look.figure is not None]
    if not figures:
        return set_constant(document, Address(GROUND_POSITION), (canvas_box.width / 2, float(canvas_box.height)))
    lowest = max(figures, key=lambda figure: figure.foot[1])
    document = set_constant(document, Address(GROUND_POSITION), lowest.foot)
    later = np.concatenate([look.later for look in figures_seen.values()])
    ways = list(_drawn_ways(document, figures_seen))
    return _first_lit(document, figures, later, ways)


def relit(document: Document) -> tuple[Document, tuple[Message, ...]]:
    """Return the document with the sun where its first lamp would swing the shadows of moved layers, and what to say.

    A light that anybody has set stays; and the same document comes back where the shadows turn by little.
    """
    ways = list(_shown_ways(document)) if _has_a_lamp_alone(document) else []
    first = value_at(document.tracks, LIGHT_POSITION, 1)
    if turn_of_shadows(camera_at(document, 1), ground_at(document, 1), lamp(first), ways) <= MOST_TURN_DEG:
        return document, ()
    looks = [measured_figure(layer.cels.drawings, document.canvas.box) for layer in document.layers]
    figures = [look.figure for look in looks if look.figure is not None]
    drawn = np.concatenate([look.later for look in looks])
    if not figures or _light(document, figures, drawn, ()).lamp != first:
        return document, ()
    light = _light(document, figures, np.concatenate(list(_moved_outlines(document, looks))), ways)
    note = Message("the light is the sun now: near a lamp the shadow would turn round while the figure travels")
    return _lit(document, light), (note,)


def turning_note(before: Document, after: Document) -> Message | None:
    """Return what to say of a lamp near the way on which layers are made to travel by a step; None where all is well.

    Only a lamp that stands still counts: one that is moved may well turn the shadows on purpose.
    """
    if _placing(before) == _placing(after):
        return None
    if _turn(after) <= MOST_TURN_DEG or _turn(before) > MOST_TURN_DEG:
        return None
    return Message(
        "near the lamp the shadow turns round while the figure travels; the sun, or a lamp farther off, keeps its "
        "direction"
    )


def _placing(document: Document) -> tuple[object, ...]:
    """Return what moves the drawings of a document."""
    return tuple(layer.tracks.get(name) for layer in document.layers for name in sorted(PLACING))


def _turn(document: Document) -> float:
    """Return by how many degrees the shadows of moved figures turn under a lamp that stands still; 0 under others."""
    place = document.tracks.get(LIGHT_POSITION.name)
    kind = document.tracks.get(LIGHT_KIND.name)
    if (place is not None and place.is_keyed) or (kind is not None and kind.is_keyed):
        return 0.0
    ground = ground_at(document, 1)
    light = light_at(document, 1, ground)
    return 0.0 if light[3] == 0 else turn_of_shadows(camera_at(document, 1), ground, light, _shown_ways(document))


def grounded_as_shown(document: Document) -> Document:
    """Return the document with the ground under the lowest figure as its layer lays it, and a light that fits there.

    For layers that are moved from the start; those of an import alone lie as they are drawn.
    """
    looks = [measured_figure(layer.cels.drawings, document.canvas.box) for layer in document.layers]
    figures = [
        placed_figure(look.figure, placement_at(document, layer, _first_seen(layer)))
        for layer, look in zip(document.layers, looks, strict=True)
        if look.figure is not None
    ]
    if not figures:
        return document
    lowest = max(figures, key=lambda figure: figure.foot[1])
    document = set_constant(document, Address(GROUND_POSITION), lowest.foot)
    outlines = np.concatenate(list(_moved_outlines(document, looks)))
    return _first_lit(document, figures, outlines, list(_shown_ways(document)))


def _first_seen(layer: Layer) -> int:
    """Return the first frame on which a layer shows a drawing, 1 where it never does."""
    return next((max(each.frame, 1) for each in layer.cels.exposures if each.drawing is not None), 1)


def _has_a_lamp_alone(document: Document) -> bool:
    """Whether the light may be that of the import, and layers move their drawings."""
    place = document.tracks.get(LIGHT_POSITION.name)
    is_first = place is not None and not place.is_keyed
    is_first &= document.tracks.keys().isdisjoint(prop.name for prop in (LIGHT_KIND, LIGHT_AZIMUTH, LIGHT_ELEVATION))
    return is_first and not all(layer.tracks.keys().isdisjoint(PLACING) for layer in document.layers)


def _light(
    document: Document, figures: Sequence[Figure], later: Matrix, ways: Sequence[Sequence[Station]]
) -> FirstLight:
    return first_light(document.canvas.box, camera_at(document, 1), ground_at(document, 1), figures, later, ways)


def _first_lit(
    document: Document, figures: Sequence[Figure], later: Matrix, ways: Sequence[Sequence[Station]]
) -> Document:
    """Return a new document in its first light, and ready for a lamp overhead."""
    document = _lit(document, _light(document, figures, later, ways))
    return ready_for_overhead(document, max(float(figure.box.height) for figure in figures), ways)


def _lit(document: Document, light: FirstLight) -> Document:
    """Return the document in a light; the lamp's place is kept also where the sun shines."""
    document = set_constant(document, Address(LIGHT_POSITION), light.lamp)
    if light.sun is None:
        return document
    azimuth, elevation = light.sun
    document = set_constant(document, Address(LIGHT_KIND), "sun")
    document = set_constant(document, Address(LIGHT_AZIMUTH), azimuth)
    return set_constant(document, Address(LIGHT_ELEVATION), elevation)


def _drawn_ways(document: Document, figures_seen: Mapping[str, MeasuredFigure]) -> Iterator[tuple[Station, ...]]:
    """Yield the stations of each figure as its own drawings go; its parts only say how far it reaches."""
    for layer in document.layers:
        own = figures_seen[layer.id].boxes
        if layer.joins is None and own:
            parts = (figures_seen[part.id].boxes for part in parts_of(document, layer.id))
            whole = around(*(boxes[0] for boxes in parts if boxes)) or own[0]
            yield stations(own, above_px=own[0].top - whole.top, below_px=whole.bottom - own[0].bottom)


def _shown_ways(document: Document) -> Iterator[tuple[Station, ...]]:
    """Yield the stations of each figure as the cut shows it."""
    for layer in document.layers:
        if layer.joins is None:
            yield stations(
                [
                    figure_box(document, layer.id, frame)
                    for frame in spread_frames(document.canvas.length_frames, _MOST_FRAMES)
                ]
            )


def _moved_outlines(document: Document, looks: Sequence[MeasuredFigure]) -> Iterator[Matrix]:
    """Yield the first figures' outlines (N, 2) where their layers move them, canvas px."""
    for layer, look in zip(document.layers, looks, strict=True):
        if look.figure is None:
            continue
        points = np.column_stack([outline := look.figure.outline(), np.ones(len(outline))])
        for frame in spread_frames(document.canvas.length_frames, _MOST_FRAMES):
            moving = canvas_from_centred(placement_at(document, layer, frame))
            yield points @ moving[:2].T
