"""The pass of sets: a shadow on every face that is seen, each cut to what is seen and lit of it, and added up.

A flat face is one more receiver with a homography of its own, so its edges are as exact as the flat ground's. What is
seen and lit of a face adds up to the whole picture pixel by pixel: there is no gap and no double edge at a seam.
"""

from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import partial

from kagezou.geometry.box import Box, around
from kagezou.geometry.sets.faces_seen import GROUND, Face
from kagezou.geometry.vectors import Vector4
from kagezou.io.sets.mesh_cache import MeshCache
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.mattes import PlacedMatte
from kagezou.render.gpu.targets import Target
from kagezou.render.meshes.display import Display, SetPicture
from kagezou.render.meshes.light_map import Taken
from kagezou.render.passes.cast import CastPass, Window, strokes
from kagezou.render.passes.filter import ShapePass
from kagezou.render.passes.silhouette import SilhouettePass
from kagezou.render.prepare.card_places import places_on_card
from kagezou.render.prepare.set_as_seen import SetAsSeen
from kagezou.render.prepare.set_receivers import blocks, receivers_of, views_of
from kagezou.render.sets.lit_set import Lit, Shaped
from kagezou.render.sets.own_shadow import OwnShadowPass
from kagezou.render.sets.round_faces import RoundLit
from kagezou.render.sets.set_drawing import SetDrawing, mask_of
from kagezou.scene.pieces import SetCast
from kagezou.scene.scene import ShadowCast

_Character = tuple[ShadowCast, PlacedMatte]


class SetPass:
    """Draws characters' shadows on a set, and the set's own.

    Attributes
    ----------
    own
        The pass of the set's own shadow.
    """

    def __init__(self, boxes: Boxes, caster: CastPass, shaper: ShapePass, meshes: MeshCache) -> None:
        self._caster = caster
        self._shaper = shaper
        self._drawing = SetDrawing(boxes, caster, meshes)
        self.own = OwnShadowPass(self._drawing)
        self._silhouette = SilhouettePass(boxes, shaper)

    def close(self) -> None:
        """Give the memory back."""
        self._drawing.close()
        self._silhouette.close()

    def forget_meshes(self) -> None:
        """Give back the memory of meshes."""
        self._drawing.mesh.forget()

    def call_between(self, between: Callable[[], None]) -> None:
        """Have something called before each face is drawn; what it raises ends the drawing."""
        self._drawing.between = between

    @property
    def meshes_seen(self) -> tuple[int, int]:
        """How often the camera's view of meshes has been drawn, and how many lights' views."""
        return self._drawing.mesh.views_drawn, self._drawing.mesh.maps_drawn

    def draw(self, cast: ShadowCast, matte: PlacedMatte | None, target: Target, old: Box | None) -> Box | None:
        """Draw into ``target``, clearing ``old``; return the box that may hold shadow, None for none."""
        if old is not None:
            target.clear(old)
        if matte is None:
            return None
        set_seen = self._drawing.set_seen(cast.camera, target.box, cast.receivers[0], cast.pieces)
        shaped = self._shaped(set_seen, cast, matte, target) if cast.is_filtered and cast.lights else None
        drawn: Box | None = None
        ground = cast.receivers[0] if cast.ground_receives else None
        # A filtered shadow reaches beyond what the card throws.
        taken = Taken(blocks, None if shaped is not None else places_on_card(cast, matte.box))
        for light in cast.lights:
            lit = self._drawing.lit(set_seen, light, ground, taken)
            own = target if len(cast.lights) == 1 else self._drawing.scratches.like("light", target)
            box = self._draw_light(lit, cast, matte, own, shaped)
            drawn = self._drawing.united(own, box, target, drawn)
        for alone, box in (shaped.faces if shaped else {}).values():
            if box is not None:
                alone.clear(box)
        return drawn

    def pictures(self, cast: SetCast, canvas: Box, displays: Iterable[Display]) -> tuple[SetPicture, ...]:
        """Return what is to be shown of meshes themselves, those under the background first."""
        ways = {display.value for display in displays}
        if not any(piece.mesh is not None and piece.display in ways for piece in cast.pieces):
            return ()
        view = self._drawing.mesh.view(self._drawing.set_seen(cast.camera, canvas, cast.ground, cast.pieces), canvas)
        return () if view is None else self._drawing.mesh.pictures(view, displays)

    def coverage(self, cast: ShadowCast, face: Face, light: Vector4, matte: PlacedMatte, target: Target) -> Box | None:
        """Draw the shadow on the plane of one face as if nothing else were there; return the box that may hold it."""
        alone = replace(cast, receivers=(face.plane,), lights=(light,))
        return self._caster.unite(alone, matte, target, Window(face.box))

    def _draw_light(
        self, lit: Lit, cast: ShadowCast, matte: PlacedMatte, target: Target, shaped: Shaped | None
    ) -> Box | None:
        """Add up what one light casts on all faces; return the box that may hold it."""
        set_seen = lit.set_seen
        drawn: Box | None = None
        single: list[Face] = []
        for face in set_seen.faces:
            self._drawing.between()
            if not set_seen.receives(face) or (face.body == GROUND and not cast.ground_receives):
                continue
            of_face = None if shaped is None else shaped.faces.get(face)
            if of_face is None and len(cast.card.pieces) == 1 and lit.meshes is None:
                single.append(face)
            else:
                drawn = around(drawn, self._add_face(lit, (cast, matte), face, target, of_face))
        masked = (
            (mask_of(lit, face), stroke)
            for face in single
            for stroke in strokes(cast, (face.plane, lit.light), matte, Window(face.box))
            if stroke.grid.touched.any()
        )
        drawn = around(drawn, self._drawing.adding.add_strokes(masked, partial(self._aside, target), target))
        if shaped is not None and shaped.silhouette is not None:
            cast, matte = shaped.silhouette.cast, shaped.silhouette.matte
        if lit.meshes is not None:
            drawn = around(drawn, self._drawing.mesh.draw(lit.meshes, cast, matte, target))
        for round_face in set_seen.rounds:
            if set_seen.receives(round_face):
                round_lit = RoundLit(
                    set_seen, round_face, lit.light, lit.occlusions, self._drawing.screen(lit, round_face)
                )
                box = self._drawing.round.draw(round_lit, cast, matte, self._drawing.scratches.like("face", target))
                drawn = around(drawn, self._drawing.add_round(lit, round_face, box, target))
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
            screen = self._drawing.screen(lit, face)
            return None if box is None else self._drawing.adding.add(mask_of(lit, face), alone, box, target, screen)
        cast, matte = character
        alone = self._drawing.scratches.like("face", target)
        box = self.coverage(cast, face, lit.light, matte, alone)
        if box is None:
            return None
        drawn = self._drawing.adding.add(mask_of(lit, face), alone, box, target, self._drawing.screen(lit, face))
        alone.clear(box)
        return drawn

    def _shaped(self, set_seen: SetAsSeen, cast: ShadowCast, matte: PlacedMatte, target: Target) -> Shaped:
        """Draw the filtered shadow on the ground and on every flat face it reaches, each as if it were seen alone."""
        blurred = self._shaper.blurred(replace(cast, pieces=()), matte, receivers_of(set_seen, cast.lights[0]))
        shaped = Shaped()
        if blurred is None:
            return shaped
        for number, (face, view) in enumerate(views_of(set_seen, blurred.job)):
            alone = self._drawing.scratches.like(f"shaped {number}", target)
            shaped.faces[face] = alone, self._shaper.show(blurred, view, alone)
        if any(piece.receives and piece.mesh is not None for piece in set_seen.pieces) or any(
            set_seen.receives(each) for each in set_seen.rounds
        ):
            shaped.silhouette = self._silhouette.drawn(blurred, target.box)
        return shaped

    def _aside(self, target: Target, number: int) -> Target:
        return self._drawing.scratches.like(f"edges {number}", target)
