"""What of a set a filtered shadow is laid on: the bodies that receive it, and how each face that is seen shows it."""

from collections.abc import Iterator

from kagezou.geometry.sets.faces_seen import GROUND, Face
from kagezou.geometry.vectors import Vector4
from kagezou.render.prepare.filter_charts import Receivers
from kagezou.render.prepare.filter_job import BlurView, FilterJob
from kagezou.render.prepare.set_as_seen import SetAsSeen
from kagezou.scene.pieces import PieceScene


def blocks(piece: PieceScene) -> bool:
    """Whether a piece ends characters' shadows."""
    return piece.blocks


def casts(piece: PieceScene) -> bool:
    """Whether a piece throws a shadow itself."""
    return piece.casts


def receivers_of(set_seen: SetAsSeen, light: Vector4) -> Receivers:
    """Return the bodies that receive, and what those that block take of the ground."""
    bodies = {index: body for index, body in enumerate(set_seen.bodies) if set_seen.owners[index].receives}
    occlusions = set_seen.occlusions(light, blocks)
    ground = next((face for face in set_seen.faces if face.body == GROUND), None)
    return Receivers(bodies, () if ground is None else ground.unlit(occlusions))


def views_of(set_seen: SetAsSeen, job: FilterJob) -> Iterator[tuple[Face, BlurView]]:
    """Yield the ground and the faces laid flat that are seen, and how they show a job."""
    sheets = [(number, sheet) for number, sheet in enumerate(job.development.sheets) if sheet.is_looked_up]
    for face in set_seen.faces:
        if face.body == GROUND:
            yield face, BlurView.of_ground(job, face.box)
        for number, sheet in sheets:
            if face.body == sheet.face.body and face.plane == sheet.face.plane:
                yield face, BlurView.of_sheet(job, number, face.box)
