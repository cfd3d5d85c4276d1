"""How the child moves: two seconds of walking, a leap, a floating landing and a look up; poses as numbers.

Feet that stand are fixed on the ground, whatever the body does; everything else follows from where the body is.
"""

from dataclasses import dataclass
from math import atan2, cos, hypot, pi, sin, tau

FRAMES = 48
GROUND_Y = 838.0
"""The ground line, canvas px."""

_STEP = 112.0
_FRAMES_A_STEP = 12
_START_X = 226.0
_WALK_END = 24.0
_CROUCH_END = 30.0
_LAND = 42.0
_HIP_HEIGHT = 158.0

Point = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Foot:
    """An ankle above the ground and how far the toes point down, radians."""

    ankle: Point
    pitch: float


@dataclass(frozen=True, slots=True)
class Pose:
    """One drawing's pose; positions in canvas px, angles in radians, y down.

    Parameters
    ----------
    hip
        Where the legs meet.
    lean
        Of the body, forward.
    stretch
        Height of body and head against their rest: more than 1 in the leap, less in the crouch.
    near, far
        The feet.
    swing
        Of the free arm from hanging down, forward; −2 is thrown up behind.
    hold
        The hand with the string.
    balloon
        The middle of the balloon.
    sway
        How far the coat's hem is left behind, px.
    joy
        0 calm to 1 laughing.
    blink
        0 open to 1 closed.
    gaze
        How far the head looks up, 0 to 1.
    """

    hip: Point
    lean: float
    stretch: float
    near: Foot
    far: Foot
    swing: float
    hold: Point
    balloon: Point
    sway: float
    joy: float
    blink: float
    gaze: float


def pose_at(frame: int) -> Pose:
    """Return the pose of a frame, 1 to `FRAMES`."""
    time = frame - 1.0
    x, y = body_at(time)
    before_x, before_y = body_at(time - 1.0)
    speed_x, speed_y = x - before_x, y - before_y
    leap = _airborne(time)
    walking = 1.0 - _eased(time, _WALK_END - 2, _WALK_END + 2)
    stretch = 1.0 - 0.09 * _crouch(time) + 0.05 * leap * (1 if speed_y < 0 else 0.4)
    lean = 0.07 * walking + 0.10 * _crouch(time) - 0.04 * leap
    swing = -0.6 * walking * cos(tau * time / (2 * _FRAMES_A_STEP)) - 0.6 * _crouch(time) - 2.0 * leap
    calm = 0.25 * _eased(time, _LAND, _LAND + 4)
    hold = (x + 92 - 4 * leap, y - 146 * stretch - 22 * leap)
    return Pose(
        hip=(x, y),
        lean=lean,
        stretch=stretch,
        near=_foot_at(time, is_near=True),
        far=_foot_at(time, is_near=False),
        swing=swing - calm,
        hold=hold,
        balloon=_balloon_at(time, hold),
        sway=-2.2 * speed_x - 5 * sin(tau * time / _FRAMES_A_STEP) * walking,
        joy=_eased(time, _CROUCH_END - 1, _CROUCH_END + 3),
        blink=max(_bump(time, 9, 2.2), _bump(time, 44.5, 2.2)),
        gaze=_eased(time, _CROUCH_END - 6, _CROUCH_END) * 0.8 + 0.2,
    )


def body_at(time: float) -> Point:
    """Return where the hip is, ``time`` frames after the first."""
    end = _START_X + _STEP * _WALK_END / _FRAMES_A_STEP
    if time < _WALK_END:
        x = _START_X + _STEP * time / _FRAMES_A_STEP
    else:
        # Braking takes up the pace of the walk.
        braking = 1 - (1 - _line(time, _WALK_END, _CROUCH_END)) ** 2
        x = end + 28 * braking + 174 * _line(time, _CROUCH_END, _LAND)
    walking = 1.0 - _eased(time, _WALK_END - 2, _WALK_END + 2)
    bob = 7.0 * cos(tau * (time - 1.5) / _FRAMES_A_STEP) * walking
    rise = 118.0 * _airborne(time)
    return (x, GROUND_Y - _HIP_HEIGHT + bob + 34.0 * _crouch(time) - rise)


def _airborne(time: float) -> float:
    """Return the height of the leap, 0 to 1: up like a ball, down like someone under a balloon."""
    part = _line(time, _CROUCH_END, _LAND)
    top = 0.42
    if part < top:
        return 1 - ((top - part) / top) ** 2
    return 0.5 + 0.5 * cos(pi * (part - top) / (1 - top))


def _crouch(time: float) -> float:
    """Return how deep the knees are bent beyond walking, 0 to 1: before the leap and after it."""
    before = _eased(time, _WALK_END, _CROUCH_END - 2) * (1 - _eased(time, _CROUCH_END - 2, _CROUCH_END))
    after = 0.75 * _eased(time, _LAND - 1, _LAND + 1.5) * (1 - _eased(time, _LAND + 1.5, _LAND + 5))
    return before + after


def _foot_at(time: float, *, is_near: bool) -> Foot:
    if time >= _CROUCH_END:
        return _leaping_foot(time, is_near=is_near)
    if time >= _WALK_END:
        return _closing_foot(time, is_near=is_near)
    # A foot stands for one step and swings for the next; the feet take turns.
    phase = time / _FRAMES_A_STEP - (0.0 if is_near else 1.0)
    turn = phase // 2
    inside = phase - 2 * turn
    stands_at = _START_X + _STEP * (2 * turn + 0.5 + (0.0 if is_near else 1.0))
    if inside < 1:
        heel = 0.55 * _eased(inside, 0.72, 1.0) - 0.30 * (1 - _eased(inside, 0.0, 0.18))
        return _standing(stands_at, heel)
    part = inside - 1
    x = stands_at + 2 * _STEP * _eased(part, 0.0, 1.0)
    lift = 46.0 * sin(pi * part) ** 1.2
    heel = 0.55 - 0.85 * _eased(part, 0.05, 0.95)
    return Foot((x, GROUND_Y - 27 - 30 * max(heel, 0.0) - lift), heel)


def _standing(x: float, heel: float) -> Foot:
    """Return a foot on the ground; positive ``heel`` lifts the heel, negative the toes."""
    return Foot((x, GROUND_Y - 27 - 30 * max(heel, 0.0) - 8 * max(-heel, 0.0)), heel)


def _closing_foot(time: float, *, is_near: bool) -> Foot:
    end = _START_X + _STEP * 2
    if is_near:
        return _standing(end + _STEP / 2, 0.0)
    part = _eased(time, _WALK_END, _CROUCH_END - 2)
    return Foot((end - _STEP / 2 + 68 * part, GROUND_Y - 27 - 24 * sin(pi * part)), 0.4 * (1 - part))


def _leaping_foot(time: float, *, is_near: bool) -> Foot:
    hip_x, hip_y = body_at(time)
    leap = _airborne(time)
    apart = 22.0 if is_near else -32.0
    tuck = 0.0 if is_near else 26.0
    from_x = _START_X + _STEP * 2 + (_STEP / 2 if is_near else 12)
    land_x = body_at(_LAND)[0] + apart
    if time >= _LAND:
        return _standing(land_x, 0.0)
    ease = _eased(time, _CROUCH_END, _CROUCH_END + 3)
    x = from_x + (hip_x + apart - 20 * leap - from_x) * ease
    hanging = min(hip_y + 136 - tuck * leap, GROUND_Y - 27)
    y = GROUND_Y - 27 + (hanging - GROUND_Y + 27) * ease
    return Foot((x + (land_x - x) * _eased(time, _LAND - 4, _LAND), y), 0.75 * leap)


def _balloon_at(time: float, hold: Point) -> Point:
    """Return where the balloon hangs in the air: it comes late, and keeps up."""
    late_x, late_y = body_at(time - 5)
    now_x, now_y = body_at(time)
    drift = 10 * sin(tau * time / 31)
    return (hold[0] + 62 + 0.9 * (late_x - now_x) + drift, hold[1] - 252 + 0.3 * (late_y - now_y))


def knee_of(hip: Point, ankle: Point, thigh: float, shin: float) -> Point:
    """Return the knee of a leg whose knee points forward (+x); a leg too short is stretched straight."""
    dx, dy = ankle[0] - hip[0], ankle[1] - hip[1]
    reach = min(hypot(dx, dy), (thigh + shin) * 0.999)
    bend = (thigh * thigh + reach * reach - shin * shin) / (2 * max(thigh * reach, 1e-6))
    angle = atan2(dy, dx) - _acos(bend)
    return (hip[0] + thigh * cos(angle), hip[1] + thigh * sin(angle))


def _acos(value: float) -> float:
    clipped = min(max(value, -1.0), 1.0)
    return atan2((1 - clipped * clipped) ** 0.5, clipped)


def _line(value: float, low: float, high: float) -> float:
    return min(max((value - low) / (high - low), 0.0), 1.0)


def _eased(value: float, low: float, high: float) -> float:
    part = _line(value, low, high)
    return part * part * (3 - 2 * part)


def _bump(value: float, middle: float, reach: float) -> float:
    return max(1 - abs(value - middle) / reach, 0.0)
