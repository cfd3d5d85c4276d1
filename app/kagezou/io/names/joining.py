"""Drawings whose names begin alike as sequences: what is one in spite of its spelling, and what is not."""

from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace

from kagezou.io.names.marks import key
from kagezou.io.names.members import NO_STAMP, Member


@dataclass(slots=True)
class Draft:
    """A sequence while it is being put together.

    Parameters
    ----------
    members
        Its drawings, with those of one place that will not count.
    aside
        What has the number of one of them but another word behind it.
    outdated
        Drawings of older versions of the whole sequence.
    places, originals, tails
        Of the members: numbers with their inserts, those of originals with how new they are, the words behind them.
    """

    members: list[Member] = field(default_factory=list)
    aside: list[Member] = field(default_factory=list)
    outdated: list[Member] = field(default_factory=list)
    places: set[tuple[int, str]] = field(default_factory=set)
    originals: set[tuple[object, ...]] = field(default_factory=set)
    tails: set[str] = field(default_factory=set)

    def add(self, group: Sequence[Member]) -> None:
        """Take drawings in."""
        self.members += group
        self.places |= {member.place for member in group}
        self.originals |= {_original(member) for member in group if not member.copy}
        self.tails |= {member.tail_key for member in group}


def drafts_of(members: Iterable[Member]) -> list[Draft]:
    """Return drawings whose names begin alike as sequences.

    Different spellings and different words behind the numbers are one sequence unless they claim the same numbers.
    """
    groups: dict[tuple[str, str], list[Member]] = defaultdict(list)
    for member in _called_by_letters(list(members)):
        groups[member.tail_key, member.head].append(member)
    drafts: list[Draft] = []
    for group in sorted(
        groups.values(), key=lambda each: (each[0].tail_key != "", -len(each), each[0].head, each[0].tail_key)
    ):
        if not any(_takes(draft, group) for draft in drafts):
            drafts.append(Draft())
            drafts[-1].add(group)
    for draft in drafts:
        _leave_outdated(draft)
    return drafts


def _called_by_letters(members: list[Member]) -> list[Member]:
    """Return drawings whose letters behind the numbers are names where each letter has several: ``1A 2A 1B 2B``."""
    numbers: dict[str, set[int]] = defaultdict(set)
    for member in members:
        numbers[member.insert.casefold()].add(member.number)
    if "" in numbers or len(numbers) < 2 or min(map(len, numbers.values())) < 2:
        return members
    return [
        replace(
            member, insert="", tail=f"{member.insert} {member.tail}", tail_key=key(f"{member.insert} {member.tail}")
        )
        for member in members
    ]


def _takes(draft: Draft, group: Sequence[Member]) -> bool:
    """Take a group into a draft, if it belongs there."""
    clash = _clash(draft, group)
    if (
        clash
        and _is_below(group)
        and not _clash(draft, negative := [replace(each, number=-each.number) for each in group])
    ):
        clash, group = 0, negative
    is_alike = group[0].tail_key in draft.tails
    if not is_alike and any(each.place in draft.places for each in group):
        return _takes_aside(draft, group)
    if clash and len(group) > 1:
        return False
    draft.add(group)
    return True


def _takes_aside(draft: Draft, group: Sequence[Member]) -> bool:
    """Take a few drawings with a word behind their number beside a sequence without: retakes, roughs, references."""
    is_few = 2 * len(group) <= len(draft.members) and all(member.place in draft.places for member in group)
    if draft.members[0].tail_key or not draft.members[0].head_key or not is_few:
        return False
    for member in group:
        if member.tail_key.isdigit():
            # A figure behind the number of a drawing that is there without one is its next state.
            draft.add([replace(member, tail_key="", stamp=(int(member.tail_key[:18]), *member.stamp[1:]))])
        else:
            draft.aside.append(member)
    return True


def _clash(draft: Draft, group: Sequence[Member]) -> int:
    """Return how many drawings of a group are there already, and are neither newer nor older nor copies."""
    return sum(_original(member) in draft.originals for member in group if not member.copy)


def _original(member: Member) -> tuple[object, ...]:
    return member.place, member.front, member.stamp


def _is_below(group: Sequence[Member]) -> bool:
    """Whether what was taken for a dash before the numbers may be a minus."""
    return group[0].head.endswith("-") and all(member.number >= 0 for member in group)


def _leave_outdated(draft: Draft) -> None:
    """Leave out older versions of a sequence that bring numbers of the newest one again."""
    fronts: dict[tuple[int, int, int], set[tuple[int, str]]] = defaultdict(set)
    for member in draft.members:
        fronts[member.front].add(member.place)
    newest = max(fronts, default=NO_STAMP)
    again = {front for front, places in fronts.items() if front != newest and places & fronts[newest]}
    draft.outdated = [member for member in draft.members if member.front in again]
    draft.members = [member for member in draft.members if member.front not in again]
