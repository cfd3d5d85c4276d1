"""A set under a light, and what every shadow on it is drawn with: kept views, scratches, and faces added up."""

from collections import OrderedDict
from collections.abc import Callable

from kagezou.geometry.box import Box, around
from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import Plane
from kagezou.geometry.sets.faces_seen import Face, go_on
from kagezou.geometry.sets.round_faces_seen import RoundFace
from kagezou.geometry.vectors import Vector4
from kagezou.io.sets.mesh_cache import MeshCache
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.scratches import Scratches
from kagezou.render.gpu.targets import Target
from kagezou.render.meshes.light_map import Taken
from kagezou.render.meshes.mesh_pass import MeshLit, MeshPass
from kagezou.render.meshes.occlusion import Screen
from kagezou.render.passes.cast import CastPass
from kagezou.render.prepare.mask_tiles import Mask
from kagezou.render.prepare.set_as_seen import SetAsSeen
from kagezou.render.sets.add_face import Adding
from kagezou.render.sets.lit_set import Lit
from kagezou.render.sets.round_faces import RoundPass
from kagezou.scene.pieces import PieceScene

_KEPT_VIEWS = 4


class SetDrawing:
    """What the passes of a set share.

    Attributes
    ----------
    adding, round, mesh
        What adds up flat faces, draws round ones, and draws meshes.
    scratches
        Targets for faces that are drawn alone.
    between
        Called before each face; what it raises ends the drawing.
    """

    between: Callable[[], None]

    def __init__(self, boxes: Boxes, caster: CastPass, meshes: MeshCache) -> None:
        self.adding = Adding(boxes, caster)
        self.round = RoundPass(boxes)
        self.mesh = MeshPass(boxes, meshes)
        self.scratches = Scratches()
        self.between = go_on
        self._views: OrderedDict[int, SetAsSeen] = OrderedDict()

    def close(self) -> None:
        """Give the memory back."""
        self.adding.close()
        self.round.close()
        self.mesh.close()
        self.scratches.close()

    def set_seen(self, camera: Camera, canvas: Box, ground: Plane, pieces: tuple[PieceScene, ...]) -> SetAsSeen:
        """Return a set as a camera sees it; the last few are kept."""
        for key, set_seen in self._views.items():
            if set_seen.is_of(camera, ground, pieces):
                self._views.move_to_end(key)
                return set_seen
        set_seen = SetAsSeen.of(camera, canvas, ground, pieces, self.between)
        self._views[id(set_seen)] = set_seen
        if len(self._views) > _KEPT_VIEWS:
            self._views.popitem(last=False)
        return set_seen

    def lit(self, set_seen: SetAsSeen, light: Vector4, ground: Plane | None, taken: Taken) -> Lit:
        """Return a set under a light that some of its pieces take."""
        view = self.mesh.view(set_seen, Box(0, 0, set_seen.camera.width_px, set_seen.camera.height_px))
        meshes = None if view is None else self.mesh.lit(view, set_seen, light, ground, taken)
        return Lit(set_seen, light, set_seen.occlusions(light, taken.by), meshes)

    def unlit(self, set_seen: SetAsSeen, light: Vector4, ground: Plane | None) -> Lit:
        """Return a set under a light that nobody keeps from anybody."""
        view = self.mesh.view(set_seen, Box(0, 0, set_seen.camera.width_px, set_seen.camera.height_px))
        return Lit(set_seen, light, {}, None if view is None else MeshLit(view, set_seen, light, {}, None, ground))

    def screen(self, lit: Lit, face: Face | RoundFace) -> Screen | None:
        """Return what meshes hide of a face, and keep from it; None without meshes."""
        return None if lit.meshes is None else self.mesh.screen(lit.meshes, face)

    def add_round(self, lit: Lit, face: RoundFace, box: Box | None, target: Target) -> Box | None:
        """Add what is seen of a round face, and empty the scratch it was drawn in."""
        if box is None:
            return None
        alone = self.scratches.like("face", target)
        drawn = self.adding.add(SetAsSeen.round_mask(face), alone, box, target, self.screen(lit, face))
        alone.clear(box)
        return drawn

    def united(self, own: Target, box: Box | None, target: Target, drawn: Box | None) -> Box | None:
        """Unite what one light drew in ``own`` with the whole, and empty it; return the box that may hold anything."""
        if box is not None and own is not target:
            self.adding.unite(own, box, target)
            own.clear(box)
        return around(drawn, box)


def mask_of(lit: Lit, face: Face) -> Mask:
    """Return what is seen and lit of a flat face."""
    return lit.set_seen.mask(face, face.unlit(lit.occlusions))
