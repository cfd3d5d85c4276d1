"""What a cut is made of, as one text that changes with any of it: its files, style, template, and the program."""

import hashlib
import os
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Final

from kagezou.batch.orders import Orders
from kagezou.document.model import Document
from kagezou.export.ledger import engine
from kagezou.io.clips.style_files import dumps_style
from kagezou.io.files.file_stamp import FileStamp, stamp_of
from kagezou.io.project.file_state import state_of

_DEEP: Final = 4
"""So many folders below that of a cut its drawings may lie."""

_FileState = tuple[str, *FileStamp]


def made_of(cut: Path, folders: Iterable[str], orders: Orders) -> str:
    """Return the text for a cut at a path whose files lie in ``folders`` besides."""
    listed = sorted({*_states(cut), *(state for folder in folders for state in _of_folder(Path(folder), 1))})
    style = None if orders.style is None else dumps_style(orders.style)
    template = None if orders.template is None else state_of(orders.template)
    asked = (orders.export, orders.with_light, sorted(orders.parts), style, template, orders.missing.value)
    return hashlib.sha256(repr((engine(), asked, listed)).encode("utf-8", "backslashreplace")).hexdigest()


def folders_of(cut: Path, document: Document) -> tuple[str, ...]:
    """Return the folders outside of that of a cut in which files of its document lie."""
    files = {drawing.path for layer in document.layers for drawing in layer.cels.drawings}
    files |= {drawing.path for drawing in document.behind.drawings}
    files |= {piece.source for piece in document.pieces if piece.source is not None}
    folders = {file.parent for file in files if file != cut}
    return tuple(sorted(str(each) for each in folders if each != cut and cut not in each.parents))


def _states(cut: Path) -> Iterator[_FileState]:
    """Yield the states of the files of a cut: all in its folder, or its file and those beside it of its name."""
    if cut.is_dir():
        yield from _of_folder(cut, _DEEP)
    yield from _of_entries(cut.parent, 0, cut.name if cut.is_dir() else cut.stem)


def _of_folder(folder: Path, deep: int) -> Iterator[_FileState]:
    return _of_entries(folder, deep, None)


def _of_entries(folder: Path, deep: int, stem: str | None) -> Iterator[_FileState]:
    """Yield path, size and time of change of files; only those of a stem, if one is given."""
    try:
        with os.scandir(folder) as entries:
            for entry in entries:
                if entry.name.startswith(".") or (stem is not None and Path(entry.name).stem != stem):
                    continue
                if entry.is_dir():
                    if deep > 1:
                        yield from _of_folder(Path(entry.path), deep - 1)
                elif entry.is_file():
                    found = entry.stat()
                    yield entry.path, *stamp_of(found)
    except OSError:
        yield str(folder), -1, -1, -1
