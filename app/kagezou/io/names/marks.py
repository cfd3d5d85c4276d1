"""What one name is made of: numbers, and marks with figures that are none: retakes, versions, dates, sizes, copies."""

import re
import unicodedata
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from enum import IntEnum
from itertools import pairwise
from typing import Final


class MarkKind(IntEnum):
    """Kinds of marks; where a name has no other number, that of the first kind here is taken for one."""

    VERSION = 0
    DATE = 1
    SIZE = 2
    RETAKE = 3


@dataclass(frozen=True, slots=True)
class Mark:
    """Where a mark stands in the text, half-open, and how new it says the drawing is; sizes say nothing of it."""

    start: int
    end: int
    kind: MarkKind
    value: int


@dataclass(frozen=True, slots=True)
class Number:
    """Where figures stand in the text, half-open, and what number they are, below 0 behind a minus."""

    start: int
    end: int
    value: int


@dataclass(frozen=True, slots=True)
class NameParts:
    """A name in its parts.

    Parameters
    ----------
    text
        The name in half-width letters (NFKC), without what says that it is a copy.
    numbers, marks
        From left to right; they do not overlap.
    copy
        0 for an original, else which copy it is.
    stands_in
        The kind of mark that was taken for the number, None where there is a number.
    """

    text: str
    numbers: tuple[Number, ...]
    marks: tuple[Mark, ...]
    copy: int = 0
    stands_in: MarkKind | None = None

    def insert(self, at: int) -> str:
        """Return what tells an inserted drawing right behind a number: the ``a`` of ``12a``, the ``.5`` of ``12.5``."""
        end = self.numbers[at].end
        if any(mark.start <= end < mark.end for mark in self.marks):
            return ""
        found = _INSERT.match(self.text, end)
        return found[0] if found else ""

    def without_marks(self, start: int, end: int, also: tuple[Number, ...] = ()) -> str:
        """Return a part of the text, half-open, without its marks and without some numbers."""
        known = [(mark.start, mark.end) for mark in self.marks] + [(number.start, number.end) for number in also]
        spans = sorted((left, right) for left, right in known if start <= left and right <= end)
        edges = [start, *(edge for span in spans for edge in span), end]
        return " ".join(self.text[left:right] for left, right in list(pairwise(edges))[::2])


# Longer runs of figures are no number that anybody counts by.
_FIGURES: Final = re.compile(r"(?<!\d)\d{1,18}(?!\d)")
_MOST_NUMBERS: Final = 12
"""Of more numbers in one name the last are looked at."""

_MINUS: Final = re.compile(r"(?:^|[_.(\[\-])-$")
_INSERT: Final = re.compile(r"(?:[A-Za-z]{1,2}|\.[1-9])(?![^\W_])")
_SEPARATORS: Final = re.compile(r"[\s_.\-()\[\]{}#~,]+")

_VERSION: Final = re.compile(r"(?<![^\W\d_])(?:version|ver|rev|v)[ _.\-]?(\d{1,4})(?![^\W_])", re.IGNORECASE)
_DATE: Final = re.compile(r"(?<!\d)((?:19|20)\d\d)([-_.]?)(0[1-9]|1[0-2])\2(0[1-9]|[12]\d|3[01])(?!\d)")
_EIGHT: Final = re.compile(r"(?<!\d)(?:19|20)\d{6}(?!\d)")
_FEW: Final = 2
_SIZE: Final = re.compile(
    r"(?<![^\W_])@?(?:\d{2,5} ?[x×] ?\d{2,5}|(?:360|480|540|576|720|1080|1440|2160|4320)[pi]|(?:[1-9]|1[0-6])k"
    r"|\d{2,4}[dp]pi|\d{1,5}px|(?:8|10|12|16|24|32)(?:bits?|bpc)|\d{1,3}fps|[1-9]x)(?![^\W_])",
    re.IGNORECASE,
)
_RETAKE: Final = re.compile(
    r"(?<=\d)(?P<insert>[a-z]{0,2}?)[ _.\-]*[(\[]?"
    r"(?:retake|rtk|rt|re|r|fixed|fix|final|new|リテイク|リテーク|リテ|修正|修|新)"
    r"[ _.\-]?(?P<number>\d{0,3})[)\]]?(?![^\W_])",
    re.IGNORECASE,
)
_RETAKE_IN_FRONT: Final = re.compile(
    r"^(?P<insert>)[(\[]?(?:retake|リテイク|リテーク|修正)[ _.\-]?(?P<number>\d{0,3})[)\]]?[ _.\-]+", re.IGNORECASE
)
_LEFT: Final = re.compile(r"(?<=\d)[ _.\-]*l(?![^\W_])", re.IGNORECASE)
_OLD: Final = re.compile(
    r"(?<=\d)(?P<insert>[a-z]{0,2}?)[ _.\-]+[(\[]?(?:old|original|orig|backup|bak|ng|旧|没)[)\]]?(?![^\W_])",
    re.IGNORECASE,
)
_COPY: Final = re.compile(
    r"(?:[ _\-]+copy|[ _\-]*の?コピー|[ _]-[ _](?:kopie|copie|copia|cópia|kopia|kopi|副本|복사본))"
    r"(?:[ _]?\(?(\d{1,3})\)?)?$",
    re.IGNORECASE,
)
_COPY_IN_FRONT: Final = re.compile(r"^(?:copy(?: \((\d+)\))? of|コピー ?(?:\((\d+)\) ?)?~) *", re.IGNORECASE)
_IN_BRACKETS: Final = re.compile(r"\s*\((\d{1,18})\)$")


def half_width(name: str) -> str:
    """Return a name in half-width letters and figures and composed, as it is compared."""
    return unicodedata.normalize("NFKC", name)


def key(text: str) -> str:
    """Return a text without what is no difference between names: case, width, and which separators there are."""
    return _SEPARATORS.sub(" ", unicodedata.normalize("NFKC", text.casefold())).strip()


def words_of(text: str) -> str:
    """Return the words of a text, joined by single underscores."""
    return "_".join(filter(None, _SEPARATORS.split(text)))


def bracketed(text: str) -> tuple[str, int] | None:
    """Return what stands before a number in brackets at the end, and the number: ``A (1)``."""
    found = _IN_BRACKETS.search(text)
    return (text[: found.start()], int(found[1])) if found else None


def has_left_side(text: str) -> bool:
    """Whether a name is of a left side, such as ``hand_1_L``, so that an R beside it is a right side and no retake."""
    return _LEFT.search(text) is not None


def are_dates(names: Iterable[str]) -> bool:
    """Whether figures that look like dates are dates; not where they count on, or beside such as are none."""
    figures = [found for name in names for found in _EIGHT.findall(name)]
    dates = {int(each) for each in figures if _DATE.fullmatch(each)}
    counts_on = len(dates) > _FEW and max(dates) - min(dates) < _FEW * len(dates)
    return not counts_on and all(_DATE.fullmatch(each) for each in figures)


def parts_of(name: str, copy: int = 0, *, has_sides: bool = False, has_dates: bool = True) -> NameParts:
    """Return the parts of a name; one that has no number has none in it either.

    Parameters
    ----------
    name
        In half-width letters; of a file without its suffix.
    copy
        Which copy it is known to be.
    has_sides
        Whether a mere R is no retake.
    has_dates
        Whether what looks like a date is one.
    """
    text, found = _without_copy(name)
    marks = tuple(
        mark
        for mark in _marks_in(text)
        if not (has_sides and words_of(text[mark.start : mark.end]) in ("R", "r"))
        and (has_dates or mark.kind is not MarkKind.DATE)
    )
    parts = NameParts(text, _numbers_in(text, marks), marks, copy or found)
    for kind in MarkKind:
        if parts.numbers:
            break
        kept = tuple(each for each in parts.marks if each.kind is not kind)
        if len(kept) < len(parts.marks):
            parts = replace(parts, numbers=_numbers_in(text, kept), marks=kept, stands_in=kind)
    return parts


def _without_copy(text: str) -> tuple[str, int]:
    for pattern in (_COPY, _COPY_IN_FRONT):
        found = pattern.search(text)
        if found and found.end() - found.start() < len(text):
            number = next((int(each) for each in found.groups() if each), 1)
            return text[: found.start()] + text[found.end() :], number
    return text, 0


def _marks_in(text: str) -> tuple[Mark, ...]:
    """Return the marks, of overlapping ones the first that is found."""
    marks: list[Mark] = []
    for mark in _every_mark(text):
        if all(mark.end <= each.start or each.end <= mark.start for each in marks):
            marks.append(mark)
    return tuple(sorted(marks, key=lambda mark: mark.start))


def _every_mark(text: str) -> Iterator[Mark]:
    for found in _SIZE.finditer(text):
        yield Mark(found.start(), found.end(), MarkKind.SIZE, 0)
    for found in _DATE.finditer(text):
        yield Mark(found.start(), found.end(), MarkKind.DATE, int(found[1] + found[3] + found[4]))
    for found in _VERSION.finditer(text):
        yield Mark(found.start(), found.end(), MarkKind.VERSION, int(found[1]))
    for pattern in (_RETAKE, _RETAKE_IN_FRONT):
        for found in pattern.finditer(text):
            yield Mark(found.end("insert"), found.end(), MarkKind.RETAKE, int(found["number"] or 1))
    for found in _OLD.finditer(text):
        yield Mark(found.end("insert"), found.end(), MarkKind.RETAKE, -1)


def _numbers_in(text: str, marks: tuple[Mark, ...]) -> tuple[Number, ...]:
    numbers: list[Number] = []
    for found in _FIGURES.finditer(text):
        if any(mark.start < found.end() and found.start() < mark.end for mark in marks):
            continue
        if numbers and numbers[-1].end + 1 == found.start() and _INSERT.match(text, numbers[-1].end):
            continue
        is_below = _MINUS.search(text[: found.start()])
        numbers.append(Number(found.start(), found.end(), -int(found[0]) if is_below else int(found[0])))
    return tuple(numbers[-_MOST_NUMBERS:])
