"""From a document and a frame to the scene."""

from kagezou.animation.track import Value
from kagezou.document import properties
from kagezou.document.model import Document, Layer, Tracks
from kagezou.document.property import Property
from kagezou.geometry.camera import Camera
from kagezou.geometry.card import Card, card_for
from kagezou.geometry.ground import Plane, ground_plane
from kagezou.geometry.light import is_over, lamp, sun, virtual_lights
from kagezou.geometry.vectors import Vector3, Vector4
from kagezou.scene.scene import LayerScene, Scene, ShadowCast, ShadowLook, Simplify


def evaluate(document: Document, frame: int) -> Scene:
    """Return the scene of a frame, counted from 1; invisible layers are left out."""
    camera = camera_at(document, frame)
    ground = ground_at(document, frame)
    light = light_at(document, frame, ground)
    radius = _number(_value(document.tracks, properties.OVERHEAD_RADIUS, frame))
    layers = tuple(
        _layer_scene(layer, frame, camera, ground, light, radius)
        for layer in document.layers
        if _value(layer.tracks, properties.VISIBLE, frame)
    )
    return Scene(document.canvas.box, camera, ground, document.background, layers)


def camera_at(document: Document, frame: int) -> Camera:
    """Return the camera of a frame."""
    fov = _number(_value(document.tracks, properties.FOV, frame))
    return Camera(document.canvas.width_px, document.canvas.height_px, fov)


def ground_at(document: Document, frame: int) -> Plane:
    """Return the ground of a frame."""
    position = _numbers(_value(document.tracks, properties.GROUND_POSITION, frame))
    roll = _number(_value(document.tracks, properties.GROUND_ROLL, frame))
    declination = _number(_value(document.tracks, properties.GROUND_DECLINATION, frame))
    return ground_plane((position[0], position[1]), roll, declination)


def light_at(document: Document, frame: int, ground: Plane) -> Vector4:
    """Return the light of a frame, homogeneous, before it is spread into virtual ones."""
    if _value(document.tracks, properties.LIGHT_KIND, frame) == "sun":
        azimuth = _number(_value(document.tracks, properties.LIGHT_AZIMUTH, frame))
        elevation = _number(_value(document.tracks, properties.LIGHT_ELEVATION, frame))
        return sun(ground, azimuth, elevation)
    x, y, z = _numbers(_value(document.tracks, properties.LIGHT_POSITION, frame))
    return lamp((x, y, z))


def card_at(layer: Layer, frame: int, camera: Camera, ground: Plane) -> Card:
    """Return the card a layer's drawing stands on at a frame."""
    grounding = _value(layer.tracks, properties.GROUNDING, frame)
    points = [point for point in grounding if isinstance(point, tuple)] if isinstance(grounding, tuple) else []
    tilt = _number(_value(layer.tracks, properties.TILT, frame))
    return card_for(camera, ground, points, tilt, layer.figure.height)


def contact_of(card: Card, ground: Plane) -> Vector3:
    """Return where the character stands: the middle of its grounding points' places, else the ground's position."""
    if not card.contacts:
        return ground.origin
    x, y, z = (sum(axis) / len(card.contacts) for axis in zip(*card.contacts, strict=True))
    return (x, y, z)


def _layer_scene(
    layer: Layer, frame: int, camera: Camera, ground: Plane, light: Vector4, overhead_radius: float
) -> LayerScene:
    drawing = layer.cels.drawing_at(frame)
    cast = None
    if drawing is not None:
        card = card_at(layer, frame, camera, ground)
        spread = virtual_lights(light, contact_of(card, ground), overhead_radius)
        cast = ShadowCast(
            drawing=drawing,
            translucent=_value(layer.tracks, properties.MATTE, frame) == "translucent",
            camera=camera,
            receivers=(ground,),
            card=card,
            lights=tuple(each for each in spread if is_over(ground, each)),
            simplify=_simplify(layer.tracks, frame),
        )
    return LayerScene(layer.id, layer.name, drawing, cast, _look(layer.tracks, frame))


def _simplify(tracks: Tracks, frame: int) -> Simplify | None:
    amount = _number(_value(tracks, properties.SIMPLIFY, frame))
    return Simplify(amount, _number(_value(tracks, properties.DISTANCE, frame))) if amount > 0 else None


def _look(tracks: Tracks, frame: int) -> ShadowLook:
    color = str(_value(tracks, properties.COLOR, frame))
    return ShadowLook(
        color=(int(color[1:3], 16), int(color[3:5], 16), int(color[5:7], 16)),
        opacity=_number(_value(tracks, properties.OPACITY, frame)),
        multiply=_value(tracks, properties.BLEND, frame) == "multiply",
    )


def _value(tracks: Tracks, line: Property, frame: int) -> Value:
    track = tracks.get(line.name)
    return line.default if track is None else track.value_at(frame)


def _number(value: Value) -> float:
    assert isinstance(value, float), value
    return value


def _numbers(value: Value) -> tuple[float, ...]:
    assert isinstance(value, tuple), value
    return tuple(part for part in value if isinstance(part, float))
