"""Where the hand is on the graph of curves, and what the keys it holds ask for."""

from dataclasses import dataclass

from kagezou.geometry.vectors import Point2

GraphPlace = tuple[float, float]
"""A frame and an ordinate."""


@dataclass(frozen=True, slots=True)
class GraphPointer:
    """One report of mouse or pen.

    Parameters
    ----------
    place
        In graph coordinates.
    view_px
        The same in the widget, logical px, y down.
    one_axis
        Keep to the way along which the hand goes farther; a corner of the frame scales both ways alike.
    alone
        Leave the handle on the other side of the key where it is.
    about_centre
        Scale about the middle of the frame instead of the opposite edge.
    """

    place: GraphPlace
    view_px: Point2 = (0.0, 0.0)
    one_axis: bool = False
    alone: bool = False
    about_centre: bool = False

    def since(self, press: "GraphPointer") -> tuple[float, float]:
        """Return how far the hand has gone since the press, in frames and ordinates."""
        return self.place[0] - press.place[0], self.place[1] - press.place[1]
