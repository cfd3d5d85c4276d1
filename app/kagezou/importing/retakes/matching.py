"""Which drawing of a retake is which one of before: by name and picture, then by likeness, then by order.

A name alone can lie: where drawings were put in between, all behind them have other numbers. So the same picture comes
first, and a name does not count where the picture of before plainly lies under another name.
"""

from collections import defaultdict
from collections.abc import Hashable, Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kagezou.importing.retakes.prints import Print, likeness

_PLAINLY: Final = 0.9
"""Drawings this alike are plainly of one pose."""
_CLEARER: Final = 0.1
"""By so much another one must be more like it, for a name not to count."""
_LIKE: Final = 0.72
"""From this likeness on a drawing under another name may be the same one, drawn again."""


class How(StrEnum):
    """By what a drawing was known again."""

    SAME = "same"
    """Name and picture are as before."""
    NAME = "name"
    """The name is; the picture is another."""
    PICTURE = "picture"
    """The picture is; its name is another."""
    LIKENESS = "likeness"
    ORDER = "order"
    """It stands in the only place left between others."""


@dataclass(frozen=True, slots=True)
class Known:
    """What a drawing is known by: what makes its name the same in another folder, and its print if it can be read."""

    name: Hashable
    print: Print | None


@dataclass(frozen=True, slots=True)
class Match:
    """An old drawing and the new one that it became, as indices."""

    before: int
    after: int
    how: How


def matched(before: Sequence[Known], after: Sequence[Known]) -> tuple[Match, ...]:
    """Return which drawings became which, each in one match at most, by the new ones' order."""
    found: list[Match] = []
    for step in (_same, _pictures, _names, _alike, _between):
        old, new = _left(found, len(before), len(after))
        found += step(before, after, old, new, found)
    return tuple(sorted(found, key=lambda match: match.after))


def _left(found: Sequence[Match], before: int, after: int) -> tuple[list[int], list[int]]:
    old, new = {match.before for match in found}, {match.after for match in found}
    return [each for each in range(before) if each not in old], [each for each in range(after) if each not in new]


def _same(
    before: Sequence[Known], after: Sequence[Known], old: list[int], new: list[int], _found: Sequence[Match]
) -> Iterator[Match]:
    places = {(after[each].name, _digest(after[each])): each for each in reversed(new)}
    for each in old:
        place = places.pop((before[each].name, _digest(before[each])), None)
        if place is not None and before[each].print is not None:
            yield Match(each, place, How.SAME)


def _pictures(
    before: Sequence[Known], after: Sequence[Known], old: list[int], new: list[int], _found: Sequence[Match]
) -> Iterator[Match]:
    """Yield the same pictures under other names; equal ones in their order."""
    places: dict[bytes, list[int]] = defaultdict(list)
    for each in new:
        if (digest := _digest(after[each])) is not None:
            places[digest].append(each)
    for each in old:
        digest = _digest(before[each])
        if digest is not None and places.get(digest):
            yield Match(each, places[digest].pop(0), How.PICTURE)


def _names(
    before: Sequence[Known], after: Sequence[Known], old: list[int], new: list[int], _found: Sequence[Match]
) -> Iterator[Match]:
    """Yield drawings of one name, unless the old picture lies under another new name, or the other way round."""
    by_name = {after[each].name: each for each in reversed(new)}
    alike = _likeness(before, after, old, new)
    for row, each in enumerate(old):
        place = by_name.get(before[each].name)
        if place is None:
            continue
        column = new.index(place)
        itself = alike[row, column]
        best = max(alike[row].max(), alike[:, column].max())
        if not (best >= _PLAINLY and itself < best - _CLEARER):
            del by_name[before[each].name]
            yield Match(each, place, How.NAME)


def _alike(
    before: Sequence[Known], after: Sequence[Known], old: list[int], new: list[int], _found: Sequence[Match]
) -> Iterator[Match]:
    """Yield the drawings that are most alike as a whole, in their order: a walk is full of drawings that are alike."""
    alike = _likeness(before, after, old, new)
    best = np.zeros((len(old) + 1, len(new) + 1))
    for row in range(len(old) - 1, -1, -1):
        for column in range(len(new) - 1, -1, -1):
            score = alike[row, column] if alike[row, column] >= _LIKE else 0.0
            paired = best[row + 1, column + 1] + score if score else 0.0
            best[row, column] = max(paired, best[row + 1, column], best[row, column + 1])
    row = column = 0
    while row < len(old) and column < len(new):
        if best[row, column] == best[row + 1, column]:
            row += 1
        elif best[row, column] == best[row, column + 1]:
            column += 1
        else:
            yield Match(old[row], new[column], How.LIKENESS)
            row, column = row + 1, column + 1


def _between(
    before: Sequence[Known], after: Sequence[Known], old: list[int], new: list[int], found: Sequence[Match]
) -> Iterator[Match]:
    """Yield those that are as many before as after between two that are known."""
    del before, after
    gaps: dict[tuple[int, int], tuple[list[int], list[int]]] = defaultdict(lambda: ([], []))
    anchors = sorted((match.before, match.after) for match in found)
    if [after_index for _, after_index in anchors] != sorted(after_index for _, after_index in anchors):
        # The drawings have changed places: what is between two of them says nothing.
        return
    for side, left in enumerate((old, new)):
        for each in left:
            number = sum(anchor[side] < each for anchor in anchors)
            gaps[number, number][side].append(each)
    for olds, news in gaps.values():
        if len(olds) == len(news):
            yield from (Match(one, other, How.ORDER) for one, other in zip(olds, news, strict=True))


def _likeness(before: Sequence[Known], after: Sequence[Known], old: list[int], new: list[int]) -> NDArray[np.float64]:
    """Return how alike the drawings are that are left, (old, new); 0 where one cannot be read."""
    found = np.zeros((len(old), len(new)))
    rows = [(row, known) for row, each in enumerate(old) if (known := before[each].print) is not None]
    columns = [(column, known) for column, each in enumerate(new) if (known := after[each].print) is not None]
    if rows and columns:
        places = np.ix_([row for row, _ in rows], [column for column, _ in columns])
        found[places] = likeness([known for _, known in rows], [known for _, known in columns])
    return found


def _digest(known: Known) -> bytes | None:
    return None if known.print is None else known.print.digest
