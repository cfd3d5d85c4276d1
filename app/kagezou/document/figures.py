"""Figures of several layers."""

from kagezou.document.model import Document, Layer


def parts_of(document: Document, figure_id: str) -> tuple[Layer, ...]:
    """Return the layer of a figure and those that join it, from bottom to top, the figure's own layer first."""
    joined = (layer for layer in document.layers if layer.joins == figure_id)
    return (document.layer(figure_id), *joined)
