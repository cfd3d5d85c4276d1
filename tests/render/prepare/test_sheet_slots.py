"""Where sheets are cast aside: no two in one place, all that is seen of each, and laid in their order."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.box import Box
from kagezou.geometry.sets.laid_flat import FlatOutline
from kagezou.render.prepare import sheet_slots as room
from kagezou.render.prepare.sheet_slots import sheet_slots

WINDOW = Box(0, 0, 300, 200)
PICTURE_FROM_FLAT = np.array([[0.5, 0.0, 20.0], [0.0, 0.5, 10.0], [0.0, 0.0, 1.0]])


def square(left: float, top: float, side: float) -> np.ndarray:
    return np.array([[left, top], [left + side, top], [left + side, top + side], [left, top + side]])


@given(
    st.lists(
        st.tuples(st.integers(0, 6), st.floats(-300, 700), st.floats(-300, 500), st.floats(1, 400)),
        min_size=1,
        max_size=12,
    )
)
def test_every_sheet_has_a_place_of_its_own(squares: list[tuple[int, float, float, float]]) -> None:
    outlines = [FlatOutline(sheet, square(x, y, side)) for sheet, x, y, side in squares]
    for together in sheet_slots(outlines, PICTURE_FROM_FLAT, WINDOW):
        boxes = [slot.box for slot in together.slots]
        for index, box in enumerate(boxes):
            assert box.right <= WINDOW.width
            assert together.box.union(box) == together.box
            assert all(box.intersection(other) is None for other in boxes[:index])
        for slot in together.slots:
            assert slot.part.moved(*slot.shift) == slot.box
            for outline in outlines:
                corners = outline.corners * 0.5 + (20.0, 10.0)
                low, high = np.floor(corners.min(axis=0)), np.ceil(corners.max(axis=0))
                seen = Box(*map(int, (*low, *high))).intersection(WINDOW)
                if outline.sheet == slot.sheet and seen is not None:
                    assert slot.part.union(seen) == slot.part


def test_polygons_are_laid_in_their_order_with_the_number_of_their_slot() -> None:
    outlines = [FlatOutline(sheet, square(10.0 * sheet, 0.0, 100.0)) for sheet in (4, 2, 4)]
    (together,) = sheet_slots(outlines, PICTURE_FROM_FLAT, WINDOW)
    assert [slot.sheet for slot in together.slots] == [4, 2]
    assert together.triangles[:, 2].tolist() == [0.0] * 6 + [1.0] * 6 + [0.0] * 6
    assert together.triangles[0].tolist() == [40.0, 10.0, 0.0]


def test_what_is_not_seen_has_no_place() -> None:
    outlines = [FlatOutline(0, square(5000.0, 0.0, 10.0)), FlatOutline(1, np.zeros((0, 2)))]
    assert not list(sheet_slots(outlines, PICTURE_FROM_FLAT, WINDOW))


def test_where_there_is_no_room_the_rest_follows_in_its_order(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(room, "MOST_ROWS", 250)
    outlines = [FlatOutline(sheet, square(0.0, 0.0, 1000.0)) for sheet in (0, 1, 0)]
    found = list(sheet_slots(outlines, PICTURE_FROM_FLAT, WINDOW))
    assert [[slot.sheet for slot in together.slots] for together in found] == [[0], [1], [0]]
    assert all(together.box.bottom <= 250 for together in found)
