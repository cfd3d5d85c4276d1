"""glTF and GLB files as trees of numbers; what they claim is checked before anything is made of it (glTF 2.0, 3-5)."""

import json
import struct
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final
from urllib.parse import unquote

from kagezou.errors import InputProblem
from kagezou.io.files.faults import input_problem
from kagezou.io.sets.bounded_bytes import bytes_of
from kagezou.io.sets.gltf_buffers import Buffers
from kagezou.io.sets.gltf_tree import SHAPELESS, Tree, damaged, entry_of, list_of
from kagezou.io.sets.plain_text import utf8_of
from kagezou.message import Message

_MAX_JSON_BYTES: Final = 32 << 20
_MAX_NODES: Final = 200_000
_MAX_DEPTH: Final = 200
_NEWEST: Final = (2, 0)
_MAGIC: Final = b"glTF"
_JSON_CHUNK: Final = 0x4E4F534A
_BINARY_CHUNK: Final = 0x004E4942


@dataclass(frozen=True, slots=True)
class Gltf:
    """A checked file: its tree, its buffers, and which node hangs on which."""

    path: Path
    tree: Tree
    buffers: Buffers
    parents: dict[int, int]
    notes: tuple[Message, ...] = ()


def read_gltf(path: Path) -> Gltf:
    """Read and check a file, but for its numbers, which are looked at where they are used.

    Raises
    ------
    InputProblem
        It is broken.
    """
    data = bytes_of(path)
    try:
        tree, binary, notes = _parts(path, data)
        return Gltf(path, tree, Buffers(path, tree, binary), _parents(path, tree), notes)
    except SHAPELESS as error:
        raise damaged(path) from error


def _parts(path: Path, data: bytes) -> tuple[Tree, bytes, tuple[Message, ...]]:
    text, binary, notes = _chunks(path, data) if data[:4] == _MAGIC else (utf8_of(data), b"", ())
    if len(text) > _MAX_JSON_BYTES:
        raise input_problem(
            path, Message("its description is larger than {megabytes} MB", megabytes=_MAX_JSON_BYTES >> 20)
        )
    try:
        # Some programs fill it up with zeros.
        tree = json.loads(text.rstrip(b"\0").decode("utf-8-sig"))
    except RecursionError as error:
        raise input_problem(path, Message("it is nested too deep")) from error
    if not isinstance(tree, dict) or str(tree["asset"]["version"]).partition(".")[0] != "2":
        raise input_problem(path, Message("it is not a glTF 2 file"))
    least = str(tree["asset"].get("minVersion", "2.0"))
    if tuple(int(part) for part in least.split(".")[:2]) > _NEWEST:
        raise input_problem(path, Message("it requires glTF {version}; only glTF 2.0 is read", version=least[:20]))
    return tree, binary, notes


def _chunks(path: Path, data: bytes) -> tuple[bytes, bytes, tuple[Message, ...]]:
    """Return text and numbers of a GLB; chunks of other kinds are passed over, as they have to be."""
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
    beyond = len(data) - length
    notes = (Message("{count} bytes behind its end are not used", count=beyond),) if beyond else ()
    return chunks[_JSON_CHUNK], chunks.get(_BINARY_CHUNK, b""), notes


def files_beside(path: Path) -> tuple[Path, ...]:
    """Return the files that a set needs besides its own: the buffers of a ``.gltf``; none of one that is broken."""
    if path.suffix.lower() != ".gltf":
        return ()
    try:
        tree = read_gltf(path).tree
        uris = [buffer.get("uri", "data:") for buffer in list_of(path, tree, "buffers")]
    except (InputProblem, *SHAPELESS):
        return ()
    return tuple(path.parent / unquote(uri) for uri in uris if isinstance(uri, str) and not uri.startswith("data:"))


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


def named(entry: dict[str, Any], number: int) -> str:
    """Return what an entry of a tree is called, or its number from 0."""
    return str(entry.get("name") or number)[:60]
