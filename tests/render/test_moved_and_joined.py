"""Cels that their layer moves, and several cels that are one figure: what they cast and what is seen of them."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.document import edits
from kagezou.document.model import Cels, Document, Drawing, Exposure
from kagezou.geometry.box import Box
from kagezou.geometry.placement import Placement
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from kagezou.standing.foot import Foot, FootPin, Verdict
from tests.render.reference.figures import figure_alpha, standing, with_values, write_figure

WAIST = 660


def coverage(renderer: Renderer, document: Document, index: int = 0) -> NDArray[Any]:
    scene = evaluate(document, 1)
    return renderer.coverage(scene, scene.layers[index]) / 65535


def picture(renderer: Renderer, document: Document) -> NDArray[Any]:
    """Premultiplied, so that colours count as much as they are seen."""
    renderer.draw_picture(evaluate(document, 1), Backdrop.TRANSPARENT)
    seen = renderer.read_picture().astype(np.int64)
    seen[..., :3] = seen[..., :3] * seen[..., 3:] // 255
    return seen


def iou(one: NDArray[Any], other: NDArray[Any]) -> float:
    return float(np.minimum(one, other).sum() / np.maximum(one, other).sum())


def with_part(document: Document, name: str, path: Path) -> Document:
    cels = Cels((Drawing("1", path),), (Exposure(1, 0),))
    return edits.add_layer(document, name, cels, Box(0, 0, 1000, 1000))


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_figure(tmp_path_factory.mktemp("whole") / "whole.png", figure_alpha())


@pytest.fixture(scope="module")
def halves(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """The figure cut at the waist: legs, body."""
    folder, alpha = tmp_path_factory.mktemp("halves"), figure_alpha()
    legs, body = alpha.copy(), alpha.copy()
    legs[:WAIST] = 0
    body[WAIST:] = 0
    return write_figure(folder / "legs.png", legs), write_figure(folder / "body.png", body)


MOVES = [
    {"position": [620.0, 470.0], "scale": [80.0, 80.0]},
    {"position": [520.0, 560.0], "rotation": 17.0, "scale": [70.0, 70.0]},
    {"position": [480.0, 520.0], "scale": [-90.0, 90.0], "rotation": -6.0},
    {"position": [437.0, 500.0], "anchor": [470.0, 700.0]},
]
CASTS = [
    {},
    {"camera.fov": 35.0, "ground.roll": 7.0, "layers.A.tilt": 20.0},
    {"layers.A.grounding": [[440.0, 880.0]]},
]


@pytest.mark.parametrize("cast", CASTS, ids=["plain", "perspective", "grounded"])
@pytest.mark.parametrize("move", MOVES, ids=["scaled", "turned", "mirrored", "about an anchor"])
def test_a_moved_drawing_casts_what_it_casts_drawn_there(
    renderer: Renderer, whole: Path, tmp_path: Path, move: dict[str, Any], cast: dict[str, Any]
) -> None:
    moved = with_values(standing(whole), cast | {f"layers.A.{name}": value for name, value in move.items()})
    x, y = move.get("scale", [100.0, 100.0])
    anchor = tuple(move.get("anchor", [500.0, 500.0]))
    place = Placement(tuple(move["position"]), anchor, (x / 100, y / 100), move.get("rotation", 0.0))
    drawn = write_figure(tmp_path / "there.png", figure_alpha(moved=place))
    there = with_values(standing(drawn), cast)
    mine, wanted = coverage(renderer, moved), coverage(renderer, there)
    assert wanted.sum() > 5000
    assert iou(mine, wanted) >= 0.995
    assert np.abs(picture(renderer, moved) - picture(renderer, there))[..., 3].mean() < 0.1


@pytest.mark.parametrize("filtered", [{"simplify": 30.0}, {"softness": 12.0}, {"simplify": 60.0, "distance": 200.0}])
def test_filters_see_the_moved_drawing(
    renderer: Renderer, whole: Path, tmp_path: Path, filtered: dict[str, float]
) -> None:
    values = {f"layers.A.shadow.{name}": value for name, value in filtered.items()}
    place = Placement((560.0, 520.0), (500.0, 500.0), (-0.8, 0.8), 9.0)
    moved = {"layers.A.position": [560.0, 520.0], "layers.A.scale": [-80.0, 80.0], "layers.A.rotation": 9.0}
    mine = coverage(renderer, with_values(standing(whole), values | moved))
    drawn = write_figure(tmp_path / "there.png", figure_alpha(moved=place))
    assert iou(mine, coverage(renderer, with_values(standing(drawn), values))) >= 0.995


def test_a_whole_step_moves_every_pixel_with_it(renderer: Renderer, whole: Path) -> None:
    """The contact, too: the sun casts the same shadow from the same place of another ground."""
    sun = {"light.kind": "sun", "light.elevation": 40.0}
    still = with_values(standing(whole), sun)
    moved = with_values(still, {"layers.A.position": [540.0, 470.0], "ground.position": [540.0, FEET - 30.0]})
    before, after = picture(renderer, still), picture(renderer, moved)
    assert (np.roll(before, (-30, 40), (0, 1))[100:850, 100:850] == after[100:850, 100:850]).mean() > 0.9999


FEET = 900.0


def test_nothing_is_seen_of_what_is_scaled_to_nothing(renderer: Renderer, whole: Path) -> None:
    document = with_values(standing(whole), {"layers.A.scale": [0.0, 100.0]})
    assert not picture(renderer, document).any()
    assert not coverage(renderer, document).any()


@pytest.mark.parametrize("simplify", [0.0, 20.0, 60.0])
def test_a_figure_in_two_cels_casts_what_the_whole_one_casts(
    renderer: Renderer, whole: Path, halves: tuple[Path, Path], simplify: float
) -> None:
    legs, body = halves
    values = {"layers.A.shadow.simplify": simplify}
    alone = with_values(standing(whole), values)
    document = with_part(with_values(standing(body), values), "legs", legs)
    document = edits.join_layer(document, document.layers[1].id, document.layers[0].id)
    assert iou(coverage(renderer, document), coverage(renderer, alone)) >= 0.9995
    assert evaluate(document, 1).layers[1].cast is None
    # Nothing is darkened twice: the picture is that of the whole figure.
    assert np.abs(picture(renderer, document) - picture(renderer, alone)).max() <= 1


def test_parts_may_be_moved_each_by_itself(renderer: Renderer, halves: tuple[Path, Path], tmp_path: Path) -> None:
    legs, body = halves
    document = with_part(standing(legs), "body", body)
    document = edits.join_layer(document, document.layers[1].id, document.layers[0].id)
    values = {
        "layers.body.rotation": 20.0,
        "layers.body.anchor": [500.0, 660.0],
        "layers.body.position": [500.0, 660.0],
    }
    place = Placement((500.0, 660.0), (500.0, 660.0), (1.0, 1.0), 20.0)
    bent = figure_alpha()
    bent[:WAIST] = 0
    upper = figure_alpha(moved=place)
    turned = np.array(np.mgrid[0:1000, 0:1000][::-1]) + 0.5 - np.array([500.0, 660.0])[:, None, None]
    upper[turned[1] * np.cos(np.radians(20)) - turned[0] * np.sin(np.radians(20)) > 0] = 0
    drawn = write_figure(tmp_path / "bent.png", np.maximum(bent, upper))
    assert iou(coverage(renderer, with_values(document, values)), coverage(renderer, standing(drawn))) >= 0.995
    both = values | {f"layers.A.{name}": value for name, value in {"scale": [100.0, 100.0]}.items()}
    assert coverage(renderer, with_values(document, both)).sum() > 0


def test_an_empty_or_hidden_part_takes_no_part(renderer: Renderer, halves: tuple[Path, Path]) -> None:
    legs, body = halves
    document = with_part(standing(legs), "body", body)
    document = edits.join_layer(document, document.layers[1].id, document.layers[0].id)
    hidden = with_values(document, {"layers.body.visible": False})
    assert (coverage(renderer, hidden) == coverage(renderer, standing(legs))).all()
    empty = edits.set_exposures(document, document.layers[0].id, (Exposure(1, None),))
    scene = evaluate(empty, 1)
    assert scene.layers[0].drawing is None
    assert (renderer.coverage(scene, scene.layers[0]) / 65535 == coverage(renderer, standing(body))).all()


def test_no_part_casts_on_its_own_figure(halves: tuple[Path, Path]) -> None:
    legs, body = halves
    document = with_part(with_values(standing(legs), {"layers.A.receives": True}), "body", body)
    document = with_values(document, {"layers.body.receives": True})
    document = edits.join_layer(document, document.layers[1].id, document.layers[0].id)
    received = [layer.received for layer in evaluate(document, 1).layers]
    assert all(each is not None and not each.shades for each in received)


def test_the_depth_map_agrees_with_a_moved_figure(renderer: Renderer, whole: Path) -> None:
    values = {"layers.A.scale": [60.0, 60.0], "layers.A.position": [500.0, 650.0], "layers.A.rotation": 10.0}
    scene = evaluate(with_values(standing(whole), values), 1)
    literal = renderer.depth_map_coverage(scene, scene.layers[0]) / 65535
    assert iou(renderer.coverage(scene, scene.layers[0]) / 65535, literal) > 0.97


FEET_AT = ((440.0, 890.0), (565.0, 868.0))


def on_feet(document: Document, alpha: NDArray[np.uint8], *places: tuple[float, float]) -> Document:
    """The first layer, of this alpha, on feet that carry, drawing px."""
    (drawing,) = document.layers[0].cels.drawings
    feet = tuple(Foot(track, place) for track, place in enumerate(places))
    pins = tuple(FootPin(foot.track, Verdict.PLANTED) for foot in feet)
    rows, columns = np.nonzero(alpha.any(axis=1))[0], np.nonzero(alpha.any(axis=0))[0]
    figure = Box(int(columns[0]), int(rows[0]), int(columns[-1]) + 1, int(rows[-1]) + 1)
    standing = replace(drawing, size_px=(1000, 1000), figure=figure, feet=feet, pins=pins)
    return edits.set_drawings(document, document.layers[0].id, (standing,))


@pytest.mark.parametrize("values", [{}, {"camera.fov": 35.0, "ground.roll": 6.0, "layers.A.tilt": 12.0}])
@pytest.mark.parametrize("simplify", [0.0, 25.0])
def test_a_mirrored_cel_stands_on_its_feet_as_one_drawn_there(
    renderer: Renderer, whole: Path, tmp_path: Path, values: dict[str, Any], simplify: float
) -> None:
    place = Placement((520.0, 530.0), (500.0, 500.0), (-0.8, 0.8), 4.0)
    moved = {"layers.A.position": [520.0, 530.0], "layers.A.scale": [-80.0, 80.0], "layers.A.rotation": 4.0}
    common = values | {"layers.A.shadow.simplify": simplify}
    mine = with_values(on_feet(standing(whole), figure_alpha(), *FEET_AT), common | moved)
    moved_alpha = figure_alpha(moved=place)
    drawn = write_figure(tmp_path / "there.png", moved_alpha)
    there = with_values(on_feet(standing(drawn), moved_alpha, *map(place.placed, FEET_AT)), common)
    first, second = (evaluate(each, 1).layers[0].card for each in (mine, there))
    assert len(first.pieces) > 3
    assert np.allclose(first.contacts[0], second.contacts[0]) or np.allclose(first.contacts[0], second.contacts[1])
    assert iou(coverage(renderer, mine), coverage(renderer, there)) >= 0.995
