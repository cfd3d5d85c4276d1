"""What the numbers of a pass need of a matte."""

from typing import Protocol

from kagezou.geometry.box import Box
from kagezou.render.prepare.occupancy import Occupancy


class MatteOnCanvas(Protocol):
    """A matte as it lies on the canvas, one texel a canvas px; its texels themselves are on the graphics card."""

    @property
    def box(self) -> Box:
        """The canvas px that its texels cover."""

    @property
    def occupancy(self) -> Occupancy:
        """Where it is empty or full."""
