"""A name as a drawing of a run: its number, what it is a drawing of, and how new it is beside others of that number."""

from dataclasses import dataclass
from typing import Final

from kagezou.io.names.columns import head_key
from kagezou.io.names.marks import Mark, MarkKind, NameParts, key

Stamp = tuple[int, int, int]
"""Retake, version and date; of two drawings of one number the greater one is newer."""

NO_STAMP: Final[Stamp] = (0, 0, 0)


@dataclass(frozen=True, slots=True)
class Member:
    """One drawing.

    Parameters
    ----------
    index
        Which of the names.
    number, insert
        Its number and the letters of an inserted drawing.
    head, tail
        What stands before and behind the number, as it is spelled, the latter without marks.
    head_key, tail_key
        What stands before and behind it, as it is compared.
    front, stamp
        How new the whole run is, by what stands before the number, and how new the drawing.
    copy
        0 for an original, else which copy it is.
    figures
        How many figures the number is written with.
    stands_in
        The kind of mark that was taken for its number, None where it has one.
    is_guessed
        Whether more than one of its numbers runs.
    """

    index: int
    number: int
    insert: str
    head: str
    tail: str
    head_key: str
    tail_key: str
    front: Stamp
    stamp: Stamp
    copy: int
    figures: int
    stands_in: MarkKind | None
    is_guessed: bool

    @property
    def place(self) -> tuple[int, str]:
        """Number and insert: two drawings of one place are one drawing twice."""
        return self.number, self.insert.casefold()


def member_of(index: int, parts: NameParts, column: int, free: tuple[int, ...], *, is_guessed: bool) -> Member:
    """Return a name as a drawing whose number stands in ``column``, the numbers in the ``free`` ones aside."""
    number = parts.numbers[column]
    insert = parts.insert(column)
    ignored = tuple(parts.numbers[at] for at in free)
    tail = parts.without_marks(number.end + len(insert), len(parts.text), ignored)
    before = [mark for mark in parts.marks if 0 < mark.start < number.start]
    behind = [mark for mark in parts.marks if mark.start == 0 or mark.start > number.start]
    return Member(
        index=index,
        number=number.value,
        insert=insert,
        head=parts.text[: number.start],
        tail=tail,
        head_key=head_key(parts, column, free),
        tail_key=key(tail),
        front=_stamp(before),
        stamp=_stamp(behind),
        copy=parts.copy,
        figures=number.end - number.start,
        stands_in=parts.stands_in,
        is_guessed=is_guessed,
    )


def _stamp(marks: list[Mark]) -> Stamp:
    newest = [0, 0, 0]
    kinds = (MarkKind.RETAKE, MarkKind.VERSION, MarkKind.DATE)
    for mark in marks:
        if mark.kind in kinds:
            newest[kinds.index(mark.kind)] = mark.value
    retake, version, date = newest
    return retake, version, date
