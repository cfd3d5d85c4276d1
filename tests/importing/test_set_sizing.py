"""The size of an imported set, told by two of its points."""

from pathlib import Path

import numpy as np
import pytest

from kagezou.document.address import Address
from kagezou.document.edits import add_layer, set_constant
from kagezou.document.model import Canvas, Cels, Document
from kagezou.document.properties import GROUND_POSITION
from kagezou.document.set_pieces import add_piece
from kagezou.errors import UsageProblem
from kagezou.geometry.box import Box
from kagezou.geometry.sets.measures import PieceKind
from kagezou.importing.set_placing import placement
from kagezou.importing.set_sizing import figure_height, sized


def stage() -> Document:
    document = add_layer(Document(Canvas(800, 600)), "A", Cels(), Box(300, 200, 500, 520))
    document = set_constant(document, Address(GROUND_POSITION), (400.0, 520.0))
    return add_piece(document, "set", PieceKind.MESH, {"position": (400.0, 520.0)}, Path("/sets/a.glb"))


@pytest.mark.parametrize("heights", [0.25, 1.0, 3.5])
def test_the_points_come_to_lie_as_far_apart_as_said(heights: float) -> None:
    document = stage()
    piece_id = document.pieces[0].id
    between = ((0.0, 0.0, 0.0), (1.0, 2.0, -2.0))
    world_from_mesh = placement(sized(document, piece_id, between, heights, 1), piece_id, 1)
    assert world_from_mesh is not None
    a, b = (world_from_mesh @ [*point, 1.0] for point in between)
    assert np.linalg.norm(a - b) == pytest.approx(heights * 320)


def test_without_a_character_half_the_canvas_is_the_measure() -> None:
    assert figure_height(Document(Canvas(800, 600))) == 300.0
    assert figure_height(stage()) == 320.0


@pytest.mark.parametrize(("between", "heights"), [(((0.0, 0.0, 0.0), (0.0, 0.0, 0.0)), 1.0),
                                                  (((0.0, 0.0, 0.0), (1.0, 0.0, 0.0)), 0.0)])  # fmt: skip
def test_a_size_of_nothing_is_refused(
    between: tuple[tuple[float, float, float], tuple[float, float, float]], heights: float
) -> None:
    document = stage()
    with pytest.raises(UsageProblem, match="two different points"):
        sized(document, document.pieces[0].id, between, heights, 1)
