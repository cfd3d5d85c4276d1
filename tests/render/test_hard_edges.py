"""Hard edges: a pixel is all shadow or none, in shadows, on characters, under feet and in the ground."""

from pathlib import Path

import numpy as np
import pytest

from kagezou.document.edits import add_layer
from kagezou.document.model import Cels, Document, Drawing, Exposure
from kagezou.document.set_pieces import add_piece
from kagezou.geometry.box import Box
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate, ground_at, light_at
from tests.render.reference.figures import standing, with_values

HARD: dict[str, object] = {"layers.A.shadow.edges": "hard"}


def coverage(renderer: Renderer, document: Document) -> np.ndarray[tuple[int, ...], np.dtype[np.uint16]]:
    scene = evaluate(document, 1)
    return np.asarray(renderer.coverage(scene, scene.layers[0]), np.uint16)


@pytest.mark.parametrize(
    "look",
    [{}, {"simplify": 20.0}, {"softness": 12.0}, {"shape": "disc"}, {"wave1.amplitude": 8.0, "least_part": 60.0}],
    ids=["plain", "simplified", "soft", "round", "waves"],
)
def test_a_pixel_is_all_shadow_or_none(renderer: Renderer, figure: Path, look: dict[str, object]) -> None:
    smooth = with_values(standing(figure), {f"layers.A.shadow.{name}": value for name, value in look.items()})
    before, after = coverage(renderer, smooth), coverage(renderer, with_values(smooth, HARD))
    assert ((before > 0) & (before < 65535)).sum() > 0
    assert np.array_equal(after, np.where(before >= 32768, 65535, 0))


def test_on_a_set_too(renderer: Renderer, figure: Path) -> None:
    document = add_piece(standing(figure), "wall", "wall", {"position": [560, 860], "width": 900, "height": 700})
    found = coverage(renderer, with_values(document, HARD))
    assert set(np.unique(found)) == {0, 65535}


def test_smoke_keeps_its_alpha(renderer: Renderer, figure: Path) -> None:
    smoke = with_values(standing(figure), {"layers.A.shadow.matte": "translucent"})
    assert np.array_equal(coverage(renderer, smoke), coverage(renderer, with_values(smoke, HARD)))


def test_what_falls_on_a_character_is_hard_too(renderer: Renderer, figure: Path) -> None:
    cels = Cels((Drawing("1", figure),), (Exposure(1, 0),))
    document = add_layer(standing(figure), "B", cels, Box(346, 198, 674, 900))
    receiving = {"layers.B.receives": True, "layers.A.grounding": [[500, 930]], "light.position": [500, 0, 900]}
    document = with_values(with_values(document, receiving), HARD)
    scene = evaluate(document, 1)
    found = renderer.received_coverage(scene, scene.layers[1])
    drawing = found[found > 0]
    assert drawing.size > 5000
    # Cut to the drawing's own alpha, which is as it was drawn.
    assert (drawing == 65535).mean() > 0.95


def test_patches_and_reflections_are_hard_too(renderer: Renderer, figure: Path) -> None:
    values = {"contact.strength": 1.0, "reflection.opacity": 1.0, "tilt": 10.0}
    document = with_values(standing(figure), {f"layers.A.{name}": value for name, value in values.items()})
    document = with_values(document, HARD)
    document = with_values(document, {"camera.fov": 30.0, "ground.position": [500.0, 700.0]})
    scene = evaluate(document, 1)
    for alpha in (
        renderer.contact(scene, scene.layers[0]).rgba()[..., 3],
        renderer.reflection(scene, scene.layers[0])[..., 3],
    ):
        assert set(np.unique(alpha)) == {0, 255}


def test_the_lamp_goes_by_whole_steps_where_that_is_asked(figure: Path) -> None:
    document = with_values(standing(figure), {"light.step": 8.0})
    ground = ground_at(document, 1)
    for x, wanted in ((200.0, 200.0), (203.9, 200.0), (204.0, 208.0), (-5.0, -8.0)):
        moved = with_values(document, {"light.position": [x, -199.0, 901.0]})
        assert light_at(moved, 1, ground) == (wanted, -200.0, 904.0, 1.0)
    free = with_values(document, {"light.step": 0.0, "light.position": [203.9, -199.0, 901.0]})
    assert light_at(free, 1, ground) == (203.9, -199.0, 901.0, 1.0)
