"""Draws the pictures of the styles that the welcome page shows, with the demo's own character.

::

    .venv/bin/python packaging/dev_style_pictures.py

Run it after changing a style or how shadows look, and look at what it wrote into ``app/resources/styles/pictures``.
"""

from __future__ import annotations

import sys
import tempfile
from functools import reduce
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from kagezou.animation.track import Value
from kagezou.cli.demo.stage import make_demo
from kagezou.document.address import Address
from kagezou.document.edits import set_background, set_constant
from kagezou.document.model import Document
from kagezou.document.properties import LIGHT_AZIMUTH, LIGHT_ELEVATION, LIGHT_KIND
from kagezou.document.property import AnyProperty
from kagezou.document.styling import put_style
from kagezou.export.portraits import Portraits
from kagezou.geometry.box import Box
from kagezou.importing.feet import document_with_feet
from kagezou.io.clips.style_files import bundled_styles
from kagezou.io.images.writing import write_rgba
from kagezou.io.project.file import load
from kagezou.locations import resource_folder
from kagezou.render.gpu.context import open_headless_context
from kagezou.render.prepare.backdrop import Backdrop

FRAME = 40
SIZE_PX = (264, 176)
LIGHT: dict[AnyProperty, Value] = {LIGHT_KIND: "sun", LIGHT_AZIMUTH: 62.0, LIGHT_ELEVATION: 38.0}
"""A light under which the shadow lies beside the character; styles are shown without their own, as they are put on."""


def main() -> None:
    """Draw every style."""
    folder = resource_folder() / "styles" / "pictures"
    folder.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as made, open_headless_context():
        document = stage(Path(made))
        figure_id = document.layers[-1].id
        styled = {
            each.path.stem: put_style(document, [figure_id], each.style, FRAME).document for each in bundled_styles()
        }
        portraits = Portraits(document, figure_id, FRAME, 2 * SIZE_PX[0])
        place = wide(reduce(Box.union, map(portraits.box, styled.values())))
        for stem, each in styled.items():
            square = np.asarray(portraits.draw(each, place, Backdrop.WHITE), np.float64)
            beyond = (square.shape[0] - square.shape[0] * SIZE_PX[1] // SIZE_PX[0]) // 2
            path = folder / f"{stem}.png"
            write_rgba(path, shrunk(square[beyond:-beyond]))
            sys.stdout.write(f"{path}\n")
        portraits.close()


def stage(folder: Path) -> Document:
    """Return the demo with its last character alone to be seen in its light, on nothing."""
    document = set_background(load(make_demo(folder, 2, lambda *_: None).project), None)
    for prop, value in LIGHT.items():
        document = set_constant(document, Address(prop), value)
    return document_with_feet(document, [document.layers[-1].id]).document


def wide(place: Box) -> Box:
    """Return a box as wide as the pictures are, in whose middle another one lies."""
    more = max(0, place.height * SIZE_PX[0] // SIZE_PX[1] - place.width) // 2
    return Box(place.left - more, place.top, place.right + more, place.bottom)


def shrunk(picture: NDArray[np.float64]) -> NDArray[np.uint8]:
    """Return a picture at the pictures' size, each pixel the mean of what it covers."""
    for axis, size in ((0, SIZE_PX[1]), (1, SIZE_PX[0])):
        edges = np.linspace(0, picture.shape[axis], size + 1).round().astype(int)
        sums = np.add.reduceat(picture, edges[:-1], axis)
        widths = np.diff(edges).reshape([-1 if each == axis else 1 for each in range(3)])
        picture = sums / widths
    return (picture + 0.5).astype(np.uint8)


if __name__ == "__main__":
    main()
