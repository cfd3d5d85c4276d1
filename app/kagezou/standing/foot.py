"""What is known of the feet of one drawing: what was found in the picture, and what a person said about it."""

from dataclasses import dataclass
from enum import StrEnum

from kagezou.geometry.vectors import Point2


@dataclass(frozen=True, slots=True)
class Foot:
    """A place of a drawing where the figure may carry its weight.

    Parameters
    ----------
    track
        Which foot it is: the same number in every drawing of the layer, from 0.
    place
        Its lowest point, drawing px from the top left corner, y down.
    """

    track: int
    place: Point2


class Verdict(StrEnum):
    """What a person said about a foot."""

    PLANTED = "planted"
    LIFTED = "lifted"
    NONE = "none"
    """It is no foot."""


@dataclass(frozen=True, slots=True)
class FootPin:
    """A person's word about one foot of one drawing; it wins over everything that is found.

    Parameters
    ----------
    track
        Which foot.
    verdict
        What it does; None leaves that to what is found.
    place
        Where it is, drawing px; None leaves it where it was found. A track that was not found there is a foot that a
        person put.
    ground_row
        The row of the ground below it while it is lifted, drawing px; None leaves that to its contacts.
    """

    track: int
    verdict: Verdict | None = None
    place: Point2 | None = None
    ground_row: float | None = None
