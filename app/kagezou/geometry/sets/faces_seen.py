"""What a camera sees of a set: the ground and every flat face that is turned to it, and what hides parts of them."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import Plane, world_from_canvas_on
from kagezou.geometry.polygon import bounding_box, box_polygon, clipped, shifted
from kagezou.geometry.sets.bodies import Body, Drum, Solid
from kagezou.geometry.sets.heights import BodyHeights
from kagezou.geometry.sets.occlusion_cones import Cone, Occlusion, end_cone, facet_cone, occlusion_of
from kagezou.geometry.sets.regions import TOUCHING_PX, Flat, Group, Region, Taken, apart, beyond
from kagezou.geometry.vectors import Matrix, Vector4

GROUND = -1
"""Stands for the ground where a body is counted."""


@dataclass(frozen=True, slots=True, eq=False)
class Face:
    """A flat receiver that is seen.

    Parameters
    ----------
    body
        Which of the bodies it belongs to, or GROUND.
    plane
        Its plane, the normal toward the eye.
    flat
        The same as forms.
    outline
        Where on the canvas it would be seen alone; None for everywhere.
    hidden
        What each body hides of it, by the body.
    box
        The canvas box it is seen in.
    heights
        Those of the bodies over any plane.
    """

    body: int
    plane: Plane
    flat: Flat
    outline: Region | None
    hidden: dict[int, Taken]
    box: Box
    heights: BodyHeights

    def unlit(self, occlusions: dict[int, Occlusion]) -> tuple[Group, ...]:
        """Return what each of the occlusions of a light takes from this face."""
        groups: list[Group] = []
        over = self._over()
        for index, occlusion in occlusions.items():
            if index not in over:
                continue
            taken = self.flat.group(over[index], occlusion, keeps_footprint=False)
            if taken is not None:
                seen = self.hidden.get(index)
                groups.append(self._beyond(taken[0] if seen is None else apart(taken, seen)))
        return tuple(groups)

    def hidden_by(self, occlusions: Sequence[Occlusion]) -> "Face":
        """Return the face with what the camera's occlusions, one a body, but for its own body's, hide of it."""
        hidden: dict[int, Taken] = {}
        for index, span in self._over().items():
            taken = self.flat.group(span, occlusions[index], keeps_footprint=True)
            if taken is not None:
                hidden[index] = (self._beyond(taken[0]), taken[1])
        return replace(self, hidden=hidden)

    def _over(self) -> dict[int, tuple[float, float]]:
        """Return the heights of the bodies that reach over the face, but for its own: no other takes anything of it."""
        spans = self.heights.over(self.flat.equation)
        reaching = np.flatnonzero(spans[:, 1] > TOUCHING_PX)
        return {
            index: (low, high)
            for index, (low, high) in zip(reaching.tolist(), spans[reaching].tolist(), strict=True)
            if index != self.body
        }

    def _beyond(self, group: Group) -> Group:
        return group if self.outline is None else beyond(group, self.outline, self.box)


def go_on() -> None:
    """Do nothing between two faces."""


def faces_of(
    camera: Camera, canvas: Box, ground: Plane, bodies: Sequence[Body], between: Callable[[], None] = go_on
) -> tuple[Face, ...]:
    """Return the ground and the flat faces turned to the eye, those outside of the canvas left out.

    Of many bodies this takes long: ``between`` is called before each face, and what it raises ends the work.
    """
    occlusions = [occlusion_of(body, camera.eye) for body in bodies]
    heights = BodyHeights(bodies)
    found = [_face(camera, canvas, (GROUND, ground, None), heights)]
    for index, body in enumerate(bodies):
        found += [_face(camera, canvas, (index, *seen), heights) for seen in _seen_of(body, camera.eye)]
    made: list[Face] = []
    for face in found:
        if face is not None:
            between()
            made.append(face.hidden_by(occlusions))
    return tuple(made)


def _face(camera: Camera, canvas: Box, seen: tuple[int, Plane, Cone | None], heights: BodyHeights) -> Face | None:
    """Return a face, given by its body, its plane and the eye's cone over it, as if nothing else were there."""
    body, plane, cone = seen
    lift = world_from_canvas_on(camera, plane)
    if lift is None:
        return None
    rim = (
        None if cone is None or cone.edges is None else np.column_stack([cone.edges[:, 0], np.ones(len(cone.edges))]).T
    )
    flat = Flat(lift / np.abs(lift).max(), plane.equation, rim)
    outline = None if cone is None else flat.outline(cone)
    box = canvas if outline is None else region_box(outline, canvas)
    return None if box is None else Face(body, plane, flat, outline, {}, box, heights)


def _seen_of(body: Body, eye: Vector4) -> Iterator[tuple[Plane, Cone]]:
    """Yield the flat faces of a body that are turned to the eye, with the eye's cones over them."""
    if isinstance(body, Solid):
        for facet in body.facets:
            value = float(np.dot(facet.equation, eye))
            cone = facet_cone(facet, eye) if body.is_sheet or value > 0 else None
            if cone is not None:
                yield facet.plane(is_turned=value < 0), cone
    elif isinstance(body, Drum):
        end = end_cone(body, eye)
        if end is not None:
            yield end


def region_box(region: Region, canvas: Box) -> Box | None:
    """Return the canvas box around a region, grown by a pixel, or None where it lies outside of the canvas."""
    polygon = box_polygon(canvas)
    for line in region.lines:
        polygon = clipped(polygon, shifted(line, 1.0))
    around = bounding_box(polygon)
    if around is None or region.conic is None:
        return around and around.intersection(canvas)
    ellipse = _ellipse_box(region.conic)
    return around.intersection(canvas if ellipse is None else ellipse)


def _ellipse_box(conic: Matrix) -> Box | None:
    """Return the box around an ellipse, or None for a conic that is none."""
    if conic[0, 0] >= 0 or float(np.linalg.det(conic[:2, :2])) <= 1e-12 * conic[0, 0] ** 2:
        return None
    # Its tangents are the lines l with l·C⁻¹·l = 0; those that run along x and y bound it.
    dual = np.linalg.inv(conic)
    roots = dual[[0, 1], 2] ** 2 - dual[[0, 1], [0, 1]] * dual[2, 2]
    reach = np.sqrt(np.maximum(roots, 0.0)) / abs(dual[2, 2])
    middle = dual[[0, 1], 2] / dual[2, 2]
    low, high = np.floor(middle - reach) - 1, np.ceil(middle + reach) + 1
    return Box(int(low[0]), int(low[1]), int(high[0]), int(high[1]))
