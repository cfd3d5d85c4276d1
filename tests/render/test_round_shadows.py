"""Round shadows as they are drawn: an ellipse, in every camera, with filters and on sets."""

from math import cos, pi, radians
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.document.model import Document
from kagezou.document.set_pieces import add_piece
from kagezou.geometry.ground import canvas_from_plane
from kagezou.render.prepare.disc_matte import disc_matte
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from tests.render.reference.figures import figure_alpha, standing, with_values, write_figure


@pytest.fixture(scope="module")
def document(tmp_path_factory: pytest.TempPathFactory) -> Document:
    path = write_figure(tmp_path_factory.mktemp("round") / "a.png", figure_alpha())
    raised = {"ground.position": [500.0, 700.0], "layers.A.shadow.shape": "disc"}
    return with_values(standing(path), raised)


def coverage(renderer: Renderer, document: Document) -> NDArray[Any]:
    scene = evaluate(document, 1)
    return renderer.coverage(scene, scene.layers[0]) / 65535


CAMERAS: list[dict[str, Any]] = [
    {},
    {"camera.fov": 50.0},
    {"camera.fov": 50.0, "ground.declination": 85.0, "ground.roll": 12.0},
    {"ground.declination": 5.0},
]


@pytest.mark.parametrize("camera", CAMERAS, ids=["straight", "perspective", "rolled", "from above"])
def test_it_is_the_disc_on_the_ground(renderer: Renderer, document: Document, camera: dict[str, Any]) -> None:
    document = with_values(document, camera)
    scene, found = evaluate(document, 1), coverage(renderer, document)
    y, x = np.mgrid[0:1000, 0:1000] + 0.5
    plane = np.linalg.inv(canvas_from_plane(scene.camera, scene.ground))
    u, v, w = np.tensordot(plane, np.array([x, y, np.ones_like(x)]), 1)
    # Below the middle of the box around the figure, on the ground line.
    middle = (10.0 / scene.ground.u[0], 0.0)
    across, away = (each / np.where(w == 0, 1, w) - at for each, at in zip((u, v), middle, strict=True))
    distance = np.where(w > 0, np.hypot(across, away), np.inf)
    radius = 0.275 * document.layers[0].figure.height
    wanted = distance <= radius
    assert wanted.sum() > 3000
    assert np.minimum(found, wanted).sum() / np.maximum(found, wanted).sum() > 0.98
    assert (found[distance < 0.98 * radius] == 1).all()
    assert not found[distance > 1.02 * radius + 2].any()


def test_its_area_is_exact_and_its_edge_anti_aliased(renderer: Renderer, document: Document) -> None:
    radius = 0.275 * document.layers[0].figure.height
    found = coverage(renderer, document)
    assert found.sum() == pytest.approx(pi * radius**2 * cos(radians(60.0)), rel=2e-3)
    assert ((found > 0.05) & (found < 0.95)).any()


@pytest.mark.parametrize(
    "values", [{"simplify": 30.0}, {"softness": 20.0}, {"wave1.amplitude": 8.0, "wave1.wavelength": 60.0}]
)
def test_filters_go_on_from_there(renderer: Renderer, document: Document, values: dict[str, float]) -> None:
    plain = coverage(renderer, document)
    filtered = coverage(renderer, with_values(document, {f"layers.A.shadow.{name}": n for name, n in values.items()}))
    assert filtered.sum() == pytest.approx(plain.sum(), rel=0.03)
    assert np.abs(filtered - plain).max() > 0.2 or "simplify" in values


def test_a_set_takes_it_where_it_lies_on_top(renderer: Renderer, document: Document) -> None:
    plain = coverage(renderer, document)
    document = add_piece(document, "box", "box")
    box = {"width": 60.0, "depth": 60.0, "height": 40.0, "position": [500.0, 690.0]}
    document = with_values(document, {f"set.box.{name}": value for name, value in box.items()})
    found = coverage(renderer, document)
    assert not np.array_equal(found, plain)
    # The top of the box is seen over the ground behind it, and lies in the disc as well.
    assert found[640, 500] == 1


def test_there_is_one_disc_for_all() -> None:
    matte = disc_matte()
    assert matte is disc_matte()
    assert not matte.hard_edged
    assert matte.box is not None
    assert matte.box.middle == (512.0, 512.0)
    assert matte.alpha.sum() / 255 == pytest.approx(pi * 500**2, rel=1e-5)


def test_it_is_made_of_no_drawing(renderer: Renderer, document: Document) -> None:
    lost = standing(Path("/nowhere/a.png"))
    lost = with_values(lost, {"ground.position": [500.0, 700.0], "layers.A.shadow.shape": "disc"})
    assert (coverage(renderer, lost) == coverage(renderer, document)).all()
