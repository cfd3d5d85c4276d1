"""The camera: orthographic along −z, or a pinhole whose picture plane is the drawing (spec 1)."""

from dataclasses import dataclass
from math import radians, tan
from typing import Final

import numpy as np

from kagezou.geometry.vectors import Matrix, Point2, Vector4

LEAST_FOV_DEG: Final = 1e-6
"""Below this the eye is farther away than numbers tell from infinity."""


@dataclass(frozen=True, slots=True)
class Camera:
    """A camera that never changes the drawing: z = 0 maps to itself.

    Parameters
    ----------
    width_px, height_px
        Size of the canvas.
    fov_deg
        Vertical field of view; 0 is orthographic.
    """

    width_px: int
    height_px: int
    fov_deg: float = 0.0

    @property
    def eye(self) -> Vector4:
        """The eye in world px: a point, or for the orthographic camera the direction toward the viewer."""
        if self.fov_deg < LEAST_FOV_DEG:
            return (0.0, 0.0, 1.0, 0.0)
        distance = (self.height_px / 2) / tan(radians(self.fov_deg) / 2)
        return (self.width_px / 2, self.height_px / 2, distance, 1.0)

    def canvas_from_world(self) -> Matrix:
        """Return the (3, 4) projection onto z = 0; w > 0 in front of the eye."""
        x, y, distance, w = self.eye
        k = w / distance
        return np.array([[1, 0, -k * x, 0], [0, 1, -k * y, 0], [0, 0, -k, 1]], dtype=np.float64)

    def toward_eye(self, point: Vector4) -> tuple[float, float, float]:
        """Return the direction from a world point toward the eye, not normalised."""
        ex, ey, ez, ew = self.eye
        return (ex - ew * point[0], ey - ew * point[1], ez - ew * point[2])


def project(matrix: Matrix, point: Point2 | Vector4) -> Point2:
    """Apply a projection to a canvas point (for (3, 3)) or a world point (for (3, 4)); return canvas px."""
    source = (*point, 1.0) if len(point) == 2 else point
    x, y, w = matrix @ np.asarray(source, dtype=np.float64)
    return (float(x / w), float(y / w))
