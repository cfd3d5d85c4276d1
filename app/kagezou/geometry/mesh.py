"""A triangle mesh: what an imported set is made of."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.vectors import Matrix


@dataclass(frozen=True, slots=True, eq=False)
class Mesh:
    """Triangles of one file, compared by identity; the arrays are kept and must not be changed.

    Parameters
    ----------
    vertices
        (N, 3) float64, in the file's units and axes, all finite.
    triangles
        (M, 3) int32, indices of vertices; the front is where they run anticlockwise.
    lines
        (K, 2) int32, pairs of vertices: creases and borders, what is worth drawing of a wireframe.
    """

    vertices: Matrix
    triangles: NDArray[np.int32]
    lines: NDArray[np.int32]

    def __post_init__(self) -> None:
        for array in (self.vertices, self.triangles, self.lines):
            array.flags.writeable = False

    @property
    def nbytes(self) -> int:
        """The memory it takes."""
        return self.vertices.nbytes + self.triangles.nbytes + self.lines.nbytes

    @property
    def corners(self) -> tuple[Matrix, Matrix]:
        """The lowest and the highest coordinates, (3,) each."""
        return self.vertices.min(axis=0), self.vertices.max(axis=0)
