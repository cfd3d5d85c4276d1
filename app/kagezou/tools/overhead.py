"""The area over a character within which a lamp is overhead: its rim on the ground, dragged wider and narrower.

It is shown while there is one, and while the lamp is near: of a lamp far off it changes nothing, and it says so.
"""

from math import cos, pi, sin
from typing import Final

from kagezou.document import properties
from kagezou.document.model import Document
from kagezou.geometry.light import horizontal_distance
from kagezou.geometry.sight import seen
from kagezou.geometry.vectors import Vector3, dot
from kagezou.message import Message
from kagezou.scene.overhead import RADIUS_OF_FIGURE
from kagezou.tools.drag import Aim
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.handle import Cursor, Guide, GuideKind, Handle, HandleShape
from kagezou.tools.sight import between, moved, place_seen_at

OVERHEAD = "light.overhead"

LEAST_VIEW_PX: Final = 26.0
"""So far beside the feet the handle lies at least, logical view px, even where the radius is 0."""

_NEAR: Final = 1.5
"""The lamp is near within so many times the radius, or the usual one."""

_UPWARD: Final = 0.05
"""A ground that rises no more than this toward the world's y, as one that is rolled on its side, has no rim."""

_RIM_POINTS = 64


def handles(geometry: FrameGeometry) -> tuple[Handle, ...]:
    """Return the grip of the rim while there is one or a lamp is near; none for the sun, and without a character."""
    if not _is_shown(geometry):
        return ()
    assert geometry.layer is not None
    return (
        Handle(
            OVERHEAD, HandleShape.LEVER, seen(geometry.camera, _grip(geometry)),
            geometry.address(properties.OVERHEAD_RADIUS), _words(geometry), Cursor.HORIZONTAL,
            layer_id=geometry.layer.id,
        ),
    )  # fmt: skip


def guides(geometry: FrameGeometry) -> tuple[Guide, ...]:
    """Return the rim."""
    radius = geometry.value(properties.OVERHEAD_RADIUS)
    if not _is_shown(geometry) or radius <= 0:
        return ()
    angles = (2 * pi * step / _RIM_POINTS for step in range(_RIM_POINTS))
    rim = tuple(seen(geometry.camera, _below(geometry, radius * cos(each), radius * sin(each))) for each in angles)
    return (Guide(GuideKind.OVERHEAD_AREA, rim, closed=True),)


def move_rim(geometry: FrameGeometry, _handle: Handle, aim: Aim) -> Document:
    """Make the area wider or narrower; seen edge-on only the way along the ground line counts."""
    grip = _grip(geometry)
    place = place_seen_at(geometry.camera, grip, geometry.ground.normal, aim.target)
    if place is None:
        wider = dot((*aim.offset, 0.0), (*geometry.along, 0.0))
    else:
        wider = _from_contact(geometry, place) - _from_contact(geometry, grip)
    return geometry.edited(properties.OVERHEAD_RADIUS, geometry.value(properties.OVERHEAD_RADIUS) + wider)


def _is_shown(geometry: FrameGeometry) -> bool:
    if geometry.is_sun or geometry.layer is None or abs(geometry.ground.normal[1]) < _UPWARD:
        return False
    usual = RADIUS_OF_FIGURE * geometry.figure_box.height
    return geometry.value(properties.OVERHEAD_RADIUS) > 0 or _distance(geometry) <= _NEAR * usual


def _words(geometry: FrameGeometry) -> Message:
    radius, distance = geometry.value(properties.OVERHEAD_RADIUS), _distance(geometry)
    if 0 < radius <= distance:
        return Message("Overhead radius; the lamp is {away} px outside it", away=f"{distance - radius:.0f}")
    return properties.OVERHEAD_RADIUS.label


def _distance(geometry: FrameGeometry) -> float:
    return horizontal_distance(geometry.light, geometry.contact)


def _grip(geometry: FrameGeometry) -> Vector3:
    least = geometry.view.canvas_length(LEAST_VIEW_PX)
    return _below(geometry, max(geometry.value(properties.OVERHEAD_RADIUS), least), 0.0)


def _below(geometry: FrameGeometry, right: float, nearer: float) -> Vector3:
    """Return the place on the ground straight under a point so far beside the contact in (x, z), world px."""
    nx, ny, nz = geometry.ground.normal
    return moved(geometry.contact, (1.0, (right, -(nx * right + nz * nearer) / ny, nearer)))


def _from_contact(geometry: FrameGeometry, place: Vector3) -> float:
    x, _, z = between(geometry.contact, place)
    return float((x * x + z * z) ** 0.5)
