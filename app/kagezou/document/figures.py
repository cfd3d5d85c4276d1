"""Figures of several layers."""

from kagezou.document.figure_properties import SCALE
from kagezou.document.model import Document, Layer
from kagezou.document.values import value_at


def parts_of(document: Document, figure_id: str) -> tuple[Layer, ...]:
    """Return the layer of a figure and those that join it, from bottom to top, the figure's own layer first."""
    joined = (layer for layer in document.layers if layer.joins == figure_id)
    return (document.layer(figure_id), *joined)


def height_of(figure: Layer, frame: float) -> float:
    """Return how tall the figure of a layer's first drawing is as the layer scales it on a frame, canvas px."""
    _, percent = value_at(figure.tracks, SCALE, frame)
    return figure.figure.height * abs(percent) / 100
