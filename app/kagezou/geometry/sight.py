"""Places of the world as the camera sees them, without ever blowing up.

Something may stand beside or behind the eye, where a true projection flies off to infinity and comes back mirrored.
What is drawn over the picture therefore divides by no less than ``MIN_DEPTH``: equal to the camera's picture for
everything before that depth, continuous beyond it, and still invertible on every plane.
"""

from typing import Final

from kagezou.geometry.camera import Camera
from kagezou.geometry.vectors import Point2, Vector3

MIN_DEPTH: Final = 0.05
"""The least part of the eye's distance from the drawing at which things are still seen in true perspective."""


def seen(camera: Camera, point: Vector3) -> Point2:
    """Return where a world point is shown on the canvas, canvas px."""
    depth = max(depth_of(camera, point), MIN_DEPTH)
    ex, ey, _, ew = camera.eye
    if ew == 0:
        return (point[0], point[1])
    return (ex + (point[0] - ex) / depth, ey + (point[1] - ey) / depth)


def depth_of(camera: Camera, point: Vector3) -> float:
    """Return the distance before the eye as part of the drawing's: 1 at the drawing, 0 at the eye."""
    _, _, distance, w = camera.eye
    return 1.0 - w * point[2] / distance
