"""Relief cards in the paths of the renderer: against rays on their surface."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from kagezou.document import edits
from kagezou.document.model import Cels, Document, Drawing, Exposure
from kagezou.geometry.box import Box
from kagezou.geometry.relief import Foothold, relief_card
from kagezou.geometry.shadow import cast_card
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from kagezou.scene.scene import Scene, ShadowCast
from tests.effort import tries
from tests.render.reference import blurred, raycast, set_raycast
from tests.render.reference.figures import figure_alpha, standing, with_values, write_figure
from tests.render.reference.mesh_scenes import Array
from tests.render.reference.outlines import Shift
from tests.render.sets.test_exactness import in_a_set, judged
from tests.render.test_exactness import MIN_SHADOW_PX, RAYS, Agreement, random_light

HEIGHT = 702.0
Values = Mapping[str, object]
WALL: dict[str, Values] = {"wall": {"kind": "wall", "position": [500, 800], "width": 2400, "height": 1100, "lean": 25}}
BALL: dict[str, Values] = {"ball": {"kind": "sphere", "position": [560, 780], "width": 320}}


def planted(x: float, y: float) -> Foothold:
    return Foothold((x, y), y, is_planted=True)


FEET = (planted(440.0, 899.0), planted(565.0, 870.0))


def on_feet(scene: Scene, feet: Sequence[Foothold], tilt: float = 0.0, upright: float = 0.0) -> Scene:
    """Return a scene whose first layer stands on feet, as what others cast on it does."""
    first = scene.layers[0]
    assert first.cast is not None
    scale = scene.canvas.height / 1000
    card = relief_card(scene.camera, scene.ground, feet, HEIGHT * scale, tilt, upright)
    received = None if first.received is None else replace(first.received, card=card)
    first = replace(first, cast=replace(first.cast, card=card), received=received)
    return replace(scene, layers=(first, *scene.layers[1:]))


def cast_of(scene: Scene) -> ShadowCast:
    cast = scene.layers[0].cast
    assert cast is not None
    return cast


def drawn(renderer: Renderer, scene: Scene) -> Array:
    return np.asarray(renderer.coverage(scene, scene.layers[0]) / 65535)


def random_scene(figure: Path, seed: int, pieces: Mapping[str, Values] | None = None) -> Scene:
    rng = np.random.default_rng(seed)
    values = random_light(rng) | {
        "ground.declination": float(rng.uniform(35, 75)),
        "ground.roll": float(rng.uniform(-10, 10)),
        "camera.fov": float(rng.choice([0, 0, 30, 50])),
        "layers.A.shadow.matte": "translucent" if rng.random() < 0.15 else "solid",
    }
    feet = [planted(440.0, float(rng.uniform(880, 905))), planted(565.0, float(rng.uniform(850, 900)))]
    if rng.random() < 0.5:
        row = float(rng.uniform(870, 900))
        feet.append(Foothold((float(rng.uniform(480, 520)), row - 15), row, is_planted=False))
    tilt, upright = float(rng.choice([0, 0, 12])), float(rng.choice([0, 0, 0.5, 1]))
    return on_feet(evaluate(in_a_set(figure, dict(pieces or {}), values), 1), feet, tilt, upright)


def agreement(got: Array, cast: ShadowCast) -> Agreement:
    art = raycast.Art(figure_alpha() / 255)
    return Agreement.by_rays(got, partial(raycast.coverage, cast, art, got), *RAYS)


@pytest.mark.parametrize("seed", range(tries(4, 10)))
def test_the_closed_form_agrees_with_rays_on_the_same_surface(renderer: Renderer, figure: Path, seed: int) -> None:
    scene = random_scene(figure, seed)
    got = drawn(renderer, scene)
    assert len(cast_of(scene).card.pieces) > 7
    if got.sum() >= MIN_SHADOW_PX:
        assert agreement(got, cast_of(scene)).is_right


def test_a_shadow_that_is_folded_back_over_itself_unites(renderer: Renderer, figure: Path) -> None:
    """The leg behind is turned inside out by a light from the side: nothing there is darkened twice."""
    values = {"ground.declination": 65.0, "light.position": [-500.0, 350.0, 500.0]}
    feet = (planted(440.0, 899.0), planted(565.0, 800.0))
    scene = on_feet(evaluate(with_values(standing(figure), values), 1), feet)
    cast = cast_of(scene)
    sheets = {each.sheet for each in cast_card(cast.camera, scene.ground, cast.card, cast.lights[0])}
    assert len(sheets) > 1
    assert agreement(drawn(renderer, scene), cast).is_right


def test_four_lights_unite(renderer: Renderer, figure: Path) -> None:
    values = {"light.position": [520.0, -900.0, 30.0], "light.overhead_radius": 300.0}
    scene = on_feet(evaluate(with_values(standing(figure), values), 1), FEET)
    assert len(cast_of(scene).lights) == 4
    assert agreement(drawn(renderer, scene), cast_of(scene)).is_right


@pytest.mark.parametrize("seed", [21, 22, 23][: tries(1, 3)])
def test_the_depth_map_agrees(renderer: Renderer, figure: Path, seed: int) -> None:
    scene = random_scene(figure, seed)
    first = scene.layers[0]
    scene = replace(scene, layers=(replace(first, cast=replace(cast_of(scene), translucent=False)),))
    exact = drawn(renderer, scene) >= 0.5
    mapped = renderer.depth_map_coverage(scene, scene.layers[0]) >= 32768
    assert exact.sum() > MIN_SHADOW_PX
    assert (exact & mapped).sum() / (exact | mapped).sum() >= 0.985


@pytest.mark.parametrize("pieces", [WALL, BALL], ids=["wall", "ball"])
@pytest.mark.parametrize("seed", [30, 32][: tries(1, 2)])
def test_shadows_on_set_pieces_agree_with_rays(
    renderer: Renderer, figure: Path, pieces: dict[str, Values], seed: int
) -> None:
    scene = random_scene(figure, seed, pieces)
    art, cast = raycast.Art(figure_alpha() / 255), cast_of(scene)
    got = drawn(renderer, scene)
    assert got.sum() > MIN_SHADOW_PX
    assert judged(got, lambda x, y: set_raycast.shade(cast, art, x, y)).iou >= 0.998


# ---- filters


@pytest.mark.parametrize(("amount", "distance"), [(20.0, 0.0), (60.0, 200.0)])
def test_a_simplified_relief_has_the_outline_of_the_exact_gaussian(
    renderer: Renderer, figure: Path, amount: float, distance: float
) -> None:
    values = {
        "camera.fov": 30.0,
        "ground.roll": 5.0,
        "layers.A.shadow.simplify": amount,
        "layers.A.shadow.distance": distance,
    }
    scene = on_feet(evaluate(with_values(standing(figure), values), 1), FEET)
    cast = cast_of(scene)
    shadow = blurred.fallen(cast, raycast.Art(figure_alpha() / 255))
    wanted = blurred.simplified(shadow, amount, distance).coverage(cast, 1000, 1000)
    shift = Shift.between(wanted, drawn(renderer, scene))
    assert shift.mean < 0.25
    assert shift.p99 < 0.75


# ---- what falls on a character


def duo(folder: Path) -> Document:
    """A, which receives, and B before it on the left; the lamp shines over B's shoulder."""
    document = standing(write_figure(folder / "a.png", figure_alpha(500)), 500)
    other = write_figure(folder / "b.png", np.roll(figure_alpha(500), (30, -40), axis=(0, 1)))
    document = edits.add_layer(document, "B", Cels((Drawing("1", other),), (Exposure(1, 0),)), Box(133, 129, 297, 480))
    values = {
        "layers.A.receives": True,
        "layers.B.grounding": [[210.0, 495.0]],
        "light.position": [10.0, -228.0, 468.0],
    }
    return with_values(document, values)


@pytest.mark.parametrize("fov", [0.0, 40.0])
@pytest.mark.parametrize(("tilt", "upright"), [(0.0, 0.0), (10.0, 0.6)])
def test_a_shadow_on_a_relief_is_cut_to_its_pieces(
    renderer: Renderer, tmp_path: Path, fov: float, tilt: float, upright: float
) -> None:
    scene = evaluate(with_values(duo(tmp_path), {"camera.fov": fov}), 1)
    scene = on_feet(scene, [planted(220.0, 449.0), planted(282.0, 440.0)], tilt, upright)
    first, caster = scene.layers[0], scene.layers[1].cast
    assert first.received is not None
    assert caster is not None
    alpha = figure_alpha(500) / 255
    arts = raycast.Art(alpha), raycast.Art(np.roll(alpha, (30, -40), axis=(0, 1)))
    got = renderer.received_coverage(scene, first) / 65535
    assert got.sum() > 1500
    wanted = raycast.received(first.received, caster, arts, got, rays=400)
    assert Agreement.of(got, wanted).is_right
