"""The part of a silhouette that round shadows are cast by."""

from dataclasses import dataclass
from typing import Final

from kagezou.geometry.placement import Placement

DISC_PX: Final = 1024
DISC_RADIUS_PX: Final = 500.0
"""The side of the picture that the unit disc is drawn in, and its radius there."""


@dataclass(frozen=True, slots=True)
class Disc:
    """A part that comes from no file: the unit disc, which lies in the middle of the canvas unless it is moved."""

    placement: Placement | None = None
