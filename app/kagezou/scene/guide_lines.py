"""What a cut stands on as lines over its picture, for looking at it: ground, set and feet."""

from collections.abc import Iterator
from dataclasses import dataclass
from math import cos, hypot, pi, radians, sin
from typing import Final

from kagezou.document import properties
from kagezou.document.figure_properties import STANCE
from kagezou.document.model import Document, Layer
from kagezou.document.values import value_at
from kagezou.geometry.sight import seen
from kagezou.geometry.vectors import Point2
from kagezou.scene.evaluate import camera_at, ground_at
from kagezou.scene.figure_card import feet_at
from kagezou.scene.placing import figure_box
from kagezou.scene.set_outlines import Line, set_lines

_SQUARES: Final = 4
"""So many squares of the ground lie along each side of what is drawn of it."""
_RING_PART: Final = 1 / 110
"""The radius of a ring around a contact, as part of the canvas's height."""
_RING_SIDES: Final = 24


@dataclass(frozen=True, slots=True)
class GuideLines:
    """Lines over a picture, canvas px.

    Parameters
    ----------
    edges, floor
        As of `SetLines`.
    ground
        The ground line across the picture, and squares of the ground around its position.
    contacts
        A ring around every place where a figure stands, and a plumb line under each foot in the air.
    """

    edges: tuple[Line, ...] = ()
    floor: tuple[Line, ...] = ()
    ground: tuple[Line, ...] = ()
    contacts: tuple[Line, ...] = ()


def guide_lines(document: Document, frame: int) -> GuideLines:
    """Return the lines of a frame."""
    of_set = set_lines(document, frame)
    figures = [layer for layer in document.layers if layer.joins is None and not _box_is_empty(document, layer, frame)]
    contacts = tuple(line for figure in figures for line in _contacts(document, figure, frame))
    return GuideLines(of_set.edges, of_set.floor, tuple(_ground(document, frame)), contacts)


def _box_is_empty(document: Document, layer: Layer, frame: int) -> bool:
    """Whether nothing of a figure is seen."""
    is_seen = value_at(layer.tracks, properties.VISIBLE, frame)
    return not is_seen or figure_box(document, layer.id, frame).is_empty


def _ground(document: Document, frame: int) -> Iterator[Line]:
    canvas = document.canvas
    camera, ground = camera_at(document, frame), ground_at(document, frame)
    x, y = ground.origin[:2]
    roll = radians(value_at(document.tracks, properties.GROUND_ROLL, frame))
    reach = hypot(canvas.width_px, canvas.height_px) + hypot(x, y)
    yield tuple((x + way * reach * cos(roll), y + way * reach * sin(roll)) for way in (-1.0, 1.0))
    half = canvas.height_px / 4
    steps = [half * (2 * index / _SQUARES - 1) for index in range(_SQUARES + 1)]
    for step in steps:
        yield tuple(seen(camera, ground.point(along, step)) for along in steps)
        yield tuple(seen(camera, ground.point(step, across)) for across in steps)


def _contacts(document: Document, figure: Layer, frame: int) -> Iterator[Line]:
    radius = max(document.canvas.height_px * _RING_PART, 2.0)
    standing = feet_at(document, figure, frame)
    if standing is not None:
        for foot in standing[0]:
            below = (foot.place[0], foot.ground_row)
            yield _ring(foot.place if foot.is_planted else below, radius)
            if not foot.is_planted:
                yield (foot.place, below)
    elif value_at(figure.tracks, STANCE, frame) != "line":
        for point in value_at(figure.tracks, properties.GROUNDING, frame):
            yield _ring(point, radius)


def _ring(center: Point2, radius: float) -> Line:
    turns = (2 * pi * index / _RING_SIDES for index in range(_RING_SIDES + 1))
    return tuple((center[0] + radius * cos(turn), center[1] + radius * sin(turn)) for turn in turns)
