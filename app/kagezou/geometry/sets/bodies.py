"""The convex bodies that set pieces are made of: flat-faced solids, balls and drums, in world px."""

from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from kagezou.geometry.ground import Plane
from kagezou.geometry.vectors import Matrix, Vector3, Vector4, dot, plane_through


@dataclass(frozen=True, slots=True)
class Facet:
    """A flat convex face.

    Parameters
    ----------
    corners
        In order around it, at least three, world px.
    normal
        Unit length, out of the body.
    """

    corners: tuple[Vector3, ...]
    normal: Vector3

    @property
    def equation(self) -> Vector4:
        """The plane (n, d): positive outside of the body."""
        return plane_through(self.corners[0], self.normal)

    def plane(self, *, is_turned: bool) -> Plane:
        """Return the facet as a receiver, u along its first edge; turned, it is lit from the inside."""
        sign = -1.0 if is_turned else 1.0
        normal = np.array(self.normal) * sign
        first, second = (np.array(corner) for corner in self.corners[:2])
        u = (second - first) / np.linalg.norm(second - first)
        return Plane(self.corners[0], vector(u), vector(np.cross(normal, u)), vector(normal))


@dataclass(frozen=True, slots=True)
class Solid:
    """A convex body of flat faces.

    Parameters
    ----------
    facets
        All of them.
    is_sheet
        Whether it is one facet without thickness, seen and lit from both sides.
    """

    facets: tuple[Facet, ...]
    is_sheet: bool = False


@dataclass(frozen=True, slots=True)
class Ball:
    """A sphere."""

    centre: Vector3
    radius_px: float

    @property
    def quadric(self) -> Matrix:
        """The (4, 4) form Q with XᵀQX < 0 inside."""
        form = np.eye(4)
        form[:3, 3] = form[3, :3] = -np.array(self.centre)
        form[3, 3] = dot(self.centre, self.centre) - self.radius_px**2
        return form


@dataclass(frozen=True, slots=True)
class Drum:
    """A straight round cylinder with flat ends.

    Parameters
    ----------
    foot
        The centre of its lower end.
    axis
        Unit length, toward the upper end.
    radius_px, height_px
        Its measures.
    """

    foot: Vector3
    axis: Vector3
    radius_px: float
    height_px: float

    @property
    def head(self) -> Vector3:
        """The centre of its upper end."""
        return vector(np.array(self.foot) + self.height_px * np.array(self.axis))

    @property
    def quadric(self) -> Matrix:
        """The (4, 4) form Q of the endless cylinder with XᵀQX < 0 inside."""
        axis, foot = np.array(self.axis), np.array(self.foot)
        across = np.eye(3) - np.outer(axis, axis)
        form = np.zeros((4, 4))
        form[:3, :3] = across
        form[:3, 3] = form[3, :3] = -across @ foot
        form[3, 3] = foot @ across @ foot - self.radius_px**2
        return form

    @property
    def ends(self) -> tuple[Vector4, Vector4]:
        """The planes of the lower and the upper end, positive outside of the body."""
        down = vector(-np.array(self.axis))
        return plane_through(self.foot, down), plane_through(self.head, self.axis)

    def end_plane(self, *, upper: bool) -> Plane:
        """Return one of its ends as a receiver."""
        normal = np.array(self.ends[upper][:3])
        across = np.eye(3)[int(np.argmin(np.abs(normal)))]
        u = np.cross(across, normal)
        u /= np.linalg.norm(u)
        origin = self.head if upper else self.foot
        return Plane(origin, vector(u), vector(np.cross(normal, u)), vector(normal))


Body: TypeAlias = Solid | Ball | Drum


def vector(numbers: Matrix) -> Vector3:
    """Return an array (3,) as plain numbers."""
    x, y, z = (float(number) for number in numbers)
    return (x, y, z)
