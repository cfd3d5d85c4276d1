"""Figures mirrored in the ground, against rays that a mirror throws back."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.document import edits
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.document.set_pieces import add_piece
from kagezou.document.wave_edits import loop_waves
from kagezou.geometry.box import Box
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from kagezou.scene.scene import Reflection, Scene
from kagezou.standing.foot import Foot, FootPin, Verdict
from tests.render.reference import mirror
from tests.render.reference.figures import figure_alpha, with_values
from tests.render.reference.raycast import Art

WIDE, TALL = 1000, 1500
FEET = ((440.0, 899.0), (565.0, 870.0))
VIEWS: dict[str, Mapping[str, object]] = {
    "plain": {},
    "steep": {"ground.declination": 35.0, "ground.roll": 6.0},
    "flat": {"ground.declination": 80.0},
    "perspective": {"camera.fov": 40.0, "ground.roll": -5.0},
    "turned": {"layers.A.tilt": 25.0, "camera.fov": 25.0},
    "leaning half up": {"layers.A.reflection.upright": 0.5, "ground.declination": 70.0},
    "the shadow's card": {"layers.A.reflection.upright": 0.0, "ground.declination": 70.0, "layers.A.tilt": -15.0},
    "waves": {
        "layers.A.shadow.wave1.amplitude": 9.0,
        "layers.A.shadow.wave2.amplitude": 4.0,
        "layers.A.shadow.wave_anchor": 120.0,
        "camera.fov": 20.0,
    },
}


def mirroring(path: Path, values: Mapping[str, object], *, on_feet: bool = False) -> Document:
    """A figure over wide ground, mirrored in full; its drawing lies on a canvas of 1000 x 1700 px."""
    drawing = Drawing("1", path, size_px=(1000, 1000))
    if on_feet:
        feet = tuple(Foot(track, place) for track, place in enumerate(FEET))
        pins = tuple(FootPin(foot.track, Verdict.PLANTED) for foot in feet)
        drawing = replace(drawing, figure=Box(346, 198, 674, 900), feet=feet, pins=pins)
    top = (TALL - 1000) // 2
    document = edits.add_layer(
        Document(Canvas(WIDE, TALL)), "A", Cels((drawing,), (Exposure(1, 0),)), Box(346, top + 198, 674, top + 900)
    )
    common = {
        "ground.position": [500.0, top + 900.0],
        "light.position": [200.0, 100.0, 900.0],
        "layers.A.reflection.opacity": 1.0,
        "layers.A.stance": "feet" if on_feet else "line",
    }
    return with_values(document, {**common, **values})


def reflection_in(scene: Scene) -> Reflection:
    found = scene.layers[0].reflection
    assert found is not None
    return found


def drawn(renderer: Renderer, scene: Scene) -> NDArray[np.float64]:
    return np.asarray(renderer.reflection(scene, scene.layers[0], 16) / 65535)


def iou(one: NDArray[np.float64], other: NDArray[np.float64]) -> float:
    return float(np.minimum(one, other).sum() / np.maximum(one, other).sum())


def rays(scene: Scene, hint: NDArray[np.float64]) -> NDArray[np.float64]:
    return mirror.coverage(reflection_in(scene), Art(figure_alpha() / 255, 0, (TALL - 1000) // 2), hint)


@pytest.mark.parametrize("view", VIEWS)
@pytest.mark.parametrize("on_feet", [False, True], ids=["flat", "relief"])
def test_the_ground_mirrors_what_rays_find(renderer: Renderer, figure: Path, view: str, *, on_feet: bool) -> None:
    scene = evaluate(mirroring(figure, VIEWS[view], on_feet=on_feet), 1)
    assert (len(reflection_in(scene).card.pieces) > 1) == on_feet
    got = drawn(renderer, scene)[..., 3]
    assert got.sum() > 20_000
    wanted = rays(scene, got)
    # Where nothing shrinks a pixel shows what lies at its middle, as a flipped drawing does, and not a mean.
    assert iou(got, wanted) >= 0.993
    assert iou(np.asarray(got >= 0.5), np.asarray(wanted >= 0.5)) >= 0.999


def test_an_upright_body_is_mirrored_as_tall_as_it_is(renderer: Renderer, figure: Path) -> None:
    """Seen straight on, the reflection is the drawing turned over at the ground line, whatever the declination."""
    for declination in (30.0, 60.0, 85.0):
        scene = evaluate(mirroring(figure, {"ground.declination": declination}), 1)
        got = drawn(renderer, scene)[..., 3]
        ground = (TALL - 1000) // 2 + 900
        wanted = figure_alpha()[900 - (TALL - ground) : 900][::-1] / 255
        assert iou(got[ground:], wanted) >= 0.998
        assert not got[: ground - 1].any()


def test_it_keeps_colours_or_takes_on_its_own(renderer: Renderer, figure: Path) -> None:
    own = drawn(renderer, evaluate(mirroring(figure, {}), 1))
    solid = own[..., 3] == 1.0
    assert np.allclose(own[solid][:, :3], np.array([200, 120, 60]) / 255, atol=1e-4)
    values = {
        "layers.A.reflection.color": "#0000FF",
        "layers.A.reflection.tone": 0.5,
        "layers.A.reflection.opacity": 0.4,
    }
    toned = drawn(renderer, evaluate(mirroring(figure, values), 1))
    assert np.allclose(toned[solid], np.array([100, 60, 157.5, 102]) / 255, atol=1e-4)


def test_it_fades_with_the_distance_from_the_feet(renderer: Renderer, figure: Path) -> None:
    scene = evaluate(mirroring(figure, {"layers.A.reflection.fade": 400.0}), 1)
    whole = drawn(renderer, evaluate(mirroring(figure, {}), 1))[..., 3]
    got = drawn(renderer, scene)[..., 3]
    ground = (TALL - 1000) // 2 + 900
    # Ground px are foreshortened by the cosine of the declination.
    away = (np.arange(TALL) + 0.5 - ground) / np.cos(np.radians(60.0))
    wanted = whole * np.clip(1 - away / 400.0, 0, 1)[:, np.newaxis]
    assert np.abs(got - wanted)[whole == 1.0].max() < 1e-3


def test_still_water_and_empty_cels_mirror_nothing(renderer: Renderer, figure: Path) -> None:
    document = mirroring(figure, {"layers.A.reflection.opacity": 0.0})
    scene = evaluate(document, 1)
    assert scene.layers[0].reflection is None
    assert not renderer.reflection(scene, scene.layers[0]).any()


def test_pieces_of_the_set_hide_it(renderer: Renderer, figure: Path) -> None:
    document = mirroring(figure, {})
    whole = drawn(renderer, evaluate(document, 1))[..., 3]
    document = add_piece(document, "crate", "box", {"position": [500, 1350], "width": 260, "height": 120, "depth": 120})
    got = drawn(renderer, evaluate(document, 1))[..., 3]
    hidden = (whole == 1.0) & (got == 0.0)
    assert hidden.sum() > 5_000
    assert np.array_equal(got[~hidden & (whole == 1.0)] > 0, (whole > 0)[~hidden & (whole == 1.0)])


def test_it_lies_in_the_picture_over_shadows_and_under_figures(renderer: Renderer, figure: Path) -> None:
    scene = evaluate(mirroring(figure, {"layers.A.reflection.opacity": 0.5}), 1)
    renderer.draw_picture(scene, Backdrop.WHITE)
    picture = renderer.read_picture()[..., :3] / 255
    mirrored, shadow = drawn(renderer, scene), renderer.shadow(scene, scene.layers[0]).rgba() / 255
    drawing = np.zeros((TALL, WIDE))
    top = (TALL - 1000) // 2
    drawing[top : top + 1000] = figure_alpha() / 255
    ground = 1 - shadow[..., 3:] * (1 - shadow[..., :3])
    wanted = ground + mirrored[..., 3:] * (mirrored[..., :3] - ground)
    clear = drawing == 0
    assert np.abs(picture - wanted)[clear].max() < 2 / 255
    assert np.allclose(picture[drawing == 1], np.array([200, 120, 60]) / 255, atol=1e-6)


def test_waves_that_loop_bring_shadow_gaps_and_reflection_back(renderer: Renderer, figure: Path) -> None:
    """Frame 1 is the frame after the last one, and the one between is another."""
    values = {**VIEWS["waves"], "layers.A.shadow.slits": 0.8, "layers.A.shadow.wave1.amplitude": 14.0}
    document = mirroring(figure, values)
    document = replace(document, canvas=replace(document.canvas, length_frames=24))
    document = with_values(document, {"layers.A.shadow.wave1.velocity": 7.3, "layers.A.shadow.wave2.velocity": -2.1})
    document = loop_waves(document, ("layer-1",), 1)
    shown = [evaluate(document, frame) for frame in (1, 13, 25)]
    assert shown[0].layers[0].cast != shown[1].layers[0].cast

    def covered(scene: Scene) -> NDArray[np.float64]:
        return np.asarray(renderer.coverage(scene, scene.layers[0]) / 65535)

    def mirrored(scene: Scene) -> NDArray[np.float64]:
        return drawn(renderer, scene)

    for draw in (covered, mirrored):
        first, between, again = map(draw, shown)
        assert np.abs(first - again).max() < 0.02
        assert np.abs(first - between).max() > 0.5
