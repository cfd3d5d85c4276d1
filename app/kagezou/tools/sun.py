"""The sun on its dial: a disc around the character, its middle straight above, its rim the horizon.

The dial is a picture of directions, not a thing on the ground: of one size on screen, round the contact, squashed as
the ground is but never flatter than ``MIN_SQUASH``. Distance from the middle is proportional to the angle from
straight above; a sun under the horizon is shown outside the rim.
"""

from math import atan2, cos, degrees, hypot, pi, radians, sin

from kagezou.document import properties
from kagezou.document.model import Document
from kagezou.document.property import Property
from kagezou.geometry.sight import seen
from kagezou.geometry.vectors import Point2
from kagezou.message import Message
from kagezou.tools.drag import Aim
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.handle import Cursor, Guide, GuideKind, Handle, HandleShape

SUN = "light.sun"

DIAL_RADIUS_VIEW_PX = 90.0
MIN_SQUASH = 0.3

_RIM_POINTS = 64


def handles(geometry: FrameGeometry) -> tuple[Handle, ...]:
    """Return the sun, none for a lamp."""
    if not geometry.is_sun:
        return ()
    azimuth = geometry.value(properties.LIGHT_AZIMUTH)
    elevation = geometry.value(properties.LIGHT_ELEVATION)
    return (
        Handle(
            SUN, HandleShape.DIAL, _on_dial(geometry, radians(azimuth), (90 - elevation) / 90),
            geometry.address(properties.LIGHT_AZIMUTH), Message("Sun"), Cursor.MOVE,
            also=(geometry.address(properties.LIGHT_ELEVATION),),
            layer_id=geometry.layer.id if geometry.layer else None, stays_in_view=True,
        ),
    )  # fmt: skip


def guides(geometry: FrameGeometry) -> tuple[Guide, ...]:
    """Return the dial's rim and the line from its middle to the sun."""
    if not geometry.is_sun:
        return ()
    rim = tuple(_on_dial(geometry, 2 * pi * step / _RIM_POINTS, 1.0) for step in range(_RIM_POINTS))
    sun = handles(geometry)[0].canvas_px
    return (
        Guide(GuideKind.SUN_DIAL, rim, closed=True),
        Guide(GuideKind.SUN_RAY, (_middle(geometry), sun)),
    )


def move_sun(geometry: FrameGeometry, _handle: Handle, aim: Aim) -> Document:
    """Set azimuth and elevation; the sun stays over the horizon and its azimuth counts whole turns."""
    middle, along, across = _middle(geometry), geometry.along, geometry.across
    x, y = aim.target[0] - middle[0], aim.target[1] - middle[1]
    right = x * along[0] + y * along[1]
    nearer = (x * across[0] + y * across[1]) / _squash(geometry)
    from_above = hypot(right, nearer) / geometry.view.canvas_length(DIAL_RADIUS_VIEW_PX)
    elevation = min(max(aim.angle(90 - 90 * from_above), 0.0), 90.0)
    document = geometry.edited(properties.LIGHT_ELEVATION, elevation)
    if from_above < 1e-9:
        return document
    shown = geometry.value(properties.LIGHT_AZIMUTH, aim.shown)
    azimuth = unwound(aim.angle(degrees(atan2(right, nearer))), shown, properties.LIGHT_AZIMUTH)
    return geometry.edited(properties.LIGHT_AZIMUTH, azimuth, document)


def unwound(angle_deg: float, near_deg: float, prop: Property[float]) -> float:
    """Return the angle with the whole turns added that bring it nearest to another, within the property's range.

    So keys go the way the hand went, and not once round at ±180°.
    """
    nearest = angle_deg + 360 * round((near_deg - angle_deg) / 360)
    return nearest if prop.low <= nearest <= prop.high else angle_deg


def _middle(geometry: FrameGeometry) -> Point2:
    return seen(geometry.camera, geometry.contact)


def _squash(geometry: FrameGeometry) -> float:
    return max(cos(radians(geometry.value(properties.GROUND_DECLINATION))), MIN_SQUASH)


def _on_dial(geometry: FrameGeometry, azimuth_rad: float, from_above: float) -> Point2:
    """Return the canvas point of a direction; ``from_above`` is 0 straight above and 1 at the horizon."""
    radius = from_above * geometry.view.canvas_length(DIAL_RADIUS_VIEW_PX)
    right, nearer = radius * sin(azimuth_rad), radius * cos(azimuth_rad) * _squash(geometry)
    (x, y), along, across = _middle(geometry), geometry.along, geometry.across
    return (x + right * along[0] + nearer * across[0], y + right * along[1] + nearer * across[1])
