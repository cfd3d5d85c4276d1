"""The frame around the selected keys: where it lies, and what of it is under the pointer."""

from collections.abc import Iterable
from dataclasses import dataclass

from kagezou.tools.curves.graph_pointer import GraphPlace
from kagezou.tools.curves.picture import CurvePicture, KeyMark

REACH_PX = 10.0
PADDING_PX = 16.0
"""The frame stands off from its keys so that both can be taken hold of."""


@dataclass(frozen=True, slots=True)
class BoxGrip:
    """A part of the frame: −1, 0 or 1 across and up; (0, 0) is its inside."""

    across: int
    up: int

    @property
    def is_inside(self) -> bool:
        """Whether it moves the keys instead of scaling them."""
        return self.across == self.up == 0


@dataclass(frozen=True, slots=True)
class Outline:
    """A box in graph coordinates."""

    left: float
    right: float
    low: float
    high: float

    def holds(self, place: GraphPlace) -> bool:
        """Whether a place is within it, its edges included."""
        return self.left <= place[0] <= self.right and self.low <= place[1] <= self.high


@dataclass(frozen=True, slots=True)
class KeyBox:
    """The smallest box around keys in graph coordinates, and the px that a frame and a unit measure."""

    left: float
    right: float
    low: float
    high: float
    frame_px: float
    unit_px: float

    @property
    def parts(self) -> tuple[BoxGrip, ...]:
        """The handles there are; without any breadth, or height, there is nothing to scale that way."""
        wide, tall = self.right > self.left, (self.high - self.low) * self.unit_px > 1e-6
        across, up = (-1, 0, 1) if wide else (0,), (-1, 0, 1) if tall else (0,)
        return tuple(BoxGrip(a, u) for a in across for u in up if a or u)

    @property
    def padded(self) -> Outline:
        """The frame as it is drawn."""
        across, up = PADDING_PX / self.frame_px, PADDING_PX / self.unit_px
        return Outline(self.left - across, self.right + across, self.low - up, self.high + up)

    def place_of(self, part: BoxGrip) -> GraphPlace:
        """Return where the handle of a part is drawn."""
        frame = self.padded
        x = (frame.left, (frame.left + frame.right) / 2, frame.right)[part.across + 1]
        return x, (frame.low, (frame.low + frame.high) / 2, frame.high)[part.up + 1]

    def edge_of(self, part: BoxGrip) -> GraphPlace:
        """Return the edge of the keys themselves on the side of a part."""
        middle = (self.left + self.right) / 2, (self.low + self.high) / 2
        x = (self.left, middle[0], self.right)[part.across + 1]
        return x, (self.low, middle[1], self.high)[part.up + 1]

    def part_at(self, place: GraphPlace) -> BoxGrip | None:
        """Return the part under a place of the graph, a handle within reach before the inside."""

        def away(part: BoxGrip) -> float:
            x, y = self.place_of(part)
            return float(max(abs(x - place[0]) * self.frame_px, abs(y - place[1]) * self.unit_px))

        near = min(self.parts, key=away, default=None)
        if near is not None and away(near) <= REACH_PX:
            return near
        return BoxGrip(0, 0) if self.padded.holds(place) else None


def box_around(pictures: Iterable[CurvePicture], pixels: tuple[float, float]) -> KeyBox | None:
    """Return the box around the selected keys that are seen; None for fewer than two keys.

    Parameters
    ----------
    pictures
        What is drawn.
    pixels
        Frames and units a pixel.
    """
    marks: list[KeyMark] = [mark for picture in pictures for mark in picture.keys if mark.is_chosen]
    if len({mark.ref for mark in marks}) < 2:
        return None
    frames, levels = [mark.frame for mark in marks], [mark.ordinate for mark in marks]
    return KeyBox(min(frames), max(frames), min(levels), max(levels), 1 / pixels[0], 1 / pixels[1])
