"""The set's own shadow: what its pieces keep from each other and the ground, and mattes of what is seen of them."""

from kagezou.geometry.box import Box, around
from kagezou.geometry.sets.faces_seen import GROUND, Face
from kagezou.geometry.vectors import height_over
from kagezou.render.gpu.targets import Target
from kagezou.render.meshes.light_map import Taken
from kagezou.render.prepare.set_receivers import casts
from kagezou.render.sets.add_face import OwnShade
from kagezou.render.sets.lit_set import EVERYWHERE, Lit, own_shade
from kagezou.render.sets.round_faces import RoundLit
from kagezou.render.sets.set_drawing import SetDrawing
from kagezou.scene.pieces import SetCast


class OwnShadowPass:
    """Draws the shadow of a set on itself."""

    def __init__(self, drawing: SetDrawing) -> None:
        self._drawing = drawing

    def draw(self, cast: SetCast, target: Target, old: Box | None) -> Box | None:
        """Draw the shadow of the set itself, clearing ``old``; return the box that may hold it, None for none."""
        if old is not None:
            target.clear(old)
        set_seen = self._drawing.set_seen(cast.camera, target.box, cast.ground, cast.pieces)
        drawn: Box | None = None
        ground = cast.ground if cast.ground_receives else None
        for light in cast.lights:
            lit = self._drawing.lit(set_seen, light, ground, Taken(casts))
            own = target if len(cast.lights) == 1 else self._drawing.scratches.like("light", target)
            box: Box | None = None
            for face in set_seen.faces:
                if face.body != GROUND or ground is not None:
                    box = around(box, self._add(lit, face, own))
            if lit.meshes is not None:
                box = around(box, self._drawing.mesh.draw_own(lit.meshes, own))
            for each in set_seen.rounds:
                alone = self._drawing.scratches.like("face", target)
                round_lit = RoundLit(set_seen, each, light, lit.occlusions, self._drawing.screen(lit, each))
                dark = self._drawing.round.draw_own(round_lit, alone, is_caster=set_seen.is_caster(each))
                box = around(box, self._drawing.add_round(lit, each, dark, own))
            drawn = self._drawing.united(own, box, target, drawn)
        return drawn

    def draw_seen(self, cast: SetCast, target: Target) -> Box | None:
        """Draw where the pieces that cast are seen, or, where none does, the ground; return the box that may hold it.

        It is the shadow of a light that stands, for every place, opposite to the eye: all that is seen is turned away
        from it.
        """
        target.clear()
        set_seen = self._drawing.set_seen(cast.camera, target.box, cast.ground, cast.pieces)
        ground = cast.ground if cast.ground_receives else None
        ex, ey, ez, ew = cast.camera.eye
        lit = self._drawing.unlit(set_seen, (-ex, -ey, -ez, -ew), ground)
        wants_ground = ground is not None and not any(piece.casts for piece in cast.pieces)
        drawn: Box | None = None
        for face in set_seen.faces:
            if set_seen.is_caster(face) or (face.body == GROUND and wants_ground):
                mask, shade = set_seen.mask(face, (EVERYWHERE,)), own_shade(face, None, face.box)
                box = self._drawing.adding.add_own(mask, shade, face.box, target, self._drawing.screen(lit, face))
                drawn = around(drawn, box)
        if lit.meshes is not None:
            drawn = around(drawn, self._drawing.mesh.draw_own(lit.meshes, target))
        for each in filter(set_seen.is_caster, set_seen.rounds):
            alone = self._drawing.scratches.like("face", target)
            round_lit = RoundLit(set_seen, each, lit.light, {}, self._drawing.screen(lit, each))
            drawn = around(
                drawn,
                self._drawing.add_round(
                    lit, each, self._drawing.round.draw_own(round_lit, alone, is_caster=True), target
                ),
            )
        return drawn

    def _add(self, lit: Lit, face: Face, target: Target) -> Box | None:
        """Add what the set takes from one light on one face."""
        set_seen, screen = lit.set_seen, self._drawing.screen(lit, face)
        is_caster = set_seen.is_caster(face)
        if height_over(face.plane.equation, lit.light) <= 0:
            if not is_caster:
                return None
            shade = own_shade(face, None, face.box)
            return self._drawing.adding.add_own(set_seen.mask(face, (EVERYWHERE,)), shade, face.box, target, screen)
        unlit = face.unlit(lit.occlusions)
        by_mesh = screen is not None and screen.light_map is not None
        shade = own_shade(face, lit.light if unlit or is_caster or by_mesh else None, face.box)
        if is_caster and not shade.is_even:
            # It passes over into a face that is turned away: every tile is a little dark.
            dark = OwnShade(shade.switches | {"DARK_WHEN_TURNED"}, shade.uniforms, is_even=False)
            return self._drawing.adding.add_own(set_seen.mask(face, unlit), dark, face.box, target, screen)
        if not unlit and not by_mesh:
            return None
        return self._drawing.adding.add_own(set_seen.mask(face, unlit), shade, face.box, target, screen)
