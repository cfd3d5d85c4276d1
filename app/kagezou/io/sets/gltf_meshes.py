"""All triangles of a glTF file, every mesh where its nodes, instances and joints put it."""

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from kagezou.geometry.vectors import Matrix
from kagezou.io.files.faults import input_problem
from kagezou.io.sets.gltf import Gltf, read_gltf
from kagezou.io.sets.gltf_accessors import count_of, numbers
from kagezou.io.sets.gltf_extensions import extension_notes, refused
from kagezou.io.sets.gltf_nodes import RESTS, SceneNodes, placed, scene_nodes
from kagezou.io.sets.gltf_notes import notes_of
from kagezou.io.sets.gltf_shapes import Shape, has_triangles, joint_places, moved_by, posed, shape_of, sizes_of
from kagezou.io.sets.gltf_tree import SHAPELESS, Tree, damaged, entry_of, extension_of, list_of
from kagezou.io.sets.triangles import Triangles, joined
from kagezou.message import Message

_INSTANCING = "EXT_mesh_gpu_instancing"
_PARTS = {"translation": ("TRANSLATION", "VEC3"), "rotation": ("ROTATION", "VEC4"), "scale": ("SCALE", "VEC3")}


def read_gltf_meshes(path: Path, most_triangles: int) -> Triangles:
    """Return the triangles of a file's scene as it stands without its animations.

    Raises
    ------
    InputProblem
        The file does not hold what it claims, refers to something outside its folder, requires what is not done, or
        has too many triangles.
    """
    file = read_gltf(path)
    try:
        problem = refused(file)
        if problem is not None:
            raise problem
        scene = scene_nodes(file)
        _check_sizes(file, scene, most_triangles)
        found = joined(_Placing(file, scene).every())
        notes = (*file.notes, *extension_notes(file), *scene.notes, *notes_of(file, scene))
        return Triangles(found.points, found.corners, notes)
    except SHAPELESS as error:
        raise damaged(path) from error


def _check_sizes(file: Gltf, scene: SceneNodes, most_triangles: int) -> None:
    """See that nothing becomes too large by being placed many times."""
    total = corners = 0
    sizes: dict[int, tuple[int, int]] = {}
    for node in _with_mesh(file, scene):
        index = node["mesh"]
        parts = entry_of(file.path, file.tree, "meshes", index)["primitives"]
        if index not in sizes:
            each = [sizes_of(file, part) for part in parts if has_triangles(part)]
            sizes[index] = sum(size[0] for size in each), sum(size[1] for size in each)
        times = _instances(file, node)
        total += sizes[index][0] * times
        corners += sizes[index][1] * times
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


def _with_mesh(file: Gltf, scene: SceneNodes) -> list[Tree]:
    nodes = list_of(file.path, file.tree, "nodes")
    return [nodes[number] for number in scene.numbers if "mesh" in nodes[number]]


def _instances(file: Gltf, node: Tree) -> int:
    """Return how many times a node puts its mesh."""
    more = extension_of(node, _INSTANCING)
    counts = {
        count_of(file, more["attributes"][name], kind)
        for name, kind in _PARTS.values()
        if more is not None and name in more["attributes"]
    }
    if len(counts) > 1:
        raise ValueError(counts)
    return counts.pop() if counts else 1


@dataclass(slots=True)
class _Placing:
    """The meshes of a file being placed; one that is placed again is decoded once."""

    file: Gltf
    scene: SceneNodes
    shapes: dict[tuple[int, tuple[float, ...]], list[Shape]] = field(default_factory=dict)

    def every(self) -> list[Triangles]:
        nodes = list_of(self.file.path, self.file.tree, "nodes")
        every = [number for number in self.scene.numbers if "mesh" in nodes[number]]
        return [
            _turned_right(Triangles(points, shape.corners), place)
            for number in every
            for shape in self._shapes(nodes[number])
            for points, place in self._stands(shape, nodes[number], self.scene.places[number])
        ]

    def _shapes(self, node: Tree) -> list[Shape]:
        mesh = entry_of(self.file.path, self.file.tree, "meshes", node["mesh"])
        weights = np.array(node.get("weights") or mesh.get("weights") or (), np.float64)
        key = node["mesh"], tuple(weights.tolist())
        if key not in self.shapes:
            self.shapes[key] = [
                shape_of(self.file, part, weights) for part in mesh["primitives"] if has_triangles(part)
            ]
        return self.shapes[key]

    def _stands(self, shape: Shape, node: Tree, place: Matrix) -> list[tuple[Matrix, Matrix]]:
        """Return the points of a shape for each time that a node puts it, and where."""
        if "skin" in node and shape.joints.size:
            joints = joint_places(self.file, node["skin"], self.scene.places)
            return [(posed(shape, joints, place), joints[0])]
        return [(moved_by(each, shape.points), each) for each in self._places(node, place)]

    def _places(self, node: Tree, place: Matrix) -> list[Matrix]:
        more = extension_of(node, _INSTANCING)
        count = _instances(self.file, node)
        if more is None:
            return [place]
        columns = [
            numbers(self.file, more["attributes"][name], kind)
            if name in more["attributes"]
            else np.tile(np.array(RESTS[part], np.float64), (count, 1))
            for part, (name, kind) in _PARTS.items()
        ]
        return [place @ placed(*parts) for parts in zip(*columns, strict=True)]


def _turned_right(made: Triangles, place: Matrix) -> Triangles:
    """Return triangles whose fronts are in front again where a place mirrors them."""
    return Triangles(made.points, made.corners[:, ::-1]) if np.linalg.det(place[:3, :3]) < 0 else made
