"""A lamp that stands among the meshes it lights: shadows on all sides of it, without a seam."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from kagezou.geometry.mesh import Mesh
from kagezou.render.prepare.light_windows import LightAxes, LightCone, LightWindows
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from kagezou.scene.scene import Scene
from tests.render.reference import mesh_raycast, raycast, set_raycast
from tests.render.reference.figures import figure_alpha, standing, with_values, write_figure
from tests.render.reference.mesh_scenes import Array, Meshes, as_meshes, corners_of, with_pieces
from tests.render.sets.test_exactness import ROOM, in_a_set
from tests.render.test_exactness import Agreement

SIDE = 240
MIN_IOU = 0.99


def box_corners(middle: tuple[float, float, float], size: tuple[float, float, float], turned_deg: float = 0.0) -> Array:
    """The eight corners of a box of the world, turned about the vertical."""
    signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    c, s = np.cos(np.radians(turned_deg)), np.sin(np.radians(turned_deg))
    turn = np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])
    return np.asarray(middle + (signs * np.array(size) / 2) @ turn.T)


QUADS = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
FRONT = 5
"""The side of a box toward the viewer."""


def mesh_of(boxes: list[tuple[Array, tuple[int, ...]]]) -> Mesh:
    """The sides of boxes, each of these numbers, as triangles."""
    points, triangles = [], []
    for number, (corners, sides) in enumerate(boxes):
        points.append(corners)
        for side in sides:
            a, b, c, d = (8 * number + corner for corner in QUADS[side])
            triangles += [(a, b, c), (a, c, d)]
    return Mesh(np.concatenate(points), np.array(triangles, np.int32), np.zeros((0, 2), np.int32))


def room(*, has_beams: bool) -> Mesh:
    """A room without its front, and around its middle boards and pillars that throw shadows on all of it.

    Beams stand along the edges of a cube, so that their shadows run over where its faces meet.
    """
    inside = tuple(side for side in range(6) if side != FRONT)
    every = tuple(range(6))
    boxes = [(box_corners((120.0, 120.0, -60.0), (230.0, 220.0, 240.0)), inside)]
    around = [
        ((120.0, 60.0, -60.0), (70.0, 8.0, 60.0), 20.0),
        ((60.0, 130.0, -40.0), (10.0, 70.0, 14.0), 30.0),
        ((175.0, 110.0, -75.0), (8.0, 90.0, 12.0), -25.0),
        ((125.0, 130.0, -125.0), (40.0, 12.0, 6.0), 10.0),
        ((110.0, 180.0, -70.0), (50.0, 6.0, 8.0), 50.0),
        ((150.0, 170.0, -20.0), (12.0, 12.0, 12.0), 15.0),
    ]
    beams = [
        ((90.0, 95.0, -60.0), (4.0, 4.0, 70.0), 0.0),
        ((150.0, 145.0, -60.0), (4.0, 4.0, 70.0), 0.0),
        ((120.0, 90.0, -95.0), (70.0, 4.0, 4.0), 0.0),
        ((84.0, 120.0, -92.0), (4.0, 90.0, 4.0), 0.0),
        ((152.0, 120.0, -94.0), (4.0, 90.0, 4.0), 0.0),
    ]
    return mesh_of(boxes + [(box_corners(*each), every) for each in (*around, *(beams if has_beams else ()))])


def scene_in(figure: Path, meshes: Meshes, mesh: Mesh, values: dict[str, object]) -> Scene:
    values = {"ground.declination": 80.0, "ground.position": [120.0, 229.0], **values}
    scene = evaluate(with_values(standing(figure, SIDE), values), 1)
    return with_pieces(scene, (replace(meshes.piece("room", mesh), casts=True),), has_ground=False)


@pytest.fixture
def faces(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """How many windows each light's map had that was drawn."""
    counts: list[int] = []
    plain = LightWindows.of

    def noted(light: Array, asked: LightCone | None, receivers: Array | None, casters: Array) -> LightWindows | None:
        found = plain(light, asked, receivers, casters)
        counts.append(0 if found is None else len(found.faces))
        return found

    monkeypatch.setattr(LightWindows, "of", staticmethod(noted))
    return counts


@pytest.fixture(scope="module")
def small_figure(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_figure(tmp_path_factory.mktemp("room") / "figure.png", figure_alpha(SIDE))


@pytest.mark.parametrize(("fov", "lamp"), [(0.0, [117.0, 116.0, -58.0]), (50.0, [135.0, 100.0, -80.0])])
def test_the_shadow_of_a_room_around_its_lamp_agrees_with_rays(
    mesh_renderer: Renderer, meshes: Meshes, small_figure: Path, faces: list[int], fov: float, lamp: list[float]
) -> None:
    """On its floor, its walls and its ceiling, before the lamp and behind it."""
    values = {"camera.fov": fov, "light.position": lamp}
    scene = scene_in(small_figure, meshes, room(has_beams=False), values)
    world = mesh_raycast.MeshWorld(scene.camera, corners_of(scene, meshes), None)
    cast = scene.layers[0].cast
    assert cast is not None
    own = np.asarray(mesh_renderer.set_coverage(scene) / 65535)
    wanted = set_raycast.coverage(lambda x, y: mesh_raycast.own_shade(world, cast.lights, x, y), own, rays=36)
    assert Agreement.of(own, wanted).iou >= MIN_IOU
    assert (np.abs(own - wanted) > 0.5).sum() < 5
    assert faces == [6]


def test_a_figure_near_a_lamp_in_a_room_agrees_with_rays(
    mesh_renderer: Renderer, meshes: Meshes, small_figure: Path, faces: list[int]
) -> None:
    """A lamp so near to a figure that no one window holds it."""
    values = {"camera.fov": 50.0, "light.position": [125.0, 130.0, 20.0]}
    scene = scene_in(small_figure, meshes, room(has_beams=False), values)
    cast = scene.layers[0].cast
    assert cast is not None
    world = mesh_raycast.MeshWorld(scene.camera, corners_of(scene, meshes), None)
    art = raycast.Art(figure_alpha(SIDE) / 255)
    got = np.asarray(mesh_renderer.coverage(scene, scene.layers[0]) / 65535)
    assert got.sum() > 1000
    assert faces == [6]
    wanted = set_raycast.coverage(lambda x, y: mesh_raycast.shade(cast, world, art, x, y), got, rays=16)
    assert Agreement.of(got, wanted).iou >= MIN_IOU


@pytest.mark.parametrize("turn_deg", [31.0, 45.0])
def test_no_seam_is_seen_where_faces_of_the_cube_meet(
    mesh_renderer: Renderer, meshes: Meshes, small_figure: Path, monkeypatch: pytest.MonkeyPatch, turn_deg: float
) -> None:
    """However the cube is turned, so that its seams run elsewhere, the picture is the same."""
    values = {"camera.fov": 50.0, "light.position": [119.0, 117.0, -61.0]}
    scene = scene_in(small_figure, meshes, room(has_beams=True), values)
    plain = np.asarray(mesh_renderer.set_coverage(scene) / 65535)
    toward = LightAxes.toward
    c, s = np.cos(np.radians(turn_deg)), np.sin(np.radians(turn_deg))
    turn = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]]) @ [[1.0, 0.0, 0.0], [0.0, c, s], [0.0, -s, c]]

    def turned(light: Array, points: Array) -> LightAxes:
        return LightAxes(light, turn @ toward(light, points).rows)

    monkeypatch.setattr(LightAxes, "toward", staticmethod(turned))
    before = mesh_renderer.meshes_seen[1]
    # Another mesh of the same shape, so that nothing of the first is kept.
    other = np.asarray(mesh_renderer.set_coverage(scene_in(small_figure, meshes, room(has_beams=True), values)) / 65535)
    assert mesh_renderer.meshes_seen[1] == before + 1
    assert plain.sum() > 5000
    assert Agreement.of(other, plain).iou >= 0.998
    assert (np.abs(other - plain) > 0.3).sum() < 10


@pytest.mark.parametrize("lamp", [[560.0, 790.0, -40.0], [500.0, 780.0, 40.0]])
def test_meshes_around_a_lamp_look_like_the_pieces_they_are_made_of(
    mesh_renderer: Renderer, meshes: Meshes, figure: Path, faces: list[int], lamp: list[float]
) -> None:
    """What a body takes is told by planes through the light: it never had an edge beyond which all is lit."""
    values = {"light.position": lamp, "camera.fov": 30.0, **{f"set.{piece}.casts": True for piece in ROOM}}
    pieces = evaluate(in_a_set(figure, ROOM, values), 1)
    same = as_meshes(pieces, meshes)
    chosen = zip(pieces.pieces, same.pieces, strict=True)
    mixed = with_pieces(pieces, tuple(mesh if plain.name == "box" else plain for plain, mesh in chosen))
    plain_own, *own = (np.asarray(mesh_renderer.set_coverage(each) / 65535) for each in (pieces, same, mixed))
    assert plain_own.sum() > 3000
    assert [Agreement.of(each, plain_own).iou >= 0.998 for each in own] == [True, True]
    assert 6 in faces
