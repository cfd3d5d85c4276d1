"""What readers say of files, said once: what of a file was not used, and what of it had to be assumed."""

from collections.abc import Iterable
from pathlib import Path

from kagezou.document.model import Document, Drawing
from kagezou.errors import InputProblem
from kagezou.io.files.faults import shown
from kagezou.io.images.reading import probe
from kagezou.io.pixels.signatures import is_psd
from kagezou.io.psd.file import psd_notes
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


def notes_on_files(document: Document, meshes: MeshCache) -> tuple[Message, ...]:
    """Return what the readers of all the files of a document say, and which of them cannot be read.

    Files that are missing are not spoken of.
    """
    made: list[Message] = []
    for name, drawings in (
        *((layer.name, layer.cels.drawings) for layer in document.layers),
        ("background", document.behind.drawings),
    ):
        said = [_of_drawing(drawing) for drawing in drawings if drawing.path.is_file()]
        made += said_once(name, [each for each in said if not isinstance(each, Message)])
        made += [each for each in said if isinstance(each, Message)]
    for piece in document.pieces:
        if piece.source is not None and piece.source.is_file():
            try:
                made += said_once(piece.name, [(piece.source, meshes.notes(piece.source))])
            except InputProblem as problem:
                made.append(problem.message)
    return tuple(dict.fromkeys(made))


def _of_drawing(drawing: Drawing) -> tuple[Path, tuple[Message, ...]] | Message:
    """Return what is said of a drawing's file, or why it cannot be read."""
    try:
        own = probe(drawing.source).notes
        return drawing.path, (*own, *(psd_notes(drawing.path) if is_psd(drawing.path) else ()))
    except InputProblem as problem:
        return problem.message
