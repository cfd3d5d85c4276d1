"""The shadow itself: the tip that the head throws is taken hold of, and the light follows.

The light must lie on the line from the tip through the head. That settles the sun; a lamp keeps its height over the
ground. Feet and what is hardly above them say too little about the light, so such a head has no handle.
"""

from dataclasses import replace
from math import radians, sin, sqrt

from kagezou.document import properties
from kagezou.document.figure_properties import SHAPE
from kagezou.document.model import Document
from kagezou.document.values import value_at
from kagezou.geometry.card import Card
from kagezou.geometry.light import GRAZING_DARK_DEG, sun_angles
from kagezou.geometry.sight import MIN_DEPTH, depth_of, seen
from kagezou.geometry.vectors import Point2, Vector3, dot, height_over
from kagezou.message import Message
from kagezou.scene.evaluate import light_at
from kagezou.scene.figure_card import Moment
from kagezou.scene.poses import casting_of
from kagezou.tools.drag import Aim
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.handle import Guide, GuideKind, Handle, HandleShape
from kagezou.tools.sight import REACH_PX, between, is_edge_on, moved, on_plane, place_seen_at, within_reach
from kagezou.tools.sun import unwound

TIP = "shadow.tip"

_ROUNDS = 12
_SETTLED_PX = 1e-3

MIN_HEIGHT_OF_FIGURE = 0.1
"""A head less high over the ground than this part of the figure has no handle."""


def handles(geometry: FrameGeometry) -> tuple[Handle, ...]:
    """Return the shadow's tip, where there is one."""
    head, tip = head_of(geometry), tip_of(geometry)
    if geometry.layer is None or head is None or tip is None:
        return ()
    lines = (properties.LIGHT_AZIMUTH, properties.LIGHT_ELEVATION) if geometry.is_sun else (properties.LIGHT_POSITION,)
    address, *also = map(geometry.address, lines)
    return (
        Handle(
            TIP, HandleShape.RING, seen(geometry.camera, tip), address, Message("Tip of the shadow"),
            also=tuple(also), layer_id=geometry.layer.id, stays_in_view=True,
        ),
    )  # fmt: skip


def guides(geometry: FrameGeometry) -> tuple[Guide, ...]:
    """Return the line from the head to its shadow."""
    head, tip = head_of(geometry), tip_of(geometry)
    if head is None or tip is None:
        return ()
    return (Guide(GuideKind.SHADOW_RAY, (seen(geometry.camera, head), seen(geometry.camera, tip))),)


def move_tip(geometry: FrameGeometry, _handle: Handle, aim: Aim) -> Document:
    """Move the light so that the head's shadow falls where it is wanted."""
    head, tip = head_of(geometry), tip_of(geometry)
    if head is None or tip is None:
        return geometry.document
    wanted = place_seen_at(geometry.camera, tip, geometry.ground.normal, aim.straightened(geometry.along).target)
    if wanted is None:
        return geometry.document
    document = geometry.document
    for _ in range(_ROUNDS):
        document = _lit_through(geometry, head, within_reach(tip, wanted) if geometry.is_sun else wanted, aim)
        # In the air the size of the shadow, and so the head, depends on the light.
        found = head_of(replace(geometry, light=light_at(document, geometry.frame, geometry.ground)))
        if found is None or max(map(abs, between(head, found))) < _SETTLED_PX:
            break
        head = found
    return document


def _lit_through(geometry: FrameGeometry, head: Vector3, wanted: Vector3, aim: Aim) -> Document:
    """Move the light onto the line from a place of the ground through the head."""
    ground = geometry.ground
    if geometry.is_sun:
        return _sun_through(geometry, between(wanted, head), aim)
    toward_head = between(wanted, head)
    gain = height_over(ground.equation, geometry.light) / height_over(ground.equation, (*head, 1.0))
    place = within_reach(geometry.light[:3], moved(wanted, (gain, toward_head)))
    return geometry.edited(properties.LIGHT_POSITION, place)


def _sun_through(geometry: FrameGeometry, direction: Vector3, aim: Aim) -> Document:
    azimuth, elevation = sun_angles(geometry.ground, direction)
    document = geometry.edited(properties.LIGHT_ELEVATION, elevation)
    if azimuth is None:
        return document
    shown = geometry.value(properties.LIGHT_AZIMUTH, aim.shown)
    return geometry.edited(properties.LIGHT_AZIMUTH, unwound(azimuth, shown, properties.LIGHT_AZIMUTH), document)


def head_of(geometry: FrameGeometry) -> Vector3 | None:
    """Return the middle of the figure's top on the card it casts from, world px, or None if it says too little."""
    layer, figure = geometry.figure, geometry.figure_box
    if layer is None or figure.is_empty or not geometry.is_figure_shown:
        return None
    if value_at(layer.tracks, SHAPE, geometry.frame) == "disc":
        return None
    moment = Moment(geometry.document, geometry.frame, geometry.camera, geometry.ground)
    card, lowered = casting_of(moment, layer, geometry.frame, geometry.light)
    top = ((figure.left + figure.right) / 2, float(figure.top))
    head = _on_card(geometry, card, top if lowered is None else lowered.lowered(top))
    if head is None:
        return None
    height = height_over(geometry.ground.equation, (*head, 1.0))
    return head if height >= MIN_HEIGHT_OF_FIGURE * figure.height else None


def _on_card(geometry: FrameGeometry, card: Card, canvas_px: Point2) -> Vector3 | None:
    nx, ny, nz, d = card.piece_at(canvas_px).plane
    place = on_plane(geometry.camera, (nx, ny, nz, d), canvas_px)
    return place if place is None or max(map(abs, place)) <= REACH_PX else None


def tip_of(geometry: FrameGeometry) -> Vector3 | None:
    """Return where the head's shadow falls on the ground, world px, or None if it does not, or out of sight."""
    head = head_of(geometry)
    ground, light = geometry.ground, geometry.light
    if head is None:
        return None
    x, y, z, w = light
    ray = (x - w * head[0], y - w * head[1], z - w * head[2])
    rise = dot(ray, ground.normal)
    if rise <= sin(radians(GRAZING_DARK_DEG)) * sqrt(dot(ray, ray)):
        return None
    tip = moved(head, (-height_over(ground.equation, (*head, 1.0)) / rise, ray))
    if max(map(abs, tip)) > REACH_PX or depth_of(geometry.camera, tip) <= MIN_DEPTH:
        return None
    return None if is_edge_on(geometry.camera, tip, ground.normal) else tip
