"""Which files make a cut: the drawings, the background and the timesheet in a folder, or one file that holds them all.

A folder of a cut has a folder for each column of its timesheet (A, B, ...), or numbered drawings themselves, or a file
of layers. What is called like a background (BG, LO, 背景, ...) lies under everything.
"""

import re
import unicodedata
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

from kagezou.errors import InputProblem
from kagezou.importing.imported import Imported
from kagezou.importing.new_cels import CharacterSource, printable
from kagezou.importing.oca_project import as_long_as, oca_among
from kagezou.importing.progress import Progress, no_progress
from kagezou.importing.psd_characters import is_background_name
from kagezou.importing.sheet_project import TIMESHEET_SUFFIXES, check_seen, sources_beside, timed_from_beside
from kagezou.importing.staging import exposed, new_document
from kagezou.io.files.faults import input_problem, shown
from kagezou.io.files.spellings import on_disk
from kagezou.io.images.sequences import Sequence as FileSequence
from kagezou.io.images.sequences import natural_key, sequences_among, sequences_below
from kagezou.io.oca.reading import oca_file
from kagezou.io.pixels.signatures import is_picture, is_psd
from kagezou.io.project.paths import absolute
from kagezou.io.sheets.reading import read_timesheet
from kagezou.message import Message, first_names

_CELS: Final = "_cell"
"""Where AniLaPaint puts the folders of a cut."""

_COLUMN: Final = re.compile(r"(?:.*[_\-. ])?(?:cels?|cells?|セル)?[_\-. ]?[a-z][0-9]?(?:[_\-. ](?![0-9]+$).*)?")
"""The name of a column, alone or behind that of the cut, and perhaps the state of its drawings: A, c012_A, A_R1."""


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


@dataclass(frozen=True, slots=True)
class Listing:
    """What lies in a folder, in natural order, without hidden things.

    Parameters
    ----------
    folder
        The folder.
    folders
        Folders in it that are no backgrounds.
    pictures
        Flat pictures that are no backgrounds.
    layered
        Files and folders of layers: PSD, OCA.
    sheets
        Timesheets.
    backgrounds
        Pictures, and folders of pictures, that are called like a background.
    """

    folder: Path
    folders: tuple[Path, ...]
    pictures: tuple[Path, ...]
    layered: tuple[Path, ...]
    sheets: tuple[Path, ...]
    backgrounds: tuple[Path, ...]

    @property
    def columns(self) -> tuple[Path, ...]:
        """The folders that are called like columns and hold pictures, those in ``_Cell`` too."""
        inner = [each for folder in self.folders if plain(folder.name) == _CELS for each in listed(folder).folders]
        return tuple(each for each in (*inner, *self.folders) if is_column_name(each.name) and holds_pictures(each))

    @property
    def runs(self) -> tuple[FileSequence, ...]:
        """The numbered drawings in it."""
        return tuple(each for each in sequences_among(self.pictures).sequences if each.files[0].number is not None)


def listed(folder: Path) -> Listing:
    """Return what lies in a folder.

    Raises
    ------
    InputProblem
        It cannot be looked into.
    """
    try:
        entries = sorted(
            (each for each in folder.iterdir() if each.name[:1] != "."), key=lambda each: natural_key(each.name)
        )
    except OSError as error:
        raise input_problem(folder, error) from error
    kinds: dict[str, dict[Path, None]] = {
        name: {} for name in ("folders", "pictures", "layered", "sheets", "backgrounds")
    }
    for entry in entries:
        kind, path = _kind_of(entry)
        if kind:
            kinds[kind][path] = None
    return Listing(folder, **{name: tuple(found) for name, found in kinds.items()})


def _kind_of(entry: Path) -> tuple[str, Path]:
    """Return as which part of a `Listing` something counts, empty where as none, and its path there."""
    if entry.suffix.lower() in TIMESHEET_SUFFIXES:
        return "sheets", entry
    if (document := oca_file(entry)) is not None:
        return "layered", document
    if is_psd(entry):
        return "layered", entry
    if entry.is_dir():
        return ("backgrounds" if _is_background(entry) and holds_pictures(entry) else "folders"), entry
    if is_picture(entry):
        return ("backgrounds" if _is_background(entry) else "pictures"), entry
    return "", entry


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
    if not any((listing.folders, listing.pictures, listing.layered, listing.sheets, listing.backgrounds)):
        raise InputProblem(Message("{path}: the folder of this cut is empty", path=shown(path)))
    sheets = listing.sheets or tuple(_sheets_beside(path))
    if sheets:
        found = _of_sheet(_own(sheets, path), path / _own(sheets, path).name, listing)
        left = [each.name for each in sheets if each != found.sheet]
        return replace(found, notes=(*found.notes, *_left(path, left)))
    background, notes = _background(listing)
    if listing.layered:
        sources = tuple(CharacterSource(None, each) for each in listing.layered)
        left = [each.name for each in (*listing.columns, *listing.pictures)]
        return CutFiles(sources, background, None, (*notes, *_left(path, left)))
    found = _of_drawings(listing)
    return replace(found, background=background, notes=(*notes, *found.notes))


def document_of_cut(files: CutFiles, progress: Progress = no_progress) -> Imported:
    """Return a new document of a cut.

    Raises
    ------
    InputProblem, UsageProblem
        As for `new_document` and `read_timesheet`.
    """
    cut = oca_among(files.sources)
    if cut is None:
        imported = new_document(files.sources, background=files.background, progress=progress)
    else:
        imported = new_document(
            files.sources,
            background=files.background,
            size=cut.size_px,
            frame_rate=cut.frame_rate,
            progress=progress,
        )
        imported = as_long_as(imported, cut)
    imported = replace(imported, notes=(*files.notes, *imported.notes))
    if files.sheet is None:
        return timed_from_beside(imported, files.sources)
    timed = exposed(imported.document, read_timesheet(files.sheet))
    check_seen(timed.document, files.sheet)
    return replace(timed, notes=(*imported.notes, *timed.notes))


def holds_pictures(folder: Path) -> bool:
    """Return whether pictures lie in a folder; False where it is none or cannot be looked into."""
    try:
        return any(is_picture(each) and each.name[:1] != "." for each in folder.iterdir())
    except OSError:
        return False


def is_column_name(name: str) -> bool:
    """Return whether a file or folder is called like a column of a timesheet."""
    return _COLUMN.fullmatch(plain(name)) is not None


def plain(name: str) -> str:
    """Return a name by which spellings of case, width and form are one."""
    return unicodedata.normalize("NFKC", name).strip().casefold()


def _is_background(path: Path) -> bool:
    """Return whether a file or folder is called like a background, alone or behind the name of the cut."""
    name = plain(path.name if path.is_dir() else path.stem)
    return is_background_name(name) or is_background_name(re.split(r"[_\-. ]", name)[-1])


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


def _of_drawings(listing: Listing) -> CutFiles:
    """Return characters of the folders that are columns, else of numbered drawings, of folders, or of stills."""
    columns = listing.columns
    runs = () if columns else listing.runs
    folders = () if runs else columns or tuple(each for each in listing.folders if holds_pictures(each))
    if folders:
        below = sequences_below(folders)
        sequences: Iterable[FileSequence] = (*below.sequences, *sequences_among(below.left_out).sequences)
        left = [*listing.pictures, *(each for each in listing.folders if each not in folders and holds_pictures(each))]
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
