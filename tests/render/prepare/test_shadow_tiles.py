"""Tiles of a shadow: each pixel is in exactly one of them, and none is called covered or untouched that is not."""

from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from kagezou.geometry.box import Box
from kagezou.geometry.shadow import Cast
from kagezou.render.prepare.occupancy import Occupancy
from kagezou.render.prepare.shadow_tiles import (
    CELLS,
    TILE_PX,
    EdgeKind,
    Fineness,
    TileGrid,
    around_boxes,
    runs_of,
    tile_corners,
    tile_grid,
    whole_grid,
)

EVERYWHERE = np.array([0.0, 0.0, 1.0])
ONE = Fineness(1.0)


@dataclass(frozen=True)
class DrawnMatte:
    """A matte that is nowhere but in memory."""

    box: Box
    occupancy: Occupancy


def matte(alpha: np.ndarray) -> DrawnMatte:
    return DrawnMatte(Box(0, 0, alpha.shape[1], alpha.shape[0]), Occupancy(alpha, 0))


def block(width: int = 64, height: int = 64, margin: int = 16) -> np.ndarray:
    """A full square in the middle of an empty matte."""
    alpha = np.zeros((height, width), np.uint8)
    alpha[margin : height - margin, margin : width - margin] = 255
    return alpha


def cast(art_from_canvas: np.ndarray | None = None, side: np.ndarray = EVERYWHERE) -> Cast:
    art = np.eye(3) if art_from_canvas is None else art_from_canvas
    return Cast(art, np.eye(3), side, EVERYWHERE, np.empty((0, 3)))


def painted(boxes: np.ndarray, canvas: Box) -> np.ndarray:
    """How often each pixel of a canvas is in a box."""
    count = np.zeros((canvas.height, canvas.width), int)
    for left, top, right, bottom in boxes.astype(int):
        count[top:bottom, left:right] += 1
    return count


def test_a_drawing_seen_as_it_is_has_tiles_where_it_is() -> None:
    canvas = Box(0, 0, 64, 64)
    tiling = tile_grid(cast(), canvas, matte(block()), ONE).tiling(canvas)
    full, drawn = painted(tiling.full, canvas), painted(tiling.boxes, canvas)
    assert drawn.max() == 1
    assert (drawn[block() > 0] == 1).all()
    assert (block()[full > 0] == 255).all()
    # What lies two tiles within the edge is found to be full; what lies two tiles beyond it is not drawn.
    assert full[32, 32] == 1
    assert drawn[2, 2] == 0
    assert tiling.box == Box(8, 8, 56, 56)


def test_an_edge_seen_as_it_is_has_one_cell_a_pixel_and_one_seen_small_has_more() -> None:
    canvas = Box(0, 0, 64, 64)
    kinds = set(tile_grid(cast(), canvas, matte(block()), ONE).tiling(canvas).edges)
    assert kinds == {EdgeKind(1, 1, is_at_limit=False, is_squeezed=False)}
    squeezed = cast(np.diag([3.0, 1.0, 1.0]))
    (kind,) = tile_grid(squeezed, canvas, matte(block(192, 64)), ONE).tiling(canvas).edges
    assert (kind.cells_x, kind.cells_y, kind.is_squeezed) == (3, 1, False)


def test_more_texels_than_cells_are_said_to_be_squeezed() -> None:
    canvas = Box(0, 0, 16, 16)
    edges = tile_grid(cast(np.diag([40.0, 1.0, 1.0])), canvas, matte(block(640, 16, 4)), ONE).tiling(canvas).edges
    assert {(kind.cells_x, kind.is_squeezed) for kind in edges} == {(CELLS[-1], True)}
    coarse = Fineness(1.0, max_cells=4)
    edges = tile_grid(cast(np.diag([8.0, 1.0, 1.0])), canvas, matte(block(128, 16, 4)), coarse).tiling(canvas).edges
    assert {(kind.cells_x, kind.is_squeezed) for kind in edges} == {(4, True)}


def test_beyond_the_contact_line_nothing_is_drawn_and_along_it_tiles_are_at_a_limit() -> None:
    canvas = Box(0, 0, 64, 64)
    below = np.array([0.0, 1.0, -32.0])
    tiling = tile_grid(cast(side=below), canvas, matte(np.full((64, 64), 255, np.uint8)), ONE).tiling(canvas)
    drawn = painted(tiling.boxes, canvas)
    assert not drawn[:24].any()
    assert drawn[33:].all()
    assert {kind.is_at_limit for kind in tiling.edges} >= {True}


def test_across_the_horizon_a_tile_may_be_anything() -> None:
    canvas = Box(0, 0, 64, 64)
    over_the_edge = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 1 / 32, -1.0]])
    grid = tile_grid(cast(over_the_edge), canvas, matte(block()), ONE)
    # Rows 3 and 4 touch the line y = 32, where the denominator is 0.
    kinds = {kind for kind in grid.tiling(Box(0, 30, 64, 34)).edges if kind.is_squeezed}
    assert kinds


@given(
    arrays.arrays(np.uint8, (48, 48), elements=st.sampled_from([0, 255]), fill=st.just(0)),
    st.floats(0.3, 3.0),
    st.floats(-0.8, 0.8),
    st.tuples(st.floats(-40, 40), st.floats(-40, 40)),
)
def test_no_tile_is_called_covered_or_untouched_that_is_not(
    alpha: np.ndarray, scale: float, shear: float, shift: tuple[float, float]
) -> None:
    canvas = Box(0, 0, 40, 40)
    art_from_canvas = np.array([[scale, shear, shift[0]], [0.0, scale, shift[1]], [0.0, 0.0, 1.0]])
    tiling = tile_grid(cast(art_from_canvas), canvas, matte(alpha), ONE).tiling(canvas)
    full, drawn = painted(tiling.full, canvas), painted(tiling.boxes, canvas)
    assert drawn.max() <= 1
    y, x = np.mgrid[0:40, 0:40] + 0.5
    places = art_from_canvas @ np.array([x.ravel(), y.ravel(), np.ones(1600)])
    columns, rows = (np.floor(part).astype(int) for part in places[:2])
    inside = (columns >= 0) & (rows >= 0) & (columns < 48) & (rows < 48)
    value = np.zeros(1600, int)
    value[inside] = alpha[rows[inside], columns[inside]]
    assert (value[full.ravel() > 0] == 255).all()
    assert (value[drawn.ravel() == 0] == 0).all()


@given(arrays.arrays(np.int64, st.tuples(st.integers(1, 6), st.integers(1, 6)), elements=st.integers(0, 3)))
def test_runs_hold_every_tile_that_is_touched_once_with_its_code(codes: np.ndarray) -> None:
    canvas = Box(0, 0, codes.shape[1] * TILE_PX, codes.shape[0] * TILE_PX)
    boxes, kinds = runs_of(codes, (0, 0), canvas)
    shown = np.zeros(codes.shape, int)
    for (left, top, right, bottom), kind in zip((boxes / TILE_PX).astype(int), kinds, strict=True):
        assert bottom == top + 1
        assert (shown[top:bottom, left:right] == 0).all()
        shown[top:bottom, left:right] = kind
    assert np.array_equal(shown, codes)


def test_runs_are_cut_to_the_canvas() -> None:
    boxes, _ = runs_of(np.ones((1, 3), np.int64), (1, 2), Box(10, 18, 27, 21))
    assert boxes.tolist() == [[10.0, 18.0, 27.0, 21.0]]


def test_two_sets_of_tiles_of_one_grid_are_told_apart() -> None:
    canvas = Box(0, 0, 32, 8)
    grid = TileGrid(np.array([[1, 1, 2, 0]]), np.arange(4), np.arange(1))
    first, second = grid.tilings(canvas, np.array([True, False, True, True]), np.array([False, True, False, False]))
    assert first.full.tolist() == [[0.0, 0.0, 8.0, 8.0]]
    assert [boxes.tolist() for boxes in first.edges.values()] == [[[16.0, 0.0, 24.0, 8.0]]]
    assert second.full.tolist() == [[8.0, 0.0, 16.0, 8.0]]
    assert second.edges == {}


def test_corners_go_around_each_tile_with_their_margin() -> None:
    corners = tile_corners(np.array([2]), np.array([1]), 1.0)
    assert corners[:, :, 0].tolist() == [[15, 7, 1], [25, 7, 1], [25, 17, 1], [15, 17, 1]]


def test_a_whole_grid_covers_its_box() -> None:
    box = Box(3, 9, 30, 20)
    tiling = whole_grid(box).tiling(box)
    assert painted(tiling.full, Box(0, 0, 40, 40)).sum() == box.width * box.height
    assert tiling.box == box


def test_no_boxes_have_nothing_around_them() -> None:
    assert around_boxes(np.empty((0, 4))) is None


@pytest.mark.parametrize("kind", [EdgeKind(2, 32, is_at_limit=True, is_squeezed=True)])
def test_a_kind_names_its_switches(kind: EdgeKind) -> None:
    assert kind.switches == {"CELLS_X 2", "CELLS_Y 32", "AT_A_LIMIT", "SQUEEZED"}
