"""The filters: the line across the shadow at which simplifying is at its full strength, and an arrow for each wave.

Both lie on the ground, so that they are foreshortened as the shadow is.
"""

from math import atan2, cos, degrees, hypot, radians, sin

from kagezou.document import properties
from kagezou.document.model import Document
from kagezou.document.wave_properties import SLITS, WaveLines
from kagezou.geometry.contact import contact_plane
from kagezou.geometry.ground import Plane
from kagezou.geometry.sight import seen
from kagezou.geometry.vectors import Vector3, dot
from kagezou.message import Message
from kagezou.tools.drag import Aim
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.handle import Cursor, Guide, GuideKind, Handle, HandleShape
from kagezou.tools.shadow import tip_of
from kagezou.tools.sight import between, place_seen_at
from kagezou.tools.sun import unwound

DISTANCE = "filter.distance"
WAVE1, WAVE2 = "filter.wave1", "filter.wave2"

_HALF_LINE_OF_FIGURE = 0.35
"""Half the length of the line, as a part of the figure's height."""

_WAVES = {WAVE1: properties.WAVE1, WAVE2: properties.WAVE2}


def handles(geometry: FrameGeometry) -> tuple[Handle, ...]:
    """Return what the filters in use are taken hold of by."""
    if geometry.layer is None or geometry.card is None:
        return ()
    made: list[Handle] = []
    if _is_simplified(geometry):
        made.append(
            Handle(
                DISTANCE, HandleShape.LEVER, seen(geometry.camera, _line(geometry)[1]),
                geometry.address(properties.DISTANCE), properties.DISTANCE.label, Cursor.VERTICAL,
                layer_id=geometry.layer.id,
            )
        )  # fmt: skip
    for handle_id, lines in _waves(geometry).items():
        number = handle_id[-1]
        made.append(
            Handle(
                handle_id, HandleShape.ARROW, seen(geometry.camera, _arrow(geometry, lines)[1]),
                geometry.address(lines.direction), Message("Wave {number}", number=number),
                also=(geometry.address(lines.wavelength),), layer_id=geometry.layer.id,
            )
        )  # fmt: skip
    return tuple(made)


def guides(geometry: FrameGeometry) -> tuple[Guide, ...]:
    """Return the line of the distance, and the shafts of the arrows."""
    if geometry.layer is None or geometry.card is None:
        return ()
    made: list[Guide] = []
    if _is_simplified(geometry):
        made.append(Guide(GuideKind.FILTER_DISTANCE, tuple(seen(geometry.camera, end) for end in _line(geometry))))
    made += [
        Guide(GuideKind.WAVE, tuple(seen(geometry.camera, end) for end in _arrow(geometry, lines)))
        for lines in _waves(geometry).values()
    ]
    return tuple(made)


def move_distance(geometry: FrameGeometry, _handle: Handle, aim: Aim) -> Document:
    """Move the line away from the feet, or up to them."""
    plane, end = _plane(geometry), _line(geometry)[1]
    place = place_seen_at(geometry.camera, end, plane.normal, aim.straightened(geometry.across).target)
    if place is None:
        return geometry.document
    away = _side(geometry) * dot(between(plane.origin, place), plane.v)
    return geometry.edited(properties.DISTANCE, max(away, 0.0))


def move_wave(geometry: FrameGeometry, handle: Handle, aim: Aim) -> Document:
    """Turn a wave and make it longer or shorter: the arrow is one wavelength, and points where the crests go."""
    lines, ground = _WAVES[handle.id], geometry.ground
    start, end = _arrow(geometry, lines)
    place = place_seen_at(geometry.camera, end, ground.normal, aim.target)
    if place is None:
        return geometry.document
    way = between(start, place)
    right, nearer = dot(way, ground.u), dot(way, ground.v)
    if hypot(right, nearer) < 1e-6:
        return geometry.document
    shown = geometry.value(lines.direction, aim.shown)
    direction = unwound(aim.angle(degrees(atan2(nearer, right))), shown, lines.direction)
    document = geometry.edited(lines.wavelength, hypot(right, nearer))
    return geometry.edited(lines.direction, direction, document)


def _is_simplified(geometry: FrameGeometry) -> bool:
    return geometry.value(properties.SIMPLIFY_ON) and geometry.value(properties.SIMPLIFY) > 0


def _waves(geometry: FrameGeometry) -> dict[str, WaveLines]:
    if not geometry.value(properties.WAVES_ON):
        return {}
    # Gaps go with the first set even where it moves nothing.
    opens = {WAVE1} if geometry.value(SLITS) > 0 else set()
    return {name: lines for name, lines in _WAVES.items() if name in opens or geometry.value(lines.amplitude) > 0}


def _plane(geometry: FrameGeometry) -> Plane:
    assert geometry.card is not None
    return contact_plane(geometry.card, geometry.ground)


def _side(geometry: FrameGeometry) -> float:
    """Return on which side of the contact line the shadow falls: 1 toward the viewer, else -1."""
    plane, tip = _plane(geometry), tip_of(geometry)
    return 1.0 if tip is not None and dot(between(plane.origin, tip), plane.v) > 0 else -1.0


def _line(geometry: FrameGeometry) -> tuple[Vector3, Vector3]:
    """Return the ends of the line across the shadow, world px."""
    assert geometry.layer is not None
    plane = _plane(geometry)
    middle = dot(between(plane.origin, geometry.contact), plane.u)
    half = _HALF_LINE_OF_FIGURE * geometry.layer.figure.height
    away = _side(geometry) * geometry.value(properties.DISTANCE)
    return (plane.point(middle - half, away), plane.point(middle + half, away))


def _arrow(geometry: FrameGeometry, lines: WaveLines) -> tuple[Vector3, Vector3]:
    """Return the ends of a wave's arrow, world px; it begins in the middle of the shadow."""
    ground, contact, tip = geometry.ground, geometry.contact, tip_of(geometry)
    middle = contact if tip is None else _halfway(contact, tip)
    right, nearer = (dot(between(ground.origin, middle), axis) for axis in (ground.u, ground.v))
    angle, length = radians(geometry.value(lines.direction)), geometry.value(lines.wavelength)
    return (ground.point(right, nearer), ground.point(right + length * cos(angle), nearer + length * sin(angle)))


def _halfway(start: Vector3, end: Vector3) -> Vector3:
    x, y, z = ((a + b) / 2 for a, b in zip(start, end, strict=True))
    return (x, y, z)
