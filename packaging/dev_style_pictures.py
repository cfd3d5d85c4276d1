"""Draws the pictures of the styles that the welcome page shows, with the demo's own character.

::

    .venv/bin/python packaging/dev_style_pictures.py

Run it after changing a style or how shadows look, and look at what it wrote into ``app/resources/styles/pictures``.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from kagezou.cli.demo.stage import make_demo
from kagezou.document.edits import set_background
from kagezou.document.styling import put_style
from kagezou.importing.feet import document_with_feet
from kagezou.io.clips.style_files import bundled_styles
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.writing import write_rgba
from kagezou.io.project.file import load
from kagezou.locations import resource_folder
from kagezou.render.gpu.context import open_headless_context
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate

FRAME = 40
SIZE_PX = (264, 176)
LEFT_PX, TOP_PX, WIDE_PX = 10, 295, 990
"""The part of the demo's canvas around the character and its shadows."""


def main() -> None:
    """Draw every style."""
    folder = resource_folder() / "styles" / "pictures"
    folder.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as made, open_headless_context():
        document = set_background(load(make_demo(Path(made), 2, lambda *_: None).project), None)
        document = document_with_feet(document, [document.layers[-1].id]).document
        layer = document.layers[-1]
        renderer = Renderer(CelCache())
        for each in bundled_styles():
            styled = put_style(document, [layer.id], each.style, FRAME).document
            renderer.draw_picture(evaluate(styled, FRAME), Backdrop.WHITE)
            high = WIDE_PX * SIZE_PX[1] // SIZE_PX[0]
            picture = np.asarray(renderer.read_picture(), np.float64)
            part = picture[TOP_PX : TOP_PX + high, LEFT_PX : LEFT_PX + WIDE_PX]
            path = folder / f"{each.path.stem}.png"
            write_rgba(path, shrunk(part))
            sys.stdout.write(f"{path}\n")
        renderer.close()


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
