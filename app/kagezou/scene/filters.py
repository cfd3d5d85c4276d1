"""What is done to the shape of a shadow after it is cast."""

from dataclasses import dataclass

from kagezou.geometry.slits import Slits
from kagezou.geometry.waves import Ripple


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
    slits
        The gaps that go with the waves; None for none.
    """

    ripples: tuple[Ripple, ...]
    anchor_px: float
    slits: Slits | None = None

    @property
    def reach_px(self) -> float:
        """How far the waves move a place at most, px of the receiver."""
        return sum(ripple.wave.reach_px for ripple in self.ripples)
