"""Which of several numbers runs through names that are built alike."""

import re
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from typing import Final

from kagezou.io.names.marks import NameParts, key

# A number behind such a word says where a drawing belongs, not which it is.
_PLACE: Final = re.compile(
    r"(?:^|[^\w]|_)(?:c|s|sc|cut|scene|shot|sq|seq|ep|part|take|layer|cam|カット|シーン|話)[ _.\-]?$", re.IGNORECASE
)
_WIDE: Final = 3
_LOOKED_AT: Final = 20


def shape_of(parts: NameParts) -> tuple[str, ...]:
    """Return what names that are built alike share: the words between their numbers."""
    edges = [0]
    for at, number in enumerate(parts.numbers):
        edges += [number.start, number.end + len(parts.insert(at))]
    edges.append(len(parts.text))
    return tuple(key(parts.without_marks(left, right)) for left, right in zip(edges[::2], edges[1::2], strict=True))


def head_key(parts: NameParts, column: int, free: Iterable[int] = ()) -> str:
    """Return what stands before one of a name's numbers, without the numbers in the columns that are free."""
    ignored = tuple(parts.numbers[each] for each in free)
    return key(parts.without_marks(0, parts.numbers[column].start, ignored))


def running(names: Mapping[int, NameParts]) -> dict[int, tuple[int, tuple[int, ...], bool]]:
    """Return of each name which of its numbers runs, which others run along with it, and whether that is a guess.

    Parameters
    ----------
    names
        Names that have numbers, by any keys.
    """
    shapes: dict[tuple[str, ...], list[int]] = defaultdict(list)
    for index, parts in names.items():
        shapes[shape_of(parts)].append(index)
    followers = _followers(names)
    chosen: dict[int, tuple[int, tuple[int, ...], bool]] = {}
    for indices in shapes.values():
        rows = sorted({tuple(number.value for number in names[index].numbers) for index in indices})
        varying = [at for at in range(len(rows[0])) if len({row[at] for row in rows}) > 1]
        if varying:
            found = _of_several(rows, varying, [names[index] for index in indices[:_LOOKED_AT]], followers)
            chosen.update(dict.fromkeys(indices, found))
        else:
            for index in indices:
                chosen[index] = (_of_one(names[index], followers), (), False)
    return chosen


def default_column(parts: NameParts) -> int:
    """Return which number of a name is its drawing's where no other name tells: the last that names no place."""
    plain = [at for at in range(len(parts.numbers)) if not _is_place(parts, at)]
    return (plain or [len(parts.numbers) - 1])[-1]


def _of_several(
    rows: Sequence[tuple[int, ...]],
    varying: Sequence[int],
    samples: Sequence[NameParts],
    followers: Mapping[str, int],
) -> tuple[int, tuple[int, ...], bool]:
    """Return the column of equally built names that runs, from the numbers that each has once."""
    if len(varying) == 1:
        return varying[0], (), False
    alone = [at for at in varying if len({row[at] for row in rows}) == len(rows)]
    candidates = [at for at in alone or varying if not _is_place(samples[0], at)] or alone or varying

    def merit(at: int) -> tuple[int, int, bool, int]:
        # Padded numbers are counted by; times and sizes of files lie far apart.
        behind = sum(followers[head_key(sample, at)] for sample in samples)
        return behind, -_span(rows, at) if alone else 0, _is_wide(samples[0], at), at

    best = max(candidates, key=merit)
    return best, tuple(at for at in alone if at != best), len(candidates) > 1


def _span(rows: Sequence[tuple[int, ...]], at: int) -> int:
    values = [row[at] for row in rows]
    return max(values) - min(values)


def _is_wide(parts: NameParts, at: int) -> bool:
    number = parts.numbers[at]
    return number.end - number.start >= _WIDE


def _is_place(parts: NameParts, at: int) -> bool:
    return _PLACE.search(parts.text[: parts.numbers[at].start]) is not None


def _followers(names: Mapping[int, NameParts]) -> Mapping[str, int]:
    """Return how many different numbers stand behind each beginning of names."""
    found: dict[str, set[int]] = defaultdict(set)
    for parts in names.values():
        for at, number in enumerate(parts.numbers):
            found[head_key(parts, at)].add(number.value)
    return {head: len(values) for head, values in found.items()}


def _of_one(parts: NameParts, followers: Mapping[str, int]) -> int:
    """Return the column of a name that is built like no other: that whose beginning most others share."""
    usual = default_column(parts)
    return max(range(len(parts.numbers)), key=lambda at: (followers[head_key(parts, at)], at == usual, at))
