"""Set files changed at random: bytes, numbers, pieces taken out, doubled or cut off."""

import random
import re
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

import numpy as np

from tests.io.sets import set_files
from tests.io.sets.mesh_files import TRIANGLE, glb, gltf, tree_with
from tests.io.sets.usd_files import SKIN, instancer, mesh

_NUMBER = re.compile(rb"-?[0-9]+(?:\.[0-9]+)?")
_ODD = [b"0", b"-1", b"1e39", b"nan", b"4294967295", b"99999999999999999999", b"-2147483648", b"0.5", b"65536", b""]


def rich_gltf() -> tuple[dict[str, object], bytes]:
    """Return a tree with a skin, sparse numbers, instances, morph targets, a camera and its animation."""
    corners = np.array([0, 1, 2], "<u2")
    moves = np.array([[0, 0, 0], [10, 0, 0], [0, 0, 20]], "<f4")
    tree, data = tree_with([TRIANGLE, corners, moves, np.array([[0, 0, 0, 0]] * 3, "|u1"),
                            np.array([[1, 0, 0, 0]] * 3, "<f4"), np.array([0, 1], "<f4"), moves[:2]])  # fmt: skip
    tree["accessors"].append({"componentType": 5126, "count": 3, "type": "VEC3", "sparse": {
        "count": 2, "indices": {"bufferView": 1, "componentType": 5123}, "values": {"bufferView": 2}}})  # fmt: skip
    skinned = {"attributes": {"POSITION": 0, "JOINTS_0": 3, "WEIGHTS_0": 4}, "indices": 1}
    tree |= {
        "scenes": [{"nodes": [0, 1, 2, 3]}, {"nodes": []}],
        "nodes": [{"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 2}}}},
                  {"mesh": 1, "skin": 0, "weights": [0.5]},
                  {"rotation": [0, 0, 0, 1], "extensions": {"KHR_node_visibility": {"visible": True}}},
                  {"camera": 0, "translation": [0, 1, 5], "children": [4]}, {"camera": 1}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "mode": 5}]},
                   {"primitives": [{**skinned, "targets": [{"POSITION": 7}]}]}],
        "skins": [{"joints": [2]}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 1.0, "znear": 0.1}},
                    {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 0, "zfar": 9}}],
        "animations": [{"samplers": [{"input": 5, "output": 6}],
                        "channels": [{"sampler": 0, "target": {"node": 3, "path": "translation"}}]}],
    }  # fmt: skip
    return tree, data


_STAGE = (
    "#usda 1.0\n(\n startTimeCode = 1\n endTimeCode = 3\n)\n"
    + mesh("m", "int[] holeIndices = [3]", (1, 2, 3))
    + instancer("point3f[] positions = [(0,0,0), (2,0,0)]\nint[] protoIndices = [0, 0]\nint64[] invisibleIds = [1]")
    + '\ndef Camera "c" {\n float focalLength.timeSamples = {1: 30, 3: 40}\n}\ndef Cone "k" {\n double radius = 2\n}\n'
    + SKIN % mesh("m").partition("{")[2].rpartition("}")[0]
)


def originals(folder: Path, *, with_usd: bool) -> dict[str, bytes]:
    """Return a file of every format by its suffix; those of USD where the package for it is there."""
    tree, data = rich_gltf()
    made = {
        ".glb": glb(folder / "rich.glb", tree, data).read_bytes(),
        ".gltf": gltf(folder / "rich.gltf", tree, data).read_bytes(),
        ".obj": (set_files.CUBE_OBJ + "f 1 2 4 3 7\nl 1 2\nf -1/2/3 -2//1 -3/1\n").encode(),
        ".ply": set_files.CUBE_PLY.encode(),
        ".stl": set_files.CUBE_STL,
    }
    if with_usd:
        sdf, utils = import_module("pxr.Sdf"), import_module("pxr.UsdUtils")
        text = folder / "rich.usda"
        text.write_text(_STAGE)
        sdf.Layer.FindOrOpen(str(text)).Export(str(folder / "rich.usdc"))
        utils.CreateNewUsdzPackage(str(text), str(folder / "rich.usdz"))
        made |= {suffix: (folder / f"rich{suffix}").read_bytes() for suffix in (".usda", ".usdc", ".usdz")}
    return made


def mutants(original: bytes, count: int, seed: int) -> Iterator[bytes]:
    """Yield so many changed files, the same ones for a seed."""
    draw = random.Random(seed)
    for _ in range(count):
        data = bytearray(original)
        for _ in range(draw.choice((1, 1, 2, 4, 8))):
            _change(data, draw)
        yield bytes(data)


def _change(data: bytearray, draw: random.Random) -> None:
    if not data:
        return
    at = draw.randrange(len(data))
    how = draw.randrange(7)
    if how == 0:
        data[at] ^= 1 << draw.randrange(8)
    elif how == 1:
        data[at] = draw.choice((0, 1, 127, 128, 255))
    elif how == 2:
        data[at : at + 4] = draw.choice((b"\xff\xff\xff\xff", b"\0\0\0\0", b"\0\0\xc0\x7f", b"\xff\xff\xff\x7f"))
    elif how == 3:
        found = list(_NUMBER.finditer(bytes(data[at : at + 200])))
        if found:
            chosen = draw.choice(found)
            data[at + chosen.start() : at + chosen.end()] = draw.choice(_ODD)
    elif how == 4:
        del data[at : at + draw.randrange(1, 40)]
    elif how == 5:
        data[at:at] = data[at : at + draw.randrange(1, 60)]
    elif draw.random() < 0.3:
        del data[at:]
