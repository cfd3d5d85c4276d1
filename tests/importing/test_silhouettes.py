"""Silhouettes of figures: where drawings are opaque in their boxes, moved as they are seen."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from kagezou.document.edits import set_drawings
from kagezou.document.model import Document
from kagezou.geometry.box import Box
from kagezou.importing.silhouettes import silhouettes_of
from kagezou.io.images.writing import write_rgba
from tests.export.small_cuts import cut, with_values

LAYER = "layer-1"


def corner_cut(folder: Path) -> Document:
    """Return a figure of 20 x 20 px whose upper right quarter is clear."""
    document = cut(folder, count=1)
    pixels = np.zeros((48, 64, 4), np.uint8)
    pixels[20:40, 10:30, 3] = 255
    pixels[20:30, 20:30, 3] = 0
    path = folder / "corner.png"
    write_rgba(path, pixels)
    (drawing,) = document.layer(LAYER).cels.drawings
    box = Box(10, 20, 30, 40)
    return set_drawings(document, LAYER, (replace(drawing, path=path, figure=box, size_px=(64, 48)),))


def test_it_is_where_the_drawing_is_opaque(tmp_path: Path) -> None:
    shape = silhouettes_of(corner_cut(tmp_path), 1)[LAYER]
    rows, columns = shape.shape
    assert shape[: rows // 2, : columns // 2].all()
    assert shape[rows // 2 :].all()
    assert not shape[: rows // 2, columns // 2 :].any()


def test_a_cel_that_is_moved_and_mirrored_has_it_as_it_is_seen(tmp_path: Path) -> None:
    document = with_values(corner_cut(tmp_path), **{"layers.A.scale": [-100, 100], "layers.A.position": [40, 20]})
    shape = silhouettes_of(document, 1)[LAYER]
    rows, columns = shape.shape
    assert not shape[2 : rows // 2 - 2, 2 : columns // 2 - 2].any()
    assert shape[2 : rows // 2 - 2, columns // 2 + 2 : -2].all()


def test_what_cannot_be_read_is_left_out_and_a_clear_drawing_is_empty(tmp_path: Path) -> None:
    document = corner_cut(tmp_path)
    write_rgba(tmp_path / "corner.png", np.zeros((48, 64, 4), np.uint8))
    assert not silhouettes_of(document, 1)[LAYER].any()
    (tmp_path / "corner.png").unlink()
    assert silhouettes_of(document, 1) == {}
