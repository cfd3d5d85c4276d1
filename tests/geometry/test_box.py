"""Boxes of whole pixels and where a drawing lies on the canvas."""

import pytest

from kagezou.geometry.box import Box, around, centred_offset

BOX = Box(10, 20, 30, 60)


def test_extent() -> None:
    assert (BOX.width, BOX.height) == (20, 40)
    assert not BOX.is_empty
    assert Box(10, 20, 10, 60).is_empty
    assert Box(10, 60, 30, 20).is_empty


def test_moved_and_grown() -> None:
    assert BOX.moved(-10, 5) == Box(0, 25, 20, 65)
    assert BOX.grown(2) == Box(8, 18, 32, 62)


def test_intersection_and_union() -> None:
    other = Box(20, 0, 50, 30)
    assert BOX.intersection(other) == Box(20, 20, 30, 30)
    assert BOX.intersection(Box(30, 20, 40, 60)) is None
    assert BOX.union(other) == Box(10, 0, 50, 60)
    assert around(None, BOX, None, other) == Box(10, 0, 50, 60)
    assert around(None) is None


@pytest.mark.parametrize(
    ("size", "offset"),
    [((100, 80), (0, 0)), ((50, 40), (25, 20)), ((51, 41), (24, 19)), ((101, 81), (-1, -1)), ((103, 83), (-2, -2))],
)
def test_a_drawing_lies_centred_pixel_for_pixel(size: tuple[int, int], offset: tuple[int, int]) -> None:
    assert centred_offset(Box(0, 0, 100, 80), *size) == offset
