"""USD stages written by hand for the tests."""

from fractions import Fraction
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from kagezou.errors import InputProblem
from kagezou.io.sets import mesh_cache
from kagezou.io.sets.mesh_cache import SetContents
from kagezou.io.sets.usd_child import contents_of
from kagezou.message import Message

SQUARE = """
    point3f[] points = [(0,0,0), (1,0,0), (1,1,0), (0,1,0)]
    int[] faceVertexCounts = [4]
    int[] faceVertexIndices = [0, 1, 2, 3]
"""


def mesh(name: str, more: str = "", move: tuple[float, float, float] | None = None) -> str:
    """Return a unit square, moved if that is asked for."""
    moved = f'double3 xformOp:translate = {move}\nuniform token[] xformOpOrder = ["xformOp:translate"]' if move else ""
    return f'def Mesh "{name}" {{{SQUARE}{more}\n{moved}\n}}\n'


def stage(path: Path, body: str, head: str = "") -> Path:
    """Write a stage of a body, its metadata in front."""
    path.write_text(f"#usda 1.0\n(\n{head}\n)\n{body}")
    return path


def read(path: Path, body: str, head: str = "") -> SetContents:
    """Read a stage of a body, in this process."""
    written = stage(path / "a.usda", body, head)
    with np.errstate(all="ignore"):
        found = contents_of(written, Fraction(24)).triangles
    if isinstance(found, Message):
        raise InputProblem(found)
    return SetContents(mesh_cache._checked(written, found), found.notes)


def said(found: SetContents) -> list[str]:
    return [str(note) for note in found.notes]


def lefts(found: SetContents) -> list[float]:
    """Return where the triangles begin on the first axis, each place once."""
    corners: NDArray[np.float64] = found.mesh.vertices[found.mesh.triangles]
    return sorted(set(np.round(corners[..., 0].min(axis=1), 6).tolist()))
