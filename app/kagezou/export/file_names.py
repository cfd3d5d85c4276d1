"""How the files of an export are called: a pattern of words, where their numbers begin, and how long these are."""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from string import Formatter
from typing import Final

from kagezou.document.model import Document
from kagezou.errors import UsageProblem
from kagezou.export.names import MIN_DIGITS, digits_for, safe_names
from kagezou.message import Message

USUAL: Final = "{layer}_{kind}/{layer}_{kind}_{frame}"
"""A folder for each sequence."""
MAX_FIRST: Final = 999_999
"""The largest number of a first file."""
MAX_DIGITS: Final = 12

_FRAME: Final = "frame"
_WORDS: Final = ("layer", "kind", "name", "scene", "cut")
_KNOWN: Final = ", ".join(f"{{{word}}}" for word in (*_WORDS, _FRAME))
_JOINTS: Final = "_. -"
"""Signs between two words, of which one goes where a word is empty."""
_MARK: Final = "\0"
"""Stands for the number in a name; no pattern has it."""
_LONG: Final = 60
_FORBIDDEN: Final = frozenset('<>:"|?*')
_SPEC: Final = re.compile(r"0?([1-9]\d?)d?")
_FAMILIAR: Final = re.compile(r"#+|%0?([1-9]\d?)?d")
"""A frame's number as other programs write it: ``####`` and ``%04d``."""


@dataclass(frozen=True, slots=True)
class Label:
    """What a sequence is called: the name of whose it is, which may be empty, and what it shows."""

    layer: str
    kind: str

    @property
    def text(self) -> str:
        """Both in one."""
        return f"{self.layer}_{self.kind}" if self.layer else self.kind


@dataclass(frozen=True, slots=True)
class NumberedName:
    """The path of each file of a sequence.

    Parameters
    ----------
    folder
        Where they lie.
    before, after
        What stands around the number; the suffix is part of ``after``.
    digits
        How many the number of each has.
    first
        The number of the first frame of the cut.
    """

    folder: Path
    before: str
    after: str
    digits: int = MIN_DIGITS
    first: int = 1

    def file(self, frame: int) -> Path:
        """Return the path for a frame, counted from 1."""
        return self.folder / f"{self.before}{frame + self.first - 1:0{self.digits}d}{self.after}"


@dataclass(frozen=True, slots=True)
class FileNames:
    """How files are called.

    Parameters
    ----------
    pattern
        Folders and the name of a file, without suffix: words in braces and what stands between them. ``{layer}`` is
        whose the picture is, ``{kind}`` what it shows, ``{name}``, ``{scene}`` and ``{cut}`` are those of the cut, and
        ``{frame}`` is the number, once, in the file's name; ``{frame:04d}``, ``####`` and ``%04d`` say its digits.
        An empty word between signs that join takes one of them along.
    first
        The number of the first frame of the cut; None for the one that the cut shows.
    digits
        How many digits a number has at least, instead of what the pattern says; None for what it says, else 4.
        All of a cut have as many as the largest needs.

    Raises
    ------
    UsageProblem
        It cannot name files.
    """

    pattern: str = USUAL
    first: int | None = None
    digits: int | None = None
    _parts: tuple[str, ...] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        if self.first is not None and not 0 <= self.first <= MAX_FIRST:
            raise UsageProblem(
                Message("files are numbered from 0 to {most}, not from {first}", most=MAX_FIRST, first=self.first)
            )
        if self.digits is not None and not 1 <= self.digits <= MAX_DIGITS:
            raise UsageProblem(
                Message("a number has 1 to {most} digits, not {digits}", most=MAX_DIGITS, digits=self.digits)
            )
        # Only where it is a pattern can files be named; so it is looked at once, here.
        object.__setattr__(self, "_parts", _checked(self.pattern))
        if self.digits is not None and _told_digits(self.pattern) is not None:
            raise UsageProblem(
                Message("file names {pattern!r}: the digits of a number are said twice", pattern=self.pattern)
            )

    def named(self, labels: Sequence[Label], document: Document, folder: Path, suffix: str) -> tuple[NumberedName, ...]:
        """Return the names of some sequences of a cut, under a folder.

        Raises
        ------
        UsageProblem
            Two of them would have the same files.
        """
        canvas, slate = document.canvas, document.slate
        first = canvas.first_frame if self.first is None else self.first
        least = self.digits or _told_digits(self.pattern) or MIN_DIGITS
        digits = digits_for(first + canvas.length_frames - 1, least)
        of_cut = {"name": slate.name, "scene": slate.scene, "cut": slate.cut}
        safe = {word: safe_names([text])[text] if text else "" for word, text in of_cut.items()}
        found = []
        for label in labels:
            words = {**safe, "layer": label.layer, "kind": label.kind}
            *folders, name = (_filled(part, words) for part in self._parts)
            inside = folder.joinpath(*(_allowed(each) for each in folders if each))
            before, after = _allowed(name).split(_MARK)
            found.append(NumberedName(inside, before, after + suffix, digits, first))
        self._check_apart(labels, found)
        return tuple(found)

    def _check_apart(self, labels: Sequence[Label], found: Sequence[NumberedName]) -> None:
        """Refuse a pattern that gives two sequences the same files, also for file systems that mind no case."""
        taken: dict[str, Label] = {}
        for label, name in zip(labels, found, strict=True):
            same = taken.setdefault(str(name.file(1)).casefold(), label)
            if same is not label:
                raise UsageProblem(
                    Message(
                        "file names {pattern!r}: {one} and {other} would have the same files; {{layer}} and {{kind}} "
                        "tell them apart",
                        pattern=self.pattern,
                        one=same.text,
                        other=label.text,
                    )
                )


def _checked(pattern: str) -> tuple[str, ...]:
    """Return the folders and the name of a pattern, the number in the same form everywhere."""
    parts = tuple(part.strip() for part in re.split(r"[/\\]", pattern))
    problem = _problem(pattern, parts)
    if problem is not None:
        raise UsageProblem(problem)
    return (*parts[:-1], "".join(_with_mark(parts[-1])))


def _problem(pattern: str, parts: Sequence[str]) -> Message | None:
    """Return why a pattern cannot name files, or None."""
    if not pattern.isprintable() or any(_FORBIDDEN & set(_between(part)) or part.strip(". ") == "" for part in parts):
        return Message("file names {pattern!r}: this is no place under the output folder", pattern=pattern)
    try:
        words = [word for part in parts for _, word, _, _ in Formatter().parse(part) if word is not None]
        digits = _told_digits(pattern)
    except ValueError:
        return Message("file names {pattern!r}: a brace has no partner", pattern=pattern)
    wrong = next((word for word in words if word not in (*_WORDS, _FRAME)), None)
    if wrong is not None:
        return Message(
            "file names {pattern!r}: there is no word {word!r}, only {known}",
            pattern=pattern,
            word=f"{{{wrong}}}",
            known=_KNOWN,
        )
    if digits is not None and digits > MAX_DIGITS:
        return Message("a number has 1 to {most} digits, not {digits}", most=MAX_DIGITS, digits=digits)
    if sum(_numbers_in(part) for part in parts) != 1 or not _numbers_in(parts[-1]):
        return Message("file names {pattern!r}: the name of the file needs {{frame}} once", pattern=pattern)
    return None


def _between(part: str) -> str:
    """Return what of a part stands outside braces."""
    return re.sub(r"\{[^{}]*\}", "", part)


def _numbers_in(part: str) -> int:
    """Return how many numbers a part of a pattern has, however written."""
    return sum(word == _FRAME for _, word, _, _ in Formatter().parse(part)) + len(_FAMILIAR.findall(_between(part)))


def _told_digits(pattern: str) -> int | None:
    """Return the digits that a pattern says; ValueError if its braces cannot be read."""
    if "{{" in pattern or "}}" in pattern:
        raise ValueError(pattern)
    for _, word, spec, change in Formatter().parse(pattern):
        if change or (spec and word != _FRAME):
            raise ValueError(pattern)
        if spec:
            found = _SPEC.fullmatch(spec)
            if found is None:
                raise ValueError(pattern)
            return int(found[1])
    mark = _FAMILIAR.search(_between(pattern))
    if mark is None:
        return None
    return len(mark[0]) if mark[0].startswith("#") else int(mark[1] or 1)


def _with_mark(name: str) -> Iterator[str]:
    """Yield a name in which a sign that no text has stands for the number."""
    for text, word, _, _ in Formatter().parse(name):
        yield _FAMILIAR.sub(_MARK, text)
        if word is not None:
            yield _MARK if word == _FRAME else f"{{{word}}}"


def _filled(part: str, words: Mapping[str, str]) -> str:
    """Return a part with its words; an empty one between signs that join takes one of them along."""
    for word in (each for each in _WORDS if not words[each]):
        mark = re.escape(f"{{{word}}}")
        part = re.sub(rf"[{_JOINTS}]{mark}(?=[{_JOINTS}]|$)|^{mark}[{_JOINTS}]?|{mark}", "", part)
    return re.sub(r"\{(\w+)\}", lambda found: words[found[1]], part)


def _allowed(name: str) -> str:
    """Return a name as every file system takes it; words that fill it are so already, and may be long."""
    digit = "0"
    filled = name.replace(_MARK, digit)
    return name if safe_names([filled])[filled] in (filled, filled[:-1]) or len(filled) > _LONG else f"_{name}"
