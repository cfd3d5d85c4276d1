"""Meshes made by the tests, and scenes in which they stand."""

from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.ground import Plane
from kagezou.geometry.mesh import Mesh
from kagezou.geometry.sets.bodies import Solid
from kagezou.io.sets.mesh_cache import MeshCache
from kagezou.scene.pieces import MeshPlacement, PieceScene, SetCast
from kagezou.scene.scene import Scene, SetShadow, ShadowLook

Array = NDArray[np.float64]

AS_IT_IS = tuple(tuple(float(i == j) for j in range(4)) for i in range(4))


class Meshes(MeshCache):
    """Hands out meshes that are in no file."""

    def __init__(self) -> None:
        super().__init__()
        self.by_name: dict[str, Mesh] = {}

    def mesh(self, path: Path) -> Mesh:
        return self.by_name[path.name]

    def piece(self, name: str, mesh: Mesh, piece: PieceScene | None = None) -> PieceScene:
        """Return a piece with a mesh in world px: like another one, or one that receives and blocks."""
        self.by_name[name] = mesh
        like = piece or PieceScene(name, name, (), receives=True, blocks=True, casts=False)
        return replace(like, bodies=(), mesh=MeshPlacement(Path(name), AS_IT_IS))


def solid_mesh(piece: PieceScene) -> Mesh:
    """Return the bodies of a flat-faced piece as triangles."""
    vertices: list[tuple[float, float, float]] = []
    triangles: list[tuple[int, int, int]] = []
    for body in piece.bodies:
        assert isinstance(body, Solid)
        for facet in body.facets:
            first = len(vertices)
            vertices += facet.corners
            triangles += [(first, first + k, first + k + 1) for k in range(1, len(facet.corners) - 1)]
    lines = [(a, b) for t in triangles for a, b in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0]))]
    return Mesh(np.array(vertices), np.array(triangles, np.int32), np.array(lines, np.int32))


def heights_mesh(ground: Plane, heights: Array, reach_px: float) -> Mesh:
    """Return a square of the ground, 2·reach wide, raised by heights (N, N) px: 2·(N - 1)² triangles."""
    side = np.linspace(-reach_px, reach_px, len(heights))
    u, v = np.meshgrid(side, side)
    origin, gu, gv, up = (np.array(each) for each in (ground.origin, ground.u, ground.v, ground.normal))
    points = origin + u[..., None] * gu + v[..., None] * gv + heights[..., None] * up
    at = np.arange(heights.size, dtype=np.int32).reshape(heights.shape)
    a, b, c, d = at[:-1, :-1].ravel(), at[:-1, 1:].ravel(), at[1:, 1:].ravel(), at[1:, :-1].ravel()
    triangles = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return Mesh(points.reshape(-1, 3), triangles, np.zeros((0, 2), np.int32))


def waves(count: int, amplitude_px: float, turns: float) -> Array:
    """Return the heights (N, N) of gentle hills."""
    x, y = np.meshgrid(np.linspace(0, turns * 2 * np.pi, count), np.linspace(0, turns * 2 * np.pi, count))
    return np.asarray(amplitude_px * np.sin(x) * np.cos(1.3 * y))


def with_pieces(scene: Scene, pieces: tuple[PieceScene, ...], *, has_ground: bool = True) -> Scene:
    """Return the scene with another set."""
    layers = tuple(
        replace(layer, cast=replace(layer.cast, pieces=pieces, ground_receives=has_ground))
        for layer in scene.layers
        if layer.cast is not None
    )
    shadow = None
    if any(piece.casts for piece in pieces):
        lights = layers[0].cast.lights if layers and layers[0].cast is not None else ()
        cast = SetCast(scene.camera, scene.ground, pieces, lights, has_ground)
        shadow = SetShadow(cast, ShadowLook((0, 0, 0), 0.5, multiply=True))
    return replace(scene, layers=layers, pieces=pieces, set_shadow=shadow)


def as_meshes(scene: Scene, meshes: Meshes) -> Scene:
    """Return the scene with all its flat-faced pieces as meshes."""
    pieces = tuple(meshes.piece(piece.name, solid_mesh(piece), piece) for piece in scene.pieces)
    cast = scene.layers[0].cast
    return with_pieces(scene, pieces, has_ground=cast is None or cast.ground_receives)


def corners_of(scene: Scene, meshes: Meshes) -> Array:
    """Return all triangles (M, 3, 3) of a scene."""
    placed = [meshes.mesh(piece.mesh.path) for piece in scene.pieces if piece.mesh is not None]
    return np.concatenate([mesh.vertices[mesh.triangles] for mesh in placed])
