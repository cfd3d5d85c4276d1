"""Between which heights over a plane each body of a set lies."""

from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.sets.bodies import Ball, Body, Drum, Solid
from kagezou.geometry.vectors import Vector4

Spans = NDArray[np.float64]
_NO_POINT: Final = (0.0, 0.0, 0.0)


class BodyHeights:
    """The corners of all bodies, laid out once: every face of a set asks for the heights of every body over it.

    Parameters
    ----------
    bodies
        Of a set, in world px.
    """

    def __init__(self, bodies: Sequence[Body]) -> None:
        corners = [_corners(body) for body in bodies]
        self._corners = np.array([corner for each in corners for corner in each], float).reshape(-1, 3)
        self._starts = np.cumsum([0, *map(len, corners)])[:-1]
        self._balls = np.array([body.radius_px if isinstance(body, Ball) else 0.0 for body in bodies])
        self._drums = np.array([body.radius_px if isinstance(body, Drum) else 0.0 for body in bodies])
        self._axes = np.array([body.axis if isinstance(body, Drum) else _NO_POINT for body in bodies]).reshape(-1, 3)

    def over(self, plane: Vector4) -> Spans:
        """Return (B, 2): between which heights over a plane (n, d) of unit normal each body lies, px."""
        if not len(self._starts):
            return np.zeros((0, 2))
        normal = np.array(plane[:3])
        heights = self._corners @ normal + plane[3]
        wide = self._balls + self._drums * np.sqrt(np.maximum(1.0 - (self._axes @ normal) ** 2, 0.0))
        low = np.minimum.reduceat(heights, self._starts) - wide
        high = np.maximum.reduceat(heights, self._starts) + wide
        return np.column_stack([low, high])


def _corners(body: Body) -> list[tuple[float, float, float]]:
    """Return the points between whose heights a body lies, but for its radius."""
    if isinstance(body, Solid):
        return list(dict.fromkeys(corner for facet in body.facets for corner in facet.corners))
    return [body.centre] if isinstance(body, Ball) else [body.foot, body.head]
