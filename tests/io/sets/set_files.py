"""A unit cube as a set in every format, and glTF trees that can be bent out of shape."""

import json
import struct
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

Tree = dict[str, Any]

CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], np.float32)
"""The corners of the unit cube, counted 4 x + 2 y + z."""

CUBE_FACES = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
                       [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]], np.uint16)  # fmt: skip

_COMPONENTS = {"f4": 5126, "u2": 5123}


class GltfFile:
    """A glTF tree that is filled step by step; ``binary`` is its one buffer."""

    def __init__(self) -> None:
        self.binary = b""
        self.tree: Tree = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}]}
        for name in ("nodes", "meshes", "accessors", "bufferViews"):
            self.tree[name] = []

    def accessor(self, rows: NDArray[Any]) -> int:
        """Add numbers (count,) or (count, 3)."""
        view = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": rows.nbytes}
        self.binary += rows.tobytes() + bytes(-rows.nbytes % 4)
        self.tree["bufferViews"].append(view)
        kind = "SCALAR" if rows.ndim == 1 else "VEC3"
        made = {"bufferView": len(self.tree["bufferViews"]) - 1, "componentType": _COMPONENTS[rows.dtype.str[1:]],
                "count": len(rows), "type": kind}  # fmt: skip
        self.tree["accessors"].append(made)
        return len(self.tree["accessors"]) - 1

    def mesh(self, vertices: NDArray[np.float32] = CUBE, faces: NDArray[Any] = CUBE_FACES) -> int:
        """Add a mesh of triangles."""
        part = {"attributes": {"POSITION": self.accessor(vertices)}, "indices": self.accessor(faces.reshape(-1))}
        self.tree["meshes"].append({"primitives": [part]})
        return len(self.tree["meshes"]) - 1

    def node(self, **more: Any) -> None:
        """Add a node to the scene."""
        self.tree["nodes"].append(more)
        self.tree["scenes"][0]["nodes"].append(len(self.tree["nodes"]) - 1)

    def glb(self) -> bytes:
        """Return it as one binary file."""
        tree = {**self.tree, "buffers": [{"byteLength": len(self.binary)}]}
        return glb_of(json.dumps(tree).encode(), self.binary)

    def gltf(self, uri: str) -> bytes:
        """Return its text, its buffer lying at ``uri``."""
        return json.dumps({**self.tree, "buffers": [{"byteLength": len(self.binary), "uri": uri}]}).encode()


def glb_of(text: bytes, binary: bytes) -> bytes:
    """Return a GLB of any JSON text and any binary chunk."""
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
    if binary:
        binary += bytes(-len(binary) % 4)
        chunks += struct.pack("<II", len(binary), 0x004E4942) + binary
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def cube_file() -> GltfFile:
    """Return a file with one unit cube."""
    made = GltfFile()
    made.node(mesh=made.mesh())
    return made


def changed(made: GltfFile, **lists: Mapping[int, Mapping[str, Any]]) -> bytes:
    """Return a GLB in which entries of lists are changed: ``accessors={1: {"count": 7}}``."""
    for name, changes in lists.items():
        for index, change in changes.items():
            made.tree[name][index].update(change)
    return made.glb()


def written(path: Path, data: bytes | str) -> Path:
    """Write a file and return where it is."""
    path.write_bytes(data.encode() if isinstance(data, str) else data)
    return path


CUBE_OBJ = "".join(f"v {x} {y} {z}\n" for x, y, z in CUBE) + "".join(
    f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in CUBE_FACES
)

CUBE_PLY = (
    "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 12\nproperty list uchar int vertex_indices\nend_header\n"
    + "".join(f"{x} {y} {z}\n" for x, y, z in CUBE)
    + "".join(f"3 {a} {b} {c}\n" for a, b, c in CUBE_FACES)
)

CUBE_STL = (
    bytes(80)
    + struct.pack("<I", 12)
    + b"".join(struct.pack("<3f", 0, 0, 0) + CUBE[face].tobytes() + bytes(2) for face in CUBE_FACES)
)

CUBE_USDA = """#usda 1.0
def Mesh "cube"
{
    int[] faceVertexCounts = [4, 4, 4, 4, 4, 4]
    int[] faceVertexIndices = [0, 1, 3, 2, 4, 6, 7, 5, 0, 4, 5, 1, 2, 3, 7, 6, 0, 2, 6, 4, 1, 5, 7, 3]
    point3f[] points = [(0,0,0), (0,0,1), (0,1,0), (0,1,1), (1,0,0), (1,0,1), (1,1,0), (1,1,1)]
}
"""
