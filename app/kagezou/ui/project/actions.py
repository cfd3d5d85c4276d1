"""What the commands about files do: ask, act, and say in the message bar what went wrong."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject, Signal
from PySide6.QtWidgets import QApplication, QWidget

from kagezou.errors import Problem
from kagezou.geometry.set_camera import SetCamera
from kagezou.importing.outside_files import note_on_outside_files
from kagezou.importing.sheet_project import TIMESHEET_SUFFIXES
from kagezou.importing.staging import CharacterSource
from kagezou.io.oca.reading import oca_file
from kagezou.io.pixels.signatures import is_psd
from kagezou.io.project.file import next_version
from kagezou.io.project.recovery_file import RecoveredWork
from kagezou.ui.project.asking import Asking
from kagezou.ui.project.cut_names import output_name
from kagezou.ui.project.dialogs import Answer, Changed, Dialogs
from kagezou.ui.project.dropped_files import PROJECT_SUFFIX, DroppedFiles, dropped_files_of
from kagezou.ui.project.load import AnyLoad
from kagezou.ui.project.loading import Loading
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.project.project_lock import ProjectLock
from kagezou.ui.project.saving import LAST_WAIT_S, Saving, is_saved_by_now
from kagezou.ui.system.settings import Settings
from kagezou.ui.system.waiting import waiting
from kagezou.ui.system.words import translated
from kagezou.ui.widgets.message_bar import MessageBar, Severity

_KEY = "project"


class ProjectActions(QObject):
    """New, open, save, import, and the question before unsaved work goes.

    Parameters
    ----------
    open_project
        The project.
    dialogs
        Who asks.
    bar
        Where problems are said.
    settings
        Where recent projects are remembered.
    """

    recent_changed = Signal()
    done = Signal(str)
    """What was asked for is done, in words that nobody needs to answer."""
    set_read = Signal(Path, object)
    """A set was read from a file, with its cameras, a tuple of SetCamera."""

    def __init__(self, open_project: OpenProject, dialogs: Dialogs, bar: MessageBar, settings: Settings) -> None:
        super().__init__()
        self._open_project, self.dialogs, self._bar, self._settings = open_project, dialogs, bar, settings
        self.loading = Loading(self._say, lambda: _is_free(open_project, self.loading.window()))
        self.saving = _told_of(Saving(open_project), self._saved, self._say)
        self._asking, self._lock = Asking(self.loading, dialogs, self._load), ProjectLock()
        open_project.path_changed.connect(lambda: self._lock.hold(open_project.path))
        self._lock.hold(open_project.path)

    def new(self) -> None:
        """Begin a project from a folder of cels."""
        if self.may_leave() and (folder := self.dialogs.folder_of_cels()):
            self._asking.folder(folder, self._open_project.new)

    def open(self) -> None:
        """Open another project."""
        if self.may_leave() and (path := self.dialogs.project_to_open()):
            self.open_path(path)

    def open_recent(self, path: Path) -> None:
        """Open a project of before."""
        if self.may_leave():
            self.open_path(path)

    def open_path(self, path: Path) -> bool:
        """Open a project without asking about the old one; false if it turns out at once that it cannot be opened.

        A timesheet, which drawing programs start us with, begins a project of the drawings beside it, and a PSD file
        or a document of Open Cel Animation one of what is in it.
        """
        if is_psd(path) or oca_file(path) is not None:
            return self._load(self._open_project.new((CharacterSource(None, path),)))
        if path.suffix.lower() in TIMESHEET_SUFFIXES:
            return self._asking.sheet(path, self._open_project.new_by)
        holder = self._lock.holder_of(path)
        if holder and not self.dialogs.open_twice(path.name, holder):
            return False
        return self._load(_then(self._open_project.open(path), lambda: self._opened(path)))

    def save(self) -> bool:
        """Save where it was saved before, or ask; false if it is neither saved after that nor being saved."""
        path = self.saving.path or self._open_project.path
        if path is None:
            return self.save_as()
        # What is being written is only written anew: nobody else changed it meanwhile.
        answer = Changed.REPLACE if self.saving.path else _about_changes(path, self._open_project, self.dialogs)
        if answer is Changed.SAVE_AS:
            return self.save_as(next_version(path).name)
        return answer is Changed.REPLACE and self._save_to(path)

    def save_increment(self) -> bool:
        """Save as the next version beside the old one; false as for ``save``."""
        path = self._open_project.path
        return self._save_to(next_version(path)) if path else self.save_as()

    def recover(self, work: RecoveredWork) -> bool:
        """Open unsaved work again; false if what is open is not to be left."""
        if not self.may_leave():
            return False
        self.loading.cancel()
        return self._try(partial(self._open_project.recover, work))

    def put_away(self) -> None:
        """Leave the project to others, once it is written."""
        self.saving.wait(LAST_WAIT_S)
        self._lock.release()

    def save_as(self, suggested: str = "") -> bool:
        """Ask where to save; without a suggestion the project's own name is one."""
        chosen = self.dialogs.project_to_save(suggested or self.project_name + PROJECT_SUFFIX)
        return self._save_to(chosen) if chosen else False

    def import_folder(self) -> None:
        """Bring in folders of cels, each a character or more."""
        if folders := self.dialogs.folders_of_cels():
            self.bring(folders)

    def import_pictures(self) -> None:
        """Bring in pictures; of one numbered picture the whole sequence comes."""
        if paths := self.dialogs.pictures():
            self._asking.pictures(paths, self._open_project.bring)

    def put_background(self, path: Path | None) -> None:
        """Put a picture, or the numbered ones of a folder, under everything; with None nobody chose any."""
        if path:
            self._load(self._open_project.put_background(path))

    def remove_background(self) -> None:
        """Take the background away."""
        self._try(self._open_project.remove_background)

    def read_ahead(self) -> None:
        """Bring the drawings of the work area into memory."""
        self._load(self._open_project.reading_ahead())

    def time_by(self, path: Path) -> bool:
        """Expose the drawings as a timesheet says, or begin a project of the drawings beside it."""
        return self._asking.sheet(path, self._open_project.time_by)

    def import_timesheet(self) -> None:
        """Ask for a timesheet."""
        if path := self.dialogs.timesheet():
            self.time_by(path)

    def export_timesheet(self) -> None:
        """Ask where to write the timesheet."""
        name = output_name(self._open_project.bridge.document, self.project_name)
        if path := self.dialogs.timesheet_to_save(f"{name}.xdts"):
            self._try(lambda: self._open_project.write_timesheet(path, self.project_name))

    def bring(self, paths: Iterable[Path]) -> None:
        """Take what was dropped: a project is opened, cels become layers, a lone opaque picture the background."""
        given = list(paths)
        dropped = dropped_files_of(given)
        if dropped.project is not None:
            self.open_recent(dropped.project)
        elif dropped.timesheet or dropped.characters or dropped.pictures:
            self._asking.dropped(dropped, self._open_project)
        elif (load := _load_of(dropped, self._open_project, self.set_read.emit)) is not None:
            self._load(load)
        elif given:
            self._bar.say(_KEY, _nothing_in(given), Severity.WARNING)

    def may_leave(self) -> bool:
        """Whether the project may be put away: it is saved, saved now, or given up."""
        if is_saved_by_now(self.saving, self.loading.window()):
            return True
        answer = Answer.CANCEL if self.saving.is_running else self.dialogs.unsaved(self.project_name)
        is_saved = answer is Answer.SAVE and self.save() and is_saved_by_now(self.saving, self.loading.window())
        return is_saved or answer is Answer.DISCARD

    @property
    def project_name(self) -> str:
        """What the window calls the project."""
        return self._open_project.path.stem if self._open_project.path else self.tr("Untitled")

    def _save_to(self, path: Path) -> bool:
        with waiting():
            return self.saving.start(path)

    def _saved(self, path: Path) -> None:
        self._bar.withdraw(_KEY)
        self._remember(path)
        self.done.emit(self.tr("Saved %1").replace("%1", path.name))

    def _opened(self, path: Path) -> None:
        """Remember a project, and say of one that is new here which files of other folders it reads."""
        if path.absolute() not in self._settings.recent:
            _note_outside_files(self._open_project, path)
        self._remember(path)

    def _remember(self, path: Path) -> None:
        self._settings.remember_project(path)
        self.recent_changed.emit()

    def _load(self, load: AnyLoad) -> bool:
        """Load beside the window; what would put away work that is newer than the question asks again."""
        over = self._open_project.bridge.document

        def put(found: object) -> None:
            if load.replaces and self._open_project.bridge.document is not over and not self.may_leave():
                return
            load.put(found)
            self._bar.withdraw(_KEY)

        return self.loading.start(replace(load, put=put))

    def _try(self, do: Callable[[], object]) -> bool:
        try:
            with waiting():
                do()
        except Problem as problem:
            self._say(problem)
            return False
        self._bar.withdraw(_KEY)
        return True

    def _say(self, problem: Problem) -> None:
        self._bar.say(_KEY, translated(problem))


def _told_of(saving: Saving, saved: Callable[[Path], None], failed: Callable[[Problem], None]) -> Saving:
    saving.saved.connect(saved)
    saving.failed.connect(failed)
    return saving


def _note_outside_files(open_project: OpenProject, path: Path) -> None:
    note = note_on_outside_files(open_project.bridge.document, path)
    if note is not None:
        open_project.noted.emit(note)


def _nothing_in(paths: Sequence[Path]) -> str:
    names = ", ".join(path.name for path in paths[:3])
    words = QCoreApplication.translate(
        "ProjectActions", "%1: neither a project, a folder of cels, a set nor a picture that can be read"
    )
    return words.replace("%1", names)


def _then(load: AnyLoad, do: Callable[[], None]) -> AnyLoad:
    """Return a load after which something is done once it is put in place."""

    def put(found: object) -> None:
        load.put(found)
        do()

    return replace(load, put=put)


def _about_changes(path: Path, open_project: OpenProject, dialogs: Dialogs) -> Changed:
    """Return what to do about what others wrote to the project's file; where nobody did, it is replaced unasked."""
    return dialogs.overwrite_changed(path.name) if open_project.is_changed_outside(path) else Changed.REPLACE


def _load_of(
    dropped: DroppedFiles, open_project: OpenProject, put_set: Callable[[Path, tuple[SetCamera, ...]], None]
) -> AnyLoad | None:
    """Return what brings dropped files into the open project, None if they are nothing that can be brought."""
    if dropped.set_file is not None:
        return open_project.read_set(dropped.set_file, put_set)
    if dropped.background is not None:
        return open_project.put_background(dropped.background)
    return None


def _is_free(open_project: OpenProject, window: QWidget) -> bool:
    """Whether the open project can take something: nobody drags, and no question about it is open."""
    question = QApplication.activeModalWidget()
    is_ours = question is not None and question.parentWidget() is window
    return not open_project.bridge.session.is_in_gesture and not is_ours
