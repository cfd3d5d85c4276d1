"""Convex polygons on the canvas and the half-planes that cut them."""

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.vectors import Matrix


def distance_form(form: Matrix) -> Matrix:
    """Scale a linear form (3,) over canvas points (x, y, 1) so that its value is a signed distance in px.

    A constant form has no edge; it is returned as everywhere inside (+1e6 px) or outside (−1e6 px).
    """
    length = float(np.hypot(form[0], form[1]))
    if length < 1e-12 * (1e-12 + abs(float(form[2]))):
        return np.array([0.0, 0.0, 1e6 if form[2] > 0 else -1e6])
    return np.asarray(form / length)


def distance_forms(forms: Matrix) -> Matrix:
    """Scale linear forms (N, 3) as :func:`distance_form` does one."""
    lengths = np.hypot(forms[:, 0], forms[:, 1])
    is_constant = lengths < 1e-12 * (1e-12 + np.abs(forms[:, 2]))
    scaled = forms / np.where(is_constant, 1.0, lengths)[:, np.newaxis]
    scaled[is_constant] = 0.0
    scaled[is_constant, 2] = np.where(forms[is_constant, 2] > 0, 1e6, -1e6)
    return np.asarray(scaled)


def shifted(form: Matrix, margin_px: float) -> Matrix:
    """Return a distance form whose half-plane is ``margin_px`` larger."""
    return np.asarray(form + np.array([0.0, 0.0, margin_px]))


def box_polygon(box: Box) -> Matrix:
    """Return the corners (4, 2) of a box in canvas px."""
    return np.array(
        [(box.left, box.top), (box.right, box.top), (box.right, box.bottom), (box.left, box.bottom)],
        dtype=np.float64,
    )


def clipped(polygon: Matrix, form: Matrix) -> Matrix:
    """Return the part (M, 2) of a convex polygon (N, 2) where a linear form is >= 0; M may be 0."""
    # Few corners: plain numbers are several times as fast as arrays.
    a, b, c = form.tolist()
    points: list[list[float]] = polygon.tolist()
    values = [a * x + b * y + c for x, y in points]
    if all(value >= 0 for value in values):
        return polygon
    corners: list[tuple[float, float]] = []
    ends = zip(points[1:] + points[:1], values[1:] + values[:1], strict=True)
    for (x, y), value, ((next_x, next_y), following) in zip(points, values, ends, strict=True):
        if value >= 0:
            corners.append((x, y))
        if (value >= 0) != (following >= 0):
            t = value / (value - following)
            corners.append((x + t * (next_x - x), y + t * (next_y - y)))
    return np.array(corners) if len(corners) >= 3 else np.empty((0, 2))


def bounding_box(polygon: Matrix) -> Box | None:
    """Return the smallest pixel box around a polygon (N, 2), or None for an empty one."""
    if len(polygon) == 0:
        return None
    low, high = np.floor(polygon.min(axis=0)), np.ceil(polygon.max(axis=0))
    return Box(int(low[0]), int(low[1]), int(high[0]), int(high[1]))


def rectangle_edges(
    plane_from_canvas: Matrix, low: tuple[float, float], high: tuple[float, float]
) -> tuple[Matrix, Matrix, Matrix, Matrix]:
    """Return the four edges of a rectangle of a plane as distance forms (3,) in canvas px, each >= 0 inside."""
    x_row, y_row, w_row = plane_from_canvas
    return (
        distance_form(x_row - low[0] * w_row),
        distance_form(high[0] * w_row - x_row),
        distance_form(y_row - low[1] * w_row),
        distance_form(high[1] * w_row - y_row),
    )


def seen_rectangle(
    canvas: Box, plane_from_canvas: Matrix, low: tuple[float, float], high: tuple[float, float], margin_px: float = 1.0
) -> Matrix:
    """Return the convex polygon (N, 2) of a canvas in which a rectangle of a plane is seen.

    Parameters
    ----------
    canvas
        The polygon is cut to it.
    plane_from_canvas
        (3, 3) homography whose w is positive where the plane is seen.
    low, high
        The corners of the rectangle on the plane.
    margin_px
        How much larger than the rectangle the polygon is, canvas px.
    """
    polygon = clipped(box_polygon(canvas), shifted(distance_form(plane_from_canvas[2]), -0.01))
    for edge in rectangle_edges(plane_from_canvas, low, high):
        polygon = clipped(polygon, shifted(edge, margin_px))
    return polygon
