"""The pass that measures a set: how far from the contact line every place is, down the ground and up its faces."""

import numpy as np

from kagezou.geometry.contact import contact_plane
from kagezou.geometry.ground import Plane, canvas_from_plane
from kagezou.geometry.sets.faces_seen import Face
from kagezou.geometry.sets.laid_flat import GROUND as THE_GROUND
from kagezou.geometry.sets.laid_flat import FlatSheet
from kagezou.geometry.sets.unfolding import unfolded
from kagezou.geometry.vectors import Matrix
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.program import Program
from kagezou.render.gpu.scratches import Scratches
from kagezou.render.gpu.targets import Target
from kagezou.render.passes.cast import CastPass
from kagezou.render.passes.fade_and_tip import distance_uniforms
from kagezou.render.prepare.filter_charts import flat_faces
from kagezou.render.prepare.set_as_seen import SetAsSeen
from kagezou.render.prepare.set_receivers import receivers_of
from kagezou.render.sets.add_face import Adding
from kagezou.scene.scene import ShadowCast

_AWAY = np.array([0.0, 1.0, 0.0])


class DistancePass:
    """Draws distances into targets of floating point; where only round faces or meshes are seen they stay 0."""

    def __init__(self, boxes: Boxes, caster: CastPass) -> None:
        self._boxes = boxes
        self._adding = Adding(boxes, caster)
        self._measure = Program("common/box.vert", "sets/distance.frag")
        self._scratches = Scratches()

    def draw(self, cast: ShadowCast, target: Target) -> None:
        """Draw the distances of a cast's receivers."""
        set_seen = SetAsSeen.of(cast.camera, target.box, cast.receivers[0], cast.pieces)
        contact = contact_plane(cast.card, cast.receivers[0])
        faces = flat_faces(cast, receivers_of(set_seen, cast.lights[0]))
        forms = _forms(unfolded(contact, tuple(faces), 2, 0.0).sheets)
        target.clear()
        alone = self._scratches.like("alone", target)
        for face in set_seen.faces:
            # What no shadow falls on counts like the ground seen there, so that the parts of a pixel at its rim add up.
            found = forms.get((face.body, face.plane), (contact, _AWAY))
            self._add(set_seen, face, cast, found, (alone, target))

    def close(self) -> None:
        """Give the memory back."""
        self._adding.close()
        self._measure.close()
        self._scratches.close()

    def _add(
        self,
        set_seen: SetAsSeen,
        face: Face,
        cast: ShadowCast,
        found: tuple[Plane, Matrix],
        targets: tuple[Target, Target],
    ) -> None:
        alone, target = targets
        plane, form = found
        alone.bind(face.box)
        plane_from_canvas = np.asarray(np.linalg.inv(canvas_from_plane(cast.camera, plane)), np.float64)
        uniforms = distance_uniforms(form @ plane_from_canvas, plane_from_canvas[2], face.box)
        self._measure.use({"u_target_size_px": alone.size_px, **uniforms})
        self._boxes.draw_one(face.box)
        self._adding.add(set_seen.mask(face, ()), alone, face.box, target)


def _forms(sheets: tuple[FlatSheet, ...]) -> dict[tuple[int, Plane], tuple[Plane, Matrix]]:
    """Return for each face its plane and the form (3,) over (u, v, 1) of it whose value is the distance.

    To the nearest place of the hinge it is that of what the face hangs on, and from there straight on.
    """
    flat: list[Matrix] = []
    result: dict[tuple[int, Plane], tuple[Plane, Matrix]] = {}
    for sheet in sheets:
        below = flat[sheet.parent] if sheet.parent != THE_GROUND else _AWAY * (np.sign(sheet.seam[:, 1].sum()) or 1.0)
        run = sheet.seam[1] - sheet.seam[0]
        normal = np.array([-run[1], run[0]]) / np.linalg.norm(run)
        normal *= np.sign((sheet.corners.mean(axis=0) - sheet.seam[0]) @ normal) or 1.0
        more = 1.0 - float(below[:2] @ normal)
        form = np.array([*(below[:2] + more * normal), below[2] - more * float(sheet.seam[0] @ normal)])
        flat.append(form)
        if not sheet.is_guest:
            result[sheet.face.body, sheet.face.plane] = (sheet.face.plane, np.asarray(form @ sheet.flat_from_plane))
    return result
