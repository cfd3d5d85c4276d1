"""Long shadows: whether the head of one still falls on the picture, and whether one climbs up a background."""

from collections.abc import Iterator
from typing import Final

import numpy as np

from kagezou.document.figure_properties import SHAPE
from kagezou.document.model import Layer
from kagezou.document.properties import LIGHT_AZIMUTH, LIGHT_ELEVATION, LIGHT_KIND
from kagezou.document.values import value_at
from kagezou.geometry.light import sun
from kagezou.geometry.shadow import cast_on
from kagezou.geometry.vectors import Matrix, Point2, Vector4
from kagezou.message import Message
from kagezou.scene.evaluate import light_at
from kagezou.scene.figure_card import Moment
from kagezou.scene.placing import figure_box
from kagezou.scene.poses import casting_of

LOW_DEG: Final = 35.0
"""Under a sun lower than this shadows are long and may leave the picture unforeseen; a higher one is not asked."""

_AZIMUTHS_DEG: Final = range(-75, 76, 5)
_ELEVATIONS_DEG: Final = range(15, 61, 5)

_HEAD: Final = ((0.0, 0.0), (-0.25, 0.15), (0.25, 0.15))
"""The outline of a head: from the middle of the top of the box around a figure, in parts of its width and height."""

_CLIMBED: Final = 0.6
"""A shadow whose head is seen higher over the feet than this part of the figure's height climbs up the picture."""

_STEEPER_COUNTS: Final = 2.0
"""A degree of elevation takes more from the look than one of azimuth."""


def leaving_words(on: Moment, layer: Layer) -> Message | None:
    """Return what to say of a figure in a low sun whose head's shadow falls beside the picture; None else."""
    tracks = on.document.tracks
    azimuth, elevation = (value_at(tracks, prop, on.frame) for prop in (LIGHT_AZIMUTH, LIGHT_ELEVATION))
    is_low = value_at(tracks, LIGHT_KIND, on.frame) == "sun" and 0 < elevation < LOW_DEG
    if not is_low or value_at(layer.tracks, SHAPE, on.frame) == "disc" or _is_kept(on, layer, (azimuth, elevation)):
        return None
    suns = sorted(_suns(), key=lambda way: abs(way[0] - azimuth) + _STEEPER_COUNTS * abs(way[1] - elevation))
    kept = next((way for way in suns if _is_kept(on, layer, way)), None)
    if kept is None:
        return Message(
            "the head of {figure}'s long shadow falls beside the picture on frame {frame}, as it does under any sun",
            figure=layer.name,
            frame=on.frame,
        )
    return Message(
        "the head of {figure}'s long shadow falls beside the picture on frame {frame}: light.azimuth = {azimuth} and "
        "light.elevation = {elevation} keep it there",
        figure=layer.name,
        frame=on.frame,
        azimuth=round(kept[0]),
        elevation=round(kept[1]),
    )


def climbing_words(on: Moment, layer: Layer) -> Message | None:
    """Return what to say of a shadow that runs far up a background for want of perspective; None else.

    Seen straight on, the ground has no horizon: over a painted picture a long shadow climbs into what stands there.
    """
    is_flat = on.camera.eye[3] == 0 and on.document.behind.drawing_at(on.frame) is not None
    if not is_flat or value_at(layer.tracks, SHAPE, on.frame) == "disc":
        return None
    head = _head_on_canvas(on, layer, light_at(on.document, on.frame, on.ground))
    box = figure_box(on.document, layer.id, on.frame)
    if head is None or box.bottom - float(head[1, 0] / head[2, 0]) <= _CLIMBED * box.height:
        return None
    return Message(
        "{figure}'s long shadow runs up the background on frame {frame}, for without perspective the ground has no "
        "horizon: camera.fov, or matching the camera to the picture, lays it down",
        figure=layer.name,
        frame=on.frame,
    )


def _suns() -> Iterator[Point2]:
    """Yield azimuths and elevations that shadows fall away from the viewer under."""
    return ((float(azimuth), float(elevation)) for azimuth in _AZIMUTHS_DEG for elevation in _ELEVATIONS_DEG)


def _is_kept(on: Moment, layer: Layer, way: Point2) -> bool:
    """Whether the shadow of a figure's head falls on the picture under the sun of an azimuth and an elevation."""
    head = _head_on_canvas(on, layer, sun(on.ground, *way))
    if head is None:
        return False
    x, y, w = head
    inside = (w > 0) & (x >= 0) & (x <= w * on.camera.width_px) & (y >= 0) & (y <= w * on.camera.height_px)
    return bool(inside.all())


def _head_on_canvas(on: Moment, layer: Layer, light: Vector4) -> Matrix | None:
    """Return where the shadow of a figure's head is seen, homogeneous (3, N), its top first; None where none is."""
    box = figure_box(on.document, layer.id, on.frame)
    card, lowered = casting_of(on, layer, on.frame, light)
    places = [(box.middle[0] + x * box.width, box.top + y * box.height) for x, y in _HEAD]
    head = np.array([place if lowered is None else lowered.lowered(place) for place in places])
    top = (float(head[0][0]), float(head[0][1]))
    piece = next((each for each in card.pieces if each.holds(top)), card.pieces[0])
    cast = cast_on(on.camera, on.ground, piece, light)
    if cast is None:
        return None
    return np.asarray(np.linalg.inv(cast.art_from_canvas) @ np.column_stack([head, np.ones(len(head))]).T)
