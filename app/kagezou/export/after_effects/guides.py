"""Light, ground line and grounding points as nulls, so that a compositor's own effects can follow them."""

from collections.abc import Callable

from kagezou.animation.track import Track, components_of
from kagezou.document import properties
from kagezou.document.address import Address, track_of
from kagezou.document.model import Document, Layer
from kagezou.document.property import AnyProperty
from kagezou.document.values import value_at
from kagezou.export.after_effects.channels import baked, channel_of
from kagezou.export.after_effects.comp import Channel, Null
from kagezou.geometry.camera import project
from kagezou.geometry.vectors import Point2
from kagezou.scene.evaluate import camera_at, ground_at, light_at

_STILL = Channel(0.0)


def guides_of(document: Document) -> tuple[Null, ...]:
    """Return the nulls of a document: the ground, the light, and each figure's grounding points."""
    points = [null for layer in document.layers if layer.joins is None for null in _points(document, layer)]
    return (_ground(document), _light(document), *points)


def _ground(document: Document) -> Null:
    place, roll = (track_of(document, Address(prop)) for prop in (properties.GROUND_POSITION, properties.GROUND_ROLL))
    rate = document.canvas.frame_rate
    sliders = (("Declination", _number(document, properties.GROUND_DECLINATION)),)
    return Null(
        "ground",
        "Ground line",
        channel_of(place, 0, rate),
        channel_of(place, 1, rate),
        channel_of(roll, 0, rate),
        sliders,
    )


def _light(document: Document) -> Null:
    sliders = (
        ("Sun azimuth", _number(document, properties.LIGHT_AZIMUTH)),
        ("Sun elevation", _number(document, properties.LIGHT_ELEVATION)),
    )
    track = track_of(document, Address(properties.LIGHT_POSITION))
    rate = document.canvas.frame_rate
    if _is_plain(document):
        # An orthographic camera shows x and y as they are, so the curves can stay curves.
        return Null("light", "Light", channel_of(track, 0, rate), channel_of(track, 1, rate), _STILL, sliders)
    seen = {frame: _lamp_on_canvas(document, frame) for frame in range(1, document.canvas.length_frames + 1)}
    return Null("light", "Light", *_baked(document, lambda frame: seen[frame]), _STILL, sliders)


def _is_plain(document: Document) -> bool:
    """Whether the light is a lamp seen without perspective for the whole cut."""
    fov, kind = (track_of(document, Address(prop)) for prop in (properties.FOV, properties.LIGHT_KIND))
    flat = not any(key.value for key in fov.keys) if fov.is_keyed else not fov.constant
    lamp = all(key.value == "point" for key in kind.keys) if kind.is_keyed else kind.constant == "point"
    return bool(flat and lamp)


def _lamp_on_canvas(document: Document, frame: int) -> Point2:
    """Return where the light is seen; a sun is far away, so its null lies on the ground's own point."""
    light = light_at(document, frame, ground_at(document, frame))
    camera = camera_at(document, frame)
    matrix = camera.canvas_from_world()
    # A lamp behind the eye is seen nowhere.
    if light[3] == 0 or float(matrix[2] @ light) <= 0:
        return value_at(document.tracks, properties.GROUND_POSITION, frame)
    return project(matrix, light)


def _points(document: Document, layer: Layer) -> tuple[Null, ...]:
    track = track_of(document, Address(properties.GROUNDING, layer.id))
    rate = document.canvas.frame_rate
    counts = {len(components_of(key.value) or ()) // 2 for key in track.keys} or {
        len(components_of(track.constant) or ()) // 2
    }
    made = []
    for index in range(max(counts)):
        if len(counts) == 1:
            x, y = (channel_of(track, 2 * index + part, rate) for part in (0, 1))
        else:
            x, y = _baked(document, lambda frame, index=index: _point(track, index, frame))  # type: ignore[misc] # bound now
        made.append(Null(f"point:{layer.id}:{index + 1}", f"{layer.name} grounding {index + 1}", x, y, _STILL))
    return tuple(made)


def _point(track: Track, index: int, frame: int) -> Point2:
    """Return a grounding point; while there are fewer it lies on the last of them."""
    parts = components_of(track.value_at(frame)) or (0.0, 0.0)
    at = min(2 * index, len(parts) - 2)
    return (parts[at], parts[at + 1])


def _baked(document: Document, place_at: Callable[[int], Point2]) -> tuple[Channel, Channel]:
    frames, rate = document.canvas.length_frames, document.canvas.frame_rate
    return (
        baked(lambda frame: place_at(frame)[0], frames, rate),
        baked(lambda frame: place_at(frame)[1], frames, rate),
    )


def _number(document: Document, prop: AnyProperty) -> Channel:
    return channel_of(track_of(document, Address(prop)), 0, document.canvas.frame_rate)
