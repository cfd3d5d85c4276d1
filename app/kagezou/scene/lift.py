"""Jumps: a figure in the air casts as if it stood on the ground below it, smaller, softer and fainter (figures)."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

from kagezou.document.figure_properties import LIFT_FADE, LIFT_SHRINK, LIFT_SOFTEN
from kagezou.document.model import Document, Layer
from kagezou.document.values import value_at
from kagezou.geometry.placement import Placement
from kagezou.geometry.relief import Foothold
from kagezou.geometry.vectors import Point2
from kagezou.scene.figure_card import feet_at
from kagezou.scene.scene import PlacedDrawing, ShadowLook
from kagezou.scene.stances import stances_of

_LEAST_SIZE: Final = 0.05
"""So much of its size a shadow keeps at any height."""

_SOFTEST: Final = 0.25
"""By this part of the height over the ground an edge becomes wider where ``shadow.lift_soften`` is 1."""


@dataclass(frozen=True, slots=True)
class Lift:
    """A figure in the air, and what its height makes of its shadow.

    Parameters
    ----------
    height_px
        How high it is over the ground, canvas px, over 0.
    about
        The canvas point of the ground below it, about which the shadow shrinks.
    size
        What is left of its size.
    wider_px
        By how much its edge is wider.
    opacity
        What is left of its opacity.
    standing
        Its feet and its height, px, in the air.
    """

    height_px: float
    about: Point2
    size: float
    wider_px: float
    opacity: float
    standing: tuple[tuple[Foothold, ...], float]

    def lowered(self, place: Point2) -> Point2:
        """Return where a canvas point of the figure is while it casts: down on the ground, and smaller."""
        (x, y), (cx, cy) = place, self.about
        return (cx + self.size * (x - cx), cy + self.size * (y + self.height_px - cy))

    @property
    def lowered_standing(self) -> tuple[tuple[Foothold, ...], float]:
        """Its feet and its height while it casts."""
        feet, tall = self.standing
        middle = self.about[1]
        lowered = tuple(
            replace(foot, place=self.lowered(foot.place), ground_row=middle + self.size * (foot.ground_row - middle))
            for foot in feet
        )
        return lowered, self.size * tall


def lift_at(document: Document, figure: Layer, frame: int, since: int | None = None) -> Lift | None:
    """Return how a figure is in the air at a frame; None on the ground, and where it does not stand on feet.

    Parameters
    ----------
    document, figure
        A layer with a figure of its own.
    frame
        Whose height counts.
    since
        The frame whose values of the shadow count, that one where none is given.
    """
    since = frame if since is None else since
    standing, found = feet_at(document, figure, frame, since), stances_of(document, figure.id)
    height = 0.0 if found is None else found.at(frame).lift_px
    if standing is None or height <= 0:
        return None
    feet, tall = standing
    part = min(height / max(tall, 1.0), 1.0)
    shrink, soften, fade = (value_at(figure.tracks, prop, since) for prop in (LIFT_SHRINK, LIFT_SOFTEN, LIFT_FADE))
    return Lift(
        height_px=height,
        about=middle_below(feet),
        size=max(1 - shrink * part, _LEAST_SIZE),
        wider_px=soften * _SOFTEST * height,
        opacity=1 - fade * part,
        standing=standing,
    )


def middle_below(feet: Sequence[Foothold]) -> Point2:
    """Return the canvas point of the ground below a figure: the mean of those below its feet, at least one."""
    return (sum(foot.place[0] for foot in feet) / len(feet), sum(foot.ground_row for foot in feet) / len(feet))


def lowered_cel(lift: Lift, cel: PlacedDrawing) -> PlacedDrawing:
    """Return a cel as it lies while the figure casts."""
    placement = cel.placement or Placement(lift.about, lift.about)
    sx, sy = placement.scale
    return replace(
        cel,
        placement=replace(placement, position=lift.lowered(placement.position), scale=(sx * lift.size, sy * lift.size)),
    )


def faded(lift: Lift, look: ShadowLook) -> ShadowLook:
    """Return how a shadow is laid on the picture at the height."""
    return replace(look, opacity=look.opacity * lift.opacity)
