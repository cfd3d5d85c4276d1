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


def instancer(more: str, prototypes: str = "", names: str = "</i/p/a>") -> str:
    """Return an instancer of points, whose prototypes hang on it."""
    return f"""def PointInstancer "i" {{
        rel prototypes = [{names}]
        {more}
        def Xform "p" {{
            {prototypes or mesh("a")}
        }}
    }}"""


SKIN = """def SkelRoot "r" {
    def Skeleton "s" (prepend apiSchemas = ["SkelBindingAPI"]) {
        uniform token[] joints = ["a"]
        uniform matrix4d[] bindTransforms = [((1,0,0,0), (0,1,0,0), (0,0,1,0), (0,0,0,1))]
        uniform matrix4d[] restTransforms = [((1,0,0,0), (0,1,0,0), (0,0,1,0), (0,0,0,1))]
        rel skel:animationSource = </r/s/w>
        def SkelAnimation "w" {
            uniform token[] joints = ["a"]
            float3[] translations.timeSamples = {1: [(7,0,0)], 2: [(8,0,0)]}
            quatf[] rotations = [(1,0,0,0)]
            half3[] scales = [(1,1,1)]
        }
    }
    def Mesh "m" (prepend apiSchemas = ["SkelBindingAPI"]) {
        %s
        rel skel:skeleton = </r/s>
        int[] primvars:skel:jointIndices = [0] (
            elementSize = 1
            interpolation = "constant"
        )
        float[] primvars:skel:jointWeights = [1] (
            elementSize = 1
            interpolation = "constant"
        )
    }
}
"""
"""A mesh on a skeleton of one joint; its inner text stands for %s."""


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
