"""How a shadow is coloured over its length (spec 3), in the layer and in the composite."""

from pathlib import Path

import numpy as np
import pytest

from kagezou.io.images.reading import read_cel
from kagezou.io.images.writing import ShadowImage, write_shadow
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from tests.render.reference import blurred
from tests.render.reference.blurred import ContactLine
from tests.render.reference.figures import standing, with_values
from tests.render.reference.raycast import Array

SHADOW = "layers.A.shadow."
PERSPECTIVE = {"camera.fov": 40.0, "ground.roll": 8.0, "layers.A.tilt": 10.0}


def drawn(
    renderer: Renderer, figure: Path, look: dict[str, object], depth: int = 16
) -> tuple[ShadowImage, Array, Array]:
    """The layer, the coverage before any look, and the distance of each pixel from the contact line."""
    named = {SHADOW + name: value for name, value in look.items()}
    scene = evaluate(with_values(with_values(standing(figure), PERSPECTIVE), named), 1)
    layer = scene.layers[0]
    assert layer.cast is not None
    image = renderer.shadow(scene, layer, depth)
    covered = np.asarray(renderer.coverage(scene, layer) / 65535)
    y, x = np.mgrid[0:1000, 0:1000] + 0.5
    u, v, _ = blurred.ground_seen_at(layer.cast, x, y)
    return image, covered, np.abs(ContactLine.of(layer.cast).from_ground(u, v)[1])


@pytest.mark.parametrize("curve", [0.5, 1.0, 3.0])
def test_opacity_falls_with_the_distance(renderer: Renderer, figure: Path, curve: float) -> None:
    image, covered, away = drawn(renderer, figure, {"fade": 400.0, "fade_curve": curve, "opacity": 0.8})
    wanted = covered * 0.8 * np.clip(1 - away / 400.0, 0, None) ** curve
    assert np.abs(image.rgba()[..., 3] / 65535 - wanted).max() < 2e-3
    assert (wanted[away > 400.0] == 0).all()


def test_the_colour_passes_over_to_the_tip(renderer: Renderer, figure: Path) -> None:
    look = {"color": "#102030", "tip_color": "#F0A050", "tip_distance": 300.0}
    image, covered, away = drawn(renderer, figure, look)
    rgba = image.rgba()
    part = np.clip(away / 300.0, 0, 1)[..., np.newaxis]
    wanted = (1 - part) * np.array([0x10, 0x20, 0x30]) / 255 + part * np.array([0xF0, 0xA0, 0x50]) / 255
    inside = covered > 0
    assert np.abs(rgba[inside][:, :3] / 65535 - wanted[inside]).max() < 2e-3
    assert np.abs(rgba[..., 3] / 65535 - covered * 0.6).max() < 1e-3


@pytest.mark.parametrize("suffix", [".png", ".tif", ".exr", ".tga"])
def test_every_format_holds_the_colours(renderer: Renderer, figure: Path, tmp_path: Path, suffix: str) -> None:
    image, *_ = drawn(renderer, figure, {"tip_color": "#F0A050", "tip_distance": 300.0, "opacity": 1.0}, depth=8)
    path = tmp_path / f"shadow{suffix}"
    write_shadow(path, image)
    pixels = read_cel(path, white_is_clear=False).rgba
    solid = image.rgba()[..., 3] == 255
    full = np.iinfo(pixels.dtype).max
    assert np.abs(pixels[solid] / full - image.rgba()[solid] / 255).max() < 0.01


def test_the_composite_shows_the_same_as_the_layer(renderer: Renderer, figure: Path) -> None:
    named = {SHADOW + name: value for name, value in {"fade": 3000.0, "tip_distance": 300.0, "blend": "normal"}.items()}
    scene = evaluate(with_values(standing(figure), named), 1)
    layer = renderer.shadow(scene, scene.layers[0], 16).rgba() / 65535
    renderer.draw_picture(scene, Backdrop.WHITE, depth=16)
    picture = renderer.read_picture() / 65535
    alpha = layer[..., 3:]
    away_from_the_figure = np.s_[:, 720:]
    wanted = (layer[..., :3] * alpha + 1 - alpha)[away_from_the_figure]
    assert alpha[away_from_the_figure].sum() > 1000
    assert np.abs(picture[..., :3][away_from_the_figure] - wanted).max() < 2e-3


def test_a_look_does_not_cast_again(renderer: Renderer, figure: Path) -> None:
    drawn(renderer, figure, {"fade": 400.0})
    cast = renderer.casts_drawn
    drawn(renderer, figure, {"fade": 300.0, "tip_distance": 100.0})
    assert renderer.casts_drawn == cast
