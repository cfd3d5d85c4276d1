"""The background's pictures: from a picture, a folder or a pattern to what is seen under everything, and when."""

from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

from kagezou.document.edits import set_background_cels, set_canvas, still
from kagezou.document.model import Document
from kagezou.errors import InputProblem
from kagezou.importing.cel_sizes import canvas_size, measured_cels
from kagezou.importing.cels_of_files import cels_of, number_notes
from kagezou.importing.file_notes import said_once
from kagezou.importing.file_pages import FILM_RATE, pages_of
from kagezou.importing.new_cels import NewCels, printable
from kagezou.importing.progress import LoadPhase, Progress, no_progress
from kagezou.io.files.faults import shown
from kagezou.io.files.spellings import on_disk
from kagezou.io.images.parts import is_exr
from kagezou.io.images.reading import ImageInfo, probe, read_cel
from kagezou.io.images.sequences import find_sequences
from kagezou.io.project.paths import absolute
from kagezou.message import Message, first_names
from kagezou.picture_source import PicturePart, PictureSource, file_of


def background_of(
    behind: Path | PicturePart, progress: Progress = no_progress, frame_rate: Fraction = FILM_RATE
) -> NewCels:
    """Return the pictures of a background.

    Parameters
    ----------
    behind
        A picture, which is seen for the whole cut; a file of several, which follow one another; or a folder or a
        pattern such as ``bg_#.png``, whose pictures are exposed as their numbers say. As a part of such a path, that
        layer is taken of its OpenEXR files.
    progress
        Told how far it is.
    frame_rate
        Frames a second of the cut, by which films are exposed.

    Raises
    ------
    InputProblem
        There is nothing to be found, or none of it can be opened.
    """
    layer = behind.address if isinstance(behind, PicturePart) else None
    source = on_disk(absolute(file_of(behind)))
    progress(LoadPhase.FINDING, 0, 0)
    if not source.is_dir() and (source.is_file() or "#" not in source.name):
        return _of_file(source, frame_rate, layer)
    found = find_sequences(source)
    first, *others = found.sequences
    if len(first.files) == 1 and not others and not found.left_out:
        return _of_file(first.files[0].path, frame_rate, layer)
    name = printable(source.name if source.is_dir() else first.name)
    cels = cels_of(first, layer)
    measured = measured_cels(name, cels.drawings, progress)
    unused = [*(each.name for each in others), *(each.name for each in found.left_out)]
    doubts = said_once(name, [(source, found.notes)])
    notes = (*doubts, *_left_out(source, first.name, unused), *number_notes(name, first), *measured.notes)
    cels = replace(cels, drawings=measured.drawings)
    return NewCels(name, cels, measured.size_px, cels.exposures[-1].frame, notes)


def _of_file(path: Path, frame_rate: Fraction, layer: str | None) -> NewCels:
    """Return the one picture of a file, or its several."""
    name = printable(path.stem)
    pages = pages_of(path, frame_rate)
    if pages is not None:
        measured = measured_cels(name, pages.cels.drawings, no_progress)
        cels = replace(pages.cels, drawings=measured.drawings)
        return NewCels(name, cels, measured.size_px, pages.length_frames, (*pages.notes, *measured.notes))
    source = PicturePart(path, layer) if layer is not None and is_exr(path) else path
    info = probe(source)
    said = said_once(name, [(path, (*info.notes, *_notes_on_light(source, info)))])
    size_px = (info.width_px, info.height_px)
    cels = still(source)
    cels = replace(cels, drawings=tuple(replace(drawing, size_px=size_px) for drawing in cels.drawings))
    return NewCels(name, cels, size_px, 1, said)


def _notes_on_light(source: PictureSource, info: ImageInfo) -> tuple[Message, ...]:
    """Return what is to be said of a background's light where its alpha is 0, for which its pixels are read."""
    if not info.is_doubtful:
        return ()
    with suppress(InputProblem):  # told when it is drawn
        return read_cel(source, white_is_clear=False).notes
    return ()


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
    return (
        Message(
            "{path}: the background is {taken}; left out: {names}",
            path=shown(source),
            taken=taken,
            names=first_names(unused),
        ),
    )
