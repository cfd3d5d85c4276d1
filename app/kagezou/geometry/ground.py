"""The ground plane seen at a declination, and any other flat receiver of shadow (spec 1)."""

from dataclasses import dataclass
from functools import lru_cache
from math import cos, radians, sin

import numpy as np

from kagezou.geometry.camera import Camera
from kagezou.geometry.vectors import Matrix, Point2, Vector3, Vector4, plane_through


@dataclass(frozen=True, slots=True)
class Plane:
    """A flat receiver: an origin and two orthonormal axes, world px.

    ``u`` runs along the contact line, ``v`` away from it toward the viewer, ``normal`` out of the lit side.
    """

    origin: Vector3
    u: Vector3
    v: Vector3
    normal: Vector3

    @property
    def equation(self) -> Vector4:
        """The plane (n, d): n·X + d is the height over the receiver in px."""
        return plane_through(self.origin, self.normal)

    def world_from_plane(self) -> Matrix:
        """Return the (4, 3) map from plane coordinates (u, v, 1) in px to the world."""
        return np.array([[*self.u, 0.0], [*self.v, 0.0], [*self.origin, 1.0]], dtype=np.float64).T

    def point(self, u: float, v: float) -> Vector3:
        """Return the world point at plane coordinates (u, v) in px."""
        x, y, z, _ = self.world_from_plane() @ np.array([u, v, 1.0])
        return (float(x), float(y), float(z))


def ground_plane(position: Point2, roll_deg: float, declination_deg: float) -> Plane:
    """Return the ground through ``position`` (canvas px, z = 0).

    Parameters
    ----------
    position
        ``ground.position``.
    roll_deg
        ``ground.roll`` r: the turn of the contact line in the picture.
    declination_deg
        ``ground.declination`` θ: the angle between the silhouette plane and the ground; 90 is seen edge-on.
    """
    r, theta = radians(roll_deg), radians(declination_deg)
    return Plane(
        origin=(position[0], position[1], 0.0),
        u=(cos(r), sin(r), 0.0),
        v=(-sin(r) * cos(theta), cos(r) * cos(theta), sin(theta)),
        normal=(sin(r) * sin(theta), -cos(r) * sin(theta), cos(theta)),
    )


def canvas_from_plane(camera: Camera, plane: Plane) -> Matrix:
    """Return the (3, 3) map from plane coordinates (u, v, 1) to canvas px; w > 0 in front of the eye."""
    return camera.canvas_from_world() @ plane.world_from_plane()


@lru_cache(maxsize=256)
def world_from_canvas_on(camera: Camera, plane: Plane) -> Matrix | None:
    """Return the (4, 3) map that lifts canvas px along the view ray onto the plane.

    Its last row is scaled so that w > 0 exactly where the plane is seen in front of the eye.
    None where the plane is seen edge-on and has no picture. The array is kept and must not be changed.
    """
    forward = canvas_from_plane(camera, plane)
    determinant = float(np.linalg.det(forward))
    if abs(determinant) < 1e-9:
        return None
    # For a homography H with w(p) > 0 in front, H⁻¹ maps (x, y, 1) to a multiple 1/w(p) > 0 of (u, v, 1).
    lift = plane.world_from_plane() @ np.linalg.inv(forward)
    lift.flags.writeable = False
    return lift


def place_on(camera: Camera, plane: Plane, point: Point2) -> Vector3 | None:
    """Return the world point of the plane seen at a canvas point, or None at and above its horizon."""
    lift = world_from_canvas_on(camera, plane)
    if lift is None:
        return None
    x, y, z, w = lift @ np.array([*point, 1.0])
    if w <= 1e-9:
        return None
    return (float(x / w), float(y / w), float(z / w))
