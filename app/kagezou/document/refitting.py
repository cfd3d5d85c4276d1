"""A cut on a canvas of another size: what lay on the old one stays, goes to the middle or is scaled with it."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from enum import StrEnum
from types import MappingProxyType
from typing import Final, cast

from kagezou.animation.track import Track, Value
from kagezou.document.figure_properties import ANCHOR, BACKGROUND_POSITION, POSITION, SCALE
from kagezou.document.lengths import LengthMap, multiplied, sized, widened
from kagezou.document.model import BroughtLight, Canvas, Document, Layer, Piece, Tracks, drawing_offset, drawing_size
from kagezou.document.properties import FOV, OF_DOCUMENT, OF_LAYER, OF_PIECE
from kagezou.document.property import MAX_COORDINATE_PX, AnyProperty, Kind
from kagezou.geometry.box import centred_offset
from kagezou.geometry.vanishing import Line, VanishingLines
from kagezou.geometry.vectors import Point2

_SAME_PX: Final = 1e-6


class Refit(StrEnum):
    """What becomes of drawings, light, ground and set on a canvas of another size."""

    STAY = "stay"
    """They stay at the top left."""
    CENTRE = "centre"
    """They go to the middle."""
    SCALE = "scale"
    """They become larger or smaller with it, as far as all of the old canvas is seen, in the middle."""


def refit_map(canvas: Canvas, width_px: int, height_px: int, refit: Refit) -> LengthMap:
    """Return where the lengths and places of a canvas go on one of another size.

    What is not scaled moves by whole px, so that no drawing is resampled.
    """
    more = (width_px - canvas.width_px, height_px - canvas.height_px)
    match refit:
        case Refit.STAY:
            return LengthMap()
        case Refit.CENTRE:
            return LengthMap(shift=(more[0] // 2, more[1] // 2))
        case Refit.SCALE:
            factor = min(width_px / canvas.width_px, height_px / canvas.height_px)
            left = (width_px - factor * canvas.width_px, height_px - factor * canvas.height_px)
            return LengthMap(factor, (left[0] / 2, left[1] / 2))


@dataclass(frozen=True, slots=True)
class Refitted:
    """A document on a canvas of another size, and how many of its values were kept to their range."""

    document: Document
    limited: int


def refitted(document: Document, width_px: int, height_px: int, refit: Refit) -> Refitted:
    """Return a document on a canvas of another size; drawings lie pixel for pixel where they lay, or are scaled.

    The picture of the background has a place and no scale: it keeps its size. The eye of a camera with perspective
    keeps its distance and looks at the middle of the new canvas.
    """
    canvas = document.canvas
    if (width_px, height_px) == (canvas.width_px, canvas.height_px):
        return Refitted(document, 0)
    how = _Refitting(
        canvas, replace(canvas, width_px=width_px, height_px=height_px), refit_map(canvas, width_px, height_px, refit)
    )
    return Refitted(how.document(document), how.limited)


class _Refitting:
    """One change of the canvas; counts what it keeps to its range."""

    def __init__(self, old: Canvas, new: Canvas, how: LengthMap) -> None:
        self._old, self._new, self._how = old, new, how
        self.limited = 0

    def document(self, document: Document) -> Document:
        brought, vanishing = document.brought_light, document.vanishing
        return replace(
            document,
            canvas=self._new,
            behind=sized(document.behind, self._old),
            layers=tuple(self._layer(layer) for layer in document.layers),
            tracks=self._scene(document),
            pieces=tuple(self._piece(piece) for piece in document.pieces),
            vanishing=vanishing and self._lines(vanishing),
            brought_light=brought
            and BroughtLight(self._as_kept(brought.tracks, OF_DOCUMENT), self._as_kept(brought.before, OF_DOCUMENT)),
        )

    def _scene(self, document: Document) -> Tracks:
        tracks = dict(self._how.tracks(document.tracks, OF_DOCUMENT))
        if FOV.name in tracks:
            times = self._new.height_px / (self._old.height_px * self._how.factor)
            tracks[FOV.name] = widened(tracks[FOV.name], times)
        if document.behind.drawings:
            size = drawing_size(self._old, document.behind.drawings[0])
            # What is scaled lies in the middle of the new canvas as it lies there by itself.
            aside = _parity(self._old, size, self._new) if self._how.factor == 1.0 else (0.0, 0.0)
            self._put_place(tracks, BACKGROUND_POSITION, document.tracks, aside)
        return self._within(tracks, OF_DOCUMENT)

    def _layer(self, layer: Layer) -> Layer:
        layer = replace(layer, cels=sized(layer.cels, self._old))
        before, after = drawing_offset(self._old, layer), drawing_offset(self._new, layer)
        tracks = dict(self._how.tracks(layer.tracks, OF_LAYER))
        self._put_place(tracks, POSITION, layer.tracks, (0.0, 0.0))
        middle = self._old.box.middle
        aside = _parity(self._old, drawing_size(self._old, next(iter(layer.cels.drawings), None)), self._new)
        if ANCHOR.name in layer.tracks:
            # A point of the drawing, whose pixels are as they were.
            tracks[ANCHOR.name] = layer.tracks[ANCHOR.name]
        elif aside != (0.0, 0.0):
            tracks[ANCHOR.name] = Track((middle[0] - before[0], middle[1] - before[1]))
        if self._how.factor != 1.0:
            as_drawn = layer.tracks.get(SCALE.name, Track(SCALE.default))
            tracks[SCALE.name] = multiplied(as_drawn, self._how.factor)
        figure = layer.figure.moved(after[0] - before[0], after[1] - before[1])
        return replace(layer, figure=figure, tracks=self._within(tracks, OF_LAYER))

    def _piece(self, piece: Piece) -> Piece:
        return replace(piece, tracks=self._within(self._how.tracks(piece.tracks, OF_PIECE), OF_PIECE))

    def _put_place(self, tracks: dict[str, Track], prop: AnyProperty, before: Tracks, aside: Point2) -> None:
        """Put a place that is usually the middle of the canvas where it was, unless it would be there by itself."""
        if prop.name in before:
            track = self._how.track(prop, before[prop.name])
        else:
            track = Track(self._how.point(self._old.box.middle))
        moved = multiplied(track, 1.0, aside)
        wanted, usual = cast("Point2", moved.constant), self._new.box.middle
        is_usual = max(abs(wanted[0] - usual[0]), abs(wanted[1] - usual[1])) < _SAME_PX
        if prop.name in before or not is_usual:
            tracks[prop.name] = moved

    def _lines(self, lines: VanishingLines) -> VanishingLines:
        def line(each: Line) -> Line:
            return (_kept(self._how.point(each[0])), _kept(self._how.point(each[1])))

        (a, b), (c, d) = lines.first, lines.second
        return VanishingLines((line(a), line(b)), (line(c), line(d)))

    def _as_kept(self, tracks: Tracks, table: Mapping[str, AnyProperty]) -> Tracks:
        """Return tracks that are kept aside: only those that are there."""
        return self._within({name: self._how.track(table[name], track) for name, track in tracks.items()}, table)

    def _within(self, tracks: Mapping[str, Track], table: Mapping[str, AnyProperty]) -> Tracks:
        kept: dict[str, Track] = {}
        for name, track in tracks.items():
            inside = _track_within(table[name], track)
            self.limited += inside != track
            kept[name] = track if inside == track else inside
        return MappingProxyType(kept)


def _parity(old: Canvas, size: tuple[int, int], new: Canvas) -> Point2:
    """Return by which part of a px a centred drawing lies otherwise about the middle than it did: 0 or a half."""
    found = []
    for canvas in (old, new):
        offset, middle = centred_offset(canvas.box, *size), canvas.box.middle
        found.append((offset[0] - middle[0], offset[1] - middle[1]))
    (x, y), (other_x, other_y) = found
    return (x - other_x, y - other_y)


def _track_within(prop: AnyProperty, track: Track) -> Track:
    keys = tuple(replace(key, value=_value_within(prop, key.value)) for key in track.keys)
    return Track(_value_within(prop, track.constant), keys)


def _value_within(prop: AnyProperty, value: Value) -> Value:
    if prop.kind is Kind.NUMBER:
        return min(max(cast("float", value), prop.low), prop.high)
    if prop.kind in (Kind.POINT, Kind.PLACE):
        return tuple(_coordinate(number) for number in cast("tuple[float, ...]", value))
    if prop.kind is Kind.POINTS:
        return tuple(_kept(point) for point in cast("tuple[Point2, ...]", value))
    return value


def _kept(point: Point2) -> Point2:
    return (_coordinate(point[0]), _coordinate(point[1]))


def _coordinate(number: float) -> float:
    return min(max(number, -MAX_COORDINATE_PX), MAX_COORDINATE_PX)
