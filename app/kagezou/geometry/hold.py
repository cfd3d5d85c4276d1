"""How far a simplified shadow is slid so that it begins at the feet again.

A wide blur draws the legs of a shadow into its body, and the body's near edge is left away from the contact line. The
whole shape is slid along the line from the feet to its middle, so that outline and area stay what they are. The edge is
told by a soft least distance, which islands that come and go pass through without a jump.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import log, sqrt
from typing import Final

import numpy as np

from kagezou.geometry.vectors import Matrix

_FEET_OF_SHAPE: Final = 0.08
"""So near to the contact line, as a part of the root of its area, a shadow is that of the feet."""

_SHARPNESS: Final = 4.0
"""How many times the softness of the least distance goes into the shape's half length."""

_BEYOND_SOFT_LEAST: Final = 0.60373
"""How far beyond the soft least distance the edge of an ellipse lies, in its half lengths: 1 - ln(2 I₁(4)/4)/4."""

_UNDER_FEET: Final = 0.12
"""So far, in half lengths, the shape goes on under the feet: both of a stance stand on its round end."""

_STILL_THERE: Final = 0.6
"""A shape that has so much of the feet's shadow left, or more, stands on the feet already."""


@dataclass(frozen=True, slots=True, eq=False)
class Patches:
    """A shape in small parts.

    Parameters
    ----------
    along, away
        (N,): the middle of each part, px along the contact line and away from it, signed.
    area
        (N,): how much of the shape it holds, px².
    """

    along: Matrix
    away: Matrix
    area: Matrix

    @staticmethod
    def of(parts: "Sequence[Patches]") -> "Patches":
        """Return several as one."""
        return Patches(*(np.concatenate([getattr(each, name) for each in parts]) for name in Patches.__slots__))

    @property
    def whole(self) -> float:
        """The area of the shape."""
        return float(self.area.sum())

    def mean(self, numbers: Matrix) -> float:
        """Return the mean of a number of each part (N,) over the shape."""
        return float(self.area @ numbers) / self.whole


def slide_to_feet(sharp: Patches, shape: Patches, left: Patches, hold: float) -> tuple[float, float]:
    """Return from how much farther along and away from the contact line the shape is to be read, px.

    Parameters
    ----------
    sharp
        The shadow before it was simplified.
    shape
        The same area after it.
    left
        What is left of the shadow in the shape: where both are.
    hold
        0 for the shape where it is, 1 for its near edge under the feet.
    """
    if hold <= 0 or sharp.whole <= 0 or shape.whole <= 0:
        return (0.0, 0.0)
    at_feet = _Feet.of(sharp)
    along, away = shape.along - at_feet.along_px, shape.away
    u, v = shape.mean(along), shape.mean(away)
    distance = sqrt(u * u + v * v)
    if distance <= 0:
        return (0.0, 0.0)
    u, v = u / distance, v / distance
    lost = max(1 - at_feet.area(left) / at_feet.area(sharp) / _STILL_THERE, 0.0)
    way = hold * lost * lost * _gap(shape, along * u + away * v)
    return (way * u, way * v)


@dataclass(frozen=True, slots=True)
class _Feet:
    """The part of a shadow that is nearest to the contact line.

    Parameters
    ----------
    near_px
        How far it reaches, as a standard deviation.
    least_px
        Where it begins, 0 at the line: something is nearest in any case.
    along_px
        Where along the line it lies.
    """

    near_px: float
    least_px: float
    along_px: float = 0.0

    @classmethod
    def of(cls, sharp: Patches) -> "_Feet":
        reach = _FEET_OF_SHAPE * sqrt(sharp.whole)
        near = cls(reach, max(float(np.abs(sharp.away[sharp.area > 0]).min()) - reach / 2, 0.0))
        weights = near._weights(sharp)
        return replace(near, along_px=float(weights @ sharp.along / weights.sum()))

    def area(self, shape: Patches) -> float:
        """Return how much of a shape is there, px²."""
        return float(self._weights(shape).sum())

    def _weights(self, shape: Patches) -> Matrix:
        return np.asarray(shape.area * np.exp(-0.5 * ((np.abs(shape.away) - self.least_px) / self.near_px) ** 2))


def _gap(shape: Patches, from_feet: Matrix) -> float:
    """Return how far the edge of a shape lies from where it is to be, px; 0 where it reaches farther already."""
    middle = shape.mean(from_feet)
    half = 2 * sqrt(shape.mean((from_feet - middle) ** 2))
    soft = half / _SHARPNESS
    if soft <= 0:
        return max(middle, 0.0)
    least = middle - soft * log(shape.mean(np.exp((middle - from_feet) / soft)))
    return max(least - (_BEYOND_SOFT_LEAST - _UNDER_FEET) * half, 0.0)
