"""How large an imported set is: told by two of its points and by what lies between them."""

from math import dist
from typing import Final

from kagezou.document.edits import set_value
from kagezou.document.figures import height_of
from kagezou.document.model import Document
from kagezou.document.set_properties import PIECE_SCALE
from kagezou.errors import UsageProblem
from kagezou.geometry.vectors import Vector3
from kagezou.importing.set_placing import of_piece
from kagezou.message import Message

FIGURE_METRES: Final = 1.6
"""How tall a character is taken to be where lengths are given in metres."""


def figure_height(document: Document) -> float:
    """Return the height of the tallest character, px; without one half the canvas, as a character would be drawn."""
    return float(max((height_of(layer, 1) for layer in document.layers), default=document.canvas.height_px / 2))


def sized(
    document: Document, piece_id: str, between: tuple[Vector3, Vector3], figure_heights: float, frame: int
) -> Document:
    """Return the document in which two points of a set lie a number of figure heights apart.

    Parameters
    ----------
    document, piece_id
        The set, which keeps standing where it does.
    between
        The two points, in the units of its file.
    figure_heights
        The length between them, in heights of the tallest character.
    frame
        Where the scale is set, if it is keyed.

    Raises
    ------
    UsageProblem
        The points are one, or the length makes no sense.
    """
    length = dist(*between)
    if length <= 0 or figure_heights <= 0:
        raise UsageProblem(Message("a size is given by two different points of the set and a length over 0"))
    scale = figure_heights * figure_height(document) / length
    return set_value(document, of_piece(PIECE_SCALE, piece_id), scale, frame)
