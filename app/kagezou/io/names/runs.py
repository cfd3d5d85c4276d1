"""Names that lie together as runs: which belong to one sequence, in which order, and which of them count."""

from collections import Counter, defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Final

from kagezou.io.names.columns import default_column, running
from kagezou.io.names.joining import Draft, drafts_of
from kagezou.io.names.marks import MarkKind, NameParts, are_dates, bracketed, half_width, has_left_side, key, parts_of
from kagezou.io.names.members import Member, member_of
from kagezou.io.names.titles import titles_of
from kagezou.message import Message, first_names

_MAX_CHARACTERS: Final = 1000
_Pair = tuple[Member, Member]


@dataclass(frozen=True, slots=True)
class Place:
    """One drawing of a run: which of the names it is, its number, and the letters of an inserted drawing."""

    index: int
    number: int
    insert: str


@dataclass(frozen=True, slots=True)
class Run:
    """Names that are one sequence.

    Parameters
    ----------
    name
        What stands before the numbers, empty where there is nothing.
    places
        One a drawing, in the order of the numbers.
    replaced
        Older retakes and versions, each with the drawing that counts instead.
    twice
        Copies, references and others that have a number again, each with the drawing that counts.
    outdated
        Names of older versions of the whole run.
    left_out, doubts
        What does not count and what had to be guessed, as sentences.
    """

    name: str
    places: tuple[Place, ...]
    replaced: tuple[tuple[int, int], ...] = ()
    twice: tuple[tuple[int, int], ...] = ()
    outdated: tuple[int, ...] = ()
    left_out: tuple[Message, ...] = ()
    doubts: tuple[Message, ...] = ()

    @property
    def notes(self) -> tuple[Message, ...]:
        """Everything that is to be said."""
        return (*self.left_out, *self.doubts)


@dataclass(frozen=True, slots=True)
class Runs:
    """All runs, and the names that have no number, by their indices."""

    runs: tuple[Run, ...]
    unnumbered: tuple[int, ...]


def runs_of(names: Sequence[str], formats: Sequence[str] = (), shown: Sequence[str] = ()) -> Runs:
    """Return which of names that lie together are sequences.

    The order of the names says nothing.

    Parameters
    ----------
    names
        As they are written; those of files without suffix.
    formats
        The suffix of each, where they are files; of two with one number that of the more usual suffix counts.
    shown
        What sentences call each, unless it is its name.
    """
    written = [half_width(name[:_MAX_CHARACTERS]).strip() for name in names]
    parts = _parts(written)
    numbered = {index: each for index, each in enumerate(parts) if each.numbers}
    columns = running(numbered)
    heads: dict[str, list[Member]] = defaultdict(list)
    for index in sorted(numbered, key=lambda each: (written[each], names[each], formats[each:][:1], shown[each:][:1])):
        column, free, is_guessed = columns[index]
        member = member_of(index, numbered[index], column, free, is_guessed=is_guessed)
        heads[member.head_key].append(member)
    drafts = _joined_singles([draft for head in sorted(heads) for draft in drafts_of(heads[head])])
    runs = [draft for draft in drafts if not _is_still(draft)]
    sorter = _Sorter(shown or names, formats)
    unnumbered = [index for index, each in enumerate(parts) if not each.numbers]
    unnumbered += [draft.members[0].index for draft in drafts if _is_still(draft)]
    named = zip(titles_of(runs, names), runs, strict=True)
    return Runs(tuple(sorter.run(title, draft) for title, draft in named), tuple(sorted(unnumbered)))


def number_in(name: str) -> tuple[int, str] | None:
    """Return the number of one name by itself and the letters behind it, in lower case; None where it has none."""
    parts = parts_of(half_width(name[:_MAX_CHARACTERS]).strip())
    if not parts.numbers:
        return None
    column = default_column(parts)
    return parts.numbers[column].value, parts.insert(column).casefold()


def is_numbered_by(tail: str) -> bool:
    """Return whether what follows a name's beginning is a number, perhaps with an insert's letters and marks, alone."""
    parts = parts_of(half_width(tail))
    if len(parts.numbers) != 1:
        return False
    number = parts.numbers[0]
    behind = number.end + len(parts.insert(0))
    return not key(parts.without_marks(0, number.start) + parts.without_marks(behind, len(parts.text)))


def ends_numbered(name: str) -> bool:
    """Return whether a name ends with its number, marks and an insert's letters aside, and is no copy's."""
    parts = parts_of(half_width(name[:_MAX_CHARACTERS]).strip())
    if not parts.numbers or parts.copy:
        return False
    return not key(parts.without_marks(parts.numbers[-1].end + len(parts.insert(-1)), len(parts.text)))


def _is_still(draft: Draft) -> bool:
    """Whether all that a single name has for a number is its version, date or size."""
    return len(draft.members) == 1 and draft.members[0].stands_in is not None


def _parts(written: Sequence[str]) -> list[NameParts]:
    """Return the parts of names; a number in brackets behind another is a copy's, unless it is what runs."""
    there = set(written)
    behind: Counter[str] = Counter(found[0] for text in written if (found := bracketed(text)))
    parts_in = partial(parts_of, has_sides=any(map(has_left_side, written)), has_dates=are_dates(written))
    made = []
    for text in written:
        found = bracketed(text)
        base = parts_in(found[0], found[1]) if found else None
        is_copy = found is not None and (found[0] in there or (behind[found[0]] == 1 < len(behind)))
        made.append(base if base is not None and base.numbers and is_copy else parts_in(text))
    return made


def _joined_singles(drafts: list[Draft]) -> list[Draft]:
    """Return drafts; three and more of one drawing each that begin with one word and share no number are one."""
    words: dict[str, list[Draft]] = defaultdict(list)
    for draft in drafts:
        word, _, more = draft.members[0].head_key.partition(" ")
        if len(draft.members) == 1 and more:
            words[word].append(draft)
    for singles in words.values():
        numbers = {draft.members[0].number for draft in singles}
        if len(numbers) == len(singles) > 2:
            first, *others = singles
            for draft in others:
                first.add(draft.members)
            drafts = [draft for draft in drafts if draft not in others]
    return drafts


@dataclass(frozen=True, slots=True)
class _Sorter:
    """Makes runs of drafts; knows what sentences call the names, and the suffixes of files."""

    shown: Sequence[str]
    formats: Sequence[str]

    def run(self, title: str, draft: Draft) -> Run:
        best, replaced = self._sorted_out(draft)
        pairs = [(worse, best[worse.place]) for worse in (*replaced, *draft.aside)]
        newer = [pair for pair in pairs if _age(pair[0]) != _age(pair[1])]
        twice = [pair for pair in pairs if _age(pair[0]) == _age(pair[1])]
        return Run(
            title,
            tuple(Place(each.index, each.number, each.insert) for _, each in sorted(best.items())),
            _indices(newer),
            _indices(twice),
            tuple(member.index for member in draft.outdated),
            tuple(self._left_out(draft, newer, twice)),
            tuple(self._doubts(draft)),
        )

    def _sorted_out(self, draft: Draft) -> tuple[dict[tuple[int, str], Member], list[Member]]:
        """Return the drawing that counts at each place, and those that do not."""
        formats = Counter(self._format(member) for member in draft.members)
        figures = Counter(member.figures for member in draft.members)
        best: dict[tuple[int, str], Member] = {}

        def merit(member: Member) -> tuple[object, ...]:
            return (member.front, member.stamp, -member.copy, formats[self._format(member)], figures[member.figures])

        for member in (ordered := sorted(draft.members, key=merit, reverse=True)):
            best.setdefault(member.place, member)
        return best, [member for member in ordered if best[member.place] is not member]

    def _left_out(self, draft: Draft, newer: Sequence[_Pair], twice: Sequence[_Pair]) -> list[Message]:
        notes = []
        if newer:
            notes.append(Message("the newest retake counts: {names}", names=self._instead(newer)))
        if twice:
            notes.append(Message("of two with one number only one counts: {names}", names=self._instead(twice)))
        if draft.outdated:
            left = first_names([self._written(member) for member in draft.outdated])
            count = len(draft.outdated)
            notes.append(
                Message(
                    "the newest version counts; older drawings left out: {count} ({names})", count=count, names=left
                )
            )
        return notes

    def _doubts(self, draft: Draft) -> list[Message]:
        members = sorted(draft.members, key=lambda member: member.place)
        first, last = self._written(members[0]), self._written(members[-1])
        notes = []
        if any(member.is_guessed for member in members):
            number = members[0].number
            notes.append(
                Message(
                    "several numbers run; the drawing's is taken to be {number} in {first}", number=number, first=first
                )
            )
        elif members[0].stands_in is MarkKind.VERSION and members[0].head_key:
            notes.append(Message("what looks like a version is taken as the drawing's number: {first}", first=first))
        if below := [member for member in members if member.number < 0]:
            first_below = self._written(below[0])
            notes.append(Message("a dash before a number is taken as a minus: {first}", first=first_below))
        if len(draft.tails) > 1 or len({member.head_key for member in members}) > 1:
            notes.append(
                Message("one sequence, although the words in its names differ: {first}, {last}", first=first, last=last)
            )
        return notes

    def _instead(self, pairs: Sequence[_Pair]) -> str:
        return first_names([f"{self._written(worse)} → {self._written(better)}" for worse, better in pairs])

    def _written(self, member: Member) -> str:
        return self.shown[member.index]

    def _format(self, member: Member) -> str:
        return self.formats[member.index] if self.formats else ""


def _indices(pairs: Sequence[_Pair]) -> tuple[tuple[int, int], ...]:
    return tuple((worse.index, better.index) for worse, better in pairs)


def _age(member: Member) -> tuple[object, object]:
    return member.front, member.stamp
