"""A set as one camera sees it: its bodies, its faces, and what the camera's side of every mask is."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import Plane
from kagezou.geometry.sets.bodies import Body
from kagezou.geometry.sets.faces_seen import GROUND, Face, faces_of, go_on
from kagezou.geometry.sets.occlusion_cones import Occlusion, occlusion_of
from kagezou.geometry.sets.regions import Group
from kagezou.geometry.sets.round_faces_seen import RoundFace, round_faces_of
from kagezou.geometry.vectors import Vector4
from kagezou.render.prepare.mask_tiles import Mask
from kagezou.scene.pieces import PieceScene


@dataclass(frozen=True, slots=True, eq=False)
class SetAsSeen:
    """A set seen by a camera.

    Parameters
    ----------
    camera, ground, pieces
        What it was made of.
    bodies
        Those of all pieces, and ``owners`` the piece each belongs to.
    faces, rounds
        The flat receivers that are seen, the ground among them, and the round ones.
    eye_occlusions
        What each body hides from the eye.
    """

    camera: Camera
    ground: Plane
    pieces: tuple[PieceScene, ...]
    bodies: tuple[Body, ...]
    owners: tuple[PieceScene, ...]
    faces: tuple[Face, ...]
    rounds: tuple[RoundFace, ...]
    eye_occlusions: tuple[Occlusion, ...]

    @staticmethod
    def of(
        camera: Camera,
        canvas: Box,
        ground: Plane,
        pieces: tuple[PieceScene, ...],
        between: Callable[[], None] = go_on,
    ) -> "SetAsSeen":
        """Look at a set, ``between`` being called before each of its faces."""
        pairs = [(body, piece) for piece in pieces for body in piece.bodies]
        bodies = tuple(body for body, _ in pairs)
        owners = tuple(piece for _, piece in pairs)
        faces = faces_of(camera, canvas, ground, bodies, between)
        rounds = round_faces_of(camera, canvas, bodies)
        eye_occlusions = (
            tuple(occlusion_of(body, camera.eye) for body in bodies)
            if rounds or any(piece.mesh for piece in pieces)
            else ()
        )
        return SetAsSeen(camera, ground, pieces, bodies, owners, faces, rounds, eye_occlusions)

    def is_of(self, camera: Camera, ground: Plane, pieces: tuple[PieceScene, ...]) -> bool:
        """Whether it was made of these."""
        return self.pieces == pieces and self.camera == camera and self.ground == ground

    def receives(self, face: Face | RoundFace) -> bool:
        """Whether characters' shadows are to be shown on a face; the ground is asked about elsewhere."""
        return face.body == GROUND or self.owners[face.body].receives

    def is_caster(self, face: Face | RoundFace) -> bool:
        """Whether a face belongs to a piece whose own shadow is drawn."""
        return face.body != GROUND and self.owners[face.body].casts

    def occlusions(self, light: Vector4, wanted: Callable[[PieceScene], bool]) -> dict[int, Occlusion]:
        """Return what the bodies of the wanted pieces keep from a light, by their numbers."""
        chosen = ((index, body) for index, body in enumerate(self.bodies) if wanted(self.owners[index]))
        return {index: occlusion_of(body, light) for index, body in chosen}

    @staticmethod
    def round_mask(face: RoundFace) -> Mask:
        """Return the mask of a round face; what other bodies take of it is found on its surface."""
        return Mask(face.outline, () if face.end is None else (face.end,), ())

    def mask(self, face: Face, unlit: Sequence[Group]) -> Mask:
        """Return the mask of a face under a light."""
        outline = None if face.outline is None else Group((face.outline,), overlaps=False)
        return Mask(outline, tuple(taken[0] for taken in face.hidden.values()), tuple(unlit))
