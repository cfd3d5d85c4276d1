"""Which tiles of a picture lie within a polygon and within none of others, and which have to be looked at."""

from collections.abc import Sequence

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.vectors import Matrix
from kagezou.render.prepare.shadow_tiles import TILE_PX, Boxes, runs_of

_INSIDE, _EDGE = 1, 2


def polygon_tiles(polygons: Sequence[Matrix], box: Box) -> tuple[Boxes, Boxes]:
    """Return the boxes of tiles wholly within the first of some polygons and outside all others, and of mixed ones.

    Parameters
    ----------
    polygons
        Convex, each by the lines (N, 3) of its sides, not negative inside; the first one at least.
    box
        What is asked about, px.
    """
    columns = np.arange(box.left // TILE_PX, -(-box.right // TILE_PX))
    rows = np.arange(box.top // TILE_PX, -(-box.bottom // TILE_PX))
    x, y = (columns + 0.5) * TILE_PX, (rows[:, np.newaxis] + 0.5) * TILE_PX
    shape = (len(rows), len(columns))
    whole, some = np.ones(shape, np.bool_), np.ones(shape, np.bool_)
    for number, lines in enumerate(polygons):
        within, touched = np.ones(shape, np.bool_), np.ones(shape, np.bool_)
        for a, b, c in lines:
            middle, reach = a * x + b * y + c, (abs(a) + abs(b)) * TILE_PX / 2
            within &= middle >= reach
            touched &= middle >= -reach
        whole &= within if number == 0 else ~touched
        some &= touched if number == 0 else ~within
    codes = np.where(whole, _INSIDE, np.where(some, _EDGE, 0))
    boxes, kinds = runs_of(codes, (int(columns[0]), int(rows[0])), box)
    return boxes[kinds == _INSIDE], boxes[kinds == _EDGE]
