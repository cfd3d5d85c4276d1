"""Loads before which somebody may be asked: what files mean is found out first, and shown where it is not plain."""

from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

from PySide6.QtCore import QCoreApplication

from kagezou.importing.found_characters import FoundCharacters, found_characters, whole_of
from kagezou.importing.new_cels import CharacterSource
from kagezou.io.sheets.reading import read_sheets, sheet_names
from kagezou.io.sheets.timesheet import Timesheet
from kagezou.ui.project.dialogs import Dialogs
from kagezou.ui.project.dropped_files import DroppedFiles, dropped_files_of
from kagezou.ui.project.load import AnyLoad, Load
from kagezou.ui.project.loading import Loading
from kagezou.ui.project.open_project import OpenProject

_Found = TypeVar("_Found")
_LoadOf = Callable[[tuple[CharacterSource, ...]], AnyLoad]


class Asking:
    """Finds out, asks, and hands on what is to be loaded.

    Parameters
    ----------
    loading
        Where files are looked at beside the window.
    dialogs
        Who asks.
    load
        Carries out a load; false if it turned out at once that it cannot be done.
    """

    def __init__(self, loading: Loading, dialogs: Dialogs, load: Callable[[AnyLoad], bool]) -> None:
        self._loading, self._dialogs, self._load = loading, dialogs, load

    def dropped(self, dropped: DroppedFiles, open_project: OpenProject) -> bool:
        """Bring what was dropped: a timesheet times the drawings, all else becomes characters."""
        if dropped.timesheet is not None:
            return self.sheet(dropped.timesheet, open_project.time_by)
        return self.characters(lambda: found_characters(dropped.characters, dropped.pictures), open_project.bring)

    def folder(self, folder: Path, load_of: _LoadOf) -> bool:
        """Load the characters of a folder."""
        return self.characters(lambda: found_characters([CharacterSource(None, folder)]), load_of)

    def pictures(self, paths: list[Path], load_of: _LoadOf) -> bool:
        """Load chosen pictures; of one numbered picture the whole sequence comes."""
        if len(paths) == 1:
            return self.characters(lambda: whole_of(paths[0]), load_of)
        dropped = dropped_files_of(paths)
        return self.characters(lambda: found_characters(dropped.characters, dropped.pictures), load_of)

    def characters(self, find: Callable[[], FoundCharacters], load_of: _LoadOf) -> bool:
        """Load the characters that are found; which of them is asked where there are several or there is a doubt."""

        def chosen(found: FoundCharacters) -> AnyLoad | None:
            sources = found.sources if found.is_clear else self._dialogs.characters(found)
            return load_of(sources) if sources else None

        return self._after(QCoreApplication.translate("Asking", "the files"), find, chosen)

    def sheet(self, path: Path, load_of: Callable[[Path, str | None], AnyLoad]) -> bool:
        """Load by a timesheet file; which sheet is asked where it holds several."""

        def chosen(sheets: tuple[Timesheet, ...]) -> AnyLoad | None:
            if len(sheets) == 1:
                return load_of(path, None)
            which = self._dialogs.sheet(sheet_names(sheets))
            return None if which is None else load_of(path, which)

        return self._after(path.name, lambda: read_sheets(path), chosen)

    def _after(self, what: str, find: Callable[[], _Found], chosen: Callable[[_Found], AnyLoad | None]) -> bool:
        """Load what is chosen of what is found; false if it turned out at once that it cannot be."""
        failed: list[bool] = []

        def put(found: _Found) -> None:
            load = chosen(found)
            if load is not None and not self._load(load):
                failed.append(True)

        return self._loading.start(Load(what, lambda _watch: find(), put)) and not failed
