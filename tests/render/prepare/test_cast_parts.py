"""How fine a shadow is cast for its strips, and that each part holds what they need of it."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.bands import Blur, Extent, bands_of
from kagezou.render.prepare.band_atlas import laid_out
from kagezou.render.prepare.cast_parts import CastPart, cast_parts, steps_to
from kagezou.render.prepare.filter_job import Chart, FilterJob
from tests.render.prepare.filter_jobs import cast_of, job_of, scene_with


def job_with(blur: Blur, extent: Extent) -> FilterJob:
    chart = Chart(extent, laid_out(bands_of(blur, extent)))
    return replace(job_of(cast_of(scene_with({"layers.A.shadow.simplify": 20.0}))), blur=blur, charts=(chart,))


@given(
    st.floats(1.0, 300.0),
    st.one_of(st.just(0.0), st.floats(20.0, 900.0)),
    st.floats(50.0, 6000.0),
    st.floats(50.0, 6000.0),
)
def test_every_strip_finds_what_it_needs(amount: float, distance: float, width: float, height: float) -> None:
    job = job_with(Blur(amount, distance), Extent(-width / 3, -height, 2 * width / 3, 40.0))
    (chart,) = job.charts
    for strip in chart.strips:
        (part,) = (part for part in cast_parts(chart) if part.is_for(strip))
        levels, needed = part.levels(chart), strip.band.needed
        assert part.finest <= strip.band.level <= part.coarsest
        assert steps_to(chart)[strip] == strip.band.level - part.finest
        box, texel = levels.box_of(strip.band.level), strip.band.texel_px
        low = levels.corner_of(strip.band.level)[1] * texel
        # Of the shadow; beyond it there is nothing to be found.
        assert low <= max(needed.low, chart.extent.low)
        assert low + box.height * texel >= min(needed.high, chart.extent.high)


def test_only_near_the_contact_line_it_is_cast_fine() -> None:
    job = job_with(Blur(40.0, 200.0), Extent(-392.0, -511.0, 183.0, 1.0))
    fine, coarse = cast_parts(job.charts[0])
    assert (fine.finest, coarse.finest) == (0, 1)
    heights = [part.levels(job.charts[0]).height for part in (fine, coarse)]
    assert heights[0] < 200
    assert heights[1] == pytest.approx(256, abs=40)


def test_while_the_filter_changes_a_little_the_parts_stay() -> None:
    extent = Extent(-392.0, -511.0, 183.0, 1.0)
    first, second = (cast_parts(job_with(Blur(40.0, d), extent).charts[0]) for d in (200.0, 204.0))
    assert first == second


def parts_of_sheets(extent: Extent) -> tuple[CastPart, ...]:
    return cast_parts(Chart(extent, laid_out(bands_of(Blur(40.0, 200.0), extent, (extent.low, extent.high))), number=1))


def test_a_small_chart_with_sheets_is_cast_once() -> None:
    (only,) = parts_of_sheets(Extent(-200.0, -500.0, 200.0, 20.0))
    assert only.finest == 0
    assert set(only.served) == {0, 1, 2, 3}
    assert [part.finest for part in parts_of_sheets(Extent(-600.0, -800.0, 500.0, 20.0))] == [0, 1]


def test_a_chart_with_sheets_that_lies_far_from_the_contact_line_is_cast_once_and_no_finer_than_it_is_blurred() -> None:
    far = Extent(-600.0, -880.0, 560.0, -60.0)
    (only,) = parts_of_sheets(far)
    assert only.finest == min(only.served) == 1
    assert [part.finest for part in cast_parts(job_with(Blur(40.0, 200.0), far).charts[0])] == [0, 1]
