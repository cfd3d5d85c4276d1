"""What lines of a picture tell about the camera: two edges of the floor that run away, and two square to them.

Lines that are parallel on the ground meet in one point of the picture. Two such points lie on the horizon, which gives
roll and declination; that the two directions are square to each other gives the field of view. All points are taken
from the middle of the canvas, in its height, so that no number depends on the resolution.
"""

from dataclasses import dataclass, replace
from enum import StrEnum
from math import atan, atan2, cos, degrees, hypot, pi, radians, sin, sqrt, tan
from typing import Final, TypeAlias

import numpy as np

from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import Plane
from kagezou.geometry.vectors import Matrix, Point2, Vector3

Line: TypeAlias = tuple[Point2, Point2]
"""A piece of a straight line by its ends, canvas px."""

USUAL_FOV_DEG: Final = 40.0
"""What a picture is taken for where nothing tells its field of view: about a lens of 35 mm."""

_WIDEST_FOV_DEG: Final = 120.0
_AT_INFINITY: Final = 50.0
"""Lines that meet farther away than so many canvas heights count as parallel; their point tells no field of view."""

_SAME: Final = 1e-9

_TOO_SHORT: Final = 0.004
"""A line of less, in canvas heights, has no direction that a hand could have meant."""


@dataclass(frozen=True, slots=True)
class VanishingLines:
    """Edges of the floor in a picture: two that are parallel there, and two square to them.

    ``kept_fov_deg`` is the field of view that is kept while the lines tell none: that of before they told one.
    """

    first: tuple[Line, Line]
    second: tuple[Line, Line]
    kept_fov_deg: float | None = None

    @property
    def all(self) -> tuple[Line, Line, Line, Line]:
        """The four lines, the first two first."""
        return (*self.first, *self.second)

    def with_line(self, index: int, line: Line) -> "VanishingLines":
        """Return the lines with one of the four replaced."""
        a, b, c, d = (line if number == index else old for number, old in enumerate(self.all))
        return replace(self, first=(a, b), second=(c, d))


@dataclass(frozen=True, slots=True)
class CameraMatch:
    """What the lines tell: ``camera.fov``, ``ground.roll`` and ``ground.declination`` in degrees.

    ``tells_fov`` is false where the field of view is the one that was to be kept.
    """

    fov_deg: float
    roll_deg: float
    declination_deg: float
    tells_fov: bool = True


class Mismatch(StrEnum):
    """Why lines tell nothing."""

    SAME_LINE = "same-line"
    """Two of them that should be parallel on the floor lie on one another, or one has no length."""
    ALL_PARALLEL = "all-parallel"
    """Both directions have their points at infinity."""
    NOT_SQUARE = "not-square"
    """No camera sees these two directions square to each other on one floor."""


@dataclass(frozen=True, slots=True)
class Horizon:
    """Where the ground's horizon is seen: ``height_px`` above the middle of the canvas, square to the rolled line."""

    height_px: float
    roll_deg: float


def horizon_of(camera: Camera, roll_deg: float, declination_deg: float) -> Horizon | None:
    """Return the horizon of the ground, or None where it is at infinity: seen without perspective, or from above."""
    if camera.eye[3] == 0 or declination_deg < 1e-3:
        return None
    return Horizon(camera.eye[2] / tan(radians(declination_deg)), roll_deg)


def declination_below(camera: Camera, height_px: float) -> float:
    """Return the declination whose horizon is seen so high above the middle of the canvas; 90 for one below it."""
    return degrees(atan2(camera.eye[2], max(height_px, 0.0)))


def matched(lines: VanishingLines, size_px: Point2, fov_deg: float) -> CameraMatch | Mismatch:
    """Return the camera and ground in whose view the lines are what they are said to be.

    Parameters
    ----------
    lines
        Canvas px.
    size_px
        The canvas.
    fov_deg
        The field of view to keep where one direction's lines are parallel in the picture, which tells none.
    """
    points = [_meeting(pair, size_px) for pair in (lines.first, lines.second)]
    if any(point is None for point in points):
        return Mismatch.SAME_LINE
    (x1, y1, w1), (x2, y2, w2) = (point for point in points if point is not None)
    if w1 == 0 and w2 == 0:
        return Mismatch.ALL_PARALLEL
    a, b, c = (y1 * w2 - y2 * w1, x2 * w1 - x1 * w2, x1 * y2 - x2 * y1)
    length = hypot(a, b)
    if length < _SAME:
        return Mismatch.SAME_LINE
    # Pointing up in the picture, where the sky is.
    sign = -1.0 if b > 0 or (b == 0 and a < 0) else 1.0
    a, b, c = (sign * part / length for part in (a, b, c))
    tells_fov = w1 != 0 and w2 != 0
    if not tells_fov:
        focal = 0.5 / tan(radians(fov_deg or USUAL_FOV_DEG) / 2)
    else:
        square = -(x1 * x2 + y1 * y2) / (w1 * w2)
        if square <= 0:
            return Mismatch.NOT_SQUARE
        focal = max(sqrt(square), 0.5 / tan(radians(_WIDEST_FOV_DEG) / 2))
    fov, roll, declination = 2 * atan(0.5 / focal), atan2(a, -b), atan2(focal, max(-c, 0.0))
    return CameraMatch(degrees(fov), degrees(roll), degrees(declination), tells_fov)


def azimuth_of(pair: tuple[Line, Line], camera: Camera, ground: Plane) -> float | None:
    """Return the direction on the ground of lines that meet, degrees from its u toward its v, 0 to 180; None for one.

    None also without perspective, where directions have no points.
    """
    size = (float(camera.width_px), float(camera.height_px))
    point = _meeting(pair, size)
    if point is None or camera.eye[3] == 0:
        return None
    x, y, w = point
    way = np.array([x * size[1], y * size[1], -w * camera.eye[2]])
    return degrees(atan2(float(way @ ground.v), float(way @ ground.u)) % pi)


def laid(lines: VanishingLines, camera: Camera, ground: Plane, azimuth_deg: float) -> VanishingLines:
    """Return the lines turned about their middles so that they run along a direction of the ground and square to it.

    Parameters
    ----------
    lines
        Whose places and lengths are kept.
    camera, ground
        As they are to be seen.
    azimuth_deg
        The first direction, from the ground's u toward its v.
    """
    turned = []
    for number, line in enumerate(lines.all):
        angle = radians(azimuth_deg + (0.0 if number < 2 else 90.0))
        u, v, _ = ground.world_from_plane().T
        turned.append(_toward(line, _vanishing_point(camera, cos(angle) * u + sin(angle) * v)))
    first, second, third, fourth = turned
    return replace(lines, first=(first, second), second=(third, fourth))


def first_lines(size_px: Point2) -> VanishingLines:
    """Return four lines on the lower half of a picture, still to be laid."""
    width, height = size_px
    half = 0.11 * width

    def line(x: float, y: float) -> Line:
        return ((x * width - half, y * height), (x * width + half, y * height))

    return VanishingLines((line(0.3, 0.66), line(0.36, 0.86)), (line(0.7, 0.66), line(0.64, 0.86)))


def vanishing_point(pair: tuple[Line, Line], size_px: Point2) -> Point2 | None:
    """Return where two lines meet, canvas px; None where they are parallel or the same."""
    point = _meeting(pair, size_px)
    if point is None or point[2] == 0:
        return None
    x, y, w = point
    width, height = size_px
    return (width / 2 + height * x / w, height / 2 + height * y / w)


def _meeting(pair: tuple[Line, Line], size_px: Point2) -> Vector3 | None:
    """Return where two lines meet, homogeneous, of length 1; w = 0 at infinity; None for the same or no line."""
    (a, b), (c, d) = (tuple(_from_middle(end, size_px) for end in line) for line in pair)
    lines = [np.cross(a, b), np.cross(c, d)]
    lengths = [hypot(line[0], line[1]) for line in lines]
    if min(lengths) < _TOO_SHORT:
        return None
    point = np.cross(lines[0] / lengths[0], lines[1] / lengths[1])
    length = float(np.linalg.norm(point))
    if length < _SAME:
        return None
    x, y, w = (float(part) / length for part in point)
    if abs(w) * _AT_INFINITY < hypot(x, y):
        flat = hypot(x, y)
        return (x / flat, y / flat, 0.0)
    return (x, y, w)


def _from_middle(point: Point2, size_px: Point2) -> Matrix:
    return np.array([(point[0] - size_px[0] / 2) / size_px[1], (point[1] - size_px[1] / 2) / size_px[1], 1.0])


def _vanishing_point(camera: Camera, direction: Matrix) -> Matrix:
    """Return where a direction of the world vanishes, homogeneous canvas px."""
    x, y, distance, w = camera.eye
    if w == 0:
        return np.array([direction[0], direction[1], 0.0])
    return np.array([x * direction[2] - distance * direction[0], y * direction[2] - distance * direction[1],
                     direction[2]])  # fmt: skip


def _toward(line: Line, point: Matrix) -> Line:
    """Return a line turned about its middle to run through a homogeneous point, its ends in their old order."""
    (ax, ay), (bx, by) = line
    mx, my, half = (ax + bx) / 2, (ay + by) / 2, hypot(bx - ax, by - ay) / 2
    dx, dy = float(point[0] - mx * point[2]), float(point[1] - my * point[2])
    length = hypot(dx, dy)
    if length < _SAME:
        return line
    reach = half / length if dx * (bx - ax) + dy * (by - ay) >= 0 else -half / length
    return ((mx - reach * dx, my - reach * dy), (mx + reach * dx, my + reach * dy))
