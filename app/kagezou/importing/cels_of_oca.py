"""From documents of Open Cel Animation to cels: a layer is a character, a group of several is one figure."""

from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

from kagezou.document.model import Cels, Drawing, Exposure
from kagezou.errors import InputProblem
from kagezou.geometry.box import Box, centred_offset
from kagezou.importing.cel_sizes import measured_cels
from kagezou.importing.file_notes import said_once
from kagezou.importing.new_cels import CharacterSource, Held, NewCels, printable
from kagezou.importing.painted import notes_on_first_drawings
from kagezou.importing.paper import on_found_paper
from kagezou.importing.progress import Progress
from kagezou.io.files.faults import shown
from kagezou.io.images.reading import probe, read_matte
from kagezou.io.oca.document import OcaDocument, OcaFrame, OcaLayer
from kagezou.io.oca.reading import read_oca
from kagezou.message import Message, first_names


def held_by_oca(source: CharacterSource, path: Path, progress: Progress) -> Held:
    """Return the layers that the document at ``path`` holds; raises as `cels_of_files.held_by` does."""
    document = read_oca(path)
    background = _background(document)
    layers = document.layers[background is not None :]
    if not layers and background is None:
        raise InputProblem(Message("{path}: every layer in it is hidden or empty", path=shown(path)))
    made = [
        _new_cels(document, layer, called, progress)
        for layer, called in zip(layers, _names(layers, source.name), strict=True)
    ]
    notes = [*said_once(path.stem, [(path, document.notes)]), *_joined_notes(path, made)]
    return Held(made, notes) if background is None else Held(made, notes, (background[0],), background[1])


def _background(document: OcaDocument) -> tuple[Path, tuple[int, int]] | None:
    """Return the picture of the lowest layer where one fills the canvas, and its way from the middle, px."""
    lowest = document.layers[0] if document.layers else None
    if lowest is None or lowest.group or len(lowest.frames) != 1 or len(document.layers) == 1:
        return None
    file = lowest.frames[0].file
    try:
        if file is None or not file.is_file():
            return None
        about = probe(file)
        is_full = not about.has_alpha or read_matte(file).is_full
    except InputProblem:  # told when it is brought as a character
        return None
    size = (about.width_px, about.height_px)
    away = _away(document, lowest.frames[0], size)
    canvas = Box(0, 0, *document.size_px)
    covered = Box(0, 0, *size).moved(*centred_offset(canvas, *size)).moved(*away)
    return (file, away) if is_full and covered.intersection(canvas) == canvas else None


def _names(layers: Sequence[OcaLayer], wanted: str | None) -> list[tuple[str, str | None]]:
    """Return what each layer is to be called and which it joins: of a group of several, the lowest is the figure."""
    sizes = Counter(layer.group[0] for layer in layers if layer.group)
    head = f"{wanted} " if wanted and len(layers) > 1 else ""
    made: list[tuple[str, str | None]] = []
    figures: set[str] = set()
    for layer in layers:
        own = printable(layer.name)
        figure = printable(layer.group[0]) if layer.group and sizes[layer.group[0]] > 1 else None
        if figure is None:
            made.append((wanted if wanted and not head else head + own, None))
        elif figure in figures:
            made.append((f"{head}{figure} {own}", head + figure))
        else:
            figures.add(figure)
            made.append((head + figure, None))
    return made


def _new_cels(document: OcaDocument, layer: OcaLayer, called: tuple[str, str | None], progress: Progress) -> NewCels:
    name, joins = called
    files = list(dict.fromkeys(frame.file for frame in layer.frames if frame.file is not None))
    titles = {frame.file: frame.name for frame in reversed(layer.frames)}
    drawings = tuple(Drawing(printable(titles[file] or file.stem), file) for file in files)
    are_placed = any(frame.middle_px is not None for frame in layer.frames)
    measured = measured_cels(name, drawings, progress, are_placed=are_placed)
    exposures = tuple(_exposures(layer.frames, {file: index for index, file in enumerate(files)}, document))
    cels, on_paper = on_found_paper(name, Cels(measured.drawings, exposures))
    sizes = {drawing.path: drawing.size_px for drawing in cels.drawings if drawing.size_px is not None}
    notes = (
        *measured.notes,
        *on_paper,
        *notes_on_first_drawings(name, cels),
        *_size_notes(name, layer.frames, sizes),
    )
    moved = tuple(_moved(document, layer.frames, sizes))
    return NewCels(name, cels, document.size_px, document.length_frames, notes, joins, moved)


def _exposures(frames: Sequence[OcaFrame], places: dict[Path, int], document: OcaDocument) -> Iterator[Exposure]:
    """Yield when each drawing is seen, and when none is: where a frame ends before the next begins."""
    for index, frame in enumerate(frames):
        yield Exposure(frame.frame, None if frame.file is None else places[frame.file])
        end = frame.frame + frame.duration_frames
        until = frames[index + 1].frame if index + 1 < len(frames) else document.length_frames + 1
        if frame.duration_frames and end < until and frame.file is not None:
            yield Exposure(end, None)


def _moved(
    document: OcaDocument, frames: Sequence[OcaFrame], sizes: dict[Path, tuple[int, int]]
) -> Iterator[tuple[int, tuple[int, int]]]:
    """Yield from when on drawings lie elsewhere than in the middle, and how far from it; nothing where all do."""
    found = [
        (frame.frame, _away(document, frame, sizes[frame.file]))
        for frame in frames
        if frame.file is not None and frame.file in sizes
    ]
    if all(away == (0, 0) for _, away in found):
        return
    last = None
    for at, away in found:
        if away != last:
            yield (1 if last is None else at), away
        last = away


def _away(document: OcaDocument, frame: OcaFrame, size: tuple[int, int]) -> tuple[int, int]:
    """Return how far from the middle of the canvas a picture lies, px.

    A middle is a whole number: of a picture as large as the canvas either of those about its middle means that.
    """
    if frame.middle_px is None:
        return (0, 0)
    away = []
    for middle, extent, canvas in zip(frame.middle_px, size, document.size_px, strict=True):
        # Krita halves the sum of the first and the last pixel, and rounds towards 0.
        is_rounded_down = document.counts_from_corner and middle >= 0
        before = (extent - 1) // 2 if is_rounded_down else extent // 2
        is_centred = extent == canvas and abs(middle - canvas / 2) <= 1
        away.append(0 if is_centred else round(middle) - before - (canvas - extent) // 2)
    return (away[0], away[1])


def _size_notes(name: str, frames: Sequence[OcaFrame], sizes: dict[Path, tuple[int, int]]) -> Iterator[Message]:
    """Yield what is said where pictures are of other sizes than the document says."""
    unlike = [
        frame.file.name
        for frame in frames
        if frame.file in sizes and frame.size_px is not None and sizes[frame.file] != frame.size_px
    ]
    if unlike:
        names = first_names(dict.fromkeys(unlike))
        yield Message(
            "{name}: these are of other sizes than the document says, and lie about their middles: {names}",
            name=name,
            names=names,
        )


def _joined_notes(path: Path, layers: Sequence[NewCels]) -> Iterator[Message]:
    """Yield what is said about layers of a group that were taken as parts of one figure."""
    for figure in dict.fromkeys(layer.joins for layer in layers if layer.joins is not None):
        names = [figure, *(layer.name for layer in layers if layer.joins == figure)]
        yield Message("{path}: one figure with one shadow: {names}", path=shown(path), names=first_names(names))
