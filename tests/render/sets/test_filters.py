"""Filters on set pieces: against an exact Gaussian on ground and wall laid flat, and where receivers meet."""

from collections.abc import Mapping
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from kagezou.scene.scene import ShadowCast
from tests.render.reference import raycast
from tests.render.reference.figures import figure_alpha, with_values
from tests.render.reference.outlines import Shift
from tests.render.reference.raycast import Array
from tests.render.reference.unfolded import FoldedGround, px_areas, simplified
from tests.render.sets.test_exactness import Pieces, in_a_set

SHADOW = "layers.A.shadow."
LIGHT: dict[str, object] = {"light.position": [300, -400, 950]}
WALL: Pieces = {
    "wall": {"kind": "wall", "position": [500, 800], "width": 2400, "height": 1100, "angle": -8, "lean": 25}
}
FILTERS: dict[str, dict[str, object]] = {
    "simplified": {SHADOW + "simplify": 20.0},
    "with the distance": {SHADOW + "simplify": 60.0, SHADOW + "distance": 200.0},
    "in waves": {SHADOW + "simplify": 12.0, SHADOW + "wave1.amplitude": 6.0, SHADOW + "wave1.wavelength": 90.0},
    "soft": {SHADOW + "softness": 12.0},
}


def seen(renderer: Renderer, figure: Path, pieces: Pieces, values: Mapping[str, object]) -> tuple[ShadowCast, Array]:
    scene = evaluate(in_a_set(figure, pieces, LIGHT | dict(values)), 1)
    cast = scene.layers[0].cast
    assert cast is not None
    return cast, np.asarray(renderer.coverage(scene, scene.layers[0]) / 65535)


@pytest.mark.parametrize(("amount", "distance", "fov"), [(20.0, 0.0, 0.0), (60.0, 200.0, 40.0)])
def test_a_wall_shows_the_gaussian_of_its_own_plane(
    renderer: Renderer, figure: Path, amount: float, distance: float, fov: float
) -> None:
    values = {SHADOW + "simplify": amount, SHADOW + "distance": distance, "camera.fov": fov}
    cast, got = seen(renderer, figure, WALL, values)
    folded = FoldedGround.of(cast)
    shadow = folded.fallen(raycast.Art(figure_alpha() / 255))
    assert not np.concatenate([*shadow.value[[0, -1]], *shadow.value.T[[0, -1]]]).any()
    field, level = simplified(shadow, amount, distance)
    rows, columns = np.nonzero(got.any(axis=1))[0], np.nonzero(got.any(axis=0))[0]
    box = (int(columns[0]) - 6, int(rows[0]) - 6, int(columns[-1]) + 6, 880)
    exact = folded.coverage(field, level, box)
    shift = Shift.between(got[box[1] : box[3], box[0] : box[2]], exact)
    assert shift.mean < 0.25
    assert shift.p99 < 0.75


@pytest.mark.parametrize("name", ["simplified", "with the distance"])
def test_the_unfolded_shadow_keeps_its_area(renderer: Renderer, figure: Path, name: str) -> None:
    cast, plain = seen(renderer, figure, WALL, {})
    _, got = seen(renderer, figure, WALL, FILTERS[name])
    areas = px_areas(cast, 1000, 1000)
    assert not plain[0].any()
    assert not got[0].any()
    assert (got * areas).sum() == pytest.approx((plain * areas).sum(), rel=0.01)


def outer_crossings(coverage: Array) -> Array:
    """Return where the outline begins and ends in each row that has it, (rows, 2), px."""
    found = []
    for row in coverage:
        inside = np.nonzero(row > 0.5)[0]
        first, last = int(inside[0]), int(inside[-1])
        left = first - (row[first] - 0.5) / max(row[first] - row[first - 1], 1e-6)
        right = last + (row[last] - 0.5) / max(row[last] - row[last + 1], 1e-6)
        found.append((left, right))
    return np.array(found)


@pytest.mark.parametrize("name", FILTERS)
def test_no_outline_jumps_at_the_foot_of_a_wall_or_on_steps(renderer: Renderer, figure: Path, name: str) -> None:
    sets: dict[str, tuple[Pieces, slice]] = {
        "wall": ({"wall": {**WALL["wall"], "angle": 0, "position": [500, 800.5]}}, slice(780, 822)),
        "steps": (
            {"steps": {"kind": "steps", "position": [500, 790], "width": 1600, "height": 90, "depth": 120, "count": 3}},
            slice(740, 840),
        ),
    }
    for pieces, rows in sets.values():
        _, got = seen(renderer, figure, pieces, FILTERS[name])
        crossings = outer_crossings(got[rows])
        steps = np.abs(np.diff(crossings, axis=0))
        around = np.maximum(
            np.pad(steps, ((1, 0), (0, 0)), mode="edge")[:-1], np.pad(steps, ((0, 1), (0, 0)), mode="edge")[1:]
        )
        assert (steps - around).max() < 1.0


@pytest.mark.parametrize("name", FILTERS)
def test_no_gap_along_the_edges_of_a_box(renderer: Renderer, figure: Path, name: str) -> None:
    """Where the shadow lies on both sides of an edge between two lit faces, or a face and the ground, it is whole."""
    box = {"box": {"kind": "box", "position": [560, 800], "width": 160, "height": 70, "depth": 110, "angle": 30}}
    _, plain = seen(renderer, figure, box, {})
    _, got = seen(renderer, figure, box, FILTERS[name])
    # Far within the shadow there is nothing but shadow.
    solid = plain > 0.999
    for _ in range(14):
        rim = np.pad(solid, 1)
        solid = solid & rim[2:, 1:-1] & rim[:-2, 1:-1] & rim[1:-1, 2:] & rim[1:-1, :-2]
    assert solid.sum() > 2000
    assert got[solid].min() > 0.98


@pytest.mark.parametrize("simplify", [0.0, 15.0])
def test_opacity_falls_down_the_ground_and_up_the_wall(renderer: Renderer, figure: Path, simplify: float) -> None:
    wall: Pieces = {"wall": {"kind": "wall", "position": [500, 800], "width": 2400, "height": 600}}
    values = {SHADOW + "fade": 500.0, SHADOW + "opacity": 1.0, SHADOW + "simplify": simplify}
    scene = evaluate(in_a_set(figure, wall, LIGHT | values), 1)
    image = renderer.shadow(scene, scene.layers[0], depth=16)
    covered = renderer.coverage(scene, scene.layers[0]) / 65535
    box = image.box
    alpha = np.zeros((1000, 1000))
    alpha[box.top : box.bottom, box.left : box.right] = image.alpha / 65535
    middles = np.arange(1000) + 0.5
    # Seen at 60 degrees, the ground is half as high on the canvas as it is deep, and a wall 0.866 times as it is high.
    away = np.where(middles > 800, (900 - middles) / 0.5, 200 + (800 - middles) / np.sin(np.radians(60)))
    for row in (890, 850, 802, 797, 750, 700):
        inside = covered[row] > 0.999
        assert inside.sum() > 10
        assert np.abs(alpha[row][inside] - (1 - away[row] / 500)).max() < 0.002


def test_without_filters_and_far_from_pieces_nothing_changes(renderer: Renderer, figure: Path) -> None:
    far: Pieces = {"far": {"kind": "box", "position": [120, 950], "width": 60, "height": 40, "depth": 40}}
    for values in FILTERS.values():
        _, flat = seen(renderer, figure, {}, values)
        _, got = seen(renderer, figure, far, values)
        assert np.array_equal(got, flat)
    _, crisp = seen(renderer, figure, WALL, {})
    _, off = seen(renderer, figure, WALL, {SHADOW + "simplify": 0.0, SHADOW + "distance": 200.0})
    assert np.array_equal(crisp, off)


def test_a_light_that_moves_a_little_moves_a_filtered_shadow_a_little(renderer: Renderer, figure: Path) -> None:
    box: Pieces = {
        "box": {"kind": "box", "position": [560, 800], "width": 160, "height": 70, "depth": 110, "angle": 30},
        "back": {"kind": "wall", "position": [500, 700], "width": 900, "height": 500},
    }
    document = with_values(in_a_set(figure, box, LIGHT), FILTERS["with the distance"])

    def at(x: float) -> Array:
        scene = evaluate(with_values(document, {"light.position": [x, -400, 950]}), 1)
        return np.asarray(renderer.coverage(scene, scene.layers[0]) / 65535)

    shown = [at(300.0 + step) for step in range(3)]
    for before, after in pairwise(shown):
        assert np.abs(after - before).sum() < 0.02 * before.sum()


def test_a_light_below_the_ground_or_low_over_it_is_no_harm(renderer: Renderer, figure: Path) -> None:
    values = {**FILTERS["with the distance"], SHADOW + "softness": 12.0}
    _, dark = seen(renderer, figure, WALL, {**values, "light.position": [500.0, 2000.0, 0.0]})
    assert not dark.any()
    low = {"light.kind": "sun", "light.azimuth": 20.0, "light.elevation": 2.5}
    _, shown = seen(renderer, figure, WALL, {**values, **low})
    assert shown.any()
