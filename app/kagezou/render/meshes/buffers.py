"""The meshes of a set on the graphics card: their corners to be drawn, and their triangles to be asked about."""

from collections.abc import Callable, Sequence
from ctypes import c_void_p
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.mesh import Mesh
from kagezou.geometry.vectors import Matrix
from kagezou.render.gpu.gl import GL, deleted, made
from kagezou.render.gpu.program import Program
from kagezou.render.gpu.targets import Format, Texture
from kagezou.render.prepare.clusters import Clusters, near_together
from kagezou.scene.pieces import PieceScene

_ROW_TRIANGLES = 1024
"""As ``meshes/triangles.glsl`` has it."""

_PART_TEXELS = 4

_TRIANGLE_BYTES = 12

RECEIVES, CASTS, UNDER = 1, 2, 16
"""Flags of a triangle."""

FLAG_OF_DISPLAY = {"none": 0, "wireframe": 4, "clay": 8}


@dataclass(frozen=True, slots=True, eq=False)
class PlacedMesh:
    """A mesh and the piece that places it."""

    mesh: Mesh
    piece: PieceScene

    def places(self) -> Matrix:
        """Return its vertices (N, 3), world px."""
        assert self.piece.mesh is not None
        matrix = np.array(self.piece.mesh.world_from_mesh)
        return np.asarray(self.mesh.vertices @ matrix[:3, :3].T + matrix[:3, 3])

    def is_like(self, other: "PlacedMesh") -> bool:
        """Whether it would be the same on the card."""
        return self.mesh is other.mesh and self.piece == other.piece

    @property
    def flags(self) -> int:
        """The flags of its triangles."""
        piece = self.piece
        switches = (RECEIVES, piece.receives), (CASTS, piece.casts), (UNDER, piece.is_under)
        return FLAG_OF_DISPLAY[piece.display] | sum(flag for flag, is_set in switches if is_set)


class MeshBuffers:
    """All meshes of a set, their numbers around one origin.

    Parameters
    ----------
    placed
        One at least.
    """

    def __init__(self, placed: Sequence[PlacedMesh]) -> None:
        self.placed = tuple(placed)
        places = [each.places() for each in placed]
        world = np.concatenate(places)
        self.origin: Matrix = (world.min(axis=0) + world.max(axis=0)) / 2 if len(world) else np.zeros(3)
        self.places: Matrix = world - self.origin
        """(N, 3): vertices around the origin, px."""
        starts = np.cumsum([0, *(len(each) for each in places)])
        corners = [each.mesh.triangles + start for each, start in zip(placed, starts, strict=False)]
        corners = [each[near_together(self.places[each])] for each in corners]
        counts = [len(each) for each in corners]
        self._clusters = [Clusters.of(self.places[each]) for each in corners]
        self._starts = [int(start) for start in starts]
        self._firsts = [int(first) for first in np.cumsum([0, *counts])]
        self._triangles = np.ascontiguousarray(np.concatenate(corners), dtype=np.uint32)
        self.texture = self._texture(np.repeat([each.flags for each in placed], counts))
        self._upload()

    def is_of(self, placed: Sequence[PlacedMesh]) -> bool:
        """Whether it was made of these."""
        return len(placed) == len(self.placed) and all(
            mine.is_like(other) for mine, other in zip(self.placed, placed, strict=True)
        )

    def draw(self, program: Program, wanted: Callable[[PieceScene], bool], clip_rows: Matrix) -> None:
        """Draw the meshes of the wanted pieces with a program in use, telling it the number of the first triangle.

        Parameters
        ----------
        clip_rows
            (4, 4): the map to clip space that the program draws with; what lies beyond need not be drawn.
        """
        GL.glBindVertexArray(self._array)
        for start, clusters, each in zip(self._firsts, self._clusters, self.placed, strict=False):
            for first, count in clusters.runs(clip_rows) if wanted(each.piece) else ():
                program.use({"u_first": start + first})
                GL.glDrawElements(
                    GL.GL_TRIANGLES, count * 3, GL.GL_UNSIGNED_INT, c_void_p((start + first) * _TRIANGLE_BYTES)
                )

    def hulls_of(self, wanted: Callable[[PieceScene], bool]) -> Matrix:
        """Return hulls (8, 3, N) around all of the meshes of the wanted pieces, around the origin."""
        pairs = zip(self._clusters, self.placed, strict=True)
        hulls = [clusters.hulls() for clusters, each in pairs if wanted(each.piece)]
        return np.concatenate([np.zeros((8, 3, 0)), *hulls], axis=2)

    def line_ends(self, wanted: Callable[[PieceScene], bool]) -> Matrix:
        """Return the ends (N, 2, 3) of the lines of the meshes of the wanted pieces, world px."""
        starts = zip(self._starts, self.placed, strict=False)
        lines = [each.mesh.lines + start for start, each in starts if wanted(each.piece)]
        joined = np.concatenate([np.zeros((0, 2), np.int64), *lines])
        return np.asarray(self.places[joined] + self.origin)

    def close(self) -> None:
        """Give the memory back."""
        self.texture.close()
        for buffer in (self._places_buffer, self._triangles_buffer):
            deleted(GL.glDeleteBuffers, buffer)
        deleted(GL.glDeleteVertexArrays, self._array)

    def _texture(self, flags: NDArray[np.int64]) -> Texture:
        """Return the triangles as ``meshes/triangles.glsl`` wants them."""
        corners = self.places[self._triangles]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
        rows = max(-(-len(corners) // _ROW_TRIANGLES), 1)
        table = np.zeros((rows * _ROW_TRIANGLES, _PART_TEXELS, 4), np.float32)
        table[: len(corners), :3, :3] = corners
        table[: len(corners), 0, 3] = flags
        table[: len(corners), 3, :3] = normals
        table[: len(corners), 3, 3] = -np.einsum("ij,ij->i", normals, corners[:, 0])
        texture = Texture(_ROW_TRIANGLES * _PART_TEXELS, rows, Format.FLOAT4)
        texture.upload(table.reshape(rows, _ROW_TRIANGLES * _PART_TEXELS, 4))
        return texture

    def _upload(self) -> None:
        self._array = made(GL.glGenVertexArrays)
        self._places_buffer, self._triangles_buffer = made(GL.glGenBuffers), made(GL.glGenBuffers)
        GL.glBindVertexArray(self._array)
        places = np.ascontiguousarray(self.places, dtype=np.float32)
        for kind, buffer, numbers in (
            (GL.GL_ARRAY_BUFFER, self._places_buffer, places),
            (GL.GL_ELEMENT_ARRAY_BUFFER, self._triangles_buffer, self._triangles),
        ):
            GL.glBindBuffer(kind, buffer)
            GL.glBufferData(kind, numbers.nbytes, c_void_p(numbers.ctypes.data), GL.GL_STATIC_DRAW)
        GL.glEnableVertexAttribArray(0)
        GL.glVertexAttribPointer(0, 3, GL.GL_FLOAT, False, 12, c_void_p(0))  # noqa: FBT003 - the call's own order
        GL.glBindVertexArray(0)
