"""What a glTF file shows: instances, skins, morph targets, hidden nodes, scenes, and what of it is not done."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from kagezou.errors import InputProblem
from kagezou.io.sets.mesh_cache import SetContents, read_set
from tests.io.sets.mesh_files import TRIANGLE, glb, tree_with

Tree = dict[str, Any]
CORNERS = np.array([0, 1, 2], "<u2")
INSTANCING, HIDING = "EXT_mesh_gpu_instancing", "KHR_node_visibility"


def read(path: Path, numbers: list[np.ndarray[Any, Any]], part: Tree | None = None, **parts: Any) -> SetContents:
    """Read a file whose only mesh is made of the first two arrays, on one node if nothing else is said."""
    tree, data = tree_with([TRIANGLE, CORNERS, *numbers])
    primitive = {"attributes": {"POSITION": 0}, "indices": 1, **(part or {})}
    whole = {"scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}], "meshes": [{"primitives": [primitive]}], **parts}
    return read_set(glb(path / "a.glb", {**tree, **whole}, data))


def said(found: SetContents) -> list[str]:
    return [str(note) for note in found.notes]


def test_instances_are_moved_turned_and_sized(tmp_path: Path) -> None:
    moves = np.array([[0, 0, 0], [10, 0, 0], [0, 0, 20]], "<f4")
    turns = np.array([[0, 0, 0, 1], [0, 0, np.sqrt(0.5), np.sqrt(0.5)], [0, 0, 0, 1]], "<f4")
    sizes = np.array([[1, 1, 1], [1, 1, 1], [5, 1, 1]], "<f4")
    attributes = {"TRANSLATION": 2, "ROTATION": 3, "SCALE": 4}
    nodes = [{"mesh": 0, "translation": [0, 0, 1], "extensions": {INSTANCING: {"attributes": attributes}}}]
    found = read(tmp_path, [moves, turns, sizes], nodes=nodes, extensionsRequired=[INSTANCING])
    assert len(found.mesh.triangles) == 3
    corners = np.round(found.mesh.vertices, 5).tolist()
    assert [10, 2, 1] in corners, "a quarter turn brings x to y"
    assert [10, 0, 21] in corners, "five times as wide, and where the node puts it"
    assert not found.notes


def test_instances_with_places_alone_and_with_counts_that_differ(tmp_path: Path) -> None:
    moves = np.array([[0, 0, 0], [10, 0, 0], [0, 0, 20]], "<f4")
    alone = [{"mesh": 0, "extensions": {INSTANCING: {"attributes": {"SCALE": 2}}}}]
    nodes = [{"mesh": 0, "extensions": {INSTANCING: {"attributes": {"SCALE": 2, "TRANSLATION": 3}}}}]
    with pytest.raises(InputProblem, match="not a complete"):
        read(tmp_path, [moves, moves[:2]], nodes=nodes)
    assert len(read(tmp_path, [moves + 1], nodes=alone).mesh.triangles) == 3


def test_too_many_instances_are_counted_before_they_are_made(tmp_path: Path) -> None:
    nodes = [{"mesh": 0, "extensions": {INSTANCING: {"attributes": {"TRANSLATION": 2}}}}]
    tree, data = tree_with([TRIANGLE, CORNERS])
    tree["accessors"].append({"componentType": 5126, "count": 6_000_000, "type": "VEC3"})
    tree |= {"scenes": [{"nodes": [0]}], "nodes": nodes,
             "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}]}  # fmt: skip
    with pytest.raises(InputProblem, match="it has 6000000 triangles"):
        read_set(glb(tmp_path / "a.glb", tree, data))


def skinned(tmp_path: Path, weights: np.ndarray[Any, Any], joints: int = 2, **parts: Any) -> SetContents:
    back = np.tile(np.eye(4, dtype="<f4"), (2, 1, 1))
    back[1, 3, :3] = (0, 0, -1)
    tree, data = tree_with([TRIANGLE, CORNERS, np.array([[0, 1, 0, 0]] * 3, "|u1"), weights.astype("<f4"),
                            back.reshape(8, 4)])  # fmt: skip
    tree["accessors"][4].update(type="MAT4", count=2)
    attributes = {"POSITION": 0, "JOINTS_0": 2, "WEIGHTS_0": 3}
    whole = {
        "scenes": [{"nodes": [0, 1]}],
        "nodes": [{"mesh": 0, "skin": 0, "scale": [100, 100, 100]}, {"translation": [10, 0, 0], "children": [2]},
                  {"translation": [0, 5, 1]}],
        "meshes": [{"primitives": [{"attributes": attributes, "indices": 1}]}],
        "skins": [{"joints": [1, 2][:joints], "inverseBindMatrices": 4}],
    }  # fmt: skip
    return read_set(glb(tmp_path / "a.glb", {**tree, **whole, **parts}, data))


def test_a_skin_is_moved_by_its_joints_and_not_by_its_node(tmp_path: Path) -> None:
    found = skinned(tmp_path, np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0.5, 0.5, 0, 0]]))
    assert sorted(np.round(found.mesh.vertices, 5).tolist()) == [[10, 0, 0], [10, 3.5, 0], [12, 5, 0]]
    assert said(found) == ["its skins are posed as their joints stand without animation"]


def test_weights_that_are_not_one_together_and_corners_without_any(tmp_path: Path) -> None:
    found = skinned(tmp_path, np.array([[2, 0, 0, 0], [0, 0.2, 0, 0], [0, 0, 0, 0]]))
    assert sorted(np.round(found.mesh.vertices, 5).tolist()) == [[0, 100, 0], [10, 0, 0], [12, 5, 0]]


def test_joints_that_are_not_there(tmp_path: Path) -> None:
    with pytest.raises(InputProblem, match="not a complete"):
        skinned(tmp_path, np.array([[0, 1, 0, 0]] * 3), joints=1)
    with pytest.raises(InputProblem, match="not a complete"):
        skinned(tmp_path, np.array([[1, 0, 0, 0]] * 3), skins=[{"joints": [77], "inverseBindMatrices": 4}])
    with pytest.raises(InputProblem, match="there is no skins"):
        skinned(tmp_path, np.array([[1, 0, 0, 0]] * 3), skins=[])


@pytest.mark.parametrize(
    ("of_node", "of_mesh", "top", "is_said"),
    [(None, [0.5], 4.0, True), ([1], [0.5], 7.0, True), (None, None, 1.0, False), ([0], [1], 1.0, False)],
)  # fmt: skip
def test_morph_targets_with_the_weights_of_the_file(
    tmp_path: Path,
    of_node: list[float] | None,
    of_mesh: list[float] | None,
    top: float,
    is_said: bool,  # noqa: FBT001
) -> None:
    moved = np.array([[0, 0, 0], [0, 0, 0], [0, 6, 0]], "<f4")
    primitive = {"attributes": {"POSITION": 0}, "indices": 1, "targets": [{"POSITION": 2}]}
    mesh: Tree = {"primitives": [primitive], **({"weights": of_mesh} if of_mesh else {})}
    node: Tree = {"mesh": 0, **({"weights": of_node} if of_node else {})}
    found = read(tmp_path, [moved], meshes=[mesh], nodes=[node])
    assert found.mesh.corners[1][1] == pytest.approx(top)
    assert len(said(found)) == is_said


def test_hidden_nodes_and_what_hangs_on_them(tmp_path: Path) -> None:
    off = {HIDING: {"visible": False}}
    nodes = [{"mesh": 0, "children": [1]}, {"translation": [50, 0, 0], "extensions": off, "children": [2]}, {"mesh": 0},
             {"mesh": 0, "translation": [0, 0, 9], "extensions": {HIDING: {"visible": True}}}]  # fmt: skip
    found = read(tmp_path, [], nodes=nodes, scenes=[{"nodes": [0, 3]}], extensionsRequired=[HIDING])
    assert found.mesh.corners[1].tolist() == [2, 1, 9]
    assert said(found) == ["1 of its nodes are hidden, and what hangs on them"]
    with pytest.raises(InputProblem, match="there are no triangles in it: 1 of its nodes are hidden"):
        read(tmp_path, [], nodes=[{"mesh": 0, "extensions": off}])


def test_the_default_scene_is_read_and_others_are_said(tmp_path: Path) -> None:
    nodes = [{"mesh": 0}, {"mesh": 0, "translation": [50, 0, 0]}]
    scenes = [{"nodes": [0]}, {"nodes": [1], "name": "night"}]
    found = read(tmp_path, [], nodes=nodes, scenes=scenes, scene=1)
    assert found.mesh.corners[0][0] == 50
    assert said(found) == ["of its 2 scenes only 'night' is read"]
    every = read(tmp_path, [], nodes=nodes, scenes=[])
    assert len(every.mesh.triangles) == 2
    assert said(every) == ["it has no scene: all of its nodes are read"]
    with pytest.raises(InputProblem, match=r"there is no scenes\[5\]"):
        read(tmp_path, [], scene=5)


@pytest.mark.parametrize(
    ("mode", "notes"),
    [(0, ["its single points are not used"]), (1, ["its lines are not used"]), (3, ["its lines are not used"])],
)  # fmt: skip
def test_points_and_lines_are_said(tmp_path: Path, mode: int, notes: list[str]) -> None:
    parts = [{"attributes": {"POSITION": 0}}, {"attributes": {"POSITION": 0}, "mode": mode}]
    assert said(read(tmp_path, [], meshes=[{"primitives": parts}])) == notes


@pytest.mark.parametrize(("mode", "count"), [(5, 2), (6, 2), (4, 1)])
def test_strips_and_fans(tmp_path: Path, mode: int, count: int) -> None:
    quad = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], "<f4")
    found = read(tmp_path, [quad], {"attributes": {"POSITION": 2}, "mode": mode, "indices": 3}
                 if mode > 9 else {"attributes": {"POSITION": 2}, "mode": mode, "indices": 1})  # fmt: skip
    assert len(found.mesh.triangles) == 1
    tree, data = tree_with([quad])
    tree |= {"scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
             "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": mode}]}]}  # fmt: skip
    assert len(read_set(glb(tmp_path / "b.glb", tree, data)).mesh.triangles) == count


def test_a_mirrored_node_keeps_its_front_in_front(tmp_path: Path) -> None:
    found = read(tmp_path, [], nodes=[{"mesh": 0, "scale": [-1, 1, 1]}])
    a, b, c = found.mesh.vertices[found.mesh.triangles[0]]
    assert np.cross(b - a, c - a)[2] > 0
    assert found.mesh.corners[0][0] == -2
    matrix = [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 0, 0, 1]
    a, b, c = (found := read(tmp_path, [], nodes=[{"mesh": 0, "matrix": matrix}])).mesh.vertices[
        found.mesh.triangles[0]
    ]
    assert np.cross(b - a, c - a)[2] > 0
    assert found.mesh.corners[1][0] == 3


@pytest.mark.parametrize("name", ["EXT_primitive_voxels", "KHR_gaussian_splatting", "CESIUM_RTC", "X_my_shape"])
def test_extensions_that_are_not_done_are_refused_where_required_and_else_said(tmp_path: Path, name: str) -> None:
    with pytest.raises(InputProblem, match=f"it requires the extensions {name}, which are not read"):
        read(tmp_path, [], extensionsRequired=[name], extensionsUsed=[name])
    assert said(read(tmp_path, [], extensionsUsed=[name])) == [f"the extensions {name} are not used"]


@pytest.mark.parametrize(
    "name",
    ["KHR_texture_transform", "KHR_materials_unlit", "KHR_texture_basisu", "EXT_texture_webp", "KHR_lights_punctual",
     "KHR_xmp_json_ld", "KHR_materials_variants", "EXT_mesh_features"],
)  # fmt: skip
def test_extensions_that_do_not_matter_for_a_shape(tmp_path: Path, name: str) -> None:
    assert not read(tmp_path, [], extensionsRequired=[name], extensionsUsed=[name]).notes


def test_animated_meshes_and_cameras_and_meshes_that_hang_nowhere_are_said(tmp_path: Path) -> None:
    channel = {"sampler": 0, "target": {"path": "translation"}}
    times, values = np.array([0, 1], "<f4"), np.array([[0, 0, 0], [0, 0, 1]], "<f4")
    sampler = {"input": 2, "output": 3}
    nodes = [{"children": [1]}, {"mesh": 0}, {"camera": 0}]
    cameras = [{"type": "perspective", "perspective": {"yfov": 1, "znear": 1}}] * 2
    for target, expected in ((0, 1), (1, 1), (2, 0)):
        moved = {"samplers": [sampler], "channels": [{**channel, "target": {"path": "translation", "node": target}}]}
        found = read(tmp_path, [times, values], nodes=nodes, animations=[moved], scenes=[{"nodes": [0, 2]}])
        assert said(found) == ["its meshes are animated: they are used as they stand without that"][:expected]
    primitive = {"primitives": [{"attributes": {"POSITION": 0}}]}
    found = read(tmp_path, [], meshes=[primitive, primitive], nodes=nodes, cameras=cameras, scenes=[{"nodes": [0]}])
    assert said(found) == ["1 of its meshes hang on no node and are not used",
                           "its cameras 1 hang on no node and are not used"]  # fmt: skip
