"""Imported sets of a frame: where their meshes stand, and what becomes of the flat ground."""

from pathlib import Path

import numpy as np
import pytest

from kagezou.document.model import Document
from kagezou.document.set_pieces import add_piece
from kagezou.geometry.camera import project
from kagezou.scene.evaluate import evaluate
from kagezou.scene.left_out import without_pieces
from kagezou.scene.pieces import MeshPlacement
from tests.scene.test_pieces import a_room, with_values

SOURCE = Path("/sets/a.glb")


def a_set(**values: object) -> Document:
    document = with_values(a_room("wall", present=False), camera__fov=40.0, ground__declination=70.0)
    return add_piece(document, "set", "mesh", {"position": (500.0, 900.0), **values}, SOURCE)


def placed(document: Document) -> MeshPlacement:
    (piece,) = evaluate(document, 1).pieces
    assert piece.bodies == ()
    assert piece.mesh is not None
    return piece.mesh


@pytest.mark.parametrize("up", ["y", "z"])
def test_the_anchor_stands_at_the_place_in_its_scale_with_its_axis_up(up: str) -> None:
    document = a_set(anchor=(1.0, 2.0, 3.0), scale=25.0, angle=30.0, up=up, position=(420.0, 870.0))
    scene, mesh = evaluate(document, 1), placed(document)
    assert mesh.path == SOURCE
    matrix = np.array(mesh.world_from_mesh)
    anchor = matrix @ [1.0, 2.0, 3.0, 1.0]
    ground = np.array(scene.ground.equation)
    assert ground @ anchor == pytest.approx(0.0, abs=1e-9)
    assert project(scene.camera.canvas_from_world(), tuple(anchor)) == pytest.approx((420.0, 870.0))
    above = matrix @ (np.array([1.0, 2.0, 3.0, 1.0]) + np.eye(4)[2 if up == "z" else 1])
    # One px of the canvas is w px of the world at that depth.
    w = float(scene.camera.canvas_from_world()[2] @ anchor)
    assert ground @ above == pytest.approx(25.0 * w)
    # A turn and a scale: no shear, and no mirror image.
    linear = matrix[:3, :3] / (25.0 * w)
    assert linear @ linear.T == pytest.approx(np.eye(3), abs=1e-9)
    assert np.linalg.det(linear) == pytest.approx(-1.0), "the world's y points down"


def test_the_ground_may_move_while_the_picture_of_a_set_stays() -> None:
    document = a_set(anchor=(1.0, 0.0, 3.0), scale=25.0)
    moved = with_values(document, ground__position=[640, 820])
    pictures = [
        [
            project(evaluate(each, 1).camera.canvas_from_world(), tuple(np.array(placed(each).world_from_mesh) @ point))
            for point in ([0.0, 0.0, 0.0, 1.0], [3.0, 2.0, -4.0, 1.0])
        ]
        for each in (document, moved)
    ]
    assert np.array(pictures[0]) == pytest.approx(np.array(pictures[1]), abs=1e-6)


def test_a_set_without_a_file_is_not_there() -> None:
    assert evaluate(add_piece(a_room("wall", present=False), "set", "mesh"), 1).pieces == ()


@pytest.mark.parametrize("receives", [True, False])
def test_both_shadows_know_whether_there_is_a_flat_ground(*, receives: bool) -> None:
    scene = evaluate(with_values(a_set(casts=True), ground__receives=receives), 1)
    assert scene.layers[0].cast is not None
    assert scene.layers[0].cast.ground_receives is receives
    assert scene.set_shadow is not None
    assert scene.set_shadow.cast.ground_receives is receives


def test_pieces_that_cannot_be_shown_are_taken_from_everything() -> None:
    document = with_values(a_set(casts=True), ground__receives=False)
    document = add_piece(document, "crate", "box", {"casts": True})
    scene = evaluate(document, 1)
    lost, crate = scene.pieces
    less = without_pieces(scene, {lost.id})
    assert less.pieces == (crate,)
    assert less.set_shadow is not None
    assert less.set_shadow.cast.pieces == (crate,)
    assert less.layers[0].cast is not None
    assert (less.layers[0].cast.pieces, less.layers[0].cast.ground_receives) == ((crate,), False)
    nothing = without_pieces(scene, {lost.id, crate.id})
    assert nothing.set_shadow is None
    assert nothing.layers[0].cast is not None
    assert (nothing.layers[0].cast.pieces, nothing.layers[0].cast.ground_receives) == ((), True)
