"""The numbers of glTF files: parts of the largest number, replaced rows, buffers of every kind, harmless deviations."""

import base64
import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from kagezou.errors import InputProblem
from kagezou.io.sets.gltf import files_beside
from kagezou.io.sets.mesh_cache import SetContents, read_set
from tests.io.sets.mesh_files import TRIANGLE, glb, gltf, tree_with, triangle_tree

Tree = dict[str, Any]
CORNERS = np.array([0, 1, 2], "<u2")


def placed(tree: Tree, **parts: Any) -> Tree:
    """Return a tree whose first accessor is the places of a mesh on one node."""
    attributes = {"POSITION": 0}
    return {**tree, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": attributes, "indices": 1}]}], **parts}  # fmt: skip


def tops(found: SetContents) -> list[float]:
    return [float(each) for each in found.mesh.corners[1]]


@pytest.mark.parametrize(
    ("kind", "component", "largest"),
    [("<i2", 5122, 32767), ("<u2", 5123, 65535), ("|i1", 5120, 127), ("|u1", 5121, 255)],
)  # fmt: skip
@pytest.mark.parametrize("is_part", [True, False])
def test_quantized_places(tmp_path: Path, kind: str, component: int, largest: int, is_part: bool) -> None:  # noqa: FBT001
    whole = np.array([[0, 0, 0, 0], [largest, 0, 0, 0], [0, largest, 0, 0]]).astype(kind)
    tree, data = tree_with([TRIANGLE, CORNERS])
    start = len(data)
    data += whole.tobytes() + bytes(-whole.nbytes % 4)
    tree["bufferViews"].append({"buffer": 0, "byteOffset": start, "byteLength": whole.nbytes,
                                "byteStride": 4 * whole.itemsize})  # fmt: skip
    tree["accessors"][0] = {
        "bufferView": 2,
        "componentType": component,
        "count": 3,
        "type": "VEC3",
        "normalized": is_part,
    }
    tree["buffers"][0]["byteLength"] = len(data)
    names = ["KHR_mesh_quantization"]
    found = read_set(glb(tmp_path / "a.glb", placed(tree, nodes=[{"mesh": 0, "scale": [4, 4, 4]}],
                                                    extensionsRequired=names, extensionsUsed=names), data))  # fmt: skip
    assert tops(found) == pytest.approx([4, 4, 0] if is_part else [4 * largest, 4 * largest, 0])
    assert not found.notes


def sparse(base: bool, index_kind: str = "<u2", component: int = 5123) -> tuple[Tree, bytes]:  # noqa: FBT001
    """Return a triangle of which one corner is replaced, over numbers that are there or over zeros."""
    tree, data = tree_with([TRIANGLE, CORNERS])
    for part in (np.array([1, 2], index_kind), np.array([[7, 0, 0], [0, 5, 1]], "<f4")):
        tree["bufferViews"].append({"buffer": 0, "byteOffset": len(data), "byteLength": part.nbytes})
        data += part.tobytes() + bytes(-part.nbytes % 4)
    tree["buffers"][0]["byteLength"] = len(data)
    tree["accessors"][0]["sparse"] = {"count": 2, "indices": {"bufferView": 2, "componentType": component},
                                      "values": {"bufferView": 3}}  # fmt: skip
    if not base:
        del tree["accessors"][0]["bufferView"]
    return placed(tree), data


@pytest.mark.parametrize("base", [True, False])
@pytest.mark.parametrize(("kind", "component"), [("|u1", 5121), ("<u2", 5123), ("<u4", 5125)])
def test_sparse_numbers(tmp_path: Path, base: bool, kind: str, component: int) -> None:  # noqa: FBT001
    assert tops(read_set(glb(tmp_path / "a.glb", *sparse(base, kind, component)))) == pytest.approx([7, 5, 1])


def test_an_index_may_be_sparse_too(tmp_path: Path) -> None:
    tree, data = sparse(base=True)
    tree["accessors"][1]["sparse"] = {"count": 1, "indices": {"bufferView": 2, "componentType": 5123},
                                      "values": {"bufferView": 2, "byteOffset": 2}}  # fmt: skip
    # Corners 0, 2, 2: nothing is left of the triangle.
    with pytest.raises(InputProblem, match="without an area"):
        read_set(glb(tmp_path / "a.glb", tree, data))


@pytest.mark.parametrize(
    "change",
    [{"count": 4}, {"count": -1}, {"count": 1.5}, {"indices": {"bufferView": 2, "componentType": 5126}},
     {"indices": {"bufferView": 9, "componentType": 5123}}, {"values": {"bufferView": 2}}, {"values": {}},
     {"indices": {"bufferView": 3, "componentType": 5123}}],
)  # fmt: skip
def test_sparse_numbers_that_are_not_there(tmp_path: Path, change: Tree) -> None:
    tree, data = sparse(base=False)
    tree["accessors"][0]["sparse"].update(change)
    with pytest.raises(InputProblem):
        read_set(glb(tmp_path / "a.glb", tree, data))


def test_unused_damage_refuses_nothing(tmp_path: Path) -> None:
    tree, data = triangle_tree()
    tree["accessors"] += [{"count": "many"}, {"bufferView": 99, "componentType": 1, "count": 3, "type": "VEC3"}, {}]
    tree["bufferViews"] += [{"buffer": 1, "byteLength": 10}]
    tree["buffers"] += [{"byteLength": 10, "uri": "picture.bin"}, {"byteLength": 10, "uri": "../far.bin"}]
    assert tops(read_set(glb(tmp_path / "a.glb", tree, data))) == [2, 4, 0]


def test_buffers_and_files_may_be_longer_than_they_say(tmp_path: Path) -> None:
    tree, data = triangle_tree()
    assert tops(read_set(glb(tmp_path / "a.glb", tree, data + bytes(7)))) == [2, 4, 0]
    path = glb(tmp_path / "b.glb", tree, data)
    path.write_bytes(path.read_bytes() + b"tail!")
    found = read_set(path)
    assert [str(note) for note in found.notes] == ["5 bytes behind its end are not used"]


def test_chunks_of_other_kinds_are_passed_over(tmp_path: Path) -> None:
    tree, data = triangle_tree()
    text = json.dumps(tree).encode()
    text += b"\0" * (-len(text) % 4)
    chunks = [(0x4E4F534A, text), (0x58585858, b"odd"), (0x004E4942, data), (0x004E4942, b"second")]
    body = b"".join(struct.pack("<II", len(part), kind) + part for kind, part in chunks)
    (tmp_path / "a.glb").write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body + bytes(3))
    assert tops(read_set(tmp_path / "a.glb")) == [2, 4, 0]


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16", "utf-16-le"])
def test_text_with_a_mark_of_its_letters(tmp_path: Path, encoding: str) -> None:
    path = gltf(tmp_path / "a.gltf", *triangle_tree())
    path.write_bytes(path.read_text().encode(encoding))
    assert tops(read_set(path)) == [2, 4, 0]


@pytest.mark.parametrize(
    "head", ["data:application/octet-stream;charset=utf-8;base64,", "data:;base64,", "DATA:;BASE64,",
             "data:application/gltf-buffer;base64,"],
)  # fmt: skip
@pytest.mark.parametrize("tail", ["", "\n", "lines", "bare"])
def test_numbers_in_the_text_itself(tmp_path: Path, head: str, tail: str) -> None:
    tree, data = triangle_tree()
    text = base64.b64encode(data).decode()
    text = {"lines": "\r\n".join([text[:20], text[20:]]), "bare": text.rstrip("=")}.get(tail, text + tail)
    tree["buffers"] = [{"byteLength": len(data), "uri": head + text}]
    (tmp_path / "a.gltf").write_text(json.dumps(tree))
    assert tops(read_set(tmp_path / "a.gltf")) == [2, 4, 0]


def test_numbers_in_the_text_as_escaped_bytes(tmp_path: Path) -> None:
    tree, data = triangle_tree()
    tree["buffers"] = [{"byteLength": len(data), "uri": "data:," + "".join(f"%{byte:02x}" for byte in data)}]
    (tmp_path / "a.gltf").write_text(json.dumps(tree))
    assert tops(read_set(tmp_path / "a.gltf")) == [2, 4, 0]


@pytest.mark.parametrize(("version", "is_read"), [("2.0", True), ("2.1", False), ("3.0", False)])
def test_the_least_version_that_a_file_asks_for(tmp_path: Path, version: str, is_read: bool) -> None:  # noqa: FBT001
    tree, data = triangle_tree(asset={"version": "2.1", "minVersion": version})
    path = glb(tmp_path / "a.glb", tree, data)
    if is_read:
        read_set(path)
    else:
        with pytest.raises(InputProblem, match=f"requires glTF {version}"):
            read_set(path)


def test_files_beside_a_set_are_told_even_where_one_is_missing(tmp_path: Path) -> None:
    tree, _ = triangle_tree()
    tree["buffers"] = [{"byteLength": 4, "uri": "a%20b.bin"}, {"byteLength": 4, "uri": "data:,abcd"}]
    (tmp_path / "a.gltf").write_text(json.dumps(tree))
    assert files_beside(tmp_path / "a.gltf") == (tmp_path / "a b.bin",)
    (tmp_path / "b.gltf").write_text("{")
    assert files_beside(tmp_path / "b.gltf") == ()
    assert files_beside(tmp_path / "c.glb") == ()
