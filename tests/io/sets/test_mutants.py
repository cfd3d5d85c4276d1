"""Changed files of every format: a set or a sentence, never anything else."""

from fractions import Fraction
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest

from kagezou.errors import InputProblem
from kagezou.io.sets.cameras import cameras_of, up_axis_of
from kagezou.io.sets.mesh_cache import read_set
from tests.io.sets.mutants import mutants, originals

COUNTS = {".glb": 120, ".gltf": 120, ".obj": 120, ".ply": 120, ".stl": 120, ".usda": 6, ".usdc": 6, ".usdz": 6}
"""How many of each; a file of USD needs a process."""


def reads_or_refuses(path: Path) -> bool:
    """Ask a file for all it may hold, and return whether its triangles could be had."""
    is_read = False
    try:
        mesh = read_set(path).mesh
        is_read = True
        assert np.isfinite(mesh.vertices).all()
        assert 0 <= mesh.triangles.min() <= mesh.triangles.max() < len(mesh.vertices)
    except InputProblem as problem:
        assert "\n" not in str(problem)  # noqa: PT017 - either outcome is right, a third one is not
    for ask in (up_axis_of, lambda of: cameras_of(of, Fraction(24))):
        try:
            ask(path)
        except InputProblem as problem:
            assert "\n" not in str(problem)  # noqa: PT017
    return is_read


@pytest.mark.parametrize("suffix", COUNTS)
def test_changed_files_are_a_set_or_a_sentence(tmp_path: Path, suffix: str) -> None:
    is_usd = suffix.startswith(".usd")
    if is_usd and find_spec("pxr") is None:
        pytest.skip("the package usd-core is not installed")
    original = originals(tmp_path, with_usd=is_usd)[suffix]
    path = tmp_path / f"changed{suffix}"
    path.write_bytes(original)
    assert reads_or_refuses(path)
    for data in mutants(original, COUNTS[suffix], seed=len(suffix)):
        path.write_bytes(data)
        reads_or_refuses(path)
