"""Sets from files in a document: seen as their cameras see them, and stood upon."""

from dataclasses import replace
from fractions import Fraction
from math import radians
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.document import set_properties as lines
from kagezou.document.address import Address, track_of, value_of
from kagezou.document.edits import add_layer, set_constant, set_key
from kagezou.document.invariants import check
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.document.properties import FOV, GROUND_DECLINATION, GROUND_POSITION, LIGHT_KIND, LIGHT_POSITION
from kagezou.document.set_pieces import add_piece
from kagezou.errors import UsageProblem
from kagezou.geometry.box import Box
from kagezou.geometry.set_camera import SetCamera
from kagezou.geometry.sets.measures import PieceKind
from kagezou.geometry.vectors import Matrix
from kagezou.importing.imported_sets import ImportedSet, SetImport, import_set, point_under, stand_at
from kagezou.importing.set_following import follow_camera
from kagezou.io.sets.mesh_cache import MeshCache
from kagezou.scene.evaluate import camera_at, evaluate, ground_at, light_at
from tests.io.sets.mesh_files import glb, triangle_tree

SIZE = (800, 600)


def stage(length: int = 12) -> Document:
    cels = Cels((Drawing("1", Path("1.png")),), (Exposure(1, 0),))
    document = add_layer(Document(Canvas(*SIZE, Fraction(24), length)), "A", cels, Box(300, 200, 500, 520))
    return set_constant(document, Address(GROUND_POSITION), (400.0, 520.0))


def looking(x: float, y: float, z: float, pitch: float, yaw: float, roll: float = 0.0) -> Matrix:
    """A pose at a place, looking down by a pitch, turned by a yaw and rolled, degrees."""
    a, b, c = (radians(each) for each in (-pitch, yaw, roll))
    tip = np.array([[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]])
    turn = np.array([[np.cos(b), 0, np.sin(b)], [0, 1, 0], [-np.sin(b), 0, np.cos(b)]])
    spin = np.array([[np.cos(c), -np.sin(c), 0], [np.sin(c), np.cos(c), 0], [0, 0, 1]])
    made = np.eye(4)
    made[:3, :3] = turn @ tip @ spin
    made[:3, 3] = (x, y, z)
    return made


def seen(document: Document, frame: int, point: tuple[float, float, float]) -> tuple[float, float]:
    (piece,) = evaluate(document, frame).pieces
    assert piece.mesh is not None
    x, y, w = camera_at(document, frame).canvas_from_world() @ np.array(piece.mesh.world_from_mesh) @ [*point, 1.0]
    return (float(x / w), float(y / w))


def with_mesh(document: Document, anchor: tuple[float, float, float] = (0.0, 0.0, 0.0), up: str = "y") -> Document:
    return add_piece(document, "set", PieceKind.MESH, {"anchor": anchor, "up": up}, Path("/sets/a.glb"))


@given(
    place=st.tuples(st.floats(-3, 3), st.floats(0.5, 6), st.floats(4, 12)),
    pitch=st.floats(2, 60),
    yaw=st.floats(-20, 20),
    roll=st.floats(-15, 15),
    fov=st.floats(15, 90),
    point=st.tuples(st.floats(-2, 2), st.floats(0, 2), st.floats(-4, 1)),
)
def test_the_canvas_camera_sees_what_the_files_camera_sees(
    place: tuple[float, float, float],
    pitch: float,
    yaw: float,
    roll: float,
    fov: float,
    point: tuple[float, float, float],
) -> None:
    camera = SetCamera("c", is_perspective=True, height=fov, aspect=0.0, poses=looking(*place, pitch, yaw, roll)[None])
    anchor = (0.3, 0.1, -0.5)
    document = with_mesh(stage(), anchor)
    document = follow_camera(document, document.pieces[0].id, camera)
    check(document)
    assert seen(document, 1, point) == pytest.approx(camera.sees(point, 1, SIZE), abs=1e-6)
    ground = evaluate(document, 1).ground
    assert ground.origin[:2] == pytest.approx(camera.sees(anchor, 1, SIZE), abs=1e-9)


@pytest.mark.parametrize("up", ["y", "z"])
def test_a_flat_camera_and_either_axis(up: str) -> None:
    pose = looking(1, 4, 9, 30, 10)
    if up == "z":
        # The same view in a file whose third axis points up.
        axes = np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1.0]])
        pose = axes @ pose
    camera = SetCamera("c", is_perspective=False, height=5.0, aspect=0.0, poses=pose[None])
    document = with_mesh(stage(), (0.0, 0.0, 0.0), up)
    document = follow_camera(document, document.pieces[0].id, camera)
    assert value_of(document, Address(FOV), 1) == 0.0
    for point in ((0.5, 1.0, -2.0), (-1.0, 0.2, 0.4)):
        assert seen(document, 1, point) == pytest.approx(camera.sees(point, 1, SIZE), abs=1e-6)
    declination = value_of(document, Address(GROUND_DECLINATION), 1)
    assert declination == pytest.approx(60.0)


def test_a_moving_camera_is_exact_on_every_frame() -> None:
    poses = np.stack([looking(0.2 * frame, 2.0, 8.0, 12 + frame, 3 * frame) for frame in range(10)])
    camera = SetCamera("c", is_perspective=True, height=40.0, aspect=0.0, poses=poses)
    document = with_mesh(stage(), (0.0, 0.0, -1.0))
    document = follow_camera(document, document.pieces[0].id, camera)
    check(document)
    assert len(track_of(document, Address(GROUND_POSITION)).keys) == 10
    for frame in (1, 2, 7, 10, 12):
        for point in ((0.5, 1.0, -2.0), (-1.0, 0.2, 0.4)):
            assert seen(document, frame, point) == pytest.approx(camera.sees(point, frame, SIZE), abs=1e-6)


@pytest.mark.parametrize("kind", ["point", "sun"])
def test_the_light_stays_where_it_is_in_the_set(kind: str) -> None:
    poses = np.stack([looking(0.3 * frame, 2.0, 8.0, 12 + 2 * frame, 9 * frame, frame) for frame in range(10)])
    camera = SetCamera("c", is_perspective=True, height=40.0, aspect=0.0, poses=poses)
    document = set_constant(with_mesh(stage(), (0.0, 0.0, -1.0)), Address(LIGHT_KIND), kind)
    keyed = set_key(document, Address(LIGHT_POSITION), 1, (0.0, 0.0, 500.0))
    kept = follow_camera(keyed, document.pieces[0].id, camera)
    assert len(track_of(kept, Address(LIGHT_POSITION)).keys) == 1
    document = follow_camera(document, document.pieces[0].id, camera)
    check(document)
    lights = []
    for frame in (1, 4, 10):
        (piece,) = evaluate(document, frame).pieces
        assert piece.mesh is not None
        light = np.linalg.inv(piece.mesh.world_from_mesh) @ light_at(document, frame, ground_at(document, frame))
        lights.append(light / (light[3] or np.linalg.norm(light)))
    assert lights[1] == pytest.approx(lights[0], abs=1e-6)
    assert lights[2] == pytest.approx(lights[0], abs=1e-6)


def test_a_camera_that_zooms_is_exact_on_every_frame() -> None:
    heights = (20.0, 30.0, 45.0, 50.0)
    pose = looking(1.0, 2.0, 8.0, 12, 5)[None]
    camera = SetCamera("c", is_perspective=True, height=20.0, aspect=0.0, poses=pose, heights=heights)
    document = with_mesh(stage(), (0.0, 0.0, -1.0))
    document = follow_camera(document, document.pieces[0].id, camera)
    check(document)
    assert [key.value for key in track_of(document, Address(FOV)).keys] == list(heights)
    for frame in (1, 2, 4, 9):
        assert seen(document, frame, (0.5, 1.0, -2.0)) == pytest.approx(camera.sees((0.5, 1.0, -2.0), frame, SIZE))


def test_a_turn_beyond_half_a_circle_does_not_jump_back() -> None:
    poses = np.stack([looking(0, 3, 0, 30, 40.0 * frame) for frame in range(12)])
    camera = SetCamera("c", is_perspective=True, height=60.0, aspect=0.0, poses=poses)
    document = with_mesh(stage(), (0.0, 0.0, 0.0))
    with pytest.raises(UsageProblem, match="sees the ground"):
        follow_camera(document, document.pieces[0].id, replace_pitch(camera))
    flat = replace(camera, is_perspective=False, height=5.0)
    document = follow_camera(document, document.pieces[0].id, flat)
    angles = [key.value for key in document.pieces[0].tracks["angle"].keys]
    steps = np.diff(np.array(angles, np.float64))
    assert steps == pytest.approx(steps[0])
    assert abs(steps).sum() == pytest.approx(440.0)


def replace_pitch(camera: SetCamera) -> SetCamera:
    return replace(camera, poses=looking(0, 3, 0, -10, 0)[None])


def test_what_stands_behind_the_camera_cannot_be_stood_on() -> None:
    camera = SetCamera("c", is_perspective=True, height=40.0, aspect=0.0, poses=looking(0, 2, -5, 10, 0)[None])
    document = with_mesh(stage())
    with pytest.raises(UsageProblem, match="behind the camera"):
        follow_camera(document, document.pieces[0].id, camera)


@pytest.fixture
def dungeon(samples: Path) -> SetImport:
    return SetImport(samples / "bg3d_dungeon_stairs" / "scene.glb", "dungeon", "shot_cam", (400.0, 500.0))


def test_the_real_set_is_seen_as_it_was_drawn(dungeon: SetImport, samples: Path) -> None:
    """The depth that was drawn with the set is that of the mesh as the canvas camera sees it."""
    from kagezou.io.images.reading import read_cel

    meshes = MeshCache()
    document = replace(stage(), canvas=Canvas(1920, 1080))
    document = set_constant(document, Address(GROUND_POSITION), (960.0, 900.0))
    imported = import_set(document, replace(dungeon, stand=None), meshes)
    assert tuple(map(str, imported.notes)) == ("A: standing upright now, as the set does",)
    check(imported.document)
    assert value_of(imported.document, Address(lines.GROUND_RECEIVES), 1) is False
    told = read_cel(samples / "bg3d_dungeon_stairs" / "plate_depth_mm.png", white_is_clear=False).rgba[..., 0]
    mesh = meshes.mesh(dungeon.path)
    (piece,) = evaluate(imported.document, 1).pieces
    assert piece.mesh is not None
    scale = np.linalg.norm(np.array(piece.mesh.world_from_mesh)[:3, 0])
    eye = camera_at(imported.document, 1).eye[2]
    misses = []
    for x in range(100, 1900, 240):
        for y in range(420, 1060, 160):
            # That picture's depth is the first of four samples of a pixel.
            point = point_under(imported.document, imported.piece_id, mesh, (x + 0.25, y + 0.25), 1)
            if point is None or told[y, x] == 0:
                continue
            world = np.array(piece.mesh.world_from_mesh) @ [*point, 1.0]
            misses.append(abs((eye - world[2]) / scale * 1000 - told[y, x]))
    assert len(misses) > 20
    assert np.median(misses) < 1.0, "millimetres"
    assert np.quantile(misses, 0.9) < 2.0


def test_standing_on_a_step_changes_nothing_that_is_seen(dungeon: SetImport) -> None:
    meshes = MeshCache()
    imported = import_set(stage(), dungeon, meshes)
    assert "the height was kept" in str(imported.notes[0])
    document, piece_id = imported.document, imported.piece_id
    step = point_under(document, piece_id, meshes.mesh(dungeon.path), (620.0, 330.0), 1)
    assert step is not None
    assert step[1] > 0.3, "above the floor"
    stood = stand_at(document, piece_id, step)
    check(stood)
    for point in (step, (0.0, 0.0, 0.0), (2.0, 1.0, -3.0)):
        assert seen(stood, 1, point) == pytest.approx(seen(document, 1, point), abs=1e-6)
    assert evaluate(stood, 1).ground.origin[:2] == pytest.approx((620.0, 330.0), abs=1e-6)
    again = stand_at(stood, piece_id, step)
    assert evaluate(again, 1).ground.origin == pytest.approx(evaluate(stood, 1).ground.origin)


def test_standing_elsewhere_under_a_moving_camera_keeps_every_frame() -> None:
    poses = np.stack([looking(0.2 * frame, 2.0, 8.0, 12, 0) for frame in range(6)])
    camera = SetCamera("c", is_perspective=True, height=40.0, aspect=0.0, poses=poses)
    document = with_mesh(stage())
    piece_id = document.pieces[0].id
    document = follow_camera(document, piece_id, camera)
    stood = stand_at(document, piece_id, (0.5, 0.4, -2.0))
    for frame in (1, 3, 6):
        assert seen(stood, frame, (1.0, 1.0, -1.0)) == pytest.approx(camera.sees((1.0, 1.0, -1.0), frame, SIZE))
    with pytest.raises(UsageProblem, match="not before the camera"):
        stand_at(document, piece_id, (0.0, 0.0, 50.0))


def scale_of(imported: ImportedSet) -> object:
    return value_of(imported.document, Address(lines.PIECE_SCALE, piece_id=imported.piece_id), 1)


def test_a_set_without_a_camera_stands_in_a_natural_size(dungeon: SetImport, tmp_path: Path) -> None:
    meshes = MeshCache()
    imported = import_set(stage(), replace(dungeon, camera=None), meshes)
    assert scale_of(imported) == pytest.approx(200.0)
    (tmp_path / "huge.obj").write_text("v 0 0 0\nv 9000 0 0\nv 0 5000 0\nf 1 2 3\n")
    huge = import_set(stage(), SetImport(tmp_path / "huge.obj", "huge"), meshes)
    assert scale_of(huge) == pytest.approx(800 / 9000)
    with pytest.raises(UsageProblem, match="no camera 'x' in it, only none at all"):
        import_set(stage(), SetImport(tmp_path / "huge.obj", "huge", "x"), meshes)


def test_nothing_under_the_pointer_is_nothing(dungeon: SetImport) -> None:
    meshes = MeshCache()
    imported = import_set(stage(), dungeon, meshes)
    mesh = meshes.mesh(dungeon.path)
    assert point_under(imported.document, imported.piece_id, mesh, (400.0, -5000.0), 1) is None
    away = set_constant(imported.document, Address(lines.PIECE_PRESENT, piece_id=imported.piece_id), raw=False)
    assert point_under(away, imported.piece_id, mesh, (400.0, 500.0), 1) is None
    with pytest.raises(UsageProblem, match="not before the camera on every frame"):
        stand_at(away, imported.piece_id, (0.0, 0.0, 0.0))


LEVEL = [(fov, height) for fov in (0.0, 0.5, 40.0, 100.0) for height in (1.5, 0.0)]


@pytest.mark.parametrize(("fov", "height"), LEVEL)
@pytest.mark.parametrize("roll", [0.0, 90.0, -30.0])
@pytest.mark.parametrize("error_deg", [0.0, 1e-5, -1e-5])
def test_a_level_camera_sees_the_set_whether_or_not_it_sees_the_ground(
    fov: float, height: float, roll: float, error_deg: float
) -> None:
    pose = looking(0.4, height, 9.0, error_deg, 12.0, roll)
    camera = SetCamera("c", is_perspective=fov > 0, height=fov or 5.0, aspect=0.0, poses=pose[None])
    document = with_mesh(stage(), (0.0, 0.0, -1.0))
    document = follow_camera(document, document.pieces[0].id, camera)
    check(document)
    for point in ((0.5, 1.0, -2.0), (-1.0, 0.2, 0.4), (0.0, 0.0, -1.0)):
        assert seen(document, 1, point) == pytest.approx(camera.sees(point, 1, SIZE), abs=0.2 if error_deg else 1e-4)


@pytest.mark.parametrize("fov", [0.0, 40.0])
def test_a_camera_that_passes_the_level_is_followed_all_the_way(fov: float) -> None:
    heights = [2.0, 1.0, 0.0]
    poses = np.stack([looking(0.0, height, 9.0, 10 * height, 0.0) for height in heights])
    camera = SetCamera("c", is_perspective=fov > 0, height=fov or 5.0, aspect=0.0, poses=poses)
    document = with_mesh(stage(), (0.0, 0.0, -1.0))
    document = follow_camera(document, document.pieces[0].id, camera)
    for frame in (1, 2, 3):
        point = (0.5, 1.0, -2.0)
        assert seen(document, frame, point) == pytest.approx(camera.sees(point, frame, SIZE), abs=1e-4)


@pytest.mark.parametrize("pitch", [90.0, 89.5, -5.0])
def test_a_camera_that_cannot_be_followed_says_how_it_sees_the_ground(pitch: float) -> None:
    camera = SetCamera("c", is_perspective=True, height=40.0, aspect=0.0, poses=looking(0, 5, 0, pitch, 0)[None])
    document = with_mesh(stage(), (0.0, 0.0, -1.0))
    with pytest.raises(UsageProblem, match="sees the ground at"):
        follow_camera(document, document.pieces[0].id, camera)


@pytest.mark.parametrize("fov", [150.0, 1e-5])
def test_a_field_of_view_that_the_canvas_camera_cannot_have_is_refused(fov: float) -> None:
    camera = SetCamera("c", is_perspective=True, height=fov, aspect=0.0, poses=looking(0, 5, 9, 20, 0)[None])
    document = with_mesh(stage(), (0.0, 0.0, -1.0))
    with pytest.raises(UsageProblem, match=r"from 0 to 120|within"):
        follow_camera(document, document.pieces[0].id, camera)


@pytest.mark.parametrize(
    ("name", "up", "is_said"), [("a.obj", None, True), ("a.obj", "z", False), ("a.glb", None, False)]
)
def test_an_axis_that_the_file_does_not_tell_is_said(
    tmp_path: Path,
    name: str,
    up: str | None,
    is_said: bool,  # noqa: FBT001
) -> None:
    if name == "a.obj":
        (tmp_path / name).write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    else:
        glb(tmp_path / name, *triangle_tree())
    notes = [str(note) for note in import_set(stage(), SetImport(tmp_path / name, "set", up=up), MeshCache()).notes]
    assert any("it does not say which axis points up: y is taken" in note for note in notes) == is_said
