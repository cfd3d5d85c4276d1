"""The same cut, smaller: for previews that look alike at a part of the resolution."""

from dataclasses import replace
from math import ceil, floor
from typing import cast

from kagezou.animation.track import Track, Value
from kagezou.document.figure_properties import ANCHOR
from kagezou.document.lengths import LengthMap
from kagezou.document.model import Canvas, Document, Drawing, Layer, drawing_offset, drawing_size
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER, OF_PIECE
from kagezou.geometry.box import Box, centred_offset
from kagezou.geometry.vectors import Point2
from kagezou.standing.foot import FootPin


def usable_divisor(canvas: Canvas, wanted: int) -> int:
    """Return the largest divisor up to ``wanted`` by which both sides of the canvas can be divided; 1 always can."""
    return next(each for each in range(wanted, 0, -1) if canvas.width_px % each == canvas.height_px % each == 0)


def scaled(document: Document, divisor: int) -> Document:
    """Return the document with every length divided; its drawings must be drawn as much smaller.

    Parameters
    ----------
    document
        The document.
    divisor
        A divisor of both sides of the canvas.
    """
    if divisor == 1:
        return document
    canvas, smaller = document.canvas, LengthMap(1 / divisor)
    return replace(
        document,
        canvas=replace(canvas, width_px=canvas.width_px // divisor, height_px=canvas.height_px // divisor),
        layers=tuple(_layer(layer, canvas, divisor) for layer in document.layers),
        tracks=smaller.tracks(document.tracks, OF_DOCUMENT),
        pieces=tuple(replace(piece, tracks=smaller.tracks(piece.tracks, OF_PIECE)) for piece in document.pieces),
    )


def _layer(layer: Layer, canvas: Canvas, divisor: int) -> Layer:
    figure = _smaller_box(layer.figure, divisor)
    offset = drawing_offset(canvas, layer)
    drawings = tuple(_drawing(drawing, canvas, divisor) for drawing in layer.cels.drawings)
    cels = layer.cels if drawings == layer.cels.drawings else replace(layer.cels, drawings=drawings)
    tracks = dict(layer.tracks)
    if ANCHOR.name in tracks:
        tracks[ANCHOR.name] = _moved(tracks[ANCHOR.name], offset)
    return replace(layer, cels=cels, figure=figure, tracks=LengthMap(1 / divisor).tracks(tracks, OF_LAYER))


def _smaller_box(box: Box, divisor: int) -> Box:
    """Return the smallest box that holds another one on a canvas of a part of the size."""
    corner = (floor(box.left / divisor), floor(box.top / divisor))
    return Box(*corner, ceil(box.right / divisor), ceil(box.bottom / divisor))


def _drawing(drawing: Drawing, canvas: Canvas, divisor: int) -> Drawing:
    """Return the drawing with its places counted from the corner of the smaller canvas, where its pixels begin."""
    if drawing.size_px is None and drawing.feet is None and drawing.figure is None:
        return drawing
    offset = centred_offset(canvas.box, *drawing_size(canvas, drawing))
    feet = drawing.feet and tuple(replace(foot, place=_place(foot.place, offset, divisor)) for foot in drawing.feet)
    pins = tuple(_pin(pin, offset, divisor) for pin in drawing.pins)
    figure = drawing.figure and _smaller_box(drawing.figure.moved(*offset), divisor)
    return replace(drawing, size_px=None, figure=figure, feet=feet, pins=pins)


def _pin(pin: FootPin, offset: tuple[int, int], divisor: int) -> FootPin:
    row = None if pin.ground_row is None else (pin.ground_row + offset[1]) / divisor
    return replace(pin, place=pin.place and _place(pin.place, offset, divisor), ground_row=row)


def _place(place: Point2, offset: tuple[int, int], divisor: int) -> Point2:
    return ((place[0] + offset[0]) / divisor, (place[1] + offset[1]) / divisor)


def _moved(track: Track, offset: tuple[int, int]) -> Track:
    def moved(value: Value) -> Value:
        x, y = cast("Point2", value)
        return (x + offset[0], y + offset[1])

    keys = tuple(replace(key, value=moved(key.value)) for key in track.keys)
    return Track(moved(track.constant), keys)
