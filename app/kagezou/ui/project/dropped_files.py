"""What files dropped on the window or picked in a dialog are meant to be."""

import re
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from kagezou.importing.sheet_project import TIMESHEET_SUFFIXES
from kagezou.importing.staging import CharacterSource
from kagezou.io.pixels.signatures import is_picture, is_psd
from kagezou.io.sets.mesh_cache import is_mesh

PROJECT_SUFFIX = ".kage"
_OPAQUE = (".jpg", ".jpeg")
_NUMBER = re.compile(r"[0-9]{1,6}(?=[A-Za-z]{0,2}$)")


@dataclass(frozen=True, slots=True)
class DroppedFiles:
    """What came.

    Parameters
    ----------
    project
        A project to open, if there is one among the files.
    characters
        Folders, sequences and single pictures that become layers.
    background
        A picture without transparency that came alone.
    timesheet
        A timesheet, if there is one among the files and no project.
    set_file
        A set, if there is one among the files and neither of those.
    """

    project: Path | None = None
    characters: tuple[CharacterSource, ...] = ()
    background: Path | None = None
    timesheet: Path | None = None
    set_file: Path | None = None

    @property
    def is_empty(self) -> bool:
        """Whether there is nothing the program can use."""
        return not (self.project or self.characters or self.background or self.timesheet or self.set_file)


def dropped_files_of(paths: Iterable[Path]) -> DroppedFiles:
    """Sort out what paths are; numbered pictures that belong together become one sequence."""
    given = list(paths)
    project = next((path for path in given if path.suffix.lower() == PROJECT_SUFFIX), None)
    if project is not None:
        return DroppedFiles(project=project)
    timesheet = next((path for path in given if path.suffix.lower() in TIMESHEET_SUFFIXES), None)
    if timesheet is not None:
        return DroppedFiles(timesheet=timesheet)
    set_file = next((path for path in given if is_mesh(path)), None)
    if set_file is not None:
        return DroppedFiles(set_file=set_file)
    if len(given) == 1 and given[0].suffix.lower() in _OPAQUE:
        return DroppedFiles(background=given[0])
    folders = [CharacterSource(None, path) for path in given if path.is_dir()]
    pictures = [path for path in given if not path.is_dir() and is_picture(path)]
    return DroppedFiles(characters=(*folders, *(CharacterSource(None, path) for path in _sequences(pictures))))


def whole_sequence(path: Path) -> Path:
    """Return the pattern of the sequence a numbered picture belongs to, or the picture itself.

    A PSD file is never one of a sequence: its number is rather that of the cut, and the cels are in it.
    """
    if is_psd(path):
        return path
    stem, hits = _NUMBER.subn("#", path.stem)
    return path.with_name(stem + path.suffix) if hits else path


def _sequences(pictures: list[Path]) -> list[Path]:
    """Return a pattern for pictures that differ only in their number, and the others as they are."""
    patterns = [whole_sequence(path) for path in pictures]
    counts = Counter(patterns)
    sources = (pattern if counts[pattern] > 1 else path for path, pattern in zip(pictures, patterns, strict=True))
    return list(dict.fromkeys(sources))
