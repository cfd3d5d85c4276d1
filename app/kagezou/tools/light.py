"""The lamp and its foot on the ground.

The lamp is dragged over its foot: sideways along the ground line, up and down as height over the ground. The foot is
dragged over the ground, the lamp following at its height. Neither can push the lamp into the ground.
"""

from kagezou.document import properties
from kagezou.document.model import Document
from kagezou.geometry.light import foot_of, lamp
from kagezou.geometry.sight import MIN_DEPTH, depth_of, seen
from kagezou.geometry.vectors import Vector3, dot, height_over
from kagezou.message import Message
from kagezou.tools.drag import Aim
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.handle import Guide, GuideKind, Handle, HandleShape
from kagezou.tools.sight import between, moved, place_seen_at, within_reach

LAMP = "light.lamp"
FOOT = "light.foot"

MIN_HEIGHT_PX = 1.0
"""The least height over the ground a drag leaves a lamp."""


def handles(geometry: FrameGeometry) -> tuple[Handle, ...]:
    """Return the foot and the lamp, none for the sun."""
    if geometry.is_sun:
        return ()
    address = geometry.address(properties.LIGHT_POSITION)
    layer_id = geometry.layer.id if geometry.layer else None
    position, foot = _lamp(geometry), _foot(geometry)
    return (
        Handle(
            FOOT, HandleShape.FOOT, seen(geometry.camera, foot), address, Message("Lamp's foot"),
            layer_id=layer_id, stays_in_view=True,
        ),
        Handle(
            LAMP, HandleShape.SUN_DISC, seen(geometry.camera, position), address, Message("Lamp"),
            layer_id=layer_id, stays_in_view=True,
        ),
    )  # fmt: skip


def guides(geometry: FrameGeometry) -> tuple[Guide, ...]:
    """Return the lines from the lamp to its foot and on to where the character stands."""
    if geometry.is_sun:
        return ()
    position, foot, contact = (
        seen(geometry.camera, place) for place in (_lamp(geometry), _foot(geometry), geometry.contact)
    )
    return (
        Guide(GuideKind.LAMP_TO_FOOT, (position, foot)),
        Guide(GuideKind.FOOT_TO_CONTACT, (foot, contact)),
    )


def move_lamp(geometry: FrameGeometry, _handle: Handle, aim: Aim) -> Document:
    """Move the lamp in the upright plane along the ground line; seen edge-on, px of the hand are px of the lamp."""
    ground, start = geometry.ground, _lamp(geometry)
    place = place_seen_at(geometry.camera, start, ground.v, aim.target)
    if place is None:
        right, down = _hand(geometry, aim, start)
        way_along, up = right, -down
    else:
        way = between(start, place)
        way_along, up = dot(way, ground.u), dot(way, ground.normal)
    if aim.modifiers.constrain:
        way_along, up = (way_along, 0.0) if _is_along(geometry, aim) else (0.0, up)
    height = height_over(ground.equation, lamp(start))
    lifted = max(up, MIN_HEIGHT_PX - height)
    return _placed(geometry, moved(start, (way_along, ground.u), (lifted, ground.normal)))


def move_foot(geometry: FrameGeometry, _handle: Handle, aim: Aim) -> Document:
    """Move the foot over the ground; seen edge-on, down is toward the viewer."""
    ground, foot = geometry.ground, _foot(geometry)
    place = place_seen_at(geometry.camera, foot, ground.normal, aim.target)
    if place is None:
        way_along, nearer = _hand(geometry, aim, foot)
    else:
        way = between(foot, place)
        way_along, nearer = dot(way, ground.u), dot(way, ground.v)
    if aim.modifiers.constrain:
        way_along, nearer = (way_along, 0.0) if _is_along(geometry, aim) else (0.0, nearer)
    return _placed(geometry, moved(_lifted(geometry), (way_along, ground.u), (nearer, ground.v)))


def _placed(geometry: FrameGeometry, wanted: Vector3) -> Document:
    return geometry.edited(properties.LIGHT_POSITION, within_reach(_lifted(geometry), wanted))


def _lamp(geometry: FrameGeometry) -> Vector3:
    return geometry.light[:3]


def _foot(geometry: FrameGeometry) -> Vector3:
    return foot_of(geometry.ground, _lamp(geometry))


def _lifted(geometry: FrameGeometry) -> Vector3:
    """Return the lamp, brought over the ground where it lay under it, so that any way on from it stays over."""
    height = height_over(geometry.ground.equation, geometry.light)
    return moved(_lamp(geometry), (max(0.0, MIN_HEIGHT_PX - height), geometry.ground.normal))


def _hand(geometry: FrameGeometry, aim: Aim, place: Vector3) -> tuple[float, float]:
    """Return the hand's way along and across the ground line in world px at a place's depth."""
    depth = max(depth_of(geometry.camera, place), MIN_DEPTH)
    (x, y), along, across = aim.offset, geometry.along, geometry.across
    return (depth * (x * along[0] + y * along[1]), x * across[0] + y * across[1])


def _is_along(geometry: FrameGeometry, aim: Aim) -> bool:
    """Whether the hand went further along the ground line than across it."""
    (x, y), along, across = aim.offset, geometry.along, geometry.across
    return abs(x * along[0] + y * along[1]) >= abs(x * across[0] + y * across[1])
