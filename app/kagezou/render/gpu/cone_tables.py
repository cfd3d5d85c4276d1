"""Cones as ``sets/occlusion_cones.glsl`` wants them: any number in a texture, for places on a curved surface."""

from collections.abc import Iterable

import numpy as np

from kagezou.geometry.sets.occlusion_cones import Cone, Occlusion
from kagezou.geometry.vectors import Matrix
from kagezou.render.gpu.targets import Format, Texture
from kagezou.render.prepare.mask_uniforms import LAST, OVERLAPS
from kagezou.render.prepare.uniforms import Uniform

_ROW_TEXELS = 256

_TABLES = 8
"""A driver waits for what still reads a texture before it is filled anew."""

TABLE_UNIT = 2


class ConeTables:
    """Textures for occlusions, used in turn."""

    def __init__(self) -> None:
        self._textures: list[Texture] = []

    def close(self) -> None:
        """Give the memory back."""
        for texture in self._textures:
            texture.close()
        self._textures.clear()

    def uniforms(
        self, occlusions: Iterable[tuple[Occlusion, int]], world_from_local: Matrix, ball: tuple[Matrix, float]
    ) -> dict[str, Uniform]:
        """Return what ``sets/occlusion_cones.glsl`` wants, its texture bound.

        Parameters
        ----------
        occlusions
            With their flags, those of the eye first.
        world_from_local
            (4, 4), a shift: from the coordinates in which places are given.
        ball
            Middle (3,) and radius of a part of the world that holds all that is asked about.
        """
        table, count = _table(occlusions, world_from_local, ball)
        rows = -(-len(table) // _ROW_TEXELS)
        texture = self._texture(rows)
        padded = np.zeros((rows * _ROW_TEXELS, 4), np.float32)
        padded[: len(table)] = table
        texture.upload(padded.reshape(rows, _ROW_TEXELS, 4))
        texture.bind(TABLE_UNIT)
        return {"u_table": TABLE_UNIT, "u_region_count": count}

    def _texture(self, rows: int) -> Texture:
        """Return the texture that was filled the longest ago, or a new one where it is too small."""
        texture = self._textures.pop(0) if len(self._textures) >= _TABLES else None
        if texture is not None and texture.height_px < rows:
            texture.close()
            texture = None
        if texture is None:
            texture = Texture(_ROW_TEXELS, max(rows, 4), Format.FLOAT4)
        self._textures.append(texture)
        return texture


def _table(
    occlusions: Iterable[tuple[Occlusion, int]], world_from_local: Matrix, ball: tuple[Matrix, float]
) -> tuple[Matrix, int]:
    """Return the rows (N, 4) of a table, the regions first, and how many of those there are."""
    found: list[tuple[Cone, int]] = []
    for occlusion, flags in occlusions:
        cones = [cone for cone in _cones(occlusion) if _may_hold(cone, ball)]
        own = flags | (OVERLAPS if occlusion.overlaps else 0)
        found += [(cone, own | (LAST if index == len(cones) - 1 else 0)) for index, cone in enumerate(cones)]
    regions: list[tuple[float, float, float, float]] = []
    rows: list[Matrix] = [np.zeros((1, 4))] if not found else []
    at = len(found)
    for cone, flags in found:
        rows.append(cone.planes @ world_from_local)
        first, at = at, at + len(cone.planes)
        quadric = -1
        if cone.quadric is not None:
            local = world_from_local.T @ cone.quadric @ world_from_local
            rows.append(local / np.abs(local).max())
            quadric, at = at, at + 4
        stop = first + len(cone.planes)
        regions.append((first, stop, quadric, flags))
    return np.concatenate([np.array(regions, dtype=np.float64).reshape(-1, 4), *rows]), len(regions)


def _cones(occlusion: Occlusion) -> tuple[Cone, ...]:
    return occlusion.cones if occlusion.inside is None else (*occlusion.cones, occlusion.inside)


def _may_hold(cone: Cone, ball: tuple[Matrix, float]) -> bool:
    """Whether any point of a ball may lie within a cone: none does that lies beyond one of its planes."""
    middle, reach_px = ball
    return bool((cone.planes @ np.append(middle, 1.0) > -reach_px).all())
