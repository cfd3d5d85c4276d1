"""Filters on meshes and round bodies: what falls there is cast by the filtered silhouette."""

from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest

from kagezou.document.set_pieces import add_piece
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from kagezou.scene.scene import Scene
from tests.render.reference.figures import standing, with_values
from tests.render.reference.mesh_scenes import Array, Meshes, heights_mesh, with_pieces
from tests.render.reference.outlines import Shift

SHADOW = "layers.A.shadow."
FILTERS: dict[str, dict[str, object]] = {
    "simplified": {SHADOW + "simplify": 30.0},
    "with the distance": {SHADOW + "simplify": 40.0, SHADOW + "distance": 200.0},
    "in waves": {SHADOW + "simplify": 12.0, SHADOW + "wave1.amplitude": 6.0, SHADOW + "wave1.wavelength": 90.0},
    "opened": {SHADOW + "simplify": 12.0, SHADOW + "slits": 0.8, SHADOW + "slit_growth": 0.1},
    "grown": {SHADOW + "grow": 6.0},
}
VIEWS: dict[str, dict[str, object]] = {
    "lamp": {},
    "sun, perspective": {"light.kind": "sun", "light.azimuth": -35.0, "light.elevation": 50.0, "camera.fov": 25.0},
    "folded": {"layers.A.grounding": [[420.0, 892.0], [580.0, 908.0]], "camera.fov": 20.0},
}


def scene_of(figure: Path, values: Mapping[str, object]) -> Scene:
    return evaluate(with_values(standing(figure), values), 1)


def cast_of(renderer: Renderer, scene: Scene) -> Array:
    return np.asarray(renderer.coverage(scene, scene.layers[0]) / 65535)


def on_a_floor(scene: Scene, meshes: Meshes) -> Scene:
    """Return the scene with a mesh in the place of its ground."""
    floor = heights_mesh(scene.ground, np.zeros((9, 9)), 4000.0)
    return with_pieces(scene, (meshes.piece("floor", floor),), has_ground=False)


@pytest.mark.parametrize("view", VIEWS)
@pytest.mark.parametrize("name", FILTERS)
def test_a_mesh_floor_shows_what_the_flat_ground_does(
    mesh_renderer: Renderer, meshes: Meshes, figure: Path, name: str, view: str
) -> None:
    scene = scene_of(figure, FILTERS[name] | VIEWS[view])
    ground = cast_of(mesh_renderer, scene)
    floor = cast_of(mesh_renderer, on_a_floor(scene, meshes))
    assert ground.sum() > 3000
    # What grows over the contact line, to the light's side of the card, cannot be cast by it.
    behind = slice(0, 850 if name == "grown" else None)
    shift = Shift.between(floor[behind], ground[behind])
    assert shift.mean < 0.2
    # Along the ridge of a thin hair that grows, single px of the ground stay open.
    assert shift.p99 < (4.0 if name == "grown" else 1.0)
    plain = cast_of(mesh_renderer, on_a_floor(scene_of(figure, VIEWS[view]), meshes))
    assert np.abs(plain - floor).sum() > 800, "the filter does something"


def test_a_soft_edge_stays_soft(mesh_renderer: Renderer, meshes: Meshes, figure: Path) -> None:
    scene = scene_of(figure, {SHADOW + "softness": 24.0})
    ground, floor = cast_of(mesh_renderer, scene), cast_of(mesh_renderer, on_a_floor(scene, meshes))
    assert ((floor > 0.2) & (floor < 0.8)).sum() > 4000
    assert np.abs(ground - floor).mean() < 0.001


def test_a_ball_takes_the_round_shape(mesh_renderer: Renderer, figure: Path) -> None:
    document = with_values(standing(figure), {SHADOW + "simplify": 60.0})
    ball = {"width": 260.0, "position": (640.0, 830.0)}
    document = add_piece(document, "ball", "sphere", ball)
    filtered = cast_of(mesh_renderer, evaluate(document, 1))
    plain = cast_of(mesh_renderer, evaluate(with_values(document, {SHADOW + "simplify_on": False}), 1))
    off = with_values(document, {"set.ball.receives": False})
    on_ball = filtered - cast_of(mesh_renderer, evaluate(off, 1))
    assert on_ball.sum() > 500
    assert np.abs(filtered - plain)[on_ball > 0.5].sum() > 100


@pytest.mark.parametrize("height", [650.0, 456.0], ids=["lower than the head", "a little higher"])
def test_what_is_as_high_as_the_lamp_is_cast_as_it_is(
    mesh_renderer: Renderer, meshes: Meshes, figure: Path, height: float
) -> None:
    low = {"light.position": [350.0, height, 500.0]}
    scene = scene_of(figure, low | {SHADOW + "simplify": 30.0})
    plain = scene_of(figure, low)
    assert np.array_equal(
        cast_of(mesh_renderer, on_a_floor(scene, meshes)), cast_of(mesh_renderer, on_a_floor(plain, meshes))
    )


def test_a_light_overhead_casts_the_drawing_itself(mesh_renderer: Renderer, meshes: Meshes, figure: Path) -> None:
    overhead = {"light.position": [420.0, -500.0, 60.0], "light.overhead_radius": 300.0}
    filtered = scene_of(figure, overhead | {SHADOW + "simplify": 30.0})
    assert len(filtered.layers[0].cast.lights) == 4  # type: ignore[union-attr]
    got = cast_of(mesh_renderer, on_a_floor(filtered, meshes))
    assert np.array_equal(got, cast_of(mesh_renderer, on_a_floor(scene_of(figure, overhead), meshes)))
