"""How a card leans: turned about the vertical by its tilt, and stood up along the ground's normal."""

from collections.abc import Iterable
from dataclasses import dataclass
from math import hypot
from typing import Final

import numpy as np

from kagezou.geometry.camera import Camera, project
from kagezou.geometry.ground import Plane
from kagezou.geometry.vectors import Point2, Vector3

_STEEPEST: Final = 3.73
"""dz/dy of a card that is stood up no further: 75° away from the screen."""

_LEAST_NEARNESS: Final = 0.2
"""How much of a foot's distance to the eye, at least, is left where the card would be seen edge-on."""

_ALONG_PX: Final = 100.0


@dataclass(frozen=True, slots=True)
class Lean:
    """The slopes that all of a card has beside its own relief.

    Parameters
    ----------
    across, down
        dz/dx and dz/dy.
    upright
        How far the card is stood up: 0 parallel to the screen, 1 along the ground's normal. Less than was asked for
        where it would be seen edge-on.
    """

    across: float = 0.0
    down: float = 0.0
    upright: float = 0.0

    @staticmethod
    def of(camera: Camera, ground: Plane, feet: Iterable[Point2], slope: float, upright: float) -> "Lean":
        """Return the lean of a card with feet at canvas points, turned by dz/dx = ``slope`` and stood up."""
        nx, ny, nz = ground.normal
        flat = nx * nx + ny * ny
        if upright <= 0 or flat < 1e-12:
            return Lean(slope)
        across, down = nz * nx / flat, nz * ny / flat
        part = min(upright, _STEEPEST / max(hypot(across, down), 1e-12))
        ex, ey, distance, w = camera.eye
        if w:
            toward = max((-across * (x - ex) - down * (y - ey) for x, y in feet), default=0.0)
            part = min(part, (1.0 - _LEAST_NEARNESS) * distance / max(toward, 1e-12))
        return Lean(slope + part * across, part * down, part)

    @property
    def normal(self) -> Vector3:
        """The normal, z > 0, of a card without relief."""
        return (-self.across, -self.down, 1.0)

    @property
    def rising(self) -> Vector3:
        """The direction in which the card stands up from each of its feet."""
        return (0.0, -1.0, -self.down)

    def depth_of(self, place: Vector3) -> float:
        """Return the depth a world place has before the card leans."""
        return place[2] - self.across * place[0] - self.down * place[1]

    def seen_at(self, camera: Camera, depth: float, point: Point2) -> Vector3:
        """Return the world place seen at a canvas point on a card without relief, given by its depth."""
        ex, ey, distance, w = camera.eye
        x, y = point
        falling = w * (self.across * (x - ex) + self.down * (y - ey)) / distance + 1.0
        z = (depth + self.across * x + self.down * y) / falling
        return (x + w * (ex - x) * z / distance, y + w * (ey - y) * z / distance, z)

    def column(self, camera: Camera, foot: Point2, place: Vector3) -> Vector3:
        """Return the canvas line, a form that is positive to the right, on which the card rises over a place.

        ``foot`` is the canvas point at which the place is seen.
        """
        if self.down == 0 or not camera.eye[3]:
            return (1.0, 0.0, -foot[0])
        x, y, z = place
        dx, dy, dz = (_ALONG_PX * each for each in self.rising)
        return line_through(project(camera.canvas_from_world(), (x + dx, y + dy, z + dz, 1.0)), foot)

    def row(self, camera: Camera, place: Vector3) -> Vector3:
        """Return the canvas line, a form that is positive upward, on which the card goes on across from a place."""
        x, y, z = place
        ahead = (x + _ALONG_PX, y, z + _ALONG_PX * self.across, 1.0)
        start = project(camera.canvas_from_world(), (x, y, z, 1.0))
        return line_through(start, project(camera.canvas_from_world(), ahead))


def line_through(a: Point2, b: Point2) -> Vector3:
    """Return the canvas line from a to b, a form of unit length, positive upward where b is at the right."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    length = float(np.hypot(dx, dy))
    x, y = dy / length, -dx / length
    return (x, y, -x * a[0] - y * a[1])
