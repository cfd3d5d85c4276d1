"""The triangles of a glTF file, checked and put into a file of their own, which another decoder can read safely."""

import json
import struct
from pathlib import Path
from typing import Final

from kagezou.io.files.faults import input_problem
from kagezou.io.sets.gltf import (
    BINARY_CHUNK,
    JSON_CHUNK,
    MAGIC,
    SHAPELESS,
    Gltf,
    Tree,
    damaged,
    entry_of,
    list_of,
    read_gltf,
)
from kagezou.message import Message

_TRIANGLE_MODES: Final = (4, 5, 6)
_OF_NODE: Final = ("children", "mesh", "matrix", "translation", "rotation", "scale")


def packed_gltf(path: Path, most_triangles: int) -> bytes:
    """Return the triangles of a file as a GLB of their own, which refers to nothing outside itself.

    Raises
    ------
    InputProblem
        The file does not hold what it claims, refers to something outside its folder, or has too many triangles.
    """
    file = read_gltf(path)
    try:
        meshes = [[part for part in mesh["primitives"] if part.get("mode", 4) in _TRIANGLE_MODES]
                  for mesh in list_of(path, file.tree, "meshes")]  # fmt: skip
        _check_sizes(file, meshes, most_triangles)
        return _packed(file, meshes)
    except SHAPELESS as error:
        raise damaged(path) from error


def _check_sizes(file: Gltf, meshes: list[list[Tree]], most_triangles: int) -> None:
    """See that nothing becomes too large by being placed many times."""
    sizes = [(sum(_triangles_of(file, part) for part in parts), sum(_corners_of(file, part) for part in parts))
             for parts in meshes]  # fmt: skip
    placed = [node["mesh"] for node in list_of(file.path, file.tree, "nodes") if "mesh" in node]
    for index in placed:
        entry_of(file.path, file.tree, "meshes", index)
    total = sum(sizes[index][0] for index in placed)
    corners = max(sum(sizes[index][1] for index in placed), sum(size[1] for size in sizes))
    if total > most_triangles:
        raise input_problem(
            file.path,
            Message(
                "it has {total} triangles, more than the {most_triangles} that can be worked with",
                total=total,
                most_triangles=most_triangles,
            ),
        )
    if corners > 3 * most_triangles:
        raise input_problem(
            file.path, Message("it has {corners} corners of triangles, too many to work with", corners=corners)
        )


def _packed(file: Gltf, meshes: list[list[Tree]]) -> bytes:
    starts, binary = [], b""
    for data in file.buffers:
        starts.append(len(binary))
        binary += data + bytes(-len(data) % 4)
    views = [
        {**view, "buffer": 0, "byteOffset": view.get("byteOffset", 0) + starts[view["buffer"]]}
        for view in list_of(file.path, file.tree, "bufferViews")
    ]
    tree = {
        "asset": {"version": "2.0"},
        "scene": file.tree.get("scene", 0),
        "scenes": [{"nodes": scene.get("nodes", [])} for scene in list_of(file.path, file.tree, "scenes")],
        "nodes": [
            {name: node[name] for name in _OF_NODE if name in node and (name != "mesh" or meshes[node["mesh"]])}
            for node in list_of(file.path, file.tree, "nodes")
        ],
        "meshes": [{"primitives": [_bare(part) for part in parts]} for parts in meshes],
        "accessors": list_of(file.path, file.tree, "accessors"),
        "bufferViews": views,
        "buffers": [{"byteLength": len(binary)}],
    }
    text = json.dumps(tree).encode()
    text += b" " * (-len(text) % 4)
    length = 28 + len(text) + len(binary)
    head = struct.pack("<4sIIII", MAGIC, 2, length, len(text), JSON_CHUNK)
    return head + text + struct.pack("<II", len(binary), BINARY_CHUNK) + binary


def _bare(part: Tree) -> Tree:
    """Return a primitive without all that is not its shape."""
    kept: Tree = {name: part[name] for name in ("indices", "mode") if name in part}
    return {"attributes": {"POSITION": part["attributes"]["POSITION"]}, **kept}


def _corners_of(file: Gltf, part: Tree) -> int:
    where = entry_of(file.path, file.tree, "accessors", part["attributes"].get("POSITION"))
    if where["type"] != "VEC3":
        raise ValueError(where)
    return int(where["count"])


def _triangles_of(file: Gltf, part: Tree) -> int:
    """Return how many triangles a primitive has, having seen that its corners are there."""
    count = _corners_of(file, part)
    if "indices" in part:
        indices = entry_of(file.path, file.tree, "accessors", part["indices"])
        if indices["componentType"] not in (5121, 5123, 5125) or indices["type"] != "SCALAR":
            raise input_problem(file.path, Message("it is damaged: corners are not named by whole numbers"))
        if indices["count"] and file.accessor(part["indices"]).max() >= count:
            raise input_problem(file.path, Message("it is damaged: a triangle names a missing corner"))
        count = int(indices["count"])
    return count // 3 if part.get("mode", 4) == 4 else max(count - 2, 0)
