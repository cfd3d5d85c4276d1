"""Lamp or sun: the other kind of light takes over where the shadow's tip was, so that the shadow stays where it is."""

from math import acos, degrees, sqrt

from kagezou.animation.track import Key, Track, Value
from kagezou.document import properties
from kagezou.document.address import Address, track_of
from kagezou.document.edits import set_track, set_value
from kagezou.document.model import Document
from kagezou.document.property import AnyProperty
from kagezou.geometry.light import sun_angles
from kagezou.geometry.vectors import Vector3, dot
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.shadow import head_of
from kagezou.tools.sight import between, moved, within_reach
from kagezou.tools.sun import unwound
from kagezou.tools.view import CanvasView

_KIND = Address(properties.LIGHT_KIND)
_LAMP: tuple[AnyProperty, ...] = (properties.LIGHT_POSITION,)
_SUN: tuple[AnyProperty, ...] = (properties.LIGHT_AZIMUTH, properties.LIGHT_ELEVATION)

_FAR = 20.0
"""A lamp in the place of the sun stands so many canvas heights off, where its shadow hardly spreads."""

_SAME_DEG = 0.05


def with_light_kind(document: Document, layer_id: str | None, frame: int, kind: str) -> Document:
    """Return the document lit by a lamp ("point") or by the "sun" from a frame's light on, its shadow where it was.

    A light that moves by keys moves by as many of the other kind. What the other kind was set to before comes back as
    it was if it lights alike. Where the kind itself is keyed, the light of that frame alone is taken over.

    Parameters
    ----------
    layer_id
        The layer of the figure whose shadow's tip is kept; without one the place where figures stand counts.
    """
    switched = set_value(document, _KIND, kind, frame)
    now, then = (FrameGeometry.of(each, frame, layer_id, CanvasView()) for each in (document, switched))
    if now.is_sun == then.is_sun:
        return switched
    before, after = (_SUN, _LAMP) if now.is_sun else (_LAMP, _SUN)
    frames = _moments(document, before, frame)
    if all(_light_alike(document, switched, layer_id, each) for each in frames):
        return switched
    found = {each: _taken_over(document, switched, layer_id, each) for each in frames}
    if track_of(document, _KIND).is_keyed:
        for prop, value in zip(after, found[frame], strict=True):
            switched = set_value(switched, Address(prop), value, frame)
        return switched
    like = {key.frame: key for prop in before for key in track_of(document, Address(prop)).keys}
    for number, prop in enumerate(after):
        values = _unwound(prop, {each: found[each][number] for each in frames})
        # Easy at both ends where it was eased: speeds in px say nothing of degrees, nor the other way round.
        keys = tuple(Key(each, values[each], like[each].interpolation) for each in frames if each in like)
        switched = set_track(switched, Address(prop), Track(values[frames[0]], keys))
    return switched


def _moments(document: Document, before: tuple[AnyProperty, ...], frame: int) -> tuple[int, ...]:
    """Return the frames at which the light is taken over: where it is keyed, else the one looked at."""
    if track_of(document, _KIND).is_keyed:
        return (frame,)
    keyed = {key.frame for prop in before for key in track_of(document, Address(prop)).keys}
    return tuple(sorted(keyed)) or (frame,)


def _light_alike(document: Document, switched: Document, layer_id: str | None, frame: int) -> bool:
    one, other = (_toward_light(each, layer_id, frame) for each in (document, switched))
    return degrees(acos(min(max(dot(one, other), -1.0), 1.0))) < _SAME_DEG


def _taken_over(document: Document, switched: Document, layer_id: str | None, frame: int) -> tuple[Value, ...]:
    """Return what the other kind of light is set to: the sun's azimuth and elevation, or the lamp's position."""
    geometry = FrameGeometry.of(document, frame, layer_id, CanvasView())
    toward = _toward_light(document, layer_id, frame)
    if not geometry.is_sun:
        azimuth, elevation = sun_angles(geometry.ground, toward)
        old = FrameGeometry.of(switched, frame, layer_id, CanvasView()).value(properties.LIGHT_AZIMUTH)
        return (old if azimuth is None else azimuth, elevation)
    head = _lit(geometry)
    return (within_reach(head, moved(head, (_FAR * document.canvas.height_px, toward))),)


def _toward_light(document: Document, layer_id: str | None, frame: int) -> Vector3:
    """Return the direction from the head to the light, unit length."""
    geometry = FrameGeometry.of(document, frame, layer_id, CanvasView())
    x, y, z, w = geometry.light
    way = (x, y, z) if w == 0 else between(_lit(geometry), (x, y, z))
    length = sqrt(dot(way, way))
    return (0.0, -1.0, 0.0) if length == 0 else (way[0] / length, way[1] / length, way[2] / length)


def _lit(geometry: FrameGeometry) -> Vector3:
    """Return the place whose shadow is kept: the head, or where the figure stands if that says too little."""
    head = head_of(geometry)
    return geometry.contact if head is None else head


def _unwound(prop: AnyProperty, values: dict[int, Value]) -> dict[int, Value]:
    """Return azimuths with whole turns added, so that each goes on from the one before the short way."""
    if prop is not properties.LIGHT_AZIMUTH:
        return values
    turned: dict[int, Value] = {}
    before: float | None = None
    for frame, value in values.items():
        assert isinstance(value, float)
        before = value if before is None else unwound(value, before, properties.LIGHT_AZIMUTH)
        turned[frame] = before
    return turned
