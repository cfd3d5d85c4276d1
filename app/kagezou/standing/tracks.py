"""Which place of one drawing is which of the next."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import chain, pairwise
from math import hypot
from typing import NamedTuple, TypeAlias

from kagezou.geometry.vectors import Point2
from kagezou.standing.minima import Minimum

Tracks: TypeAlias = tuple[tuple[int, ...], ...]
"""For each drawing a number for each of its places."""

_GATE = 0.1  # of the figure's height a drawing: a foot that moves faster can be a different one
_MOST_GATES = 2
_ASIDE = 0.05  # of the figure's height: what is lifted and set down in one place goes no farther aside in a drawing
_LONGEST_LIFT = 12  # drawings
_LIFT = 0.25  # of the figure's height: and goes up or down no farther in a drawing
_STOPS = 0.015  # of the figure's height: so much nearer must the last place be than where it was going
_MISSED = 0.02  # of the figure's height a drawing: of two that fit, the one that was seen of late


@dataclass(frozen=True, slots=True)
class _Track:
    """A place that was seen last in drawing `seen`, and how far it moved a drawing then."""

    number: int
    place: Point2
    step: Point2
    seen: int

    def away(self, place: Point2, drawing: int, stops_px: float) -> float:
        """Return how far ``place`` is from where it was going; or, if it stopped or was hidden, from where it was."""
        from_last = hypot(place[0] - self.place[0], place[1] - self.place[1])
        if drawing > self.seen + 1:
            return from_last
        ahead = hypot(place[0] - self.place[0] - self.step[0], place[1] - self.place[1] - self.step[1])
        return min(ahead, from_last + stops_px)

    def followed(self, place: Point2, drawing: int) -> "_Track":
        """Return it as seen at ``place``."""
        gone = drawing - self.seen
        step = ((place[0] - self.place[0]) / gone, (place[1] - self.place[1]) / gone)
        return _Track(self.number, place, step, drawing)


def tracked(minima: Sequence[Sequence[Minimum]], size: float) -> Tracks:
    """Return track numbers from 0 in the order of appearance, by the nearest to where each was going.

    Parameters
    ----------
    minima
        The places of each drawing.
    size
        The figure's height, px: what is near is told by it.
    """
    live: dict[int, _Track] = {}
    result: list[tuple[int, ...]] = []
    for drawing, places in enumerate(minima):
        numbers = _matched([each.place for each in places], list(live.values()), drawing, size)
        for index, each in enumerate(places):
            known = live.get(numbers.setdefault(index, len(live)))
            track = known.followed(each.place, drawing) if known else _Track(len(live), each.place, (0, 0), drawing)
            live[track.number] = track
        result.append(tuple(numbers[index] for index in range(len(places))))
    return tuple(result)


def _matched(places: Sequence[Point2], tracks: Sequence[_Track], drawing: int, size: float) -> dict[int, int]:
    """Return for places, by index, the numbers of the tracks that they go on; the nearest pairs first."""
    pairs: list[tuple[float, int, int]] = []
    for track in tracks:
        gone = drawing - track.seen
        gate = _GATE * size * min(_MOST_GATES, gone)
        for index, place in enumerate(places):
            away = track.away(place, drawing, _STOPS * size)
            if away <= gate:
                pairs.append((away + _MISSED * size * (gone - 1), track.number, index))
    numbers: dict[int, int] = {}
    for _, number, index in sorted(pairs):
        if index not in numbers and number not in numbers.values():
            numbers[index] = number
    return numbers


def with_lifts(tracks: Tracks, minima: Sequence[Sequence[Minimum]], size: float) -> Tracks:
    """Return the tracks, each with what takes its place from the drawing after it is lost to that before it comes back.

    So a foot is followed that is lifted and set down again faster than any that is near could be told from another.
    Both ends have to be seen: a hand or a knee is over a foot as well, when the foot goes away.
    """
    runs = _runs(tracks, minima)
    owner: dict[_Sight, int] = {}
    starts: dict[int, list[_Run]] = {}
    for run in chain.from_iterable(runs.values()):
        starts.setdefault(run[0].drawing, []).append(run)
    for number, mine in runs.items():
        for before, after in pairwise(mine):
            if after[0].drawing - before[-1].drawing <= _LONGEST_LIFT:
                # What leads away from a foot is younger than it, and may have gaps of its own.
                owner = dict.fromkeys(_lift(before[-1], after[0], starts, size) or (), number) | owner
    return tuple(
        tuple(
            owner.get(_Sight(drawing, each.place), number)
            for each, number in zip(minima[drawing], numbers, strict=True)
        )
        for drawing, numbers in enumerate(tracks)
    )


class _Sight(NamedTuple):
    """In which drawing a place was seen."""

    drawing: int
    place: Point2


_Run: TypeAlias = list[_Sight]
"""A track in drawings that follow one another."""


def _runs(tracks: Tracks, minima: Sequence[Sequence[Minimum]]) -> dict[int, list[_Run]]:
    """Return for each track the runs of drawings in which it is seen."""
    runs: dict[int, list[_Run]] = {}
    for drawing, (places, numbers) in enumerate(zip(minima, tracks, strict=True)):
        for each, number in zip(places, numbers, strict=True):
            known = runs.setdefault(number, [])
            if not known or known[-1][-1].drawing + 1 < drawing:
                known.append([])
            known[-1].append(_Sight(drawing, each.place))
    return runs


def _lift(before: _Sight, after: _Sight, starts: Mapping[int, Sequence[_Run]], size: float) -> _Run | None:
    """Return what leads through runs, each as a whole, from ``before`` to ``after``; None where nothing does.

    ``starts`` are the runs by their first drawings.
    """
    if _is_over(before, after, size):
        return []
    for run in starts.get(before.drawing + 1, ()):
        if run[-1].drawing < after.drawing and _is_over(before, run[0], size):
            rest = _lift(run[-1], after, starts, size)
            if rest is not None:
                return [*run, *rest]
    return None


def _is_over(before: _Sight, after: _Sight, size: float) -> bool:
    """Return whether a place of one drawing is over or below one of the drawing before."""
    aside, up = (abs(a - b) for a, b in zip(before.place, after.place, strict=True))
    return after.drawing == before.drawing + 1 and aside <= _ASIDE * size and up <= _LIFT * size


def joined(tracks: Tracks, minima: Sequence[Sequence[Minimum]]) -> Tracks:
    """Return as few tracks as feet are seen at once, numbered anew from 0; -1 stays.

    A foot that comes out from behind the other leg far from where it was lost is taken for the nearest of those that
    are lost, for good, at that time.
    """
    last = {number: drawing for drawing, numbers in enumerate(tracks) for number in numbers}
    owner: dict[int, int] = {}
    ends: list[tuple[int, Point2]] = []  # of each new number: when and where it is seen last
    for drawing, (places, numbers) in enumerate(zip(minima, tracks, strict=True)):
        for each, number in zip(places, numbers, strict=True):
            if number < 0:
                continue
            if number not in owner:
                free = [new for new, (end, _) in enumerate(ends) if end < drawing]
                owner[number] = min(free, key=lambda new: _between(ends[new][1], each.place), default=len(ends))
                ends += [(0, each.place)] * (owner[number] == len(ends))
            ends[owner[number]] = last[number], each.place
    return tuple(tuple(owner.get(number, -1) for number in numbers) for numbers in tracks)


def _between(a: Point2, b: Point2) -> float:
    return hypot(a[0] - b[0], a[1] - b[1])
