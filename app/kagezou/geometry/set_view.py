"""What a camera sees of a set: the ground and every flat face that is turned to it, and what hides parts of them."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import Plane, world_from_canvas_on
from kagezou.geometry.pieces import Body, Drum, Solid
from kagezou.geometry.polygon import bounding_box, box_polygon, clipped, shifted
from kagezou.geometry.regions import Flat, Group, Region, Taken, apart
from kagezou.geometry.vectors import Matrix, Vector4
from kagezou.geometry.veils import Cone, Veil, end_cone, facet_cone, veil_of

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
    """

    body: int
    plane: Plane
    flat: Flat
    outline: Region | None
    hidden: dict[int, Taken]
    box: Box

    def unlit(self, bodies: Sequence[Body], veils: dict[int, Veil]) -> tuple[Group, ...]:
        """Return what each of the veils of a light takes from this face."""
        groups: list[Group] = []
        for index, veil in veils.items():
            if index == self.body:
                continue
            taken = self.flat.group(bodies[index], veil, keeps_footprint=False)
            if taken is not None:
                seen = self.hidden.get(index)
                groups.append(taken[0] if seen is None else apart(taken, seen))
        return tuple(groups)


def faces_of(camera: Camera, canvas: Box, ground: Plane, bodies: Sequence[Body]) -> tuple[Face, ...]:
    """Return the ground and the flat faces turned to the eye, those outside of the canvas left out."""
    outlines: list[tuple[int, Plane, Cone | None]] = [(GROUND, ground, None)]
    for index, body in enumerate(bodies):
        outlines += [(index, plane, cone) for plane, cone in _seen_of(body, camera.eye)]
    veils = [veil_of(body, camera.eye) for body in bodies]
    found: list[Face] = []
    for index, plane, cone in outlines:
        lift = world_from_canvas_on(camera, plane)
        if lift is None:
            continue
        flat = Flat(lift / np.abs(lift).max(), plane.equation)
        outline = None if cone is None else flat.outline(cone)
        box = canvas if outline is None else region_box(outline, canvas)
        if box is not None:
            others = (
                (other, flat.group(bodies[other], veil, keeps_footprint=True)) for other, veil in enumerate(veils)
            )
            hidden = {other: taken for other, taken in others if other != index and taken is not None}
            found.append(Face(index, plane, flat, outline, hidden, box))
    return tuple(found)


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
