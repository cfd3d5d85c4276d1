"""Bands of a receiver: where each blur is done, without a gap and without needless work."""

from itertools import pairwise
from math import inf, pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.bands import (
    LARGEST_TEXEL_PX,
    MOST_TEXELS,
    MOST_TEXELS_A_SIGMA,
    REACH_SIGMAS,
    SHARP_SIGMA_PX,
    TEXELS_A_DISTANCE,
    TEXELS_A_GROWTH,
    TEXELS_A_SIGMA,
    Band,
    Blur,
    Extent,
    bands_of,
    felt_by,
)

BEHIND = Extent(-200.0, -600.0, 300.0, 1.0)


def test_the_blur_grows_to_its_amount_over_the_distance() -> None:
    blur = Blur(40.0, 200.0)
    assert [blur.sigma_at(v) for v in (0.0, -50.0, 100.0, 200.0, 900.0)] == [0.0, 10.0, 20.0, 40.0, 40.0]
    assert blur.distance_of(10.0) == 50.0
    assert blur.distance_of(41.0) == inf
    assert Blur(40.0, 0.0).sigma_at(0.0) == 40.0
    softening = Blur(30.0, 200.0, 10.0, 0.1)
    assert [softening.sigma_at(v) for v in (0.0, 300.0)] == [10.0, 50.0]
    assert [softening.distance_of(sigma) for sigma in (10.0, 50.0)] == [0.0, 300.0]


def nothing_or(least: float, most: float) -> st.SearchStrategy[float]:
    return st.just(0.0) | st.floats(least, most)


@given(
    nothing_or(0.01, 500.0), nothing_or(0.01, 5e3), nothing_or(0.01, 50.0), nothing_or(1e-4, 1.0), st.floats(0.0, 3e3)
)
def test_the_distance_of_a_width_is_where_it_is_that_wide(
    amount: float, distance: float, base: float, slope: float, away: float
) -> None:
    blur = Blur(amount, distance, base, slope)
    sigma = blur.sigma_at(away)
    first = blur.distance_of(sigma)
    # Where the width hardly changes, numbers do not tell one place from another.
    assert first <= away * (1 + 1e-6) + 1e-3 or blur.sigma_at(first) == pytest.approx(sigma, rel=1e-13)
    assert blur.sigma_at(first) == pytest.approx(sigma, rel=1e-6, abs=1e-6)


def test_the_faster_a_blur_grows_the_finer_it_is_done() -> None:
    """Where it has stopped growing not at once: what is below its kink is blurred into what is above."""
    assert Blur(20.0, 200.0).texels_a_distance(100.0) == TEXELS_A_DISTANCE
    assert Blur(200.0, 200.0).texels_a_distance(100.0) == TEXELS_A_GROWTH
    assert Blur(200.0, 200.0).texels_a_distance(300.0) == TEXELS_A_GROWTH
    assert Blur(200.0, 200.0).texels_a_distance(400.0) == TEXELS_A_DISTANCE
    assert Blur(0.0, 0.0, 1.0, 0.5).texels_a_distance(9.0) == 0.5 * TEXELS_A_GROWTH


@given(nothing_or(0.01, 500.0), nothing_or(0.01, 5e3), st.floats(0.8, 50.0), nothing_or(1e-4, 1.0))
def test_an_edge_of_its_own_leaves_nothing_sharp(amount: float, distance: float, base: float, slope: float) -> None:
    blur = Blur(amount, distance, base, slope)
    bands = bands_of(blur, Extent(-200.0, -600.0, 300.0, 400.0))
    covered = sorted((band.core.low, band.core.high) for band in bands)
    assert covered[0][0] < -600.0
    assert covered[-1][1] > 400.0
    for (_, end), (start, _) in pairwise(covered):
        assert end == pytest.approx(start, abs=1e-6)


@pytest.mark.parametrize("amount", [0.0, 0.3, SHARP_SIGMA_PX])
def test_a_blur_too_small_to_see_has_no_bands(amount: float) -> None:
    assert bands_of(Blur(amount, 0.0), BEHIND) == ()
    assert bands_of(Blur(amount, 100.0), BEHIND) == ()


@given(st.floats(0.8, 500.0))
def test_the_same_blur_everywhere_is_one_band_of_some_texels_a_sigma(amount: float) -> None:
    (band,) = bands_of(Blur(amount, 0.0), BEHIND)
    assert band.level == 0 or amount / band.texel_px >= TEXELS_A_SIGMA
    assert band.texel_px <= max(2 * LARGEST_TEXEL_PX, amount / MOST_TEXELS_A_SIGMA)
    assert band.reach_texels <= REACH_SIGMAS * max(2 * TEXELS_A_SIGMA, 2 * MOST_TEXELS_A_SIGMA)
    assert band.core.low < BEHIND.low < BEHIND.high < band.core.high


def test_a_small_shadow_needs_no_more_room_for_a_wider_blur() -> None:
    """The shape grows into a disc at most, and nothing is summed up from beyond the shadow."""
    (wide,) = bands_of(Blur(500.0, 0.0), Extent(0.0, -30.0, 20.0, 0.0))
    assert wide.core.right - wide.core.left < 60
    assert wide.level == 0
    assert wide.reach_texels < 60


def inner_and_outer(band: Band) -> tuple[float, float]:
    low, high = sorted((abs(band.core.low), abs(band.core.high)))
    return low, high


@given(st.floats(1.0, 500.0), st.floats(1.0, 5000.0))
def test_bands_follow_each_other_without_a_gap(amount: float, distance: float) -> None:
    bands = [band for band in bands_of(Blur(amount, distance), BEHIND) if band.core.high <= 0]
    ends = sorted(inner_and_outer(band) for band in bands)
    for (_, end), (start, _) in pairwise(ends):
        assert end == pytest.approx(start)
    if ends:
        assert ends[0][0] == pytest.approx(Blur(amount, distance).distance_of(SHARP_SIGMA_PX))


@given(st.floats(1.0, 500.0), st.floats(1.0, 5000.0))
def test_no_band_is_coarser_than_its_blur_allows(amount: float, distance: float) -> None:
    blur = Blur(amount, distance)
    for band in bands_of(blur, Extent(-200.0, -600.0, 300.0, 400.0)):
        inner, outer = inner_and_outer(band)
        if band.level > 0:
            assert blur.sigma_at(inner) >= 0.999 * TEXELS_A_SIGMA * band.texel_px
            assert inner >= 0.999 * blur.texels_a_distance(inner) * band.texel_px
        assert not inner < distance < outer
        assert (band.needed.left % band.texel_px, band.needed.low % band.texel_px) == (0.0, 0.0)


@given(st.floats(1.0, 500.0), st.floats(1.0, 5000.0))
def test_bands_of_one_level_are_one_but_where_the_blur_stops_growing(amount: float, distance: float) -> None:
    for side in (-1, 1):
        bands = bands_of(Blur(amount, distance), Extent(-200.0, -600.0, 300.0, 400.0))
        own = sorted((inner_and_outer(band)[1], band.level) for band in bands if band.core.high * side > 0)
        for (end, level), (_, following) in pairwise(own):
            assert level != following or end == distance


def test_the_side_without_shadow_is_left_alone_where_no_blur_reaches_over() -> None:
    assert all(band.core.high <= 0 for band in bands_of(Blur(40.0, 200.0), BEHIND))
    assert any(band.core.low >= 0 for band in bands_of(Blur(200.0, 60.0), BEHIND))


def test_what_is_needed_holds_what_is_shown_and_that_the_core() -> None:
    for band in bands_of(Blur(90.0, 120.0), BEHIND):
        for outer, inner in ((band.needed, band.shown), (band.shown, band.core)):
            assert outer.left <= inner.left
            assert outer.right >= inner.right
            assert outer.low <= inner.low
            assert outer.high >= inner.high


@pytest.mark.parametrize("distance", [0.0, 100.0])
def test_a_shadow_that_runs_far_is_blurred_on_coarser_texels(distance: float) -> None:
    for band in bands_of(Blur(2.0, distance), Extent(-8000.0, -8000.0, 8000.0, 1.0)):
        assert (band.needed.right - band.needed.left) / band.texel_px < 1.2 * MOST_TEXELS
        assert (band.needed.high - band.needed.low) / band.texel_px < 1.2 * MOST_TEXELS


def test_where_no_shadow_is_there_is_no_band() -> None:
    """A shadow far from the contact line, of a drawing that floats."""
    far = Extent(0.0, 900.0, 100.0, 1000.0)
    lowest = min(band.core.low for band in bands_of(Blur(40.0, 1000.0), far))
    assert lowest == pytest.approx(900.0 - min(REACH_SIGMAS * 40.0, 1.1 * (1e4 / pi) ** 0.5 + 2.0))


@given(st.floats(1.0, 300.0), st.one_of(st.just(0.0), st.floats(20.0, 900.0)), st.floats(-400.0, 300.0))
def test_nothing_is_blurred_into_a_window_from_beyond_what_it_feels(amount: float, distance: float, low: float) -> None:
    blur, shown = Blur(amount, distance, 1.0, 0.05), Extent(-50.0, low, 70.0, low + 250.0)
    felt = felt_by(blur, shown)
    for part in range(101):
        v = low + 2.5 * part
        reach = REACH_SIGMAS * blur.sigma_at(v)
        assert felt.low <= v - reach + 1e-6
        assert felt.high >= v + reach - 1e-6
        assert felt.left <= shown.left - reach + 1e-6
    assert felt.low >= shown.low - REACH_SIGMAS * blur.sigma_at(max(abs(low), abs(low + 250.0))) - 1e-6


@pytest.mark.parametrize("blur", [Blur(40.0, 200.0), Blur(40.0, 0.0)])
def test_of_a_part_that_is_looked_at_the_bands_show_no_more(blur: Blur) -> None:
    known, seen = Extent(-100.0, -600.0, 150.0, 20.0), (-500.0, -60.0)
    bands = bands_of(blur, known, seen)
    assert bands
    for band in bands:
        assert seen[0] <= band.core.low < band.core.high <= seen[1]
        assert (band.core.left, band.core.right) == (known.left, known.right)
        reach = REACH_SIGMAS * max(blur.sigma_at(band.core.low), blur.sigma_at(band.core.high))
        assert band.needed.low <= max(band.core.low - reach, known.low)
        assert band.needed.high >= min(band.core.high + reach, known.high)
    assert sum(band.core.high - band.core.low for band in bands) == pytest.approx(440.0)
    assert not bands_of(Blur(40.0, 200.0), known, (-2.0, 2.0))
