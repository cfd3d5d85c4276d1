"""The shadow of a figure that crouches, jumps, stretches in the air and lands."""

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.document.model import Document
from kagezou.geometry.box import Box
from kagezou.geometry.placement import Placement
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from tests.render.reference.figures import figure_alpha, with_values, write_figure
from tests.scene.jumps import jumping

RISES = (0, 0, 0, 0, 30, 70, 110, 140, 110, 70, 30, 0, 0, 0, 0)
AIR = range(5, 12)
PEAK = 8
CROUCHED, STRETCHED = 0.42, 0.5


@pytest.fixture(scope="module")
def jump(tmp_path_factory: pytest.TempPathFactory) -> Document:
    folder = tmp_path_factory.mktemp("jump")
    paths, boxes = [], []
    for index, up in enumerate(RISES):
        size = STRETCHED if up else CROUCHED
        alpha = figure_alpha(moved=Placement((500.0, 900.0 - up), (500.0, 900.0), (size, size)))
        paths.append(write_figure(folder / f"{index}.png", alpha))
        rows, columns = (np.nonzero(alpha.any(axis=axis))[0] for axis in (1, 0))
        boxes.append(Box(int(columns[0]), int(rows[0]), int(columns[-1]) + 1, int(rows[-1]) + 1))
    return jumping(RISES, paths, boxes)


def shadow(renderer: Renderer, document: Document, frame: int) -> NDArray[Any]:
    scene = evaluate(document, frame)
    return renderer.coverage(scene, scene.layers[0]) / 65535


LAMP = {"light.kind": "point", "light.position": [200.0, 100.0, 500.0]}
LIGHTS: list[dict[str, Any]] = [{}, LAMP, {"light.elevation": 25.0}, LAMP | {"camera.fov": 40.0}]


@pytest.mark.parametrize("light", LIGHTS, ids=["sun", "lamp", "low sun", "perspective"])
@pytest.mark.parametrize("filtered", [{}, {"layers.A.shadow.simplify": 12.0}], ids=["plain", "simplified"])
def test_it_shrinks_while_it_rises_and_is_back_on_landing(
    renderer: Renderer, jump: Document, light: dict[str, Any], filtered: dict[str, Any]
) -> None:
    document = with_values(jump, light | filtered)
    shadows = {frame: shadow(renderer, document, frame) for frame in range(4, 13)}
    areas = {frame: float(each.sum()) for frame, each in shadows.items()}
    assert areas[4] > 3000
    assert all(after < before for before, after in pairwise(areas[frame] for frame in range(4, PEAK + 1)))
    assert all(after > before for before, after in pairwise(areas[frame] for frame in range(PEAK, 13)))
    assert areas[PEAK] > 0.3 * areas[4]
    assert (shadows[12] == shadows[4]).all()


@pytest.mark.parametrize("light", LIGHTS, ids=["sun", "lamp", "low sun", "perspective"])
def test_it_stays_on_the_ground_below(renderer: Renderer, jump: Document, light: dict[str, Any]) -> None:
    document = with_values(jump, light)
    for frame in AIR:
        found = shadow(renderer, document, frame)
        rows, columns = np.nonzero(found > 0.5)
        # The feet stand at row 900; only they are so low.
        assert abs(rows.max() - 899) <= 4
        assert abs(columns[rows >= rows.max() - 3].mean() - 500) < 60
        assert not found[0].any()
        assert not found[:, [0, -1]].any()


def test_on_the_ground_the_height_changes_not_a_pixel(renderer: Renderer, jump: Document) -> None:
    most = {f"layers.A.shadow.lift_{name}": 1.0 for name in ("shrink", "soften", "fade")}
    for frame in (4, 12):
        assert (shadow(renderer, jump, frame) == shadow(renderer, with_values(jump, most), frame)).all()
    assert shadow(renderer, jump, PEAK).sum() > 1.5 * shadow(renderer, with_values(jump, most), PEAK).sum()
