"""The pass of sets: a shadow on every face that is seen, each cut to what is seen and lit of it, and added up.

A flat face is one more receiver with a homography of its own, so its edges are as exact as the flat ground's. What is
seen and lit of a face adds up to the whole picture pixel by pixel: there is no gap and no double edge at a seam.
"""

from collections import OrderedDict
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import Plane
from kagezou.geometry.polygon import box_polygon, clipped, distance_form, shifted
from kagezou.geometry.regions import Group, Region
from kagezou.geometry.round_view import RoundFace
from kagezou.geometry.set_view import GROUND, Face
from kagezou.geometry.shadow import plane_coordinates
from kagezou.geometry.vectors import Vector4, height_over
from kagezou.geometry.veils import Veil
from kagezou.io.meshes import MeshCache
from kagezou.render.boxes import Boxes
from kagezou.render.cast_pass import CastPass, Stroke, Window, strokes
from kagezou.render.cast_uniforms import FULL_STRENGTH, Frame, Grazing
from kagezou.render.mattes import PlacedMatte
from kagezou.render.mesh_display import Display, SetPicture
from kagezou.render.mesh_pass import MeshLit, MeshPass
from kagezou.render.mesh_screen import Screen
from kagezou.render.set_adding import Adding, OwnShade
from kagezou.render.set_round import RoundLit, RoundPass
from kagezou.render.set_shapes import blocks, casts, receivers_of, views_of
from kagezou.render.set_stage import Stage
from kagezou.render.set_tiles import Mask
from kagezou.render.shape_pass import ShapePass
from kagezou.render.targets import Target
from kagezou.scene.pieces import PieceScene, SetCast
from kagezou.scene.scene import ShadowCast

_KEPT_STAGES = 4

_MOST_ASIDES = 6
"""Targets of the canvas' size for tiles with edges."""

EVERYWHERE = Group((Region(np.zeros((0, 3))),), overlaps=False)
"""What a face that is turned away from the light loses of it."""


@dataclass(frozen=True, slots=True, eq=False)
class _Lit:
    """A set under one light: who keeps it from whom."""

    stage: Stage
    light: Vector4
    veils: dict[int, Veil]
    meshes: MeshLit | None


_Character = tuple[ShadowCast, PlacedMatte]

_Shaped = dict[Face, tuple[Target, Box | None]]
"""Filtered shadows, each on a face as if nothing else were there."""


class SetPass:
    """Draws characters' shadows on a set, and the set's own."""

    def __init__(self, boxes: Boxes, caster: CastPass, shaper: ShapePass, meshes: MeshCache) -> None:
        self._caster = caster
        self._shaper = shaper
        self._adding = Adding(boxes, caster)
        self._round = RoundPass(boxes)
        self._mesh = MeshPass(boxes, meshes)
        self._stages: OrderedDict[int, Stage] = OrderedDict()
        self._scratches: dict[str, Target] = {}

    def close(self) -> None:
        """Give the memory back."""
        self._adding.close()
        self._round.close()
        self._mesh.close()
        for target in self._scratches.values():
            target.close()
        self._scratches.clear()

    def forget_meshes(self) -> None:
        """Give back the memory of meshes."""
        self._mesh.forget()

    @property
    def meshes_seen(self) -> tuple[int, int]:
        """How often the camera's view of meshes has been drawn, and how many lights' views."""
        return self._mesh.views_drawn, self._mesh.maps_drawn

    def draw(self, cast: ShadowCast, matte: PlacedMatte | None, target: Target, old: Box | None) -> Box | None:
        """Draw into ``target``, clearing ``old``; return the box that may hold shadow, None for none."""
        if old is not None:
            target.clear(old)
        if matte is None:
            return None
        stage = self._stage(cast.camera, target.box, cast.receivers[0], cast.pieces)
        shaped = self._shaped(stage, cast, matte, target) if cast.is_filtered else None
        drawn: Box | None = None
        ground = cast.receivers[0] if cast.ground_receives else None
        for light in cast.lights:
            lit = self._lit(stage, light, ground, blocks)
            own = target if len(cast.lights) == 1 else self._scratch("light", target)
            box = self._draw_light(lit, cast, matte, own, shaped)
            drawn = self._united(own, box, target, drawn)
        for alone, box in (shaped or {}).values():
            if box is not None:
                alone.clear(box)
        return drawn

    def draw_own(self, cast: SetCast, target: Target, old: Box | None) -> Box | None:
        """Draw the shadow of the set itself, clearing ``old``; return the box that may hold it, None for none."""
        if old is not None:
            target.clear(old)
        stage = self._stage(cast.camera, target.box, cast.ground, cast.pieces)
        drawn: Box | None = None
        ground = cast.ground if cast.ground_receives else None
        for light in cast.lights:
            lit = self._lit(stage, light, ground, casts)
            own = target if len(cast.lights) == 1 else self._scratch("light", target)
            box: Box | None = None
            for face in stage.faces:
                if face.body != GROUND or ground is not None:
                    box = _around(box, self._add_own(lit, face, own))
            if lit.meshes is not None:
                box = _around(box, self._mesh.draw_own(lit.meshes, own))
            for each in stage.rounds:
                alone = self._scratch("face", target)
                round_lit = RoundLit(stage, each, light, lit.veils, self._screen(lit, each))
                dark = self._round.draw_own(round_lit, alone, is_caster=stage.is_caster(each))
                box = _around(box, self._add_round(lit, each, dark, own))
            drawn = self._united(own, box, target, drawn)
        return drawn

    def pictures(self, cast: SetCast, canvas: Box, displays: Iterable[Display]) -> tuple[SetPicture, ...]:
        """Return what is to be shown of meshes themselves, those under the background first."""
        ways = {display.value for display in displays}
        if not any(piece.mesh is not None and piece.display in ways for piece in cast.pieces):
            return ()
        view = self._mesh.view(self._stage(cast.camera, canvas, cast.ground, cast.pieces), canvas)
        return () if view is None else self._mesh.pictures(view, displays)

    def coverage(self, cast: ShadowCast, face: Face, light: Vector4, matte: PlacedMatte, target: Target) -> Box | None:
        """Draw the shadow on the plane of one face as if nothing else were there; return the box that may hold it."""
        alone = replace(cast, receivers=(face.plane,), lights=(light,))
        return self._caster.unite(alone, matte, target, Window(face.box))

    def _draw_light(
        self, lit: _Lit, cast: ShadowCast, matte: PlacedMatte, target: Target, shaped: _Shaped | None
    ) -> Box | None:
        """Add up what one light casts on all faces; return the box that may hold it."""
        stage = lit.stage
        drawn: Box | None = None
        single: list[tuple[Mask, Stroke]] = []
        for face in stage.faces:
            if not stage.receives(face) or (face.body == GROUND and not cast.ground_receives):
                continue
            of_face = None if shaped is None else shaped.get(face)
            if of_face is None and len(cast.card.pieces) == 1 and lit.meshes is None:
                found = strokes(cast, (face.plane, lit.light), matte, Window(face.box))
                single += [(self._mask(lit, face), each) for each in found if each.grid.touched.any()]
            else:
                drawn = _around(drawn, self._add_face(lit, (cast, matte), face, target, of_face))
        asides = [self._scratch(f"edges {number}", target) for number in range(min(len(single), _MOST_ASIDES))]
        drawn = _around(drawn, self._adding.add_strokes(single, asides, target) if single else None)
        if lit.meshes is not None:
            drawn = _around(drawn, self._mesh.draw(lit.meshes, cast, matte, target))
        for round_face in stage.rounds:
            if stage.receives(round_face):
                round_lit = RoundLit(stage, round_face, lit.light, lit.veils, self._screen(lit, round_face))
                box = self._round.draw(round_lit, cast, matte, self._scratch("face", target))
                drawn = _around(drawn, self._add_round(lit, round_face, box, target))
        return drawn

    def _add_face(
        self,
        lit: _Lit,
        character: _Character,
        face: Face,
        target: Target,
        shaped: tuple[Target, Box | None] | None,
    ) -> Box | None:
        """Add what is seen and lit of a face, its shadow drawn for it or given as it was shaped."""
        if shaped is not None:
            alone, box = shaped
            screen = self._screen(lit, face)
            return None if box is None else self._adding.add(self._mask(lit, face), alone, box, target, screen)
        cast, matte = character
        alone = self._scratch("face", target)
        box = self.coverage(cast, face, lit.light, matte, alone)
        if box is None:
            return None
        drawn = self._adding.add(self._mask(lit, face), alone, box, target, self._screen(lit, face))
        alone.clear(box)
        return drawn

    def _lit(self, stage: Stage, light: Vector4, ground: Plane | None, wanted: Callable[[PieceScene], bool]) -> _Lit:
        view = self._mesh.view(stage, Box(0, 0, stage.camera.width_px, stage.camera.height_px))
        meshes = None if view is None else self._mesh.lit(view, stage, light, ground, wanted)
        return _Lit(stage, light, stage.veils(light, wanted), meshes)

    def _screen(self, lit: _Lit, face: Face | RoundFace) -> Screen | None:
        return None if lit.meshes is None else self._mesh.screen(lit.meshes, face)

    @staticmethod
    def _mask(lit: _Lit, face: Face) -> Mask:
        return lit.stage.mask(face, face.unlit(lit.veils))

    def _add_round(self, lit: _Lit, face: RoundFace, box: Box | None, target: Target) -> Box | None:
        """Add what is seen of a round face, and empty the scratch it was drawn in."""
        if box is None:
            return None
        alone = self._scratch("face", target)
        drawn = self._adding.add(Stage.round_mask(face), alone, box, target, self._screen(lit, face))
        alone.clear(box)
        return drawn

    def _shaped(self, stage: Stage, cast: ShadowCast, matte: PlacedMatte, target: Target) -> _Shaped:
        """Draw the filtered shadow on the ground and on every flat face it reaches, each as if it were seen alone."""
        blurred = self._shaper.blurred(replace(cast, pieces=()), matte, receivers_of(stage, cast.lights[0]))
        shaped: _Shaped = {}
        if blurred is None:
            return shaped
        for number, (face, view) in enumerate(views_of(stage, blurred.job)):
            alone = self._scratch(f"shaped {number}", target)
            shaped[face] = alone, self._shaper.show(blurred, view, alone)
        return shaped

    def _add_own(self, lit: _Lit, face: Face, target: Target) -> Box | None:
        """Add what the set takes from one light on one face."""
        stage, screen = lit.stage, self._screen(lit, face)
        is_caster = stage.is_caster(face)
        if height_over(face.plane.equation, lit.light) <= 0:
            if not is_caster:
                return None
            shade = _shade(face, None, face.box)
            return self._adding.add_own(stage.mask(face, (EVERYWHERE,)), shade, face.box, target, screen)
        unlit = face.unlit(lit.veils)
        by_mesh = screen is not None and screen.light_map is not None
        shade = _shade(face, lit.light if unlit or is_caster or by_mesh else None, face.box)
        if is_caster and not shade.is_even:
            # It passes over into a face that is turned away: every tile is a little dark.
            dark = OwnShade(shade.switches | {"DARK_WHEN_TURNED"}, shade.uniforms, is_even=False)
            return self._adding.add_own(stage.mask(face, unlit), dark, face.box, target, screen)
        if not unlit and not by_mesh:
            return None
        return self._adding.add_own(stage.mask(face, unlit), shade, face.box, target, screen)

    def _united(self, own: Target, box: Box | None, target: Target, drawn: Box | None) -> Box | None:
        if box is not None and own is not target:
            self._adding.unite(own, box, target)
            own.clear(box)
        return _around(drawn, box)

    def _stage(self, camera: Camera, canvas: Box, ground: Plane, pieces: tuple[PieceScene, ...]) -> Stage:
        """Return a set as a camera sees it; the last few are kept."""
        for key, stage in self._stages.items():
            if stage.is_of(camera, ground, pieces):
                self._stages.move_to_end(key)
                return stage
        stage = Stage.of(camera, canvas, ground, pieces)
        self._stages[id(stage)] = stage
        if len(self._stages) > _KEPT_STAGES:
            self._stages.popitem(last=False)
        return stage

    def _scratch(self, name: str, target: Target) -> Target:
        """Return an empty target like another one; whoever draws into it empties it again."""
        kept = self._scratches.get(name)
        if kept is not None and kept.box != target.box:
            kept.close()
            kept = None
        if kept is None:
            kept = self._scratches[name] = Target(target.box.width, target.box.height, target.texture.form)
            kept.clear()
        return kept


def _around(box: Box | None, other: Box | None) -> Box | None:
    if box is None or other is None:
        return box or other
    return box.union(other)


def _shade(face: Face, light: Vector4 | None, box: Box) -> OwnShade:
    """Return how strong the set's shadow is on a face under a light; without one, at its full strength."""
    frame = Frame(clipped(box_polygon(box), shifted(distance_form(face.flat.lift[3]), -0.01)))
    grazing = FULL_STRENGTH if light is None else Grazing.of(face.plane, light)
    receiver_from_canvas = plane_coordinates(face.plane) @ face.flat.lift
    switches = grazing.switches(receiver_from_canvas, frame)
    x, y = (float(each) for each in frame.origin)
    uniforms = {"u_origin_px": (x, y), **grazing.uniforms(receiver_from_canvas, frame)}
    return OwnShade(switches, uniforms, is_even=not switches and uniforms["u_strength"] == 1.0)
