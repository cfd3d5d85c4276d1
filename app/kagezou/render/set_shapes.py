"""What of a set a filtered shadow is laid on: the bodies that receive it, and how each face that is seen shows it."""

from collections.abc import Iterator

from kagezou.geometry.set_view import GROUND, Face
from kagezou.geometry.vectors import Vector4
from kagezou.render.set_stage import Stage
from kagezou.render.shape_charts import Receivers
from kagezou.render.shape_job import Job, View
from kagezou.scene.pieces import PieceScene


def blocks(piece: PieceScene) -> bool:
    """Whether a piece ends characters' shadows."""
    return piece.blocks


def casts(piece: PieceScene) -> bool:
    """Whether a piece throws a shadow itself."""
    return piece.casts


def receivers_of(stage: Stage, light: Vector4) -> Receivers:
    """Return the bodies that receive, and what those that block take of the ground."""
    bodies = {index: body for index, body in enumerate(stage.bodies) if stage.owners[index].receives}
    veils = stage.veils(light, blocks)
    ground = next((face for face in stage.faces if face.body == GROUND), None)
    return Receivers(bodies, () if ground is None else ground.unlit(veils))


def views_of(stage: Stage, job: Job) -> Iterator[tuple[Face, View]]:
    """Yield the ground and the faces laid flat that are seen, and how they show a job."""
    sheets = [(number, sheet) for number, sheet in enumerate(job.development.sheets) if sheet.is_looked_up]
    for face in stage.faces:
        if face.body == GROUND:
            yield face, View.of_ground(job, face.box)
        for number, sheet in sheets:
            if face.body == sheet.face.body and face.plane == sheet.face.plane:
                yield face, View.of_sheet(job, number, face.box)
