"""A project of a timesheet alone: its columns find their drawings beside it, by the names that studios give them."""

import re
from fractions import Fraction
from pathlib import Path

from kagezou.errors import InputProblem
from kagezou.io.faults import cause_of, shown
from kagezou.io.project_paths import absolute
from kagezou.io.signatures import is_picture
from kagezou.io.timesheet import Timesheet
from kagezou.io.xdts import read_timesheet
from kagezou.session.exposing import CharacterSource
from kagezou.session.staging import Staged, new_document
from kagezou.session.timing import timed
from kagezou.session.watching import Watch, unwatched

_RATE = Fraction(24)
"""Sheets say nothing of it; all of them count 24 frames a second."""


def document_of_sheet(path: Path, watch: Watch = unwatched) -> Staged:
    """Return a new document of a timesheet and the drawings beside it.

    For a column A these are the pictures in a folder A (in whatever case), else ``A_0001.png``, ``A1.png``,
    ``A-01a.png`` and the like in the timesheet's own folder.

    Raises
    ------
    InputProblem
        The timesheet cannot be read, or there are no drawings of any of its columns.
    """
    path = absolute(path)
    sheet = read_timesheet(path)
    sources = sources_beside(path, sheet)
    if not sources:
        names = ", ".join(dict.fromkeys(track.name for track in sheet.tracks if track.name)) or "none"
        raise InputProblem(
            f"{shown(path)}: beside it there are no drawings of its columns ({names}): "
            "neither folders of these names nor pictures such as A_0001.png"
        )
    staged = new_document(sources, frame_rate=_RATE, watch=watch)
    document, notes = timed(staged.document, sheet)
    return Staged(document, (*staged.notes, *notes), tuple(layer.id for layer in document.layers))


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
        raise InputProblem(f"{shown(path.parent)}: {cause_of(error)}") from error
    folders = {entry.name.casefold(): entry for entry in listed if entry.is_dir()}
    pictures = [entry for entry in listed if entry.is_file() and is_picture(entry)]
    found: list[CharacterSource] = []
    for name in dict.fromkeys(track.name for track in sheet.tracks if track.name):
        folder = folders.get(name.casefold())
        if folder is not None and any(is_picture(each) for each in folder.iterdir()):
            found.append(CharacterSource(name, folder))
        elif (pattern := _pattern(name, pictures)) is not None:
            found.append(CharacterSource(name, pattern))
    return tuple(found)


def _pattern(name: str, pictures: list[Path]) -> Path | None:
    """Return the pattern of a column's pictures in one folder, such as ``A_#.png``."""
    numbered = re.compile(rf"({re.escape(name)}[_\-. ]?)[0-9]{{1,6}}[a-z]{{0,2}}", re.IGNORECASE)
    for picture in pictures:
        if match := numbered.fullmatch(picture.stem):
            return picture.with_name(f"{match[1]}#{picture.suffix}")
    return None
