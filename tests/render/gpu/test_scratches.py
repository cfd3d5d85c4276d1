"""Targets that are kept for what is drawn aside: how large they are, and when a new one is made."""

from collections.abc import Iterator

import pytest

from kagezou.geometry.box import Box
from kagezou.render.gpu.scratches import GrowingTarget
from kagezou.render.gpu.targets import Format
from kagezou.render.renderer import Renderer


@pytest.fixture
def growing(renderer: Renderer) -> Iterator[GrowingTarget]:  # noqa: ARG001 - its context is current
    growing = GrowingTarget(Format.ALPHA16)
    yield growing
    growing.close()


def test_a_little_more_is_not_a_new_one(growing: GrowingTarget) -> None:
    target = growing.at_least(300, 40)
    assert target.box.width >= 300
    assert target.texture.form is Format.ALPHA16
    for width, height in ((301, 45), (20, 20), (310, 60)):
        assert growing.holds(width, height)
        assert growing.at_least(width, height) is target


def test_one_side_that_grows_leaves_the_other_as_large_as_it_was(growing: GrowingTarget) -> None:
    first = growing.at_least(1000, 10).box
    assert not growing.holds(10, 1000)
    second = growing.at_least(10, 1000)
    assert (second.box.width, growing.target) == (first.width, second)
    assert second.box.height >= 1000


def test_no_size_at_all_is_a_target_too(growing: GrowingTarget) -> None:
    target = growing.at_least(0, 0)
    target.clear()
    assert not target.read(Box(0, 0, 1, 1)).any()
