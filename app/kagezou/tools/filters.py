"""The filters: the line across the shadow at which simplifying is at its full strength, and an arrow for each wave.

Both lie on the ground, so that they are foreshortened as the shadow is.
"""

from math import atan2, cos, degrees, hypot, radians, sin

from kagezou.document import properties
from kagezou.document.model import Document
from kagezou.document.properties import WaveLines
from kagezou.geometry.contact import contact_plane
from kagezou.geometry.ground import Plane
from kagezou.geometry.vectors import Vector3, dot
from kagezou.message import Message
from kagezou.tools.drag import Aim
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.handle import Cursor, Guide, GuideKind, Handle, HandleShape
from kagezou.tools.shadow import tip_of
from kagezou.tools.sight import between, place_seen_at, seen
from kagezou.tools.sun import unwound

DISTANCE = "filter.distance"
WAVE1, WAVE2 = "filter.wave1", "filter.wave2"

_HALF_LINE_OF_FIGURE = 0.35
"""Half the length of the line, as a part of the figure's height."""

_WAVES = {WAVE1: properties.WAVE1, WAVE2: properties.WAVE2}


def handles(setting: FrameGeometry) -> tuple[Handle, ...]:
    """Return what the filters in use are taken hold of by."""
    if setting.layer is None or setting.card is None:
        return ()
    made: list[Handle] = []
    if _is_simplified(setting):
        made.append(
            Handle(
                DISTANCE, HandleShape.LEVER, seen(setting.camera, _line(setting)[1]),
                setting.address(properties.DISTANCE), properties.DISTANCE.label, Cursor.VERTICAL,
                layer_id=setting.layer.id,
            )
        )  # fmt: skip
    for handle_id, lines in _waves(setting).items():
        number = handle_id[-1]
        made.append(
            Handle(
                handle_id, HandleShape.ARROW, seen(setting.camera, _arrow(setting, lines)[1]),
                setting.address(lines.direction), Message("Wave {number}", number=number),
                also=(setting.address(lines.wavelength),), layer_id=setting.layer.id,
            )
        )  # fmt: skip
    return tuple(made)


def guides(setting: FrameGeometry) -> tuple[Guide, ...]:
    """Return the line of the distance, and the shafts of the arrows."""
    if setting.layer is None or setting.card is None:
        return ()
    made: list[Guide] = []
    if _is_simplified(setting):
        made.append(Guide(GuideKind.FILTER_DISTANCE, tuple(seen(setting.camera, end) for end in _line(setting))))
    made += [
        Guide(GuideKind.WAVE, tuple(seen(setting.camera, end) for end in _arrow(setting, lines)))
        for lines in _waves(setting).values()
    ]
    return tuple(made)


def move_distance(setting: FrameGeometry, _handle: Handle, aim: Aim) -> Document:
    """Move the line away from the feet, or up to them."""
    plane, end = _plane(setting), _line(setting)[1]
    place = place_seen_at(setting.camera, end, plane.normal, aim.straightened(setting.across).target)
    if place is None:
        return setting.document
    away = _side(setting) * dot(between(plane.origin, place), plane.v)
    return setting.edited(properties.DISTANCE, max(away, 0.0))


def move_wave(setting: FrameGeometry, handle: Handle, aim: Aim) -> Document:
    """Turn a wave and make it longer or shorter: the arrow is one wavelength, and points where the crests go."""
    lines, ground = _WAVES[handle.id], setting.ground
    start, end = _arrow(setting, lines)
    place = place_seen_at(setting.camera, end, ground.normal, aim.target)
    if place is None:
        return setting.document
    way = between(start, place)
    right, nearer = dot(way, ground.u), dot(way, ground.v)
    if hypot(right, nearer) < 1e-6:
        return setting.document
    shown = setting.value(lines.direction, aim.shown)
    direction = unwound(aim.angle(degrees(atan2(nearer, right))), shown, lines.direction)
    document = setting.edited(lines.wavelength, hypot(right, nearer))
    return setting.edited(lines.direction, direction, document)


def _is_simplified(setting: FrameGeometry) -> bool:
    return setting.value(properties.SIMPLIFY_ON) and setting.value(properties.SIMPLIFY) > 0


def _waves(setting: FrameGeometry) -> dict[str, WaveLines]:
    if not setting.value(properties.WAVES_ON):
        return {}
    return {name: lines for name, lines in _WAVES.items() if setting.value(lines.amplitude) > 0}


def _plane(setting: FrameGeometry) -> Plane:
    assert setting.card is not None
    return contact_plane(setting.card, setting.ground)


def _side(setting: FrameGeometry) -> float:
    """Return on which side of the contact line the shadow falls: 1 toward the viewer, else -1."""
    plane, tip = _plane(setting), tip_of(setting)
    return 1.0 if tip is not None and dot(between(plane.origin, tip), plane.v) > 0 else -1.0


def _line(setting: FrameGeometry) -> tuple[Vector3, Vector3]:
    """Return the ends of the line across the shadow, world px."""
    assert setting.layer is not None
    plane = _plane(setting)
    middle = dot(between(plane.origin, setting.contact), plane.u)
    half = _HALF_LINE_OF_FIGURE * setting.layer.figure.height
    away = _side(setting) * setting.value(properties.DISTANCE)
    return (plane.point(middle - half, away), plane.point(middle + half, away))


def _arrow(setting: FrameGeometry, lines: WaveLines) -> tuple[Vector3, Vector3]:
    """Return the ends of a wave's arrow, world px; it begins in the middle of the shadow."""
    ground, contact, tip = setting.ground, setting.contact, tip_of(setting)
    middle = contact if tip is None else _halfway(contact, tip)
    right, nearer = (dot(between(ground.origin, middle), axis) for axis in (ground.u, ground.v))
    angle, length = radians(setting.value(lines.direction)), setting.value(lines.wavelength)
    return (ground.point(right, nearer), ground.point(right + length * cos(angle), nearer + length * sin(angle)))


def _halfway(start: Vector3, end: Vector3) -> Vector3:
    x, y, z = ((a + b) / 2 for a, b in zip(start, end, strict=True))
    return (x, y, z)
