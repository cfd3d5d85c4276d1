"""Project files as scripts open and save them: one writer at a time, and nobody's work is lost unsaid."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from kagezou.document.model import Document
from kagezou.errors import OutputProblem
from kagezou.io.files.exclusive import exclusive
from kagezou.io.files.faults import shown
from kagezou.io.project.file import load, save
from kagezou.io.project.file_state import FileState, state_of
from kagezou.io.project.open_elsewhere import open_elsewhere
from kagezou.message import Message


def opened(path: Path) -> tuple[Document, FileState | None]:
    """Return the document of a project, and what its file was like at the latest when it was read.

    Raises
    ------
    ProjectProblem
        As for `load`.
    """
    while True:
        before = state_of(path)
        document = load(path)
        if state_of(path) == before:
            return document, before


@contextmanager
def held(path: Path) -> Iterator[tuple[Message, ...]]:
    """Hold a project against other writers, and give what is to be said: that a window has it open.

    Raises
    ------
    OutputProblem
        As for `exclusive`.
    """
    said = open_elsewhere(path)
    with exclusive(path.resolve()):
        yield () if said is None else (said,)


def kept(document: Document, path: Path, seen: FileState | None, *, force: bool) -> FileState:
    """Write a project that is held.

    Parameters
    ----------
    seen
        What its file was like when it was read; None where it was never read.
    force
        Whether what lies there by now is replaced, whatever it is.

    Raises
    ------
    OutputProblem, DiskFullProblem, ProjectProblem
        There is another file by now, or it cannot be written.
    """
    there = None if force else state_of(path)
    if there is not None and seen is None:
        raise OutputProblem(Message("{path}: it is there already; force=True replaces it", path=shown(path)))
    if there is not None and there != seen:
        raise OutputProblem(
            Message("{path}: somebody else has changed it since it was opened; open it again", path=shown(path))
        )
    return save(document, path)
