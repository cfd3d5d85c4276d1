"""Where a filtered shadow may be seen, and which of its values are sure: against places all over the canvas."""

from collections.abc import Mapping
from dataclasses import replace
from statistics import NormalDist

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.bands import FINEST_SIGMA_PX, Extent
from kagezou.geometry.box import Box
from kagezou.render.prepare.filter_boxes import box_near_contact, box_seen, sure_values
from kagezou.render.prepare.filter_job import RAMP, BlurView, FilterJob
from kagezou.render.prepare.set_as_seen import SetAsSeen
from kagezou.render.prepare.set_receivers import views_of
from tests.render.prepare.filter_jobs import CANVAS, ELONGATED, cast_of, job_of, scene_with, scene_with_a_corner

SHADOW = "layers.A.shadow."
SIMPLIFIED = {SHADOW + "simplify": 12.0}
WIDENING = {SHADOW + "simplify": 40.0, SHADOW + "distance": 200.0}
SOFT = {SHADOW + "softness": 6.0, SHADOW + "penumbra": 0.05, SHADOW + "grow": -3.0}
WAVES = {SHADOW + "simplify": 8.0, SHADOW + "wave1.amplitude": 9.0, SHADOW + "wave1.wavelength": 70.0}
STREAKS = {**WAVES, SHADOW + "wave1.sideways": 3.0, SHADOW + "wave1.depth_shear": -2.0, SHADOW + "wave1.depth": 0.3}
PERSPECTIVE = {"camera.fov": 40.0, "ground.roll": 8.0}


def job_with(values: Mapping[str, object], stretch: np.ndarray | None = None) -> FilterJob:
    return job_of(cast_of(scene_with(values)), stretch)


def blurred_at(view: BlurView) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The (u, v) of the blur at the middle of every pixel of the canvas, (H, W), and where the receiver is seen."""
    y, x = np.mgrid[0 : CANVAS.height, 0 : CANVAS.width] + 0.5
    u, v, w = np.tensordot(view.blurred_from_canvas, np.stack([x, y, np.ones_like(x)]), axes=1)
    safe = np.where(w > 0, w, 1.0)
    return u / safe, v / safe, w > 0


def held(box: Box | None) -> np.ndarray:
    mask = np.zeros((CANVAS.height, CANVAS.width), bool)
    if box is not None:
        mask[box.top : box.bottom, box.left : box.right] = True
    return mask


@pytest.mark.parametrize("stretch", [None, ELONGATED], ids=["round", "elongated"])
@pytest.mark.parametrize(
    "values", [SIMPLIFIED, WIDENING, WAVES, WIDENING | PERSPECTIVE], ids=["even", "widening", "waves", "perspective"]
)
def test_what_a_band_shows_lies_within_the_box(values: Mapping[str, object], stretch: np.ndarray | None) -> None:
    job = job_with(values, stretch)
    view = BlurView.of_ground(job, CANVAS)
    u, v, is_seen = blurred_at(view)
    shown = np.zeros_like(is_seen)
    most_u, most_v = job.moved_px
    for strip in view.strips:
        core = strip.band.core
        shown |= (u >= core.left - most_u) & (u <= core.right + most_u)
        shown &= v >= min(strip.band.core.low for strip in view.strips) - most_v
        shown &= v <= max(strip.band.core.high for strip in view.strips) + most_v
    box = box_seen(view, None)
    assert (shown & is_seen).any()
    assert not (shown & is_seen & ~held(box)).any()
    rows, columns = np.nonzero(shown & is_seen)
    tight = Box(int(columns.min()), int(rows.min()), int(columns.max()) + 1, int(rows.max()) + 1)
    assert box is not None
    assert box.intersection(tight.grown(3)) == box


@pytest.mark.parametrize("values", [WIDENING, WIDENING | PERSPECTIVE], ids=["widening", "perspective"])
def test_near_the_contact_line_the_shadow_as_it_was_cast_is_seen(values: Mapping[str, object]) -> None:
    job = job_with(values)
    view = BlurView.of_ground(job, CANVAS)
    u, v, is_seen = blurred_at(view)
    away = job.blur.distance_of(FINEST_SIGMA_PX)
    extent = job.extent
    near = is_seen & (np.abs(v) < away) & (u > extent.left) & (u < extent.right) & (v > extent.low) & (v < extent.high)
    box = box_near_contact(view)
    assert near.any()
    assert not (near & ~held(box)).any()
    assert box is not None
    rows, columns = np.nonzero(near)
    assert box.height <= np.ptp(rows) + 7
    assert box.width <= np.ptp(columns) + 7
    blurred = box_seen(view, None)
    assert blurred is not None
    assert box_seen(view, box) == blurred.union(box)


def test_an_even_blur_has_nothing_sharp() -> None:
    assert box_near_contact(BlurView.of_ground(job_with(SIMPLIFIED), CANVAS)) is None


@pytest.mark.parametrize("stretch", [None, ELONGATED], ids=["round", "elongated"])
def test_tiles_look_as_far_as_waves_move_a_place_and_no_farther(stretch: np.ndarray | None) -> None:
    job = job_with(STREAKS, stretch)
    assert job.cast.water is not None
    (ripple,) = job.cast.water.ripples
    psi = np.linspace(0.0, 2 * np.pi, 721)
    on_receiver = (
        ripple.wave.amplitude_px * np.stack([np.cos(psi), np.sin(psi)], -1) @ np.reshape(ripple.wave.matrix, (2, 2))
    )
    farthest = np.abs(np.linalg.solve(job.receiver_from_blurred[:, :2], on_receiver.T)).max(axis=1)
    assert np.array(job.moved_px) == pytest.approx(farthest, rel=1e-4)


def test_nothing_outside_of_its_receiver_s_box_is_drawn() -> None:
    job = job_with(WIDENING)
    part = Box(100, 850, 420, 930)
    for box in (box_seen(BlurView.of_ground(job, part), None), box_near_contact(BlurView.of_ground(job, part))):
        assert box is not None
        assert box.intersection(part) == box
    assert box_seen(BlurView.of_ground(job, Box(0, 0, 5, 5)), None) is None


def test_where_paper_is_cut_a_receiver_may_show_it_everywhere() -> None:
    scene, job = scene_with_a_corner(SIMPLIFIED)
    stage = SetAsSeen.of(scene.camera, CANVAS, scene.ground, scene.pieces)
    cut = [view for _, view in views_of(stage, job) if any(join.most < 1 for join in view.joins)]
    assert cut, "three faces meet in a corner"
    for view in cut:
        assert box_seen(replace(view, box=CANVAS), None) == CANVAS


@pytest.mark.parametrize("level", [0.02, 0.5, 0.93])
def test_without_an_edge_the_level_alone_decides(level: float) -> None:
    reach = sure_values(job_with(WAVES), level)
    assert reach.empty == reach.full == level
    assert min(reach.moved_px) > 5


@given(st.floats(0.05, 0.95), st.floats(0.0, 1.0))
def test_across_a_straight_edge_sure_values_lie_beyond_all_that_it_becomes(level: float, part: float) -> None:
    """A straight edge blurred is the normal distribution; its outline is where that is at the level."""
    job = SOFT_JOB
    reach = sure_values(job, level)
    first = job.blur.distance_of(FINEST_SIGMA_PX)
    farthest = max(abs(job.extent.low), abs(job.extent.high))
    v = first + part * (farthest - first)
    edge = job.cast.edge
    assert edge is not None
    half = RAMP * (edge.softness_px + edge.penumbra * v)
    for deviations in np.linspace(-4.0, 4.0, 81).tolist():
        value = NormalDist().cdf(NormalDist().inv_cdf(level) + deviations)
        moved_px = deviations * job.blur.sigma_at(v) + edge.grow_px
        assert value > reach.empty or moved_px <= -half
        assert value <= reach.full or moved_px >= half


SOFT_JOB = job_with(SOFT)


def test_a_wider_edge_leaves_fewer_values_sure() -> None:
    narrow, wide = (sure_values(job_with({SHADOW + "softness": width}), 0.5) for width in (2.0, 12.0))
    assert narrow.empty >= wide.empty
    assert narrow.full <= wide.full
    assert sure_values(job_with({SHADOW + "softness": 2.0}), 0.0).empty < 1e-5


@pytest.mark.parametrize(("low", "high"), [(60.0, 300.0), (-300.0, -60.0)])
def test_a_chart_away_from_the_contact_line_has_nothing_of_the_sharp_shadow(low: float, high: float) -> None:
    job = job_with(WIDENING)
    away = replace(job, charts=(replace(job.charts[0], extent=Extent(-100.0, low, 100.0, high)),))
    assert box_near_contact(BlurView.of_ground(away, CANVAS)) is None
