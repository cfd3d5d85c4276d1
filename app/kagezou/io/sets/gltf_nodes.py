"""The nodes of glTF files: where they stand, which of them are in the scene, and which are hidden."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.vectors import Matrix
from kagezou.io.files.faults import input_problem
from kagezou.io.sets.gltf import Gltf, named
from kagezou.io.sets.gltf_tree import extension_of, list_of, whole
from kagezou.message import Message

RESTS: Final[Mapping[str, tuple[float, ...]]] = {
    "translation": (0, 0, 0),
    "rotation": (0, 0, 0, 1),
    "scale": (1, 1, 1),
}
"""The parts of a node's place, and what they are where it does not say."""

Part = Callable[[str], NDArray[np.float64]]
"""What gives one of these parts."""


@dataclass(frozen=True, slots=True, eq=False)
class SceneNodes:
    """The nodes of the scene that is read.

    Parameters
    ----------
    numbers
        Of those that are seen.
    places
        Where every node of the file stands, in the scene or not, (4, 4) each.
    notes
        What is not used.
    """

    numbers: tuple[int, ...]
    places: tuple[Matrix, ...]
    notes: tuple[Message, ...]


def scene_nodes(file: Gltf) -> SceneNodes:
    """Return the nodes that are seen, and where they stand without any animation."""
    nodes = list_of(file.path, file.tree, "nodes")
    roots, notes = _roots(file)
    seen: list[int] = []
    hidden = 0
    waiting = list(reversed(roots))
    while waiting:
        number = waiting.pop()
        if (extension_of(nodes[number], "KHR_node_visibility") or {}).get("visible", True) is False:
            hidden += 1
            continue
        seen.append(number)
        waiting += reversed(nodes[number].get("children", ()))
    if hidden:
        notes = (*notes, Message("{count} of its nodes are hidden, and what hangs on them", count=hidden))
    return SceneNodes(tuple(dict.fromkeys(seen)), _places(file), notes)


def _roots(file: Gltf) -> tuple[list[int], tuple[Message, ...]]:
    scenes = list_of(file.path, file.tree, "scenes")
    nodes = list_of(file.path, file.tree, "nodes")
    if not scenes:
        every = [number for number in range(len(nodes)) if number not in file.parents]
        return every, (Message("it has no scene: all of its nodes are read"),) if nodes else ()
    number = whole(file.tree.get("scene", 0))
    if number >= len(scenes):
        raise input_problem(
            file.path, Message("it is damaged: there is no {name}[{index}]", name="scenes", index=number)
        )
    roots = [whole(each) for each in scenes[number].get("nodes", ())]
    if len(scenes) == 1:
        return roots, ()
    told = Message("of its {count} scenes only {name!r} is read", count=len(scenes), name=named(scenes[number], number))
    return roots, (told,)


def _places(file: Gltf) -> tuple[Matrix, ...]:
    nodes = list_of(file.path, file.tree, "nodes")
    places: list[Matrix] = [np.eye(4)] * len(nodes)
    level = [number for number in range(len(nodes)) if number not in file.parents]
    while level:
        for number in level:
            local = local_place(nodes[number])
            above = file.parents.get(number)
            places[number] = local if above is None else places[above] @ local
        level = [whole(child) for number in level for child in nodes[number].get("children", ())]
    return tuple(places)


def local_place(node: dict[str, Any], part: Part | None = None) -> Matrix:
    """Return where a node stands on its parent (4, 4), ``part`` giving the parts of its place instead of the file."""
    if "matrix" in node:
        # Column by column in the file.
        return np.array(node["matrix"], np.float64).reshape(4, 4).T
    own = part or (lambda name: np.array(node.get(name, RESTS[name]), np.float64))
    return placed(*(own(name) for name in RESTS))


def placed(move: NDArray[np.float64], turn: NDArray[np.float64], size: NDArray[np.float64]) -> Matrix:
    """Return the place (4, 4) made of a translation, a quaternion x y z w and a scale."""
    made = np.eye(4)
    made[:3, :3] = _rotation(turn) * size
    made[:3, 3] = move
    return made


def _rotation(turn: NDArray[np.float64]) -> Matrix:
    length = np.linalg.norm(turn)
    # A quaternion of zeros turns nothing.
    x, y, z, w = turn / length if length > 0 else (0.0, 0.0, 0.0, 1.0)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
