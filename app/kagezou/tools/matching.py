"""Matching the camera to the background picture: edges of the floor and the horizon, dragged onto what is painted.

Two lines that run away on the floor and two square to them give field of view, declination and roll at once; the
horizon gives declination and roll for the field of view there is. The lines stay in the project, so that one can come
back to them.
"""

from dataclasses import replace
from math import atan2, cos, degrees, hypot, inf, radians, sin

from kagezou.document import properties
from kagezou.document.model import Document
from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import Plane, ground_plane
from kagezou.geometry.vanishing import (
    USUAL_FOV_DEG,
    Horizon,
    Mismatch,
    VanishingLines,
    azimuth_of,
    declination_below,
    first_lines,
    horizon_of,
    laid,
    matched,
    vanishing_point,
)
from kagezou.geometry.vectors import Point2
from kagezou.message import Message
from kagezou.tools.drag import Aim
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.ground import kept_near
from kagezou.tools.handle import Cursor, Guide, GuideKind, Handle, HandleShape

END = "match.end"
HORIZON = "match.horizon"
HORIZON_END = "match.horizon_end"

_FIRST_AZIMUTH_DEG = 45.0
_HORIZON_END_OF_WIDTH = 0.3

_END_WORDS = (
    Message("Edge of the floor, running away"),
    Message("Edge of the floor, square to it"),
)
_HORIZON_WORDS = Message("Horizon")
_NOTES = {
    Mismatch.SAME_LINE: Message("a line is too short, or lies on the other of its colour"),
    Mismatch.ALL_PARALLEL: Message("nothing runs together: there is no perspective in these lines"),
    Mismatch.NOT_SQUARE: Message("these lines cannot be square to each other on one floor"),
}  # fmt: skip


def handles(setting: FrameGeometry) -> tuple[Handle, ...]:
    """Return the ends of the four lines, and two places of the horizon."""
    fov, roll, declination = (
        setting.address(prop) for prop in (properties.FOV, properties.GROUND_ROLL, properties.GROUND_DECLINATION)
    )
    made = [
        Handle(
            f"{END}.{2 * number + side}", HandleShape.SQUARE if number < 2 else HandleShape.DIAMOND, end, fov,
            _END_WORDS[number // 2], also=(declination, roll), index=2 * number + side, stays_in_view=True,
        )
        for number, line in enumerate(lines_of(setting).all)
        for side, end in enumerate(line)
    ]  # fmt: skip
    horizon = _horizon(setting)
    if horizon is not None:
        middle, end = (_on_horizon(setting, horizon, along) for along in (0.0, _end_distance(setting)))
        made += [
            Handle(HORIZON_END, HandleShape.SQUARE, end, roll, properties.GROUND_ROLL.label, Cursor.ROTATE),
            Handle(
                HORIZON, HandleShape.LEVER, middle, declination, _HORIZON_WORDS, Cursor.VERTICAL, stays_in_view=True
            ),
        ]
    return tuple(made)


def guides(setting: FrameGeometry) -> tuple[Guide, ...]:
    """Return the four lines, what lies between them and the points where they meet, and the horizon."""
    lines, size = lines_of(setting), _size(setting)
    made: list[Guide] = []
    for pair, kind in ((lines.first, GuideKind.FLOOR_FIRST), (lines.second, GuideKind.FLOOR_SECOND)):
        point = vanishing_point(pair, size)
        if point is not None:
            made += [Guide(GuideKind.FLOOR_RAY, (_nearest(line, point), point)) for line in pair]
        made += [Guide(kind, line) for line in pair]
    horizon = _horizon(setting)
    if horizon is not None:
        reach = hypot(*size)
        ends = (_on_horizon(setting, horizon, along) for along in (-reach, reach))
        made.insert(0, Guide(GuideKind.HORIZON, tuple(ends)))
    return tuple(made)


def note_of(setting: FrameGeometry) -> Message | None:
    """Return why the lines tell no camera, None where they tell one."""
    if setting.document.vanishing is None:
        return None
    match = matched(setting.document.vanishing, _size(setting), setting.camera.fov_deg)
    return _NOTES[match] if isinstance(match, Mismatch) else None


def lines_of(setting: FrameGeometry) -> VanishingLines:
    """Return the lines of the project; before there are any, four that run as the present ground would."""
    if setting.document.vanishing is not None:
        return setting.document.vanishing
    return laid(first_lines(_size(setting)), _camera(setting), setting.ground, _FIRST_AZIMUTH_DEG)


def move_end(setting: FrameGeometry, handle: Handle, aim: Aim) -> Document:
    """Move an end of a line; camera and ground follow as soon as the lines make sense."""
    assert handle.index is not None
    lines, number, side = lines_of(setting), handle.index // 2, handle.index % 2
    ends = list(lines.all[number])
    ends[side] = kept_near(aim.target)
    lines = lines.with_line(number, (ends[0], ends[1]))
    document = replace(setting.document, vanishing=lines)
    match = matched(lines, _size(setting), setting.camera.fov_deg)
    if isinstance(match, Mismatch):
        return document
    document = setting.edited(properties.FOV, match.fov_deg, document)
    document = setting.edited(properties.GROUND_ROLL, match.roll_deg, document)
    return setting.edited(properties.GROUND_DECLINATION, match.declination_deg, document)


def move_horizon(setting: FrameGeometry, _handle: Handle, aim: Aim) -> Document:
    """Raise or lower the horizon: the ground is seen more from above or more from the edge."""
    roll = radians(setting.value(properties.GROUND_ROLL))
    x, y = aim.target
    width, height = _size(setting)
    above = sin(roll) * (x - width / 2) - cos(roll) * (y - height / 2)
    declination = declination_below(_camera(setting), above)
    return _turned(setting, setting.value(properties.GROUND_ROLL), aim.angle(declination))


def move_horizon_end(setting: FrameGeometry, _handle: Handle, aim: Aim) -> Document:
    """Roll the horizon about its middle."""
    horizon = _horizon(setting)
    if horizon is None:
        return setting.document
    x, y = _on_horizon(setting, horizon, 0.0)
    dx, dy = aim.target[0] - x, aim.target[1] - y
    if hypot(dx, dy) < 1e-6:
        return setting.document
    miss = abs(dy) if dx > 0 else inf
    return _turned(
        setting,
        aim.angle_or_zero(degrees(atan2(dy, dx)), miss, setting),
        setting.value(properties.GROUND_DECLINATION),
    )


def _turned(setting: FrameGeometry, roll_deg: float, declination_deg: float) -> Document:
    """Return the document with the ground turned, the lines turned with it about their middles."""
    camera, lines = _camera(setting), lines_of(setting)
    document = setting.edited(properties.FOV, camera.fov_deg)
    document = setting.edited(properties.GROUND_ROLL, roll_deg, document)
    document = setting.edited(properties.GROUND_DECLINATION, declination_deg, document)
    azimuth = azimuth_of(lines.first, camera, setting.ground)
    if azimuth is None:
        return document
    return replace(document, vanishing=laid(lines, camera, _ground(setting, document), azimuth))


def _ground(setting: FrameGeometry, document: Document) -> Plane:
    roll, declination = (
        setting.value(prop, document) for prop in (properties.GROUND_ROLL, properties.GROUND_DECLINATION)
    )
    return ground_plane(setting.ground.origin[:2], roll, declination)


def _camera(setting: FrameGeometry) -> Camera:
    """Return the camera, in perspective: without one a usual one is begun with."""
    camera = setting.camera
    return camera if camera.eye[3] else Camera(camera.width_px, camera.height_px, USUAL_FOV_DEG)


def _horizon(setting: FrameGeometry) -> Horizon | None:
    roll, declination = (setting.value(prop) for prop in (properties.GROUND_ROLL, properties.GROUND_DECLINATION))
    return horizon_of(_camera(setting), roll, declination)


def _on_horizon(setting: FrameGeometry, horizon: Horizon, along_px: float) -> Point2:
    width, height = _size(setting)
    roll = radians(horizon.roll_deg)
    return (
        width / 2 + horizon.height_px * sin(roll) + along_px * cos(roll),
        height / 2 - horizon.height_px * cos(roll) + along_px * sin(roll),
    )


def _end_distance(setting: FrameGeometry) -> float:
    return _HORIZON_END_OF_WIDTH * setting.document.canvas.width_px


def _size(setting: FrameGeometry) -> Point2:
    canvas = setting.document.canvas
    return (float(canvas.width_px), float(canvas.height_px))


def _nearest(line: tuple[Point2, Point2], point: Point2) -> Point2:
    return min(line, key=lambda end: hypot(end[0] - point[0], end[1] - point[1]))
