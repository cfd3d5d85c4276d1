"""The pass of meshes: the shadow on every triangle that is seen, and what meshes do to the other faces of a set."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from math import radians, sin

import numpy as np

from kagezou.geometry.box import Box, around
from kagezou.geometry.ground import Plane
from kagezou.geometry.light import GRAZING_DARK_DEG, GRAZING_FULL_DEG
from kagezou.geometry.sets.faces_seen import Face
from kagezou.geometry.sets.occlusion_cones import Occlusion
from kagezou.geometry.sets.round_faces_seen import RoundFace
from kagezou.geometry.shadow import SpaceCast
from kagezou.geometry.vectors import Matrix, Vector4
from kagezou.io.sets.mesh_cache import MeshCache
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.cone_tables import ConeTables
from kagezou.render.gpu.gl import GL
from kagezou.render.gpu.mattes import PlacedMatte
from kagezou.render.gpu.program import Variants
from kagezou.render.gpu.targets import Target
from kagezou.render.meshes.buffers import MeshBuffers, PlacedMesh
from kagezou.render.meshes.display import Display, MeshDisplays, SetPicture
from kagezou.render.meshes.eye_view import MeshView, MeshViews
from kagezou.render.meshes.light_map import LightMap, LightMaps, Surroundings, Taken
from kagezou.render.meshes.occlusion import Pasts, Screen, light_uniforms
from kagezou.render.prepare.cast_uniforms import card_switches, card_uniforms
from kagezou.render.prepare.mask_tiles import Flags
from kagezou.render.prepare.mask_uniforms import LIGHT
from kagezou.render.prepare.set_as_seen import SetAsSeen
from kagezou.render.prepare.uniforms import Uniform
from kagezou.scene.scene import ShadowCast

_IN_PARTS: frozenset[str] = frozenset()
_FULL = frozenset({"FULL"})
"""Switches for tiles in which a card piece casts in parts, or fully."""

_EVERYWHERE = np.array([0.0, 0.0, 0.0, 1.0])


@dataclass(frozen=True, slots=True, eq=False)
class MeshLit:
    """The meshes of a set under one light.

    Parameters
    ----------
    view, set_seen
        What is seen of them, and of the other pieces.
    light, occlusions
        The light, and what the bodies of other pieces take of it.
    light_map
        What it sees of the meshes that take it; None for none.
    ground
        The ground, where it hides what lies below it.
    """

    view: MeshView
    set_seen: SetAsSeen
    light: Vector4
    occlusions: dict[int, Occlusion]
    light_map: LightMap | None
    ground: Plane | None

    @property
    def world_from_local(self) -> Matrix:
        """The (4, 4) shift from around the origin of the meshes to the world."""
        shift = np.eye(4)
        shift[:3, 3] = self.view.on_gpu.origin
        return shift

    def uniforms(self, tables: ConeTables) -> dict[str, Uniform]:
        """Return what ``meshes/shade.frag`` always wants, its textures bound."""
        view = self.view
        view.bind()
        centre, reach = view.ball
        ball = (centre + view.on_gpu.origin, reach)
        found = view.uniforms() | tables.uniforms(self._occlusions(), self.world_from_local, ball)
        if self.light_map is not None:
            found |= light_uniforms(self.light_map, view, np.zeros(3))
        return found | {
            "u_ground": self._ground(),
            "u_light": view.local(np.array(self.light)),
            "u_grazing_sine": (sin(radians(GRAZING_DARK_DEG)), sin(radians(GRAZING_FULL_DEG))),
        }

    def _ground(self) -> Matrix:
        if self.ground is None:
            return _EVERYWHERE
        equation = np.array(self.ground.equation)
        above = float(equation @ np.array(self.view.camera.eye)) >= 0
        return self.view.local_form(equation if above else -equation)

    def _occlusions(self) -> Iterator[tuple[Occlusion, int]]:
        for occlusion in self.set_seen.eye_occlusions:
            yield occlusion, 0
        for occlusion in self.occlusions.values():
            yield occlusion, LIGHT


class MeshPass:
    """Draws the shadow on meshes."""

    def __init__(self, boxes: Boxes, meshes: MeshCache) -> None:
        self._boxes = boxes
        self._meshes = meshes
        self._programs = Variants("common/box.vert", "meshes/shade.frag")
        self._tables = ConeTables()
        self._views = MeshViews(boxes)
        self._maps = LightMaps()
        self._pasts = Pasts(boxes)
        self._displays = MeshDisplays(boxes)
        self._on_card: MeshBuffers | None = None

    @property
    def views_drawn(self) -> int:
        """How often the camera's view of the meshes has been drawn."""
        return self._views.views_drawn

    @property
    def maps_drawn(self) -> int:
        """How many lights' views of the meshes have been drawn."""
        return self._maps.maps_drawn

    def close(self) -> None:
        """Give the memory back."""
        self.forget()
        self._programs.close()
        for each in (self._tables, self._views, self._maps, self._pasts, self._displays):
            each.close()

    def forget(self) -> None:
        """Give back everything about the meshes drawn last."""
        for each in (self._displays, self._pasts, self._maps, self._views):
            each.forget()
        if self._on_card is not None:
            self._on_card.close()
            self._on_card = None

    def view(self, set_seen: SetAsSeen, canvas: Box) -> MeshView | None:
        """Return what is seen of the meshes of a set_seen; None where it has none."""
        placed = [
            PlacedMesh(self._meshes.mesh(piece.mesh.path), piece) for piece in set_seen.pieces if piece.mesh is not None
        ]
        placed = [each for each in placed if len(each.mesh.triangles)]
        if not placed:
            return None
        if self._on_card is None or not self._on_card.is_of(placed):
            self.forget()
            self._on_card = MeshBuffers(placed)
        return self._views.view(self._on_card, set_seen.camera, canvas)

    def pictures(self, view: MeshView, displays: Iterable[Display]) -> tuple[SetPicture, ...]:
        """Return what is to be shown of the meshes themselves."""
        return self._displays.pictures(view, displays)

    def lit(
        self,
        view: MeshView,
        set_seen: SetAsSeen,
        light: Vector4,
        ground: Plane | None,
        taken: Taken,
    ) -> MeshLit:
        """Return the meshes of a set_seen under a light that is taken by some."""
        around = Surroundings(ground, bool(set_seen.bodies))
        light_map = self._maps.map_of(view, light, around, taken)
        return MeshLit(view, set_seen, light, set_seen.occlusions(light, taken.by), light_map, ground)

    def screen(self, lit: MeshLit, face: Face | RoundFace) -> Screen:
        """Return what the meshes do to another face."""
        return Screen(face, lit.view, self._pasts.past(lit.view, lit.set_seen, face), lit.light_map)

    def draw(self, lit: MeshLit, cast: ShadowCast, matte: PlacedMatte, target: Target) -> Box | None:
        """Add what a character casts to ``target``; return the box that may hold it."""
        pieces = cast.in_space(lit.light)
        drawn: Box | None = None
        uniforms = {"u_target_size_px": target.size_px, **lit.uniforms(self._tables)}
        for piece in pieces:
            some, full = _shaded(lit.view, piece, matte)
            for tiles, how in ((full, _FULL), (some & ~full, _IN_PARTS)):
                tiling = lit.view.grid.tiling(target.box, tiles)
                if tiling.box is None:
                    continue
                self._begin(target, tiling.box)
                switches = self._switches(lit) | how
                more: dict[str, Uniform] = {}
                if how is _IN_PARTS:
                    switches |= card_switches(piece, translucent=cast.translucent)
                    more = card_uniforms(piece, matte, lit.world_from_local)
                matte.texture.bind(0)
                self._programs[switches].use(uniforms | more)
                self._boxes.draw(tiling.boxes)
                drawn = around(drawn, tiling.box)
        return drawn

    def draw_own(self, lit: MeshLit, target: Target) -> Box | None:
        """Add what the set takes of the light; return the box that may hold it."""
        tiling = lit.view.grid.tiling(target.box, lit.view.seen)
        if tiling.box is None:
            return None
        uniforms = {"u_target_size_px": target.size_px, **lit.uniforms(self._tables)}
        self._begin(target, tiling.box)
        self._programs[self._switches(lit) | {"OWN_SHADOW"}].use(uniforms)
        self._boxes.draw(tiling.boxes)
        return tiling.box

    @staticmethod
    def _switches(lit: MeshLit) -> frozenset[str]:
        return frozenset() if lit.light_map is None else lit.light_map.switches

    @staticmethod
    def _begin(target: Target, box: Box) -> None:
        target.bind(box)
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendFunc(GL.GL_ONE, GL.GL_ONE)


def _shaded(view: MeshView, cast: SpaceCast, matte: PlacedMatte) -> tuple[Flags, Flags]:
    """Return in which tiles of the canvas (N,) a card piece may shade a mesh, and in which it casts fully."""
    shift = np.eye(4)
    shift[:3, 3] = view.on_gpu.origin
    art, forms = cast.art_from_world @ shift, cast.forms @ shift
    # Most squares of tiles are beside the shadow, and so are all of their tiles.
    asked = _states(art, forms, view.blocks, matte)[0][view.block_of_tile]
    found = _states(art, forms, view.hulls[:, :, asked], matte)
    some, full = np.zeros(len(view.seen), bool), np.zeros(len(view.seen), bool)
    numbers = np.nonzero(view.seen)[0][asked]
    some[numbers], full[numbers] = found
    return some, full


def _states(art_from_local: Matrix, forms: Matrix, hulls: Matrix, matte: PlacedMatte) -> tuple[Flags, Flags]:
    """Return in which hulls (K, 4, N) a card piece may shade something, and in which it casts fully."""
    art = np.matmul(art_from_local, hulls)
    w = art[:, 2]
    is_bounded = w.min(axis=0) > 1e-9 * np.abs(art_from_local[2]).max()
    corner = np.array([matte.box.left, matte.box.top])[:, np.newaxis]
    texels = art[:, :2] / np.where(w > 0, w, 1.0)[:, np.newaxis] - corner
    empty, filled = matte.occupancy.states(texels.min(axis=0), texels.max(axis=0))
    values = np.matmul(forms, hulls)
    outside, inside = (values.max(axis=0) < 0).any(axis=0), (values.min(axis=0) >= 0).all(axis=0)
    return ~((is_bounded & empty) | outside), is_bounded & filled & inside
