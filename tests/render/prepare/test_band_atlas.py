"""Bands below each other in one target: whole texels, no overlap, and the way back to the receiver."""

import numpy as np
import pytest

from kagezou.geometry.bands import Blur, Extent, bands_of
from kagezou.render.prepare.band_atlas import laid_out

STRIPS = laid_out(bands_of(Blur(40.0, 200.0), Extent(-120.0, -30.0, 180.0, 700.0)))


def test_strips_lie_below_each_other_without_a_gap() -> None:
    assert len(STRIPS) > 1
    tops = [strip.box.top for strip in STRIPS]
    assert tops == [0, *[strip.box.bottom for strip in STRIPS[:-1]]]
    assert {strip.box.left for strip in STRIPS} == {0}


@pytest.mark.parametrize("strip", STRIPS)
def test_a_strip_leads_back_to_the_receiver(strip: object) -> None:
    from kagezou.render.prepare.band_atlas import Strip

    assert isinstance(strip, Strip)
    needed, box = strip.band.needed, strip.box
    low = strip.plane_from_atlas @ np.array([box.left, box.top, 1.0])
    high = strip.plane_from_atlas @ np.array([box.right, box.bottom, 1.0])
    assert low[:2] == pytest.approx([needed.left, needed.low])
    assert (high[:2] >= np.array([needed.right, needed.high]) - 1e-9).all()
    assert (high[:2] - np.array([needed.right, needed.high]) <= strip.band.texel_px + 1e-9).all()


@pytest.mark.parametrize("margin", [0, 2])
def test_the_rows_of_a_strip_count_the_area_of_its_core_once(margin: int) -> None:
    for strip in STRIPS:
        core, texel = strip.band.core, strip.band.texel_px
        whole = (core.high - core.low) * texel
        assert strip.row_areas(margin).sum() == pytest.approx(whole)
        assert len(strip.row_areas(margin)) == strip.shown.height - 2 * margin
