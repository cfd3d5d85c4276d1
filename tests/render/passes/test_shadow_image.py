"""A shadow as an image of its own: rounded, as large as its canvas, whatever canvas was drawn before."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from kagezou.document.edits import set_canvas
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.writing import ShadowImage
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from tests.render.reference.figures import standing, with_values

FADING: dict[str, object] = {"layers.A.shadow.fade": 700.0}


def image(
    renderer: Renderer, figure: Path, values: dict[str, object], side_px: int = 1000, depth: int = 8
) -> ShadowImage:
    document = with_values(standing(figure), values)
    canvas = replace(document.canvas, width_px=side_px, height_px=side_px)
    scene = evaluate(set_canvas(document, canvas), 1)
    return renderer.shadow(scene, scene.layers[0], depth)


@pytest.mark.parametrize(("opacity", "depth"), [(0.299, 8), (0.301, 8), (0.7, 16), (1.0, 8), (0.00001, 16)])
def test_opacity_is_rounded_to_the_nearest_step(renderer: Renderer, figure: Path, opacity: float, depth: int) -> None:
    found = image(renderer, figure, {"layers.A.shadow.opacity": opacity}, depth=depth)
    assert int(found.alpha.max()) == round(opacity * ((1 << depth) - 1))
    assert found.alpha.dtype == (np.uint8 if depth == 8 else np.uint16)


@pytest.mark.parametrize(
    "values", [FADING, {**FADING, "layers.A.shadow.tip_color": "#804020", "layers.A.shadow.tip_distance": 200.0}]
)
def test_a_canvas_of_another_size_has_targets_of_its_own(
    renderer: Renderer, figure: Path, values: dict[str, object]
) -> None:
    image(renderer, figure, values, side_px=700)
    again = image(renderer, figure, values, side_px=1000)
    fresh = Renderer(CelCache())
    wanted = image(fresh, figure, values, side_px=1000)
    fresh.close()
    assert (again.width_px, again.height_px) == (1000, 1000)
    assert np.array_equal(again.rgba(), wanted.rgba())
    assert again.alpha.any()
