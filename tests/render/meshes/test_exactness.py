"""Meshes against float64 rays, and against the same set made of analytic pieces."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.document.set_pieces import add_piece
from kagezou.geometry.camera import project
from kagezou.geometry.mesh import Mesh
from kagezou.geometry.sets.bodies import Solid
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from kagezou.scene.scene import Scene
from tests.render.reference import mesh_raycast, raycast, set_raycast
from tests.render.reference.figures import figure_alpha, standing, with_values, write_figure
from tests.render.reference.mesh_scenes import (
    Array,
    Meshes,
    as_meshes,
    corners_of,
    heights_mesh,
    solid_mesh,
    waves,
    with_pieces,
)
from tests.render.sets.test_exactness import ROOM, in_a_set
from tests.render.test_exactness import Agreement

MIN_IOU = 0.99

SMALL = 240

Values = Mapping[str, object]

VIEWS: dict[str, Values] = {
    "lamp in front": {"light.position": [300, -150, 950]},
    "lamp beside, perspective": {"light.position": [-200, 100, 250], "camera.fov": 40.0},
    "lamp overhead": {"light.position": [420.0, -500.0, 60.0], "light.overhead_radius": 300.0},
    "low sun, rolled": {"light.kind": "sun", "light.azimuth": 40.0, "light.elevation": 30.0, "ground.roll": 5.0},
    "sun, perspective": {"light.kind": "sun", "light.azimuth": -35.0, "light.elevation": 50.0, "camera.fov": 25.0},
}


@pytest.fixture(scope="module")
def small_figure(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_figure(tmp_path_factory.mktemp("small") / "figure.png", figure_alpha(SMALL))


def cast_of(renderer: Renderer, scene: Scene) -> Array:
    return np.asarray(renderer.coverage(scene, scene.layers[0]) / 65535)


def own_of(renderer: Renderer, scene: Scene) -> Array:
    return np.asarray(renderer.set_coverage(scene) / 65535)


def iou(got: Array, wanted: Array) -> float:
    return Agreement.of(got, wanted).iou


# ---- the same set as analytic pieces


@pytest.mark.parametrize("name", VIEWS)
def test_meshes_look_like_the_pieces_they_are_made_of(
    mesh_renderer: Renderer, meshes: Meshes, figure: Path, name: str
) -> None:
    casting = {f"set.{piece}.casts": True for piece in ROOM}
    pieces = evaluate(in_a_set(figure, ROOM, {**VIEWS[name], **casting}), 1)
    same = as_meshes(pieces, meshes)
    plain = cast_of(mesh_renderer, pieces)
    assert plain.sum() > 3000
    assert iou(cast_of(mesh_renderer, same), plain) >= 0.995
    assert iou(own_of(mesh_renderer, same), own_of(mesh_renderer, pieces)) >= MIN_IOU


@pytest.mark.parametrize("kind", ["box", "wall"])
def test_meshes_and_pieces_hide_and_darken_each_other(
    mesh_renderer: Renderer, meshes: Meshes, figure: Path, kind: str
) -> None:
    """One of each: whatever is a mesh and whatever is not, the picture is the same."""
    casting = {f"set.{piece}.casts": True for piece in ROOM}
    pieces = evaluate(in_a_set(figure, ROOM, {"light.position": [350, -250, 900], "camera.fov": 30.0} | casting), 1)
    as_mesh = as_meshes(pieces, meshes)
    chosen = zip(pieces.pieces, as_mesh.pieces, strict=True)
    mixed = with_pieces(pieces, tuple(mesh if plain.name == kind else plain for plain, mesh in chosen))
    assert iou(cast_of(mesh_renderer, mixed), cast_of(mesh_renderer, pieces)) >= 0.998
    assert iou(own_of(mesh_renderer, mixed), own_of(mesh_renderer, pieces)) >= MIN_IOU


def test_a_mesh_hides_a_ball_and_is_hidden_by_a_drum(mesh_renderer: Renderer, meshes: Meshes, figure: Path) -> None:
    document = in_a_set(figure, {"wall": {**ROOM["wall"], "width": 200, "height": 120}}, {"set.wall.casts": True})
    document = add_piece(document, "ball", "sphere", {"position": [560, 745], "width": 160})
    document = add_piece(document, "drum", "cylinder", {"position": [450, 800], "width": 60, "height": 90})
    pieces = evaluate(with_values(document, {"light.position": [300, -150, 950]}), 1)
    wall = as_meshes(with_pieces(pieces, pieces.pieces[:1]), meshes).pieces
    mixed = with_pieces(pieces, (*wall, *pieces.pieces[1:]))
    assert iou(cast_of(mesh_renderer, mixed), cast_of(mesh_renderer, pieces)) >= 0.998


# ---- rays


@pytest.mark.parametrize(("fov", "position"), [(0.0, [50, -60, 210]), (45.0, [150, -50, -160])])
def test_hills_through_the_ground_agree_with_rays(
    mesh_renderer: Renderer, meshes: Meshes, small_figure: Path, fov: float, position: list[float]
) -> None:
    values = {"camera.fov": fov, "light.position": position, "ground.declination": 50.0}
    scene = evaluate(with_values(standing(small_figure, SMALL), values), 1)
    hills = meshes.piece("hills", heights_mesh(scene.ground, waves(8, 12.0, 1.3), 105.0))
    scene = with_pieces(scene, (hills,))
    world = mesh_raycast.MeshWorld(scene.camera, corners_of(scene, meshes), scene.ground)
    cast = scene.layers[0].cast
    assert cast is not None
    art = raycast.Art(figure_alpha(SMALL) / 255)
    got = cast_of(mesh_renderer, scene)
    wanted = set_raycast.coverage(lambda x, y: mesh_raycast.shade(cast, world, art, x, y), got, rays=64)
    assert iou(got, wanted) >= MIN_IOU


@pytest.mark.parametrize("fov", [0.0, 45.0])
def test_the_shadow_of_a_mesh_agrees_with_rays(
    mesh_renderer: Renderer, meshes: Meshes, small_figure: Path, fov: float
) -> None:
    """Boxes on the ground and on each other, some of it below the ground."""
    box = {"kind": "box", "position": [130, 200], "width": 60, "height": 50, "depth": 40, "angle": 25}
    slope = {"kind": "ramp", "position": [170, 215], "width": 70, "height": 40, "depth": 60, "angle": -40}
    document = standing(small_figure, SMALL)
    for name, each in (("box", box), ("slope", slope)):
        values = {key: value for key, value in each.items() if key != "kind"}
        document = add_piece(document, name, str(each["kind"]), {**values, "casts": True})
    light = {"camera.fov": fov, "light.position": [10, 20, 120], "ground.declination": 50.0}
    scene = as_meshes(evaluate(with_values(document, light), 1), meshes)
    world = mesh_raycast.MeshWorld(scene.camera, corners_of(scene, meshes), scene.ground)
    cast = scene.layers[0].cast
    assert cast is not None
    own = own_of(mesh_renderer, scene)
    assert own.sum() > 1500
    wanted = set_raycast.coverage(lambda x, y: mesh_raycast.own_shade(world, cast.lights, x, y), own, rays=64)
    assert iou(own, wanted) >= MIN_IOU


@pytest.mark.parametrize("values", [
    {"layers.A.grounding": [[105.0, 215.0], [120.0, 212.0], [135.0, 216.0]]},
    {"layers.A.shadow.matte": "translucent"},
])  # fmt: skip
def test_folds_and_smoke_agree_with_rays(
    mesh_renderer: Renderer, meshes: Meshes, small_figure: Path, values: Values
) -> None:
    scene = evaluate(with_values(standing(small_figure, SMALL), {"light.position": [50, -60, 210]} | dict(values)), 1)
    slope = np.add.outer(np.linspace(50.0, 0.0, 3), np.zeros(3))
    scene = with_pieces(scene, (meshes.piece("slope", heights_mesh(scene.ground, slope, 110.0)),))
    world = mesh_raycast.MeshWorld(scene.camera, corners_of(scene, meshes), scene.ground)
    cast = scene.layers[0].cast
    assert cast is not None
    art = raycast.Art(figure_alpha(SMALL) / 255)
    got = cast_of(mesh_renderer, scene)
    assert got.sum() > 300
    wanted = set_raycast.coverage(lambda x, y: mesh_raycast.shade(cast, world, art, x, y), got, rays=64)
    assert iou(got, wanted) >= MIN_IOU


# ---- the feet, and what is behind the camera


@pytest.mark.parametrize("fov", [0.0, 60.0])
def test_a_floor_takes_the_shadow_as_the_flat_ground_does(
    mesh_renderer: Renderer, meshes: Meshes, figure: Path, fov: float
) -> None:
    """The floor goes on behind the camera; a point of contact stays where it is."""
    values = {"camera.fov": fov, "layers.A.grounding": [[440.0, 890.0]], "light.position": [200, -300, 700]}
    flat = evaluate(with_values(standing(figure), values), 1)
    floor = with_pieces(
        flat, (meshes.piece("floor", heights_mesh(flat.ground, np.zeros((2, 2)), 6000.0)),), has_ground=False
    )
    plain, got = cast_of(mesh_renderer, flat), cast_of(mesh_renderer, floor)
    assert iou(got, plain) >= 0.999
    feet = np.abs(got - plain)[880:900, 420:460]
    assert feet.max() < 0.02


def test_the_ground_that_does_not_receive_is_not_there(mesh_renderer: Renderer, meshes: Meshes, figure: Path) -> None:
    scene = evaluate(in_a_set(figure, {"box": ROOM["box"]}, {"light.position": [100, -200, 800]}), 1)
    alone = with_pieces(as_meshes(scene, meshes), as_meshes(scene, meshes).pieces, has_ground=False)
    seen = cast_of(mesh_renderer, alone) > 0
    # Only the box is left, which stands within this.
    assert seen.any()
    rows, columns = np.nonzero(seen)
    assert columns.min() > 530
    assert rows.max() < 900


# ---- no acne and no gaps


@pytest.mark.parametrize("name", VIEWS)
def test_a_lit_mesh_does_not_darken_itself(mesh_renderer: Renderer, meshes: Meshes, figure: Path, name: str) -> None:
    """Hills so gentle that no light of the sweep leaves a shadow on them, of 20 000 triangles."""
    scene = evaluate(with_values(standing(figure), VIEWS[name]), 1)
    hills = meshes.piece("hills", heights_mesh(scene.ground, waves(101, 4.0, 3.0), 500.0))
    own = own_of(mesh_renderer, with_pieces(scene, (replace(hills, casts=True),), has_ground=False))
    assert (own > 0.01).sum() == 0


def test_no_gap_where_a_box_stands(mesh_renderer: Renderer, meshes: Meshes, figure: Path) -> None:
    """Along the foot of a box, on the dark side, no line of light is left, on the flat ground or on a floor."""
    box = {"kind": "box", "position": [500, 800.3], "width": 200, "height": 150, "depth": 100, "casts": True}
    values = {"light.kind": "sun", "light.azimuth": 150.0, "light.elevation": 45.0, "camera.fov": 0.0}
    scene = evaluate(in_a_set(figure, {"box": box}, values), 1)
    same = as_meshes(scene, meshes)
    floor = meshes.piece("floor", heights_mesh(scene.ground, np.zeros((5, 5)), 700.0))
    on_floor = with_pieces(same, (*same.pieces, replace(floor, casts=True)), has_ground=False)
    plain = own_of(mesh_renderer, scene)
    # The front of the box and the ground before it: their seam lies within.
    dark = wholly_dark(plain)
    for each in (same, on_floor):
        assert own_of(mesh_renderer, each)[dark].min() > 0.97
        assert iou(own_of(mesh_renderer, each), plain) >= MIN_IOU


def wholly_dark(own: Array) -> NDArray[np.bool_]:
    """Pixels all of whose neighbours, two px far, are wholly dark."""
    rim = np.pad(own > 0.999, 2)
    around = [rim[j : j + own.shape[0], i : i + own.shape[1]] for j in range(5) for i in range(5)]
    dark = np.logical_and.reduce(around)
    assert dark.sum() > 1000
    return np.asarray(dark)


# ---- what is drawn again


def test_only_what_changed_is_drawn_again(mesh_renderer: Renderer, meshes: Meshes, figure: Path) -> None:
    def drawn(values: Values) -> tuple[int, int]:
        scene = as_one(evaluate(with_values(standing(figure), {"light.position": [300, -150, 950]} | dict(values)), 1))
        before = mesh_renderer.meshes_seen
        mesh_renderer.draw_picture(scene)
        after = mesh_renderer.meshes_seen
        return after[0] - before[0], after[1] - before[1]

    hills = meshes.piece("hills", heights_mesh(evaluate(standing(figure), 1).ground, waves(20, 20.0, 2.0), 400.0))

    def as_one(scene: Scene) -> Scene:
        return with_pieces(scene, (hills,))

    assert drawn({}) == (1, 1)
    assert drawn({}) == (0, 0)
    assert drawn({"layers.A.shadow.opacity": 0.3}) == (0, 0)
    assert drawn({"layers.A.tilt": 10.0}) == (0, 0)
    assert drawn({"light.position": [310, -150, 950]}) == (0, 1)
    assert drawn({"camera.fov": 20.0}) == (1, 1)
    before = mesh_renderer.casts_drawn
    meshes.by_name["hills"] = heights_mesh(evaluate(standing(figure), 1).ground, waves(20, 5.0, 2.0), 400.0)
    assert drawn({"camera.fov": 20.0}) == (1, 1)
    assert mesh_renderer.casts_drawn == before + 1


def test_a_light_is_looked_at_for_one_character_or_for_all(
    mesh_renderer: Renderer, meshes: Meshes, figure: Path
) -> None:
    """A map is fitted to who asks first; who asks then gets one for everything, and sees the same shadow."""
    hills = meshes.piece("hills", heights_mesh(evaluate(standing(figure), 1).ground, waves(20, 40.0, 2.0), 400.0))

    def at(x: float, lamp: float) -> Scene:
        values = {"light.position": [lamp, -150, 950], "layers.A.position": [x, 500.0]}
        return with_pieces(evaluate(with_values(standing(figure), values), 1), (hills,))

    def drawn(scene: Scene) -> tuple[Array, int]:
        before = mesh_renderer.meshes_seen[1]
        got = cast_of(mesh_renderer, scene)
        return got, mesh_renderer.meshes_seen[1] - before

    alone, _ = drawn(at(700.0, 300.0))
    assert drawn(at(300.0, 320.0))[1] == 1
    # Far beside: the map is drawn once more, then it is there for both.
    assert drawn(at(700.0, 320.0))[1] == 1
    assert drawn(at(320.0, 320.0))[1] == 0
    # So it is at once for the next light, until one has but one character.
    assert drawn(at(300.0, 340.0))[1] + drawn(at(700.0, 340.0))[1] == 1
    drawn(at(300.0, 300.0))
    again, _ = drawn(at(700.0, 300.0))
    assert alone.sum() > 1000
    assert np.abs(again - alone).max() < 0.05


# ---- shown


def test_clay_and_wireframe_are_shown_where_they_are_asked_for(
    mesh_renderer: Renderer, meshes: Meshes, figure: Path
) -> None:
    scene = evaluate(in_a_set(figure, {"box": {**ROOM["box"], "position": [800, 850]}}, {}), 1)
    box = meshes.piece("box", box_mesh(scene), scene.pieces[0])

    def shown(display: str, *, wireframes: bool, is_under: bool = False) -> Array:
        piece = replace(box, display=display, is_under=is_under)
        mesh_renderer.draw_picture(with_pieces(scene, (piece,)), wireframes=wireframes)
        return mesh_renderer.read_picture().astype(float)

    nothing = shown("none", wireframes=True)
    assert (shown("wireframe", wireframes=False) == nothing).all()
    clay = shown("clay", wireframes=False)
    inside = clay[790:810, 790:810]
    assert (inside[..., 3] == 255).all()
    assert np.ptp(inside[..., :3], axis=-1).max() == 0
    assert (np.abs(shown("clay", wireframes=False, is_under=True) - clay).max()) == 0, (
        "there is no background to hide it"
    )
    mixed = with_pieces(scene, (replace(box, display="clay"), replace(box, id="b", display="clay", is_under=True)))
    over, under = (mesh_renderer.clay(mixed, is_under=each)[..., 3] for each in (False, True))
    assert not ((over == 255) & (under == 255)).any(), "each is drawn once"
    assert over.any() or under.any()
    lines = np.abs(shown("wireframe", wireframes=True) - nothing).max(axis=-1)
    drawn = (lines > 100).sum()
    assert drawn > 500
    x, y = hidden_corner(scene)
    assert lines[y - 3 : y + 4, x - 3 : x + 4].max() == 0


def box_mesh(scene: Scene) -> Mesh:
    """The box of a scene, with its edges as lines but not the diagonals of its faces."""
    (body,) = scene.pieces[0].bodies
    assert isinstance(body, Solid)
    mesh = solid_mesh(scene.pieces[0])
    starts = np.cumsum([0, *(len(facet.corners) for facet in body.facets)])[:-1]
    lines = [(start + k, start + (k + 1) % 4) for start in starts for k in range(4)]
    return Mesh(mesh.vertices, mesh.triangles, np.array(lines, np.int32))


def hidden_corner(scene: Scene) -> tuple[int, int]:
    """Where on the canvas the corner of a box lies that none of its faces turned to the eye has."""
    (body,) = scene.pieces[0].bodies
    assert isinstance(body, Solid)
    seen = {corner for facet in body.facets if np.dot(facet.equation, scene.camera.eye) > 0 for corner in facet.corners}
    (corner,) = {corner for facet in body.facets for corner in facet.corners} - seen
    x, y = project(scene.camera.canvas_from_world(), (*corner, 1.0))
    return round(x), round(y)
