"""Shadows of characters on each other: the renderer against float64 rays, and how they are laid and told."""

from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.document import edits
from kagezou.document.model import Cels, Document, Drawing, Exposure
from kagezou.geometry.box import Box
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from kagezou.scene.scene import Received, ShadowCast
from tests.effort import tries
from tests.render.reference import raycast
from tests.render.reference.figures import figure_alpha, standing, with_values, write_figure
from tests.render.test_exactness import Agreement

SIZE = 500
SHIFT = (30, -40)
"""Where B is drawn beside A, px down and to the right."""

MIN_SHADE_PX = 1500


@pytest.fixture(scope="module")
def duo(tmp_path_factory: pytest.TempPathFactory) -> Document:
    """A, which receives, and B before it on the left; the lamp shines over B's shoulder."""
    folder = tmp_path_factory.mktemp("duo")
    document = standing(write_figure(folder / "a.png", figure_alpha(SIZE)), SIZE)
    other = write_figure(folder / "b.png", np.roll(figure_alpha(SIZE), SHIFT, axis=(0, 1)))
    cels = Cels((Drawing("1", other),), (Exposure(1, 0),))
    document = edits.add_layer(document, "B", cels, Box(133, 129, 297, 480))
    return with_values(
        document,
        {
            "layers.A.receives": True,
            "layers.A.grounding": [[250.0, 450.0]],
            "layers.B.grounding": [[210.0, 495.0]],
            "light.position": [10.0, -228.0, 468.0],
        },
    )


def arts() -> tuple[raycast.Art, raycast.Art]:
    alpha = figure_alpha(SIZE) / 255
    return raycast.Art(alpha), raycast.Art(np.roll(alpha, SHIFT, axis=(0, 1)))


def drawn(renderer: Renderer, document: Document) -> tuple[NDArray[np.float64], Received, ShadowCast]:
    scene = evaluate(document, 1)
    layer = scene.layers[0]
    assert layer.received is not None
    assert scene.layers[1].cast is not None
    return renderer.received_coverage(scene, layer) / 65535, layer.received, scene.layers[1].cast


def random_case(seed: int) -> dict[str, object]:
    rng = np.random.default_rng(seed)
    grounds = [[[250.0, 450.0]], [[215.0, 455.0], [285.0, 440.0]], [[215.3, 450.0], [250.4, 435.0], [283.7, 452.0]]]
    casting = [[[210.0, 495.0]], [[180.0, 492.0], [240.0, 497.0]], [[180.0, 494.0], [209.6, 488.0], [240.0, 497.0]]]
    farther = float(rng.uniform(2.5, 9))
    return {
        "ground.declination": float(rng.uniform(35, 75)),
        "ground.roll": float(rng.uniform(-8, 8)),
        "camera.fov": float(rng.choice([0, 0, 25, 50])),
        "layers.A.grounding": grounds[int(rng.integers(3))],
        "layers.B.grounding": casting[int(rng.integers(3))],
        "layers.B.tilt": float(rng.uniform(-25, 25)),
        "layers.B.shadow.matte": "translucent" if rng.random() < 0.15 else "solid",
        # From A's chest past B's head.
        "light.position": [
            250.0 - farther * float(rng.uniform(20, 60)),
            300.0 - farther * float(rng.uniform(60, 100)),
            farther * float(rng.uniform(60, 110)),
        ],
    }


def test_shadows_on_a_card_agree_with_rays_over_a_sweep(renderer: Renderer, duo: Document) -> None:
    wrong, judged = {}, 0
    for seed in range(tries(6, 16)):
        got, received, cast = drawn(renderer, with_values(duo, random_case(seed)))
        if got.sum() < MIN_SHADE_PX:
            continue
        judged += 1
        wanted = partial(raycast.received, received, cast, arts(), got)
        agreement = Agreement.by_rays(got, wanted, 60, 800)
        if not agreement.is_right:
            wrong[seed] = agreement
    assert judged == tries(6, 16)
    assert not wrong


def received_sum(renderer: Renderer, document: Document) -> float:
    scene = evaluate(document, 1)
    return float(renderer.received_coverage(scene, scene.layers[0]).sum()) / 65535


def test_nothing_falls_on_a_character_that_does_not_receive_or_stands_before_the_other(
    renderer: Renderer, duo: Document
) -> None:
    assert received_sum(renderer, duo) > MIN_SHADE_PX
    assert evaluate(with_values(duo, {"layers.A.receives": False}), 1).layers[0].received is None
    before = with_values(duo, {"layers.A.grounding": [[250.0, 499.0]], "layers.B.grounding": [[210.0, 440.0]]})
    assert received_sum(renderer, before) == 0
    assert received_sum(renderer, with_values(duo, {"layers.B.visible": False})) == 0


def test_a_card_casts_nothing_on_itself_or_on_one_in_the_same_plane(renderer: Renderer, duo: Document) -> None:
    alone = edits.remove_layer(duo, "layer-2")
    assert received_sum(renderer, alone) == 0
    for fov in (0.0, 40.0):
        together = {"layers.A.grounding": [], "layers.B.grounding": [], "camera.fov": fov}
        assert received_sum(renderer, with_values(duo, together)) == 0


def test_a_light_behind_a_character_leaves_its_front_alone(renderer: Renderer, duo: Document) -> None:
    behind = {"light.position": [290.0, -200.0, -500.0], "layers.B.grounding": [[210.0, 420.0]]}
    assert received_sum(renderer, with_values(duo, behind)) == 0


def test_a_shade_is_cut_to_the_alpha_of_the_drawing(renderer: Renderer, duo: Document) -> None:
    scene = evaluate(duo, 1)
    got = renderer.received_coverage(scene, scene.layers[0]) / 65535
    alpha = figure_alpha(SIZE) / 255
    assert (got <= alpha + 1e-4).all()
    image = renderer.received(scene, scene.layers[0])
    assert image.color == (0x20, 0x20, 0x3A)
    assert image.alpha.max() == round(0.6 * 255)


def test_several_casters_of_one_look_unite_and_are_not_darkened_twice(renderer: Renderer, duo: Document) -> None:
    b = duo.layers[1]
    twice = edits.add_layer(duo, "C", b.cels, b.figure)
    twice = with_values(twice, {"layers.C.grounding": [[210.0, 495.0]]})
    one, two = evaluate(duo, 1), evaluate(twice, 1)
    assert two.layers[0].received is not None
    assert len(two.layers[0].received.shades) == 1
    once = renderer.received_coverage(one, one.layers[0])
    assert np.array_equal(renderer.received_coverage(two, two.layers[0]), once)
    folded = with_values(twice, {"layers.A.grounding": [[215.3, 450.0], [250.4, 435.0], [283.7, 452.0]]})
    one, two = evaluate(edits.remove_layer(folded, "layer-3"), 1), evaluate(folded, 1)
    once, both = (renderer.received_coverage(scene, scene.layers[0]).astype(float) for scene in (one, two))
    assert once.max() > 60000
    assert np.abs(once - both).max() <= 1


@pytest.mark.parametrize("blend", ["multiply", "normal"])
def test_casters_of_several_looks_are_one_layer_that_does_what_they_do(
    renderer: Renderer, duo: Document, blend: str
) -> None:
    b = duo.layers[1]
    document = edits.add_layer(duo, "C", b.cels, b.figure)
    document = with_values(
        document,
        {
            "layers.C.grounding": [[230.0, 490.0]],
            "layers.C.shadow.color": "#C03020",
            "layers.C.shadow.opacity": 0.4,
            "layers.C.shadow.blend": blend,
            "layers.B.shadow.blend": blend,
        },
    )
    scene = evaluate(document, 1)
    layer = scene.layers[0]
    assert layer.received is not None
    image = renderer.received(scene, layer, 16, multiply=blend == "multiply").rgba() / 65535
    renderer.draw_picture(scene, Backdrop.WHITE)
    with_shades = renderer.read_picture() / 255
    renderer.draw_picture(replace(scene, layers=(replace(layer, received=None), *scene.layers[1:])), Backdrop.WHITE)
    without = renderer.read_picture() / 255
    alone = figure_alpha(SIZE) == 255
    alone &= np.roll(figure_alpha(SIZE), SHIFT, axis=(0, 1)) == 0  # not hidden by those before it
    alpha = image[..., 3:]
    laid = without[..., :3] * (1 - alpha) + alpha * image[..., :3] * (without[..., :3] if blend == "multiply" else 1)
    assert (alpha[alone] > 0.45).any()
    assert np.abs(laid - with_shades[..., :3])[alone].max() < 2.5 / 255
