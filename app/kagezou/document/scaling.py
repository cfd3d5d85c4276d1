"""The same cut, smaller: for previews that look alike at a part of the resolution."""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from math import ceil, floor
from types import MappingProxyType
from typing import cast

from kagezou.animation.ease import Ease
from kagezou.animation.track import Key, Track, Value
from kagezou.document.figure_properties import ANCHOR
from kagezou.document.model import Canvas, Document, Drawing, Layer, Piece, Tracks, drawing_offset, drawing_size
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER, OF_PIECE
from kagezou.document.property import AnyProperty, Usual
from kagezou.geometry.box import Box, centred_offset
from kagezou.geometry.vectors import Point2
from kagezou.standing.foot import FootPin

_POWERS = MappingProxyType({"px": 1, "px²": 2})
"""Units of lengths and areas: how often a size divides them."""


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
    canvas = document.canvas
    return replace(
        document,
        canvas=replace(canvas, width_px=canvas.width_px // divisor, height_px=canvas.height_px // divisor),
        layers=tuple(_layer(layer, canvas, divisor) for layer in document.layers),
        tracks=_tracks(document.tracks, OF_DOCUMENT, divisor),
        pieces=tuple(_piece(piece, divisor) for piece in document.pieces),
    )


def _layer(layer: Layer, canvas: Canvas, divisor: int) -> Layer:
    figure = _smaller_box(layer.figure, divisor)
    offset = drawing_offset(canvas, layer)
    drawings = tuple(_drawing(drawing, canvas, divisor) for drawing in layer.cels.drawings)
    cels = layer.cels if drawings == layer.cels.drawings else replace(layer.cels, drawings=drawings)
    tracks = dict(layer.tracks)
    if ANCHOR.name in tracks:
        tracks[ANCHOR.name] = _moved(tracks[ANCHOR.name], offset)
    return replace(layer, cels=cels, figure=figure, tracks=_tracks(tracks, OF_LAYER, divisor))


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


def _piece(piece: Piece, divisor: int) -> Piece:
    return replace(piece, tracks=_tracks(piece.tracks, OF_PIECE, divisor))


def _tracks(tracks: Tracks, table: Mapping[str, AnyProperty], divisor: int) -> Tracks:
    measures = {name: prop for name, prop in table.items() if prop.unit in _POWERS}
    # What has no track has its default, which is a length as well; what is usual for the cut follows its canvas.
    whole = {
        name: tracks.get(name, Track(prop.default))
        for name, prop in measures.items()
        if name in tracks or prop.usual is Usual.DEFAULT
    }
    smaller = {name: _track(track, divisor ** _POWERS[measures[name].unit]) for name, track in whole.items()}
    return MappingProxyType({**tracks, **smaller})


def _track(track: Track, divisor: int) -> Track:
    keys = tuple(_key(key, divisor) for key in track.keys)
    return Track(_divided(track.constant, divisor), keys)


def _key(key: Key, divisor: int) -> Key:
    return replace(
        key,
        value=_divided(key.value, divisor),
        ease_in=_eases(key.ease_in, divisor),
        ease_out=_eases(key.ease_out, divisor),
    )


def _eases(eases: Iterable[Ease], divisor: int) -> tuple[Ease, ...]:
    return tuple(replace(ease, speed=ease.speed / divisor) for ease in eases)


def _divided(value: Value, divisor: int) -> Value:
    if isinstance(value, tuple):
        return cast("Value", tuple(_divided(part, divisor) for part in value))
    return value / divisor if isinstance(value, float) else value
