"""The round faces of a set as a camera sees them: balls, and the sides of drums."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.sets.bodies import Ball, Body, Drum
from kagezou.geometry.sets.faces_seen import region_box
from kagezou.geometry.sets.occlusion_cones import end_cone, occlusion_of
from kagezou.geometry.sets.regions import Flat, Group
from kagezou.geometry.vectors import Matrix

_DRAWING = Flat(np.array([[1.0, 0, 0], [0, 1, 0], [0, 0, 0], [0, 0, 1]]), (0.0, 0.0, 1.0, 0.0))
"""The plane of the drawing: what holds for a whole ray from the eye may be asked at its point there."""


@dataclass(frozen=True, slots=True, eq=False)
class RoundFace:
    """A round receiver that is seen.

    Parameters
    ----------
    body
        Which of the bodies it is.
    shape
        That body.
    outline
        Where on the canvas it would be seen alone, with its end.
    end
        Where its flat end is seen instead; None for a ball, or where no end is turned to the eye.
    box
        The canvas box it is seen in.
    """

    body: int
    shape: Ball | Drum
    outline: Group
    end: Group | None
    box: Box

    @property
    def centre(self) -> Matrix:
        """The world point (3,) in its middle, around which its numbers are given."""
        if isinstance(self.shape, Ball):
            return np.array(self.shape.centre)
        return np.asarray((np.array(self.shape.foot) + np.array(self.shape.head)) / 2)

    @property
    def across(self) -> Matrix:
        """The (3, 3) part of its quadric: (X - centre)ᵀ·across·(X - centre) = radius² on the surface."""
        return np.asarray(self.shape.quadric[:3, :3])

    def seen_at(self, camera: Camera, points: Matrix) -> Matrix:
        """Return the world points (…, 4, N) seen at canvas points (…, 3, N); beside the face, those nearest to it."""
        ex, ey, ez, ew = camera.eye
        start = np.stack([points[..., 0, :], points[..., 1, :], np.zeros_like(points[..., 0, :])], axis=-2)
        start = start - self.centre[:, np.newaxis]
        eye = np.array([ex, ey, ez]) - ew * self.centre
        along = start * ew - eye[:, np.newaxis]
        bent = self.across @ along
        square = (along * bent).sum(axis=-2, keepdims=True)
        start = start - along * (start * bent).sum(axis=-2, keepdims=True) / square
        inside = self.shape.radius_px**2 - (start * (self.across @ start)).sum(axis=-2, keepdims=True)
        seen = start - along * np.sqrt(np.maximum(inside, 0.0) / square) + self.centre[:, np.newaxis]
        return np.concatenate([seen, np.ones_like(inside)], axis=-2)


def round_faces_of(camera: Camera, canvas: Box, bodies: Sequence[Body]) -> tuple[RoundFace, ...]:
    """Return the round faces on the canvas; a body around or behind the eye is not seen."""
    found = (
        _round_face(camera, canvas, index, body) for index, body in enumerate(bodies) if isinstance(body, (Ball, Drum))
    )
    return tuple(face for face in found if face is not None)


def _round_face(camera: Camera, canvas: Box, index: int, body: Ball | Drum) -> RoundFace | None:
    occlusion = occlusion_of(body, camera.eye)
    middle = np.append(body.centre if isinstance(body, Ball) else body.foot, 1.0)
    if not occlusion.cones or float(camera.canvas_from_world()[2] @ middle) <= 0:
        return None
    outline = Group(tuple(_DRAWING.outline(cone) for cone in occlusion.cones), overlaps=True)
    boxes = [box for box in (region_box(region, canvas) for region in outline.regions) if box is not None]
    if not boxes:
        return None
    box = boxes[0]
    for other in boxes[1:]:
        box = box.union(other)
    end = end_cone(body, camera.eye) if isinstance(body, Drum) else None
    seen_end = None if end is None else Group((_DRAWING.outline(end[1]),), overlaps=False)
    return RoundFace(index, body, outline, seen_end, box)
