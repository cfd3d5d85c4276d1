"""The background's pictures: from a picture, a folder or a pattern to what is seen under everything, and when."""

from dataclasses import replace
from pathlib import Path

from kagezou.document.edits import set_background_cels, set_canvas, still
from kagezou.document.model import Document
from kagezou.importing.cel_sizes import canvas_size, measured_cels
from kagezou.importing.cels_of_files import cels_of, number_notes
from kagezou.importing.file_notes import said_once
from kagezou.importing.new_cels import NewCels, printable
from kagezou.importing.progress import LoadPhase, Progress, no_progress
from kagezou.io.files.faults import shown
from kagezou.io.files.spellings import on_disk
from kagezou.io.images.reading import probe
from kagezou.io.images.sequences import find_sequences
from kagezou.io.project.paths import absolute
from kagezou.message import Message

_SHOWN_NAMES = 3


def background_of(path: Path, progress: Progress = no_progress) -> NewCels:
    """Return the pictures of a background.

    Parameters
    ----------
    path
        A picture, which is seen for the whole cut; or a folder or a pattern such as ``bg_#.png``, whose pictures are
        exposed as their numbers say.
    progress
        Told how far it is.

    Raises
    ------
    InputProblem
        There is nothing to be found, or none of it can be opened.
    """
    source = on_disk(absolute(path))
    progress(LoadPhase.FINDING, 0, 0)
    if not source.is_dir() and (source.is_file() or "#" not in source.name):
        info = probe(source)
        name = printable(source.stem)
        said = said_once(name, [(source, info.notes)])
        return NewCels(name, still(source), (info.width_px, info.height_px), 1, said)
    found = find_sequences(source)
    first, *others = found.sequences
    name = printable(source.name if source.is_dir() else first.name)
    cels = cels_of(first)
    measured = measured_cels(name, cels.drawings, progress)
    unused = [*(each.name for each in others), *(each.name for each in found.left_out)]
    doubts = said_once(name, [(source, found.notes)])
    notes = (*doubts, *_left_out(source, first.name, unused), *number_notes(name, first), *measured.notes)
    cels = replace(cels, drawings=measured.drawings)
    return NewCels(name, cels, measured.size_px, cels.exposures[-1].frame, notes)


def with_background(document: Document, found: NewCels) -> Document:
    """Put the pictures of a background under everything; the cut is at least as long as they are."""
    canvas = document.canvas
    longer = replace(canvas, length_frames=max(canvas.length_frames, found.length_frames))
    return set_background_cels(set_canvas(document, longer), found.cels)


def laid_behind(document: Document, found: NewCels) -> Document:
    """Do the same; where there is nothing to see yet the canvas becomes as large as the largest of them.

    Raises
    ------
    InputProblem
        They are too large for a canvas.
    """
    if document.is_blank:
        width, height = canvas_size(found.size_px)
        document = set_canvas(document, replace(document.canvas, width_px=width, height_px=height))
    return with_background(document, found)


def _left_out(source: Path, taken: str, unused: list[str]) -> tuple[Message, ...]:
    if not unused:
        return ()
    names = ", ".join(unused[:_SHOWN_NAMES]) + (", …" if len(unused) > _SHOWN_NAMES else "")
    return (
        Message("{path}: the background is {taken}; left out: {names}", path=shown(source), taken=taken, names=names),
    )
