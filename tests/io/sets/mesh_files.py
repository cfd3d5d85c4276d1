"""Small sets written by hand for the tests: glTF, GLB and OBJ."""

import base64
import json
import struct
from pathlib import Path
from typing import Any

import numpy as np

TRIANGLE = np.array([[0, 0, 0], [2, 0, 0], [0, 1, 0]], "<f4")
Tree = dict[str, Any]


def tree_with(numbers: list[np.ndarray[Any, Any]], **parts: Any) -> tuple[Tree, bytes]:
    """Return a glTF tree with one accessor for each array, and the binary that holds them."""
    kinds = {"<f4": 5126, "<u2": 5123, "<u4": 5125, "|u1": 5121}
    widths = {1: "SCALAR", 3: "VEC3", 4: "VEC4"}
    data, views, accessors = b"", [], []
    for number, array in enumerate(numbers):
        rows = array.reshape(len(array), -1)
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": array.nbytes})
        accessors.append(
            {
                "bufferView": number,
                "componentType": kinds[array.dtype.str],
                "count": len(rows),
                "type": widths[rows.shape[1]],
                "min": rows.min(axis=0).tolist(),
                "max": rows.max(axis=0).tolist(),
            }
        )
        data += array.tobytes() + b"\0" * (-array.nbytes % 4)
    tree = {
        "asset": {"version": "2.0"},
        "buffers": [{"byteLength": len(data)}],
        "bufferViews": views,
        "accessors": accessors,
        "scene": 0,
        **parts,
    }
    return tree, data


def triangle_tree(**parts: Any) -> tuple[Tree, bytes]:
    """Return a triangle on a node that lifts it by 3."""
    tree, data = tree_with([TRIANGLE, np.array([0, 1, 2], "<u2")])
    tree |= {
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "translation": [0, 3, 0]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    }
    return tree | parts, data


def glb(path: Path, tree: Tree, data: bytes) -> Path:
    text = json.dumps(tree).encode()
    text += b" " * (-len(text) % 4)
    body = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(data), 0x004E4942) + data
    path.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body)
    return path


def gltf(path: Path, tree: Tree, data: bytes) -> Path:
    inside = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    tree = {**tree, "buffers": [{"byteLength": len(data), "uri": inside}]}
    path.write_text(json.dumps(tree))
    return path
