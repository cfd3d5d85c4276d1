"""Drawn figures whose feet are known, and the gaits they have."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi, sin

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.vectors import Point2
from kagezou.standing.finding import FoundFeet
from kagezou.standing.outline import Outline, outline_of
from kagezou.standing.seen import Seen, SeenFoot, Stance

WIDTH_PX, HEIGHT_PX = 400, 400
GROUND = 360.0
FAR = 352.0
"""The ground rows of the near and the far foot of a figure about 300 px high."""

_Pixels = NDArray[np.bool_]


def figure(feet: Sequence[Point2], hip: Point2 = (200.0, 220.0), size: float = 1.0) -> NDArray[np.uint8]:
    """Return the alpha of a figure that has its soles at ``feet``; all lengths times ``size``."""
    y, x = np.mgrid[0 : round(HEIGHT_PX * size), 0 : round(WIDTH_PX * size)] + 0.5
    x, y = x / size, y / size
    hip_x, hip_y = hip
    solid = ((x - hip_x) / 40) ** 2 + ((y - hip_y + 60) / 75) ** 2 < 1
    solid |= (x - hip_x) ** 2 + (y - hip_y + 135) ** 2 < 25**2
    for foot_x, foot_y in feet:
        solid |= _limb(x, y, hip, (foot_x, foot_y - 14))
        solid |= (abs(x - foot_x) < 16) & (y < foot_y) & (y >= foot_y - 14)
    return np.where(solid, 255, 0).astype(np.uint8)


def _limb(x: NDArray[np.float64], y: NDArray[np.float64], start: Point2, end: Point2) -> _Pixels:
    along = np.array(end) - start
    share = np.clip(((x - start[0]) * along[0] + (y - start[1]) * along[1]) / (along @ along), 0, 1)
    near: _Pixels = np.hypot(x - start[0] - share * along[0], y - start[1] - share * along[1]) < 10
    return near


def outline(alpha: NDArray[np.uint8]) -> Outline | None:
    """Return the outline of a whole drawing."""
    return outline_of(alpha, 0, 0, alpha.shape[0])


@dataclass(frozen=True)
class Pose:
    """The soles of two feet, near and far, and which of them carry."""

    feet: tuple[Point2, Point2]
    carry: tuple[bool, bool]
    hip: Point2 = (200.0, 220.0)


def walk(drawings: int, cycle: int = 16) -> list[Pose]:
    """Return a walk on the spot to the right: each foot is down for six tenths of a cycle of drawings."""
    return [_walking(drawing / cycle) for drawing in range(drawings)]


def walk_speed(cycle: int = 16) -> float:
    """Return by how many px the ground runs back a drawing."""
    return _STRIDE_PX / (_DOWN * cycle)


_DOWN = 0.6
_STRIDE_PX = 90.0


def _walking(time: float) -> Pose:
    feet, carry = [], []
    for phase, row in ((time % 1, GROUND), ((time + 0.5) % 1, FAR)):
        down = phase < _DOWN
        share = phase / _DOWN if down else (phase - _DOWN) / (1 - _DOWN)
        x = 200 + _STRIDE_PX * (0.5 - share if down else share - 0.5)
        feet.append((x, row if down else row - 30 * sin(pi * share)))
        carry.append(down)
    return Pose((feet[0], feet[1]), (carry[0], carry[1]))


def jump(rises_px: Sequence[float]) -> list[Pose]:
    """Return a figure that stands with its feet apart, and is so high over the ground in each drawing."""
    return [
        Pose(((170.0, GROUND - up), (230.0, GROUND - up)), (up <= 0, up <= 0), (200.0, 220.0 - up)) for up in rises_px
    ]


def run(steps: int) -> list[Pose]:
    """Return a run on the spot: each foot is down for four drawings, then both are in the air for two."""
    result = []
    for drawing in range(6 * steps):
        feet, carry = [], []
        for offset in (0, 6):
            phase = (drawing + offset) % 12
            down = phase < _RUN_DOWN
            share = phase / _RUN_DOWN if down else (phase - _RUN_DOWN + 1) / (12 - _RUN_DOWN + 1)
            x = 200 + (60 - 30 * phase if down else -90 + 180 * share)
            feet.append((x, GROUND if down else GROUND - 70 * sin(pi * share)))
            carry.append(down)
        result.append(Pose((feet[0], feet[1]), (carry[0], carry[1])))
    return result


_RUN_DOWN = 4


def drawn(poses: Sequence[Pose], size: float = 1.0) -> list[Outline | None]:
    """Return the outlines of drawings of ``poses``."""
    return [outline(figure(pose.feet, pose.hip, size)) for pose in poses]


def seen(
    found: Sequence[FoundFeet], height_px: float = 300.0, exposure: int = 1, speed_px: float = 0.0
) -> tuple[Seen, ...]:
    """Return found feet as frames show them: each drawing for ``exposure`` frames, moved by ``speed_px`` a drawing."""
    return tuple(
        Seen(
            index * exposure,
            height_px if each.feet else 0.0,
            tuple(SeenFoot(foot.track, (foot.place[0] + index * speed_px, foot.place[1])) for foot in each.feet),
        )
        for index, each in enumerate(found)
    )


def planted_near(stance: Stance, place: Point2, reach_px: float = 20.0) -> bool:
    """Return whether a foot is planted there."""
    return any(foot.is_planted and abs(foot.place[0] - place[0]) <= reach_px for foot in stance.feet)
