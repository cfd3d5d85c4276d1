"""The graph as it is seen now: its curves, what of them is near a place, and the frame around the selected keys."""

from dataclasses import dataclass
from math import hypot
from typing import TypeVar

import numpy as np

from kagezou.document.key_edits import Refs
from kagezou.tools.curves.graph_pointer import GraphPlace
from kagezou.tools.curves.key_box import KeyBox, box_around
from kagezou.tools.curves.picture import CurvePicture, GraphKind, HandleMark, KeyMark, Pictures

KEY_REACH_PX = 10.0
CURVE_REACH_PX = 7.0

Mark = TypeVar("Mark", KeyMark, HandleMark)


@dataclass(frozen=True, slots=True)
class GraphModel:
    """What is seen, and at which scale.

    Parameters
    ----------
    pictures
        The curves.
    pixels
        How many frames and ordinates a px is.
    kind
        What is drawn over time.
    is_locked
        Whether nothing can be changed.
    """

    pictures: Pictures
    pixels: tuple[float, float]
    kind: GraphKind
    is_locked: bool

    @property
    def key_box(self) -> KeyBox | None:
        """The frame around the selected keys, where they can be pulled by it."""
        if self.is_locked or self.kind is GraphKind.SPEED:
            return None
        return box_around(self.pictures, self.pixels)

    def key_at(self, place: GraphPlace) -> tuple[CurvePicture, KeyMark] | None:
        """Return the key nearest to a place, None beyond reach."""
        return self._nearest(place, [(picture, mark) for picture in self.pictures for mark in picture.keys])

    def handle_at(self, place: GraphPlace) -> tuple[CurvePicture, HandleMark] | None:
        """Return the handle nearest to a place, None beyond reach and where nothing can be changed."""
        if self.is_locked:
            return None
        return self._nearest(place, [(picture, mark) for picture in self.pictures for mark in picture.handles])

    def curve_at(self, place: GraphPlace) -> CurvePicture | None:
        """Return the curve nearest to a place, None beyond reach."""
        across, up = self.pixels

        def away(picture: CurvePicture) -> float:
            line = picture.line
            # The curve near the pointer, a pixel's width to both sides.
            frames = place[0] + np.array([-2.0, 0.0, 2.0]) * across
            levels = np.interp(frames, line.frames, line.values)
            return float(np.min(np.abs(levels - place[1])) / up)

        near = min(self.pictures, key=away, default=None)
        return near if near is not None and away(near) <= CURVE_REACH_PX else None

    def keys_between(self, corner: GraphPlace, opposite: GraphPlace) -> Refs:
        """Return the keys in the box between two of its corners, its edges included."""
        (left, right), (low, high) = (sorted(pair) for pair in zip(corner, opposite, strict=True))
        return frozenset(
            mark.ref
            for picture in self.pictures
            for mark in picture.keys
            if left <= mark.frame <= right and low <= mark.ordinate <= high
        )

    def _nearest(self, place: GraphPlace, found: list[tuple[CurvePicture, Mark]]) -> tuple[CurvePicture, Mark] | None:
        across, up = self.pixels

        def away(each: tuple[CurvePicture, Mark]) -> float:
            return hypot((each[1].frame - place[0]) / across, (each[1].ordinate - place[1]) / up)

        near = min(found, key=away, default=None)
        return near if near is not None and away(near) <= KEY_REACH_PX else None
