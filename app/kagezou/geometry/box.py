"""Axis-aligned boxes on the canvas."""

from dataclasses import dataclass
from functools import reduce

from kagezou.geometry.vectors import Point2


@dataclass(frozen=True, slots=True)
class Box:
    """A half-open box in canvas px, y down: ``left <= x < right`` and ``top <= y < bottom``."""

    left: int
    top: int
    right: int
    bottom: int

    @property
    def width(self) -> int:
        """The extent in x, px."""
        return self.right - self.left

    @property
    def height(self) -> int:
        """The extent in y, px."""
        return self.bottom - self.top

    @property
    def middle(self) -> Point2:
        """Its middle, px."""
        return ((self.left + self.right) / 2, (self.top + self.bottom) / 2)

    @property
    def is_empty(self) -> bool:
        """Whether no pixel lies in the box."""
        return self.right <= self.left or self.bottom <= self.top

    def moved(self, dx: int, dy: int) -> "Box":
        """Return the box moved by whole pixels."""
        return Box(self.left + dx, self.top + dy, self.right + dx, self.bottom + dy)

    def grown(self, margin: int) -> "Box":
        """Return the box with ``margin`` px added on every side."""
        return Box(self.left - margin, self.top - margin, self.right + margin, self.bottom + margin)

    def intersection(self, other: "Box") -> "Box | None":
        """Return the common part, or None where there is none."""
        common = Box(
            max(self.left, other.left),
            max(self.top, other.top),
            min(self.right, other.right),
            min(self.bottom, other.bottom),
        )
        return None if common.is_empty else common

    def union(self, other: "Box") -> "Box":
        """Return the smallest box that holds both."""
        return Box(
            min(self.left, other.left),
            min(self.top, other.top),
            max(self.right, other.right),
            max(self.bottom, other.bottom),
        )


def around(*boxes: Box | None) -> Box | None:
    """Return the smallest box that holds all that are there, None where none is."""
    there = [box for box in boxes if box is not None]
    return reduce(Box.union, there) if there else None


def centred_offset(canvas: Box, width_px: int, height_px: int) -> tuple[int, int]:
    """Return where the top left pixel of a drawing lies that is centred on the canvas, pixel for pixel."""
    return (canvas.left + (canvas.width - width_px) // 2, canvas.top + (canvas.height - height_px) // 2)
