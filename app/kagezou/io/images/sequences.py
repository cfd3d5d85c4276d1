"""Numbered drawings found in folders: which files make one sequence, in which order, and which numbers are missing."""

import os
import re
import unicodedata
from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

from kagezou.io.files.faults import input_problem, shown
from kagezou.io.files.spellings import on_disk
from kagezou.io.names.marks import half_width
from kagezou.io.names.runs import Run, is_numbered_by, runs_of
from kagezou.io.names.states import states_among
from kagezou.io.pixels.signatures import is_picture
from kagezou.message import Message, first_names

_MAX_SPAN: Final = 100_000
"""Numbers that lie further apart are times or dates, not frames."""

_PATTERN: Final = re.compile(r"(?P<prefix>[^#]*)#+(?P<rest>[^#]*)", re.DOTALL)
_LAST_WORD: Final = re.compile(r"(?P<rest>.*[^_\-. ])[_\-. ]+[^_\-. ]+", re.DOTALL)
_MANY: Final = 2
_ANY: Final = "*"
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
    """Drawings that belong together, in natural order; ``notes`` say what of them is doubtful or does not count."""

    name: str
    files: tuple[NumberedFile, ...]
    notes: tuple[Message, ...] = ()

    @property
    def counts_frames(self) -> bool:
        """Whether its numbers can be frames; else they lie too far apart."""
        numbers = [file.number or 0 for file in self.files]
        return max(numbers) - min(numbers) < _MAX_SPAN

    @property
    def gaps(self) -> tuple[int, ...]:
        """The numbers between the first and the last that no file has, upward."""
        numbers = {file.number for file in self.files if file.number is not None}
        if not numbers or not self.counts_frames:
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

    Which part of a name is the number is found from all names that lie together. Of several drawings of one number,
    retakes and copies, the newest original counts; what does not is said.

    Parameters
    ----------
    source
        A folder of numbered pictures; a folder whose sub-folders hold them, each named after its folder where it is
        the only one in it; one picture, a still; or a pattern ``FOLDER/walk_#.png`` whose run of ``#`` stands for the
        number, ``walk_#*.png`` with inserted drawings and retakes. Un-numbered pictures count only where nothing is
        numbered: as stills, or, where only the last word of their names differs (``girl smile``, ``girl cry``), as
        drawings of one character.

    Raises
    ------
    InputProblem
        There is no such thing, or no picture in it.
    """
    try:
        source = on_disk(source)
        if source.is_dir():
            return _in_folder(source)
        if source.exists():
            return _still(source)
        if "#" in source.name:
            return _by_pattern(source)
    except OSError as error:
        raise input_problem(source, error) from error
    raise input_problem(source, Message("it does not exist"))


def sequences_among(pictures: Iterable[Path]) -> Found:
    """Return the sequences among pictures that were chosen, those of one folder together; un-numbered ones are stills.

    Parameters
    ----------
    pictures
        Files, all of them pictures.
    """
    folders: dict[Path, list[Path]] = {}
    for path in sorted(set(pictures), key=lambda each: natural_key(str(each))):
        folders.setdefault(path.parent, []).append(path)
    parts = [_understood(inside, folder) for folder, inside in folders.items()]
    sequences = [each for part in parts for each in (*part.sequences, *_stills(part.left_out))]
    return Found(_sorted(sequences), (), tuple(note for part in parts for note in part.notes))


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
    found = _understood(pictures, folder)
    if found.sequences:
        unseen = [child.name for child in folders if _listed(child)[0]]
        note = Message("folders beside its pictures are left out: {names}", names=first_names(unseen))
        return _with_doubts(replace(found, notes=(*found.notes, *([note] if unseen else []))))
    below = sequences_below(folders)
    loose = (*found.left_out, *below.left_out)
    if below.sequences:
        return _with_doubts(replace(below, left_out=loose))
    if not loose:
        raise input_problem(folder, Message("there is no picture in this folder"))
    return _with_doubts(Found(_stills(loose), ()))


def sequences_below(folders: Iterable[Path]) -> Found:
    """Return the sequences in folders, each named after its folder where it is the only one in it.

    Folders that hold one thing in several states, such as ``A`` and ``A_R1``, are one.
    """
    inside = [(folder, _understood(_listed(folder)[0], folder)) for folder in folders]
    below = [
        replace(each, name=folder.name) if len(part.sequences) == 1 else each
        for folder, part in inside
        for each in part.sequences
    ]
    sequences = _sorted(_newest(below))
    loose = tuple(path for _, part in inside for path in part.left_out)
    return Found(sequences, loose, tuple(note for each in sequences for note in each.notes))


def _newest(sequences: list[Sequence]) -> list[Sequence]:
    """Return sequences, those whose names are states of one thing as one: newer drawings in the place of older ones."""
    rest = dict(enumerate(sequences))
    made = []
    for states in states_among([each.name for each in sequences]):
        parts = [rest.pop(index) for index in states.indices]
        kept = parts[-1:] if states.are_versions else parts
        files = {(file.number or 0, file.suffix.casefold()): file for part in kept for file in part.files}
        old = sum(len(part.files) for part in parts) - len(files)
        names = ", ".join(part.name for part in parts)
        note = Message("taken as one, of which the newest counts: {names}; older drawings: {old}", names=names, old=old)
        own = [each for part in kept for each in part.notes]
        made.append(Sequence(kept[0].name, tuple(files[place] for place in sorted(files)), (note, *own)))
    return [*rest.values(), *made]


def _with_doubts(found: Found) -> Found:
    """Return what was found; that several characters have one drawing each is said, as they are seen together."""
    single = [sequence.name for sequence in found.sequences if len(sequence.files) == 1]
    if len(single) < _MANY:
        return found
    note = Message(
        "{count} characters have one drawing each and are seen together: {names}",
        count=len(single),
        names=first_names(single),
    )
    return Found(found.sequences, found.left_out, (*found.notes, note))


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
    folder = on_disk(pattern.parent)
    if not folder.is_dir():
        raise input_problem(pattern, Message("its folder does not exist"))
    rest = parts["rest"].removesuffix(pattern.suffix)
    same = [path for path in _listed(folder)[0] if path.suffix.lower() == pattern.suffix.lower()]
    return _matching(pattern, parts["prefix"], rest, same)


def _matching(pattern: Path, prefix: str, rest: str, pictures: list[Path]) -> Found:
    """Return the pictures that a pattern means, of those with its suffix in its folder."""
    sign = "-?" if prefix[-1:] in ("", "_", ".", "(", "-") else ""
    beginning = re.compile(re.escape(half_width(prefix)) + f"(?={sign}\\d)")
    tails = [(path, stem[start.end() :]) for path in pictures if (start := beginning.match(stem := _stem(path)))]
    literal = re.compile(r"-?\d+" + re.escape(half_width(rest)))
    meant = [
        (path, tail)
        for path, tail in tails
        if (is_numbered_by(tail) if rest == _ANY else literal.fullmatch(tail) is not None)
    ]
    if not meant:
        raise input_problem(pattern, Message("no file has such a name"))
    files = [path for path, _ in meant]
    found = runs_of([tail for _, tail in meant], [path.suffix.lower() for path in files], _shown(files))
    name = prefix.rstrip(_BETWEEN) or pattern.parent.resolve().name
    sequences = [Sequence(name, _numbered(run, files), run.notes) for run in found.runs]
    sequences = sequences or [Sequence(name, tuple(NumberedFile(None, "", path) for path in files))]
    others = [path for path, _ in tails if path not in files]
    left = Message("not meant by the pattern: {names}", names=first_names(_shown(others)))
    notes = [note for run in found.runs for note in run.notes]
    return Found(tuple(sequences), (), (*notes, *([left] if others else [])))


def _stem(path: Path) -> str:
    return half_width(path.stem)


def _listed(folder: Path) -> tuple[list[Path], list[Path]]:
    """Return the pictures and the folders in ``folder``, in natural order, without hidden ones."""
    with os.scandir(folder) as entries:
        kept = [(Path(entry.path), entry.is_dir(), entry.is_file()) for entry in entries if entry.name[:1] != "."]
    kept.sort(key=lambda item: natural_key(item[0].name))
    pictures = [path for path, _, is_file in kept if is_file and is_picture(path)]
    return pictures, [path for path, is_folder, _ in kept if is_folder]


def _understood(pictures: Iterable[Path], folder: Path) -> Found:
    """Return the sequences among pictures, which lie in ``folder``; those that have no number are left out."""
    files = list(pictures)
    found = runs_of([path.stem for path in files], [path.suffix.lower() for path in files], _shown(files))
    own = folder.resolve().name
    sequences = _sorted(Sequence(run.name or own, _numbered(run, files), run.notes) for run in found.runs)
    notes = tuple(note for run in found.runs for note in run.notes)
    return Found(sequences, tuple(files[index] for index in found.unnumbered), notes)


def _shown(files: Iterable[Path]) -> list[str]:
    return [shown(Path(path.name)) for path in files]


def _numbered(run: Run, files: list[Path]) -> tuple[NumberedFile, ...]:
    return tuple(NumberedFile(place.number, place.insert, files[place.index]) for place in run.places)


def _sorted(sequences: Iterable[Sequence]) -> tuple[Sequence, ...]:
    return tuple(sorted(sequences, key=lambda sequence: natural_key(sequence.name)))
