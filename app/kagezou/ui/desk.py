"""The project on the desk: where its file lies, and opening, saving and bringing things in."""

from pathlib import Path

from PySide6.QtCore import QObject, Signal

from kagezou.document.edits import set_background
from kagezou.document.model import Canvas, Document
from kagezou.io import project_file
from kagezou.io.cels import CelCache
from kagezou.io.keepsake import Keepsake
from kagezou.io.xdts import write_xdts
from kagezou.session.session import Session
from kagezou.session.sheet_project import document_of_sheet, timed_from_beside
from kagezou.session.staging import CharacterSource, new_document, with_characters, with_timesheet
from kagezou.session.timing import sheet_of
from kagezou.ui.arrivals import PROJECT_SUFFIX
from kagezou.ui.bridge import Bridge

BLANK_SIZE_PX = (1920, 1080)


class Desk(QObject):
    """One project at a time. Every method may raise a Problem; then everything is as it was.

    Outlives the window, which is made anew when the language changes.
    """

    path_changed = Signal()
    noted = Signal(str)
    """Something the user should know about what came in, one sentence."""

    def __init__(self) -> None:
        super().__init__()
        self.cels = CelCache()
        self.bridge = Bridge(Session(blank_document()))
        self._path: Path | None = None
        self._seen = ""

    @property
    def path(self) -> Path | None:
        """Where the project was opened from or saved to."""
        return self._path

    @property
    def is_blank(self) -> bool:
        """Whether there is nothing to see."""
        document = self.bridge.document
        return not document.layers and document.background is None

    @property
    def is_saved(self) -> bool:
        """Whether nothing would be lost."""
        return self.bridge.session.is_saved

    def clear(self) -> None:
        """Begin with nothing."""
        self._put(Session(blank_document()), None)

    def new(self, sources: tuple[CharacterSource, ...]) -> None:
        """Begin a project with characters; it has no file yet and counts as unsaved."""
        staged = timed_from_beside(new_document(sources), sources)
        session = Session(blank_document())
        session.edit(self.tr("New from cels"), staged.document)
        self._put(session, None)
        self._say(staged.notes)

    def open(self, path: Path) -> None:
        """Open a project file."""
        seen = project_file.fingerprint(path)
        self._put(Session(project_file.load(path)), path)
        self._seen = seen

    def recover(self, work: Keepsake) -> None:
        """Put unsaved work back as it was put aside; it counts as unsaved."""
        session = Session(blank_document())
        session.edit(self.tr("Recover unsaved work"), work.document)
        self._put(session, work.path)
        self._seen = project_file.fingerprint(work.path) if work.path else ""

    def is_changed_outside(self, path: Path) -> bool:
        """Whether saving to ``path`` would undo what others saved there since it was opened."""
        now = project_file.fingerprint(path)
        return path == self._path and now not in ("", self._seen)

    def save(self, path: Path) -> None:
        """Write the project; a name without suffix gets one."""
        whole = path if path.suffix.lower() == PROJECT_SUFFIX else path.with_name(path.name + PROJECT_SUFFIX)
        session = self.bridge.session
        project_file.save(session.document, whole)
        self._seen = project_file.fingerprint(whole)
        self._path = whole
        session.mark_saved()
        self.path_changed.emit()

    def bring(self, sources: tuple[CharacterSource, ...]) -> None:
        """Add characters as one step; into nothing they come with a canvas, a ground and a lamp of their own."""
        session = self.bridge.session
        if self.is_blank:
            staged = timed_from_beside(new_document(sources), sources)
        else:
            staged = with_characters(session.document, sources)
        session.edit(self.tr("Import character"), staged.document)
        if staged.layer_ids:
            session.select(staged.layer_ids[-1])
        self._say(staged.notes)

    def time_by(self, path: Path) -> None:
        """Expose the drawings as a timesheet says; with nothing on the desk they are looked for beside it."""
        if self.is_blank:
            staged = document_of_sheet(path)
            session = Session(blank_document())
            session.edit(self.tr("New from timesheet"), staged.document)
            self._put(session, None)
        else:
            staged = with_timesheet(self.bridge.document, path)
            self.bridge.session.edit(self.tr("Apply timesheet"), staged.document)
        self._say(staged.notes)

    def write_timesheet(self, path: Path, name: str) -> None:
        """Write when which drawing is exposed, as XDTS; a name without suffix gets one."""
        whole = path if path.suffix.lower() == ".xdts" else path.with_name(path.name + ".xdts")
        write_xdts(whole, sheet_of(self.bridge.document, name))

    def put_background(self, path: Path | None) -> None:
        """Put a picture under everything, or take it away; into nothing it brings its size."""
        session = self.bridge.session
        if path is not None and self.is_blank:
            document = new_document((), background=path).document
        else:
            document = set_background(session.document, path)
        session.edit(self.tr("Set background"), document)

    def _put(self, session: Session, path: Path | None) -> None:
        self._path = path
        self.bridge.open(session)
        self.path_changed.emit()

    def _say(self, notes: tuple[str, ...]) -> None:
        for note in notes:
            self.noted.emit(note)


def blank_document() -> Document:
    """Return a document with nothing in it."""
    return Document(Canvas(*BLANK_SIZE_PX))
