"""The card a figure stands on: by its feet, its grounding points or the ground line (spec 2; figures)."""

from collections.abc import Sequence
from dataclasses import dataclass

from kagezou.document.figure_properties import STANCE, UPRIGHT
from kagezou.document.figures import height_of
from kagezou.document.model import Document, Layer
from kagezou.document.properties import GROUNDING, TILT
from kagezou.document.values import value_at
from kagezou.geometry.camera import Camera
from kagezou.geometry.card import Card, card_for
from kagezou.geometry.ground import Plane
from kagezou.geometry.relief import Foothold, relief_card
from kagezou.scene.stances import FigureStances, stances_of


@dataclass(frozen=True, slots=True)
class Moment:
    """A frame of a document, and what it is seen with and stands on."""

    document: Document
    frame: int
    camera: Camera
    ground: Plane


def card_at(document: Document, layer: Layer, frame: int, camera: Camera, ground: Plane) -> Card:
    """Return the card a layer's figure stands on at a frame."""
    figure = layer if layer.joins is None else document.layer(layer.joins)
    return card_of(Moment(document, frame, camera, ground), figure, frame)


def card_of(on: Moment, figure: Layer, since: int, stood_up: float = 0.0) -> Card:
    """Return the card of a figure.

    Parameters
    ----------
    on
        The frame; feet are where it shows them.
    figure
        A layer with a figure of its own.
    since
        The frame whose grounding points, tilt and the like count: they may wait for the next drawing.
    stood_up
        How much more it is stood up than the figure's own card, 0 to 1 for all the way.
    """
    standing = feet_at(on.document, figure, on.frame, since)
    if standing is not None:
        return card_on_feet(on, figure, since, standing, stood_up)
    tilt, upright = _lean_at(figure, since, stood_up)
    is_on_line = value_at(figure.tracks, STANCE, since) == "line"
    points = () if is_on_line else value_at(figure.tracks, GROUNDING, since)
    return card_for(on.camera, on.ground, points, tilt, height_of(figure, since), upright)


def card_on_feet(
    on: Moment, figure: Layer, since: int, standing: tuple[Sequence[Foothold], float], stood_up: float = 0.0
) -> Card:
    """Return the card of a figure as :func:`card_of` does, on given feet; ``standing`` are they and its height, px."""
    return relief_card(on.camera, on.ground, *standing, *_lean_at(figure, since, stood_up))


def _lean_at(figure: Layer, since: int, stood_up: float) -> tuple[float, float]:
    """Return by which angle the card is turned, and how far it is stood up, 0 to 1."""
    tilt, upright = (value_at(figure.tracks, prop, since) for prop in (TILT, UPRIGHT))
    return tilt, upright + stood_up * (1 - upright)


def feet_at(
    document: Document, figure: Layer, frame: int, since: int | None = None
) -> tuple[tuple[Foothold, ...], float] | None:
    """Return the feet that a figure stands on at a frame and its height, px; None where it does not stand on feet.

    Keys and points of ``grounding`` win over feet.
    """
    since = frame if since is None else since
    if value_at(figure.tracks, STANCE, since) != "feet" or value_at(figure.tracks, GROUNDING, since):
        return None
    found = stances_of(document, figure.id)
    footholds = () if found is None else _footholds(found, frame)
    return (footholds, found.height_px) if found is not None and footholds else None


def _footholds(found: FigureStances, frame: int) -> tuple[Foothold, ...]:
    """Return the feet of a frame; where none is seen the ground of the nearest drawing that shows some."""
    feet = found.at(frame).feet
    if feet:
        return tuple(Foothold(foot.place, foot.ground_row, foot.is_planted) for foot in feet)
    shown = [(start, stance) for start, stance in zip(found.frames, found.stances, strict=True) if stance.feet]
    if not shown:
        return ()
    _, nearest = min(shown, key=lambda each: abs(each[0] - frame))
    x, row = (_mean(numbers) for numbers in ([f.place[0] for f in nearest.feet], [f.ground_row for f in nearest.feet]))
    return (Foothold((x, row), row, is_planted=False),)


def _mean(numbers: Sequence[float]) -> float:
    return sum(numbers) / len(numbers)
