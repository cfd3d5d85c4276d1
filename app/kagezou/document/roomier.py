"""The same cut on a larger canvas: for pictures that show what leaves the canvas, too."""

from collections.abc import Mapping
from dataclasses import replace
from math import atan, degrees, radians, tan
from types import MappingProxyType
from typing import Final, cast

from kagezou.animation.track import Track, Value
from kagezou.document.figure_properties import BACKGROUND_POSITION, POSITION
from kagezou.document.model import Canvas, Cels, Document, Layer, Piece, Tracks
from kagezou.document.properties import FOV, GROUND_POSITION, GROUNDING, LIGHT_POSITION, OF_DOCUMENT, OF_LAYER, OF_PIECE
from kagezou.document.property import AnyProperty, Usual
from kagezou.document.set_properties import PIECE_POSITION

PLACES: Final = frozenset((GROUND_POSITION, LIGHT_POSITION, BACKGROUND_POSITION, POSITION, GROUNDING, PIECE_POSITION))
"""The properties whose values are places on the canvas; an anchor is one in its drawing."""


def roomier(document: Document, across_px: int, down_px: int) -> Document:
    """Return the document with margins around its canvas, in which everything looks as it does without.

    Parameters
    ----------
    document
        The document.
    across_px, down_px
        What is added to the left and to the right, above and below; 0 or more.
    """
    canvas = document.canvas
    larger = replace(canvas, width_px=canvas.width_px + 2 * across_px, height_px=canvas.height_px + 2 * down_px)
    way = (across_px, down_px)
    tracks = dict(_moved_tracks(document.tracks, OF_DOCUMENT, way))
    if FOV.name in tracks:
        tracks[FOV.name] = _wider(tracks[FOV.name], larger.height_px / canvas.height_px)
    return replace(
        document,
        canvas=larger,
        behind=_sized(document.behind, canvas),
        layers=tuple(_layer(layer, canvas, way) for layer in document.layers),
        tracks=MappingProxyType(tracks),
        pieces=tuple(_piece(piece, way) for piece in document.pieces),
    )


def _layer(layer: Layer, canvas: Canvas, way: tuple[int, int]) -> Layer:
    tracks = _moved_tracks(layer.tracks, OF_LAYER, way)
    return replace(layer, cels=_sized(layer.cels, canvas), figure=layer.figure.moved(*way), tracks=tracks)


def _piece(piece: Piece, way: tuple[int, int]) -> Piece:
    return replace(piece, tracks=_moved_tracks(piece.tracks, OF_PIECE, way))


def _sized(cels: Cels, canvas: Canvas) -> Cels:
    """Return cels whose drawings of unknown size are as large as the canvas was, for which they count."""
    size = (canvas.width_px, canvas.height_px)
    return replace(cels, drawings=tuple(replace(each, size_px=each.size_px or size) for each in cels.drawings))


def _moved_tracks(tracks: Tracks, table: Mapping[str, AnyProperty], way: tuple[int, int]) -> Tracks:
    # What has no track has its default, which is a place as well; what is usual for the cut follows its canvas.
    places = {
        name: tracks.get(name, Track(prop.default))
        for name, prop in table.items()
        if prop in PLACES and (name in tracks or prop.usual is Usual.DEFAULT)
    }
    return MappingProxyType({**tracks, **{name: _moved_track(track, way) for name, track in places.items()}})


def _moved_track(track: Track, way: tuple[int, int]) -> Track:
    keys = tuple(replace(key, value=_moved(key.value, way)) for key in track.keys)
    return Track(_moved(track.constant, way), keys)


def _moved(value: Value, way: tuple[int, int]) -> Value:
    """Return a point, a place, of which the depth stays, or points, moved."""
    numbers = cast("tuple[float | tuple[float, float], ...]", value)
    if not numbers or isinstance(numbers[0], tuple):
        return cast("Value", tuple(_moved(cast("Value", point), way) for point in numbers))
    x, y, *depth = cast("tuple[float, ...]", numbers)
    return cast("Value", (x + way[0], y + way[1], *depth))


def _wider(track: Track, times: float) -> Track:
    """Return the field of view that sees so many times the height from the same eye."""

    def wider(value: Value) -> float:
        return 2 * degrees(atan(times * tan(radians(cast("float", value)) / 2)))

    return Track(wider(track.constant), tuple(replace(key, value=wider(key.value)) for key in track.keys))
