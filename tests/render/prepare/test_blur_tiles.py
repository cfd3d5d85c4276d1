"""Where a blur has to be summed up: everywhere its reach touches both shadow and none, and little more."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.bands import Band, Extent
from kagezou.geometry.box import Box
from kagezou.render.prepare.band_atlas import Strip
from kagezou.render.prepare.blur_tiles import blur_tiles
from kagezou.render.prepare.shadow_tiles import TILE_PX

WHOLE = Extent(0.0, 0.0, 96.0, 64.0)
BOX = Box(0, 0, 96, 64)


def strip_of(reach: float, box: Box = BOX) -> Strip:
    return Strip(Band(0, reach, WHOLE, WHOLE, WHOLE), box)


def drawn(boxes: np.ndarray) -> np.ndarray:
    mask = np.zeros((64, 96), bool)
    for left, top, right, bottom in boxes.astype(int):
        assert not mask[top:bottom, left:right].any(), "no texel is blurred twice"
        mask[top:bottom, left:right] = True
    return mask


def test_a_point_is_blurred_down_first_and_then_along() -> None:
    shadow = np.zeros((64, 96), np.float32)
    shadow[30, 50] = 1.0
    across, along = (drawn(tiles.summed) for tiles in blur_tiles(strip_of(8.0), shadow))
    rows, columns = np.nonzero(across)
    assert (rows.min(), rows.max() + 1) == (16, 40)
    assert (columns.min(), columns.max() + 1) == (48, 56)
    rows, columns = np.nonzero(along)
    assert (rows.min(), rows.max() + 1) == (16, 40)
    assert (columns.min(), columns.max() + 1) == (40, 64)


def test_what_has_nothing_but_shadow_around_it_is_full() -> None:
    shadow = np.zeros((64, 96), np.float32)
    shadow[8:56, 8:80] = 1.0
    across, along = blur_tiles(strip_of(6.0), shadow)
    full = drawn(across.full)
    assert full[16:48, 8:80].all()
    assert full.sum() == 32 * 72
    full = drawn(along.full)
    assert full[16:48, 16:72].all()
    assert full.sum() == 32 * 56
    assert not (drawn(along.summed) & full).any()


def test_nothing_is_blurred_where_there_is_no_shadow() -> None:
    for tiles in blur_tiles(strip_of(20.0), np.zeros((64, 96), np.float32)):
        assert len(tiles.full) == len(tiles.summed) == len(tiles.corners) == 0


def test_tiles_lie_where_the_strip_lies_in_the_atlas() -> None:
    shadow = np.zeros((64, 96), np.float32)
    shadow[30, 10] = 1.0
    tiles = blur_tiles(strip_of(8.0, Box(0, 100, 96, 164)), shadow)[1]
    assert (int(tiles.summed[:, 1].min()), int(tiles.summed[:, 3].max())) == (116, 140)
    assert (int(tiles.corners[:, 1].min()), int(tiles.corners[:, 1].max())) == (116, 132)


@given(
    st.lists(st.tuples(st.integers(0, 63), st.integers(0, 95)), min_size=1, max_size=4),
    st.integers(1, 60),
    st.booleans(),
)
def test_every_texel_within_reach_is_known(places: list[tuple[int, int]], reach: int, is_gap: bool) -> None:  # noqa: FBT001 - drawn
    shadow = np.full((64, 96), float(is_gap), np.float32)
    for place in places:
        shadow[place] = 1.0 - is_gap
    across, along = blur_tiles(strip_of(float(reach)), shadow)
    for row, column in places:
        down = slice(max(row - reach, 0), row + reach + 1)
        assert drawn(across.summed)[down, column].all()
        assert drawn(along.summed)[down, max(column - reach, 0) : column + reach + 1].all()
    if is_gap:
        return
    # No more than a tile around what is asked for.
    near = np.zeros((64, 96), bool)
    more = reach + 2 * TILE_PX
    for row, column in places:
        near[max(row - more, 0) : row + more, max(column - more, 0) : column + more] = True
    assert not (drawn(along.summed) & ~near).any()
