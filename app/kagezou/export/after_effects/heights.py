"""How shadows move where a compositor holds figures higher over the ground: what the control of the height needs."""

from collections.abc import Mapping
from typing import Final

import numpy as np

from kagezou.document.figure_properties import LIFT_SHRINK, SHAPE
from kagezou.document.figures import height_of
from kagezou.document.model import Document, Layer
from kagezou.document.values import value_at
from kagezou.export.after_effects.channels import pair_through
from kagezou.export.after_effects.comp import Rising
from kagezou.geometry.camera import project
from kagezou.geometry.shadow import Cast, cast_card
from kagezou.geometry.vectors import Point2
from kagezou.scene.evaluate import contact_of, evaluate
from kagezou.scene.scene import Scene, ShadowCast

_STEP_OF_FIGURE: Final = 1 / 8
"""The height that is looked at: from there a sun's shadow goes on evenly, and a lamp's is taken to."""

_FARTHEST_PX: Final = 100_000.0
_PLACES: Final = 3
"""Decimal places that are kept: a thousandth of a pixel."""


def risings_of(document: Document) -> Mapping[str, Rising]:
    """Return how the shadows of figures move, by the ids of their layers; of figures that never cast there is none.

    A round shadow stays where it is, as it lies under its figure at every height.
    """
    scenes = [evaluate(document, frame) for frame in range(1, document.canvas.length_frames + 1)]
    found = {}
    for layer in (each for each in document.layers if each.joins is None):
        places = [_places_in(scene, layer) for scene in scenes]
        known = [place for place in places if place is not None]
        if known:
            found[layer.id] = _rising(document, layer, [place or known[0] for place in _held(places)])
    return found


def _rising(document: Document, layer: Layer, places: list[tuple[Point2, Point2]]) -> Rising:
    rate, tall = document.canvas.frame_rate, _tall(layer)
    return Rising(
        contact=pair_through([contact for contact, _ in places], rate),
        raised=pair_through([raised for _, raised in places], rate),
        step_px=tall * _STEP_OF_FIGURE,
        tall_px=tall,
        shrink=value_at(layer.tracks, LIFT_SHRINK, 1),
    )


def _held(places: list[tuple[Point2, Point2] | None]) -> list[tuple[Point2, Point2] | None]:
    """Return the places of all frames; while no shadow is there those of the last one before."""
    held: list[tuple[Point2, Point2] | None] = []
    for place in places:
        held.append(place or (held[-1] if held else None))
    return held


def _places_in(scene: Scene, layer: Layer) -> tuple[Point2, Point2] | None:
    """Return where a figure stands, and where the shadow of that place falls when it is raised, canvas px."""
    cast = next((each.cast for each in scene.layers if each.id == layer.id), None)
    if cast is None or not cast.lights:
        return None
    contact = project(cast.camera.canvas_from_world(), (*contact_of(cast.card, scene.ground), 1.0))
    is_round = value_at(layer.tracks, SHAPE, 1) == "disc"
    raised = None if is_round else _raised(scene, cast, contact, _tall(layer) * _STEP_OF_FIGURE)
    return _rounded(contact), _rounded(contact if raised is None else raised)


def _tall(layer: Layer) -> float:
    return max(height_of(layer, 1), 1.0)


def _raised(scene: Scene, cast: ShadowCast, contact: Point2, step_px: float) -> Point2 | None:
    """Return where the shadow of the contact falls when it is raised; None where it does not, or far away."""
    above = (contact[0], contact[1] - step_px)
    casts = cast_card(cast.camera, scene.ground, cast.card, cast.lights[0])
    piece = cast.card.piece_at(above)
    of_piece = next((each for each in casts if cast.card.pieces[each.number] is piece), None)
    if of_piece is None:
        return None
    return _moved_from(of_piece, above, contact)


def _moved_from(cast: Cast, above: Point2, contact: Point2) -> Point2 | None:
    """Return the contact, moved by as much as its shadow moves on a card's piece."""
    canvas_from_art = np.linalg.inv(cast.art_from_canvas)
    high, low = (canvas_from_art @ (*point, 1.0) for point in (above, contact))
    if abs(high[2]) < abs(low[2]) * 1e-6 or high[2] * low[2] <= 0:
        return None
    way = high[:2] / high[2] - low[:2] / low[2]
    if float(np.abs(way).max()) > _FARTHEST_PX:
        return None
    return (contact[0] + float(way[0]), contact[1] + float(way[1]))


def _rounded(place: Point2) -> Point2:
    return (round(place[0], _PLACES), round(place[1], _PLACES))
