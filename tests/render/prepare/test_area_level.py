"""The level at which a blurred shadow keeps its area, and the bands it is counted in."""

import numpy as np
import pytest

from kagezou.geometry.bands import Blur, Extent, bands_of
from kagezou.render.prepare.area_level import Counted, Floats, area_preserving_level
from kagezou.render.prepare.band_atlas import laid_out

MARGIN = 2


def disc_and_blurred(side: int, radius: float, sigma: float) -> tuple[Floats, Floats]:
    """A disc of ones, and a cone that falls off evenly around it in its stead after a blur."""
    y, x = np.mgrid[0:side, 0:side] - (side - 1) / 2
    distance = np.hypot(x, y)
    sharp = np.clip(radius - distance + 0.5, 0, 1)
    blurred = np.clip(0.5 - (distance - radius) / (4 * sigma), 0, 1)
    return sharp.astype(np.float32), blurred.astype(np.float32)


def test_an_edge_that_falls_off_evenly_keeps_its_place() -> None:
    sharp, blurred = disc_and_blurred(200, 60.0, 8.0)
    level = area_preserving_level([Counted(sharp, blurred, np.ones(200 - 2 * MARGIN), MARGIN)])
    assert level == pytest.approx(0.5, abs=0.003)


def test_a_small_band_is_counted_finely() -> None:
    sharp, blurred = disc_and_blurred(24, 4.0, 1.5)
    level = area_preserving_level([Counted(sharp, blurred, np.ones(24 - 2 * MARGIN), MARGIN)])
    # On a small disc the spline itself rounds the cone a little.
    assert level == pytest.approx(0.5, abs=0.03)


def test_coarse_texels_count_for_their_area() -> None:
    sharp, blurred = disc_and_blurred(100, 30.0, 4.0)
    lost = np.zeros_like(sharp)
    rows = np.ones(100 - 2 * MARGIN)
    level = area_preserving_level([Counted(sharp, blurred, 16 * rows, MARGIN), Counted(sharp, lost, rows, MARGIN)])
    # The area lost in the second band has to be found in the first, whose texels are sixteen times as large.
    grown = 30.0 * np.sqrt(17 / 16)
    assert level == pytest.approx(0.5 - (grown - 30.0) / 16, abs=0.004)


def test_where_tiles_with_an_edge_are_known_the_rest_need_not_be_asked() -> None:
    sharp, blurred = disc_and_blurred(200, 60.0, 4.0)
    rows, counts = np.linspace(0.5, 1.5, 200 - 2 * MARGIN), np.ones((200 - 2 * MARGIN, 200 - 2 * MARGIN), np.bool_)
    counts[60:90, 20:120] = False
    corners = [
        (x, y)
        for y in range(-4, 200, 8)
        for x in range(-4, 200, 8)
        if np.ptp(blurred[max(y, 0) : y + 8, max(x, 0) : x + 8]) > 0
    ]
    assert len(corners) < 400
    whole = Counted(sharp, blurred, rows, MARGIN, counts)
    in_tiles = Counted(sharp, blurred, rows, MARGIN, counts, np.array(corners))
    assert area_preserving_level([in_tiles]) == pytest.approx(area_preserving_level([whole]), abs=1e-5)
    assert in_tiles.area < 0.8 * whole.area


def test_no_shadow_has_a_level_too() -> None:
    empty = np.zeros((20, 20), np.float32)
    assert area_preserving_level([Counted(empty, empty, np.ones(16), MARGIN)]) == 0.5
    assert area_preserving_level([]) == 0.5


def test_rows_count_once_over_all_bands() -> None:
    shadow = Extent(-50.0, -300.0, 50.0, 1.0)
    strips = laid_out(bands_of(Blur(30.0, 150.0), shadow))
    assert len(strips) > 1
    counted = sum(float(strip.row_areas(MARGIN).sum() / strip.band.texel_px) for strip in strips)
    wanted = sum(strip.band.core.high - strip.band.core.low for strip in strips)
    assert counted == pytest.approx(wanted, rel=1e-6)
    tops = [strip.box.top for strip in strips]
    assert tops == sorted(tops)
    assert all(strip.box.top <= strip.shown.top < strip.shown.bottom <= strip.box.bottom for strip in strips)
