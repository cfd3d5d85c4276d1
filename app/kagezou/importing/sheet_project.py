"""A project of a timesheet alone: its columns find their drawings beside it, by the names that studios give them."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

from kagezou.errors import InputProblem
from kagezou.importing.new_cels import CharacterSource, printable
from kagezou.importing.progress import Progress, no_progress
from kagezou.importing.psd_characters import characters_in
from kagezou.importing.staging import Imported, new_document
from kagezou.importing.timesheet_on_document import timed
from kagezou.io.files.faults import cause_of, shown
from kagezou.io.pixels.signatures import is_picture, is_psd
from kagezou.io.project.paths import absolute
from kagezou.io.psd.file import psd_tree
from kagezou.io.sheets.timesheet import Timesheet
from kagezou.io.sheets.xdts import read_timesheet
from kagezou.message import Message

TIMESHEET_SUFFIXES = (".xdts", ".tdts", ".sts")
_CELS = "_Cell"
"""Where AniLaPaint puts the folders of a cut."""

_RATE = Fraction(24)
"""Sheets say nothing of it; all of them count 24 frames a second."""


def document_of_sheet(path: Path, progress: Progress = no_progress) -> Imported:
    """Return a new document of a timesheet and the drawings beside it.

    For a column A these are the pictures in a folder A (in whatever case), else ``A_0001.png``, ``A1.png``,
    ``A-01a.png`` and the like in the timesheet's own folder, else the cels of a group A in a PSD file there. A folder
    may also lie in one called ``_Cell``. Columns of one name are layers of the same drawings.

    Raises
    ------
    InputProblem
        The timesheet cannot be read, or there are no drawings of any of its columns.
    """
    path = absolute(path)
    sheet = read_timesheet(path)
    sources = sources_beside(path, sheet)
    if not sources:
        names = ", ".join(dict.fromkeys(track.name for track in sheet.tracks if track.name)) or Message("none")
        raise InputProblem(
            Message(
                "{path}: beside it there are no drawings of its columns ({names}): "
                "neither folders of these names nor pictures such as A_0001.png nor PSD files with such groups",
                path=shown(path),
                names=names,
            )
        )
    imported = new_document(sources, frame_rate=_RATE, progress=progress)
    document, notes = timed(imported.document, sheet)
    return Imported(document, (*imported.notes, *notes), tuple(layer.id for layer in document.layers))


def timed_from_beside(imported: Imported, sources: Sequence[CharacterSource]) -> Imported:
    """Return a new document timed by the sheet that lies beside its PSD file and is called like it, if there is one."""
    files = [source.path for source in sources if is_psd(source.path)]
    beside = (file.with_suffix(suffix) for file in files for suffix in TIMESHEET_SUFFIXES)
    path = next((sheet for sheet in beside if sheet.is_file()), None)
    if path is None or len(files) > 1:
        return imported
    try:
        document, notes = timed(imported.document, read_timesheet(path))
    except InputProblem as problem:
        return replace(imported, notes=(*imported.notes, problem.message))
    return replace(
        imported, document=document, notes=(*imported.notes, Message("timed by {path}", path=shown(path)), *notes)
    )


def sources_beside(path: Path, sheet: Timesheet) -> tuple[CharacterSource, ...]:
    """Return where the drawings of a timesheet's columns lie, from the lowest column up; columns without any are left.

    Raises
    ------
    InputProblem
        The timesheet's folder cannot be read.
    """
    try:
        listed = sorted(path.parent.iterdir())
    except OSError as error:
        raise InputProblem(Message("{path}: {cause}", path=shown(path.parent), cause=cause_of(error))) from error
    folders = {entry.name.casefold(): entry for entry in (*_below(path.parent / _CELS), *listed) if entry.is_dir()}
    pictures = [entry for entry in listed if entry.is_file() and is_picture(entry) and not is_psd(entry)]
    found: list[CharacterSource] = []
    missing: set[str] = set()
    seen: set[str] = set()
    for track in sheet.tracks:
        name = track.name
        if not name or (name in seen and not track.entries):
            continue
        seen.add(name)
        folder = folders.get(name.casefold())
        if folder is not None and any(is_picture(each) for each in _below(folder)):
            found.append(CharacterSource(printable(name), folder, is_timed=True))
        elif (pattern := _pattern(name, pictures)) is not None:
            found.append(CharacterSource(printable(name), pattern, is_timed=True))
        else:
            missing.add(name.casefold())
    return (*found, *_psd_files(path, listed, missing))


def _below(folder: Path) -> list[Path]:
    """Return what lies in a folder; nothing where it is none or cannot be looked into."""
    try:
        return list(folder.iterdir())
    except OSError:
        return []


def _psd_files(path: Path, listed: list[Path], missing: set[str]) -> Iterator[CharacterSource]:
    """Yield the PSD files with characters of the missing columns; the one called like the timesheet comes first."""
    files = [each for each in listed if is_psd(each) and each.is_file()]
    for file in sorted(files, key=lambda each: each.stem.casefold() != path.stem.casefold()):
        try:
            cast = characters_in(psd_tree(file), file.stem)
        except InputProblem:
            continue  # it may be anything; a missing column reports it
        names = {character.name.strip().casefold() for character in cast.characters}
        if names & missing:
            missing -= names
            yield CharacterSource(None, file)


def _pattern(name: str, pictures: list[Path]) -> Path | None:
    """Return the pattern of a column's pictures in one folder, such as ``A_#*.png``."""
    numbered = re.compile(rf"({re.escape(name)}[_\-. ]?)[0-9]{{1,6}}[a-z]{{0,2}}", re.IGNORECASE)
    for picture in pictures:
        if match := numbered.fullmatch(picture.stem):
            return picture.with_name(f"{match[1]}#*{picture.suffix}")
    return None
