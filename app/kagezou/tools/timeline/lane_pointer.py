"""Where the hand is on the lanes of the timeline."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class LanePointer:
    """One report of mouse or pen.

    Parameters
    ----------
    x_px
        The place across the lanes, logical px.
    cell_px
        The width of a frame there now.
    catches
        Whether what is dragged is drawn to frames that mean something.
    ripples
        Whether what follows a drawing moves along.
    goes_over
        Whether a drawing may take the place of its neighbours.
    """

    x_px: float
    cell_px: float
    catches: bool = True
    ripples: bool = False
    goes_over: bool = False

    def frames_since(self, press: "LanePointer") -> float:
        """Return how far the hand has gone since the press, in frames."""
        return (self.x_px - press.x_px) / self.cell_px
