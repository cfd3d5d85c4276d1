"""What files dropped on the window or picked in a dialog are meant to be."""

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from kagezou.importing.sheet_project import TIMESHEET_SUFFIXES
from kagezou.importing.staging import CharacterSource
from kagezou.io.oca.reading import oca_file
from kagezou.io.pixels.signatures import is_picture, is_psd
from kagezou.io.sets.mesh_cache import is_mesh

PROJECT_SUFFIX = ".kage"
_OPAQUE = (".jpg", ".jpeg")


@dataclass(frozen=True, slots=True)
class DroppedFiles:
    """What came.

    Parameters
    ----------
    project
        A project to open, if there is one among the files.
    characters
        Folders, PSD files, documents of Open Cel Animation and a single picture, which become layers.
    pictures
        Several pictures, of one character or more.
    background
        A picture without transparency that came alone.
    timesheet
        A timesheet, if there is one among the files and no project.
    set_file
        A set, if there is one among the files and neither of those.
    """

    project: Path | None = None
    characters: tuple[CharacterSource, ...] = ()
    pictures: tuple[Path, ...] = ()
    background: Path | None = None
    timesheet: Path | None = None
    set_file: Path | None = None

    @property
    def is_empty(self) -> bool:
        """Whether there is nothing the program can use."""
        known = (self.project, self.characters, self.pictures, self.background, self.timesheet, self.set_file)
        return not any(known)


def dropped_files_of(paths: Iterable[Path]) -> DroppedFiles:
    """Sort out what paths are."""
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
    whole = [path for path in given if path.is_dir() or is_psd(path) or oca_file(path) is not None]
    pictures = [path for path in given if path not in whole and is_picture(path)]
    if len(pictures) == 1:
        return DroppedFiles(characters=tuple(CharacterSource(None, path) for path in (*whole, *pictures)))
    return DroppedFiles(characters=tuple(CharacterSource(None, path) for path in whole), pictures=tuple(pictures))
