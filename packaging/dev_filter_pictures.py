"""Draws the pictures of the filters that tool tips and manual show, with the demo's own character.

::

    .venv/bin/python packaging/dev_filter_pictures.py

Run it after changing how shadows look, and look at what it wrote into ``docs/pictures``.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Mapping
from functools import reduce
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from dev_style_pictures import FRAME, SIZE_PX, shrunk, stage, wide
from kagezou.animation.track import Value
from kagezou.document.address import Address
from kagezou.document.edits import set_constant
from kagezou.document.model import Document
from kagezou.document.properties import OF_LAYER
from kagezou.export.portraits import Portraits
from kagezou.geometry.box import Box
from kagezou.io.images.writing import write_rgba
from kagezou.render.gpu.context import open_headless_context
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.ui.panels.filter_pictures import COMPANIONS, EXAMPLES, picture_of

GAP_PX = 8


def main() -> None:
    """Draw every filter."""
    with tempfile.TemporaryDirectory() as made, open_headless_context():
        document = stage(Path(made))
        figure_id = document.layers[-1].id
        portraits = Portraits(document, figure_id, FRAME, 2 * SIZE_PX[0])
        for name, values in EXAMPLES.items():
            base = _with(document, figure_id, COMPANIONS.get(name, {}))
            shown = [_with(base, figure_id, {name: value}) for value in values]
            place = wide(reduce(Box.union, map(portraits.box, shown)))
            path = picture_of(name)
            path.parent.mkdir(parents=True, exist_ok=True)
            write_rgba(path, _beside([_picture(portraits, each, place) for each in shown]))
            sys.stdout.write(f"{path}\n")
        portraits.close()


def _with(document: Document, figure_id: str, values: Mapping[str, Value]) -> Document:
    for name, value in values.items():
        document = set_constant(document, Address(OF_LAYER[name], figure_id), value)
    return document


def _picture(portraits: Portraits, document: Document, place: Box) -> NDArray[np.uint8]:
    square = np.asarray(portraits.draw(document, place, Backdrop.WHITE), np.float64)
    beyond = (square.shape[0] - square.shape[0] * SIZE_PX[1] // SIZE_PX[0]) // 2
    return shrunk(square[beyond:-beyond])


def _beside(pictures: list[NDArray[np.uint8]]) -> NDArray[np.uint8]:
    """Return pictures beside each other with clear gaps, (H, W, 4)."""
    gap = np.zeros((pictures[0].shape[0], GAP_PX, 4), np.uint8)
    row = [part for picture in pictures for part in (picture, gap)]
    return np.concatenate(row[:-1], axis=1)


if __name__ == "__main__":
    main()
