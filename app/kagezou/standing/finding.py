"""Feet in the drawings of a layer: which minima of the lower edge are feet, and which foot is which."""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from math import dist
from statistics import median

from kagezou.message import Message
from kagezou.standing.foot import Foot
from kagezou.standing.minima import Minimum, minima_of
from kagezou.standing.outline import Outline, longest_run
from kagezou.standing.steps import steps_of
from kagezou.standing.tracks import Tracks, joined, tracked, with_lifts

_BASE = 0.03  # of the height: what lies no higher over the lowest pixel rests on the ground
_BROAD = 0.4  # of the height: wider than a foot, and than two that are close together
_CUT = 0.25  # of the height: a body, not a sole, runs out of the picture
_REACH = 0.45  # of the height: a foot is lifted no higher than a hip
_BESIDE = 0.05  # of the height: what is half hidden lies so far beside the middle of what hides it
_STILL = 0.01  # of the height a drawing: a foot that is half hidden stays; what moves may be a leg that swings
_TOUCHES = 0.06  # of the height: a foot that is farther away can stand so much higher in the picture
_MOST = 4  # feet of a figure


class Footless(Enum):
    """Why a drawing has no feet; what a person is told about it."""

    EMPTY = Message("nothing is drawn")
    CUT_OFF = Message("the figure is cut off by the lower edge of the drawing")
    BROAD = Message("the figure rests on a broad base: a hem, or it sits or lies")


@dataclass(frozen=True, slots=True)
class FoundFeet:
    """What was found in one drawing.

    Attributes
    ----------
    feet
        By track; those that carry and those that are lifted.
    footless
        Why there are none; None where there are some.
    """

    feet: tuple[Foot, ...]
    footless: Footless | None


def found_feet(outlines: Sequence[Outline | None]) -> tuple[FoundFeet, ...]:
    """Return the feet of each of a layer's distinct drawings, with track numbers that go through all of them.

    A foot is a minimum of the lower edge that can be followed to where it is about as low as the lowest one: what never
    comes near the ground, such as a hand, is none. A step of the edge is a foot, too, where it stays from one drawing
    to the next, or where there is but one drawing. Where most drawings rest on a broad base none has feet; where few
    do, as a figure that crouches in a wide skirt, they have feet as the others.

    Parameters
    ----------
    outlines
        In the order in which the drawings are first shown; None where nothing is solid.
    """
    solid = [outline for outline in outlines if outline is not None]
    reasons = [_footless(outline) for outline in outlines]
    if 2 * reasons.count(Footless.BROAD) < len(solid):
        reasons = [None if reason is Footless.BROAD else reason for reason in reasons]
    else:
        reasons = [reason or Footless.BROAD for reason in reasons]
    size = median([outline.height_px for outline in solid]) if solid else 1.0
    candidates = [
        () if reason or outline is None else _candidates(outline)
        for outline, reason in zip(outlines, reasons, strict=True)
    ]
    minima = tuple(
        () if outline is None or not each else _in_reach(each, outline.height_px)
        for outline, each in zip(outlines, _without_moving_steps(candidates, size), strict=True)
    )
    tracks = with_lifts(tracked(minima, size), minima, size)
    tracks = joined(_feet_among(tracks, minima, size), minima)
    return tuple(
        FoundFeet(_feet(places, numbers), reason)
        for places, numbers, reason in zip(minima, tracks, reasons, strict=True)
    )


def _footless(outline: Outline | None) -> Footless | None:
    """Return why a drawing alone has no feet."""
    if outline is None:
        return Footless.EMPTY
    if outline.cut_px > _CUT * outline.height_px:
        return Footless.CUT_OFF
    rests = outline.lower >= outline.box.bottom - _BASE * outline.height_px
    return Footless.BROAD if longest_run(rests) > _BROAD * outline.height_px else None


def _candidates(outline: Outline) -> tuple[Minimum, ...]:
    """Return the minima of the lower edge and its steps that are none of them."""
    minima = minima_of(outline)
    beside = _BESIDE * outline.height_px
    steps = (step for step in steps_of(outline) if all(abs(step.place[0] - each.place[0]) >= beside for each in minima))
    return (*minima, *steps)


def _without_moving_steps(minima: Sequence[tuple[Minimum, ...]], size: float) -> Sequence[tuple[Minimum, ...]]:
    """Return the candidates of each drawing without the steps that are in neither the one before nor the one after."""
    if len(minima) <= 1:
        return minima
    before, after = [(), *minima[:-1]], [*minima[1:], ()]
    return [
        tuple(
            each
            for each in mine
            if not each.is_step or any(dist(each.place, other.place) <= _STILL * size for other in beside)
        )
        for mine, beside in zip(minima, ((*a, *b) for a, b in zip(before, after, strict=True)), strict=True)
    ]


def _in_reach(minima: tuple[Minimum, ...], height_px: float) -> tuple[Minimum, ...]:
    """Return the lowest of the minima, those from which a leg can come, from left to right."""
    lowest = sorted(minima, key=lambda each: (-each.place[1], each.place[0]))[:_MOST]
    high = lowest[0].place[1] - _REACH * height_px
    return tuple(sorted((each for each in lowest if each.place[1] >= high), key=lambda each: each.place))


def _feet_among(tracks: Tracks, minima: Sequence[Sequence[Minimum]], size: float) -> Tracks:
    """Return the tracks that are feet, the others as -1."""
    carrying: set[int] = set()
    for places, numbers in zip(minima, tracks, strict=True):
        lowest = max((each.place[1] for each in places), default=0.0)
        low = [
            number
            for each, number in zip(places, numbers, strict=True)
            if each.is_step or each.place[1] >= lowest - _TOUCHES * size
        ]
        carrying.update(low)
    return tuple(tuple(number if number in carrying else -1 for number in numbers) for numbers in tracks)


def _feet(places: Sequence[Minimum], numbers: Sequence[int]) -> tuple[Foot, ...]:
    feet = [Foot(number, each.place) for each, number in zip(places, numbers, strict=True) if number >= 0]
    return tuple(sorted(feet, key=lambda foot: foot.track))
