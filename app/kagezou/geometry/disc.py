"""A disc on the ground, and the ellipse it is seen as: what a round shadow is cast by.

The light along the ground's normal casts a disc that floats over the ground exactly onto the one below it. So it is one
more silhouette on a card, and everything that is done to shadows goes on from there.
"""

from dataclasses import dataclass
from math import atan2, degrees, sqrt
from typing import Final

import numpy as np

from kagezou.geometry.camera import Camera
from kagezou.geometry.card import Card, CardPiece
from kagezou.geometry.ground import Plane
from kagezou.geometry.vectors import Matrix, Point2, Vector3, Vector4, height_over

_NEAREST: Final = 0.1
"""So much of its middle's distance from the eye, at least, every point of a disc is away from it."""


@dataclass(frozen=True, slots=True)
class Ellipse:
    """An ellipse on the canvas.

    Parameters
    ----------
    middle
        Canvas px.
    half_axes
        Half the length of each axis, canvas px.
    rotation_deg
        How far the first axis is turned from the x axis, clockwise as it is seen.
    """

    middle: Point2
    half_axes: Point2
    rotation_deg: float


def light_over(ground: Plane) -> Vector4:
    """Return the direction straight up from the ground, homogeneous."""
    return (*ground.normal, 0.0)


def floating_disc(
    camera: Camera, ground: Plane, middle: Vector3, radius_px: float, height_px: float
) -> tuple[Card, Ellipse] | None:
    """Return the card of a disc that floats over the ground, and how the disc is seen; None where that is edge-on.

    Parameters
    ----------
    camera, ground
        What it is seen with, and over which it floats.
    middle
        Of the disc below it, a place on the ground before the eye, world px.
    radius_px
        Its radius; less where a part of it would not be before the eye.
    height_px
        How high it floats, over 0; less where the eye would not look down on all of it.
    """
    _, _, distance, w = camera.eye
    radius, height = radius_px, height_px
    _, _, forward = ground.v
    _, _, rising = ground.normal
    if w:
        room = distance - middle[2]
        radius = min(radius, (1 - _NEAREST) * room / max(forward, 1e-9))
        height = min(height, (room - radius * forward) / 2 / max(rising, 1e-9))
        over = height_over(ground.equation, camera.eye)
        height = min(height, over / 2) if over > 0 else height
    x, y, z = (place + height * up for place, up in zip(middle, ground.normal, strict=True))
    world_from_unit = np.array(
        [[*(radius * np.array(ground.u)), 0.0], [*(radius * np.array(ground.v)), 0.0], [x, y, z, 1.0]]
    ).T
    ellipse = ellipse_of_circle(camera.canvas_from_world() @ world_from_unit)
    if min(ellipse.half_axes) < 1e-6 * max(ellipse.half_axes):
        return None
    return Card((CardPiece((x, y, z), ground.normal),), (middle,), contact_line=(middle, ground.u)), ellipse


def ellipse_of_circle(canvas_from_unit: Matrix) -> Ellipse:
    """Return the ellipse as which a homography (3, 3) shows the unit circle; all of it must lie before the eye."""
    # What touches the circle touches the ellipse, so its tangents are mapped.
    dual = canvas_from_unit @ np.diag([1.0, 1.0, -1.0]) @ canvas_from_unit.T
    dual = dual / -dual[2, 2]
    middle = -dual[:2, 2]
    squares, axes = np.linalg.eigh(dual[:2, :2] + np.outer(middle, middle))
    first, second = (sqrt(max(float(each), 0.0)) for each in squares[::-1])
    along = axes[:, 1]
    x, y = (float(each) for each in middle)
    return Ellipse((x, y), (first, second), degrees(atan2(float(along[1]), float(along[0]))))
