"""Where a ray first meets a mesh."""

import numpy as np

from kagezou.geometry.mesh import Mesh
from kagezou.geometry.vectors import Matrix, Vector3

_EDGE_ON = 1e-12
_INSIDE = -1e-9


def first_hit(mesh: Mesh, start: Matrix, direction: Matrix) -> Vector3 | None:
    """Return the nearest point before ``start`` along a ray, in the mesh's coordinates; None where it meets nothing.

    Both sides of a triangle count (Möller and Trumbore 1997, over all triangles at once).
    """
    a, b, c = (mesh.vertices[mesh.triangles[:, corner]] for corner in range(3))
    ab, ac = b - a, c - a
    across = np.cross(direction, ac)
    determinant = np.einsum("ij,ij->i", ab, across)
    facing = np.abs(determinant) > _EDGE_ON * np.linalg.norm(ab, axis=1) * np.linalg.norm(across, axis=1)
    inverse = np.divide(1.0, determinant, out=np.zeros_like(determinant), where=facing)
    away = start - a
    u = np.einsum("ij,ij->i", away, across) * inverse
    turned = np.cross(away, ab)
    v = np.einsum("j,ij->i", direction, turned) * inverse
    part = np.einsum("ij,ij->i", ac, turned) * inverse
    met = facing & (u >= _INSIDE) & (v >= _INSIDE) & (u + v <= 1 - _INSIDE) & (part > 0)
    if not met.any():
        return None
    x, y, z = start + float(part[met].min()) * direction
    return (float(x), float(y), float(z))
