"""The charts of a set: that each of them shows whatever a receiver looks up on it near a seam."""

from collections.abc import Iterator, Mapping

import numpy as np
import pytest

from kagezou.geometry.bands import SHARP_SIGMA_PX
from kagezou.geometry.sets.laid_flat import GROUND, Join, lines_of
from kagezou.render.prepare.filter_charts import charted
from kagezou.render.prepare.filter_job import BlurView, FilterJob
from kagezou.render.prepare.set_as_seen import SetAsSeen
from kagezou.render.prepare.set_receivers import receivers_of
from tests.render.prepare.filter_jobs import CANVAS, cast_of, job_of, scene_with

SHADOW = "layers.A.shadow."
WALL = {"kind": "wall", "position": [500.0, 760.0], "width": 900.0, "height": 500.0, "angle": -8.0}
BOXES = {
    f"box {number}": {
        "kind": "box",
        "position": [x, y],
        "angle": angle,
        "width": 140.0,
        "height": 90.0,
        "depth": 90.0,
    }
    for number, (x, y, angle) in enumerate([(640.0, 850.0, 30.0), (395.0, 830.0, 12.0), (560.0, 870.0, -20.0)])
}
LIGHTS = ([620.0, 200.0, 900.0], [300.0, -200.0, 1500.0])


def job_on_a_set(values: Mapping[str, object]) -> FilterJob:
    scene = scene_with({"light.kind": "point", **values}, {"wall": WALL, **BOXES})
    cast = cast_of(scene)
    set_seen = SetAsSeen.of(scene.camera, CANVAS, scene.ground, scene.pieces)
    receivers = receivers_of(set_seen, cast.lights[0])
    return charted(job_of(cast), receivers)


def looked_up(job: FilterJob, join: Join) -> np.ndarray:
    """Places (N, 2) of the other chart that a receiver looks up, all over what it has near the seam."""
    view = BlurView.of_ground(job, CANVAS) if join.sheet == GROUND else BlurView.of_sheet(job, join.sheet, CANVAS)
    seam, reach = view.seam_of(join), view.reach_of(join)
    run = seam[1] - seam[0]
    left = np.array([-run[1], run[0]]) / np.linalg.norm(run)
    along, away = np.meshgrid(np.linspace(0, 1, 21), np.linspace(0, 0.99 * reach, 21))
    places = seam[0] + along.reshape(-1, 1) * run + away.reshape(-1, 1) * left
    if join.sheet == GROUND:
        extent = job.extent
        low, high = (extent.left, extent.low), (extent.right, extent.high)
        places = places[((places >= low) & (places <= high)).all(axis=1)]
    else:
        lines = lines_of(job.development.sheets[join.sheet].corners)
        places = places[(places @ lines[:, :2].T + lines[:, 2] >= 0).all(axis=1)]
    there = view.there_from_here(join)
    return np.asarray(places @ there[:2, :2].T + there[:2, 2])


def in_cores(job: FilterJob, chart: int, places: np.ndarray) -> np.ndarray:
    found = np.zeros(len(places), bool)
    for strip in job.charts[chart].strips:
        core = strip.band.core
        found |= ((places >= (core.left, core.low)) & (places <= (core.right, core.high))).all(axis=1)
    return found


@pytest.mark.parametrize("light", LIGHTS, ids=["low", "high"])
@pytest.mark.parametrize(
    "values",
    [
        {SHADOW + "simplify": 40.0, SHADOW + "distance": 200.0},
        {SHADOW + "simplify": 15.0},
        {SHADOW + "softness": 8.0, SHADOW + "penumbra": 0.05},
    ],
    ids=["widening", "even", "soft"],
)
def test_a_chart_shows_what_receivers_look_up_on_it(values: Mapping[str, object], light: list[float]) -> None:
    job = job_on_a_set({**values, "light.position": light})
    joins = list(_on_charts(job))
    assert joins
    for join in joins:
        places = looked_up(job, join)
        sharp = np.array([job.blur.sigma_at(v) <= SHARP_SIGMA_PX for v in places[:, 1]], bool)
        assert (in_cores(job, join.chart, places) | sharp).all()


def _on_charts(job: FilterJob) -> Iterator[Join]:
    return (join for join in job.development.joins if job.charts[join.chart].strips)
