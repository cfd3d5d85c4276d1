"""Meshes of imported sets: read from glTF, OBJ, PLY, STL and USD, checked, and kept in memory.

What a file claims is compared with what it holds before a decoder allocates anything; pictures in it are never loaded.
"""

import threading
from collections import OrderedDict
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Final

import numpy as np

from kagezou.geometry.mesh import Mesh
from kagezou.geometry.mesh_making import mesh_of
from kagezou.io.files.faults import input_problem
from kagezou.io.files.file_stamp import FileStamp
from kagezou.io.sets.bounded_bytes import bytes_of, state_of
from kagezou.io.sets.triangle_count import MAX_TRIANGLES, too_many
from kagezou.message import Message

if TYPE_CHECKING:  # each reader is loaded with the first file of its kind
    from kagezou.io.sets.triangles import Triangles

MESH_SUFFIXES: Final = (".glb", ".gltf", ".obj", ".ply", ".stl", ".usd", ".usda", ".usdc", ".usdz")
DEFAULT_LIMIT_BYTES: Final = 512 << 20

_GLTF: Final = (".glb", ".gltf")
_USD: Final = (".usd", ".usda", ".usdc", ".usdz")
_FARTHEST: Final = 1e9

_State = tuple[Path, *FileStamp]
"""A file, its size and its time of change."""


@dataclass(frozen=True, slots=True, eq=False)
class SetContents:
    """What a file of a set holds.

    Parameters
    ----------
    mesh
        All its triangles, every node where it stands.
    notes
        What of the file is not used and what had to be assumed, without the file's name.
    """

    mesh: Mesh
    notes: tuple[Message, ...] = ()


class MeshCache:
    """Meshes read from files, bounded by memory, the least lately used going first; any thread may ask.

    A file is known by path, size and time of change, so an edited one is read again.

    Parameters
    ----------
    limit_bytes
        The memory that kept meshes may take together; a larger one is delivered but not kept.
    """

    def __init__(self, limit_bytes: int = DEFAULT_LIMIT_BYTES) -> None:
        self._limit_bytes = limit_bytes
        self._kept: OrderedDict[_State, SetContents] = OrderedDict()
        self._reading: dict[_State, threading.Lock] = {}
        self._lock = threading.Lock()

    def mesh(self, path: Path) -> Mesh:
        """Return the mesh of a file.

        Raises
        ------
        InputProblem
            It cannot be read.
        """
        return self._contents(path).mesh

    def notes(self, path: Path) -> tuple[Message, ...]:
        """Return what of a file is not used and what had to be assumed; raises as `mesh` does."""
        return self._contents(path).notes

    def _contents(self, path: Path) -> SetContents:
        key = (path, *state_of(path))
        if (kept := self._found(key)) is not None:
            return kept
        with self._lock:
            reading = self._reading.setdefault(key, threading.Lock())
        # Two threads that want one mesh wait for one reading; other meshes are had meanwhile.
        try:
            with reading:
                if (kept := self._found(key)) is None:
                    kept = read_set(path)
                    self._keep(key, kept)
        finally:
            with self._lock:
                self._reading.pop(key, None)
        return kept

    def _found(self, key: _State) -> SetContents | None:
        with self._lock:
            kept = self._kept.get(key)
            if kept is not None:
                self._kept.move_to_end(key)
            return kept

    def _keep(self, key: _State, contents: SetContents) -> None:
        with self._lock:
            for other in [each for each in self._kept if each[0] == key[0]]:
                del self._kept[other]
            self._kept[key] = contents
            while len(self._kept) > 1 and sum(each.mesh.nbytes for each in self._kept.values()) > self._limit_bytes:
                self._kept.popitem(last=False)


def is_mesh(path: Path) -> bool:
    """Whether a file is an imported set by its name."""
    return path.suffix.lower() in MESH_SUFFIXES


def read_set(path: Path) -> SetContents:
    """Read all the triangles of a file as one mesh, every node where it stands.

    Raises
    ------
    InputProblem
        The file is missing, broken, of an unknown kind or too large, or has no triangles.
    """
    state_of(path)
    suffix = path.suffix.lower()
    if suffix not in MESH_SUFFIXES:
        raise input_problem(
            path,
            Message(
                "this is not a set that can be read; readable are {mesh_suffixes}",
                mesh_suffixes=", ".join(MESH_SUFFIXES),
            ),
        )
    try:
        # What is no number is looked for in the end.
        with np.errstate(all="ignore"):
            found = _triangles(path, suffix)
        return SetContents(_checked(path, found), found.notes)
    except MemoryError as error:
        raise input_problem(path, Message("there is not enough memory for this set")) from error


def _triangles(path: Path, suffix: str) -> "Triangles":
    if suffix in _USD:
        from kagezou.io.sets.usd import read_usd

        return read_usd(path)
    if suffix in _GLTF:
        from kagezou.io.sets.gltf_meshes import read_gltf_meshes

        return read_gltf_meshes(path, MAX_TRIANGLES)
    return _plain_triangles(path, suffix)


def _plain_triangles(path: Path, suffix: str) -> "Triangles":
    if suffix == ".obj":
        from kagezou.io.sets.obj import read_obj as read
    elif suffix == ".ply":
        from kagezou.io.sets.ply import read_ply as read
    else:
        from kagezou.io.sets.stl import read_stl as read
    return read(path, bytes_of(path), MAX_TRIANGLES)


def _checked(path: Path, found: "Triangles") -> Mesh:
    """Return a mesh whose numbers make sense, its equal vertices made one."""
    points, corners = found.points, found.corners
    if not len(points) or not len(corners):
        raise input_problem(path, _nothing_in(found.notes))
    if len(corners) > MAX_TRIANGLES:
        raise too_many(path, len(corners))
    if corners.min() < 0 or corners.max() >= len(points):
        raise input_problem(path, Message("it is damaged: a triangle names a missing corner"))
    _check_places(path, found)
    mesh = mesh_of(points, corners)
    if not len(mesh.triangles):
        raise input_problem(path, Message("there are only triangles without an area in it"))
    return mesh


def _check_places(path: Path, found: "Triangles") -> None:
    """See that all corners of triangles lie somewhere; other points of a file may lie nowhere."""
    is_used = np.zeros(len(found.points), bool)
    is_used[found.corners] = True
    used = found.points if is_used.all() else found.points[is_used]
    low, high = float(used.min()), float(used.max())
    if not np.isfinite([low, high]).all():
        raise input_problem(path, Message("it is damaged: a corner is not a number"))
    if max(high, -low) > _FARTHEST:
        raise input_problem(path, Message("a corner lies more than {farthest:g} units away", farthest=_FARTHEST))


def _nothing_in(notes: tuple[Message, ...]) -> Message:
    """Return what is said of a file without triangles, and of the first thing in it that is not used."""
    if notes:
        return Message("there are no triangles in it: {why}", why=notes[0])
    return Message("there are no triangles in it")
