"""A project of a document of Open Cel Animation: its canvas, its rate and its length are the cut's."""

from collections.abc import Sequence
from dataclasses import replace

from kagezou.document.edits import set_canvas
from kagezou.importing.imported import Imported
from kagezou.importing.new_cels import CharacterSource
from kagezou.importing.progress import Progress, no_progress
from kagezou.importing.sheet_project import timed_from_beside
from kagezou.importing.staging import new_document
from kagezou.io.files.spellings import on_disk
from kagezou.io.oca.document import OcaDocument
from kagezou.io.oca.reading import oca_file, read_oca
from kagezou.io.project.paths import absolute


def document_of_sources(sources: Sequence[CharacterSource], progress: Progress = no_progress) -> Imported:
    """Return a new document of what was brought: the cut is as the only document of Open Cel Animation has it, if one.

    Raises
    ------
    InputProblem, UsageProblem
        As for `new_document`.
    """
    document = oca_among(sources)
    if document is None:
        return timed_from_beside(new_document(sources, progress=progress), sources)
    imported = new_document(sources, size=document.size_px, frame_rate=document.frame_rate, progress=progress)
    return as_long_as(imported, document)


def oca_among(sources: Sequence[CharacterSource]) -> OcaDocument | None:
    """Return the document of Open Cel Animation that is among sources, None without one or with several.

    Raises
    ------
    InputProblem
        It cannot be read.
    """
    files = [oca_file(on_disk(absolute(source.path))) for source in sources]
    found = [file for file in files if file is not None]
    return read_oca(found[0]) if len(found) == 1 else None


def as_long_as(imported: Imported, document: OcaDocument) -> Imported:
    """Return a new document as long as the one that it was made of."""
    canvas = replace(imported.document.canvas, length_frames=document.length_frames)
    return replace(imported, document=set_canvas(imported.document, canvas))
