"""Round faces: what is left undrawn of them holds no shadow."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

from kagezou.geometry.box import Box
from kagezou.geometry.shadow import SpaceCast
from kagezou.io.images.cel_cache import CelCache
from kagezou.render.gpu.mattes import PlacedMatte
from kagezou.render.prepare.shadow_tiles import Tiling, whole_grid
from kagezou.render.renderer import Renderer
from kagezou.render.sets import round_faces
from kagezou.render.sets.round_faces import RoundLit
from kagezou.scene.evaluate import evaluate
from tests.render.sets.test_exactness import in_a_set, random_piece, view
from tests.render.test_exactness import random_light


def every_tile(lit: RoundLit, _casts: Sequence[SpaceCast], _matte: PlacedMatte, canvas: Box) -> Tiling:
    return whole_grid(lit.face.box).tiling(canvas)


@pytest.mark.parametrize("seed", [3, 6, 13, 17, 26, 39])
def test_tiles_that_are_left_out_hold_no_shadow(
    renderer: Renderer, figure: Path, monkeypatch: pytest.MonkeyPatch, seed: int
) -> None:
    """Also where a tile holds the rim, whose patch its corners do not bound."""
    rng = np.random.default_rng(seed)
    piece = random_piece(rng, ("sphere", "cylinder")[seed % 2]) | {"width": float(rng.uniform(30, 320))}
    scene = evaluate(in_a_set(figure, {"one": piece}, view(rng) | random_light(rng)), 1)
    got = renderer.coverage(scene, scene.layers[0])
    assert got.any()
    monkeypatch.setattr(round_faces, "_shaded_tiles", every_tile)
    whole = Renderer(CelCache())
    assert np.array_equal(got, whole.coverage(scene, scene.layers[0]))
    whole.close()
