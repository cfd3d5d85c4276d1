"""A project of a timesheet alone: its columns find their drawings beside it, by the names that studios give them."""

import re
import unicodedata
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import TypeVar

from kagezou.document.model import Document
from kagezou.errors import InputProblem
from kagezou.importing.new_cels import CharacterSource, printable
from kagezou.importing.progress import Progress, no_progress
from kagezou.importing.psd_characters import characters_in
from kagezou.importing.staging import Imported, new_document
from kagezou.importing.timesheet_on_document import timed
from kagezou.io.files.faults import cause_of, shown
from kagezou.io.files.spellings import on_disk
from kagezou.io.images.sequences import sequences_among, sequences_below
from kagezou.io.names.states import states_among
from kagezou.io.pixels.signatures import is_picture, is_psd
from kagezou.io.project.paths import absolute
from kagezou.io.psd.file import psd_tree
from kagezou.io.sheets.reading import read_timesheet
from kagezou.io.sheets.timesheet import Timesheet
from kagezou.message import Message

TIMESHEET_SUFFIXES = (".xdts", ".tdts", ".sts")
_CELS = "_Cell"
"""Where AniLaPaint puts the folders of a cut."""

_Found = TypeVar("_Found")

_RATE = Fraction(24)
"""Sheets say nothing of it; all of them count 24 frames a second."""


def document_of_sheet(path: Path, progress: Progress = no_progress, which: str | None = None) -> Imported:
    """Return a new document of a timesheet and the drawings beside it, as `sources_beside` finds them.

    Parameters
    ----------
    path
        The timesheet's file.
    progress
        Told how far it is.
    which
        Which of several sheets in it, as for `read_timesheet`.

    Raises
    ------
    InputProblem
        The timesheet cannot be read, or there are no drawings of any of its columns.
    """
    path = on_disk(absolute(path))
    sheet = read_timesheet(path, which)
    imported = new_document(sources_beside(path, sheet), frame_rate=_RATE, progress=progress)
    document, notes = timed(imported.document, sheet)
    check_seen(document, path)
    return Imported(document, (*imported.notes, *notes), tuple(layer.id for layer in document.layers))


def timed_from_beside(imported: Imported, sources: Sequence[CharacterSource]) -> Imported:
    """Return a new document timed by the sheet that lies beside its PSD file and is called like it, if there is one."""
    files = [source.path for source in sources if is_psd(source.path)]
    beside = (on_disk(file.with_suffix(suffix)) for file in files for suffix in TIMESHEET_SUFFIXES)
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


def check_seen(document: Document, sheet: Path) -> None:
    """Make sure that a new document that ``sheet`` timed shows something.

    Raises
    ------
    InputProblem
        It has characters, and none of them has a drawing on any frame.
    """
    exposures = [exposure for layer in document.layers for exposure in layer.cels.exposures]
    if document.layers and all(exposure.drawing is None for exposure in exposures):
        layers = ", ".join(layer.name for layer in document.layers)
        raise InputProblem(
            Message("{path}: none of its cels has a drawing among those of {layers}", path=shown(sheet), layers=layers)
        )


def sources_beside(path: Path, sheet: Timesheet) -> tuple[CharacterSource, ...]:
    """Return where the drawings of a timesheet's columns lie, from the lowest column up; columns without any are left.

    For a column A these are the pictures in a folder A, else those beside the sheet that are called A and numbered,
    such as ``A_0001.png``, else the cels of a group A in a PSD file there. Case, width and spelling of letters do not
    matter, and where nothing is called A it may be the last word of a name: ``c012_A``. A folder may also lie in one
    called ``_Cell``. Columns of one name are layers of the same drawings.

    Raises
    ------
    InputProblem
        The timesheet's folder cannot be read, or there are no drawings of any column.
    """
    try:
        listed = sorted(path.parent.iterdir())
    except OSError as error:
        raise InputProblem(Message("{path}: {cause}", path=shown(path.parent), cause=cause_of(error))) from error
    folders = {_plain(each.name): each for each in (*_below(path.parent / _CELS), *listed) if _holds_pictures(each)}
    pictures = [entry for entry in listed if entry.is_file() and is_picture(entry) and not is_psd(entry)]
    numbered = [each for each in sequences_among(pictures).sequences if each.files[0].number is not None]
    runs = {_plain(each.name): each for each in reversed(numbered)}
    found: list[CharacterSource] = []
    missing: set[str] = set()
    seen: set[str] = set()
    for track in sheet.tracks:
        name = _plain(track.name)
        if not name or (name in seen and not track.entries):
            continue
        seen.add(name)
        if (folder := _called(name, folders, path.stem)) is not None:
            found.append(_in_folder(printable(track.name), folder, list(folders.values())))
        elif (run := _called(name, runs, path.stem)) is not None:
            found.append(CharacterSource(printable(track.name), path.parent, is_timed=True, drawings=run))
        else:
            missing.add(name)
    sources = (*found, *_psd_files(path, listed, missing))
    if not sources:
        raise _no_drawings(path, sheet)
    return sources


def _in_folder(name: str, folder: Path, folders: Sequence[Path]) -> CharacterSource:
    """Return a column's drawings in a folder; where others beside it hold retakes of them, the newest."""
    for states in states_among([each.name for each in folders]):
        group = [folders[index] for index in states.indices]
        if folder in group and len(sequences := sequences_below(group).sequences) == 1:
            return CharacterSource(name, folder, is_timed=True, drawings=sequences[0])
    return CharacterSource(name, folder, is_timed=True)


def _no_drawings(path: Path, sheet: Timesheet) -> InputProblem:
    names = ", ".join(dict.fromkeys(track.name for track in sheet.tracks if track.name)) or Message("none")
    return InputProblem(
        Message(
            "{path}: beside it there are no drawings of its columns ({names}): "
            "neither folders of these names nor pictures such as A_0001.png nor PSD files with such groups",
            path=shown(path),
            names=names,
        )
    )


def _called(name: str, known: Mapping[str, _Found], cut: str) -> _Found | None:
    """Return what is called so, else the only one whose last word is the name; of several that of the cut's name."""
    if name in known:
        return known[name]
    ending = {title: each for title, each in known.items() if re.split(r"[_\-. ]+", title)[-1] == name}
    if len(ending) > 1:
        ending = {title: each for title, each in ending.items() if title.startswith(_plain(cut))}
    return next(iter(ending.values())) if len(ending) == 1 else None


def _plain(name: str) -> str:
    return unicodedata.normalize("NFKC", name).strip().casefold()


def _holds_pictures(path: Path) -> bool:
    return path.is_dir() and any(is_picture(each) for each in _below(path))


def _below(folder: Path) -> list[Path]:
    """Return what lies in a folder; nothing where it is none or cannot be looked into."""
    try:
        return list(folder.iterdir())
    except OSError:
        return []


def _psd_files(path: Path, listed: list[Path], missing: set[str]) -> Iterator[CharacterSource]:
    """Yield the PSD files with characters of the missing columns; the one called like the timesheet comes first."""
    files = [each for each in listed if is_psd(each) and each.is_file()]
    for file in sorted(files, key=lambda each: _plain(each.stem) != _plain(path.stem)):
        try:
            cast = characters_in(psd_tree(file), file.stem)
        except InputProblem:
            continue  # it may be anything; a missing column reports it
        names = {_plain(character.name) for character in cast.characters}
        if names & missing:
            missing -= names
            yield CharacterSource(None, file)
