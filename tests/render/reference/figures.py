"""Characters drawn by the tests: limbs, a head and thin hair, anti-aliased or binary, as straight RGBA."""

from collections.abc import Mapping
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from kagezou.document import edits
from kagezou.document.address import resolve
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.geometry.box import Box
from kagezou.geometry.placement import Placement
from kagezou.io.images.writing import write_rgba

SIZE = 1000
FEET_Y = 900.0
STROKES = (
    # from, to, half width: two legs, a trunk, two arms, a head, three hairs
    ((470.0, 660.0), (440.0, 890.0), 22.0),
    ((530.0, 660.0), (565.0, 888.0), 20.0),
    ((500.0, 480.0), (500.0, 660.0), 55.0),
    ((460.0, 470.0), (360.0, 560.0), 14.0),
    ((540.0, 470.0), (660.0, 400.0), 14.0),
    ((500.0, 360.0), (500.0, 370.0), 70.0),
    ((450.0, 310.0), (400.0, 230.0), 3.0),
    ((500.0, 295.0), (505.0, 200.0), 2.0),
    ((550.0, 310.0), (610.0, 250.0), 1.2),
)


def figure_alpha(size: int = SIZE, *, binary: bool = False, moved: Placement | None = None) -> NDArray[np.uint8]:
    """A standing figure (size, size); feet at y = 900 of 1000; drawn anew where an even placement moves it."""
    return _drawn(size, moved, binary=binary).copy()


@cache
def _drawn(size: int, moved: Placement | None, *, binary: bool) -> NDArray[np.uint8]:
    scale = size / SIZE
    y, x = (np.mgrid[0:size, 0:size] + 0.5) / scale
    if moved is not None:
        ((a, b, c), (d, e, f), _), scale = moved.centred_from_canvas(), scale * abs(moved.scale[0])
        x, y = a * x + b * y + c, d * x + e * y + f
    distance = np.full((size, size), 1e9)
    for (ax, ay), (bx, by), half in STROKES:
        dx, dy = bx - ax, by - ay
        t = np.clip(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy), 0, 1)
        distance = np.minimum(distance, np.hypot(x - ax - t * dx, y - ay - t * dy) - half)
    distance = np.maximum(distance, y - FEET_Y)
    coverage = np.clip(0.5 - distance * scale, 0, 1)
    return np.asarray((coverage >= 0.5) * 255 if binary else np.round(coverage * 255), np.uint8)


def write_figure(path: Path, alpha: NDArray[np.uint8]) -> Path:
    """Write a flat character of this alpha; no colour where it is clear."""
    rgba = np.zeros((*alpha.shape, 4), np.uint8)
    rgba[..., :3] = np.array([200, 120, 60]) * (alpha > 0)[..., np.newaxis]
    rgba[..., 3] = alpha
    write_rgba(path, rgba)
    return path


def standing(path: Path, size: int = SIZE) -> Document:
    """One character on the ground at its feet, lit by a lamp before it on the left."""
    scale = size / SIZE
    cels = Cels((Drawing("1", path),), (Exposure(1, 0),))
    figure = Box(int(346 * scale), int(198 * scale), int(674 * scale), int(900 * scale))
    document = edits.add_layer(Document(Canvas(size, size)), "A", cels, figure)
    return with_values(
        document,
        {
            "ground.position": [500.0 * scale, FEET_Y * scale],
            "light.position": [200.0 * scale, -200.0 * scale, 900.0 * scale],
        },
    )


def with_values(document: Document, values: Mapping[str, object]) -> Document:
    """Set constants by their paths."""
    for path, value in values.items():
        document = edits.set_constant(document, resolve(document, path), value)
    return document
