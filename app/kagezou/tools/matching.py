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
_SAME_DEG = 1e-6

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


def handles(geometry: FrameGeometry) -> tuple[Handle, ...]:
    """Return the ends of the four lines, and two places of the horizon."""
    fov, roll, declination = (
        geometry.address(prop) for prop in (properties.FOV, properties.GROUND_ROLL, properties.GROUND_DECLINATION)
    )
    made = [
        Handle(
            f"{END}.{2 * number + side}", HandleShape.SQUARE if number < 2 else HandleShape.DIAMOND, end, fov,
            _END_WORDS[number // 2], also=(declination, roll), index=2 * number + side, stays_in_view=True,
        )
        for number, line in enumerate(lines_of(geometry).all)
        for side, end in enumerate(line)
    ]  # fmt: skip
    horizon = _horizon(geometry)
    if horizon is not None:
        middle, end = (_on_horizon(geometry, horizon, along) for along in (0.0, _end_distance(geometry)))
        made += [
            Handle(HORIZON_END, HandleShape.SQUARE, end, roll, properties.GROUND_ROLL.label, Cursor.ROTATE),
            Handle(
                HORIZON, HandleShape.LEVER, middle, declination, _HORIZON_WORDS, Cursor.VERTICAL, stays_in_view=True
            ),
        ]
    return tuple(made)


def guides(geometry: FrameGeometry) -> tuple[Guide, ...]:
    """Return the four lines, what lies between them and the points where they meet, and the horizon."""
    lines, size = lines_of(geometry), _size(geometry)
    made: list[Guide] = []
    for pair, kind in ((lines.first, GuideKind.FLOOR_FIRST), (lines.second, GuideKind.FLOOR_SECOND)):
        point = vanishing_point(pair, size)
        if point is not None:
            made += [Guide(GuideKind.FLOOR_RAY, (_nearest(line, point), point)) for line in pair]
        made += [Guide(kind, line) for line in pair]
    horizon = _horizon(geometry)
    if horizon is not None:
        reach = hypot(*size)
        ends = (_on_horizon(geometry, horizon, along) for along in (-reach, reach))
        made.insert(0, Guide(GuideKind.HORIZON, tuple(ends)))
    return tuple(made)


def note_of(geometry: FrameGeometry) -> Message | None:
    """Return why the lines tell no camera, or no field of view; None where they tell all."""
    lines = geometry.document.vanishing
    if lines is None:
        return None
    match = matched(lines, _size(geometry), _fov_to_keep(geometry, lines))
    if isinstance(match, Mismatch):
        return _NOTES[match]
    if match.tells_fov:
        return None
    return Message(
        "lines that are parallel in the picture do not tell the field of view: it stays at {fov}°",
        fov=f"{match.fov_deg:.1f}",
    )


def lines_of(geometry: FrameGeometry) -> VanishingLines:
    """Return the lines of the project; before there are any, four that run as the present ground would."""
    if geometry.document.vanishing is not None:
        return geometry.document.vanishing
    return laid(first_lines(_size(geometry)), _camera(geometry), geometry.ground, _FIRST_AZIMUTH_DEG)


def move_end(geometry: FrameGeometry, handle: Handle, aim: Aim) -> Document:
    """Move an end of a line; camera and ground follow as soon as the lines make sense."""
    assert handle.index is not None
    lines, number, side = lines_of(geometry), handle.index // 2, handle.index % 2
    ends = list(lines.all[number])
    ends[side] = kept_near(aim.target)
    keep = _fov_to_keep(geometry, lines)
    lines = replace(lines.with_line(number, (ends[0], ends[1])), kept_fov_deg=keep)
    document = replace(geometry.document, vanishing=lines)
    match = matched(lines, _size(geometry), keep)
    if isinstance(match, Mismatch):
        return document
    document = geometry.edited(properties.FOV, match.fov_deg, document)
    document = geometry.edited(properties.GROUND_ROLL, match.roll_deg, document)
    return geometry.edited(properties.GROUND_DECLINATION, match.declination_deg, document)


def move_horizon(geometry: FrameGeometry, _handle: Handle, aim: Aim) -> Document:
    """Raise or lower the horizon: the ground is seen more from above or more from the edge."""
    roll = radians(geometry.value(properties.GROUND_ROLL))
    x, y = aim.target
    width, height = _size(geometry)
    above = sin(roll) * (x - width / 2) - cos(roll) * (y - height / 2)
    declination = declination_below(_camera(geometry), above)
    return _turned(geometry, geometry.value(properties.GROUND_ROLL), aim.angle(declination))


def move_horizon_end(geometry: FrameGeometry, _handle: Handle, aim: Aim) -> Document:
    """Roll the horizon about its middle."""
    horizon = _horizon(geometry)
    if horizon is None:
        return geometry.document
    x, y = _on_horizon(geometry, horizon, 0.0)
    dx, dy = aim.target[0] - x, aim.target[1] - y
    if hypot(dx, dy) < 1e-6:
        return geometry.document
    miss = abs(dy) if dx > 0 else inf
    return _turned(
        geometry,
        aim.angle_or_zero(degrees(atan2(dy, dx)), miss, geometry),
        geometry.value(properties.GROUND_DECLINATION),
    )


def _fov_to_keep(geometry: FrameGeometry, lines: VanishingLines) -> float:
    """Return the field of view for lines that tell none: the present one, unless it is only what the lines told."""
    now = geometry.camera.fov_deg
    if lines.kept_fov_deg is None:
        return now
    told = matched(lines, _size(geometry), lines.kept_fov_deg)
    from_lines = not isinstance(told, Mismatch) and abs(told.fov_deg - now) < _SAME_DEG
    return lines.kept_fov_deg if from_lines or isinstance(told, Mismatch) else now


def _turned(geometry: FrameGeometry, roll_deg: float, declination_deg: float) -> Document:
    """Return the document with the ground turned, the lines turned with it about their middles."""
    camera, lines = _camera(geometry), lines_of(geometry)
    document = geometry.edited(properties.FOV, camera.fov_deg)
    document = geometry.edited(properties.GROUND_ROLL, roll_deg, document)
    document = geometry.edited(properties.GROUND_DECLINATION, declination_deg, document)
    azimuth = azimuth_of(lines.first, camera, geometry.ground)
    if azimuth is None:
        return document
    return replace(document, vanishing=laid(lines, camera, _ground(geometry, document), azimuth))


def _ground(geometry: FrameGeometry, document: Document) -> Plane:
    roll, declination = (
        geometry.value(prop, document) for prop in (properties.GROUND_ROLL, properties.GROUND_DECLINATION)
    )
    return ground_plane(geometry.ground.origin[:2], roll, declination)


def _camera(geometry: FrameGeometry) -> Camera:
    """Return the camera, in perspective: without one a usual one is begun with."""
    camera = geometry.camera
    return camera if camera.eye[3] else Camera(camera.width_px, camera.height_px, USUAL_FOV_DEG)


def _horizon(geometry: FrameGeometry) -> Horizon | None:
    roll, declination = (geometry.value(prop) for prop in (properties.GROUND_ROLL, properties.GROUND_DECLINATION))
    return horizon_of(_camera(geometry), roll, declination)


def _on_horizon(geometry: FrameGeometry, horizon: Horizon, along_px: float) -> Point2:
    width, height = _size(geometry)
    roll = radians(horizon.roll_deg)
    return (
        width / 2 + horizon.height_px * sin(roll) + along_px * cos(roll),
        height / 2 - horizon.height_px * cos(roll) + along_px * sin(roll),
    )


def _end_distance(geometry: FrameGeometry) -> float:
    return _HORIZON_END_OF_WIDTH * geometry.document.canvas.width_px


def _size(geometry: FrameGeometry) -> Point2:
    canvas = geometry.document.canvas
    return (float(canvas.width_px), float(canvas.height_px))


def _nearest(line: tuple[Point2, Point2], point: Point2) -> Point2:
    return min(line, key=lambda end: hypot(end[0] - point[0], end[1] - point[1]))
