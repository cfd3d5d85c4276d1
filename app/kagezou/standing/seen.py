"""What is seen of a figure's feet over time, and what follows from it."""

from dataclasses import dataclass

from kagezou.geometry.vectors import Point2
from kagezou.standing.foot import Verdict


@dataclass(frozen=True, slots=True)
class SeenFoot:
    """A foot as a frame shows it.

    Attributes
    ----------
    track
        Which foot.
    place
        Its lowest point, canvas px, y down.
    verdict
        What a person said about it; None where nobody did.
    ground_row
        The row of the ground below it while it is lifted, canvas px, where a person said so.
    """

    track: int
    place: Point2
    verdict: Verdict | None = None
    ground_row: float | None = None


@dataclass(frozen=True, slots=True)
class Seen:
    """A run of frames that show the same drawing in the same place.

    Attributes
    ----------
    frame
        The first of them.
    height_px
        The figure's height on the canvas; 0 where nothing is shown.
    feet
        Each track once.
    drawing
        Which drawing it is, where runs that follow each other may show the same one moved; None where they do not.
    """

    frame: int
    height_px: float
    feet: tuple[SeenFoot, ...]
    drawing: int | None = None

    def is_moved(self, other: "Seen") -> bool:
        """Return whether ``other`` is the same drawing in another place, with the same said about its feet."""
        mine, its = ([(foot.track, foot.verdict) for foot in each.feet] for each in (self, other))
        return self.drawing is not None and self.drawing == other.drawing and mine == its


@dataclass(frozen=True, slots=True)
class Standing:
    """A foot and the ground below it.

    Attributes
    ----------
    track
        Which foot.
    place
        Its lowest point, canvas px.
    ground_row
        The canvas row of the ground below it; its own row while it is planted.
    is_planted
        Whether it carries.
    """

    track: int
    place: Point2
    ground_row: float
    is_planted: bool


@dataclass(frozen=True, slots=True)
class Stance:
    """How a figure stands during one run of frames.

    Attributes
    ----------
    feet
        Its feet, but those of which a person said that they are none.
    lift_px
        How high it is over the ground, canvas px; more than 0 only in a jump.
    doubt
        Whether a person should look at it: what was decided was decided narrowly.
    """

    feet: tuple[Standing, ...]
    lift_px: float
    doubt: bool
