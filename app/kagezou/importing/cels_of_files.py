"""From picture files to cels: which drawings a source holds, when each is exposed, how large they are."""

from collections.abc import Iterable
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

from kagezou.animation.frames import format_frames
from kagezou.document.model import Cels, Drawing, Exposure
from kagezou.errors import InputProblem
from kagezou.importing.cel_sizes import measured_cels
from kagezou.importing.cels_of_oca import held_by_oca
from kagezou.importing.cels_of_psd import held_by_psd
from kagezou.importing.file_notes import said_once
from kagezou.importing.file_pages import FILM_RATE, pages_of
from kagezou.importing.new_cels import CharacterSource, Held, NewCels, left_out_note, printable
from kagezou.importing.painted import notes_on_first_drawings
from kagezou.importing.paper import on_found_paper
from kagezou.importing.progress import LoadPhase, Progress, no_progress
from kagezou.io.files.faults import shown
from kagezou.io.files.spellings import on_disk
from kagezou.io.images.parts import is_exr
from kagezou.io.images.sequences import NumberedFile, Sequence, find_sequences
from kagezou.io.oca.reading import oca_file
from kagezou.io.pixels.signatures import is_psd
from kagezou.io.project.paths import absolute
from kagezou.message import Message


def held_by(source: CharacterSource, progress: Progress = no_progress, frame_rate: Fraction = FILM_RATE) -> Held:
    """Return the layers that a source holds, and notes about the source as a whole.

    Parameters
    ----------
    source
        What was brought.
    progress
        Told how far it is.
    frame_rate
        Frames a second of the cut, by which films are exposed.

    Raises
    ------
    InputProblem
        There is nothing to be found, or none of the drawings of a layer can be opened.
    """
    path = on_disk(absolute(source.path))
    progress(LoadPhase.FINDING, 0, 0)
    if source.drawings is not None:
        name = source.name or printable(source.drawings.name)
        notes = list(said_once(name, [(path, source.drawings.notes)]))
        return _joining(source, Held([_new_cels(name, source.drawings, source, progress, frame_rate)], notes))
    if is_psd(path) and path.is_file():
        return _joining(source, held_by_psd(source, path, progress))
    if (document := oca_file(path)) is not None:
        return _joining(source, held_by_oca(source, document, progress))
    found = find_sequences(path)
    notes = list(said_once(source.name or printable(path.stem), [(path, found.notes)]))
    if found.left_out:
        notes.append(left_out_note(path, (shown(Path(each.name)) for each in found.left_out)))
    if len(found.sequences) == 1:
        only = found.sequences[0]
        own = path.name if path.is_dir() else only.name
        name = source.name or printable(own)
        return _joining(source, Held([_new_cels(name, only, source, progress, frame_rate)], notes))
    head = f"{source.name} " if source.name else ""
    layers = [_new_cels(head + printable(each.name), each, source, progress, frame_rate) for each in found.sequences]
    return _joining(source, Held(layers, notes))


def _joining(source: CharacterSource, held: Held) -> Held:
    """Return what a source holds as parts of the figure that it joins."""
    if source.joins is None:
        return held
    return replace(held, layers=[replace(layer, joins=source.joins) for layer in held.layers])


def _new_cels(
    name: str, sequence: Sequence, source: CharacterSource, progress: Progress, frame_rate: Fraction
) -> NewCels:
    pages = None
    if len(sequence.files) == 1:
        with suppress(InputProblem):  # told when its size is asked for
            pages = pages_of(sequence.files[0].path, frame_rate)
    cels = cels_of(sequence, source.layer) if pages is None else pages.cels
    measured = measured_cels(name, cels.drawings, progress)
    cels, on_paper = on_found_paper(name, replace(cels, drawings=measured.drawings))
    gaps = () if source.is_timed else number_notes(name, sequence)
    gaps = gaps if pages is None else pages.notes
    last = cels.exposures[-1].frame if pages is None else pages.length_frames
    return NewCels(
        name, cels, measured.size_px, last, (*gaps, *measured.notes, *on_paper, *notes_on_first_drawings(name, cels))
    )


def cels_of(sequence: Sequence, layer: str | None = None) -> Cels:
    """Return numbered pictures as drawings, exposed as their numbers say; ``layer`` is meant of OpenEXR files."""
    drawings = tuple(_drawing(file, layer) for file in sequence.files)
    if not sequence.counts_frames:
        return Cels(drawings, tuple(Exposure(index + 1, index) for index in range(len(drawings))))
    return Cels(drawings, _exposures(sequence.files))


def number_notes(name: str, sequence: Sequence) -> tuple[Message, ...]:
    """Return what is to be said about numbers that no file has, or that are no frames."""
    if not sequence.counts_frames:
        return (Message("{name}: its numbers lie too far apart to be frames; each drawing has one", name=name),)
    if not sequence.gaps:
        return ()
    gaps = format_frames(sequence.gaps)
    return (Message("{name}: missing {gaps}; the drawing before is held", name=name, gaps=gaps),)


def _drawing(file: NumberedFile, layer: str | None) -> Drawing:
    name = file.path.stem if file.number is None else f"{file.number}{file.suffix}"
    return Drawing(printable(name), file.path, layer if is_exr(file.path) else None)


def _exposures(files: Iterable[NumberedFile]) -> tuple[Exposure, ...]:
    """Return one exposure a drawing: the first number on frame 1, the others as far behind as their numbers say.

    A number that is there twice (12 and 12a) takes one frame more, so that no drawing is lost.
    """
    exposures: list[Exposure] = []
    numbers: list[int] = []
    inserted = 0
    for index, file in enumerate(files):
        number = file.number or 0
        inserted += number in numbers[-1:]
        numbers.append(number)
        exposures.append(Exposure(number - numbers[0] + 1 + inserted, index))
    return tuple(exposures)
