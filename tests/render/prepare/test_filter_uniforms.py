"""The numbers of a filtered shadow, read back as ``passes/shape.frag`` reads them, against the job they are made of."""

from collections.abc import Mapping
from statistics import NormalDist

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.bands import FINEST_SIGMA_PX, SHARP_SIGMA_PX
from kagezou.render.prepare.filter_job import BlurView, FilterJob
from kagezou.render.prepare.filter_uniforms import MAX_BANDS, MAX_JOINS, shape_uniforms, strength, width_uniforms
from kagezou.render.prepare.set_as_seen import SetAsSeen
from kagezou.render.prepare.set_receivers import views_of
from kagezou.render.prepare.uniforms import Uniform
from tests.render.prepare.filter_jobs import CANVAS, ELONGATED, cast_of, job_of, scene_with, scene_with_a_corner

SHADOW = "layers.A.shadow."
SIMPLIFIED = {SHADOW + "simplify": 12.0}
WIDENING = {SHADOW + "simplify": 40.0, SHADOW + "distance": 200.0}
SOFT = {SHADOW + "softness": 6.0, SHADOW + "penumbra": 0.05, SHADOW + "grow": -3.0}
WAVES = {
    SHADOW + "wave1.amplitude": 9.0,
    SHADOW + "wave1.wavelength": 70.0,
    SHADOW + "wave1.direction": 65.0,
    SHADOW + "wave1.sideways": -1.7,
    SHADOW + "wave1.depth_shear": 0.6,
    SHADOW + "wave2.sideways_shear": -0.9,
    SHADOW + "wave2.depth": 0.2,
    SHADOW + "wave2.amplitude": 4.0,
    SHADOW + "wave2.wavelength": 31.0,
    "ground.roll": 7.0,
    "layers.A.grounding": [[440.0, 890.0], [565.0, 860.0]],
}


def job_with(values: Mapping[str, object], stretch: np.ndarray | None = None) -> FilterJob:
    return job_of(cast_of(scene_with(values)), stretch)


def table(uniforms: Mapping[str, Uniform], name: str) -> np.ndarray:
    found = uniforms[name]
    assert isinstance(found, np.ndarray)
    return found


def shown(view: BlurView, level: float = 0.5) -> tuple[frozenset[str], dict[str, Uniform]]:
    return shape_uniforms(view, CANVAS, level)


JOBS = {"even": job_with(SIMPLIFIED), "widening": job_with(WIDENING), "elongated": job_with(WIDENING, ELONGATED)}


@pytest.mark.parametrize("name", JOBS)
def test_a_place_is_read_in_the_band_whose_core_holds_it(name: str) -> None:
    job = JOBS[name]
    _, uniforms = shown(BlurView.of_ground(job, CANVAS))
    cores, places, sizes = (table(uniforms, each) for each in ("u_cores", "u_places", "u_sizes"))
    assert len(cores) == len(places) == len(sizes) == MAX_BANDS
    assert uniforms["u_bands"] == (0.0, float(len(job.strips)))
    for number, strip in enumerate(job.strips):
        core = strip.band.core
        for part in (0.01, 0.5, 0.99):
            u, v = core.left + part * (core.right - core.left), core.low + part * (core.high - core.low)
            near, far, side, texel = cores[:, 0], cores[:, 1], cores[:, 2], cores[:, 3]
            holds = (side == 0) | ((np.abs(v) >= near) & (np.abs(v) < far) & (v * side >= 0))
            assert np.flatnonzero(holds[: len(job.strips)]).tolist() == [number]
            texels = (np.array([u, v]) - places[number, :2]) / texel[number] + places[number, 2:]
            assert (strip.plane_from_atlas @ [*texels, 1.0])[:2] == pytest.approx([u, v])
        assert sizes[number, :2].tolist() == [strip.shown.width, strip.shown.height]


@given(st.sampled_from(sorted(JOBS)), st.floats(100, 900), st.floats(650, 990))
def test_a_pixel_sees_its_place_on_the_receiver(name: str, x: float, y: float) -> None:
    job = JOBS[name]
    view = BlurView.of_ground(job, CANVAS)
    _, uniforms = shown(view)
    origin = table(strength(view, CANVAS)[1], "u_origin_px")
    h = table(uniforms, "u_plane_from_pixel") @ [x - origin[0], y - origin[1], 1.0]
    back = job.canvas_from_plane @ [*(h[:2] / h[2]), 1.0]
    assert back[:2] / back[2] == pytest.approx([x, y], abs=1e-6)
    assert h[2] > 0


def test_the_width_of_the_blur_is_told_as_the_blur_has_it() -> None:
    for job in (JOBS["widening"], job_with(SOFT), job_with(SIMPLIFIED | SOFT)):
        amount, distance, base, slope = (
            width_uniforms(job)[f"u_{name}"] for name in ("amount_px", "distance_px", "base_px", "slope")
        )
        assert isinstance(amount, float)
        assert isinstance(distance, float)
        assert isinstance(base, float)
        assert isinstance(slope, float)
        for v in (0.0, 40.0, 300.0):
            part = min(v / distance, 1.0) if distance > 0 else 1.0
            assert np.hypot(amount * part, base + slope * v) == pytest.approx(job.blur.sigma_at(v))


def test_each_thing_done_to_a_shape_has_its_switch() -> None:
    def switches(values: Mapping[str, object]) -> frozenset[str]:
        return shown(BlurView.of_ground(job_with(values), CANVAS))[0]

    assert switches(SIMPLIFIED) == frozenset()
    assert switches(SOFT) == {"EDGE"}
    assert switches(WAVES) == {"WAVES"}
    assert switches(SIMPLIFIED | SOFT | WAVES) == {"EDGE", "WAVES"}
    _, job = scene_with_a_corner(SIMPLIFIED)
    assert shown(BlurView.of_ground(job, CANVAS))[0] == {"JOINED"}


def test_the_level_stands_once() -> None:
    _, plain = shown(BlurView.of_ground(job_with(SIMPLIFIED), CANVAS), 0.3)
    assert plain["u_level"] == 0.3
    assert plain["u_pass_over_px"] == (SHARP_SIGMA_PX, FINEST_SIGMA_PX)
    _, soft = shown(BlurView.of_ground(job_with(SOFT), CANVAS), 0.3)
    assert "u_level" not in soft
    deviations = soft["u_level_deviations"]
    assert isinstance(deviations, float)
    assert NormalDist().cdf(deviations) == pytest.approx(0.3)
    _, nothing = shown(BlurView.of_ground(job_with(SOFT), CANVAS), 0.0)
    assert nothing["u_level_deviations"] == pytest.approx(NormalDist().inv_cdf(1e-5))


def test_an_edge_is_as_wide_on_the_ground_whatever_the_blur_s_own_coordinates() -> None:
    for stretch in (None, ELONGATED):
        job = job_with(SOFT, stretch)
        edge = job.cast.edge
        assert edge is not None
        _, uniforms = shown(BlurView.of_ground(job, CANVAS))
        place = np.array([30.0, 200.0])
        on_ground = job.ground_from_blurred @ place
        softness, penumbra = uniforms["u_softness_px"], uniforms["u_penumbra"]
        assert isinstance(softness, float)
        assert isinstance(penumbra, float)
        assert softness + penumbra * place[1] == pytest.approx(edge.softness_px + edge.penumbra * on_ground[1])
        assert uniforms["u_grow_px"] == edge.grow_px
        back = table(uniforms, "u_blurred_from_ground").reshape(2, 2)
        assert back @ on_ground == pytest.approx(place)


@given(st.floats(-300, 300), st.floats(-200, 400), st.sampled_from([0.0, 120.0]), st.booleans())
def test_waves_move_a_place_as_they_do_on_the_receiver(
    u: float,
    v: float,
    anchor: float,
    is_elongated: bool,  # noqa: FBT001
) -> None:
    job = job_with({**WAVES, SHADOW + "wave_anchor": anchor}, ELONGATED if is_elongated else None)
    water = job.cast.water
    assert water is not None
    assert len(water.ripples) == 2
    assert water.anchor_px == anchor
    _, uniforms = shown(BlurView.of_ground(job, CANVAS))
    assert uniforms["u_ripple_count"] == 2
    total = np.zeros(2)
    for ripple, matrix in zip(table(uniforms, "u_ripples"), table(uniforms, "u_ripple_matrices"), strict=True):
        k_u, k_v, phase, amplitude = ripple
        psi = k_u * u + k_v * v + phase
        total += amplitude * np.array([np.cos(psi), np.sin(psi)]) @ matrix.reshape(2, 2)
    heave = table(uniforms, "u_heave").reshape(2, 2)
    anchor_v = uniforms["u_anchor_px"]
    assert isinstance(anchor_v, float)
    got = (min(abs(v) / anchor_v, 1.0) if anchor_v > 0 else 1.0) * (heave @ total)
    on_receiver = job.receiver_from_blurred @ [u, v, 1.0]
    wanted = np.zeros(2)
    for each in water.ripples:
        psi = np.array(each.k) @ on_receiver + each.phase
        wanted += each.wave.amplitude_px * np.array([np.cos(psi), np.sin(psi)]) @ np.reshape(each.wave.matrix, (2, 2))
    from_line = abs(float(job.ground_from_blurred[1, 1]) * v)
    wanted *= min(from_line / anchor, 1.0) if anchor > 0 else 1.0
    assert job.receiver_from_blurred[:, :2] @ got == pytest.approx(wanted, abs=1e-6)


def test_a_join_leads_to_the_same_place_of_the_other_chart() -> None:
    scene, job = scene_with_a_corner(SIMPLIFIED)
    stage = SetAsSeen.of(scene.camera, CANVAS, scene.ground, scene.pieces)
    views = [view for _, view in views_of(stage, job)]
    assert sum(len(view.joins) for view in views) > 3
    for view in views:
        _, uniforms = shown(view)
        first, last = job.bands_of(view.chart)
        assert uniforms["u_bands"] == (first, last)
        assert uniforms.get("u_join_count", 0) == len(view.joins) <= MAX_JOINS
        for number, join in enumerate(view.joins):
            seam, bands = table(uniforms, "u_seams")[number], table(uniforms, "u_join_bands")[number]
            assert seam.reshape(2, 2) == pytest.approx(view.seam_of(join))
            assert bands.tolist() == [*job.bands_of(join.chart), view.reach_of(join), join.most]
            place = seam[:2] + np.array([3.0, 5.0])
            turned = table(uniforms, "u_join_turns")[number].reshape(2, 2) @ place
            there = turned + table(uniforms, "u_join_shifts")[number, :2]
            assert there == pytest.approx((view.there_from_here(join) @ [*place, 1.0])[:2])


def test_no_light_weakens_a_silhouette() -> None:
    cast = cast_of(scene_with(SIMPLIFIED | {"light.kind": "sun", "light.elevation": 2.0}))
    view = BlurView.of_ground(job_of(cast), CANVAS)
    silhouette = BlurView(view.job, view.receiver, view.canvas_from_blurred, CANVAS, is_silhouette=True)
    weak, full = (strength(each, CANVAS)[1]["u_strength"] for each in (view, silhouette))
    assert isinstance(weak, float)
    assert 0 < weak < 1
    assert full == 1.0
