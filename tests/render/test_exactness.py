"""What "right" means (spec 7): the renderer against float64 rays, over a sweep of everything that moves a shadow."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from tests.effort import tries
from tests.render.reference import raycast
from tests.render.reference.figures import figure_alpha, standing, with_values, write_figure

MIN_IOU = 0.998
MAX_MEAN_ERROR = 0.002
MIN_SHADOW_PX = 3000
"""A sliver thinner than this is decided by the rays of the reference, not by the renderer."""

Values = dict[str, object]
Rays = Callable[[int, raycast.Array | None], raycast.Array]
"""What makes the reference of so many rays a pixel, out of one of fewer."""


@dataclass(frozen=True)
class Agreement:
    """How well two coverages (H, W) agree; the mean error is over the pixels that either holds, not the canvas."""

    iou: float
    mean_error: float

    @property
    def is_right(self) -> bool:
        """Whether it meets the figures of the specification."""
        return self.iou >= MIN_IOU and self.mean_error <= MAX_MEAN_ERROR

    @staticmethod
    def of(got: NDArray[np.float64], wanted: NDArray[np.float64]) -> "Agreement":
        held = np.maximum(got, wanted)
        return Agreement(
            iou=float(np.minimum(got, wanted).sum() / held.sum()),
            mean_error=float(np.abs(got - wanted).sum() / (held > 0).sum()),
        )

    @staticmethod
    def by_rays(got: raycast.Array, wanted: "Rays", *counts: int) -> "Agreement":
        """Compare with a reference of so many rays a pixel; again with more of them where few leave it in doubt."""
        before = None
        for count in counts:
            before = wanted(count, before)
            found = Agreement.of(got, before)
            if found.is_right:
                break
        return found


RAYS = (120, 400, 1500)


def random_light(rng: np.random.Generator) -> Values:
    if rng.random() < 0.4:
        return {
            "light.kind": "sun",
            "light.azimuth": float(rng.uniform(-60, 60) + rng.choice([0, 180])),
            "light.elevation": float(rng.uniform(18, 75)),
        }
    z = float(rng.uniform(350, 1500) * rng.choice([1, 1, -1]))
    return {"light.position": [float(rng.uniform(-300, 1300)), float(rng.uniform(-1600, -300)), z]}


def random_body(rng: np.random.Generator) -> Values:
    count = int(rng.integers(0, 4))
    if count == 0:
        return {"layers.A.tilt": float(rng.uniform(-35, 35))}
    points = [[float(x), float(rng.uniform(880, 905))] for x in np.linspace(430, 580, count)]
    return {"layers.A.grounding": points} | ({"layers.A.tilt": float(rng.uniform(-35, 35))} if count == 1 else {})


def random_case(seed: int) -> Values:
    rng = np.random.default_rng(seed)
    ground = {
        "ground.declination": float(rng.uniform(25, 78)),
        "ground.roll": float(rng.uniform(-12, 12)),
        "camera.fov": float(rng.choice([0, 0, 20, 40, 60])),
    }
    matte = {"layers.A.shadow.matte": "translucent" if rng.random() < 0.15 else "solid"}
    return ground | random_light(rng) | random_body(rng) | matte


def judged(renderer: Renderer, figure: Path, seed: int) -> Agreement | None:
    """Compare one case with the rays. None for a sliver."""
    scene = evaluate(with_values(standing(figure), random_case(seed)), 1)
    layer = scene.layers[0]
    got = renderer.coverage(scene, layer) / 65535
    if got.sum() < MIN_SHADOW_PX or layer.cast is None:
        return None
    art = raycast.Art(figure_alpha() / 255)
    cast = layer.cast
    return Agreement.by_rays(got, partial(raycast.coverage, cast, art, got), *RAYS)


def test_the_closed_form_agrees_with_rays_over_a_sweep(renderer: Renderer, figure: Path) -> None:
    results = {seed: judged(renderer, figure, seed) for seed in range(tries(20, 64))}
    cases = {seed: each for seed, each in results.items() if each is not None}
    assert len(cases) >= tries(14, 48)
    assert not {seed: each for seed, each in cases.items() if not each.is_right}


@pytest.mark.parametrize("seed", range(tries(3, 6)))
def test_the_depth_map_agrees_with_the_closed_form(renderer: Renderer, figure: Path, seed: int) -> None:
    values = random_case(1000 + seed) | {"layers.A.shadow.matte": "solid"}
    scene = evaluate(with_values(standing(figure), values), 1)
    exact = renderer.coverage(scene, scene.layers[0]) >= 32768
    mapped = renderer.depth_map_coverage(scene, scene.layers[0]) >= 32768
    assert exact.sum() > MIN_SHADOW_PX
    assert (exact & mapped).sum() / (exact | mapped).sum() >= 0.99


def test_the_overhead_area_unites_four_lights(renderer: Renderer, figure: Path) -> None:
    values: Values = {"light.position": [520.0, -900.0, 30.0], "light.overhead_radius": 300.0}
    scene = evaluate(with_values(standing(figure), values), 1)
    cast = scene.layers[0].cast
    assert cast is not None
    assert len(cast.lights) == 4
    got = renderer.coverage(scene, scene.layers[0]) / 65535
    assert Agreement.of(got, raycast.coverage(cast, raycast.Art(figure_alpha() / 255), got)).is_right


def test_a_folded_card_under_four_lights_is_not_darkened_twice(renderer: Renderer, figure: Path) -> None:
    values: Values = {
        "light.position": [520.0, -900.0, 30.0],
        "light.overhead_radius": 300.0,
        "layers.A.grounding": [[440.0, 898.0], [500.0, 885.0], [565.0, 900.0]],
    }
    scene = evaluate(with_values(standing(figure), values), 1)
    cast = scene.layers[0].cast
    assert cast is not None
    got = renderer.coverage(scene, scene.layers[0]) / 65535
    art = raycast.Art(figure_alpha() / 255)
    assert Agreement.by_rays(got, partial(raycast.coverage, cast, art, got), *RAYS).is_right


def test_edges_stay_exact_when_the_shadow_is_magnified(renderer: Renderer, tmp_path: Path) -> None:
    """A drawing of 100 px seen at four times its size through a lamp close by."""
    small = figure_alpha(100)
    document = with_values(
        standing(write_figure(tmp_path / "small.png", small), 100),
        {"light.position": [50.0, -12.0, 30.0], "ground.declination": 35.0},
    )
    scene = evaluate(document, 1)
    layer = scene.layers[0]
    assert layer.cast is not None
    got = renderer.coverage(scene, layer) / 65535
    wanted = raycast.coverage(layer.cast, raycast.Art(small / 255), got, rays=400)
    assert Agreement.of(got, wanted).iou >= 0.995
    assert np.abs(got - wanted).max() < 0.25


def test_grounding_points_are_their_own_shadows(renderer: Renderer, figure: Path) -> None:
    """The shadow begins where the foot stands: no gap between a sole and its shadow, whatever the light."""
    for seed in range(tries(4, 8)):
        rng = np.random.default_rng(seed)
        values = {"layers.A.grounding": [[440.0, 899.0], [565.0, 897.0]]} | random_light(rng)
        scene = evaluate(with_values(standing(figure), values), 1)
        coverage = renderer.coverage(scene, scene.layers[0]) / 65535
        for x, y in ((440, 899), (565, 897)):
            assert coverage[y - 3 : y + 4, x - 3 : x + 4].max() > 0.9
