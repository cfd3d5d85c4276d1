"""The frozen record of one frame."""

from dataclasses import dataclass
from pathlib import Path

from kagezou.document.model import Drawing
from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.card import Card
from kagezou.geometry.ground import Plane
from kagezou.geometry.vectors import Vector4


@dataclass(frozen=True, slots=True)
class Simplify:
    """How a shadow's shape is rounded (paper 3.6.1, spec 3).

    Parameters
    ----------
    amount_px
        s, the standard deviation of the blur in px of the receiver, over 0.
    distance_px
        d, the distance from the contact line at which it is reached; 0 for the same everywhere.
    """

    amount_px: float
    distance_px: float


@dataclass(frozen=True, slots=True)
class ShadowCast:
    """All that decides the shape of a layer's shadow; equal casts have equal pixels.

    Parameters
    ----------
    drawing
        The cel that blocks the light.
    translucent
        Whether its alpha casts as it is; else alpha of 0.5 and more casts fully.
    camera, receivers
        What the shadow is seen with, and the surfaces it falls on.
    card
        The surface the drawing stands on.
    lights
        Homogeneous; their shadows unite by maximum.
    simplify
        How the united shape is rounded, None for not at all.
    """

    drawing: Drawing
    translucent: bool
    camera: Camera
    receivers: tuple[Plane, ...]
    card: Card
    lights: tuple[Vector4, ...]
    simplify: Simplify | None = None


@dataclass(frozen=True, slots=True)
class ShadowLook:
    """How a shadow of known shape is coloured and laid on the picture.

    Parameters
    ----------
    color
        sRGB, 0 to 255.
    opacity
        0 to 1.
    multiply
        Whether it multiplies what is under it; else it lies over it.
    """

    color: tuple[int, int, int]
    opacity: float
    multiply: bool


@dataclass(frozen=True, slots=True)
class LayerScene:
    """One visible character layer: its drawing and shadow, both None while its cel is empty."""

    id: str
    name: str
    drawing: Drawing | None
    cast: ShadowCast | None
    look: ShadowLook


@dataclass(frozen=True, slots=True)
class Scene:
    """One frame: the canvas, what it is seen with, the ground and the visible layers from bottom to top."""

    canvas: Box
    camera: Camera
    ground: Plane
    background: Path | None
    layers: tuple[LayerScene, ...]
