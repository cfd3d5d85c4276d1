"""Shadows of like look unite before opacity: the maximum, never the product."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.document import edits
from kagezou.document.model import Cels, Document, Drawing, Exposure
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from tests.render.reference.figures import figure_alpha, standing, with_values, write_figure

SIZE = 240
FADES = {f"layers.{name}.shadow.fade": 70.0 for name in "AB"}
TIPS = {
    f"layers.{name}.shadow.{key}": value
    for name in "AB"
    for key, value in (("tip_distance", 60.0), ("tip_color", "#C05010"))
}


@pytest.fixture(scope="module")
def pair(tmp_path_factory: pytest.TempPathFactory) -> Document:
    """Two figures side by side, whose soft shadows overlap; A lies lower and its feet are another place."""
    folder = tmp_path_factory.mktemp("pair")
    alpha = figure_alpha(SIZE)
    path = write_figure(folder / "a.png", alpha)
    beside = write_figure(folder / "b.png", np.roll(alpha, (9, 26), (0, 1)))
    document = standing(path, SIZE)
    cels = Cels((Drawing("1", beside),), (Exposure(1, 0),))
    document = edits.add_layer(document, "B", cels, document.layers[0].figure.moved(26, 9))
    soft = {f"layers.{name}.shadow.softness": 12.0 for name in "AB"}
    return with_values(document, {**soft, "layers.B.grounding": [[146.0, 225.0]]})


def picture(renderer: Renderer, document: Document) -> NDArray[Any]:
    """Return the picture on white, (H, W, 3) from 0 to 1, 16 bit."""
    renderer.draw_picture(evaluate(document, 1), Backdrop.WHITE, 16)
    return renderer.read_picture()[..., :3] / 65535


def taken(renderer: Renderer, document: Document) -> list[NDArray[Any]]:
    """Return what each shadow alone takes from each colour of white paper, (H, W, 3) from 0 to 1."""
    scene = evaluate(document, 1)
    images = [renderer.shadow(scene, layer, 16).rgba() / 65535 for layer in scene.layers]
    return [image[..., 3:] * (1 - image[..., :3]) for image in images]


def beside_figures() -> NDArray[Any]:
    alpha = figure_alpha(SIZE)
    return np.asarray((alpha == 0) & (np.roll(alpha, (9, 26), (0, 1)) == 0))


@pytest.mark.parametrize("values", [{}, FADES, TIPS, {**FADES, **TIPS}], ids=["plain", "fade", "tip", "both"])
@pytest.mark.parametrize("blend", ["multiply", "normal"])
def test_no_pixel_is_darker_than_under_one_shadow_alone(
    renderer: Renderer, pair: Document, values: dict[str, object], blend: str
) -> None:
    document = with_values(pair, {**values, **{f"layers.{name}.shadow.blend": blend for name in "AB"}})
    first, second = taken(renderer, document)
    seen = beside_figures()
    both = seen & (np.minimum(first, second).max(-1) > 0.05)
    assert both.sum() > 80, "they overlap"
    found = picture(renderer, document)
    assert np.abs(found - (1 - np.maximum(first, second)))[seen].max() < 4e-4
    apart = picture(renderer, with_values(document, {"scene.shadows_unite": False}))
    assert (apart < found - 0.02)[both].all(-1).any(), "which one after the other would have darkened"


@pytest.mark.parametrize("values", [{}, FADES, TIPS], ids=["plain", "fade", "tip"])
@pytest.mark.parametrize("depth", [8, 16])
def test_the_united_shadow_as_a_picture_of_its_own(
    renderer: Renderer, pair: Document, values: dict[str, object], depth: int
) -> None:
    document = with_values(pair, values)
    scene = evaluate(document, 1)
    image = renderer.united_shadow(scene, scene.layers, depth).rgba() / float((1 << depth) - 1)
    wanted = np.maximum(*taken(renderer, document))
    assert np.abs(image[..., 3:] * (1 - image[..., :3]) - wanted).max() < (0.006 if depth == 8 else 4e-4)
    assert image[..., 3].max() == pytest.approx(0.6, abs=0.06)


def test_shadows_of_other_opacity_darken_each_other(renderer: Renderer, pair: Document) -> None:
    document = with_values(pair, {"layers.B.shadow.opacity": 0.3})
    first, second = taken(renderer, document)
    found, seen = picture(renderer, document), beside_figures()
    assert np.abs(found - (1 - first) * (1 - second))[seen].max() < 4e-4


@pytest.mark.parametrize("hidden", [False, True])
def test_a_shadow_alone_is_what_it_was_byte_for_byte(renderer: Renderer, pair: Document, *, hidden: bool) -> None:
    other: dict[str, object] = {"layers.B.visible": False} if hidden else {"layers.B.shadow.color": "#204020"}
    document = with_values(pair, {**other, **FADES})
    apart = picture(renderer, with_values(document, {"scene.shadows_unite": False}))
    assert np.array_equal(picture(renderer, document), apart)


def test_a_union_leaves_nothing_behind_for_the_next(renderer: Renderer, pair: Document) -> None:
    moved = with_values(pair, {"light.position": [200.0, -60.0, 150.0]})
    fresh = picture(renderer, moved)
    for other in (pair, with_values(pair, TIPS), with_values(moved, TIPS)):
        picture(renderer, other)
    assert np.array_equal(picture(renderer, moved), fresh)


def test_opacity_and_union_do_not_cast_again(renderer: Renderer, pair: Document) -> None:
    picture(renderer, pair)
    cast = renderer.casts_drawn
    picture(renderer, with_values(pair, {f"layers.{name}.shadow.opacity": 0.4 for name in "AB"}))
    picture(renderer, with_values(pair, {"scene.shadows_unite": False}))
    assert renderer.casts_drawn == cast


def test_no_shadows_make_an_empty_picture(renderer: Renderer, tmp_path: Path) -> None:
    path = write_figure(tmp_path / "clear.png", np.zeros((SIZE, SIZE), np.uint8))
    scene = evaluate(standing(path, SIZE), 1)
    assert renderer.united_shadow(scene, scene.layers).box.is_empty
