"""How two flat polygons in space go through each other."""

import numpy as np

from kagezou.geometry.vectors import Matrix

_PARALLEL = 1e-9


def crossing_px(one: Matrix, other: Matrix, least_px: float) -> float:
    """Return how long the line is on which two flat convex polygons go through each other, px; 0 where none does.

    Parameters
    ----------
    one, other
        Their corners in order, (N, 3) with N >= 3, world px.
    least_px
        By so much each must reach to either side of the other one's plane: what only touches does not go through.
    """
    first, second = _normal(one), _normal(other)
    common = np.cross(first, second)
    length = float(np.linalg.norm(common))
    if length < _PARALLEL:
        return 0.0
    along = common / length
    spans = [_span(one, (other[0], second), along, least_px), _span(other, (one[0], first), along, least_px)]
    low, high = max(span[0] for span in spans), min(span[1] for span in spans)
    return max(high - low, 0.0)


def _normal(polygon: Matrix) -> Matrix:
    """Return the unit normal (3,) of a polygon."""
    around = polygon - polygon[0]
    normal = np.cross(around, np.roll(around, -1, axis=0)).sum(axis=0)
    return np.asarray(normal / max(float(np.linalg.norm(normal)), 1e-300), np.float64)


def _span(polygon: Matrix, plane: tuple[Matrix, Matrix], along: Matrix, least_px: float) -> tuple[float, float]:
    """Return from where to where a polygon meets a plane, a point and its normal, measured along their line."""
    heights = (polygon - plane[0]) @ plane[1]
    if heights.min() > -least_px or heights.max() < least_px:
        return (0.0, 0.0)
    following, next_heights = np.roll(polygon, -1, axis=0), np.roll(heights, -1)
    crosses = (heights >= 0) != (next_heights >= 0)
    part = heights[crosses] / (heights[crosses] - next_heights[crosses])
    met = polygon[crosses] + part[:, np.newaxis] * (following[crosses] - polygon[crosses])
    places = met @ along
    return (float(places.min()), float(places.max()))
