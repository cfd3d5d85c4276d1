"""The pass of sets: a shadow on every face that is seen, each cut to what is seen and lit of it, and added up.

A flat face is one more receiver with a homography of its own, so its edges are as exact as the flat ground's. What is
seen and lit of a face adds up to the whole picture pixel by pixel: there is no gap and no double edge at a seam.
"""

from collections import OrderedDict
from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import partial

from kagezou.geometry.box import Box, around
from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import Plane
from kagezou.geometry.sets.faces_seen import GROUND, Face
from kagezou.geometry.sets.round_faces_seen import RoundFace
from kagezou.geometry.vectors import Vector4, height_over
from kagezou.io.sets.mesh_cache import MeshCache
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.mattes import PlacedMatte
from kagezou.render.gpu.scratches import Scratches
from kagezou.render.gpu.targets import Target
from kagezou.render.meshes.display import Display, SetPicture
from kagezou.render.meshes.mesh_pass import MeshLit, MeshPass
from kagezou.render.meshes.occlusion import Screen
from kagezou.render.passes.cast import CastPass, Window, strokes
from kagezou.render.passes.filter import ShapePass
from kagezou.render.passes.silhouette import SilhouettePass
from kagezou.render.prepare.mask_tiles import Mask
from kagezou.render.prepare.set_as_seen import SetAsSeen
from kagezou.render.prepare.set_receivers import blocks, casts, receivers_of, views_of
from kagezou.render.sets.add_face import Adding, OwnShade
from kagezou.render.sets.lit_set import EVERYWHERE, Lit, Shaped, own_shade
from kagezou.render.sets.round_faces import RoundLit, RoundPass
from kagezou.scene.pieces import PieceScene, SetCast
from kagezou.scene.scene import ShadowCast

_KEPT_STAGES = 4

_Character = tuple[ShadowCast, PlacedMatte]


class SetPass:
    """Draws characters' shadows on a set, and the set's own."""

    def __init__(self, boxes: Boxes, caster: CastPass, shaper: ShapePass, meshes: MeshCache) -> None:
        self._caster = caster
        self._shaper = shaper
        self._adding = Adding(boxes, caster)
        self._round = RoundPass(boxes)
        self._mesh = MeshPass(boxes, meshes)
        self._silhouette = SilhouettePass(boxes, shaper)
        self._stages: OrderedDict[int, SetAsSeen] = OrderedDict()
        self._scratches = Scratches()

    def close(self) -> None:
        """Give the memory back."""
        self._adding.close()
        self._round.close()
        self._mesh.close()
        self._silhouette.close()
        self._scratches.close()

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
        shaped = self._shaped(stage, cast, matte, target) if cast.is_filtered and cast.lights else None
        drawn: Box | None = None
        ground = cast.receivers[0] if cast.ground_receives else None
        for light in cast.lights:
            lit = self._lit(stage, light, ground, blocks)
            own = target if len(cast.lights) == 1 else self._scratches.like("light", target)
            box = self._draw_light(lit, cast, matte, own, shaped)
            drawn = self._united(own, box, target, drawn)
        for alone, box in (shaped.faces if shaped else {}).values():
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
            own = target if len(cast.lights) == 1 else self._scratches.like("light", target)
            box: Box | None = None
            for face in stage.faces:
                if face.body != GROUND or ground is not None:
                    box = around(box, self._add_own(lit, face, own))
            if lit.meshes is not None:
                box = around(box, self._mesh.draw_own(lit.meshes, own))
            for each in stage.rounds:
                alone = self._scratches.like("face", target)
                round_lit = RoundLit(stage, each, light, lit.occlusions, self._screen(lit, each))
                dark = self._round.draw_own(round_lit, alone, is_caster=stage.is_caster(each))
                box = around(box, self._add_round(lit, each, dark, own))
            drawn = self._united(own, box, target, drawn)
        return drawn

    def draw_seen(self, cast: SetCast, target: Target) -> Box | None:
        """Draw where the pieces that cast are seen, or, where none does, the ground; return the box that may hold it.

        It is the shadow of a light that stands, for every place, opposite to the eye: all that is seen is turned away
        from it.
        """
        target.clear()
        stage = self._stage(cast.camera, target.box, cast.ground, cast.pieces)
        ground = cast.ground if cast.ground_receives else None
        ex, ey, ez, ew = cast.camera.eye
        lit = self._unlit(stage, (-ex, -ey, -ez, -ew), ground)
        wants_ground = ground is not None and not any(piece.casts for piece in cast.pieces)
        drawn: Box | None = None
        for face in stage.faces:
            if stage.is_caster(face) or (face.body == GROUND and wants_ground):
                mask, shade = stage.mask(face, (EVERYWHERE,)), own_shade(face, None, face.box)
                box = self._adding.add_own(mask, shade, face.box, target, self._screen(lit, face))
                drawn = around(drawn, box)
        if lit.meshes is not None:
            drawn = around(drawn, self._mesh.draw_own(lit.meshes, target))
        for each in filter(stage.is_caster, stage.rounds):
            alone = self._scratches.like("face", target)
            round_lit = RoundLit(stage, each, lit.light, {}, self._screen(lit, each))
            drawn = around(
                drawn, self._add_round(lit, each, self._round.draw_own(round_lit, alone, is_caster=True), target)
            )
        return drawn

    def _unlit(self, stage: SetAsSeen, light: Vector4, ground: Plane | None) -> Lit:
        """Return a set under a light that nobody keeps from anybody."""
        view = self._mesh.view(stage, Box(0, 0, stage.camera.width_px, stage.camera.height_px))
        return Lit(stage, light, {}, None if view is None else MeshLit(view, stage, light, {}, None, ground))

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
        self, lit: Lit, cast: ShadowCast, matte: PlacedMatte, target: Target, shaped: Shaped | None
    ) -> Box | None:
        """Add up what one light casts on all faces; return the box that may hold it."""
        stage = lit.stage
        drawn: Box | None = None
        single: list[Face] = []
        for face in stage.faces:
            if not stage.receives(face) or (face.body == GROUND and not cast.ground_receives):
                continue
            of_face = None if shaped is None else shaped.faces.get(face)
            if of_face is None and len(cast.card.pieces) == 1 and lit.meshes is None:
                single.append(face)
            else:
                drawn = around(drawn, self._add_face(lit, (cast, matte), face, target, of_face))
        masked = (
            (self._mask(lit, face), stroke)
            for face in single
            for stroke in strokes(cast, (face.plane, lit.light), matte, Window(face.box))
            if stroke.grid.touched.any()
        )
        drawn = around(drawn, self._adding.add_strokes(masked, partial(self._aside, target), target))
        if shaped is not None and shaped.silhouette is not None:
            cast, matte = shaped.silhouette.cast, shaped.silhouette.matte
        if lit.meshes is not None:
            drawn = around(drawn, self._mesh.draw(lit.meshes, cast, matte, target))
        for round_face in stage.rounds:
            if stage.receives(round_face):
                round_lit = RoundLit(stage, round_face, lit.light, lit.occlusions, self._screen(lit, round_face))
                box = self._round.draw(round_lit, cast, matte, self._scratches.like("face", target))
                drawn = around(drawn, self._add_round(lit, round_face, box, target))
        return drawn

    def _add_face(
        self,
        lit: Lit,
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
        alone = self._scratches.like("face", target)
        box = self.coverage(cast, face, lit.light, matte, alone)
        if box is None:
            return None
        drawn = self._adding.add(self._mask(lit, face), alone, box, target, self._screen(lit, face))
        alone.clear(box)
        return drawn

    def _lit(self, stage: SetAsSeen, light: Vector4, ground: Plane | None, wanted: Callable[[PieceScene], bool]) -> Lit:
        view = self._mesh.view(stage, Box(0, 0, stage.camera.width_px, stage.camera.height_px))
        meshes = None if view is None else self._mesh.lit(view, stage, light, ground, wanted)
        return Lit(stage, light, stage.occlusions(light, wanted), meshes)

    def _screen(self, lit: Lit, face: Face | RoundFace) -> Screen | None:
        return None if lit.meshes is None else self._mesh.screen(lit.meshes, face)

    @staticmethod
    def _mask(lit: Lit, face: Face) -> Mask:
        return lit.stage.mask(face, face.unlit(lit.occlusions))

    def _add_round(self, lit: Lit, face: RoundFace, box: Box | None, target: Target) -> Box | None:
        """Add what is seen of a round face, and empty the scratch it was drawn in."""
        if box is None:
            return None
        alone = self._scratches.like("face", target)
        drawn = self._adding.add(SetAsSeen.round_mask(face), alone, box, target, self._screen(lit, face))
        alone.clear(box)
        return drawn

    def _shaped(self, stage: SetAsSeen, cast: ShadowCast, matte: PlacedMatte, target: Target) -> Shaped:
        """Draw the filtered shadow on the ground and on every flat face it reaches, each as if it were seen alone."""
        blurred = self._shaper.blurred(replace(cast, pieces=()), matte, receivers_of(stage, cast.lights[0]))
        shaped = Shaped()
        if blurred is None:
            return shaped
        for number, (face, view) in enumerate(views_of(stage, blurred.job)):
            alone = self._scratches.like(f"shaped {number}", target)
            shaped.faces[face] = alone, self._shaper.show(blurred, view, alone)
        if any(piece.receives and piece.mesh is not None for piece in stage.pieces) or any(
            stage.receives(each) for each in stage.rounds
        ):
            shaped.silhouette = self._silhouette.drawn(blurred, target.box)
        return shaped

    def _add_own(self, lit: Lit, face: Face, target: Target) -> Box | None:
        """Add what the set takes from one light on one face."""
        stage, screen = lit.stage, self._screen(lit, face)
        is_caster = stage.is_caster(face)
        if height_over(face.plane.equation, lit.light) <= 0:
            if not is_caster:
                return None
            shade = own_shade(face, None, face.box)
            return self._adding.add_own(stage.mask(face, (EVERYWHERE,)), shade, face.box, target, screen)
        unlit = face.unlit(lit.occlusions)
        by_mesh = screen is not None and screen.light_map is not None
        shade = own_shade(face, lit.light if unlit or is_caster or by_mesh else None, face.box)
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
        return around(drawn, box)

    def _stage(self, camera: Camera, canvas: Box, ground: Plane, pieces: tuple[PieceScene, ...]) -> SetAsSeen:
        """Return a set as a camera sees it; the last few are kept."""
        for key, stage in self._stages.items():
            if stage.is_of(camera, ground, pieces):
                self._stages.move_to_end(key)
                return stage
        stage = SetAsSeen.of(camera, canvas, ground, pieces)
        self._stages[id(stage)] = stage
        if len(self._stages) > _KEPT_STAGES:
            self._stages.popitem(last=False)
        return stage

    def _aside(self, target: Target, number: int) -> Target:
        return self._scratches.like(f"edges {number}", target)
