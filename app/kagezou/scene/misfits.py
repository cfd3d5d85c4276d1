"""What stands wrongly in a frame: figures through set pieces, slivers, lamps overhead, heads off the picture."""

from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum, auto
from typing import Final

import numpy as np

from kagezou.animation.frames import spread_frames
from kagezou.document.figures import height_of
from kagezou.document.model import Document, Layer
from kagezou.document.properties import GROUNDING, VISIBLE
from kagezou.document.values import value_at
from kagezou.geometry.box import Box
from kagezou.geometry.card import Card, CardPiece, card_for, receiver_of
from kagezou.geometry.crossing import crossing_px
from kagezou.geometry.ground import place_on
from kagezou.geometry.sets.bodies import Solid
from kagezou.geometry.shadow import cast_on
from kagezou.geometry.vectors import Matrix
from kagezou.message import Message
from kagezou.scene.evaluate import camera_at, ground_at, light_at
from kagezou.scene.figure_card import Moment, card_of
from kagezou.scene.idle_receivers import idle_receivers
from kagezou.scene.long_shadows import climbing_words, leaving_words
from kagezou.scene.overhead import dark_words, joined_words
from kagezou.scene.placing import drawing_of, figure_box, shown_parts
from kagezou.scene.set_at_frame import pieces_at

_THROUGH_OF_FIGURE: Final = 0.02
"""What reaches through a face by a smaller part of the figure's height only touches it."""

_SLIVER: Final = 0.25
"""A shadow with less than this part of the area that it has without its points is a sliver."""

_MOST_FRAMES: Final = 24


class MisfitKind(Enum):
    """What is to be known."""

    POKES = auto()
    """A figure pokes through a set piece."""
    SLIVER = auto()
    """Grounding points leave next to nothing of a shadow."""
    DARK = auto()
    """A lamp in the plane of a drawing casts next to nothing."""
    JOINED = auto()
    """Nothing wrong: a lamp overhead is four, whose shadows are simplified to one."""
    LEAVES = auto()
    """The head of a long shadow falls beside the picture."""
    CLIMBS = auto()
    """A long shadow runs up the background, whose ground has no perspective."""
    IDLE = auto()
    """Something is said to receive what cannot be."""


@dataclass(frozen=True, slots=True)
class Misfit:
    """Something that stands wrongly, or otherwise than it seems.

    Parameters
    ----------
    kind
        What it is.
    figure_id
        The layer of the figure.
    piece_id
        The set piece that it pokes through, else None.
    message
        What the user should know.
    """

    kind: MisfitKind
    figure_id: str
    piece_id: str | None
    message: Message

    @property
    def about(self) -> tuple[object, ...]:
        """What it is about: of what is the same on many frames only the first is said."""
        return (self.kind, self.figure_id, self.piece_id)


def misfits_at(document: Document, frame: int) -> tuple[Misfit, ...]:
    """Return what stands wrongly on a frame: of set pieces with flat faces, and under the main light."""
    on = Moment(document, frame, camera_at(document, frame), ground_at(document, frame))
    shown = [layer for layer in document.layers if layer.joins is None and _is_shown(document, layer, frame)]
    found = ((*_pokes(on, layer), *_slivers(on, layer), *_lighting(on, layer)) for layer in shown)
    idle = (Misfit(MisfitKind.IDLE, layer_id, None, words) for layer_id, words in idle_receivers(document))
    return (*(misfit for each in found for misfit in each), *idle)


def misfits_of(document: Document) -> tuple[Misfit, ...]:
    """Return what stands wrongly on any of some frames spread over the cut, each once."""
    found: dict[tuple[object, ...], Misfit] = {}
    for frame in spread_frames(document.canvas.length_frames, _MOST_FRAMES):
        for misfit in misfits_at(document, frame):
            found.setdefault(misfit.about, misfit)
    return tuple(found.values())


def new_misfits(before: tuple[Misfit, ...], after: tuple[Misfit, ...]) -> tuple[Misfit, ...]:
    """Return those that were not there before."""
    known = {misfit.about for misfit in before}
    return tuple(misfit for misfit in after if misfit.about not in known)


def _is_shown(document: Document, layer: Layer, frame: int) -> bool:
    parts = shown_parts(document, layer.id, frame) if value_at(layer.tracks, VISIBLE, frame) else ()
    return any(drawing_of(document, part, frame) is not None for part in parts)


def _pokes(on: Moment, layer: Layer) -> Iterator[Misfit]:
    box = figure_box(on.document, layer.id, on.frame)
    least = _THROUGH_OF_FIGURE * box.height
    polygons = list(_polygons(on, card_of(on, layer, on.frame), box)) if on.document.pieces else []
    for piece in pieces_at(on.document, on.frame, on.camera, on.ground) if polygons else ():
        faces = (facet.corners for body in piece.bodies if isinstance(body, Solid) for facet in body.facets)
        if not piece.receives or not any(
            crossing_px(np.array(face), polygon, least) > least for face in faces for polygon in polygons
        ):
            continue
        words = Message(
            "{figure} pokes through {piece} on frame {frame}, which cuts its shadow: more room behind the figure, or "
            "upright = 1, keeps it whole",
            figure=layer.name,
            piece=piece.name,
            frame=on.frame,
        )
        yield Misfit(MisfitKind.POKES, layer.id, piece.id, words)


def _polygons(on: Moment, card: Card, box: Box) -> Iterator[Matrix]:
    """Yield the parts of a figure's box on its card, (N, 3), world px."""
    for piece in card.pieces:
        plane = receiver_of(on.camera, piece)
        places = [place_on(on.camera, plane, (float(x), float(y))) for x, y in piece.part_of(box)]
        if len(places) >= 3 and None not in places:
            yield np.array(places, np.float64)


def _slivers(on: Moment, layer: Layer) -> Iterator[Misfit]:
    card = card_of(on, layer, on.frame)
    if not card.is_tilt_measured or card.merged:
        return
    points = value_at(layer.tracks, GROUNDING, on.frame)
    x, y = (sum(axis) / len(points) for axis in zip(*points, strict=True))
    box = figure_box(on.document, layer.id, on.frame)
    flat = card_for(on.camera, on.ground, ((x, y),), 0.0, height_of(layer, on.frame), card.upright)
    area, whole = _shadow_area(on, card, box), _shadow_area(on, flat, box)
    if area is None or not whole or area / whole >= _SLIVER:
        return
    words = Message(
        "{figure}: on frame {frame} its two grounding points leave {percent:.0f} % of the shadow that one has; feet or "
        "one point keep it whole",
        figure=layer.name,
        frame=on.frame,
        percent=100 * area / whole,
    )
    yield Misfit(MisfitKind.SLIVER, layer.id, None, words)


def _lighting(on: Moment, layer: Layer) -> Iterator[Misfit]:
    asked = (
        (MisfitKind.DARK, dark_words),
        (MisfitKind.JOINED, joined_words),
        (MisfitKind.LEAVES, leaving_words),
        (MisfitKind.CLIMBS, climbing_words),
    )
    for kind, ask in asked:
        words = ask(on, layer)
        if words is not None:
            yield Misfit(kind, layer.id, None, words)


def _shadow_area(on: Moment, card: Card, box: Box) -> float | None:
    """Return the area, canvas px², of the shadow of a figure's box on the ground; None where it has no end."""
    areas = [_area_of(on, piece, box) for piece in card.pieces]
    known = [area for area in areas if area is not None]
    return sum(known) if len(known) == len(areas) else None


def _area_of(on: Moment, piece: CardPiece, box: Box) -> float | None:
    polygon = piece.part_of(box)
    cast = cast_on(on.camera, on.ground, piece, light_at(on.document, on.frame, on.ground))
    if cast is None or len(polygon) == 0:
        return 0.0
    x, y, w = np.linalg.inv(cast.art_from_canvas) @ np.column_stack([polygon, np.ones(len(polygon))]).T
    if (w <= 1e-9 * np.abs(w).max()).any():
        return None
    x, y = x / w, y / w
    return float(abs((x * np.roll(y, -1) - y * np.roll(x, -1)).sum()) / 2)
