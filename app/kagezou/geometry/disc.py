"""A disc on the ground, and the ellipse it is seen as: what a round shadow is cast by.

The light along the ground's normal casts a disc that floats over the ground exactly onto the one below it. So it is one
more silhouette on a card, and everything that is done to shadows goes on from there.
"""

from collections.abc import Sequence
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


@dataclass(frozen=True, slots=True)
class GroundDisc:
    """A disc that lies on the ground.

    Parameters
    ----------
    middle
        A place on the ground before the eye, world px.
    radius_px
        Less counts where a part of it would not be before the eye.
    """

    middle: Vector3
    radius_px: float


def floating_discs(
    camera: Camera, ground: Plane, discs: Sequence[GroundDisc], height_px: float
) -> tuple[Card, tuple[Ellipse, ...]] | None:
    """Return the card of discs that float over the ground, and how each is seen; None where that is edge-on.

    Parameters
    ----------
    camera, ground
        What they are seen with, and over which they float.
    discs
        Those below them, at least one.
    height_px
        How high they float, over 0; less where the eye would not look down on all of them.
    """
    radii = [_radius_before_eye(camera, ground, disc) for disc in discs]
    height = min(
        _height_below_eye(camera, ground, disc.middle, radius, height_px)
        for disc, radius in zip(discs, radii, strict=True)
    )
    ellipses = []
    for disc, radius in zip(discs, radii, strict=True):
        above = _above(ground, disc.middle, height)
        world_from_unit = np.array(
            [[*(radius * np.array(ground.u)), 0.0], [*(radius * np.array(ground.v)), 0.0], [*above, 1.0]]
        ).T
        ellipse = ellipse_of_circle(camera.canvas_from_world() @ world_from_unit)
        if min(ellipse.half_axes) < 1e-6 * max(ellipse.half_axes):
            return None
        ellipses.append(ellipse)
    first = discs[0].middle
    piece = CardPiece(_above(ground, first, height), ground.normal)
    return Card((piece,), tuple(disc.middle for disc in discs), contact_line=(first, ground.u)), tuple(ellipses)


def _above(ground: Plane, place: Vector3, height: float) -> Vector3:
    x, y, z = (at + height * up for at, up in zip(place, ground.normal, strict=True))
    return (x, y, z)


def _radius_before_eye(camera: Camera, ground: Plane, disc: GroundDisc) -> float:
    _, _, distance, w = camera.eye
    if not w:
        return disc.radius_px
    return min(disc.radius_px, (1 - _NEAREST) * (distance - disc.middle[2]) / max(ground.v[2], 1e-9))


def _height_below_eye(camera: Camera, ground: Plane, middle: Vector3, radius: float, height: float) -> float:
    _, _, distance, w = camera.eye
    if not w:
        return height
    height = min(height, (distance - middle[2] - radius * ground.v[2]) / 2 / max(ground.normal[2], 1e-9))
    over = height_over(ground.equation, camera.eye)
    return min(height, over / 2) if over > 0 else height


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
