"""The patches under the feet: where the ground is touched, as large as they are asked for, none under a lifted foot."""

from dataclasses import replace
from math import cos, pi, radians
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.document.model import Cels, Document
from kagezou.geometry.box import Box
from kagezou.geometry.ground import canvas_from_plane
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from kagezou.standing.foot import Foot, FootPin, Verdict
from tests.render.reference.figures import standing, with_values

TALL = 702.0
RADIUS = 0.05 * TALL
FEET = ((440.0, 860.0), (565.0, 830.0))


def on_feet(path: Path, values: dict[str, Any] | None = None, *, lifted_px: float = 0.0) -> Document:
    """The test figure on two feet, the second of them held over the ground it stood on."""
    common = {"layers.A.contact.strength": 1.0, "layers.A.contact.softness": 0.0, "ground.position": [500.0, 850.0]}
    document = with_values(standing(path), common | (values or {}))
    layer = document.layers[0]
    (left, row), (right, low) = FEET
    feet = (Foot(0, (left, row)), Foot(1, (right, low - lifted_px)))
    pins = (FootPin(0, Verdict.PLANTED), FootPin(1, Verdict.LIFTED if lifted_px else Verdict.PLANTED, ground_row=low))
    drawing = replace(
        layer.cels.drawings[0], size_px=(1000, 1000), figure=Box(346, 198, 674, 900), feet=feet, pins=pins
    )
    return replace(document, layers=(replace(layer, cels=Cels((drawing,), layer.cels.exposures)),))


def patches(renderer: Renderer, document: Document) -> NDArray[np.float64]:
    scene = evaluate(document, 1)
    return np.asarray(renderer.contact(scene, scene.layers[0], 16).rgba()[..., 3] / 65535)


def discs(document: Document, places: dict[tuple[float, float], float]) -> NDArray[np.bool_]:
    """Return the discs of radii on the ground around where canvas points lie on it."""
    scene = evaluate(document, 1)
    plane = np.linalg.inv(canvas_from_plane(scene.camera, scene.ground))
    y, x = np.mgrid[0:1000, 0:1000] + 0.5
    u, v, w = np.tensordot(plane, np.array([x, y, np.ones_like(x)]), 1)
    found = np.zeros((1000, 1000), bool)
    for (px, py), radius in places.items():
        a, b, c = plane @ (px, py, 1.0)
        found |= (w > 0) & (np.hypot(u / w - a / c, v / w - b / c) <= radius)
    return found


CAMERAS: list[dict[str, Any]] = [{}, {"camera.fov": 45.0, "ground.roll": 8.0}, {"ground.declination": 25.0}]


@pytest.mark.parametrize("camera", CAMERAS, ids=["straight", "perspective", "from above"])
def test_a_disc_lies_under_each_foot(renderer: Renderer, figure: Path, camera: dict[str, Any]) -> None:
    document = on_feet(figure, camera)
    found, wanted = patches(renderer, document), discs(document, dict.fromkeys(FEET, RADIUS))
    assert np.minimum(found, wanted).sum() / np.maximum(found, wanted).sum() > 0.97


def test_a_lifted_foot_has_less_and_then_none(renderer: Renderer, figure: Path) -> None:
    one = pi * RADIUS**2 * cos(radians(60.0))
    areas = [patches(renderer, on_feet(figure, lifted_px=up)).sum() for up in (0.0, 0.06 * TALL, 0.13 * TALL)]
    assert areas == pytest.approx([2 * one, 1.25 * one, one], rel=0.03)


def test_its_size_strength_and_softness(renderer: Renderer, figure: Path) -> None:
    plain = patches(renderer, on_feet(figure))
    wide = patches(renderer, on_feet(figure, {"layers.A.contact.size": 1.5}))
    assert wide.sum() == pytest.approx(2.25 * plain.sum(), rel=0.03)
    soft = patches(renderer, on_feet(figure, {"layers.A.contact.softness": 0.8, "layers.A.contact.strength": 0.5}))
    assert soft.max() <= 0.5 + 1e-4
    assert (soft > 0).sum() > 1.3 * (plain > 0).sum()
    assert not patches(renderer, on_feet(figure, {"layers.A.contact.strength": 0.0})).any()


def test_in_the_picture_it_darkens_the_shadow_under_the_foot(renderer: Renderer, figure: Path) -> None:
    document = on_feet(figure)
    scene = evaluate(document, 1)
    bare = replace(scene, layers=tuple(replace(layer, drawing=None) for layer in scene.layers))
    renderer.draw_picture(bare, Backdrop.WHITE)
    picture = renderer.read_picture()[..., :3] / 255
    layer = scene.layers[0]
    wanted = np.ones_like(picture)
    for shadow in (renderer.shadow(scene, layer), renderer.contact(scene, layer)):
        rgba = shadow.rgba() / 255
        wanted = wanted * (1 - rgba[..., 3:] * (1 - rgba[..., :3]))
    assert np.abs(picture - wanted).max() < 2 / 255
