"""The numbers of glTF files: rows in buffers, some of them replaced, as they are or as parts of the largest number."""

from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.io.files.faults import input_problem
from kagezou.io.sets.gltf import Gltf
from kagezou.io.sets.gltf_tree import Tree, entry_of, whole
from kagezou.io.sets.gltf_views import view_of
from kagezou.message import Message

_COMPONENTS: Final = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTHS: Final = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
_MAX_ZEROS: Final = 60_000_000
"""An accessor without a place in a buffer is all zeros, of any claimed number."""


def accessor_of(file: Gltf, index: object, kind: str) -> Tree:
    """Return an accessor, which has to be of a kind such as VEC3; ValueError else."""
    accessor = entry_of(file.path, file.tree, "accessors", index)
    if accessor["type"] != kind:
        raise ValueError(accessor)
    return accessor


def count_of(file: Gltf, index: object, kind: str) -> int:
    """Return how many rows an accessor claims to have."""
    return whole(accessor_of(file, index, kind)["count"])


def numbers(file: Gltf, index: object, kind: str) -> NDArray[np.float64]:
    """Return the rows (count, width) of an accessor of a kind; parts of the largest number lie from -1 or 0 to 1.

    Raises
    ------
    InputProblem
        It is not there or refers to more than the file holds.
    """
    accessor = accessor_of(file, index, kind)
    rows = _rows(file, accessor)
    made = rows.astype(np.float64)
    if accessor.get("normalized") and rows.dtype.kind in "iu":
        made = np.maximum(made / np.iinfo(rows.dtype).max, -1.0)
    return made


def whole_numbers(file: Gltf, index: object, kind: str) -> NDArray[np.int64]:
    """Return the rows (count, width) of an accessor of whole numbers; raises as `numbers` does."""
    accessor = accessor_of(file, index, kind)
    if np.dtype(_COMPONENTS[accessor["componentType"]]).kind != "u":
        raise input_problem(file.path, Message("it is damaged: corners are not named by whole numbers"))
    return _rows(file, accessor).astype(np.int64)


def _rows(file: Gltf, accessor: Tree) -> NDArray[Any]:
    kind = np.dtype(_COMPONENTS[accessor["componentType"]])
    width, count = _WIDTHS[accessor["type"]], whole(accessor["count"])
    sparse = accessor.get("sparse")
    if "bufferView" in accessor:
        rows = _strided(file, accessor, kind, (count, width))
    else:
        if count * width > _MAX_ZEROS:
            raise input_problem(file.path, Message("it is damaged: it refers to numbers that are missing"))
        rows = np.zeros((count, width), kind)
    return rows if sparse is None else _replaced(file, rows, sparse)


def _strided(file: Gltf, place: Tree, kind: np.dtype[Any], shape: tuple[int, int]) -> NDArray[Any]:
    """Return rows in a view, which may lie apart, having seen that it holds them all."""
    count, width = shape
    data, step = view_of(file, place["bufferView"])
    inner = whole(place.get("byteOffset", 0))
    size = kind.itemsize * width
    step = step or size
    if inner + (step * (count - 1) + size if count else 0) > len(data):
        raise input_problem(file.path, Message("it is damaged: it refers to more numbers than it holds"))
    if not count:
        return np.zeros(shape, kind)
    return np.ndarray(shape, kind, data, inner, (step, kind.itemsize))


def _replaced(file: Gltf, rows: NDArray[Any], sparse: Tree) -> NDArray[Any]:
    """Return rows of which some have other numbers (glTF 2.0, 3.6.2.3)."""
    count = whole(sparse["count"])
    kind = np.dtype(_COMPONENTS[sparse["indices"]["componentType"]])
    if count > len(rows) or kind.kind != "u":
        raise ValueError(sparse)
    at = _strided(file, sparse["indices"], kind, (count, 1))[:, 0].astype(np.int64)
    values = _strided(file, sparse["values"], rows.dtype, (count, rows.shape[1]))
    if count and at.max() >= len(rows):
        raise input_problem(file.path, Message("it is damaged: it refers to more numbers than it holds"))
    made = np.array(rows)
    made[at] = values
    return made
