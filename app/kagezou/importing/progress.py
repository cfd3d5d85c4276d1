"""Who looks on while drawings are read: told how far it is, and may end it."""

from collections.abc import Callable
from enum import StrEnum
from typing import TypeAlias


class LoadPhase(StrEnum):
    """The parts of a load that take time, in their order."""

    FINDING = "finding"
    """Folders are listed."""
    OPENING = "opening"
    """The drawings' headers are read."""
    MEASURING = "measuring"
    """A few drawings are decoded, to see where the figure stands."""
    LIGHTING = "lighting"
    """A place for the lamp is sought."""
    FEET = "feet"
    """All drawings are decoded, to find the feet in them."""
    COMPARING = "comparing"
    """Old and new drawings are decoded, to see which is which."""
    READING = "reading"
    """Drawings are decoded, to be shown."""


Progress: TypeAlias = Callable[[LoadPhase, int, int], None]
"""Called again and again with the part, how much of it is done, and of how much; it may raise ``Cancelled``."""


class Cancelled(Exception):
    """The work is not wanted any more; raised by a watch and caught by whoever made the watch."""


def no_progress(_part: LoadPhase, _done: int, _whole: int) -> None:
    """Look away."""
