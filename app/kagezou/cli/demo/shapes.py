"""Flat shapes as signed distances: exact anti-aliased edges from a few lines of arithmetic over a box of pixels.

All lengths are canvas px, y down. A distance is negative inside; a pixel is covered by 0.5 − distance, clipped to 0..1.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import reduce
from math import ceil, cos, floor, sin

import numpy as np
from numpy.typing import NDArray

Point = tuple[float, float]
Grid = NDArray[np.float32]
Color = tuple[int, int, int]
Bounds = tuple[float, float, float, float]


@dataclass(frozen=True, slots=True)
class DrawnShape:
    """A shape: ``distance(x, y)`` of pixel centres, and bounds (left, top, right, bottom) outside which it is not."""

    bounds: Bounds
    distance: Callable[[Grid, Grid], Grid]

    def __or__(self, other: "DrawnShape") -> "DrawnShape":
        """Return both."""
        bounds = _around(self.bounds, other.bounds)
        return DrawnShape(bounds, lambda x, y: np.minimum(self.distance(x, y), other.distance(x, y)))

    def __and__(self, other: "DrawnShape") -> "DrawnShape":
        """Return what is in both."""
        return DrawnShape(self.bounds, lambda x, y: np.maximum(self.distance(x, y), other.distance(x, y)))

    def __sub__(self, other: "DrawnShape") -> "DrawnShape":
        """Return what is not in the other."""
        return DrawnShape(self.bounds, lambda x, y: np.maximum(self.distance(x, y), -other.distance(x, y)))

    def grown(self, margin: float) -> "DrawnShape":
        """Return the shape, larger by a margin all around."""
        left, top, right, bottom = self.bounds
        bounds = (left - margin, top - margin, right + margin, bottom + margin)
        return DrawnShape(bounds, lambda x, y: self.distance(x, y) - np.float32(margin))

    def moved(self, dx: float, dy: float) -> "DrawnShape":
        """Return the shape elsewhere."""
        left, top, right, bottom = self.bounds
        bounds = (left + dx, top + dy, right + dx, bottom + dy)
        return DrawnShape(bounds, lambda x, y: self.distance(x - np.float32(dx), y - np.float32(dy)))


def circle(center: Point, radius: float) -> DrawnShape:
    """Return a disc."""
    return cone(center, center, radius, radius)


def cone(start: Point, end: Point, start_radius: float, end_radius: float) -> DrawnShape:
    """Return a stroke from one disc to another."""
    (ax, ay), (bx, by) = start, end
    reach = max(start_radius, end_radius)
    bounds = (min(ax, bx) - reach, min(ay, by) - reach, max(ax, bx) + reach, max(ay, by) + reach)
    dx, dy = bx - ax, by - ay
    scale = 1.0 / max(dx * dx + dy * dy, 1e-6)

    def distance(x: Grid, y: Grid) -> Grid:
        along = np.clip(((x - ax) * dx + (y - ay) * dy) * scale, 0.0, 1.0)
        away_x, away_y = x - ax - dx * along, y - ay - dy * along
        away = np.sqrt(away_x * away_x + away_y * away_y)
        return np.asarray(away - (start_radius + (end_radius - start_radius) * along), np.float32)

    return DrawnShape(bounds, distance)


def stroke(points: Sequence[Point], radii: Sequence[float]) -> DrawnShape:
    """Return a stroke through points with a radius at each."""
    pairs = zip(points, points[1:], radii, radii[1:], strict=False)
    return reduce(DrawnShape.__or__, (cone(a, b, ra, rb) for a, b, ra, rb in pairs))


def ellipse(center: Point, half_width: float, half_height: float, turn: float = 0.0) -> DrawnShape:
    """Return an ellipse turned by ``turn`` radians; its distance is exact near the edge, where it matters."""
    cx, cy = center
    reach = max(half_width, half_height)
    cosine, sine = cos(turn), sin(turn)

    def distance(x: Grid, y: Grid) -> Grid:
        u = ((x - cx) * cosine + (y - cy) * sine) / half_width
        v = ((y - cy) * cosine - (x - cx) * sine) / half_height
        level = np.hypot(u, v)
        steepness = np.hypot(u / half_width, v / half_height)
        return np.asarray(level * (level - 1.0) / np.maximum(steepness, 1e-6), np.float32)

    return DrawnShape((cx - reach, cy - reach, cx + reach, cy + reach), distance)


def polygon(points: Sequence[Point], rounding: float = 0.0) -> DrawnShape:
    """Return a polygon whose corners are rounded outward by a radius."""
    corners = np.asarray(points, np.float32)
    left, top = (corners.min(axis=0) - rounding).tolist()
    right, bottom = (corners.max(axis=0) + rounding).tolist()

    def distance(x: Grid, y: Grid) -> Grid:
        nearest = np.full(np.broadcast_shapes(x.shape, y.shape), np.inf, np.float32)
        inside = np.zeros(nearest.shape, np.bool_)
        for (ax, ay), (bx, by) in zip(corners, np.roll(corners, 1, axis=0), strict=True):
            ex, ey = bx - ax, by - ay
            wx, wy = x - ax, y - ay
            along = np.clip((wx * ex + wy * ey) / max(ex * ex + ey * ey, np.float32(1e-6)), 0.0, 1.0)
            np.minimum(nearest, (wx - ex * along) ** 2 + (wy - ey * along) ** 2, out=nearest)
            crosses = (y >= ay) != (y >= by)
            if ay != by:
                inside ^= crosses & (wx < wy * (ex / ey))
        away = np.sqrt(nearest)
        return np.where(inside, -away, away) - np.float32(rounding)

    return DrawnShape((left, top, right, bottom), distance)


def blended(a: DrawnShape, b: DrawnShape, softness: float) -> DrawnShape:
    """Return both, grown together where they meet within ``softness`` px."""

    def distance(x: Grid, y: Grid) -> Grid:
        da, db = a.distance(x, y), b.distance(x, y)
        near = np.maximum(softness - np.abs(da - db), 0.0) / softness
        return np.asarray(np.minimum(da, db) - near * near * (softness / 4), np.float32)

    return DrawnShape(_around(a.bounds, b.bounds), distance)


def curve(start: Point, control: Point, end: Point, count: int = 14) -> list[Point]:
    """Return points of a quadratic bezier."""
    points: list[Point] = []
    for step in range(count):
        t = step / (count - 1)
        first, middle, last = (1 - t) ** 2, 2 * t * (1 - t), t * t
        x, y = (first * a + middle * b + last * c for a, b, c in zip(start, control, end, strict=True))
        points.append((x, y))
    return points


class PaperSheet:
    """A transparent sheet that shapes are painted on, one over the other.

    Parameters
    ----------
    width_px, height_px
        Its size.
    """

    def __init__(self, width_px: int, height_px: int) -> None:
        self._light = np.zeros((height_px, width_px, 4), np.float32)
        """Colour × alpha, and alpha, 0 to 1."""

    def paint(self, shape: DrawnShape, color: Color, opacity: float = 1.0) -> None:
        """Lay a flat colour over what is there."""
        place = self._place(shape, 0.0)
        if place is not None:
            self._lay(place, _cover(shape.distance(*place.centres)) * np.float32(opacity), color)

    def paint_inked(self, shape: DrawnShape, line_px: float, ink: Color, fill: Color) -> None:
        """Lay a shape filled with one colour in an outline of another."""
        place = self._place(shape, line_px)
        if place is not None:
            distance = shape.distance(*place.centres)
            self._lay(place, _cover(distance - np.float32(line_px)), ink)
            self._lay(place, _cover(distance), fill)

    def _place(self, shape: DrawnShape, margin: float) -> "_Place | None":
        height, width = self._light.shape[:2]
        left, top = (max(floor(edge - margin) - 1, 0) for edge in shape.bounds[:2])
        right = min(ceil(shape.bounds[2] + margin) + 1, width)
        bottom = min(ceil(shape.bounds[3] + margin) + 1, height)
        return None if left >= right or top >= bottom else _Place(left, top, right, bottom)

    def _lay(self, place: "_Place", cover: Grid, color: Color) -> None:
        under = self._light[place.top : place.bottom, place.left : place.right]
        under *= 1.0 - cover[..., None]
        under += cover[..., None] * (np.asarray((*color, 255), np.float32) / 255)

    def pixels(self) -> NDArray[np.uint8]:
        """Return straight (H, W, 4)."""
        alpha = self._light[..., 3:]
        straight = self._light.copy()
        np.divide(self._light[..., :3], alpha, out=straight[..., :3], where=alpha > 0)
        return (np.clip(straight, 0.0, 1.0) * 255 + 0.5).astype(np.uint8)


@dataclass(frozen=True, slots=True)
class _Place:
    """The pixels of a sheet that a shape may cover."""

    left: int
    top: int
    right: int
    bottom: int

    @property
    def centres(self) -> tuple[Grid, Grid]:
        """The pixels' centres: a row of x and a column of y."""
        x = np.arange(self.left, self.right, dtype=np.float32)[None, :] + np.float32(0.5)
        y = np.arange(self.top, self.bottom, dtype=np.float32)[:, None] + np.float32(0.5)
        return x, y


def _cover(distance: Grid) -> Grid:
    return np.asarray(np.clip(0.5 - distance, 0.0, 1.0), np.float32)


def _around(a: Bounds, b: Bounds) -> Bounds:
    return (min(a[0], b[0]), min(a[1], b[1]), max(a[2], b[2]), max(a[3], b[3]))
