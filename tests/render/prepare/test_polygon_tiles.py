"""Tiles of polygons: surely inside, surely outside, or to be looked at."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.box import Box
from kagezou.geometry.sets.laid_flat import lines_of
from kagezou.render.prepare.polygon_tiles import polygon_tiles

BOX = Box(3, 5, 92, 77)
CORNER = st.tuples(st.floats(-20, 110), st.floats(-20, 110))


def is_within(lines: np.ndarray, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    return np.asarray(np.logical_and.reduce([a * x + b * y + c >= 0 for a, b, c in lines]))


@given(st.lists(st.tuples(CORNER, st.floats(3, 60), st.floats(0, 6)), min_size=1, max_size=3))
def test_every_pixel_is_laid_as_the_polygons_say(triangles: list[tuple[tuple[float, float], float, float]]) -> None:
    polygons = []
    for (x, y), radius, turn in triangles:
        angles = turn + np.arange(3) * 2 * np.pi / 3
        polygons.append(lines_of(np.stack([x + radius * np.cos(angles), y + radius * np.sin(angles)], axis=1)))
    y, x = np.mgrid[BOX.top : BOX.bottom, BOX.left : BOX.right] + 0.5
    wanted = is_within(polygons[0], x, y)
    for each in polygons[1:]:
        wanted &= ~is_within(each, x, y)
    inside, edge = (np.zeros((BOX.bottom, BOX.right), int) for _ in range(2))
    for mask, boxes in zip((inside, edge), polygon_tiles(polygons, BOX), strict=True):
        for left, top, right, bottom in boxes.astype(int):
            mask[top:bottom, left:right] += 1
    inside, edge = inside[BOX.top :, BOX.left :], edge[BOX.top :, BOX.left :]
    assert (inside + edge).max() <= 1
    assert wanted[inside == 1].all()
    assert not wanted[inside + edge == 0].any()


def test_a_large_polygon_is_mostly_inside() -> None:
    square = lines_of(np.array([[-10.0, -10.0], [200.0, -10.0], [200.0, 50.0], [-10.0, 50.0]]))
    inside, edge = polygon_tiles([square], BOX)
    assert inside[:, 3].max() == 48
    assert (int(edge[:, 1].min()), int(edge[:, 3].max())) == (48, 56)
