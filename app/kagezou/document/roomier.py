"""The same cut on a larger canvas: for pictures that show what leaves the canvas, too."""

from dataclasses import replace
from types import MappingProxyType

from kagezou.document.lengths import LengthMap, sized, widened
from kagezou.document.model import Canvas, Document, Layer
from kagezou.document.properties import FOV, OF_DOCUMENT, OF_LAYER, OF_PIECE


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
    way = LengthMap(shift=(across_px, down_px))
    tracks = dict(way.tracks(document.tracks, OF_DOCUMENT))
    if FOV.name in tracks:
        tracks[FOV.name] = widened(tracks[FOV.name], larger.height_px / canvas.height_px)
    return replace(
        document,
        canvas=larger,
        behind=sized(document.behind, canvas),
        layers=tuple(_layer(layer, canvas, (across_px, down_px)) for layer in document.layers),
        tracks=MappingProxyType(tracks),
        pieces=tuple(replace(piece, tracks=way.tracks(piece.tracks, OF_PIECE)) for piece in document.pieces),
    )


def _layer(layer: Layer, canvas: Canvas, way: tuple[int, int]) -> Layer:
    tracks = LengthMap(shift=way).tracks(layer.tracks, OF_LAYER)
    return replace(layer, cels=sized(layer.cels, canvas), figure=layer.figure.moved(*way), tracks=tracks)
