"""The shapes of glTF meshes: primitives as triangles, with morph targets, posed by the joints of a skin."""

from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.vectors import Matrix
from kagezou.io.files.faults import input_problem
from kagezou.io.sets.gltf import Gltf
from kagezou.io.sets.gltf_accessors import accessor_of, count_of, numbers, whole_numbers
from kagezou.io.sets.gltf_draco import Decoded, decoded
from kagezou.io.sets.gltf_extensions import DRACO, can_read_draco
from kagezou.io.sets.gltf_tree import Tree, entry_of, extension_of, list_of, whole
from kagezou.io.sets.strips import of_fan, of_strip
from kagezou.message import Message

POINTS, TRIANGLES, STRIP, FAN = 0, 4, 5, 6
_MODES: Final = (TRIANGLES, STRIP, FAN)


@dataclass(frozen=True, slots=True, eq=False)
class Shape:
    """A primitive as it is before it is placed.

    Parameters
    ----------
    points
        (N, 3).
    corners
        (M, 3), indices of points.
    joints, weights
        (N, J) each: which joints of a skin move a point, and how much; no columns for a shape without.
    """

    points: Matrix
    corners: NDArray[np.int32]
    joints: NDArray[np.int64]
    weights: Matrix


def has_triangles(part: Tree) -> bool:
    """Whether a primitive is made of triangles, not of points or lines."""
    return part.get("mode", TRIANGLES) in _MODES


def sizes_of(file: Gltf, part: Tree) -> tuple[int, int]:
    """Return how many triangles and how many points a primitive claims to have."""
    points = count_of(file, part["attributes"].get("POSITION"), "VEC3")
    count = count_of(file, part["indices"], "SCALAR") if "indices" in part else points
    return count // 3 if part.get("mode", TRIANGLES) == TRIANGLES else max(count - 2, 0), points


def shape_of(file: Gltf, part: Tree, weights: NDArray[np.float64]) -> Shape:
    """Return a primitive, its morph targets added with these weights.

    Raises
    ------
    InputProblem
        It refers to more than the file holds.
    """
    packed = extension_of(part, DRACO)
    found = decoded(file, packed) if packed is not None and can_read_draco() else None
    points, corners = _bare(file, part) if found is None else _unpacked(file, part, found)
    if len(corners) and not 0 <= corners.min() <= corners.max() < len(points):
        raise input_problem(file.path, Message("it is damaged: a triangle names a missing corner"))
    for target, weight in zip(part.get("targets", ()), weights, strict=False):
        if weight and "POSITION" in target:
            moved = numbers(file, target["POSITION"], "VEC3")
            if moved.shape != points.shape:
                raise ValueError(moved.shape)
            points = points + weight * moved
    joints, parts = _joints(file, part, found, len(points))
    return Shape(points, corners.astype(np.int32), joints, parts)


def _bare(file: Gltf, part: Tree) -> tuple[Matrix, NDArray[np.int64]]:
    points = numbers(file, part["attributes"].get("POSITION"), "VEC3")
    if "indices" in part:
        along = whole_numbers(file, part["indices"], "SCALAR")[:, 0]
    else:
        along = np.arange(len(points), dtype=np.int64)
    return points, _triangles(along, part.get("mode", TRIANGLES))


def _unpacked(file: Gltf, part: Tree, found: Decoded) -> tuple[Matrix, NDArray[np.int64]]:
    accessor = accessor_of(file, part["attributes"].get("POSITION"), "VEC3")
    points = found.points
    triangles, claimed = sizes_of(file, part)
    if len(points) > claimed or len(found.corners) > triangles:
        raise ValueError(len(points))
    if accessor.get("normalized") and points.dtype.kind in "iu":
        return np.maximum(points / np.iinfo(points.dtype).max, -1.0), found.corners
    return points.astype(np.float64), found.corners


def _triangles(along: NDArray[np.int64], mode: int) -> NDArray[np.int64]:
    if mode == TRIANGLES:
        return along[: len(along) // 3 * 3].reshape(-1, 3)
    return of_strip(along) if mode == STRIP else of_fan(along)


def _joints(file: Gltf, part: Tree, found: Decoded | None, count: int) -> tuple[NDArray[np.int64], Matrix]:
    attributes, packed = part["attributes"], found.others if found is not None else {}
    joints: list[NDArray[Any]] = [np.zeros((count, 0), np.int64)]
    weights: list[NDArray[Any]] = [np.zeros((count, 0))]
    number = 0
    while f"JOINTS_{number}" in attributes and f"WEIGHTS_{number}" in attributes:
        names = f"JOINTS_{number}", f"WEIGHTS_{number}"
        if names[0] in packed and names[1] in packed:
            joints.append(packed[names[0]].astype(np.int64))
            weights.append(packed[names[1]].astype(np.float64))
        else:
            joints.append(whole_numbers(file, attributes[names[0]], "VEC4"))
            weights.append(numbers(file, attributes[names[1]], "VEC4"))
        number += 1
    return np.concatenate(joints, axis=1), np.concatenate(weights, axis=1)


def joint_places(file: Gltf, skin: object, places: tuple[Matrix, ...]) -> Matrix:
    """Return the (J, 4, 4) maps of a skin's joints, from where a mesh is modelled to where its points stand."""
    entry = entry_of(file.path, file.tree, "skins", skin)
    joints = [whole(each) for each in entry["joints"]]
    if joints and max(joints) >= len(list_of(file.path, file.tree, "nodes")):
        raise IndexError(joints)
    stand = np.stack([places[joint] for joint in joints])
    if "inverseBindMatrices" not in entry:
        return stand
    # Column by column in the file.
    back = numbers(file, entry["inverseBindMatrices"], "MAT4").reshape(-1, 4, 4).transpose(0, 2, 1)
    if len(back) < len(stand):
        raise ValueError(len(back))
    return np.asarray(stand @ back[: len(stand)])


def posed(shape: Shape, joints: Matrix, place: Matrix) -> Matrix:
    """Return the points of a shape moved by the joints of its skin (J, 4, 4); those that none moves stay at ``place``.

    The place of the node that a skinned mesh hangs on is ignored else (glTF 2.0, 3.7.3.3).
    """
    if shape.joints.size and shape.joints[shape.weights > 0].max(initial=0) >= len(joints):
        raise IndexError(len(joints))
    total = shape.weights.sum(axis=1)
    made = np.zeros_like(shape.points)
    for column in range(shape.joints.shape[1]):
        weight = shape.weights[:, column]
        for joint in np.unique(shape.joints[weight > 0, column]).tolist():
            is_moved = (shape.joints[:, column] == joint) & (weight > 0)
            part = (weight[is_moved] / total[is_moved])[:, np.newaxis]
            made[is_moved] += part * moved_by(joints[joint], shape.points[is_moved])
    alone = total <= 0
    made[alone] = moved_by(place, shape.points[alone])
    return made


def moved_by(place: Matrix, points: Matrix) -> Matrix:
    """Return points (N, 3) moved by a place (4, 4)."""
    return np.asarray(points @ place[:3, :3].T + place[:3, 3])
