"""The project on the open_project: where its file lies, and opening, saving and bringing things in.

What takes time comes as a ``Load``: read beside the window, then put in place at once.
"""

from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from kagezou.document.edits import set_background
from kagezou.document.model import Canvas, Document
from kagezou.errors import Problem
from kagezou.geometry.set_camera import SetCamera
from kagezou.importing.background_pictures import background_of, laid_behind
from kagezou.importing.new_cels import NewCels
from kagezou.importing.oca_project import document_of_sources
from kagezou.importing.progress import LoadPhase, Progress
from kagezou.importing.sheet_project import document_of_sheet
from kagezou.importing.staging import Brought, CharacterSource, Imported, brought, exposed, put_in
from kagezou.importing.timesheet_on_document import sheet_of
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.project import file as project_file
from kagezou.io.project.file_state import FileState, state_of
from kagezou.io.project.recovery_file import RecoveredWork
from kagezou.io.project.savable import Savable
from kagezou.io.sets.cameras import cameras_of
from kagezou.io.sets.mesh_cache import MeshCache
from kagezou.io.sheets.reading import read_timesheet
from kagezou.io.sheets.timesheet import Timesheet
from kagezou.io.sheets.xdts_writing import write_xdts
from kagezou.message import Message
from kagezou.scene.stances import forget_stances
from kagezou.session.session import SavePoint, Session
from kagezou.ui.project.dropped_files import PROJECT_SUFFIX
from kagezou.ui.project.load import AnyLoad, Load
from kagezou.ui.project.reading_ahead import played_backgrounds, played_drawings, read_ahead
from kagezou.ui.system.bridge import Bridge

BLANK_SIZE_PX = (1920, 1080)


class OpenProject(QObject):
    """One project at a time. Every method and every load may raise a Problem; then everything is as it was.

    Outlives the window, which is made anew when the language changes.
    """

    path_changed = Signal()
    noted = Signal(Message)
    imported = Signal(tuple)
    """The ids of layers that were brought in, or timed by a sheet, just now."""
    """Something the user should know about what came in, one sentence."""

    def __init__(self) -> None:
        super().__init__()
        self.cels = CelCache()
        self.meshes = MeshCache()
        self.bridge = Bridge(_session(blank_document()))
        self._path: Path | None = None
        self._seen: FileState | None = None

    @property
    def path(self) -> Path | None:
        """Where the project was opened from or saved to."""
        return self._path

    @property
    def seen(self) -> FileState | None:
        """What its file was like when it was opened or last saved; None while it has none."""
        return self._seen

    @property
    def is_blank(self) -> bool:
        """Whether there is nothing to see."""
        return self.bridge.document.is_blank

    @property
    def is_saved(self) -> bool:
        """Whether nothing would be lost."""
        return self.bridge.session.is_saved

    def clear(self) -> None:
        """Begin with nothing."""
        self._put(_session(blank_document()), None)

    def new(self, sources: tuple[CharacterSource, ...]) -> AnyLoad:
        """Begin a project with characters; it has no file yet and counts as unsaved."""

        def read(progress: Progress) -> Imported:
            return _first_seen(self, document_of_sources(sources, progress), progress)

        return Load(
            _names(sources), read, lambda imported: self._begin(self.tr("New from cels"), imported), replaces=True
        )

    def open(self, path: Path) -> AnyLoad:
        """Open a project file."""

        def read(progress: Progress) -> tuple[Session, FileState | None]:
            progress(LoadPhase.FINDING, 0, 0)
            seen, document = state_of(path), project_file.load(path)
            _read_first(document, self.cels, self.meshes, progress)
            return _session(document), seen

        def put(found: tuple[Session, FileState | None]) -> None:
            self._put(found[0], path, found[1])

        return Load(path.name, read, put, replaces=True)

    def recover(self, work: RecoveredWork) -> None:
        """Put unsaved work back as it was put aside; it counts as unsaved."""
        self._put(_unsaved(self.tr("Recover unsaved work"), work.document), work.path, work.seen)

    def is_changed_outside(self, path: Path) -> bool:
        """Whether saving to ``path`` would undo what others saved there since it was opened."""
        return path == self._path and state_of(path) not in (None, self._seen)

    def save(self, path: Path) -> None:
        """Write the project, and wait for it; a name without suffix gets one."""
        whole, point = whole_name(path), self.bridge.session.save_point
        self.take_saved(point, whole, project_file.save(point.document, whole))

    def take_saved(self, point: SavePoint, path: Path, state: FileState) -> None:
        """Take for saved what was written to a project's file, which is like this now."""
        self._path, self._seen = path, state
        self.bridge.session.mark_saved(point)
        self.path_changed.emit()

    def bring(self, sources: tuple[CharacterSource, ...]) -> AnyLoad:
        """Add characters as one step; into nothing they come with a canvas, a ground and a lamp of their own."""

        def read(progress: Progress) -> Imported | Brought:
            over = self.bridge.document
            if over.is_blank:
                return _first_seen(self, document_of_sources(sources, progress), progress)
            return brought(sources, over.canvas, progress)

        def put(found: Imported | Brought) -> None:
            if isinstance(found, Brought):
                # The document may have gone on meanwhile; what was read fits any.
                self._edit(self.tr("Import character"), put_in(self.bridge.document, found))
            elif self.is_blank:
                self._edit(self.tr("Import character"), found)
            else:
                self.bring(sources).at_once()

        return Load(_names(sources), read, put)

    def read_set(self, path: Path, put: Callable[[Path, tuple[SetCamera, ...]], None]) -> AnyLoad:
        """Read a set from a file, so that it is there when ``put`` puts it into the picture."""

        def read(_watch: Progress) -> tuple[SetCamera, ...]:
            self.meshes.mesh(path)
            return cameras_of(path, self.bridge.document.canvas.frame_rate)

        return Load(path.name, read, lambda cameras: put(path, cameras))

    def time_by(self, path: Path, which: str | None = None) -> AnyLoad:
        """Expose the drawings as a timesheet says; with nothing open they are looked for beside it."""

        def read(progress: Progress) -> Imported | Timesheet:
            return (
                _first_seen(self, document_of_sheet(path, progress, which), progress)
                if self.is_blank
                else read_timesheet(path, which)
            )

        def put(found: Imported | Timesheet) -> None:
            if isinstance(found, Timesheet):
                self._edit(self.tr("Apply timesheet"), exposed(self.bridge.document, found))
            elif self.is_blank:
                self._begin(self.tr("New from timesheet"), found)
            else:
                self.time_by(path, which).at_once()

        return Load(path.name, read, put)

    def write_timesheet(self, path: Path, name: str) -> None:
        """Write when which drawing is exposed, as XDTS; a name without suffix gets one."""
        whole = path if path.suffix.lower() == ".xdts" else path.with_name(path.name + ".xdts")
        write_xdts(whole, sheet_of(self.bridge.document, name))

    def new_by(self, sheet: Path, which: str | None = None) -> AnyLoad:
        """Begin a project of the drawings beside a timesheet; it has no file yet and counts as unsaved."""

        def read(progress: Progress) -> Imported:
            return _first_seen(self, document_of_sheet(sheet, progress, which), progress)

        return Load(
            sheet.name, read, lambda imported: self._begin(self.tr("New from timesheet"), imported), replaces=True
        )

    def put_background(self, path: Path) -> AnyLoad:
        """Put a picture, or those of a folder, under everything; into nothing they bring their size."""

        def read(progress: Progress) -> NewCels:
            found = background_of(path, progress, self.bridge.document.canvas.frame_rate)
            _read_first(laid_behind(self.bridge.document, found), self.cels, self.meshes, progress)
            return found

        def put(found: NewCels) -> None:
            self._edit(self.tr("Set background"), Imported(laid_behind(self.bridge.document, found), found.notes, ()))

        return Load(path.name, read, put)

    def reading_ahead(self) -> AnyLoad:
        """Decode the drawings of the work area, as many as memory is meant to hold, so that they play smoothly."""

        def read(progress: Progress) -> None:
            document, cels = self.bridge.document, self.cels
            behind = [partial(cels.background, source) for source in played_backgrounds(document)]
            read_ahead([*behind, *(partial(cels.cel, source) for source in played_drawings(document))], cels, progress)

        return Load(self.tr("the work area"), read, lambda _nothing: None, gives_way=True)

    def remove_background(self) -> None:
        """Leave nothing under the characters."""
        session = self.bridge.session
        session.edit(self.tr("Set background"), set_background(session.document, None))

    def _begin(self, step: str, imported: Imported) -> None:
        """Open a new project, which has no file yet."""
        self._put(_unsaved(step, imported.document), None)
        self._tell(imported)

    def _edit(self, step: str, imported: Imported) -> None:
        self.bridge.session.edit(step, imported.document)
        if imported.layer_ids:
            self.bridge.session.select(imported.layer_ids[-1])
        self._tell(imported)

    def _tell(self, imported: Imported) -> None:
        for note in imported.notes:
            self.noted.emit(note)
        self.imported.emit(imported.layer_ids)

    def _put(self, session: Session, path: Path | None, seen: FileState | None = None) -> None:
        self._path, self._seen = path, seen
        forget_stances()
        self.bridge.open(session)
        self.path_changed.emit()


def whole_name(path: Path) -> Path:
    """Return the name of a project's file; a name without suffix gets one."""
    return path if path.suffix.lower() == PROJECT_SUFFIX else path.with_name(path.name + PROJECT_SUFFIX)


def _session(document: Document) -> Session:
    """Return a session in which nothing is done that could not be saved."""
    return Session(document, Savable(document).admit)


def _unsaved(step: str, document: Document) -> Session:
    session = _session(blank_document())
    session.edit(step, document)
    return session


def _first_seen(project: OpenProject, imported: Imported, progress: Progress) -> Imported:
    _read_first(imported.document, project.cels, project.meshes, progress)
    return imported


def _read_first(document: Document, cels: CelCache, meshes: MeshCache, progress: Progress) -> None:
    """Read what the first frame shows, so that the viewport finds it there."""
    wanted: list[Callable[[], object]] = []
    if document.background is not None:
        wanted.append(partial(cels.background, document.background))
    first = (layer.cels.drawing_at(1) for layer in document.layers)
    wanted += [partial(cels.cel, drawing.source) for drawing in first if drawing is not None]
    wanted += [partial(meshes.mesh, piece.source) for piece in document.pieces if piece.source is not None]
    for index, read in enumerate(wanted):
        progress(LoadPhase.READING, index, len(wanted))
        try:
            read()
        except Problem:
            # The viewport meets the same file, and says what is wrong with it.
            continue


def _names(sources: tuple[CharacterSource, ...]) -> str:
    first = sources[0].path.name if sources else ""
    return f"{first}, …" if len(sources) > 1 else first


def blank_document() -> Document:
    """Return a document with nothing in it."""
    return Document(Canvas(*BLANK_SIZE_PX))
