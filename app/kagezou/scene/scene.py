"""The frozen record of one frame."""

from dataclasses import dataclass

from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.card import Card
from kagezou.geometry.ground import Plane
from kagezou.geometry.placement import Placement, lie_alike
from kagezou.geometry.shadow import Cast, SpaceCast, cast_card, cast_in_space
from kagezou.geometry.vectors import Vector4
from kagezou.geometry.waves import Ripple
from kagezou.picture_source import PictureSource
from kagezou.scene.disc import Disc
from kagezou.scene.pieces import PieceScene, SetCast


@dataclass(frozen=True, slots=True)
class Simplify:
    """How a shadow's shape is rounded (paper 3.6.1, spec 3).

    Parameters
    ----------
    amount_px
        s, the standard deviation of the blur in px of the receiver, over 0.
    distance_px
        d, the distance from the contact line at which it is reached; 0 for the same everywhere.
    elongation
        e, from 0, toward a disc, to 1, toward the ellipse of the shadow's own moments.
    hold
        From 0, where the shape lies, to 1, slid so that it begins under the feet.
    """

    amount_px: float
    distance_px: float
    elongation: float = 0.0
    hold: float = 0.0


@dataclass(frozen=True, slots=True)
class Edge:
    """What becomes of a shadow's outline.

    Parameters
    ----------
    grow_px
        How far it is moved outward.
    softness_px
        How wide the edge is at the contact line, px of the receiver; 0 is crisp.
    penumbra
        How much wider it is with every px away from that line.
    """

    grow_px: float
    softness_px: float
    penumbra: float


@dataclass(frozen=True, slots=True)
class Water:
    """The waves that move a shadow at one moment (paper 3.6.2, spec 4).

    Parameters
    ----------
    ripples
        The sets of waves; their displacements, in u and v of the receiver, add up.
    anchor_px
        The distance from the contact line at which they have their full strength; 0 for everywhere.
    """

    ripples: tuple[Ripple, ...]
    anchor_px: float


@dataclass(frozen=True, slots=True)
class PlacedDrawing:
    """A drawing as it lies on the canvas: centred, pixel for pixel, unless a placement moves it."""

    source: PictureSource
    placement: Placement | None = None


@dataclass(frozen=True, slots=True)
class ShadowCast:
    """All that decides the shape of a layer's shadow; equal casts have equal pixels.

    Parameters
    ----------
    figure
        The cels that block the light together, at least one, or the disc of a round shadow; they are one silhouette.
    translucent
        Whether its alpha casts as it is; else alpha of 0.5 and more casts fully.
    camera, receivers
        What the shadow is seen with, and the surfaces it falls on; the ground is the first.
    card
        The surface the drawing stands on.
    lights
        Homogeneous; their shadows unite by maximum.
    simplify, edge, water
        How the united shape is rounded, what becomes of its outline, and the waves it lies on; None for not at all.
    pieces
        The set that stands on the ground.
    ground_receives
        Whether the flat ground is there at all, or only the pieces are.
    least_part_px2
        Islands and holes smaller than this, canvas px², are left out.
    """

    figure: tuple[PlacedDrawing | Disc, ...]
    translucent: bool
    camera: Camera
    receivers: tuple[Plane, ...]
    card: Card
    lights: tuple[Vector4, ...]
    simplify: Simplify | None = None
    edge: Edge | None = None
    water: Water | None = None
    pieces: tuple[PieceScene, ...] = ()
    ground_receives: bool = True
    least_part_px2: float = 0.0

    @property
    def is_filtered(self) -> bool:
        """Whether anything is done to the shape after it is cast."""
        return self.simplify is not None or self.edge is not None or self.water is not None

    @property
    def sources(self) -> tuple[PictureSource, ...]:
        """What its silhouette is read from."""
        return tuple(dict.fromkeys(part.source for part in self.figure if isinstance(part, PlacedDrawing)))

    @property
    def is_round(self) -> bool:
        """Whether it is a disc on the ground instead of what the light casts."""
        return any(isinstance(part, Disc) for part in self.figure)

    @property
    def placement(self) -> Placement | None:
        """How the silhouette is moved: as its cels are, where all are moved alike; else it is that of the canvas."""
        first, *others = (part.placement for part in self.figure)
        return first if all(lie_alike(first, other) for other in others) else None

    def on(self, receiver: Plane, light: Vector4) -> tuple[Cast, ...]:
        """Return what the pieces of the card cast on a flat receiver, in px of the silhouette."""
        casts = cast_card(self.camera, receiver, self.card, light)
        if self.placement is None:
            return casts
        return tuple(each.of_moved(self.placement) for each in casts)

    def in_space(self, light: Vector4) -> tuple[SpaceCast, ...]:
        """Return what the pieces of the card cast anywhere, in px of the silhouette."""
        found = (cast_in_space(self.camera, piece, light) for piece in self.card.pieces)
        casts = (each for each in found if each is not None)
        return tuple(each if self.placement is None else each.of_moved(self.placement) for each in casts)


@dataclass(frozen=True, slots=True)
class Fade:
    """How opacity falls with the distance |v| from the contact line: (1 - |v| / range)^curve.

    Parameters
    ----------
    range_px
        Where nothing is left, over 0.
    curve
        1 for evenly.
    """

    range_px: float
    curve: float


@dataclass(frozen=True, slots=True)
class Tip:
    """A second colour, sRGB 0 to 255, that is reached at a distance over 0 from the contact line."""

    color: tuple[int, int, int]
    distance_px: float


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
    fade, tip
        How it changes with the distance from the contact line; None for not at all.
    """

    color: tuple[int, int, int]
    opacity: float
    multiply: bool
    fade: Fade | None = None
    tip: Tip | None = None

    @property
    def is_plain(self) -> bool:
        """Whether it is the same everywhere."""
        return self.fade is None and self.tip is None


@dataclass(frozen=True, slots=True)
class Shade:
    """What falls on a character from others whose shadows look alike: their casts unite by maximum.

    The casts have no receivers, those are the pieces of the character's card; nothing is done to their shape.
    """

    casts: tuple[ShadowCast, ...]
    look: ShadowLook


@dataclass(frozen=True, slots=True)
class Received:
    """The shadows of other characters on one character.

    Parameters
    ----------
    drawing
        Of the character on which they fall; they are cut to its alpha.
    card
        The surface it stands on.
    shades
        By their looks, in the order of the lowest layers that cast them.
    """

    drawing: PlacedDrawing
    card: Card
    shades: tuple[Shade, ...]


@dataclass(frozen=True, slots=True)
class LayerScene:
    """One visible character layer.

    Parameters
    ----------
    id, name
        As of the document's layer.
    drawing
        None while its cel is empty.
    cast
        The shadow of its figure; None while all cels of that are empty, and for a part of another layer's figure.
    look
        How the shadow is laid on the picture.
    card
        What it stands on; that of its figure.
    figure_id
        The layer whose figure it is a part of; its own id for a figure of its own.
    received
        What others cast on it, None where it does not receive.
    """

    id: str
    name: str
    drawing: PlacedDrawing | None
    cast: ShadowCast | None
    look: ShadowLook
    card: Card
    figure_id: str
    received: Received | None = None


@dataclass(frozen=True, slots=True)
class SetShadow:
    """The shadow of the set itself and how it is laid on the picture."""

    cast: SetCast
    look: ShadowLook


@dataclass(frozen=True, slots=True)
class Scene:
    """One frame: the canvas, what it is seen with, the ground, the visible layers from bottom to top, and the set.

    ``set_shadow`` is None where no piece casts one. ``shadows_unite`` says whether shadows of like look do, see
    ``uniting``.
    """

    canvas: Box
    camera: Camera
    ground: Plane
    background: PlacedDrawing | None
    layers: tuple[LayerScene, ...]
    pieces: tuple[PieceScene, ...] = ()
    set_shadow: SetShadow | None = None
    shadows_unite: bool = True
