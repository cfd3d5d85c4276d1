"""Bringing characters onto the canvas: from folders of drawings to a document that shows a good shadow at once."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path

from kagezou.animation.track import Interpolation
from kagezou.document.address import Address
from kagezou.document.edits import add_layer, join_layer, set_background, set_canvas, set_constant, set_key
from kagezou.document.figure_properties import BACKGROUND_POSITION, POSITION
from kagezou.document.model import Canvas, Document
from kagezou.document.set_pieces import stood_up, stood_up_notes
from kagezou.errors import UsageProblem
from kagezou.geometry.box import Box
from kagezou.importing.background_pictures import background_of, with_background
from kagezou.importing.cel_notes import notes_on
from kagezou.importing.cel_sizes import canvas_size
from kagezou.importing.cels_of_files import held_by
from kagezou.importing.figures import MeasuredFigure, measured_figure
from kagezou.importing.imported import Imported
from kagezou.importing.lighting import with_ground_and_light
from kagezou.importing.new_cels import CharacterSource, NewCels
from kagezou.importing.progress import LoadPhase, Progress, no_progress
from kagezou.importing.timesheet_on_document import timed
from kagezou.io.files.faults import shown
from kagezou.io.images.reading import probe
from kagezou.io.sheets.reading import read_timesheet
from kagezou.io.sheets.timesheet import Timesheet
from kagezou.message import Message
from kagezou.picture_source import PicturePart, file_of

STILL_LENGTH_FRAMES = 24
"""The cut of a project that has only stills."""

DEFAULT_SIZE_PX = (1920, 1080)
__all__ = [
    "Brought",
    "CharacterSource",
    "Imported",
    "brought",
    "exposed",
    "new_document",
    "put_in",
    "with_characters",
    "with_timesheet",
]


@dataclass(frozen=True, slots=True)
class Brought:
    """Characters whose files have been read, to be put into a document without reading any more.

    Parameters
    ----------
    characters
        Their cels, from bottom to top.
    figures_seen
        What was seen of each one's drawings.
    notes
        What the user should know of the files, one sentence each.
    backgrounds
        Opaque pictures that could be the background, and how far from the middle of the canvas each lies, px.
    """

    characters: tuple[NewCels, ...]
    figures_seen: tuple[MeasuredFigure, ...]
    notes: tuple[Message, ...]
    backgrounds: tuple[tuple[PicturePart | Path, tuple[int, int]], ...] = ()


def new_document(
    sources: Sequence[CharacterSource],
    *,
    background: Path | PicturePart | None = None,
    size: tuple[int, int] | None = None,
    frame_rate: Fraction = Fraction(24),
    progress: Progress = no_progress,
) -> Imported:
    """Return a new document with characters, a ground under the lowest of them and a light in front.

    Parameters
    ----------
    sources
        The characters from bottom to top.
    background
        A picture under everything, or a folder or a pattern of pictures, as `background_of` takes it.
    size
        Canvas width and height, px; else that of the background's largest picture, else that of the largest drawing.
    frame_rate
        Frames a second.
    watch
        Told how far it is.

    Raises
    ------
    InputProblem
        A file that was asked for cannot be found or opened, or is too large.
    UsageProblem
        A name is no name for a layer.
    """
    read = _read(sources, progress, frame_rate)
    behind = None if background is None else background_of(background, progress, frame_rate)
    width, height = size or _natural_size(behind, read)
    document = set_canvas(Document(Canvas(1, 1)), Canvas(width, height, frame_rate))
    if behind is not None:
        document = with_background(document, behind)
        read = replace(read, notes=(*behind.notes, *read.notes))
    read = replace(read, figures_seen=_looks(read.characters, document.canvas.box, progress))
    progress(LoadPhase.LIGHTING, 0, 0)
    return put_in(document, read)


def with_characters(document: Document, sources: Sequence[CharacterSource]) -> Imported:
    """Return the document with characters on top; ground and lamp are placed only for the first ones.

    Raises
    ------
    InputProblem, UsageProblem
        As for :func:`new_document`.
    """
    return put_in(document, brought(sources, document.canvas))


def brought(sources: Sequence[CharacterSource], canvas: Canvas, progress: Progress = no_progress) -> Brought:
    """Return characters with everything read that is needed to put them into any document.

    Parameters
    ----------
    sources
        The characters from bottom to top.
    canvas
        Where they will probably lie, and at which rate.
    watch
        Told how far it is.

    Raises
    ------
    InputProblem, UsageProblem
        As for :func:`new_document`.
    """
    read = _read(sources, progress, canvas.frame_rate)
    return replace(read, figures_seen=_looks(read.characters, canvas.box, progress))


def with_timesheet(document: Document, path: Path, which: str | None = None) -> Imported:
    """Return the document exposed as the timesheet at ``path`` says, and as long; ``which`` is for `read_timesheet`.

    Raises
    ------
    InputProblem
        The timesheet cannot be read.
    """
    return exposed(document, read_timesheet(path, which))


def exposed(document: Document, sheet: Timesheet) -> Imported:
    """Return the document exposed as a timesheet says, and as long."""
    changed, notes = timed(document, sheet)
    before = {layer.id: layer for layer in document.layers}
    return Imported(changed, tuple(notes), tuple(each.id for each in changed.layers if each is not before[each.id]))


def _read(sources: Sequence[CharacterSource], progress: Progress, frame_rate: Fraction) -> Brought:
    """Return what the sources hold, not looked at yet."""
    characters: list[NewCels] = []
    notes: list[Message] = []
    backgrounds: list[tuple[PicturePart | Path, tuple[int, int]]] = []
    for source in sources:
        held = held_by(source, progress, frame_rate)
        characters += held.layers
        notes += held.notes
        backgrounds += [(each, held.away_px if index == 0 else (0, 0)) for index, each in enumerate(held.backgrounds)]
    return Brought(tuple(characters), (), tuple(notes), tuple(backgrounds))


def _with_background(document: Document, read: Brought, notes: list[Message]) -> Document:
    """Put the first of what was found under everything, unless there is a background; the others are reported."""
    taken = read.backgrounds[:1] if document.background is None else ()
    notes += [
        Message(
            "{path}: the layer {layer!r} was left out, as there is a background already",
            path=shown(file_of(each)),
            layer=each.address if isinstance(each, PicturePart) else each.stem,
        )
        for each, _ in read.backgrounds[len(taken) :]
    ]
    for source, (dx, dy) in taken:
        document = set_background(document, source)
        if (dx, dy) != (0, 0):
            x, y = document.canvas.box.middle
            document = set_constant(document, Address(BACKGROUND_POSITION), [x + dx, y + dy])
    return document


def _looks(characters: Sequence[NewCels], canvas: Box, progress: Progress) -> tuple[MeasuredFigure, ...]:
    return tuple(measured_figure(character.cels.drawings, canvas, progress) for character in characters)


def _natural_size(behind: NewCels | None, read: Brought) -> tuple[int, int]:
    if behind is not None:
        return canvas_size(behind.size_px)
    if read.backgrounds:
        info = probe(read.backgrounds[0][0])
        return canvas_size((info.width_px, info.height_px))
    if not read.characters:
        return DEFAULT_SIZE_PX
    widths, heights = zip(*(each.size_px for each in read.characters), strict=True)
    return canvas_size((max(widths), max(heights)))


def put_in(document: Document, read: Brought) -> Imported:
    """Return the document with the characters on top; for the first ones ground, lamp and the cut's length are set.

    Raises
    ------
    UsageProblem
        A name is no name for a layer.
    """
    is_first = not document.layers
    canvas_box = document.canvas.box
    notes = list(read.notes)
    document = _with_background(document, read, notes)
    figures_seen: dict[str, MeasuredFigure] = {}
    for character, seen in zip(read.characters, read.figures_seen, strict=True):
        look = replace(seen, figure=seen.figure.on(canvas_box)) if seen.figure else seen
        document = add_layer(document, character.name, character.cels, look.figure.box if look.figure else canvas_box)
        layer = document.layers[-1]
        if character.moved:
            document, look = _moved(document, layer.id, character), _seen_there(look, character)
        if character.joins is not None:
            document = join_layer(document, layer.id, _figure_named(document, character.joins, layer.id))
        figures_seen[layer.id] = look
        told = (note for note in look.notes if note not in character.notes)
        notes += [*character.notes, *told, *notes_on(layer.name, character, look.figure, canvas_box)]
    if document.pieces:
        drawn, document = document, stood_up(document, figures_seen)
        notes += stood_up_notes(drawn, document)
    if is_first and read.characters:
        document = _with_length(document, read.characters)
        document = with_ground_and_light(document, figures_seen)
    return Imported(document, tuple(notes), tuple(figures_seen))


def _moved(document: Document, layer_id: str, character: NewCels) -> Document:
    """Lay drawings where their file says, by keys that are held."""
    address = Address(POSITION, layer_id)
    (x, y), first = document.canvas.box.middle, character.moved[0][1]
    if len(character.moved) == 1:
        return set_constant(document, address, [x + first[0], y + first[1]])
    for frame, (dx, dy) in character.moved:
        document = set_key(document, address, frame, [x + dx, y + dy], Interpolation.HOLD)
    return document


def _seen_there(seen: MeasuredFigure, character: NewCels) -> MeasuredFigure:
    """Return what was seen of the first drawing where that lies, so that ground and light fit it."""
    if seen.figure is None:
        return seen
    (dx, dy), (x, y) = character.moved[0][1], seen.figure.offset
    return replace(seen, figure=replace(seen.figure, offset=(x + dx, y + dy)))


def _figure_named(document: Document, name: str, part_id: str) -> str:
    """Return the id of the layer that a part joins by its figure's name: that layer, or the first of several parts."""
    others = [layer for layer in document.layers if layer.id != part_id]
    named = [layer for layer in others if layer.name == name]
    named = named or [layer for layer in others if layer.name.startswith(f"{name} ")]
    if not named:
        part = document.layer(part_id).name
        raise UsageProblem(Message("{part}: there is no character {name!r} that it could join", part=part, name=name))
    return named[0].id


def _with_length(document: Document, characters: Sequence[NewCels]) -> Document:
    longest = max(character.length_frames for character in characters)
    length = STILL_LENGTH_FRAMES if longest == 1 else longest
    canvas = document.canvas
    return set_canvas(document, replace(canvas, length_frames=max(length, canvas.length_frames)))
