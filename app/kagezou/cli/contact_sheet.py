"""Contact sheets: a character in a row of pictures, one more adjustment in each, as the paper shows its steps."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import reduce
from math import ceil
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kagezou.document import properties
from kagezou.document.address import Address
from kagezou.document.edits import set_constant
from kagezou.document.model import Document
from kagezou.document.property import Property
from kagezou.document.values import value_at
from kagezou.export.portraits import Portraits
from kagezou.export.shrinking import shrunk
from kagezou.geometry.box import Box
from kagezou.importing.staging import CharacterSource, Imported, new_document
from kagezou.io.images.reading import Steps
from kagezou.render.prepare.backdrop import Backdrop

CELL_PX: Final = 320
_GAP_PX: Final = 6
_GREY: Final = 160
_ROOM: Final = 1.3

Picture = NDArray[np.uint8]
Adjust = Callable[[Document], Document]


def roomy(sources: Sequence[CharacterSource]) -> Imported:
    """Return a new cut with room around the drawings, so that its lamp stands well beside them."""
    drawn = new_document(sources).document.canvas
    side = ceil(_ROOM * max(drawn.width_px, drawn.height_px))
    return new_document(sources, size=(side, side))


def steps_of(document: Document) -> Iterator[tuple[str, Document]]:
    """Yield the name of each step and the cut after it: the paper's Figures 7 and 8, 11 and 12."""
    yield "initial", document
    for name, adjust in _STEPS.items():
        document = adjust(document)
        yield name, document


def sheet_of(documents: Sequence[Document], frame: int = 1) -> Picture:
    """Return rows of cells (H, W, 4), one row a cut, with the context that is current.

    In a row every cell shows the same place, so that the first figure and its shadow are whole in all of them.
    """
    return framed([np.concatenate(_row(cut, frame), axis=1) for cut in documents])


def framed(rows: Sequence[Picture]) -> Picture:
    """Return rows of cells, all as wide, under one another without the gap beyond the last ones."""
    return np.ascontiguousarray(np.concatenate(rows, axis=0)[:-_GAP_PX, :-_GAP_PX])


def _row(cut: Document, frame: int) -> list[Picture]:
    steps = [document for _, document in steps_of(cut)]
    portraits = Portraits(cut, cut.layers[0].id, frame, CELL_PX)
    around = reduce(Box.union, (portraits.box(each) for each in steps))
    backdrop = Backdrop.BACKGROUND if cut.background else Backdrop.WHITE
    cells = [cell_of(portraits.draw(each, around, backdrop), CELL_PX) for each in steps]
    portraits.close()
    return cells


def cell_of(picture: Steps, side_px: int) -> Picture:
    """Return one picture, no side over ``side_px``, with a gap to the right and below."""
    small = shrunk(picture[..., :3], side_px)
    cell = np.full((side_px + _GAP_PX, side_px + _GAP_PX, 4), (_GREY, _GREY, _GREY, 255), np.uint8)
    top, left = ((side_px - side) // 2 for side in small.shape[:2])
    cell[top : top + small.shape[0], left : left + small.shape[1], :3] = small
    return cell


def _on_layers(values: Mapping[Property[float], float]) -> Adjust:
    """Return an adjustment of every layer; lengths are given as parts of the figure's height."""

    def adjust(document: Document) -> Document:
        for layer in document.layers:
            for prop, part in values.items():
                value = part * layer.figure.height if prop.unit == "px" else part
                document = set_constant(document, Address(prop, layer.id), min(max(value, prop.low), prop.high))
        return document

    return adjust


def _light(document: Document) -> Document:
    """Put the lamp on the other side, as far from the middle of the first character."""
    x, y, z = value_at(document.tracks, properties.LIGHT_POSITION, 1)
    figure = document.layers[0].figure
    return set_constant(document, Address(properties.LIGHT_POSITION), (figure.left + figure.right - x, y, z))


def _ground(document: Document) -> Document:
    """Put the ground line a little higher than the lowest foot."""
    x, y = value_at(document.tracks, properties.GROUND_POSITION, 1)
    return set_constant(
        document, Address(properties.GROUND_POSITION), (x, y - ceil(0.02 * document.layers[0].figure.height))
    )


def _declination(document: Document) -> Document:
    return set_constant(document, Address(properties.GROUND_DECLINATION), 42.0)


_CALM: Final = {properties.WAVE1.amplitude: 0.012, properties.WAVE1.wavelength: 0.1, properties.WAVE_ANCHOR: 0.1}
_TORN: Final = {properties.WAVE1.amplitude: 0.035, properties.WAVE2.amplitude: 0.012, properties.WAVE2.wavelength: 0.06}
_STEPS: Final[Mapping[str, Adjust]] = {
    "light": _light,
    "ground": _ground,
    "declination": _declination,
    "simplify": _on_layers({properties.SIMPLIFY: 0.035}),
    "distance": _on_layers({properties.DISTANCE: 0.4}),
    "waves": _on_layers(_CALM),
    "torn": _on_layers(_TORN),
}
STEP_NAMES: Final = ("initial", *_STEPS)
