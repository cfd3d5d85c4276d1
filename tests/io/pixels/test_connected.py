"""Connected parts of masks, against parts found pixel after pixel."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.io.pixels.connected import Runs, part_areas
from tests.render.prepare.test_least_parts import parts_of


@given(st.integers(1, 12), st.integers(1, 12), st.integers(0, 2**32 - 1), st.floats(0.1, 0.9), st.booleans())
def test_every_part_is_found_with_its_area(height: int, width: int, seed: int, filled: float, diagonal: bool) -> None:  # noqa: FBT001 - drawn by hypothesis
    mask = np.random.default_rng(seed).random((height, width)) < filled
    parts = parts_of(mask, diagonal=diagonal)
    assert part_areas(mask, diagonal=diagonal).tolist() == sorted(map(len, parts), reverse=True)
    padded = np.pad(mask, 1)
    runs = Runs.of(padded, diagonal=diagonal)
    assert np.array_equal(runs.mask(np.ones(len(runs.starts), np.bool_), padded.shape), padded)
    at_border = np.zeros_like(padded)
    for part in parts:
        if any(y in (0, height - 1) or x in (0, width - 1) for y, x in part):
            for y, x in part:
                at_border[y + 1, x + 1] = True
    assert np.array_equal(runs.mask(runs.reach_border(padded.shape), padded.shape), at_border)


@pytest.mark.parametrize("shape", [(0, 5), (5, 0), (3, 3)])
def test_an_empty_mask_has_none(shape: tuple[int, int]) -> None:
    assert part_areas(np.zeros(shape, np.bool_), diagonal=True).tolist() == []
