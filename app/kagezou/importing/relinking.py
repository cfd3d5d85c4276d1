"""Drawings that are not where they were: looked for by their names in another folder."""

import os
from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

from kagezou.document.alike_names import folded
from kagezou.document.edits import set_background_cels, set_drawings
from kagezou.document.model import Document, Drawing
from kagezou.errors import InputProblem
from kagezou.importing.progress import LoadPhase, Progress, no_progress
from kagezou.io.files.faults import shown
from kagezou.io.images.reading import probe
from kagezou.message import Message, first_names

MOST_FILES: Final = 200_000
"""In a folder with more files than that, those beyond are not looked at."""


@dataclass(frozen=True, slots=True)
class Relinked:
    """Where drawings were found, by the files they were thought to be in, and what is to be said."""

    found: Mapping[Path, Path]
    notes: tuple[Message, ...]


def missing_of(document: Document, layer_ids: Collection[str], *, behind: bool = False) -> tuple[Path, ...]:
    """Return the files of layers, and with ``behind`` of the background, that are not there, each once."""
    cels = [layer.cels for layer in document.layers if layer.id in layer_ids] + [document.behind] * behind
    paths = dict.fromkeys(drawing.path for each in cels for drawing in each.drawings)
    return tuple(path for path in paths if not path.is_file())


def found_again(missing: Collection[Path], folder: Path, progress: Progress = no_progress) -> Relinked:
    """Return where missing files lie in a folder or below it, by their names in any case and Unicode form.

    Of several files of one name that one counts whose folder bears the old one's name, else the one highest up.

    Raises
    ------
    InputProblem
        None of them is there.
    """
    progress(LoadPhase.FINDING, 0, 0)
    lying = _files_by_name(folder)
    found = {path: _nearest(path, lying[folded(path.name)]) for path in missing if folded(path.name) in lying}
    left = [path.name for path in missing if path not in found]
    if not found:
        raise InputProblem(
            Message("{path}: none of the missing drawings is there: {names}", path=shown(folder), names=_first(left))
        )
    notes = [Message("{found} of {count} missing files were found", found=len(found), count=len(missing))]
    if left:
        notes.append(Message("{path}: not there: {names}", path=shown(folder), names=_first(left)))
    return Relinked(found, tuple(notes))


def relinked(
    document: Document, layer_ids: Collection[str], again: Relinked, *, behind: bool = False
) -> tuple[Document, tuple[Message, ...]]:
    """Return the document with drawings where they were found, of the background with ``behind``, and what to say."""
    odd: list[str] = []
    for layer in document.layers:
        if layer.id not in layer_ids:
            continue
        drawings = tuple(_moved(drawing, again.found, odd) for drawing in layer.cels.drawings)
        document = set_drawings(document, layer.id, drawings)
    if behind:
        pictures = tuple(_moved(drawing, again.found, odd) for drawing in document.behind.drawings)
        document = set_background_cels(document, replace(document.behind, drawings=pictures))
    notes = again.notes
    if odd:
        notes = (*notes, Message("drawings that have another size than before: {names}", names=_first(odd)))
    return document, notes


def _moved(drawing: Drawing, found: Mapping[Path, Path], odd: list[str]) -> Drawing:
    path = found.get(drawing.path)
    if path is None:
        return drawing
    moved = replace(drawing, path=path)
    try:
        info = probe(moved.source)
    except InputProblem:
        # Whoever draws it meets the same file, and says what is wrong with it.
        return moved
    size_px = (info.width_px, info.height_px)
    if drawing.size_px is not None and size_px != drawing.size_px:
        odd.append(path.name)
    return replace(moved, size_px=size_px)


def _files_by_name(folder: Path) -> dict[str, list[Path]]:
    """Return the files in and below a folder by their names, those higher up first."""
    found: dict[str, list[Path]] = {}
    count = 0
    for place, folders, names in os.walk(folder):
        folders.sort()
        for name in sorted(names):
            found.setdefault(folded(name), []).append(Path(place, name))
            count += 1
        if count > MOST_FILES:
            break
    return found


def _nearest(path: Path, candidates: list[Path]) -> Path:
    alike = [each for each in candidates if folded(each.parent.name) == folded(path.parent.name)]
    return min(alike or candidates, key=lambda each: len(each.parts))


def _first(names: list[str]) -> str:
    return first_names(dict.fromkeys(names))
