"""Which files make a cut: the drawings, the background and the timesheet in a folder, or one file that holds them all.

A folder of a cut has a folder for each column of its timesheet (A, B, ...), or numbered drawings themselves, or a file
of layers. What is called like a background (BG, LO, 背景, ...) lies under everything.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from kagezou.document.model import Document
from kagezou.errors import InputProblem
from kagezou.importing.cut_listing import Listing, folders_in, holds_pictures, listed, plain
from kagezou.importing.imported import Imported
from kagezou.importing.new_cels import CharacterSource, printable
from kagezou.importing.new_cut import NewCut, new_cut
from kagezou.importing.progress import Progress, no_progress
from kagezou.importing.sheet_project import TIMESHEET_SUFFIXES, sources_beside
from kagezou.io.files.faults import shown
from kagezou.io.files.folders import entries_to_read
from kagezou.io.files.spellings import on_disk
from kagezou.io.images.sequences import Sequence as FileSequence
from kagezou.io.images.sequences import sequences_among, sequences_below
from kagezou.io.oca.reading import oca_file
from kagezou.io.project.paths import absolute
from kagezou.io.sheets.reading import read_timesheet
from kagezou.message import Message, first_names


@dataclass(frozen=True, slots=True)
class CutFiles:
    """What a cut is made of.

    Parameters
    ----------
    sources
        Its characters from bottom to top, at least one.
    background
        A picture, or a folder of pictures; None without one.
    sheet
        The timesheet that says when each drawing is seen; None where their numbers do, or the file that holds them.
    notes
        What was left out, one sentence each.
    """

    sources: tuple[CharacterSource, ...]
    background: Path | None = None
    sheet: Path | None = None
    notes: tuple[Message, ...] = ()


def cut_files(path: Path) -> CutFiles:
    """Return what the cut at a path is made of.

    Parameters
    ----------
    path
        A folder, a timesheet, a file of layers or a picture.

    Raises
    ------
    InputProblem
        There is nothing of which a character could be made, or it cannot be read.
    """
    path = on_disk(absolute(path))
    if path.suffix.lower() in TIMESHEET_SUFFIXES:
        return _of_sheet(path, path, listed(path.parent))
    if not path.is_dir() or oca_file(path) is not None:
        return CutFiles((CharacterSource(None, path),))
    listing = listed(path)
    if not any(each.name[:1] != "." for each in entries_to_read(path)):
        raise InputProblem(Message("{path}: the folder of this cut is empty", path=shown(path)))
    sheets = listing.sheets or tuple(_sheets_beside(path))
    if sheets:
        sheet = _own(sheets, path)
        found = _of_sheet(sheet, (listing.holder or path) / sheet.name, listing)
        left = [each.name for each in sheets if each != found.sheet]
        return replace(found, notes=(*found.notes, *_left(path, left)))
    background, notes = _background(listing)
    if listing.layered:
        sources = tuple(CharacterSource(None, each) for each in listing.layered)
        left = [each.name for each in (*listing.columns, *listing.pictures)]
        return CutFiles(sources, background, None, (*notes, *_left(path, left)))
    found = _of_drawings(listing)
    return replace(found, background=background, notes=(*notes, *found.notes))


def document_of_cut(files: CutFiles, template: Document | None = None, progress: Progress = no_progress) -> Imported:
    """Return a new document of a cut, all of a template taken where there is one.

    Raises
    ------
    InputProblem, UsageProblem
        As for `new_cut`.
    """
    imported = new_cut(files.sources, NewCut(files.background, files.sheet, template=template), progress)
    return replace(imported, notes=(*files.notes, *imported.notes))


def _sheets_beside(folder: Path) -> Iterator[Path]:
    """Yield timesheets that lie beside the folder of a cut and are called like it."""
    for suffix in TIMESHEET_SUFFIXES:
        sheet = on_disk(folder.with_name(folder.name + suffix))
        if sheet.is_file():
            yield sheet


def _own(sheets: Sequence[Path], folder: Path) -> Path:
    """Return the timesheet that is called like its folder, else the first."""
    return next((each for each in sheets if plain(each.stem) == plain(folder.name)), sheets[0])


def _of_sheet(sheet: Path, where: Path, listing: Listing) -> CutFiles:
    """Return the drawings of a timesheet's columns, which lie beside ``where``."""
    sources = sources_beside(where, read_timesheet(sheet))
    taken = {plain(source.name or "") for source in sources}
    own = [each for each in listing.backgrounds if plain(each.stem) not in taken]
    if len(listing.sheets) > 1:  # which of several cuts a plain "BG" belongs to is not known
        own = [each for each in own if plain(each.stem).startswith(plain(sheet.stem))]
    background, notes = _background(replace(listing, backgrounds=tuple(own)))
    return CutFiles(sources, background, sheet, notes)


def _holds_anything(folder: Path) -> bool:
    """Return whether there are pictures in a folder, or in one in it."""
    return holds_pictures(folder) or any(map(holds_pictures, folders_in(folder)))


def _of_drawings(listing: Listing) -> CutFiles:
    """Return characters of the folders that are columns, else of numbered drawings, of folders, or of stills."""
    columns = listing.columns
    runs = () if columns else listing.runs
    folders = () if runs else columns or tuple(each for each in listing.folders if holds_pictures(each))
    if folders:
        below = sequences_below(folders)
        sequences: Iterable[FileSequence] = (*below.sequences, *sequences_among(below.left_out).sequences)
        others = [each for each in listing.folders if each not in folders and each != listing.holder]
        left = [*listing.pictures, *filter(_holds_anything, others)]
    else:
        sequences = runs or sequences_among(listing.pictures).sequences
        seen = {file.path for each in sequences for file in each.files}
        left = [*(each for each in listing.pictures if each not in seen), *filter(holds_pictures, listing.folders)]
    sources = tuple(
        CharacterSource(printable(each.name), each.files[0].path.parent, drawings=each) for each in sequences
    )
    if not sources:
        there = Message("there is only a background in it") if listing.backgrounds else Message("there is no drawing")
        raise InputProblem(Message("{path}: {cause}", path=shown(listing.folder), cause=there))
    if len(sources) == 1 and not folders:
        sources = (replace(sources[0], name=printable(listing.folder.name)),)
    return CutFiles(sources, notes=_left(listing.folder, [each.name for each in left]))


def _background(listing: Listing) -> tuple[Path | None, tuple[Message, ...]]:
    """Return the background of a cut, and what is said of others."""
    first, *others = listing.backgrounds or (None,)
    return first, _left(listing.folder, [each.name for each in others if each is not None])


def _left(folder: Path, names: Sequence[str]) -> tuple[Message, ...]:
    if not names:
        return ()
    told = first_names(shown(Path(name)) for name in names)
    return (Message("{path}: not taken into the cut: {names}", path=shown(folder), names=told),)
