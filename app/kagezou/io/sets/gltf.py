"""glTF and GLB files as trees of numbers; what they claim is checked before anything is made of it (glTF 2.0, 3-5)."""

import base64
import binascii
import json
import struct
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final
from urllib.parse import unquote

import numpy as np
from numpy.typing import NDArray

from kagezou.errors import InputProblem
from kagezou.io.files.faults import input_problem
from kagezou.io.sets.bounded_bytes import MAX_BYTES, bytes_of, check_inside
from kagezou.message import Message

Tree = dict[str, Any]

_MAX_JSON_BYTES: Final = 32 << 20
_MAX_NODES: Final = 200_000
_MAX_DEPTH: Final = 200
_MAX_BUFFERS: Final = 1000
MAGIC: Final = b"glTF"
JSON_CHUNK: Final = 0x4E4F534A
BINARY_CHUNK: Final = 0x004E4942
_COMPONENTS: Final = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTHS: Final = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
_UNREADABLE: Final = ("KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression")
SHAPELESS: Final = (KeyError, TypeError, AttributeError, ValueError, IndexError, OverflowError, struct.error)
"""A tree of the wrong shape shows itself in many ways."""


@dataclass(frozen=True, slots=True)
class Gltf:
    """A checked file: its tree, its buffers, and which node hangs on which."""

    path: Path
    tree: Tree
    buffers: tuple[bytes, ...]
    parents: dict[int, int]

    def accessor(self, index: int) -> NDArray[np.float64]:
        """Return the numbers (count, width) of an accessor."""
        accessor = entry_of(self.path, self.tree, "accessors", index)
        kind = np.dtype(_COMPONENTS[accessor["componentType"]])
        width, count = _WIDTHS[accessor["type"]], accessor["count"]
        made = np.zeros((count, width))
        if "bufferView" in accessor:
            view = entry_of(self.path, self.tree, "bufferViews", accessor["bufferView"])
            start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
            step = view.get("byteStride") or width * kind.itemsize
            rows = np.ndarray((count, width), kind, self.buffers[view["buffer"]], start, (step, kind.itemsize))
            made[:] = rows
        if accessor.get("normalized") and kind.kind in "iu":
            made = np.maximum(made / np.iinfo(kind).max, -1.0)
        return made


def read_gltf(path: Path) -> Gltf:
    """Read and check a file, but for its triangles.

    Raises
    ------
    InputProblem
        It is broken, compressed in a way that is not read, or refers to something outside its folder.
    """
    data = bytes_of(path)
    try:
        tree, binary = _parts(path, data)
        for name in tree.get("extensionsRequired", ()):
            if name in _UNREADABLE:
                raise input_problem(
                    path, Message("it is compressed ({name}): please export it without compression", name=name)
                )
        buffers = _buffers(path, tree, binary)
        file = Gltf(path, tree, buffers, _parents(path, tree))
        for accessor in list_of(path, tree, "accessors"):
            _check_accessor(file, accessor)
    except SHAPELESS as error:
        raise damaged(path) from error
    return file


def _parts(path: Path, data: bytes) -> tuple[Tree, bytes | None]:
    binary = None
    text = data
    if data[:4] == MAGIC:
        _, version, length = struct.unpack_from("<4sII", data)
        if version != 2:
            raise input_problem(path, Message("it is glTF {version}; only glTF 2 is read", version=version))
        if length > len(data):
            raise input_problem(path, Message("it is cut off"))
        at = 12
        chunks: dict[int, bytes] = {}
        while at + 8 <= length:
            size, kind = struct.unpack_from("<II", data, at)
            if at + 8 + size > length:
                raise input_problem(path, Message("it is cut off"))
            chunks.setdefault(kind, data[at + 8 : at + 8 + size])
            at += 8 + size
        text, binary = chunks[JSON_CHUNK], chunks.get(BINARY_CHUNK)
    if len(text) > _MAX_JSON_BYTES:
        raise input_problem(
            path, Message("its description is larger than {megabytes} MB", megabytes=_MAX_JSON_BYTES >> 20)
        )
    try:
        tree = json.loads(text.decode("utf-8-sig"))
    except RecursionError as error:
        raise input_problem(path, Message("it is nested too deep")) from error
    if not isinstance(tree, dict) or str(tree["asset"]["version"]).partition(".")[0] != "2":
        raise input_problem(path, Message("it is not a glTF 2 file"))
    return tree, binary


def list_of(path: Path, tree: Tree, name: str) -> list[Tree]:
    """Return a list of objects out of a tree, empty where there is none."""
    found = tree.get(name, [])
    if not isinstance(found, list):
        raise input_problem(path, Message("it is not a complete glTF file: {name!r} is not a list", name=name))
    return found


def entry_of(path: Path, tree: Tree, name: str, index: object) -> Tree:
    """Return an object of such a list."""
    found = list_of(path, tree, name)
    if not isinstance(index, int) or isinstance(index, bool) or not 0 <= index < len(found):
        raise input_problem(
            path, Message("it is damaged: there is no {name}[{index}]", name=name, index=repr(index)[:160])
        )
    entry = found[index]
    if not isinstance(entry, dict):
        raise TypeError(entry)
    return entry


def _buffers(path: Path, tree: Tree, binary: bytes | None) -> tuple[bytes, ...]:
    found: list[bytes] = []
    for buffer in list_of(path, tree, "buffers"):
        found.append(_buffer(path, buffer, binary))
        # One file may be named many times.
        if sum(map(len, found)) > MAX_BYTES or len(found) > _MAX_BUFFERS:
            raise input_problem(
                path, Message("its buffers are larger than {megabytes} MB or too many", megabytes=MAX_BYTES >> 20)
            )
    return tuple(found)


def _buffer(path: Path, buffer: Tree, binary: bytes | None) -> bytes:
    length, uri = buffer["byteLength"], buffer.get("uri")
    if uri is None:
        data = binary or b""
    elif uri.startswith("data:"):
        try:
            data = base64.b64decode(uri.partition(",")[2], validate=True)
        except binascii.Error as error:
            raise input_problem(path, Message("it is damaged: a buffer in it is not base64 text")) from error
    else:
        data = _beside(path, uri)
    if not isinstance(length, int) or len(data) < length:
        raise input_problem(path, Message("it is damaged: a buffer is shorter than it should be"))
    return data


def files_beside(path: Path) -> tuple[Path, ...]:
    """Return the files that a set needs besides its own: the buffers of a ``.gltf``; none of one that is broken."""
    if path.suffix.lower() != ".gltf":
        return ()
    try:
        tree = read_gltf(path).tree
    except InputProblem:
        return ()
    uris = (buffer.get("uri", "data:") for buffer in list_of(path, tree, "buffers"))
    return tuple(path.parent / unquote(uri) for uri in uris if not uri.startswith("data:"))


def _beside(path: Path, uri: str) -> bytes:
    """Return a file that the set refers to, which must lie in its folder or below."""
    name = unquote(uri)
    check_inside(path, name)
    return bytes_of(path.parent / name)


def _parents(path: Path, tree: Tree) -> dict[int, int]:
    """Return which node hangs on which, having seen that none hangs on itself or too deep."""
    nodes = list_of(path, tree, "nodes")
    if len(nodes) > _MAX_NODES:
        raise input_problem(path, Message("it has more than {most_nodes} nodes", most_nodes=_MAX_NODES))
    parents: dict[int, int] = {}
    for number, node in enumerate(nodes):
        for child in node.get("children", ()):
            entry_of(path, tree, "nodes", child)
            if child in parents:
                raise input_problem(path, Message("it is damaged: a node has two parents"))
            parents[child] = number
    reached = level = [number for number in range(len(nodes)) if number not in parents]
    for _ in range(_MAX_DEPTH):
        level = [child for number in level for child in nodes[number].get("children", ())]
        reached = reached + level
    if len(reached) != len(nodes):
        raise input_problem(path, Message("it is damaged: its nodes form an endless loop"))
    for scene in list_of(path, tree, "scenes"):
        for root in scene.get("nodes", ()):
            entry_of(path, tree, "nodes", root)
    return parents


def _check_accessor(file: Gltf, accessor: Tree) -> None:
    count = accessor["count"]
    size = np.dtype(_COMPONENTS[accessor["componentType"]]).itemsize * _WIDTHS[accessor["type"]]
    if not isinstance(count, int) or count < 0:
        raise ValueError(count)
    if "sparse" in accessor:
        raise input_problem(file.path, Message("it uses sparse accessors, which are not read"))
    if "bufferView" not in accessor:
        # Nothing but zeros, of any claimed number.
        raise input_problem(file.path, Message("it is damaged: it refers to numbers that are missing"))
    view = entry_of(file.path, file.tree, "bufferViews", accessor["bufferView"])
    buffer = file.buffers[_index(view["buffer"], len(file.buffers))]
    start, inner = view.get("byteOffset", 0), accessor.get("byteOffset", 0)
    step = view.get("byteStride") or size
    length = view["byteLength"]
    needed = inner + (step * (count - 1) + size if count else 0)
    if min(start, inner, length, step) < 0 or start + length > len(buffer) or needed > length:
        raise input_problem(file.path, Message("it is damaged: it refers to more numbers than it holds"))


def _index(index: object, count: int) -> int:
    if not isinstance(index, int) or not 0 <= index < count:
        raise IndexError(index)
    return index


def damaged(path: Path) -> InputProblem:
    """Return the problem of a file whose numbers do not fit together."""
    return input_problem(path, Message("it is not a complete glTF file"))
