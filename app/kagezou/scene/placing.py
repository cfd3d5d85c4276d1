"""How layers lay their drawings on the canvas, frame by frame."""

from typing import Final

from kagezou.document.figure_properties import ANCHOR, BACKGROUND_POSITION, PLACEMENT_LINES, POSITION, ROTATION, SCALE
from kagezou.document.figures import parts_of
from kagezou.document.model import Document, Layer, drawing_offset
from kagezou.document.properties import VISIBLE
from kagezou.document.values import value_at
from kagezou.geometry.box import Box, around, centred_offset
from kagezou.geometry.placement import Placement, around_placed, canvas_from_centred
from kagezou.scene.scene import PlacedDrawing

PLACING: Final = frozenset(line.name for line in PLACEMENT_LINES)
"""The names of the properties that move drawings."""


def placement_at(document: Document, layer: Layer, frame: float) -> Placement | None:
    """Return how a layer moves its drawings on a frame, None where they lie centred, pixel for pixel."""
    if layer.tracks.keys().isdisjoint(PLACING):
        return None
    placement = whole_placement(document, layer, frame)
    return placement if placement.moves else None


def whole_placement(document: Document, layer: Layer, frame: float) -> Placement:
    """Return the same also where it moves nothing."""
    middle, offset = document.canvas.box.middle, drawing_offset(document.canvas, layer)
    position = value_at(layer.tracks, POSITION, frame) if POSITION.name in layer.tracks else middle
    anchor = middle
    if ANCHOR.name in layer.tracks:
        x, y = value_at(layer.tracks, ANCHOR, frame)
        anchor = (x + offset[0], y + offset[1])
    sx, sy = value_at(layer.tracks, SCALE, frame)
    return Placement(position, anchor, (sx / 100, sy / 100), value_at(layer.tracks, ROTATION, frame))


def drawing_of(document: Document, layer: Layer, frame: int) -> PlacedDrawing | None:
    """Return what a layer shows on a frame and how that lies on the canvas; None where nothing is seen."""
    drawing, placement = layer.cels.drawing_at(frame), placement_at(document, layer, frame)
    if drawing is None or (placement is not None and not placement.is_seen):
        return None
    return PlacedDrawing(drawing.source, placement)


def background_at(document: Document, frame: int) -> PlacedDrawing | None:
    """Return what is seen of the background on a frame and how it lies on the canvas; None for nothing."""
    drawing = document.behind.drawing_at(frame)
    if drawing is None:
        return None
    if BACKGROUND_POSITION.name not in document.tracks:
        return PlacedDrawing(drawing.source)
    placement = Placement(value_at(document.tracks, BACKGROUND_POSITION, frame), document.canvas.box.middle)
    return PlacedDrawing(drawing.source, placement if placement.moves else None)


def shown_parts(document: Document, figure_id: str, frame: int) -> tuple[Layer, ...]:
    """Return the layers of a figure whose cels cast on a frame: its own, and those of its parts that are visible."""
    own, *others = parts_of(document, figure_id)
    return (own, *(part for part in others if value_at(part.tracks, VISIBLE, frame)))


def figure_box(document: Document, figure_id: str, frame: int) -> Box:
    """Return the box of a figure as it is seen on a frame, canvas px; that of its first drawing where it is not."""
    parts = shown_parts(document, figure_id, frame)
    found = around(*(_box_of(document, part, frame) for part in parts))
    return document.layer(figure_id).figure if found is None else found


def _box_of(document: Document, layer: Layer, frame: int) -> Box | None:
    drawing = layer.cels.drawing_at(frame)
    if drawing is None:
        return None
    box = layer.figure
    if drawing.figure is not None:
        size = drawing.size_px or (document.canvas.width_px, document.canvas.height_px)
        box = drawing.figure.moved(*centred_offset(document.canvas.box, *size))
    placement = placement_at(document, layer, frame)
    return box if placement is None else around_placed(box, canvas_from_centred(placement))
