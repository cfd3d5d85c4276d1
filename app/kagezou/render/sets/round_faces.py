"""The pass of round faces: the shadow on a ball or on the side of a drum, found cell by cell on the surface itself."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import radians, sin

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.light import GRAZING_DARK_DEG, GRAZING_FULL_DEG
from kagezou.geometry.sets.bodies import Ball
from kagezou.geometry.sets.occlusion_cones import Occlusion
from kagezou.geometry.sets.round_faces_seen import RoundFace
from kagezou.geometry.shadow import SpaceCast
from kagezou.geometry.vectors import Matrix, Vector4
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.cone_tables import ConeTables
from kagezou.render.gpu.gl import GL
from kagezou.render.gpu.mattes import PlacedMatte
from kagezou.render.gpu.program import Variants
from kagezou.render.gpu.targets import Target
from kagezou.render.meshes.occlusion import Screen, light_uniforms
from kagezou.render.prepare.cast_uniforms import card_switches, card_uniforms
from kagezou.render.prepare.mask_tiles import Flags, region_states
from kagezou.render.prepare.mask_uniforms import LIGHT
from kagezou.render.prepare.set_as_seen import SetAsSeen
from kagezou.render.prepare.shadow_tiles import TileGrid, Tiling, whole_grid
from kagezou.render.prepare.uniforms import Uniform
from kagezou.scene.scene import ShadowCast

_PATCH_MARGIN = 0.5
"""How far beyond its corners' picture a curved patch may reach, as a part of that."""


@dataclass(frozen=True, slots=True, eq=False)
class RoundLit:
    """A round face under one light, with what the other bodies take of that."""

    set_seen: SetAsSeen
    face: RoundFace
    light: Vector4
    occlusions: dict[int, Occlusion]
    screen: Screen | None = None

    @property
    def switches(self) -> frozenset[str]:
        """The switches of ``sets/round.frag`` that meshes ask for."""
        return frozenset() if self.screen is None or self.screen.light_map is None else self.screen.light_map.switches

    @property
    def world_from_local(self) -> Matrix:
        """The (4, 4) shift from around the middle of the body to the world."""
        shift = np.eye(4)
        shift[:3, 3] = self.face.centre
        return shift

    def uniforms(self) -> dict[str, Uniform]:
        """Return what ``sets/round.frag`` always wants."""
        face, shape, box = self.face, self.face.shape, self.face.box
        origin = ((box.left + box.right) // 2 + 0.5, (box.top + box.bottom) // 2 + 0.5)
        axis = (0.0, 0.0, 0.0, 0.0) if isinstance(shape, Ball) else (*shape.axis, shape.height_px / 2)
        return {
            "u_origin_px": origin,
            "u_origin_world": np.array([*origin, 0.0]) - face.centre,
            "u_eye": self._local(self.set_seen.camera.eye),
            "u_light": self._local(self.light),
            "u_across": face.across,
            "u_radius": shape.radius_px,
            "u_axis": axis,
            "u_grazing_sine": (sin(radians(GRAZING_DARK_DEG)), sin(radians(GRAZING_FULL_DEG))),
            **self._light(),
        }

    def _light(self) -> dict[str, Uniform]:
        if self.screen is None or self.screen.light_map is None:
            return {}
        view = self.screen.view
        return light_uniforms(self.screen.light_map, view, self.face.centre - view.on_gpu.origin)

    def piece_uniforms(self, cast: SpaceCast, matte: PlacedMatte) -> dict[str, Uniform]:
        """Return what it wants of one card piece, for a matte on unit 0."""
        return card_uniforms(cast, matte, self.world_from_local)

    def _local(self, point: Vector4) -> Matrix:
        shifted = np.array(point)
        shifted[:3] -= point[3] * self.face.centre
        return shifted

    def tables(self, tables: ConeTables) -> dict[str, Uniform]:
        """Return what ``sets/occlusion_cones.glsl`` wants."""
        shape = self.face.shape
        reach = shape.radius_px if isinstance(shape, Ball) else float(np.hypot(shape.radius_px, shape.height_px / 2))
        return tables.uniforms(self._others(), self.world_from_local, (self.face.centre, reach))

    def _others(self) -> Iterator[tuple[Occlusion, int]]:
        """Yield what other bodies hide from the eye, then what they take of the light."""
        for index, occlusion in enumerate(self.set_seen.eye_occlusions):
            if index != self.face.body:
                yield occlusion, 0
        for index, occlusion in self.occlusions.items():
            if index != self.face.body:
                yield occlusion, LIGHT


def _tiles(lit: RoundLit) -> tuple[TileGrid, Flags, Flags]:
    """Return the tiles of a round face, which of them it may be seen in, and which hold its rim."""
    face = lit.face
    grid = whole_grid(face.box)
    corners = grid.corners()
    outline = region_states(face.outline.regions, corners)
    seen, inside = np.logical_or.reduce(outline.some), np.logical_or.reduce(outline.full)
    if face.end is not None:
        end = region_states(face.end.regions, corners)
        seen, inside = seen & ~np.logical_or.reduce(end.full), inside & ~np.logical_or.reduce(end.some)
    return grid, np.asarray(seen), np.asarray(seen & ~inside)


def _shaded_tiles(lit: RoundLit, casts: Sequence[SpaceCast], matte: PlacedMatte, canvas: Box) -> Tiling:
    """Return the tiles of a round face in which a character's shadow may lie.

    Within the outline a tile sees a patch that its corners and their surroundings bound; at the rim it may see all.
    """
    grid, seen, rim = _tiles(lit)
    points = lit.face.seen_at(lit.set_seen.camera, grid.corners())
    may_hold = rim.copy()
    for cast in casts:
        art = cast.art_from_world @ points
        w = art[:, 2]
        is_bounded = w.min(axis=0) > 1e-9 * np.abs(cast.art_from_world[2]).max()
        texels = (
            art[:, :2] / np.where(w > 0, w, 1.0)[:, np.newaxis]
            - np.array([matte.box.left, matte.box.top])[:, np.newaxis]
        )
        low, high = texels.min(axis=0), texels.max(axis=0)
        margin = _PATCH_MARGIN * (high - low)
        empty, _ = matte.occupancy.states(low - margin, high + margin)
        before = (cast.side @ points).max(axis=0) < 0
        may_hold |= ~(is_bounded & (empty | before))
    return grid.tiling(canvas, seen & may_hold)


class RoundPass:
    """Draws the shadow on round faces, each as if it were seen whole but for other bodies."""

    def __init__(self, boxes: Boxes) -> None:
        self._boxes = boxes
        self._programs = Variants("common/box.vert", "sets/round.frag")
        self._tables = ConeTables()

    def close(self) -> None:
        """Give the memory back."""
        self._programs.close()
        self._tables.close()

    def draw(self, lit: RoundLit, cast: ShadowCast, matte: PlacedMatte, target: Target) -> Box | None:
        """Draw what a character casts; return the box that may hold it."""
        pieces = cast.in_space(lit.light)
        tiling = _shaded_tiles(lit, pieces, matte, target.box)
        if tiling.box is None:
            return None
        self._begin(lit, target)
        uniforms = {"u_target_size_px": target.size_px, **lit.uniforms(), **lit.tables(self._tables)}
        for piece in pieces:
            switches = lit.switches | card_switches(piece, translucent=cast.translucent)
            matte.texture.bind(0)
            self._programs[switches].use(uniforms | lit.piece_uniforms(piece, matte))
            self._boxes.draw(tiling.boxes)
        return tiling.box

    def draw_own(self, lit: RoundLit, target: Target, *, is_caster: bool) -> Box:
        """Draw what the set takes of the light; return the box that may hold it."""
        switches = lit.switches | {"OWN_SHADOW"} | ({"DARK_WHEN_TURNED"} if is_caster else set())
        self._begin(lit, target)
        uniforms = {"u_target_size_px": target.size_px, **lit.uniforms(), **lit.tables(self._tables)}
        self._programs[switches].use(uniforms)
        self._boxes.draw_one(lit.face.box)
        return lit.face.box

    @staticmethod
    def _begin(lit: RoundLit, target: Target) -> None:
        target.bind(lit.face.box)
        # Pieces of a folded card meet at their folds, where their parts of a pixel add up.
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendFunc(GL.GL_ONE, GL.GL_ONE)
