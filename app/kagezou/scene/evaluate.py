"""From a document and a frame to the scene."""

from dataclasses import replace
from functools import partial
from math import floor

from kagezou.document import properties, set_properties
from kagezou.document.figure_properties import EDGES, HOLD, LEAST_PART, PAINTED, SHADOWS_UNITE, SHAPE
from kagezou.document.figures import height_of, parts_of
from kagezou.document.model import Document, Layer, Tracks
from kagezou.document.values import rgb_at, value_at
from kagezou.geometry.camera import Camera
from kagezou.geometry.card import Card
from kagezou.geometry.ground import Plane, ground_plane
from kagezou.geometry.light import is_over, joined, lamp, overhead_share, sun, virtual_lights
from kagezou.geometry.vectors import Vector3, Vector4
from kagezou.scene.contact_patches import contact_at
from kagezou.scene.figure_card import Moment, card_of
from kagezou.scene.filters import Edge, Simplify, Water
from kagezou.scene.known_layers import KnownLayers
from kagezou.scene.lift import Lift, faded, lift_at, lowered_cel
from kagezou.scene.mirroring import reflection_at
from kagezou.scene.pieces import PieceScene, SetCast
from kagezou.scene.placing import background_at, drawing_of, shown_parts
from kagezou.scene.poses import casting_of
from kagezou.scene.receiving import with_received
from kagezou.scene.round_shadow import rounded
from kagezou.scene.scene import (
    Fade,
    LayerScene,
    PlacedDrawing,
    Scene,
    SetShadow,
    ShadowCast,
    ShadowLook,
    Tip,
)
from kagezou.scene.water import water_at

LEAST_PX = 0.01
"""What moves an outline by less cannot be seen and is left out."""

_FARTHEST_PX = 1000.0


def evaluate(document: Document, frame: int, known: KnownLayers | None = None) -> Scene:
    """Return the scene of a frame, counted from 1; invisible layers are left out.

    Parameters
    ----------
    known
        What layers were when they were evaluated last; it learns what they are now.
    """
    camera = camera_at(document, frame)
    ground = ground_at(document, frame)
    pieces = _pieces_at(document, frame, camera, ground)
    has_ground = value_at(document.tracks, set_properties.GROUND_RECEIVES, frame)
    stands = Moment(document, frame, camera, ground)
    seen = [layer for layer in document.layers if value_at(layer.tracks, properties.VISIBLE, frame)]
    scenes = (known or KnownLayers()).scenes(document, frame, seen, partial(_layer_scene, stands))
    layers = tuple(_on_set(scene, pieces, has_ground=has_ground) for scene in scenes)
    receiving = {layer.id for layer in document.layers if value_at(layer.tracks, properties.RECEIVES, frame)}
    layers = with_received(layers, receiving)
    set_shadow = _set_shadow(document, frame, SetCast(camera, ground, pieces, (), has_ground))
    unite = value_at(document.tracks, SHADOWS_UNITE, frame)
    return Scene(document.canvas.box, camera, ground, background_at(document, frame), layers, pieces, set_shadow, unite)


def _pieces_at(document: Document, frame: int, camera: Camera, ground: Plane) -> tuple[PieceScene, ...]:
    if not document.pieces:
        return ()
    from kagezou.scene.set_at_frame import pieces_at  # loaded with the first set

    return pieces_at(document, frame, camera, ground)


def camera_at(document: Document, frame: int) -> Camera:
    """Return the camera of a frame."""
    fov = value_at(document.tracks, properties.FOV, frame)
    return Camera(document.canvas.width_px, document.canvas.height_px, fov)


def ground_at(document: Document, frame: int) -> Plane:
    """Return the ground of a frame."""
    position = value_at(document.tracks, properties.GROUND_POSITION, frame)
    roll = value_at(document.tracks, properties.GROUND_ROLL, frame)
    declination = value_at(document.tracks, properties.GROUND_DECLINATION, frame)
    return ground_plane(position, roll, declination)


def light_at(document: Document, frame: int, ground: Plane) -> Vector4:
    """Return the light of a frame, homogeneous, before it is spread into virtual ones."""
    if value_at(document.tracks, properties.LIGHT_KIND, frame) == "sun":
        azimuth = value_at(document.tracks, properties.LIGHT_AZIMUTH, frame)
        elevation = value_at(document.tracks, properties.LIGHT_ELEVATION, frame)
        return sun(ground, azimuth, elevation)
    x, y, z = value_at(document.tracks, properties.LIGHT_POSITION, frame)
    step = value_at(document.tracks, properties.LIGHT_STEP, frame)
    return lamp((_by_steps(x, step), _by_steps(y, step), _by_steps(z, step)))


def _by_steps(length: float, step: float) -> float:
    """Return the nearest multiple of a step; 0 leaves a length as it is."""
    return step * floor(length / step + 0.5) if step > 0 else length


def contact_of(card: Card, ground: Plane) -> Vector3:
    """Return where the character stands: the middle of its grounding points' places, else the ground's position."""
    if not card.contacts:
        return ground.origin
    x, y, z = (sum(axis) / len(card.contacts) for axis in zip(*card.contacts, strict=True))
    return (x, y, z)


def _layer_scene(on: Moment, layer: Layer) -> LayerScene:
    drawing = drawing_of(on.document, layer, on.frame)
    figure = layer if layer.joins is None else on.document.layer(layer.joins)
    parts = parts_of(on.document, figure.id)
    # Everything about the shadow but the camera, the ground under it and where cels lie may wait for the next drawing.
    waits = value_at(figure.tracks, properties.TIMING, on.frame) == "exposures"
    moment = max(part.cels.exposed_since(on.frame) for part in parts) if waits else on.frame
    card, lift = card_of(on, figure, moment), lift_at(on.document, figure, on.frame, moment)
    look = _look(figure.tracks, moment)
    look = look if lift is None else faded(lift, look)
    cels = _cels_of(on, figure) if layer is figure else ()
    water = water_at(figure.tracks, moment, height_of(figure, moment), on.document.canvas.length_frames)
    cast = _cast(on, figure, moment, lift, cels, water) if cels else None
    return LayerScene(
        layer.id,
        layer.name,
        drawing,
        cast,
        look,
        card,
        figure.id,
        contact=None if cast is None else contact_at(on, figure, moment, card),
        reflection=reflection_at(on, figure, moment, cels, water),
    )


def _cels_of(on: Moment, figure: Layer) -> tuple[PlacedDrawing, ...]:
    """Return what is seen of the cels of a figure, from the bottom."""
    parts = shown_parts(on.document, figure.id, on.frame)
    return tuple(cel for part in parts if (cel := drawing_of(on.document, part, on.frame)) is not None)


def _cast(
    on: Moment, figure: Layer, moment: int, lift: Lift | None, cels: tuple[PlacedDrawing, ...], water: Water | None
) -> ShadowCast | None:
    """Return what the cels of a figure cast together, at least one; None where a disc is seen edge-on."""
    light = light_at(on.document, moment, on.ground)
    card, lowered = casting_of(on, figure, moment, light)
    if lowered is not None:
        cels = tuple(lowered_cel(lowered, cel) for cel in cels)
    radius = value_at(on.document.tracks, properties.OVERHEAD_RADIUS, moment)
    contact = contact_of(card, on.ground)
    spread = virtual_lights(light, contact, radius)
    cast = ShadowCast(
        figure=cels,
        translucent=value_at(figure.tracks, properties.MATTE, moment) == "translucent",
        camera=on.camera,
        receivers=(on.ground,),
        card=card,
        lights=tuple(each for each in spread if is_over(on.ground, each)),
        simplify=_simplify(on.document.tracks, figure.tracks, moment, overhead_share(light, contact, radius)),
        edge=_edge(figure.tracks, moment, 0.0 if lift is None else lift.wider_px),
        water=water,
        least_part_px2=value_at(figure.tracks, LEAST_PART, moment),
        is_hard=value_at(figure.tracks, EDGES, moment) == "hard",
        without_painted=value_at(figure.tracks, PAINTED, moment) == "left_out",
    )
    is_round = value_at(figure.tracks, SHAPE, moment) == "disc"
    return rounded(on, figure, moment, lift, cast) if is_round else cast


def _on_set(layer: LayerScene, pieces: tuple[PieceScene, ...], *, has_ground: bool) -> LayerScene:
    if not pieces and has_ground:
        return layer
    cast, contact, mirrored = layer.cast, layer.contact, layer.reflection
    return replace(
        layer,
        cast=cast and replace(cast, pieces=pieces, ground_receives=has_ground),
        contact=contact and replace(contact, cast=replace(contact.cast, pieces=pieces, ground_receives=has_ground)),
        reflection=mirrored and replace(mirrored, pieces=pieces, ground_receives=has_ground),
    )


def _set_shadow(document: Document, frame: int, dark: SetCast) -> SetShadow | None:
    """Return the shadow of the set itself under the lights of a frame; ``dark`` has none yet."""
    if not any(piece.casts for piece in dark.pieces):
        return None
    light = light_at(document, frame, dark.ground)
    radius = value_at(document.tracks, properties.OVERHEAD_RADIUS, frame)
    spread = virtual_lights(light, dark.ground.origin, radius)
    look = ShadowLook(
        color=rgb_at(document.tracks, set_properties.SET_COLOR, frame),
        opacity=value_at(document.tracks, set_properties.SET_OPACITY, frame),
        multiply=value_at(document.tracks, set_properties.SET_BLEND, frame) == "multiply",
    )
    return SetShadow(replace(dark, lights=tuple(each for each in spread if is_over(dark.ground, each))), look)


def _simplify(of_scene: Tracks, tracks: Tracks, frame: int, overhead: float) -> Simplify | None:
    """Return how a shadow is simplified, under a light that is so far overhead (0 to 1)."""
    at_least = value_at(of_scene, properties.OVERHEAD_SIMPLIFY, frame)
    amount, distance = (value_at(tracks, prop, frame) for prop in (properties.SIMPLIFY, properties.DISTANCE))
    amount, distance = joined(amount, distance, at_least, overhead)
    if amount < LEAST_PX or not value_at(tracks, properties.SIMPLIFY_ON, frame):
        return None
    elongation, hold = (value_at(tracks, prop, frame) for prop in (properties.ELONGATION, HOLD))
    return Simplify(amount, distance, elongation, hold)


def _edge(tracks: Tracks, frame: int, wider_px: float) -> Edge | None:
    """Return what becomes of an outline that a jump makes so much wider."""
    grow, softness, penumbra = (
        value_at(tracks, prop, frame) for prop in (properties.GROW, properties.SOFTNESS, properties.PENUMBRA)
    )
    softness += wider_px
    if max(abs(grow), softness, penumbra * _FARTHEST_PX) < LEAST_PX:
        return None
    return Edge(grow, softness, penumbra)


def _look(tracks: Tracks, frame: int) -> ShadowLook:
    fade = value_at(tracks, properties.FADE, frame)
    tip = value_at(tracks, properties.TIP_DISTANCE, frame)
    return ShadowLook(
        color=rgb_at(tracks, properties.COLOR, frame),
        opacity=value_at(tracks, properties.OPACITY, frame),
        multiply=value_at(tracks, properties.BLEND, frame) == "multiply",
        fade=Fade(fade, value_at(tracks, properties.FADE_CURVE, frame)) if fade > 0 else None,
        tip=Tip(rgb_at(tracks, properties.TIP_COLOR, frame), tip) if tip > 0 else None,
    )
