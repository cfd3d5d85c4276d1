"""Sets from files: read as they are, kept once, and one sentence for whatever is wrong with them."""

import contextlib
import json
import os
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from kagezou.errors import InputProblem
from kagezou.io.files.file_stamp import FileStamp
from kagezou.io.sets import bounded_bytes, mesh_cache
from kagezou.io.sets.mesh_cache import MeshCache, SetContents, is_mesh, read_set
from tests.effort import tries
from tests.io.sets import set_files
from tests.io.sets.mesh_files import TRIANGLE, glb, gltf, tree_with, triangle_tree

CUBE = """\
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
"""


def sentence(path: Path) -> str:
    with pytest.raises(InputProblem) as found:
        read_set(path)
    text = str(found.value)
    assert text.startswith(str(path.parent)), text
    assert "\n" not in text
    return text


def test_a_glb_is_read_where_its_nodes_stand(tmp_path: Path) -> None:
    mesh = read_set(glb(tmp_path / "a.glb", *triangle_tree())).mesh
    assert sorted(map(tuple, mesh.vertices)) == sorted(map(tuple, TRIANGLE + np.array([0, 3, 0])))
    assert len(mesh.triangles) == 1
    assert len(mesh.lines) == 3, "the borders"


def test_gltf_beside_its_numbers_or_with_them_inside(tmp_path: Path) -> None:
    tree, data = triangle_tree()
    (tmp_path / "figures 1.bin").write_bytes(data)
    tree["buffers"] = [{"byteLength": len(data), "uri": "figures%201.bin"}]
    (tmp_path / "a.gltf").write_text(json.dumps(tree))
    inside = read_set(gltf(tmp_path / "b.gltf", *triangle_tree())).mesh
    beside = read_set(tmp_path / "a.gltf").mesh
    assert np.array_equal(beside.vertices, inside.vertices)


def test_an_obj_is_joined_at_its_corners_and_creased_at_its_edges(tmp_path: Path) -> None:
    (tmp_path / "cube.obj").write_text("mtllib ../../secret.mtl\nusemtl x\n" + CUBE)
    mesh = read_set(tmp_path / "cube.obj").mesh
    assert (len(mesh.vertices), len(mesh.triangles), len(mesh.lines)) == (8, 12, 12)


@pytest.mark.parametrize("suffix", ["ply", "stl"])
def test_other_formats(tmp_path: Path, suffix: str) -> None:
    data = set_files.CUBE_STL if suffix == "stl" else set_files.CUBE_PLY.encode()
    mesh = read_set(set_files.written(tmp_path / f"box.{suffix}", data)).mesh
    assert (len(mesh.vertices), len(mesh.triangles)) == (8, 12)
    assert mesh.corners[1] - mesh.corners[0] == pytest.approx([1, 1, 1])


def test_a_usd_stage_is_read_where_its_prims_stand(tmp_path: Path) -> None:
    pytest.importorskip("pxr", reason="the package usd-core is not installed")
    (tmp_path / "a.usda").write_text(
        '#usda 1.0\n(\n upAxis = "Z"\n)\n'
        'def Xform "root" {\n double3 xformOp:translate = (0, 0, 5)\n'
        ' uniform token[] xformOpOrder = ["xformOp:translate"]\n'
        ' def Mesh "quad" {\n  int[] faceVertexCounts = [4]\n  int[] faceVertexIndices = [0, 1, 2, 3]\n'
        "  point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]\n }\n"
        ' def Mesh "hidden" {\n  token visibility = "invisible"\n  int[] faceVertexCounts = [3]\n'
        "  int[] faceVertexIndices = [0, 1, 2]\n  point3f[] points = [(0, 0, 9), (1, 0, 9), (1, 1, 9)]\n }\n}\n"
    )
    mesh = read_set(tmp_path / "a.usda").mesh
    assert (len(mesh.vertices), len(mesh.triangles)) == (4, 2)
    assert mesh.vertices[:, 2] == pytest.approx(5.0)
    (tmp_path / "b.usda").write_text("#usda 1.0\ndef Mesh {")
    assert "damaged" in sentence(tmp_path / "b.usda")


def test_a_set_is_kept_until_its_file_changes(tmp_path: Path) -> None:
    path = glb(tmp_path / "a.glb", *triangle_tree())
    cache = MeshCache()
    first = cache.mesh(path)
    assert cache.mesh(path) is first
    glb(path, *triangle_tree(nodes=[{"mesh": 0, "translation": [0, 4, 0]}]))
    os.utime(path, ns=(1, 1))
    assert cache.mesh(path).corners[0][1] == 4.0
    small = MeshCache(limit_bytes=1)
    other = glb(tmp_path / "b.glb", *triangle_tree())
    kept = small.mesh(path)
    small.mesh(other)
    assert small.mesh(path) is not kept


def test_the_real_set_is_read(samples: Path) -> None:
    mesh = read_set(samples / "bg3d_dungeon_stairs" / "scene.glb").mesh
    assert len(mesh.triangles) == 13770
    assert mesh.corners[1] == pytest.approx([6.0, 3.06, 4.8], abs=1e-5)


def broken_trees() -> dict[str, tuple[dict[str, object], bytes]]:
    tree, data = triangle_tree()
    accessors = tree["accessors"]
    nan = TRIANGLE.copy()
    nan[1, 1] = np.nan
    far = TRIANGLE * np.float32(1e20)
    beyond, _ = tree_with([TRIANGLE, np.array([0, 1, 9], "<u2")])
    beyond |= {each: tree[each] for each in ("scenes", "nodes", "meshes")}
    return {
        "claims": ({**tree, "accessors": [{**accessors[0], "count": 10**8}, accessors[1]]}, data),
        "claims-indices": ({**tree, "accessors": [accessors[0], {**accessors[1], "count": 10**8}]}, data),
        "claims-nothing": ({**tree, "accessors": [{"componentType": 5126, "type": "VEC3", "count": 10**8}]}, data),
        "negative": ({**tree, "accessors": [{**accessors[0], "byteOffset": -64}, accessors[1]]}, data),
        "short": ({**tree, "buffers": [{"byteLength": 10**9}]}, data),
        "outside": ({**tree, "buffers": [{"byteLength": 4, "uri": "../x.bin"}]}, data),
        "outside-escaped": ({**tree, "buffers": [{"byteLength": 4, "uri": "..%2Fx.bin"}]}, data),
        "web": ({**tree, "buffers": [{"byteLength": 4, "uri": "http://example.com/x.bin"}]}, data),
        "absolute": ({**tree, "buffers": [{"byteLength": 4, "uri": "/etc/passwd"}]}, data),
        "missing": ({**tree, "buffers": [{"byteLength": 4, "uri": "gone.bin"}]}, data),
        "base64": ({**tree, "buffers": [{"byteLength": 4, "uri": "data:,;base64,#"}]}, data),
        "cycle": ({**tree, "nodes": [{"mesh": 0, "children": [1]}, {"children": [0]}]}, data),
        "two-parents": ({**tree, "nodes": [{"children": [2]}, {"children": [2]}, {"mesh": 0}]}, data),
        "no-node": ({**tree, "scenes": [{"nodes": [7]}]}, data),
        "no-mesh": ({**tree, "nodes": [{"mesh": 5}]}, data),
        "no-triangles": ({**tree, "nodes": [{}]}, data),
        "index": (beyond, _),
        "version": ({**tree, "asset": {"version": "1.0"}}, data),
        "required": ({**tree, "extensionsRequired": ["EXT_primitive_voxels"]}, data),
        "sparse": ({**tree, "accessors": [{**accessors[0], "sparse": {}}, accessors[1]]}, data),
        "nan": (tree, nan.tobytes() + data[36:]),
        "infinite": (tree, far.tobytes() + data[36:]),
        "list": ({**tree, "nodes": 5}, data),
        "texts": ({**tree, "accessors": [{**accessors[0], "count": "many"}, accessors[1]]}, data),
    }


@pytest.mark.parametrize("name", broken_trees())
def test_a_broken_set_is_one_sentence(tmp_path: Path, name: str) -> None:
    tree, data = broken_trees()[name]
    sentence(glb(tmp_path / "a.glb", tree, data))


def test_sets_that_multiply_are_counted_before_they_are_built(tmp_path: Path) -> None:
    side = 400
    x, y = np.meshgrid(np.arange(side, dtype="<f4"), np.arange(side, dtype="<f4"))
    points = np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3)
    indices = np.arange(3 * 100_000, dtype="<u4") % len(points)
    tree, data = tree_with([points, indices])
    tree |= {
        "scenes": [{"nodes": list(range(60))}],
        "nodes": [{"mesh": 0} for _ in range(60)],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    }
    assert "6000000 triangles" in sentence(glb(tmp_path / "a.glb", tree, data))


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("a.glb", b""),
        ("a.glb", b"glTF\2\0\0\0\xff\xff\xff\x7f"),
        ("a.gltf", b"{"),
        ("a.gltf", b"[" * 100_000),
        ("a.obj", b""),
        ("a.obj", b"v 0 0 0\nf 1 2 3\n"),
        ("a.obj", b"v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
        ("a.ply", b"ply\nformat binary_little_endian 1.0\nelement vertex 100000000\nproperty float x\nend_header\n"),
        ("a.stl", b"\0" * 80 + b"\xff\xff\xff\x7f"),
        ("a.png", b"no set"),
    ],
)
def test_garbage_is_one_sentence(tmp_path: Path, name: str, content: bytes) -> None:
    (tmp_path / name).write_bytes(content)
    sentence(tmp_path / name)


def test_what_is_no_file_is_one_sentence(tmp_path: Path) -> None:
    assert "does not exist" in sentence(tmp_path / "gone.glb")
    (tmp_path / "folder.glb").mkdir()
    assert "not a file" in sentence(tmp_path / "folder.glb")
    assert is_mesh(Path("X.GLB"))
    assert not is_mesh(Path("x.png"))


@settings(max_examples=tries(20, 60), suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(data=st.data())
def test_a_damaged_file_is_a_set_or_a_sentence(tmp_path: Path, data: st.DataObject) -> None:
    path = glb(tmp_path / "a.glb", *triangle_tree())
    whole = bytearray(path.read_bytes())
    for _ in range(data.draw(st.integers(1, 4))):
        whole[data.draw(st.integers(0, len(whole) - 1))] = data.draw(st.integers(0, 255))
    path.write_bytes(whole[: data.draw(st.integers(0, len(whole)))] if data.draw(st.booleans()) else whole)
    with contextlib.suppress(InputProblem):
        assert len(read_set(path).mesh.triangles)


def test_many_threads_get_one_reading(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = glb(tmp_path / "a.glb", *triangle_tree())
    cache, readings = MeshCache(), []
    asked = threading.Semaphore(0)

    def state_of(wanted: Path) -> FileStamp:
        asked.release()
        return bounded_bytes.state_of(wanted)

    def slow(wanted: Path) -> SetContents:
        readings.append(wanted)
        for _ in range(4 if len(readings) == 1 else 0):
            assert asked.acquire(timeout=60), "all four ask while one reads"
        return read_set(wanted)

    monkeypatch.setattr(mesh_cache, "state_of", state_of)
    monkeypatch.setattr(mesh_cache, "read_set", slow)
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(cache.mesh, [path] * 4))
    assert all(each is found[0] for each in found)
    assert readings == [path]
