"""What lies in the folder of a cut: columns, drawings, files of layers, timesheets, backgrounds."""

import re
import unicodedata
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from kagezou.importing.psd_characters import is_background_name
from kagezou.importing.sheet_project import TIMESHEET_SUFFIXES
from kagezou.io.files.faults import input_problem
from kagezou.io.images.sequences import Sequence as FileSequence
from kagezou.io.images.sequences import natural_key, sequences_among
from kagezou.io.oca.reading import oca_file
from kagezou.io.pixels.signatures import is_picture, is_psd

_HOLDING_COLUMNS: Final = (
    "_cell", "仕上", "仕上げ", "paint", "painted", "color", "colour",
    "セル", "cels", "cells", "cel", "cell", "動画", "原画",
)  # fmt: skip
"""Folders in which those of the columns may lie, the latest stage first; AniLaPaint has ``_Cell``."""

_COLUMN: Final = re.compile(r"(?:.*[_\-. ])?(?:cels?|cells?|セル)?[_\-. ]?[a-z][0-9]?(?:[_\-. ](?![0-9]+$).*)?")
"""The name of a column, alone or behind that of the cut, and perhaps the state of its drawings: A, c012_A, A_R1."""


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
        """The folders that are called like columns and hold pictures, else those in the folder that holds them."""
        return _columns_among(self.folders) or (() if self.holder is None else _columns_among(folders_in(self.holder)))

    @property
    def holder(self) -> Path | None:
        """The folder, such as ``_Cell``, in which those of the columns lie; None where they lie here, or nowhere."""
        if _columns_among(self.folders):
            return None
        named = {plain(folder.name): folder for folder in self.folders}
        known = (named[name] for name in _HOLDING_COLUMNS if name in named)
        return next((folder for folder in known if _columns_among(folders_in(folder))), None)

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


def folders_in(folder: Path) -> tuple[Path, ...]:
    """Return the folders in a folder, in natural order, without hidden ones; none where it cannot be looked into."""
    try:
        found = [each for each in folder.iterdir() if each.name[:1] != "." and each.is_dir()]
    except OSError:
        return ()
    return tuple(sorted(found, key=lambda each: natural_key(each.name)))


def _columns_among(folders: Iterable[Path]) -> tuple[Path, ...]:
    return tuple(each for each in folders if is_column_name(each.name) and holds_pictures(each))


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
