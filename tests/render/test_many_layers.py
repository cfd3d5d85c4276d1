"""However many layers there are, what is kept for them stays within a budget, and no pixel depends on it."""

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.document import edits
from kagezou.document.model import Cels, Document, Drawing, Exposure
from kagezou.io.images.cel_cache import CelCache
from kagezou.render import mirrors
from kagezou.render.coverage_cache import Budgets
from kagezou.render.gpu.context import open_headless_context
from kagezou.render.passes import received
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from tests.render.reference.figures import figure_alpha, standing, with_values, write_figure

SIZE = 160
ONE_SHADOW = SIZE * SIZE * 2
NAMES = "ABCDEF"
CASES: dict[str, dict[str, object]] = {
    "united": {},
    "one after the other": {"scene.shadows_unite": False},
    "two looks": {"layers.C.shadow.color": "#204080", "layers.E.shadow.color": "#204080"},
    "with tips": {f"layers.{name}.shadow.tip_distance": 40.0 for name in NAMES},
    "on each other": {f"layers.{name}.receives": True for name in NAMES},
    "mirrored": {f"layers.{name}.reflection.opacity": 0.5 for name in NAMES},
    "patches": {f"layers.{name}.contact.strength": 0.6 for name in NAMES},
}


@pytest.fixture(scope="module")
def crowd(tmp_path_factory: pytest.TempPathFactory) -> Document:
    """Six figures side by side whose shadows overlap."""
    folder = tmp_path_factory.mktemp("crowd")
    alpha = figure_alpha(SIZE)
    document = standing(write_figure(folder / "A.png", alpha), SIZE)
    for index, name in enumerate(NAMES[1:], 1):
        way = (3 * index, 9 * index)
        path = write_figure(folder / f"{name}.png", np.roll(alpha, way, (0, 1)))
        cels = Cels((Drawing("1", path),), (Exposure(1, 0),))
        document = edits.add_layer(document, name, cels, document.layers[0].figure.moved(way[1], way[0]))
    return document


def pictures(renderer: Renderer, document: Document) -> list[NDArray[Any]]:
    """Return the picture, the same with outlines, and both once more."""
    scene, found = evaluate(document, 1), []
    for line_px in (0, 2, 0, 2):
        renderer.draw_picture(scene, Backdrop.WHITE, 8, line_px)
        found.append(renderer.read_picture())
    return found


def drawn_anew(document: Document, budgets: Budgets) -> list[NDArray[Any]]:
    with open_headless_context():
        renderer = Renderer(CelCache(), budgets=budgets)
        try:
            return pictures(renderer, document)
        finally:
            renderer.close()


@pytest.mark.parametrize("case", CASES)
def test_no_pixel_depends_on_what_is_kept(crowd: Document, case: str, monkeypatch: pytest.MonkeyPatch) -> None:
    document = with_values(crowd, CASES[case])
    wanted = drawn_anew(document, Budgets())
    monkeypatch.setattr(mirrors, "_BUDGET_BYTES", 1)
    monkeypatch.setattr(received, "_BUDGET_BYTES", 1)
    found = drawn_anew(document, Budgets(shadows=1, mattes=1))
    assert (wanted[0] != wanted[1]).any()
    for one, other in zip(wanted, found, strict=True):
        assert np.array_equal(one, other)


def test_the_shadows_of_all_layers_take_no_more_than_the_budget(crowd: Document) -> None:
    with open_headless_context():
        renderer = Renderer(CelCache(), budgets=Budgets(shadows=3 * ONE_SHADOW))
        renderer.draw_picture(evaluate(crowd, 1), Backdrop.WHITE)
        kept = renderer._shadows._by_layer
        assert len(kept.names) <= 4
        assert kept.nbytes <= 4 * ONE_SHADOW
        renderer.close()


def test_within_the_budget_nothing_is_cast_again(crowd: Document) -> None:
    with open_headless_context():
        renderer = Renderer(CelCache())
        for _ in range(2):
            renderer.draw_picture(evaluate(crowd, 1), Backdrop.WHITE)
        assert renderer.casts_drawn == len(NAMES)
        renderer.close()
