"""How a layer lays its drawings on the canvas: moved, turned, scaled and mirrored about an anchor."""

from dataclasses import dataclass
from math import ceil, cos, floor, radians, sin

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.vectors import Matrix, Point2

_LEAST_SCALE = 1e-6
"""What is scaled to less has no picture."""


@dataclass(frozen=True, slots=True)
class Placement:
    """From where a drawing lies centred on the canvas, pixel for pixel, to where it is seen; both in canvas px.

    Parameters
    ----------
    position
        Where the anchor is seen.
    anchor
        Where it lies in the centred drawing.
    scale
        In x and in y, 1 for as drawn; below 0 mirrored.
    rotation_deg
        Clockwise as it is seen.
    """

    position: Point2
    anchor: Point2
    scale: Point2 = (1.0, 1.0)
    rotation_deg: float = 0.0

    @property
    def is_seen(self) -> bool:
        """Whether it leaves anything to be seen."""
        return min(abs(each) for each in self.scale) >= _LEAST_SCALE

    @property
    def moves(self) -> bool:
        """Whether drawings do not lie as they would without it."""
        return self.scale != (1.0, 1.0) or self.rotation_deg % 360 != 0 or self.position != self.anchor

    def canvas_from_centred(self) -> Matrix:
        """Return it as an affine map (3, 3)."""
        turn = radians(self.rotation_deg)
        (sx, sy), (ax, ay), (px, py) = self.scale, self.anchor, self.position
        # In steps of a quarter the sine must be exact, or texels would lie between pixels.
        c, s = (round(each) if self.rotation_deg % 90 == 0 else each for each in (cos(turn), sin(turn)))
        linear = np.array([[c * sx, -s * sy], [s * sx, c * sy]])
        shift = np.array([px, py]) - linear @ (ax, ay)
        return np.vstack([np.column_stack([linear, shift]), [0.0, 0.0, 1.0]])

    def centred_from_canvas(self) -> Matrix:
        """Return the way back (3, 3); it must be seen."""
        return np.asarray(np.linalg.inv(self.canvas_from_centred()), np.float64)

    def placed(self, point: Point2) -> Point2:
        """Return where a point of the centred drawing is seen."""
        x, y, _ = self.canvas_from_centred() @ (*point, 1.0)
        return (float(x), float(y))


def canvas_from_centred(placement: Placement | None) -> Matrix:
    """Return the map (3, 3) of a placement; None moves nothing."""
    return np.eye(3) if placement is None else placement.canvas_from_centred()


def centred_from_canvas(placement: Placement | None) -> Matrix:
    """Return the way back (3, 3); None moves nothing."""
    return np.eye(3) if placement is None else placement.centred_from_canvas()


def lie_alike(one: Placement | None, other: Placement | None) -> bool:
    """Whether the pixels of two drawings fall on each other: one is moved against the other by whole px alone."""
    if one == other:
        return True
    shift = centred_from_canvas(one) @ canvas_from_centred(other)
    return bool(np.allclose(shift, whole_shift(shift), rtol=0, atol=1e-6))


def whole_shift(affine: Matrix) -> Matrix:
    """Return the move by whole px that is nearest to an affine map (3, 3)."""
    shift = np.eye(3)
    shift[:2, 2] = np.round(affine[:2, 2])
    return shift


def around_placed(box: Box, affine: Matrix) -> Box:
    """Return the smallest whole box around a box that an affine map (3, 3) moves, px."""
    xs, ys = (box.left, box.right, box.right, box.left), (box.top, box.top, box.bottom, box.bottom)
    x, y, _ = affine @ np.array([xs, ys, (1, 1, 1, 1)], np.float64)
    # Rounding of what should be whole must not add a pixel.
    left, top, right, bottom = x.min() + 1e-6, y.min() + 1e-6, x.max() - 1e-6, y.max() - 1e-6
    return Box(floor(left), floor(top), ceil(right), ceil(bottom))
