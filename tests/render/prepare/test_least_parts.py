"""Small islands and holes, against a flood fill of single pixels."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from kagezou.render.prepare.least_parts import without_least_parts

FULL = 65535
SIDE = 60


def parts_of(mask: NDArray[np.bool_], *, diagonal: bool) -> list[list[tuple[int, int]]]:
    """The connected parts, one pixel after another."""
    steps = [(0, 1), (1, 0), (0, -1), (-1, 0)] + [(a, b) for a in (-1, 1) for b in (-1, 1) if diagonal]
    left = {(int(y), int(x)) for y, x in zip(*np.nonzero(mask), strict=True)}
    found = []
    while left:
        ahead = [left.pop()]
        part = []
        while ahead:
            y, x = ahead.pop()
            part.append((y, x))
            for dy, dx in steps:
                if (y + dy, x + dx) in left:
                    left.remove((y + dy, x + dx))
                    ahead.append((y + dy, x + dx))
        found.append(part)
    return found


def plainly(mask: NDArray[np.bool_], least: float) -> NDArray[np.bool_]:
    """The same for pixels that are wholly covered or not at all."""
    height, width = mask.shape
    kept = np.pad(mask, 1)
    for hole in parts_of(~kept, diagonal=False):
        if (0, 0) not in hole and len(hole) < least:
            for place in hole:
                kept[place] = True
    kept = kept[1:-1, 1:-1].copy()
    for island in parts_of(kept, diagonal=True):
        inner = all(0 < y < height - 1 and 0 < x < width - 1 for y, x in island)
        if inner and len(island) < least:
            for place in island:
                kept[place] = False
    return kept


@given(st.integers(0, 2**32 - 1), st.floats(0.1, 0.9), st.sampled_from([2, 3, 6, 15, 60]), st.integers(3, 17))
def test_whole_pixels(seed: int, share: float, least: int, width: int) -> None:
    mask = np.random.default_rng(seed).random((14, width)) < share
    found = without_least_parts(mask.astype(np.uint16) * np.uint16(FULL), least)
    assert (found == plainly(mask, least) * FULL).all()


def drawn(*shapes: tuple[float, float, float], holes: tuple[tuple[float, float, float], ...] = ()) -> NDArray[Any]:
    """Return anti-aliased discs (x, y, radius), with holes in them."""
    return softly(1.0, *shapes, holes=holes)


def softly(
    width: float, *shapes: tuple[float, float, float], holes: tuple[tuple[float, float, float], ...] = ()
) -> NDArray[Any]:
    y, x = np.mgrid[0:SIDE, 0:SIDE] + 0.5
    distance = np.min([np.hypot(x - a, y - b) - r for a, b, r in shapes], axis=0)
    for a, b, r in holes:
        distance = np.maximum(distance, r - np.hypot(x - a, y - b))
    return np.asarray(np.round(FULL * np.clip(0.5 - distance / width, 0, 1)), np.uint16)


BIG = (25.0, 30.0, 18.0)


@pytest.mark.parametrize("width", [1.0, 4.0])
def test_the_rim_goes_with_its_island(width: float) -> None:
    found = without_least_parts(softly(width, BIG, (52.0, 12.0, 3.5)), 60)
    assert (found == softly(width, BIG)).all()


@pytest.mark.parametrize("width", [1.0, 4.0])
def test_the_rim_of_a_hole_is_filled_with_it(width: float) -> None:
    found = without_least_parts(softly(width, BIG, holes=((22.3, 31.7, 3.5),)), 60)
    assert (found == softly(width, BIG)).all()


def test_what_is_as_large_stays_with_every_pixel() -> None:
    shadow = drawn(BIG, (52.0, 12.0, 3.5), holes=((22.3, 31.7, 3.5),))
    assert without_least_parts(shadow, 30) is shadow
    assert without_least_parts(shadow, 0) is shadow


def test_an_island_in_a_hole_goes_with_the_hole() -> None:
    found = without_least_parts(drawn(BIG, holes=((25.0, 30.0, 6.0),)) | drawn((25.0, 30.0, 2.5)), 150)
    assert (found == drawn(BIG)).all()


def test_a_ring_is_an_island_whatever_is_in_it() -> None:
    ring = drawn((48.0, 12.0, 6.0), holes=((48.0, 12.0, 4.0),))
    found = without_least_parts(drawn(BIG) | ring, 150)
    assert (found == drawn(BIG)).all()


def test_what_runs_out_of_the_picture_stays() -> None:
    """How large it is cannot be known, and while it leaves it must not vanish at once."""
    shadow = drawn(BIG, (60.0, 10.0, 4.0), holes=((7.0, 30.0, 2.0),))
    assert without_least_parts(shadow, 100) is shadow


def test_the_rim_between_two_is_left_to_the_one_that_stays() -> None:
    near = drawn(BIG, (47.6, 30.0, 3.0))
    found = without_least_parts(near, 60).astype(int)
    alone = drawn(BIG).astype(int)
    assert np.abs(found - alone)[:, :43].max() == 0
    assert found[:, 46:].max() == 0


def test_a_faint_shadow_has_its_own_level() -> None:
    shadow = drawn(BIG, (52.0, 12.0, 3.5), holes=((22.3, 31.7, 3.5),)) // 4
    found = without_least_parts(shadow, 60)
    assert (found == drawn(BIG) // 4).all()


def test_nothing_is_nothing() -> None:
    empty = np.zeros((5, 7), np.uint16)
    assert without_least_parts(empty, 10) is empty
    none = np.zeros((0, 0), np.uint16)
    assert without_least_parts(none, 10) is none


def test_where_nothing_is_left_nothing_is() -> None:
    assert not without_least_parts(drawn((30.0, 30.0, 4.0)), 500).any()
