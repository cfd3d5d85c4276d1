"""Numbered drawings found in folders: which files make one sequence, in which order, and which numbers are missing."""

import itertools
import os
import re
import unicodedata
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from kagezou.errors import InputProblem
from kagezou.io.files.faults import input_problem, shown
from kagezou.io.pixels.signatures import is_picture
from kagezou.message import Message

# At most six digits, so that a date is not a number, then the letters of an inserted drawing or a retake.
_NUMBERED: Final = re.compile(r"(?P<prefix>.*?)(?<![0-9])(?P<number>[0-9]{1,6})(?P<suffix>[A-Za-z]{0,2})", re.DOTALL)
_PATTERN: Final = re.compile(r"(?P<prefix>[^#]*)#+(?P<rest>[^#]*)", re.DOTALL)
_LAST_WORD: Final = re.compile(r"(?P<rest>.*[^_\-. ])[_\-. ]+[^_\-. ]+", re.DOTALL)
_LETTERS: Final = "*"
_BETWEEN: Final = "_-. "
_DIGITS: Final = re.compile(r"([0-9]+)")


@dataclass(frozen=True)
class NumberedFile:
    """One drawing: the number in its name (None for a still), the letters after it, and the file."""

    number: int | None
    suffix: str
    path: Path


@dataclass(frozen=True)
class Sequence:
    """Drawings that belong together, in natural order."""

    name: str
    files: tuple[NumberedFile, ...]

    @property
    def gaps(self) -> tuple[int, ...]:
        """The numbers between the first and the last that no file has, upward."""
        numbers = {file.number for file in self.files if file.number is not None}
        if not numbers:
            return ()
        return tuple(number for number in range(min(numbers), max(numbers)) if number not in numbers)


@dataclass(frozen=True)
class Found:
    """What a source holds: its sequences by name in natural order, and pictures that belong to none of them.

    ``notes`` say which readings of names are doubtful, without the source's name.
    """

    sequences: tuple[Sequence, ...]
    left_out: tuple[Path, ...]
    notes: tuple[Message, ...] = ()


def find_sequences(source: Path) -> Found:
    """Return the sequences that ``source`` means.

    Parameters
    ----------
    source
        A folder of numbered pictures; a folder whose sub-folders hold them, each named after its folder where it is
        the only one in it; one picture, a still; or a pattern ``FOLDER/walk_#.png`` whose run of ``#`` stands for the
        number, ``walk_#*.png`` with the letters of inserted drawings and retakes. Un-numbered pictures count only where
        nothing is numbered: as stills, or, where only the last word of their names differs (``girl smile``,
        ``girl cry``), as drawings of one character.

    Raises
    ------
    InputProblem
        There is no such thing, no picture in it, or two files have one number.
    """
    try:
        if source.is_dir():
            return _in_folder(source)
        if source.exists():
            return _still(source)
        if "#" in source.name:
            return _by_pattern(source)
    except OSError as error:
        raise input_problem(source, error) from error
    raise input_problem(source, Message("it does not exist"))


def natural_key(text: str) -> tuple[tuple[int, int, str], ...]:
    """Return a sort key by which ``A2`` comes before ``A10``; it does not mind case, and ties go by the text itself."""
    parts = _DIGITS.split(unicodedata.normalize("NFC", text).casefold())
    key = [(0, int(part), "") if index % 2 else (1, 0, part) for index, part in enumerate(parts)]
    return (*key, (2, 0, text))


def _still(path: Path) -> Found:
    if not path.is_file():
        raise input_problem(path, Message("it is neither a file nor a folder"))
    if not is_picture(path):
        raise input_problem(
            path, Message("'{path_suffix}' is not a picture format that can be read", path_suffix=path.suffix)
        )
    return Found((_one(path),), ())


def _one(path: Path) -> Sequence:
    return Sequence(path.stem, (NumberedFile(None, "", path),))


def _in_folder(folder: Path) -> Found:
    pictures, folders = _listed(folder)
    sequences, loose = _grouped(pictures, folder)
    if sequences:
        return Found(sequences, loose)
    below: list[Sequence] = []
    for child in folders:
        inside, left = _grouped(_listed(child)[0], child)
        below += [Sequence(child.name, inside[0].files)] if len(inside) == 1 else inside
        loose += left
    if below:
        return Found(_sorted(below), loose)
    if not loose:
        raise input_problem(folder, Message("there is no picture in this folder"))
    return Found(_stills(loose), ())


def _stills(pictures: Iterable[Path]) -> tuple[Sequence, ...]:
    """Return un-numbered pictures as stills; those alike but for their last word are drawings of one character."""
    groups: dict[str, list[Path]] = {}
    for path in pictures:
        parts = _LAST_WORD.fullmatch(path.stem)
        groups.setdefault(parts["rest"] if parts else path.stem, []).append(path)
    return _sorted(
        _one(paths[0]) if len(paths) == 1 else Sequence(name, tuple(NumberedFile(None, "", path) for path in paths))
        for name, paths in groups.items()
    )


def _by_pattern(pattern: Path) -> Found:
    parts = _PATTERN.fullmatch(pattern.name)
    if parts is None:
        raise input_problem(pattern, Message("one run of '#' is needed where the number stands"))
    if not is_picture(pattern):
        raise input_problem(
            pattern,
            Message("'{pattern_suffix}' is not a picture format that can be read", pattern_suffix=pattern.suffix),
        )
    if not pattern.parent.is_dir():
        raise input_problem(pattern, Message("its folder does not exist"))
    rest = parts["rest"].removesuffix(pattern.suffix)
    behind = "[A-Za-z]{0,2}" if rest == _LETTERS else re.escape(rest)
    number = re.compile(re.escape(parts["prefix"]) + f"([0-9]{{1,6}})({behind})")
    files = []
    for path in _listed(pattern.parent)[0]:
        match = number.fullmatch(path.stem)
        if match and path.suffix.lower() == pattern.suffix.lower():
            files.append(NumberedFile(int(match[1]), match[2] if match[2].isalpha() else "", path))
    if not files:
        raise input_problem(pattern, Message("no file has such a name"))
    return Found((_sequence(parts["prefix"], pattern.parent, files),), ())


def _listed(folder: Path) -> tuple[list[Path], list[Path]]:
    """Return the pictures and the folders in ``folder``, in natural order, without hidden ones."""
    with os.scandir(folder) as entries:
        kept = [(Path(entry.path), entry.is_dir(), entry.is_file()) for entry in entries if entry.name[:1] != "."]
    kept.sort(key=lambda item: natural_key(item[0].name))
    pictures = [path for path, _, is_file in kept if is_file and is_picture(path)]
    return pictures, [path for path, is_folder, _ in kept if is_folder]


def _grouped(pictures: Iterable[Path], folder: Path) -> tuple[tuple[Sequence, ...], tuple[Path, ...]]:
    """Return the sequences among ``pictures``, which lie in ``folder``, and those that have no number."""
    groups: dict[tuple[str, str], tuple[str, list[NumberedFile]]] = {}
    loose = []
    for path in pictures:
        match = _NUMBERED.fullmatch(path.stem)
        if match is None:
            loose.append(path)
            continue
        key = unicodedata.normalize("NFC", match["prefix"]), path.suffix.lower()
        group = groups.setdefault(key, (match["prefix"], []))
        group[1].append(NumberedFile(int(match["number"]), match["suffix"], path))
    return _sorted(_sequence(prefix, folder, files) for prefix, files in _joined(groups)), tuple(loose)


def _joined(
    groups: Mapping[tuple[str, str], tuple[str, list[NumberedFile]]],
) -> Iterable[tuple[str, list[NumberedFile]]]:
    """Return the groups, one of those whose names differ in case and separators alone and that share no number."""
    joined: dict[tuple[str, str], tuple[str, list[NumberedFile]]] = {}
    for (prefix, suffix), (name, files) in groups.items():
        key = prefix.rstrip(_BETWEEN).casefold(), suffix
        taken = {(file.number, file.suffix) for file in joined[key][1]} if key in joined else set()
        if any((file.number, file.suffix) in taken for file in files):
            key = prefix, suffix
        joined.setdefault(key, (name, []))[1].extend(files)
    return joined.values()


def _sequence(prefix: str, folder: Path, files: list[NumberedFile]) -> Sequence:
    ordered = sorted(files, key=lambda file: (file.number or 0, file.suffix.lower(), file.suffix, file.path.name))
    for file, following in itertools.pairwise(ordered):
        if (file.number, file.suffix) == (following.number, following.suffix):
            raise InputProblem(
                Message("{path}: {path_2} has the same number", path=shown(file.path), path_2=shown(following.path))
            )
    return Sequence(prefix.rstrip(_BETWEEN) or folder.resolve().name, tuple(ordered))


def _sorted(sequences: Iterable[Sequence]) -> tuple[Sequence, ...]:
    return tuple(sorted(sequences, key=lambda sequence: natural_key(sequence.name)))
