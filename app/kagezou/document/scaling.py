"""The same cut, smaller: for previews that look alike at a part of the resolution."""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from math import ceil, floor
from types import MappingProxyType
from typing import cast

from kagezou.animation.ease import Ease
from kagezou.animation.track import Key, Track, Value
from kagezou.document.model import Canvas, Document, Layer, Piece, Tracks
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER, OF_PIECE
from kagezou.document.property import AnyProperty
from kagezou.geometry.box import Box

_LENGTH = "px"


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
        layers=tuple(_layer(layer, divisor) for layer in document.layers),
        tracks=_tracks(document.tracks, OF_DOCUMENT, divisor),
        pieces=tuple(_piece(piece, divisor) for piece in document.pieces),
    )


def _layer(layer: Layer, divisor: int) -> Layer:
    box = layer.figure
    corner = (floor(box.left / divisor), floor(box.top / divisor))
    figure = Box(*corner, ceil(box.right / divisor), ceil(box.bottom / divisor))
    return replace(layer, figure=figure, tracks=_tracks(layer.tracks, OF_LAYER, divisor))


def _piece(piece: Piece, divisor: int) -> Piece:
    return replace(piece, tracks=_tracks(piece.tracks, OF_PIECE, divisor))


def _tracks(tracks: Tracks, table: Mapping[str, AnyProperty], divisor: int) -> Tracks:
    lengths = {name: prop for name, prop in table.items() if prop.unit == _LENGTH}
    # What has no track has its default, which is a length as well.
    whole = {name: tracks.get(name, Track(prop.default)) for name, prop in lengths.items()}
    return MappingProxyType({**tracks, **{name: _track(track, divisor) for name, track in whole.items()}})


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
