"""Shadows without their smallest islands and holes, at every resolution and on sets."""

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.document.model import Document
from kagezou.document.scaling import scaled
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.smaller_cels import SmallerCels
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from tests.render.prepare.test_least_parts import parts_of
from tests.render.reference.figures import figure_alpha, standing, with_values, write_figure

LEAST = 500


@pytest.fixture(scope="module")
def document(tmp_path_factory: pytest.TempPathFactory) -> Document:
    """A figure with a ball beside it and a hole in it."""
    alpha = figure_alpha()
    y, x = np.mgrid[0:1000, 0:1000] + 0.5
    ball = np.clip(12.5 - np.hypot(x - 700, y - 500), 0, 1)
    hole = np.clip(12.5 - np.hypot(x - 500, y - 570), 0, 1)
    alpha = np.round(np.maximum(alpha * (1 - hole), 255 * ball)).astype(np.uint8)
    path = write_figure(tmp_path_factory.mktemp("least") / "a.png", alpha)
    return with_values(standing(path), {"layers.A.shadow.simplify": 4.0, "light.position": [400.0, 0.0, 900.0]})


def coverage(renderer: Renderer, document: Document) -> NDArray[Any]:
    scene = evaluate(document, 1)
    return renderer.coverage(scene, scene.layers[0]) / 65535


def counts(found: NDArray[Any]) -> tuple[int, int]:
    """How many islands a shadow has, and how many parts what is not in the shadow."""
    rows, columns = (np.nonzero(found.any(axis=axis))[0] for axis in (1, 0))
    found = np.pad(found[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1], 1)
    return len(parts_of(found >= 0.5, diagonal=True)), len(parts_of(found < 0.5, diagonal=False))


SETS: list[dict[str, Any]] = [{}, {"layers.A.shadow.simplify": 0.0}, {"layers.A.shadow.softness": 6.0}]


@pytest.mark.parametrize("values", SETS, ids=["simplified", "plain", "soft"])
def test_islands_and_holes_are_left_out(renderer: Renderer, document: Document, values: dict[str, Any]) -> None:
    document = with_values(document, values)
    before = coverage(renderer, document)
    after = coverage(renderer, with_values(document, {"layers.A.shadow.least_part": LEAST}))
    assert counts(before)[0] > 1
    assert counts(before)[1] > 1
    assert counts(after) == (1, 1)
    changed = np.abs(after - before)
    assert 0 < changed.sum() < 2.5 * LEAST
    again = coverage(renderer, document)
    assert (again == before).all()


def test_what_is_larger_stays(renderer: Renderer, document: Document) -> None:
    before = coverage(renderer, document)
    assert (coverage(renderer, with_values(document, {"layers.A.shadow.least_part": 10.0})) == before).mean() > 0.9999
    assert counts(coverage(renderer, with_values(document, {"layers.A.shadow.least_part": 60.0}))) == counts(before)


def test_a_preview_looks_the_same(renderer: Renderer, document: Document) -> None:
    document = with_values(document, {"layers.A.shadow.least_part": LEAST})
    whole = coverage(renderer, document)
    half = Renderer(SmallerCels(CelCache(), document.canvas.box, 2), divisor=2)
    found = coverage(half, scaled(document, 2))
    half.close()
    assert counts(found) == counts(whole) == (1, 1)
    mean = whole.reshape(500, 2, 500, 2).mean(axis=(1, 3))
    assert np.abs(found - mean).sum() < 0.02 * mean.sum()


def test_waves_leave_no_splinters(renderer: Renderer, document: Document) -> None:
    torn = {
        "layers.A.shadow.wave1.amplitude": 20.0,
        "layers.A.shadow.wave1.wavelength": 30.0,
        "layers.A.shadow.wave1.direction": 88.0,
    }
    document = with_values(document, torn)
    assert counts(coverage(renderer, document))[0] > 2
    left = coverage(renderer, with_values(document, {"layers.A.shadow.least_part": LEAST}))
    assert all(len(part) >= LEAST for part in parts_of(left >= 0.5, diagonal=True))
