"""glTF files compressed with Draco: read where its package is installed, else a sentence says what is missing."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from kagezou.errors import InputProblem
from kagezou.io.sets import gltf_extensions
from kagezou.io.sets.mesh_cache import read_set
from tests.io.sets.mesh_files import glb, tree_with
from tests.io.sets.set_files import CUBE, CUBE_FACES

NAME = "KHR_draco_mesh_compression"


def packed_file(packed: bytes, *, is_required: bool = True) -> tuple[dict[str, Any], bytes]:
    """Return a cube of which the numbers are packed, or beside it as they are if that is not required."""
    tree, data = tree_with([CUBE.astype("<f4"), CUBE_FACES.reshape(-1).astype("<u2")])
    if is_required:
        tree["accessors"] = [
            {key: each[key] for key in ("componentType", "count", "type")} for each in tree["accessors"]
        ]
    tree["bufferViews"].append({"buffer": 0, "byteOffset": len(data), "byteLength": len(packed)})
    extensions = {NAME: {"bufferView": 2, "attributes": {"POSITION": 0}}}
    part = {"attributes": {"POSITION": 0}, "indices": 1, "extensions": extensions}
    tree |= {"scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}], "meshes": [{"primitives": [part]}],
             "extensionsUsed": [NAME], "extensionsRequired": [NAME] if is_required else []}  # fmt: skip
    data += packed
    return {**tree, "buffers": [{"byteLength": len(data)}]}, data


def test_a_cube_is_unpacked(tmp_path: Path) -> None:
    draco = pytest.importorskip("DracoPy", reason="the package DracoPy is not installed")
    packed = draco.encode(CUBE, CUBE_FACES, preserve_order=True)
    found = read_set(glb(tmp_path / "a.glb", *packed_file(packed)))
    assert (len(found.mesh.vertices), len(found.mesh.triangles)) == (8, 12)
    assert found.mesh.corners[1] == pytest.approx([1, 1, 1], abs=1e-3)
    assert not found.notes
    for broken in (packed[:40], b"DRACO" + bytes(40), b""):
        with pytest.raises(InputProblem):
            read_set(glb(tmp_path / "b.glb", *packed_file(broken)))


def test_without_the_package_the_command_is_named_or_what_lies_beside_is_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(gltf_extensions, "find_spec", lambda _: None)
    with pytest.raises(InputProblem, match="pip install 'DracoPy>="):
        read_set(glb(tmp_path / "a.glb", *packed_file(b"DRACO")))
    beside = read_set(glb(tmp_path / "b.glb", *packed_file(b"DRACO", is_required=False)))
    assert np.array_equal(beside.mesh.corners[1], [1, 1, 1])
