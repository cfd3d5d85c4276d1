"""How far bodies reach over planes, asked of all bodies of a set at once."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.sets.bodies import Body, Solid
from kagezou.geometry.sets.regions import heights_over
from kagezou.geometry.vectors import Matrix, Vector4


@dataclass(frozen=True, slots=True, eq=False)
class Extents:
    """The bodies of a set, the corners of those with flat faces in one array.

    Parameters
    ----------
    bodies
        All of them.
    corners
        (N, 3): the corners of the solids among them, one after the other, world px.
    starts
        Where those of each solid begin.
    """

    bodies: tuple[Body, ...]
    corners: Matrix
    starts: NDArray[np.int64]

    @staticmethod
    def of(bodies: Sequence[Body]) -> "Extents":
        """Gather the corners of bodies."""
        own = [
            [corner for facet in body.facets for corner in facet.corners] for body in bodies if isinstance(body, Solid)
        ]
        counts = np.array([len(corners) for corners in own], np.int64)
        every = [corner for corners in own for corner in corners]
        return Extents(tuple(bodies), np.array(every, np.float64).reshape(-1, 3), np.cumsum(counts) - counts)

    def over(self, plane: Vector4) -> tuple[tuple[float, float], ...]:
        """Return between which heights over a plane of unit normal each body lies, px, as `heights_over` does."""
        x, y, z = self.corners.T
        # In the order in which one height alone is added up, so that not a digit differs.
        heights = plane[0] * x + plane[1] * y + plane[2] * z + plane[3]
        low, high = (
            each.reduceat(heights, self.starts).tolist() if len(heights) else [] for each in (np.minimum, np.maximum)
        )
        of_solids = zip(low, high, strict=True)
        return tuple(next(of_solids) if isinstance(body, Solid) else heights_over(plane, body) for body in self.bodies)
