"""What stays of a person's words about feet when the drawings are others.

A pin names a foot by its number, and a new search numbers feet anew: it is put on the foot that is nearest to where its
own was. Where there is none near, a pin that says only what a foot does has nothing to be about, and goes.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import dist

from kagezou.document.model import Drawing
from kagezou.geometry.box import Box
from kagezou.geometry.vectors import Point2
from kagezou.standing.foot import Foot, FootPin, Verdict

_NEAR_OF_FIGURE = 0.1
"""A foot this near, of the figure's height, is the same foot; as tracks of feet are told apart."""
_BESIDE_OF_FIGURE = 0.05
"""A pinned place this far outside the new figure, of its height, is still on it."""


@dataclass(frozen=True, slots=True)
class PinsKept:
    """The pins of a new drawing, and how many of the old ones have nothing to be about any more."""

    pins: tuple[FootPin, ...]
    dropped: int


def kept_pins(before: Drawing, after: Drawing) -> PinsKept:
    """Return which pins of an old drawing stay on the new one, whose feet have been looked for."""
    box = after.figure or before.figure
    height = box.height if box is not None else 0
    pins: dict[int, FootPin] = {}
    dropped = 0
    for pin in before.pins:
        found = _put(pin, before, after, box, height)
        if found is None or found.track in pins:
            dropped += 1
        else:
            pins[found.track] = found
    return PinsKept(tuple(pins[track] for track in sorted(pins)), dropped)


def _put(pin: FootPin, before: Drawing, after: Drawing, box: Box | None, height: float) -> FootPin | None:
    place = pin.place or next((foot.place for foot in before.feet or () if foot.track == pin.track), None)
    if place is None or box is None or not _is_on(box, place, _BESIDE_OF_FIGURE * height):
        return None
    near = _nearest(after.feet or (), place, _NEAR_OF_FIGURE * height)
    if near is not None:
        return replace(pin, track=near.track)
    if pin.place is None or pin.verdict is Verdict.NONE:
        return None
    return replace(pin, track=_free(after, pin.track))


def _nearest(feet: Sequence[Foot], place: Point2, reach: float) -> Foot | None:
    near = [foot for foot in feet if dist(foot.place, place) <= reach]
    return min(near, key=lambda foot: dist(foot.place, place), default=None)


def _free(drawing: Drawing, track: int) -> int:
    """Return a number for a foot that was put where none is found."""
    taken = {foot.track for foot in drawing.feet or ()}
    return track if track not in taken else max(taken) + 1


def _is_on(box: Box, place: Point2, margin: float) -> bool:
    x, y = place
    return box.left - margin <= x <= box.right + margin and box.top - margin <= y <= box.bottom + margin
