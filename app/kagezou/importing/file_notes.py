"""What readers say of files, said once: what of a file was not used, and what of it had to be assumed."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from kagezou.document.figure_properties import PLACEMENT_LINES
from kagezou.document.model import Cels, Document, Drawing, Layer
from kagezou.errors import InputProblem
from kagezou.io.files.faults import shown
from kagezou.io.images.reading import probe
from kagezou.io.pixels.signatures import is_psd
from kagezou.io.sets.mesh_cache import MeshCache
from kagezou.message import Message


def said_once(name: str, said: Iterable[tuple[Path, tuple[Message, ...]]]) -> tuple[Message, ...]:
    """Return what is to be said of the files of a layer called ``name``, each sentence once.

    Parameters
    ----------
    name
        The layer.
    said
        Each file with what its reader says of it.
    """
    every = list(dict.fromkeys(said))
    files: dict[Message, list[Path]] = {}
    for path, notes in every:
        for note in notes:
            files.setdefault(note, []).append(path)
    return tuple(_of_files(name, note, paths, len(every)) for note, paths in files.items())


def _of_files(name: str, note: Message, paths: list[Path], count: int) -> Message:
    if len(paths) == count > 1:
        return Message("{name}: {note}, in all its {count} files", name=name, note=note, count=count)
    if len(paths) > 1:
        return Message(
            "{name}: {note}, in {files} of {count} files, first in {path}",
            name=name,
            note=note,
            files=len(paths),
            count=count,
            path=shown(paths[0]),
        )
    return Message("{path}: {note}", path=shown(paths[0]), note=note)


def odd_size(name: str, sizes: Sequence[tuple[Path, int, int]]) -> tuple[Message, ...]:
    """Return that the drawings of a layer called ``name`` differ in size; nothing where they do not.

    Parameters
    ----------
    name
        The layer.
    sizes
        Each file with its width and height, px.
    """
    for path, width_px, height_px in sizes:
        if (width_px, height_px) != sizes[0][1:]:
            words = Message(
                "{name}: drawings differ in size, first {path} with {width_px} × {height_px} px; "
                "each lies centred on the canvas",
                name=name,
                path=shown(path),
                width_px=width_px,
                height_px=height_px,
            )
            return (words,)
    return ()


def notes_on_files(document: Document, meshes: MeshCache) -> tuple[Message, ...]:
    """Return what the readers of all the files of a document say, and which of them cannot be read.

    Files that are missing are not spoken of.
    """
    made = [said for name, cels in _cels(document) for said in _of_drawings(name, cels.drawings)]
    for piece in document.pieces:
        if piece.source is not None and piece.source.is_file():
            try:
                made += said_once(piece.name, [(piece.source, meshes.notes(piece.source))])
            except InputProblem as problem:
                made.append(problem.message)
    return tuple(dict.fromkeys(made))


def notes_on_shown(document: Document, frames: Iterable[int] | None) -> tuple[Message, ...]:
    """Return what the readers of the drawings say that are seen on some frames, or in the whole cut.

    Files that are missing or cannot be read are not spoken of: whoever draws them says so.
    """
    whole = range(1, document.canvas.length_frames + 1)
    seen = tuple(whole if frames is None else frames)
    made: list[Message] = []
    for name, cels in _cels(document):
        drawings = [cels.drawings[at] for at in dict.fromkeys(map(cels.index_at, seen)) if at is not None]
        found = [_found(each) for each in drawings if each.path.is_file()]
        made += said_once(name, [(each.path, each.notes) for each in found if each.problem is None])
        made += _odd_sizes(document, name, found)
    return tuple(dict.fromkeys(made))


def _odd_sizes(document: Document, name: str, found: Sequence["_Found"]) -> tuple[Message, ...]:
    """Return that drawings differ in size, unless the layer is placed anew for each, as parts of a document are."""
    layer = next((each for each in document.layers if each.name == name), None)
    if layer is None or _is_placed_anew(layer):
        return ()
    return odd_size(name, [(each.path, *each.size_px) for each in found if each.size_px is not None])


def _is_placed_anew(layer: Layer) -> bool:
    tracks = (layer.tracks.get(each.name) for each in PLACEMENT_LINES)
    return any(track is not None and track.is_keyed for track in tracks)


def _cels(document: Document) -> tuple[tuple[str, Cels], ...]:
    return (*((layer.name, layer.cels) for layer in document.layers), ("background", document.behind))


def _of_drawings(name: str, drawings: Iterable[Drawing]) -> list[Message]:
    found = [_found(drawing) for drawing in drawings if drawing.path.is_file()]
    notes = said_once(name, [(each.path, each.notes) for each in found if each.problem is None])
    return [*notes, *(each.problem for each in found if each.problem is not None)]


@dataclass(frozen=True, slots=True)
class _Found:
    """What the header of a drawing's file tells: its size, px, and what is said of it, or why it cannot be read."""

    path: Path
    size_px: tuple[int, int] | None = None
    notes: tuple[Message, ...] = ()
    problem: Message | None = None


def _found(drawing: Drawing) -> _Found:
    try:
        info = probe(drawing.source)
        more = _notes_on_psd(drawing.path) if is_psd(drawing.path) else ()
    except InputProblem as problem:
        return _Found(drawing.path, problem=problem.message)
    return _Found(drawing.path, (info.width_px, info.height_px), (*info.notes, *more))


def _notes_on_psd(path: Path) -> tuple[Message, ...]:
    # Its reader takes as long to be imported as two frames to be drawn.
    from kagezou.io.psd.file import psd_notes

    return psd_notes(path)
