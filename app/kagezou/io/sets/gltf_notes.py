"""What of a glTF file is not used or had to be assumed."""

from kagezou.io.sets.camera_poses import is_mirrored
from kagezou.io.sets.gltf import Gltf, named
from kagezou.io.sets.gltf_nodes import SceneNodes
from kagezou.io.sets.gltf_shapes import POINTS, has_triangles
from kagezou.io.sets.gltf_tree import Tree, entry_of, list_of
from kagezou.io.sets.triangles import listed
from kagezou.message import Message


def notes_of(file: Gltf, scene: SceneNodes) -> tuple[Message, ...]:
    """Return what is to be said of the meshes, skins, animations and cameras of a file."""
    nodes = list_of(file.path, file.tree, "nodes")
    placed = [(number, nodes[number]) for number in scene.numbers if "mesh" in nodes[number]]
    meshes = [entry_of(file.path, file.tree, "meshes", node["mesh"]) for _, node in placed]
    return (
        *_of_primitives(meshes),
        *_of_poses(file, placed, meshes),
        *_of_animations(file, [number for number, _ in placed]),
        *_of_what_hangs(file, scene, nodes),
    )


def _of_primitives(meshes: list[Tree]) -> tuple[Message, ...]:
    modes = [part.get("mode", 4) for mesh in meshes for part in mesh["primitives"] if not has_triangles(part)]
    lines = (Message("its lines are not used"),) if any(mode != POINTS for mode in modes) else ()
    return (*lines, Message("its single points are not used")) if POINTS in modes else lines


def _of_poses(file: Gltf, placed: list[tuple[int, Tree]], meshes: list[Tree]) -> tuple[Message, ...]:
    notes = []
    if any("skin" in node and list_of(file.path, file.tree, "skins") for _, node in placed):
        notes.append(Message("its skins are posed as their joints stand without animation"))
    weights = [node.get("weights") or mesh.get("weights") or () for (_, node), mesh in zip(placed, meshes, strict=True)]
    if any(any(each) for each in weights):
        notes.append(Message("its morph targets are used with the weights that the file sets at first"))
    return tuple(notes)


def _of_animations(file: Gltf, placed: list[int]) -> tuple[Message, ...]:
    """Return that meshes move in the file, which are read as they stand without that."""
    joints = [joint for skin in list_of(file.path, file.tree, "skins") for joint in skin.get("joints", ())]
    moving: set[object] = set()
    for number in (*placed, *joints):
        above = number
        while above is not None and above not in moving:
            moving.add(above)
            above = file.parents.get(above)
    targets = [
        channel.get("target", {}).get("node")
        for animation in list_of(file.path, file.tree, "animations")
        for channel in animation.get("channels", ())
    ]
    if not any(target in moving for target in targets):
        return ()
    return (Message("its meshes are animated: they are used as they stand without that"),)


def _of_what_hangs(file: Gltf, scene: SceneNodes, nodes: list[Tree]) -> tuple[Message, ...]:
    """Return which cameras cannot be as they are in the file, and what is there that hangs on no node."""
    used = {node["mesh"] for node in nodes if "mesh" in node}
    meshes = [mesh for mesh in range(len(list_of(file.path, file.tree, "meshes"))) if mesh not in used]
    cameras = list_of(file.path, file.tree, "cameras")
    seen = {node.get("camera") for node in nodes}
    alone = [named(camera, number) for number, camera in enumerate(cameras) if number not in seen]
    notes = []
    mirrored = [
        named(node, number)
        for number, node in enumerate(nodes)
        if "camera" in node and is_mirrored(scene.places[number])
    ]
    if mirrored:
        notes.append(Message("its cameras {names} are mirrored, which is not done", names=listed(mirrored)))
    if meshes:
        notes.append(Message("{count} of its meshes hang on no node and are not used", count=len(meshes)))
    if alone:
        notes.append(Message("its cameras {names} hang on no node and are not used", names=listed(alone)))
    return tuple(notes)
