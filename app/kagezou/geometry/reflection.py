"""The figure mirrored in the ground: what the eye sees there is what a light at the mirrored eye would cast.

A ray from the eye that meets the ground goes on as if it came from the eye mirrored in the ground. So the reflection
is found by the homographies of shadows (spec 2), with the way away from the mirrored eye in the place of that to the
light.
"""

from typing import Final

from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import Plane
from kagezou.geometry.polygon import clipped, distance_form
from kagezou.geometry.shadow import Cast
from kagezou.geometry.vectors import Matrix, Vector4, height_over

_EDGE_ON: Final = 1e-9
"""The ground is seen edge-on by an eye that is hardly over it."""


def away_from_mirrored_eye(camera: Camera, ground: Plane) -> Vector4 | None:
    """Return what stands in the place of a light L, so that L - w·X is the way of a mirrored ray from a place X.

    For the orthographic camera a direction (w = 0), else minus the mirrored eye (w = -1). None where the eye does not
    look down on the ground.
    """
    height = height_over(ground.equation, camera.eye)
    if height <= _EDGE_ON:
        return None
    x, y, z = (eye - 2 * height * up for eye, up in zip(camera.eye[:3], ground.normal, strict=True))
    return (-x, -y, -z, -camera.eye[3])


def mirrored_region(cast: Cast, polygon: Matrix) -> Matrix:
    """Return the part (N, 2) of a polygon of the canvas whose mirrored rays come to the card's plane at all."""
    return clipped(polygon, distance_form(cast.art_from_canvas[2]))
