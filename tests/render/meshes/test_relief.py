"""Relief cards on meshes, and cards as good as flat, which must not show where their pieces meet."""

from pathlib import Path

import numpy as np
import pytest

from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from tests.render.passes.test_relief import BALL, FEET, WALL, Values, cast_of, drawn, on_feet, planted
from tests.render.reference.mesh_scenes import Meshes, as_meshes
from tests.render.sets.test_exactness import in_a_set
from tests.render.test_exactness import MIN_SHADOW_PX, Agreement


def test_a_mesh_shows_what_the_piece_it_is_made_of_does(mesh_renderer: Renderer, meshes: Meshes, figure: Path) -> None:
    scene = on_feet(evaluate(in_a_set(figure, WALL, {"light.position": [300, -400, 950]}), 1), FEET)
    plain, mesh = drawn(mesh_renderer, scene), drawn(mesh_renderer, as_meshes(scene, meshes))
    assert plain.sum() > MIN_SHADOW_PX
    assert Agreement.of(mesh, plain).iou >= 0.995


# ---- a card that is as good as flat: whatever is seen of its pieces is a seam

NEARLY_FLAT = (planted(440.0, 899.0), planted(565.0, 899.02))
FILTERS: dict[str, Values] = {
    "plain": {},
    "simplified by 20": {"layers.A.shadow.simplify": 20.0},
    "simplified by 60": {"layers.A.shadow.simplify": 60.0, "layers.A.shadow.distance": 200.0},
}
PLACES: dict[str, dict[str, Values]] = {"ground": {}, "wall": WALL, "ball": BALL}


@pytest.mark.parametrize("fov", [0.0, 40.0])
@pytest.mark.parametrize("place", [*PLACES, "mesh"])
@pytest.mark.parametrize("name", FILTERS)
def test_a_card_with_hardly_any_relief_shows_no_seam(
    mesh_renderer: Renderer, meshes: Meshes, figure: Path, name: str, place: str, fov: float
) -> None:
    values = {"light.position": [300, -400, 950], "camera.fov": fov, **FILTERS[name]}
    scene = evaluate(in_a_set(figure, PLACES.get(place, WALL), values), 1)
    scene = as_meshes(scene, meshes) if place == "mesh" else scene
    relief, flat = on_feet(scene, NEARLY_FLAT), on_feet(scene, [planted(502.5, 899.01)])
    assert len(cast_of(relief).card.pieces) > 7
    assert len(cast_of(flat).card.pieces) == 1
    got, wanted = drawn(mesh_renderer, relief), drawn(mesh_renderer, flat)
    assert wanted.sum() > MIN_SHADOW_PX
    assert np.abs(got - wanted).mean() < 0.0005
    # Single pixels of an edge that two pieces share are known to their cells only.
    assert (np.abs(got - wanted) > 0.25).sum() <= (0 if name == "plain" else 12)
