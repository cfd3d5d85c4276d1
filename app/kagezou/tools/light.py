"""The lamp and its foot on the ground.

The lamp is dragged over its foot: sideways along the ground line, up and down as height over the ground. The foot is
dragged over the ground, the lamp following at its height. Neither can push the lamp into the ground.
"""

from kagezou.document import properties
from kagezou.document.model import Document
from kagezou.geometry.light import foot_of, lamp
from kagezou.geometry.vectors import Vector3, dot, height_over
from kagezou.message import Message
from kagezou.tools.drag import Aim
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.handle import Guide, GuideKind, Handle, HandleShape
from kagezou.tools.sight import MIN_DEPTH, between, depth_of, moved, place_seen_at, seen, within_reach

LAMP = "light.lamp"
FOOT = "light.foot"

MIN_HEIGHT_PX = 1.0
"""The least height over the ground a drag leaves a lamp."""


def handles(setting: FrameGeometry) -> tuple[Handle, ...]:
    """Return the foot and the lamp, none for the sun."""
    if setting.is_sun:
        return ()
    address = setting.address(properties.LIGHT_POSITION)
    layer_id = setting.layer.id if setting.layer else None
    position, foot = _lamp(setting), _foot(setting)
    return (
        Handle(
            FOOT, HandleShape.FOOT, seen(setting.camera, foot), address, Message("Lamp's foot"),
            layer_id=layer_id, stays_in_view=True,
        ),
        Handle(
            LAMP, HandleShape.SUN_DISC, seen(setting.camera, position), address, Message("Lamp"),
            layer_id=layer_id, stays_in_view=True,
        ),
    )  # fmt: skip


def guides(setting: FrameGeometry) -> tuple[Guide, ...]:
    """Return the lines from the lamp to its foot and on to where the character stands."""
    if setting.is_sun:
        return ()
    position, foot, contact = (
        seen(setting.camera, place) for place in (_lamp(setting), _foot(setting), setting.contact)
    )
    return (
        Guide(GuideKind.LAMP_TO_FOOT, (position, foot)),
        Guide(GuideKind.FOOT_TO_CONTACT, (foot, contact)),
    )


def move_lamp(setting: FrameGeometry, _handle: Handle, aim: Aim) -> Document:
    """Move the lamp in the upright plane along the ground line; seen edge-on, px of the hand are px of the lamp."""
    ground, start = setting.ground, _lamp(setting)
    place = place_seen_at(setting.camera, start, ground.v, aim.target)
    if place is None:
        right, down = _hand(setting, aim, start)
        way_along, up = right, -down
    else:
        way = between(start, place)
        way_along, up = dot(way, ground.u), dot(way, ground.normal)
    if aim.modifiers.constrain:
        way_along, up = (way_along, 0.0) if _is_along(setting, aim) else (0.0, up)
    height = height_over(ground.equation, lamp(start))
    lifted = max(up, MIN_HEIGHT_PX - height)
    return _placed(setting, moved(start, (way_along, ground.u), (lifted, ground.normal)))


def move_foot(setting: FrameGeometry, _handle: Handle, aim: Aim) -> Document:
    """Move the foot over the ground; seen edge-on, down is toward the viewer."""
    ground, foot = setting.ground, _foot(setting)
    place = place_seen_at(setting.camera, foot, ground.normal, aim.target)
    if place is None:
        way_along, nearer = _hand(setting, aim, foot)
    else:
        way = between(foot, place)
        way_along, nearer = dot(way, ground.u), dot(way, ground.v)
    if aim.modifiers.constrain:
        way_along, nearer = (way_along, 0.0) if _is_along(setting, aim) else (0.0, nearer)
    return _placed(setting, moved(_lifted(setting), (way_along, ground.u), (nearer, ground.v)))


def _placed(setting: FrameGeometry, wanted: Vector3) -> Document:
    return setting.edited(properties.LIGHT_POSITION, within_reach(_lifted(setting), wanted))


def _lamp(setting: FrameGeometry) -> Vector3:
    return setting.light[:3]


def _foot(setting: FrameGeometry) -> Vector3:
    return foot_of(setting.ground, _lamp(setting))


def _lifted(setting: FrameGeometry) -> Vector3:
    """Return the lamp, brought over the ground where it lay under it, so that any way on from it stays over."""
    height = height_over(setting.ground.equation, setting.light)
    return moved(_lamp(setting), (max(0.0, MIN_HEIGHT_PX - height), setting.ground.normal))


def _hand(setting: FrameGeometry, aim: Aim, place: Vector3) -> tuple[float, float]:
    """Return the hand's way along and across the ground line in world px at a place's depth."""
    depth = max(depth_of(setting.camera, place), MIN_DEPTH)
    (x, y), along, across = aim.offset, setting.along, setting.across
    return (depth * (x * along[0] + y * along[1]), x * across[0] + y * across[1])


def _is_along(setting: FrameGeometry, aim: Aim) -> bool:
    """Whether the hand went further along the ground line than across it."""
    (x, y), along, across = aim.offset, setting.along, setting.across
    return abs(x * along[0] + y * along[1]) >= abs(x * across[0] + y * across[1])
