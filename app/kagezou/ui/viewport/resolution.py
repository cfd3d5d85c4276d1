"""At which part of its resolution the picture is drawn: as chosen, or less while a hand moves and frames come late."""

from collections import deque
from dataclasses import dataclass
from enum import StrEnum
from statistics import median

DUE_S = 0.025
"""A drawing that takes longer is late: with what the window itself needs, fewer than 25 frames a second are left."""

_LOOKED_BACK_ON = 3


class Resolution(StrEnum):
    """What one can choose."""

    AUTO = "auto"
    """Full; while something is dragged as little as keeps up with the hand."""
    FULL = "full"
    HALF = "half"
    QUARTER = "quarter"

    @property
    def divisor(self) -> int:
        """How many px across become one, at rest."""
        return {Resolution.HALF: 2, Resolution.QUARTER: 4}.get(self, 1)


@dataclass(frozen=True, slots=True)
class PreviewFineness:
    """How fine a picture is to be drawn.

    Parameters
    ----------
    divisor
        How many px across become one.
    in_haste
        Whether it has to be quick: what is not at hand yet must not be waited for.
    """

    divisor: int
    in_haste: bool = False


FULL = PreviewFineness(1)


class Pace:
    """Remembers how long the last drawings took, and says how far the resolution has to go down for the next."""

    def __init__(self) -> None:
        self.resolution = Resolution.AUTO
        self._took_s: dict[int, deque[float]] = {}

    def took(self, divisor: int, seconds: float) -> None:
        """Take note of how long a picture took to draw."""
        self._took_s.setdefault(divisor, deque(maxlen=_LOOKED_BACK_ON)).append(seconds)

    def next(self, *, moving: bool) -> PreviewFineness:
        """Return how fine the next picture is to be drawn."""
        if self.resolution is not Resolution.AUTO or not moving:
            return PreviewFineness(self.resolution.divisor)
        return PreviewFineness(next((each for each in (1, 2) if not self._is_late(each)), 4), in_haste=True)

    def forget(self) -> None:
        """Forget what was measured: another project takes other times."""
        self._took_s.clear()

    def _is_late(self, divisor: int) -> bool:
        times = self._took_s.get(divisor, ())
        # One late picture may have brought its drawings to the graphics card.
        return len(times) > 1 and median(times) > DUE_S
