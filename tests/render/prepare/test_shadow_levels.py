"""A shadow in several finenesses: where each lies, and what halving does to an edge."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.bands import Extent
from kagezou.geometry.box import Box
from kagezou.render.prepare.shadow_levels import ShadowLevels, halved, variance_of


@given(st.floats(-3e3, 3e3), st.floats(-3e3, 3e3), st.floats(1.0, 2e3), st.floats(1.0, 2e3), st.integers(0, 5))
def test_every_level_holds_the_extent_with_room_to_spare(
    left: float, low: float, width: float, height: float, coarsest: int
) -> None:
    levels = ShadowLevels.of(Extent(left, low, left + width, low + height), 0, coarsest)
    boxes = [levels.box_of(level) for level in range(coarsest + 1)]
    for level, box in enumerate(boxes):
        texel = 2.0**level
        corner = levels.corner_of(level)
        assert corner[0] * texel <= left - 2 * texel
        assert corner[1] * texel <= low - 2 * texel
        assert (corner[0] + box.width) * texel >= left + width + 2 * texel
        assert (corner[1] + box.height) * texel >= low + height + 2 * texel
        assert box.union(levels.box) == levels.box
        assert all(box.intersection(other) is None for other in boxes[:level])


def halved_line(texels: np.ndarray) -> np.ndarray:
    padded = np.pad(texels, 2)
    return np.asarray((padded[1:-4:2] + 3 * padded[2:-3:2] + 3 * padded[3:-2:2] + padded[4:-1:2]) / 8)


@pytest.mark.parametrize("steps", [1, 2, 4])
@pytest.mark.parametrize("place", [100.0, 101.3, 103.75, 111.0])
def test_an_edge_is_blurred_alike_wherever_it_lies(steps: int, place: float) -> None:
    """The mean and the variance of the steps from texel to texel, which a plain mean over squares does not keep."""
    line = np.clip(np.arange(1, 257) - place, 0, 1)
    for _ in range(steps):
        line = halved_line(line)
    changes, places = np.diff(line), np.arange(1, len(line)) * 2.0**steps
    changes[len(changes) // 2 + 8 // 2**steps + 4 :] = 0
    mean = (changes * places).sum()
    assert changes.sum() == pytest.approx(1.0)
    assert mean == pytest.approx(place, abs=0.01)
    # Texel by texel the samples of an edge have the variance of what they are means of, and a twelfth besides.
    spread = (changes * (places - mean) ** 2).sum() / 4.0**steps
    assert spread == pytest.approx(variance_of(steps) + 1 / 12, abs=0.17 / 4.0**steps + 0.005)


@given(st.integers(0, 60), st.integers(1, 40))
def test_what_may_hold_something_after_halving_is_known(first: int, count: int) -> None:
    line = np.zeros(128)
    line[first : first + count] = 1.0
    held = np.nonzero(halved_line(line))[0]
    box = halved(Box(first, first, first + count, first + count))
    assert (max(box.left, 0), box.right) == (held.min(), held.max() + 1)
