"""Where a blur has to be summed up: everywhere its reach touches a shadow, and little more."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.bands import Band, Extent
from kagezou.geometry.box import Box
from kagezou.render.prepare.band_atlas import Strip
from kagezou.render.prepare.blur_tiles import blur_tiles
from kagezou.render.prepare.shadow_tiles import TILE_PX

WHOLE = Extent(0.0, 0.0, 96.0, 64.0)
STRIP = Strip(Band(0, 8.0, WHOLE, WHOLE, WHOLE), Box(0, 0, 96, 64))


def drawn(boxes: np.ndarray) -> np.ndarray:
    mask = np.zeros((64, 96), bool)
    for left, top, right, bottom in boxes.astype(int):
        assert not mask[top:bottom, left:right].any(), "no texel is blurred twice"
        mask[top:bottom, left:right] = True
    return mask


def test_a_point_is_blurred_down_first_and_then_along() -> None:
    shadow = np.zeros((64, 96), np.float32)
    shadow[30, 50] = 1.0
    across, along = (drawn(boxes) for boxes in blur_tiles(STRIP, shadow, 8))
    rows, columns = np.nonzero(across)
    assert (rows.min(), rows.max() + 1) == (16, 40)
    assert (columns.min(), columns.max() + 1) == (48, 56)
    rows, columns = np.nonzero(along)
    assert (rows.min(), rows.max() + 1) == (16, 40)
    assert (columns.min(), columns.max() + 1) == (40, 64)


def test_nothing_is_blurred_where_there_is_no_shadow() -> None:
    across, along = blur_tiles(STRIP, np.zeros((64, 96), np.float32), 20)
    assert len(across) == len(along) == 0


def test_only_the_own_part_of_the_atlas_is_looked_at() -> None:
    shadow = np.zeros((200, 96), np.float32)
    shadow[:64] = 1.0
    below = Strip(STRIP.band, Box(0, 100, 96, 164))
    assert len(blur_tiles(below, shadow, 8)[1]) == 0
    shadow[130, 10] = 1.0
    boxes = blur_tiles(below, shadow, 8)[1]
    assert boxes[:, 1].min() >= 100


@given(st.lists(st.tuples(st.integers(0, 63), st.integers(0, 95)), min_size=1, max_size=4), st.integers(1, 60))
def test_every_texel_within_reach_is_blurred(places: list[tuple[int, int]], reach: int) -> None:
    shadow = np.zeros((64, 96), np.float32)
    for place in places:
        shadow[place] = 1.0
    across, along = (drawn(boxes) for boxes in blur_tiles(STRIP, shadow, reach))
    for row, column in places:
        down = slice(max(row - reach, 0), row + reach + 1)
        assert across[down, column].all()
        assert along[down, max(column - reach, 0) : column + reach + 1].all()
    # No more than a tile around what is asked for.
    near = np.zeros((64, 96), bool)
    more = reach + 2 * TILE_PX
    for row, column in places:
        near[max(row - more, 0) : row + more, max(column - more, 0) : column + more] = True
    assert not (along & ~near).any()
