"""Primitives of glTF files that are compressed with Draco, where the optional package for it is installed."""

from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kagezou.io.files.faults import input_problem
from kagezou.io.sets.gltf import Gltf
from kagezou.io.sets.gltf_tree import Tree
from kagezou.io.sets.gltf_views import view_of
from kagezou.message import Message


@dataclass(frozen=True, slots=True, eq=False)
class Decoded:
    """What was compressed: points (N, 3) of any kind of number, corners (M, 3), and other attributes by their names."""

    points: NDArray[Any]
    corners: NDArray[np.int64]
    others: dict[str, NDArray[Any]]


def decoded(file: Gltf, packed: Tree) -> Decoded:
    """Return what an extension of a primitive holds.

    Raises
    ------
    InputProblem
        It is damaged.
    """
    data, _ = view_of(file, packed["bufferView"])
    names = packed["attributes"]
    try:
        mesh = import_module("DracoPy").decode(bytes(data))
        found = {name: mesh.get_attribute_by_unique_id(number) for name, number in names.items()}
        points = np.asarray(found.pop("POSITION")["data"]).reshape(-1, 3)
        others = {name: np.asarray(each["data"]).reshape(len(points), -1) for name, each in found.items()}
        return Decoded(points, np.asarray(mesh.faces, np.int64).reshape(-1, 3), others)
    # What a decoder raises for broken numbers is of any kind.
    except Exception as error:
        raise input_problem(file.path, Message("it is damaged: what is compressed in it cannot be read")) from error
